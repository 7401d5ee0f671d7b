//! The solvers and special functions of viscotack as a Python module, for tests only: thin, and only through the public interface.
//!
//! Arguments and results are those of the Rust functions, in the same units; see their documentation. Numbers with an error bound come as
//! (value, bound). A refusal is a `ValueError` with its sentence.

mod arrays;
mod crack;
mod elastic;
mod indentation;
mod kernels;
mod material;
mod scene;
mod sliding;
mod special;

use pyo3::prelude::*;

#[pymodule]
fn viscotack_harness(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<material::PyMaterial>()?;
    special::register(module)?;
    crack::register(module)?;
    kernels::register(module)?;
    sliding::register(module)?;
    indentation::register(module)?;
    elastic::register(module)?;
    scene::register(module)
}
