//! Special functions, element by element.

use crate::arrays::{Numbers, array, mapped};
use pyo3::prelude::*;
use pyo3::types::PyModule;
use viscotack::Refusal;
use viscotack::indentation::elliptic_k;
use viscotack::special::angle::Angle;
use viscotack::special::memory_clausen::MemoryClausen;
use viscotack::special::{
    clausen, cohesive_kernel, dawson, dilogarithm_circle, exponential_integral, exponential_mean, harmonic_imaginary, log_sine,
};
use viscotack_verification::rivals::annulus_indentation::complete_elliptic;

/// The value of a special function of one argument at a number; none for an unknown name.
fn by_name(name: &str) -> Option<fn(f64) -> Result<f64, Refusal>> {
    Some(match name {
        "clausen" => |x| Ok(clausen::clausen(Angle::new(x)?)),
        "dilogarithm_real" => |x| Ok(dilogarithm_circle::dilogarithm_on_circle(Angle::new(x)?).real),
        "dilogarithm_imaginary" => |x| Ok(dilogarithm_circle::dilogarithm_on_circle(Angle::new(x)?).imaginary),
        "log_sine" => |x| Ok(log_sine::log_sine(Angle::new(x)?)),
        "dawson" => |y| Ok(dawson::dawson(y)),
        "dawson_deficit" => |y| Ok(dawson::dawson_deficit(y)),
        "dawson_relative_deficit" => |y| Ok(dawson::dawson_relative_deficit(y)),
        "dawson_slope" => |y| Ok(dawson::dawson_slope(y)),
        "exponential_mean" => |z| Ok(exponential_mean::exponential_mean(z)),
        "exponential_mean_complement" => |z| Ok(exponential_mean::exponential_mean_complement(z)),
        "exponential_mean_decline" => |z| Ok(exponential_mean::exponential_mean_decline(z)),
        "opening_kernel" => |z| Ok(cohesive_kernel::opening_kernel(z)),
        "opening_kernel_slope" => |z| Ok(cohesive_kernel::opening_kernel_slope(z)),
        "closing_intensity_kernel" => |z| Ok(cohesive_kernel::closing_intensity_kernel(z)),
        "closing_intensity_kernel_slope" => |z| Ok(cohesive_kernel::closing_intensity_kernel_slope(z)),
        "closing_work_kernel" => |z| Ok(cohesive_kernel::closing_work_kernel(z)),
        "closing_work_kernel_slope" => |z| Ok(cohesive_kernel::closing_work_kernel_slope(z)),
        "memory_of_logarithm" => |z| Ok(exponential_integral::memory_of_logarithm(z)),
        "harmonic_on_imaginary_axis" => |b| Ok(harmonic_imaginary::harmonic_on_imaginary_axis(b)),
        // K in the PARAMETER m ≤ 0.5, as the sphere's closure needs it; K and E in the MODULUS, as the rival scheme does.
        "elliptic_k_of_parameter" => |m| Ok(elliptic_k(m)),
        "elliptic_k_of_modulus" => |modulus| Ok(complete_elliptic(modulus).0),
        "elliptic_e_of_modulus" => |modulus| Ok(complete_elliptic(modulus).1),
        _ => return None,
    })
}

/// A special function of one argument.
#[pyfunction]
fn special<'py>(py: Python<'py>, name: &str, arguments: Numbers) -> PyResult<Bound<'py, PyAny>> {
    let function = by_name(name).ok_or_else(|| crate::arrays::unknown("special function", name))?;
    mapped(py, &arguments, function)
}

/// I(x; ζ), I(x; ζ) − I(0; ζ) and the memory of the periodic logarithm, at angles of one ratio.
#[pyfunction]
fn memory_clausen<'py>(py: Python<'py>, angles: Numbers, ratio: f64) -> PyResult<[Bound<'py, PyAny>; 3]> {
    let memory = MemoryClausen::new(ratio).map_err(crate::arrays::refused)?;
    Ok([
        mapped(py, &angles, |x| Ok(memory.integral(Angle::new(x)?)))?,
        mapped(py, &angles, |x| Ok(memory.increment(Angle::new(x)?)))?,
        mapped(py, &angles, |x| Ok(memory.logarithm(Angle::new(x)?)))?,
    ])
}

/// Σ_{n>last} n^{−exponent}.
#[pyfunction]
fn zeta_tail(exponent: u32, last_left_out: u32) -> f64 {
    viscotack::special::even_zeta::zeta_tail(exponent, last_left_out)
}

/// ∫₀¹ e^{−zv} v^k dv, k = 0, 1, 2, 3, row by row.
#[pyfunction]
fn fading_moments<'py>(py: Python<'py>, arguments: Numbers) -> PyResult<Bound<'py, PyAny>> {
    let rows: Vec<f64> = arguments.0.iter().flat_map(|&z| viscotack::crack::delayed::moments::fading_moments(z).1).collect();
    array(py, &rows)?.call_method1("reshape", (arguments.0.len(), 4))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(zeta_tail, module)?)?;
    module.add_function(wrap_pyfunction!(fading_moments, module)?)?;
    module.add_function(wrap_pyfunction!(special, module)?)?;
    module.add_function(wrap_pyfunction!(memory_clausen, module)?)
}
