//! The module `recede._recede`: the library's objects for Python. Texts of scenes, arrays and exceptions are made in Python, next to it.
mod arrays;
mod contact;
mod errors;
mod field;
mod files;
mod function;
mod model;
mod scene;
mod solution;
mod sweep;

use pyo3::prelude::*;

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
    module.add_function(wrap_pyfunction!(files::replace, module)?)?;
    module.add_function(wrap_pyfunction!(function::examine, module)?)?;
    module.add_function(wrap_pyfunction!(scene::schema, module)?)
}
