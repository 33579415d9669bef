//! Scenes, and the punches of models.
use std::sync::{Arc, OnceLock};

use pyo3::prelude::*;
use pyo3::types::PyDict;
use recede::{Geometry, Item, Punch, Registry};

use crate::errors::raised;
use crate::function::{self, Failure};
use crate::model::Solver;
use crate::solution::Solution;

/// A scene: what is pressed by what.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Scene {
    pub inner: recede::Scene,
    /// Layers that are functions of Python.
    functions: Vec<Failure>,
    solver: OnceLock<Arc<Solver>>,
}

impl Scene {
    fn of(inner: recede::Scene, functions: Vec<Failure>) -> Self {
        Self { inner, functions, solver: OnceLock::new() }
    }

    /// The model of its stack, made when it is first needed.
    pub fn solver(&self, py: Python<'_>) -> PyResult<Arc<Solver>> {
        if let Some(solver) = self.solver.get() {
            return Ok(Arc::clone(solver));
        }
        let solver = Arc::new(Solver::new(py, self.inner.clone(), self.functions.clone(), false)?);
        Ok(Arc::clone(self.solver.get_or_init(|| solver)))
    }

    pub fn from_text(py: Python<'_>, text: &str) -> PyResult<Self> {
        recede::Scene::from_ron(text).map(|scene| Self::of(scene, Vec::new())).map_err(|error| raised(py, error))
    }

    /// The text of a scene; an exception if a layer is a function, which has none.
    fn written(&self) -> PyResult<String> {
        written(&self.inner, &self.functions)
    }

    pub fn functions(&self) -> &[Failure] {
        &self.functions
    }
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (stack, punch=None, force=None, **fields))]
    fn new(
        py: Python<'_>,
        stack: &Bound<'_, PyAny>,
        punch: Option<&Bound<'_, PyAny>>,
        force: Option<&Bound<'_, PyAny>>,
        fields: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let (text, layers): (String, Vec<(usize, f64, Py<PyAny>)>) =
            py.import("recede._text")?.call_method("scene", (stack, punch, force), fields)?.extract()?;
        let mut scene = recede::Scene::from_ron(&text).map_err(|error| raised(py, error))?;
        let mut functions = Vec::new();
        for (place, thickness, function) in layers {
            let (item, failure) = function::item(py, thickness, function)?;
            scene.stack[place] = item;
            functions.push(failure);
        }
        // whether the items fit together
        scene.stack().map_err(|error| raised(py, error))?;
        Ok(Self::of(scene, functions))
    }

    #[staticmethod]
    fn from_ron(py: Python<'_>, text: &str) -> PyResult<Self> {
        Self::from_text(py, text)
    }

    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        recede::Scene::from_json(text).map(|scene| Self::of(scene, Vec::new())).map_err(|error| raised(py, error))
    }

    #[staticmethod]
    fn read(py: Python<'_>, path: std::path::PathBuf) -> PyResult<Self> {
        recede::Scene::read(path).map(|scene| Self::of(scene, Vec::new())).map_err(|error| raised(py, error))
    }

    fn to_ron(&self) -> PyResult<String> {
        self.written()
    }

    fn to_json(&self) -> PyResult<String> {
        self.written().map(|_| self.inner.to_json())
    }

    #[getter]
    fn name(&self) -> &str {
        self.inner.title()
    }

    #[getter]
    fn geometry(&self) -> String {
        geometry_name(self.inner.geometry)
    }

    /// The paths of all numbers that may vary.
    #[getter]
    fn paths(&self) -> Vec<String> {
        self.inner.paths()
    }

    fn number(&self, py: Python<'_>, path: &str) -> PyResult<f64> {
        self.inner.number(path).map_err(|error| raised(py, error))
    }

    fn with_number(&self, py: Python<'_>, path: &str, value: f64) -> PyResult<Self> {
        let scene = self.inner.with(path, value).map_err(|error| raised(py, error))?;
        Ok(Self::of(scene, self.functions.clone()))
    }

    #[pyo3(signature = (*, tolerance=1e-10))]
    fn solve(&self, py: Python<'_>, tolerance: f64) -> PyResult<Solution> {
        self.solver(py)?.solve(py, tolerance)
    }

    fn __reduce__(slf: &Bound<'_, Self>) -> PyResult<(Py<PyAny>, (String,))> {
        let text = slf.get().written()?;
        Ok((slf.get_type().getattr("from_ron")?.unbind(), (text,)))
    }

    fn __copy__(slf: Bound<'_, Self>) -> Bound<'_, Self> {
        slf
    }

    fn __deepcopy__<'py>(slf: Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf
    }

    fn __eq__(slf: &Bound<'_, Self>, other: &Bound<'_, PyAny>) -> bool {
        let Ok(other) = other.cast::<Self>() else { return false };
        slf.is(other) || matches!((slf.get().written(), other.get().written()), (Ok(a), Ok(b)) if a == b)
    }

    fn __hash__(slf: &Bound<'_, Self>) -> PyResult<isize> {
        match slf.get().written() {
            Ok(text) => pyo3::types::PyString::new(slf.py(), &text).hash(),
            Err(_) => Ok(slf.as_ptr() as isize),
        }
    }

    fn __repr__(&self) -> String {
        self.written().unwrap_or_else(|_| format!("<Scene {} with layers that are functions>", self.inner.title()))
    }
}

/// The text of a scene; an exception if a layer is a function, which has none.
pub fn written(scene: &recede::Scene, functions: &[Failure]) -> PyResult<String> {
    if functions.is_empty() {
        return Ok(scene.to_ron());
    }
    let why = "a layer of this scene is a function of Python, which has no text: it can neither be written nor pickled";
    Err(pyo3::exceptions::PyTypeError::new_err(why))
}

/// The name of a geometry in a scene.
pub fn geometry_name(geometry: Geometry) -> String {
    format!("{geometry:?}")
}

/// A punch or load as the library knows it; kept by the object of Python for the geometry in which it was used.
#[pyclass(frozen, module = "recede._recede")]
pub struct CompiledPunch {
    geometry: Geometry,
    punch: Punch,
}

/// The punch of an object of `recede.items`.
pub fn punch(scene: &recede::Scene, item: &Bound<'_, PyAny>) -> PyResult<Punch> {
    let py = item.py();
    let is_labelled = scene.units.is_some();
    if let Ok(known) = item.getattr("_compiled").and_then(|known| Ok(known.cast_into::<CompiledPunch>()?)) {
        if known.get().geometry == scene.geometry && !is_labelled {
            return Ok(known.get().punch.clone());
        }
    }
    let units = scene.units.as_ref().map(|units| (units.length.clone(), units.force.clone()));
    let name = geometry_name(scene.geometry);
    let text: String = py.import("recede._text")?.call_method1("with_punch", (item, name, units))?.extract()?;
    let read = recede::Scene::from_ron(&text).map_err(|error| raised(py, error))?;
    if !is_labelled {
        let compiled = CompiledPunch { geometry: scene.geometry, punch: read.punch.clone() };
        item.setattr("_compiled", Py::new(py, compiled)?)?;
    }
    Ok(read.punch)
}

/// The items of a stack as written, for messages.
pub fn names(items: &[Item]) -> Vec<&'static str> {
    items.iter().map(Item::name).collect()
}

/// The JSON Schema of scenes, with all layers, interfaces, bases, punches and loads.
#[pyfunction]
pub fn schema() -> String {
    recede::scene_schema(&Registry::default()).to_string()
}
