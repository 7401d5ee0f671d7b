//! Materials.

use crate::arrays::{Numbers, array, mapped, refused};
use pyo3::prelude::*;
use viscotack::PlaneMaterial;
use viscotack::material::{CreepTerm, RelaxationTerm};

/// A linear viscoelastic material.
#[pyclass(name = "Material", frozen)]
pub(crate) struct PyMaterial(pub(crate) PlaneMaterial);

/// value, d ln value/d ln t, bound on the relative error.
type Mean = (f64, f64, f64);

#[pymethods]
impl PyMaterial {
    /// From creep: glassy modulus, compliances, RETARDATION times, and a steady viscosity if it flows.
    #[staticmethod]
    #[pyo3(signature = (glassy_modulus, compliances, times, steady_viscosity = None))]
    fn from_creep(glassy_modulus: f64, compliances: Numbers, times: Numbers, steady_viscosity: Option<f64>) -> PyResult<Self> {
        let terms: Vec<CreepTerm> =
            compliances.0.iter().zip(&times.0).map(|(&compliance, &retardation_time)| CreepTerm { compliance, retardation_time }).collect();
        PlaneMaterial::from_creep(glassy_modulus, &terms, steady_viscosity).map(Self).map_err(refused)
    }

    /// From relaxation: relaxed modulus, moduli, RELAXATION times.
    #[staticmethod]
    fn from_relaxation(relaxed_modulus: f64, moduli: Numbers, times: Numbers) -> PyResult<Self> {
        let terms: Vec<RelaxationTerm> =
            moduli.0.iter().zip(&times.0).map(|(&modulus, &relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
        PlaneMaterial::from_relaxation(relaxed_modulus, &terms).map(Self).map_err(refused)
    }

    /// Every modulus multiplied, as by 1/(1 − ν²).
    fn stiffened(&self, factor: f64) -> PyResult<Self> {
        self.0.stiffened(factor).map(Self).map_err(refused)
    }

    #[getter]
    fn relaxed_modulus(&self) -> f64 {
        self.0.relaxed_modulus()
    }

    #[getter]
    fn glassy_modulus(&self) -> f64 {
        self.0.glassy_modulus()
    }

    /// Compliances and retardation times, longest first.
    fn creep_terms<'py>(&self, py: Python<'py>) -> PyResult<[Bound<'py, PyAny>; 2]> {
        let terms = self.0.creep_terms();
        Ok([
            array(py, &terms.iter().map(|term| term.compliance).collect::<Vec<_>>())?,
            array(py, &terms.iter().map(|term| term.retardation_time).collect::<Vec<_>>())?,
        ])
    }

    /// Moduli and relaxation times, longest first.
    fn relaxation_terms<'py>(&self, py: Python<'py>) -> PyResult<[Bound<'py, PyAny>; 2]> {
        let terms = self.0.relaxation_terms();
        Ok([
            array(py, &terms.iter().map(|term| term.modulus).collect::<Vec<_>>())?,
            array(py, &terms.iter().map(|term| term.relaxation_time).collect::<Vec<_>>())?,
        ])
    }

    /// Bounds on the relative errors of strengths and times of the converted series, and the parts of them that come from half an ulp of the given one.
    fn conversion_errors<'py>(&self, py: Python<'py>) -> PyResult<[Bound<'py, PyAny>; 2]> {
        let errors = self.0.conversion_errors();
        Ok([
            array(py, &errors.iter().map(|error| error.strength).collect::<Vec<_>>())?,
            array(py, &errors.iter().map(|error| error.time).collect::<Vec<_>>())?,
        ])
    }

    fn creep<'py>(&self, py: Python<'py>, times: Numbers) -> PyResult<Bound<'py, PyAny>> {
        mapped(py, &times, |time| Ok(self.0.creep(time)))
    }

    fn creep_rate<'py>(&self, py: Python<'py>, times: Numbers) -> PyResult<Bound<'py, PyAny>> {
        mapped(py, &times, |time| Ok(self.0.creep_rate(time)))
    }

    fn relaxation<'py>(&self, py: Python<'py>, times: Numbers) -> PyResult<Bound<'py, PyAny>> {
        mapped(py, &times, |time| Ok(self.0.relaxation(time)))
    }

    fn relaxation_rate<'py>(&self, py: Python<'py>, times: Numbers) -> PyResult<Bound<'py, PyAny>> {
        mapped(py, &times, |time| Ok(self.0.relaxation_rate(time)))
    }

    /// Storage and loss modulus at angular frequencies.
    fn complex_modulus<'py>(&self, py: Python<'py>, frequencies: Numbers) -> PyResult<[Bound<'py, PyAny>; 2]> {
        Ok([
            mapped(py, &frequencies, |frequency| Ok(self.0.complex_modulus(frequency)?.storage))?,
            mapped(py, &frequencies, |frequency| Ok(self.0.complex_modulus(frequency)?.loss))?,
        ])
    }

    /// Mean of J over 0…time.
    fn mean_creep(&self, time: f64) -> Mean {
        let mean = self.0.mean_creep(time);
        (mean.value, mean.log_slope, mean.relative_error)
    }

    /// Mean of R over 0…time.
    fn mean_relaxation(&self, time: f64) -> Mean {
        let mean = self.0.mean_relaxation(time);
        (mean.value, mean.log_slope, mean.relative_error)
    }
}
