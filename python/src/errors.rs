//! Errors of the library as exceptions of Python, with place and hint.
use pyo3::prelude::*;
use pyo3::types::PyDict;

use recede::Error;

/// The exception for an error; its classes are in `recede/_errors.py`.
pub fn exception(py: Python<'_>, error: &Error) -> PyErr {
    let (mut line, mut column, mut excerpt) = (None, None, None);
    let mut message = error.to_string();
    if let Error::Scene(error) = error {
        (line, column, excerpt) = (error.line(), error.column(), error.excerpt());
        message = error.message().to_owned();
    }
    let make = || -> PyResult<Bound<'_, PyAny>> {
        let fields = PyDict::new(py);
        fields.set_item("hint", error.hint())?;
        fields.set_item("line", line)?;
        fields.set_item("column", column)?;
        fields.set_item("excerpt", excerpt)?;
        py.import("recede._errors")?.call_method("make", (error.is_input(), message), Some(&fields))
    };
    make().map_or_else(|error| error, PyErr::from_value)
}

/// As [`exception`], for any error of the library.
pub fn raised<E: Into<Error>>(py: Python<'_>, error: E) -> PyErr {
    exception(py, &error.into())
}
