//! The module `recede._recede`: the library's objects for Python. Texts of scenes, arrays and exceptions are made in Python, next to it.
mod arrays;
mod contact;
mod errors;
mod field;
mod function;
mod model;
mod scene;
mod solution;
mod solver;
mod source;
mod sweep;

use std::path::PathBuf;

use pyo3::prelude::*;

/// Writes all of a file. A regular file appears when it is complete and keeps its permissions, links are followed, anything else is
/// written through.
#[pyfunction]
fn replace(py: Python<'_>, path: PathBuf, data: Vec<u8>) -> PyResult<()> {
    let written = py.detach(|| recede::files::replace(&path, |out| out.write_all(&data)));
    written.map_err(|error| errors::os_error(py, &path, &error))
}

/// Compiled part of `recede`.
#[pymodule]
fn _recede(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<scene::Scene>()?;
    module.add_class::<model::Model>()?;
    module.add_class::<solution::Solution>()?;
    module.add_class::<contact::Contact>()?;
    module.add_class::<field::Field>()?;
    module.add_class::<sweep::Rows>()?;
    module.add_class::<scene::CompiledTop>()?;
    module.add_function(wrap_pyfunction!(replace, module)?)?;
    module.add_function(wrap_pyfunction!(function::examine, module)?)?;
    module.add_function(wrap_pyfunction!(scene::schema, module)?)
}
