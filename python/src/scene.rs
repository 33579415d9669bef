//! Scenes, and the punches of models.
use std::sync::{Arc, OnceLock};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use recede::{Geometry, Registry, Top};

use crate::errors::{file_error, raised, raised_about};
use crate::solution::Solution;
use crate::solver::Solver;
use crate::source::{Functions, Source};

/// Columns of a drawing in a notebook, at most.
const COLUMNS: usize = 100;

/// What is pressed by what: a stack, a punch or a load, and a force.
///
/// Args:
///     stack: a `Stack`, or its items from the top down.
///     punch: such as `Cylinder(radius=500)`; its tip is at x = 0.
///     force: the force, per unit length out of the plane, or the whole force in axisymmetric scenes; a number > 0.
///     punches: in place of punch and force: several punches, each with the place of its tip on x, its force, and a tilt if it is turned,
///         such as `[(Cylinder(radius=100), 0.0, 0.002), (Flat(half_width=0.5), 3.0, 0.001, Free(eccentricity=0.1))]`.
///     load: a pressure that is given, in place of the punch.
///     loads: in place of punch and force: several loads, each with the place of its middle on x and its force, such as
///         `[(Line(), -0.5, 0.2), (Uniform(half_width=0.2), 1.0, 0.8)]`.
///     half_length: in place of the force: the half-length (radius) of the contact under the punch, in length.
///     depth: in place of the force: how far the punch sinks, in length.
///     pressure_on_top: a pressure everywhere on the top face, also under a punch, >= 0, in stress.
///     geometry: "PlaneStrain", "PlaneStress" or "Axisymmetric"; a `Stack` brings its own.
///     name: a name for reports.
///     description: what the scene shows.
///     units: labels of the units of length and force, such as `Units("mm", "N")`, `("mm", "N")` or
///         `{"length": "mm", "force": "N"}`; numbers may then be texts, such as "26 GPa".
///
/// Raises:
///     InputError: with the object in question and a hint, if something is not legal.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Scene {
    pub inner: recede::Scene,
    source: Source,
    solver: OnceLock<Arc<Solver>>,
}

impl Scene {
    fn of(inner: recede::Scene, source: Source) -> Self {
        Self { inner, source, solver: OnceLock::new() }
    }

    /// The scene of a solution as an object of Python, of which a solver only knows how it is made.
    fn object(py: Python<'_>, inner: recede::Scene, source: Source) -> PyResult<Py<PyAny>> {
        Ok(Py::new(py, Self::of(inner, source))?.into_any())
    }

    /// The model of its stack, made when it is first needed.
    pub fn solver(&self, py: Python<'_>) -> PyResult<Arc<Solver>> {
        if let Some(solver) = self.solver.get() {
            return Ok(Arc::clone(solver));
        }
        let solver = self.new_solver(py, false)?;
        Ok(Arc::clone(self.solver.get_or_init(|| solver)))
    }

    /// A model of its own, for many loads if there are many.
    pub fn new_solver(&self, py: Python<'_>, many: bool) -> PyResult<Arc<Solver>> {
        Solver::new(py, self.inner.clone(), self.source.clone(), many, Self::object).map(Arc::new)
    }

    pub fn from_text(py: Python<'_>, text: &str) -> PyResult<Self> {
        recede::Scene::from_ron(text).map(|scene| Self::of(scene, Source::default())).map_err(|error| raised(py, error))
    }

    /// The text of the scene; an exception if a layer is a function, which has none.
    fn written(&self) -> PyResult<String> {
        self.source.written(&self.inner)
    }

    /// A part of it, by the name of the argument.
    fn part<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.written()?;
        py.import("recede._text")?.call_method1("part", (self.inner.to_json(), name))
    }

    fn check_path(&self, path: &str) -> PyResult<()> {
        if !self.source.is_hidden(&self.inner, path) {
            return Ok(());
        }
        Err(PyTypeError::new_err(format!("`{path}` is no number: the layer is a function of Python")))
    }
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(
        signature = (stack, punch=None, force=None, **fields),
        text_signature = "(stack, punch=None, force=None, *, punches=None, load=None, loads=None, half_length=None, depth=None, \
                          pressure_on_top=None, geometry=None, name=None, description=None, units=None)"
    )]
    fn new(
        py: Python<'_>,
        stack: &Bound<'_, PyAny>,
        punch: Option<&Bound<'_, PyAny>>,
        force: Option<&Bound<'_, PyAny>>,
        fields: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let (text, objects, layers): (String, Py<PyAny>, Functions) =
            py.import("recede._text")?.call_method("scene", (stack, punch, force), fields)?.extract()?;
        let objects = Arc::new(objects);
        let scene = recede::Scene::from_ron(&text).map_err(|error| raised_about(py, &error.into(), Some(&objects)))?;
        let source = Source::of(py, layers, objects)?;
        let scene = source.complete(scene);
        // whether the items fit together
        scene.stack().map_err(|error| source.failed(py, &error))?;
        Ok(Self::of(scene, source))
    }

    /// A scene from a text in RON.
    #[staticmethod]
    fn from_ron(py: Python<'_>, text: &str) -> PyResult<Self> {
        Self::from_text(py, text)
    }

    /// A scene from a text in JSON.
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        Self::from_text(py, text)
    }

    /// A scene from a file in RON or JSON.
    ///
    /// Raises:
    ///     OSError: such as `FileNotFoundError`, if the file cannot be read.
    ///     InputError: with file, line and a hint, if something in it is not legal.
    #[staticmethod]
    fn read(py: Python<'_>, path: std::path::PathBuf) -> PyResult<Self> {
        recede::Scene::read(&path)
            .map(|scene| Self::of(scene, Source::default()))
            .map_err(|error| file_error(py, &path, error))
    }

    /// The scene as a text in RON.
    fn to_ron(&self) -> PyResult<String> {
        self.written()
    }

    /// The scene as a text in JSON.
    fn to_json(&self) -> PyResult<String> {
        self.written().map(|_| self.inner.to_json())
    }

    /// What the scene is called in reports.
    #[getter]
    fn name(&self) -> &str {
        self.inner.title()
    }

    /// What the scene shows, or None.
    #[getter]
    fn description(&self) -> Option<&str> {
        self.inner.description.as_deref()
    }

    /// Labels of the units, or None.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let units = self.inner.units.as_ref();
        let make = |units: &recede::Units| {
            py.import("recede._values")?.call_method1("Units", (&units.length[..], &units.force[..]))
        };
        units.map(make).transpose()
    }

    /// "PlaneStrain", "PlaneStress" or "Axisymmetric".
    #[getter]
    fn geometry(&self) -> &'static str {
        self.inner.geometry.name()
    }

    /// The stack.
    #[getter]
    fn stack<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.part(py, "stack")
    }

    /// The punch; None where others, or a load, take its place.
    #[getter]
    fn punch<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.part(py, "punch")
    }

    /// The punches, where they are several, or one away from x = 0 or tilted, with their places, forces and tilts; or None.
    #[getter]
    fn punches<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.part(py, "punches")
    }

    /// The load in place of a punch, or None.
    #[getter]
    fn load<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.part(py, "load")
    }

    /// The loads in place of a punch, where they are several, with their places and forces; or None.
    #[getter]
    fn loads<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.part(py, "loads")
    }

    /// The force; None where a half-length or a depth is given.
    #[getter]
    fn force<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.part(py, "force")
    }

    /// The pressure everywhere on the top face, in stress; 0 if there is none.
    #[getter]
    fn pressure_on_top(&self) -> f64 {
        self.inner.pressure_on_top
    }

    /// The paths of all numbers that may vary, such as "force" and "layer[2].beta".
    #[getter]
    fn paths(&self) -> Vec<String> {
        let paths = self.inner.paths().into_iter();
        paths.filter(|path| !self.source.is_hidden(&self.inner, path)).collect()
    }

    /// The number at a path, in the units of the scene.
    fn number(&self, py: Python<'_>, path: &str) -> PyResult<f64> {
        self.check_path(path)?;
        self.inner.number(path).map_err(|error| self.source.failed(py, &error.into()))
    }

    /// The same scene with another number at a path.
    fn with_number(&self, py: Python<'_>, path: &str, value: f64) -> PyResult<Self> {
        self.check_path(path)?;
        let scene = self.inner.with(path, value).map_err(|error| self.source.failed(py, &error.into()))?;
        let source = self.source.without_objects(py);
        Ok(Self::of(source.complete(scene), source))
    }

    /// Solves the scene.
    ///
    /// Args:
    ///     tolerance: relative error to aim at, 1e-13 to 1e-2.
    ///
    /// Raises:
    ///     NoSolutionError: if no admissible contact was found.
    #[pyo3(signature = (*, tolerance=1e-10))]
    fn solve(&self, py: Python<'_>, tolerance: f64) -> PyResult<Solution> {
        let solution = Solution(self.solver(py)?.solve(py, tolerance)?);
        solution.warn(py)?;
        Ok(solution)
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
            Ok(text) => PyString::new(slf.py(), &text).hash(),
            Err(_) => Ok(slf.as_ptr() as isize),
        }
    }

    /// The drawing of `recede check`, for notebooks, which show the text of the scene where it cannot be drawn.
    #[pyo3(signature = (*, top=true))]
    fn _repr_html_(&self, py: Python<'_>, top: bool) -> PyResult<Option<String>> {
        let Ok(stack) = self.inner.stack().map_err(|error| self.source.failed(py, &error)) else { return Ok(None) };
        let recede::Scene { top: pressed, force, geometry, .. } = &self.inner;
        let label = top.then(|| format!("{}, {}", pressed.label(*geometry), force.label(*geometry)));
        drawing(py, &stack, label.as_deref()).map(Some)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        if self.source.has_functions() {
            return Ok(format!("<Scene {} with layers that are functions>", self.inner.title()));
        }
        let found = py.import("recede._text")?.call_method1("scene_repr", (self.inner.to_json(),));
        // a stack whose items do not fit together is no object
        found.map_or_else(|_| Ok(self.inner.to_ron()), |text| text.extract())
    }
}

/// A stack, and what is written on what presses if anything does, as HTML.
pub fn drawing(py: Python<'_>, stack: &recede::Stack, label: Option<&str>) -> PyResult<String> {
    py.import("recede._html")?.call_method1("drawing", (stack.drawing(label, Some(COLUMNS)),))?.extract()
}

/// A punch or load as the library knows it; kept by the object of Python for the geometry in which it was used.
#[pyclass(frozen, module = "recede._recede")]
pub struct CompiledTop {
    geometry: Geometry,
    top: Top,
}

/// The punch of an object of `recede.items`.
pub fn top(scene: &recede::Scene, item: &Bound<'_, PyAny>) -> PyResult<Top> {
    let py = item.py();
    let is_labelled = scene.units.is_some();
    if let Ok(known) = item.getattr("_compiled").and_then(|known| Ok(known.cast_into::<CompiledTop>()?))
        && known.get().geometry == scene.geometry
        && !is_labelled
    {
        return Ok(known.get().top.clone());
    }
    let units = scene.units.as_ref().map(|units| (units.length.clone(), units.force.clone()));
    let name = scene.geometry.name();
    let (text, objects): (String, Py<PyAny>) =
        py.import("recede._text")?.call_method1("with_punch", (item, name, units))?.extract()?;
    let read = recede::Scene::from_ron(&text).map_err(|error| raised_about(py, &error.into(), Some(&objects)))?;
    if !is_labelled {
        let compiled = PyDict::new(py);
        compiled
            .set_item("_compiled", Py::new(py, CompiledTop { geometry: scene.geometry, top: read.top.clone() })?)?;
        item.call_method1("_keep", (compiled,))?;
    }
    Ok(read.top)
}

/// The JSON Schema of scenes, with all layers, interfaces, bases, punches and loads.
#[pyfunction]
pub fn schema() -> String {
    recede::scene_schema(&Registry::default()).to_string()
}
