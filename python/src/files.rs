//! Files that are written from Python, by the rules of the command.
use std::path::PathBuf;

use pyo3::prelude::*;

use crate::errors::os_error;

/// Writes all of a file. A regular file appears when it is complete and keeps its permissions, links are followed, anything else is
/// written through.
#[pyfunction]
pub fn replace(py: Python<'_>, path: PathBuf, data: Vec<u8>) -> PyResult<()> {
    py.detach(|| recede::files::replace(&path, |out| out.write_all(&data))).map_err(|error| os_error(py, &path, &error))
}
