//! Layers and the steady sliding kernels of half-planes and layers. Reduced units.

use crate::arrays::{Numbers, mapped, mapped_estimates, refused, unknown};
use pyo3::prelude::*;
use viscotack::sliding::{Backing, HalfPlaneGreen, Layer, LayerGreen, MemoryTerm, SlidingMemory};

fn layer(backing: &str, poisson_ratio: f64, thickness: f64) -> PyResult<Layer> {
    let backing = match backing {
        "confined" => Backing::Confined,
        "free" => Backing::Free,
        _ => return Err(unknown("backing", backing)),
    };
    Layer::new(backing, poisson_ratio, thickness).map_err(refused)
}

/// A and S = 1 − A of a layer at harmonics.
#[pyfunction]
fn layer_factors<'py>(
    py: Python<'py>,
    backing: &str,
    poisson_ratio: f64,
    thickness: f64,
    harmonics: Numbers,
) -> PyResult<[Bound<'py, PyAny>; 2]> {
    let layer = layer(backing, poisson_ratio, thickness)?;
    Ok([mapped(py, &harmonics, |m| Ok(layer.correction(m)))?, mapped(py, &harmonics, |m| Ok(layer.compliance_factor(m)))?])
}

/// The sliding kernel of a half-plane, or of a `layer` (backing, Poisson ratio, kd): value, its bound, antiderivative, its bound.
#[pyfunction]
#[pyo3(signature = (glassy_compliance, compliances, ratios, positions, layer_of = None))]
fn sliding_green<'py>(
    py: Python<'py>,
    glassy_compliance: f64,
    compliances: Numbers,
    ratios: Numbers,
    positions: Numbers,
    layer_of: Option<(String, f64, f64)>,
) -> PyResult<[Bound<'py, PyAny>; 4]> {
    let terms: Vec<MemoryTerm> =
        compliances.0.iter().zip(&ratios.0).map(|(&compliance, &ratio)| MemoryTerm { compliance, ratio }).collect();
    let half_plane = HalfPlaneGreen::new(SlidingMemory::new(glassy_compliance, &terms).map_err(refused)?).map_err(refused)?;
    let ((value, value_error), (antiderivative, antiderivative_error)) = match layer_of {
        None => (
            mapped_estimates(py, &positions, |x| half_plane.value(x))?,
            mapped_estimates(py, &positions, |x| half_plane.antiderivative(x))?,
        ),
        Some((backing, poisson_ratio, thickness)) => {
            let green = LayerGreen::new(half_plane, layer(&backing, poisson_ratio, thickness)?);
            (mapped_estimates(py, &positions, |x| green.value(x))?, mapped_estimates(py, &positions, |x| green.antiderivative(x))?)
        }
    };
    Ok([value, value_error, antiderivative, antiderivative_error])
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(layer_factors, module)?)?;
    module.add_function(wrap_pyfunction!(sliding_green, module)?)
}
