//! Columns for other programs, by the Arrow PyCapsule interface.
use std::collections::HashMap;
use std::panic::AssertUnwindSafe;
use std::ptr::NonNull;
use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::Float64Type;
use arrow_array::{ArrayRef, PrimitiveArray, RecordBatch, RecordBatchIterator, StringArray};
use arrow_buffer::{Buffer, ScalarBuffer};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

/// A stream of one batch, with what there is to say about all of it: arrays of doubles are shared, not copied; lists of strings are.
#[pyfunction]
pub fn arrow_stream<'py>(
    py: Python<'py>,
    names: Vec<String>,
    columns: Vec<Bound<'py, PyAny>>,
    metadata: HashMap<String, String>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let columns: Vec<ArrayRef> = columns.iter().map(column).collect::<PyResult<_>>()?;
    let fields: Vec<Field> = names
        .into_iter()
        .zip(&columns)
        .map(|(name, column)| Field::new(name, column.data_type().clone(), true))
        .collect();
    let schema = Arc::new(Schema::new_with_metadata(fields, metadata));
    let batch = RecordBatch::try_new(Arc::clone(&schema), columns);
    let batch = batch.map_err(|error: ArrowError| PyRuntimeError::new_err(error.to_string()))?;
    let stream = FFI_ArrowArrayStream::new(Box::new(RecordBatchIterator::new([Ok(batch)], schema)));
    PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
}

fn column(values: &Bound<'_, PyAny>) -> PyResult<ArrayRef> {
    let Ok(array) = values.cast::<PyArray1<f64>>() else {
        return Ok(Arc::new(StringArray::from(values.extract::<Vec<String>>()?)));
    };
    if !array.is_contiguous() {
        return Err(PyTypeError::new_err("columns have to be contiguous arrays"));
    }
    let bytes = array.len() * size_of::<f64>();
    let Some(start) = NonNull::new(array.data().cast::<u8>()) else {
        return Ok(arrow_array::new_empty_array(&DataType::Float64));
    };
    let owner = Arc::new(AssertUnwindSafe(array.clone().unbind()));
    // SAFETY: the memory belongs to the array, which the buffer keeps alive, and an array of Python that is referred to is not reallocated
    let buffer = unsafe { Buffer::from_custom_allocation(start, bytes, owner) };
    Ok(Arc::new(PrimitiveArray::<Float64Type>::new(ScalarBuffer::from(buffer), None)))
}
