//! Errors of the library as exceptions of Python, with place and hint.
use std::error::Error as _;
use std::io;
use std::path::Path;

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use recede::{Error, SceneError};

/// The exception for an error; its classes are in `recede/_errors.py`. Of a scene that was made of objects it names the object in place
/// of a line of a text that nobody has written.
pub fn raised_about(py: Python<'_>, error: &Error, objects: Option<&Py<PyAny>>) -> PyErr {
    let make = || -> PyResult<Bound<'_, PyAny>> {
        let fields = PyDict::new(py);
        fields.set_item("hint", error.hint())?;
        let mut message = error.to_string();
        if let Error::Scene(error) = error {
            message = error.message().to_owned();
            match (objects, error.line()) {
                (Some(objects), Some(line)) => {
                    let about = py.import("recede._text")?.call_method1("about", (objects, line))?;
                    fields.set_item("excerpt", about)?;
                }
                _ => {
                    fields.set_item("line", error.line())?;
                    fields.set_item("column", error.column())?;
                    fields.set_item("excerpt", error.excerpt())?;
                    fields.set_item("file", error.file())?;
                }
            }
        }
        py.import("recede._errors")?.call_method("make", (error.is_input(), message), Some(&fields))
    };
    make().map_or_else(|error| error, PyErr::from_value)
}

/// The same for any error of the library, without objects.
pub fn raised<E: Into<Error>>(py: Python<'_>, error: E) -> PyErr {
    raised_about(py, &error.into(), None)
}

/// The exception for a file that is no scene; if it cannot be read, that it cannot, with its name.
pub fn file_error(py: Python<'_>, path: &Path, error: SceneError) -> PyErr {
    match error.source().and_then(|cause| cause.downcast_ref::<io::Error>()) {
        Some(cause) if cause.raw_os_error().is_some() => os_error(py, path, cause),
        _ => raised(py, error),
    }
}

/// The exception of the operating system for a file, with its name.
pub fn os_error(py: Python<'_>, path: &Path, error: &io::Error) -> PyErr {
    let Some(code) = error.raw_os_error() else { return PyOSError::new_err(error.to_string()) };
    let message = py.import("os").and_then(|os| os.call_method1("strerror", (code,))?.extract::<String>());
    // the class follows from the code
    PyOSError::new_err((code, message.unwrap_or_default(), path.as_os_str().to_owned()))
}
