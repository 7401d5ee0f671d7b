//! Whole scenes: everything that the command line solves.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::path::Path;
use viscotack_program::outcome::summary::summary;
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

/// `summary.json` of a scene given as TOML, as a dictionary; files that it names are looked for in `folder`.
#[pyfunction]
#[pyo3(signature = (text, folder = "."))]
fn run_scene<'py>(py: Python<'py>, text: String, folder: &str) -> PyResult<Bound<'py, PyAny>> {
    let wrong = |error: viscotack_program::scene::SceneError| PyValueError::new_err(error.rendered());
    let mut document = Document::parse("scene", text, Path::new(folder)).map_err(wrong)?;
    read::resolve_includes(&mut document).map_err(wrong)?;
    let scene = read::read(&document).map_err(wrong)?;
    let outcome = plan::run(&document, &scene, Vec::new(), None, &|_| {}).map_err(|error| PyValueError::new_err(error.to_string()))?;
    py.import("json")?.call_method1("loads", (summary(&outcome).to_string(),))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(run_scene, module)?)
}
