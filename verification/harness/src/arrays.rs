//! Numbers in and out: float64 buffers of any shape in, NumPy arrays out.

use pyo3::buffer::PyBuffer;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use viscotack::{Estimate, Refusal};

/// One or many doubles: a float, a list of floats, or a float64 array of any shape (taken in C order).
pub(crate) struct Numbers(pub(crate) Vec<f64>);

impl<'a, 'py> FromPyObject<'a, 'py> for Numbers {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(buffer) = PyBuffer::<f64>::get(&object) {
            return Ok(Self(buffer.to_vec(object.py())?));
        }
        if let Ok(one) = object.extract::<f64>() {
            return Ok(Self(vec![one]));
        }
        Ok(Self(object.extract::<Vec<f64>>()?))
    }
}

/// A float64 NumPy array.
pub(crate) fn array<'py>(py: Python<'py>, values: &[f64]) -> PyResult<Bound<'py, PyAny>> {
    let made = py.import("numpy")?.call_method1("empty", (values.len(),))?;
    PyBuffer::<f64>::get(&made)?.copy_from_slice(py, values)?;
    Ok(made)
}

/// Values and error bounds as two arrays.
pub(crate) fn estimates<'py>(py: Python<'py>, values: &[Estimate]) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let value: Vec<f64> = values.iter().map(|estimate| estimate.value).collect();
    let error: Vec<f64> = values.iter().map(|estimate| estimate.error).collect();
    Ok((array(py, &value)?, array(py, &error)?))
}

/// (value, error bound).
pub(crate) const fn pair(estimate: Estimate) -> (f64, f64) {
    (estimate.value, estimate.error)
}

/// Refusals become `ValueError`s with the same sentence.
pub(crate) fn refused(refusal: Refusal) -> PyErr {
    PyValueError::new_err(refusal.to_string())
}

/// Applies a function that may refuse to every number.
pub(crate) fn mapped<'py>(
    py: Python<'py>,
    numbers: &Numbers,
    function: impl Fn(f64) -> Result<f64, Refusal>,
) -> PyResult<Bound<'py, PyAny>> {
    let values: Result<Vec<f64>, Refusal> = numbers.0.iter().map(|&number| function(number)).collect();
    array(py, &values.map_err(refused)?)
}

/// The same for functions that return an error bound.
pub(crate) fn mapped_estimates<'py>(
    py: Python<'py>,
    numbers: &Numbers,
    function: impl Fn(f64) -> Result<Estimate, Refusal>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let values: Result<Vec<Estimate>, Refusal> = numbers.0.iter().map(|&number| function(number)).collect();
    estimates(py, &values.map_err(refused)?)
}

/// An unknown word.
pub(crate) fn unknown(what: &str, word: &str) -> PyErr {
    PyValueError::new_err(format!("{what} `{word}` is not known"))
}
