//! Layers whose material is a function of Python.
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use recede::layers::conformance;
use recede::{Graded, Isotropic, Item, Plane};

use crate::errors::raised;

/// The exception that a function has raised, to be raised again when the library has given up.
#[derive(Clone, Default)]
pub struct Failure(Arc<Mutex<Option<PyErr>>>);

impl Failure {
    pub fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn keep(&self, error: PyErr) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }
}

/// A layer with shear modulus and Poisson's ratio from a function of the depth.
fn layer(py: Python<'_>, thickness: f64, function: Py<PyAny>) -> PyResult<(Graded, Failure)> {
    let failure = Failure::default();
    let kept = failure.clone();
    let material = move |depth: f64| {
        let found = Python::attach(|py| material(function.bind(py), depth));
        found.unwrap_or_else(|error| {
            kept.keep(error);
            Isotropic { shear_modulus: f64::NAN, poisson: f64::NAN }
        })
    };
    // what is wrong at a face is told at once
    material(0.0);
    material(thickness);
    if let Some(error) = failure.take() {
        return Err(error);
    }
    Ok((Graded::with(thickness, material).map_err(|error| raised(py, error))?, failure))
}

/// What the function says at a depth, if it is legal.
fn material(function: &Bound<'_, PyAny>, depth: f64) -> PyResult<Isotropic> {
    let found = function.call1((depth,))?;
    let wrong = |what: &str| format!("the material at depth {depth} is {found}; {what}");
    let (shear_modulus, poisson) = found
        .extract::<(f64, f64)>()
        .map_err(|_| PyTypeError::new_err(wrong("it has to be the two numbers (shear modulus, Poisson's ratio)")))?;
    if !(shear_modulus.is_finite() && shear_modulus > 0.0) {
        return Err(PyValueError::new_err(wrong("the shear modulus has to be a finite number > 0")));
    }
    if !(poisson > -1.0 && poisson <= 0.5) {
        return Err(PyValueError::new_err(wrong("Poisson's ratio has to be greater than -1 and at most 0.5")));
    }
    Ok(Isotropic { shear_modulus, poisson })
}

/// The same as an item of a stack.
pub fn item(py: Python<'_>, thickness: f64, function: Py<PyAny>) -> PyResult<(Item, Failure)> {
    layer(py, thickness, function).map(|(layer, failure)| (Item::layer(layer), failure))
}

/// Examines a function of the depth as the material of a layer of this thickness: raises ``ValueError`` that names the first law of
/// elasticity that is not obeyed, see docs/adding_a_layer.md.
#[pyfunction]
pub fn examine(py: Python<'_>, thickness: f64, function: Py<PyAny>) -> PyResult<()> {
    let (layer, failure) = layer(py, thickness, function)?;
    let examined = py.detach(|| {
        [Plane::Strain, Plane::Stress].into_iter().try_for_each(|plane| conformance::examine(&layer, plane))
    });
    if let Some(error) = failure.take() {
        return Err(error);
    }
    examined.map_err(|broken| {
        let all: Vec<String> = broken.iter().map(ToString::to_string).collect();
        PyValueError::new_err(all.join("; "))
    })
}
