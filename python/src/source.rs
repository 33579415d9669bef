//! What a scene was made of: objects of Python, and layers that are functions.
use std::sync::Arc;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyList;
use recede::Item;

use crate::errors::raised_about;
use crate::function::{self, Failure};

/// A layer of a scene that is a function of Python.
#[derive(Clone)]
pub struct FunctionLayer {
    /// Its place among the items.
    place: usize,
    item: Item,
    failure: Failure,
}

/// Layers as they are given: place among the items, thickness, and the function.
pub type Functions = Vec<(usize, f64, Py<PyAny>)>;

/// What a scene was made of, if not of a text.
#[derive(Clone, Default)]
pub struct Source {
    functions: Vec<FunctionLayer>,
    /// The objects that the lines of its text are about.
    objects: Option<Arc<Py<PyAny>>>,
}

impl Source {
    /// The source of a scene with these layers, and with these objects for the lines of its text.
    pub fn of(py: Python<'_>, layers: Functions, objects: Arc<Py<PyAny>>) -> PyResult<Self> {
        let layer = |(place, thickness, function)| {
            let (item, failure) = function::item(py, thickness, function)?;
            Ok(FunctionLayer { place, item, failure })
        };
        let functions = layers.into_iter().map(layer).collect::<PyResult<_>>()?;
        Ok(Self { functions, objects: Some(objects) })
    }

    /// The same for a text whose numbers have changed: its lines say something else than the objects.
    pub fn without_objects(&self, py: Python<'_>) -> Self {
        let objects = self.objects.as_ref().and_then(|_| Self::of_objects(py).objects);
        Self { objects, ..self.clone() }
    }

    /// The source of a scene that was made of objects, to which the lines of its text do not lead.
    pub fn of_objects(py: Python<'_>) -> Self {
        Self { functions: Vec::new(), objects: Some(Arc::new(PyList::empty(py).unbind().into_any())) }
    }

    /// Whether a layer is a function.
    pub fn has_functions(&self) -> bool {
        !self.functions.is_empty()
    }

    /// The exception for an error of the scene, or the exception that a function in a layer has raised.
    pub fn failed(&self, py: Python<'_>, error: &recede::Error) -> PyErr {
        let failure = self.functions.iter().find_map(|layer| layer.failure.take());
        failure.unwrap_or_else(|| raised_about(py, error, self.objects.as_deref()))
    }

    /// The scene with its functions in their places.
    pub fn complete(&self, mut scene: recede::Scene) -> recede::Scene {
        for FunctionLayer { place, item, .. } in &self.functions {
            scene.stack[*place] = item.clone();
        }
        scene
    }

    /// The text of a scene; an exception if a layer is a function, which has none.
    pub fn written(&self, scene: &recede::Scene) -> PyResult<String> {
        if self.functions.is_empty() {
            return Ok(scene.to_ron());
        }
        let why =
            "a layer of this scene is a function of Python, which has no text: it can neither be written nor pickled";
        Err(PyTypeError::new_err(why))
    }

    /// Whether a path leads into a function.
    pub fn is_hidden(&self, scene: &recede::Scene, path: &str) -> bool {
        let number = |place: usize| 1 + scene.stack[..place].iter().filter(|item| !item.is_interface()).count();
        self.functions.iter().any(|layer| path.starts_with(&format!("layer[{}].", number(layer.place))))
    }
}
