//! Stacks with their kernels, ready for any punch and force.
use std::sync::Arc;
use std::time::{Duration, Instant};

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyList;
use recede::{Error, Force, Options};

use crate::errors::{exception, raised};
use crate::field::Field;
use crate::function::Failure;
use crate::scene::{self, Scene};
use crate::solution::{Pressed, Solution};

/// How often a long computation asks whether it has been interrupted.
pub const PATIENCE: Duration = Duration::from_millis(100);

/// A scene's stack with its kernels.
pub struct Solver {
    /// The scene; its punch and force are those of whoever asks.
    pub scene: recede::Scene,
    pub model: recede::Model,
    functions: Vec<Failure>,
}

impl Solver {
    pub fn new(py: Python<'_>, scene: recede::Scene, functions: Vec<Failure>, many: bool) -> PyResult<Self> {
        let stack = scene.stack().map_err(|error| raised(py, error))?;
        let model = py.detach(|| recede::Model::new(stack));
        match model {
            Ok(model) => {
                let model = if many { model.for_many_loads() } else { model };
                Ok(Self { scene, model, functions })
            }
            Err(error) => Err(failed(py, &functions, &scene.locate(error))),
        }
    }

    /// The text of the scene; an exception if a layer is a function, which has none.
    pub fn text(&self) -> PyResult<String> {
        scene::written(&self.scene, &self.functions)
    }

    /// The solution for a punch and a force. The inner result is that of the library: a row of many has one of its own.
    pub fn press(self: &Arc<Self>, py: Python<'_>, pressed: Pressed) -> PyResult<Result<Solution, PyErr>> {
        self.press_located(py, pressed, |error| error)
    }

    /// The same for the punch and the force of the scene, whose text has a place for an error.
    pub fn solve(self: &Arc<Self>, py: Python<'_>, tolerance: f64) -> PyResult<Solution> {
        let pressed = Pressed { punch: self.scene.punch.clone(), force: self.scene.force, tolerance };
        self.press_located(py, pressed, |error| self.scene.locate(error))?
    }

    fn press_located(
        self: &Arc<Self>,
        py: Python<'_>,
        pressed: Pressed,
        locate: impl FnOnce(Error) -> Error,
    ) -> PyResult<Result<Solution, PyErr>> {
        let options = Options { tolerance: pressed.tolerance, ..Options::default() };
        let begun = Instant::now();
        let solved = py.detach(|| self.model.press_with(&pressed.punch, pressed.force, &options));
        Ok(match solved {
            Ok(solution) => {
                let solution = Solution::new(Arc::clone(self), pressed, solution, begun.elapsed().as_secs_f64());
                solution.warn(py)?;
                Ok(solution)
            }
            Err(error) => Err(self.failed(py, &locate(error))),
        })
    }

    pub fn failed(&self, py: Python<'_>, error: &Error) -> PyErr {
        failed(py, &self.functions, error)
    }
}

/// The exception for an error; that of a function in a layer, if it has raised one.
pub fn failed(py: Python<'_>, functions: &[Failure], error: &Error) -> PyErr {
    functions.iter().find_map(Failure::take).unwrap_or_else(|| exception(py, error))
}

/// A stack with its kernels: serves any punch and any force.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Model {
    solver: Arc<Solver>,
    many: bool,
}

#[pymethods]
impl Model {
    #[new]
    #[pyo3(signature = (stack, *, many_loads=false))]
    fn new(py: Python<'_>, stack: &Bound<'_, PyAny>, many_loads: bool) -> PyResult<Self> {
        let scene: Bound<'_, PyAny> = py.import("recede._text")?.call_method1("scene_of", (stack,))?;
        let scene = scene.cast::<Scene>()?.get();
        let solver = match many_loads {
            true => Arc::new(Solver::new(py, scene.inner.clone(), scene.functions().to_vec(), true)?),
            false => scene.solver(py)?,
        };
        Ok(Self { solver, many: many_loads })
    }

    #[pyo3(signature = (punch, force=None, *, half_length=None, depth=None, tolerance=1e-10))]
    fn press<'py>(
        &self,
        py: Python<'py>,
        punch: &Bound<'py, PyAny>,
        force: Option<&Bound<'py, PyAny>>,
        half_length: Option<&Bound<'py, PyAny>>,
        depth: Option<&Bound<'py, PyAny>>,
        tolerance: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        // a number in most calls; arrays, and what is wrong, are seen to in Python
        let (kind, number) = match (force, half_length, depth) {
            (Some(force), None, None) => ("force", force),
            (None, Some(half_length), None) => ("half_length", half_length),
            (None, None, Some(depth)) => ("depth", depth),
            _ => {
                let why = "exactly one of `force`, `half_length` and `depth` is to be given";
                return Err(pyo3::exceptions::PyTypeError::new_err(why));
            }
        };
        let punch = scene::punch(&self.solver.scene, punch)?;
        let one = |number: f64| Pressed { punch: punch.clone(), force: force_of(kind, number), tolerance };
        if let Ok(number) = number.cast_exact::<pyo3::types::PyFloat>() {
            let solution = self.solver.press(py, one(number.extract()?))??;
            return Ok(Bound::new(py, solution)?.into_any());
        }
        let arrays = py.import("recede._arrays")?;
        let numbers = arrays.call_method1("numbers", (number, kind))?;
        if numbers.getattr("ndim")?.extract::<usize>()? == 0 {
            let solution = self.solver.press(py, one(numbers.call_method0("item")?.extract()?))??;
            return Ok(Bound::new(py, solution)?.into_any());
        }
        let found = PyList::empty(py);
        let flat: PyReadonlyArray1<'_, f64> = numbers.call_method0("ravel")?.extract()?;
        let mut asked = Instant::now();
        for number in flat.as_array() {
            match self.solver.press(py, one(*number))? {
                Ok(solution) => found.append(Bound::new(py, solution)?)?,
                Err(error) => found.append(error.into_value(py))?,
            }
            if asked.elapsed() > PATIENCE {
                py.check_signals()?;
                asked = Instant::now();
            }
        }
        py.import("recede._solutions")?.call_method1("Solutions", (found, numbers))
    }

    fn field(&self, py: Python<'_>, solution: &Solution) -> PyResult<Field> {
        let field = self.solver.model.field(solution.solution()).map_err(|error| raised(py, error))?;
        Ok(Field::new(field, &self.solver))
    }

    #[getter]
    fn geometry(&self) -> String {
        scene::geometry_name(self.solver.scene.geometry)
    }

    fn __copy__(slf: Bound<'_, Self>) -> Bound<'_, Self> {
        slf
    }

    fn __deepcopy__<'py>(slf: Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Scene, bool))> {
        let py = slf.py();
        let scene = Scene::from_text(py, &slf.get().solver.text()?)?;
        Ok((py.import("recede._text")?.getattr("model")?, (scene, slf.get().many)))
    }

    fn __repr__(&self) -> String {
        let items = scene::names(&self.solver.scene.stack);
        format!("<Model {}: {}>", scene::geometry_name(self.solver.scene.geometry), items.join(", "))
    }
}

fn force_of(kind: &str, number: f64) -> Force {
    match kind {
        "half_length" => Force::ForHalfLength(number),
        "depth" => Force::ForDepth(number),
        _ => Force::Given(number),
    }
}
