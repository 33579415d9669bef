//! Numbers from and to arrays of numpy, by the buffer protocol.
use pyo3::buffer::PyBuffer;
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyDict};

/// The numbers of an array of doubles, row by row.
pub fn read(array: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    // a number alone has no shape that a buffer could tell
    PyBuffer::<f64>::get(&array.call_method0("ravel")?)?.to_vec(array.py())
}

/// Numbers as an array of numpy.
pub fn array<'py>(py: Python<'py>, values: &[f64]) -> PyResult<Bound<'py, PyAny>> {
    let fill = |bytes: &mut [u8]| {
        bytes.chunks_exact_mut(size_of::<f64>()).zip(values).for_each(|(to, value)| {
            to.copy_from_slice(&value.to_ne_bytes());
        });
        Ok(())
    };
    let memory = PyByteArray::new_with(py, size_of_val(values), fill)?;
    py.import("numpy")?.call_method1("frombuffer", (memory,))
}

/// Columns of numbers by name, as arrays.
pub fn columns(py: Python<'_>, columns: Vec<(String, Vec<f64>)>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    columns.into_iter().try_for_each(|(name, values)| all.set_item(name, array(py, &values)?))?;
    Ok(all)
}
