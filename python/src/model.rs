//! Stacks with their kernels, ready for any punch and force.
use std::sync::Arc;
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use pyo3::types::PyList;
use recede::Force;

use crate::arrays;
use crate::errors::raised;
use crate::field::Field;
use crate::scene::{self, Scene};
use crate::solution::Solution;
use crate::solver::Solver;

/// How often a long computation asks whether it has been interrupted.
pub const PATIENCE: Duration = Duration::from_millis(100);

/// A stack with its kernels: serves any punch and any force.
///
/// Args:
///     stack: a `Stack`, or a `Scene`, of which the stack is taken.
///     many_loads: keeps solutions at fixed forces and interpolates between them, for thousands of forces under one punch.
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
            true => scene.new_solver(py, true)?,
            false => scene.solver(py)?,
        };
        Ok(Self { solver, many: many_loads })
    }

    /// Presses a punch, or a load, on the stack; other threads of Python go on meanwhile.
    ///
    /// Args:
    ///     punch: such as `Cylinder(radius=500)`, or a load such as `Uniform(half_width=1)`.
    ///     force: force per unit length out of the plane, or the whole force in axisymmetric stacks; a number, or an array of them, in
    ///         which a number that is not legal, or has no solution, has an error of its own.
    ///     half_length: in place of the force: half-length (radius) of the contact under the punch, in length.
    ///     depth: in place of the force: how far the punch sinks, in length.
    ///     tolerance: relative error to aim at, 1e-13 to 1e-2.
    ///
    /// Raises:
    ///     InputError: if a number is not legal.
    ///     NoSolutionError: if no admissible contact was found.
    #[pyo3(signature = (punch, force=None, *, half_length=None, depth=None, tolerance=1e-10))]
    #[expect(clippy::too_many_arguments, reason = "they are the keywords of Python")]
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
        let top = scene::top(&self.solver.scene, punch)?;
        let one = |number: f64| {
            let solved = self.solver.press(py, &top, force_of(kind, number), tolerance);
            solved.map(Solution).map_err(|error| self.solver.failed(py, &error))
        };
        let alone = |number: f64| -> PyResult<Bound<'py, PyAny>> {
            let solution = one(number)?;
            solution.warn(py)?;
            Ok(Bound::new(py, solution)?.into_any())
        };
        if let Ok(number) = number.cast_exact::<pyo3::types::PyFloat>() {
            return alone(number.extract()?);
        }
        let arrays = py.import("recede._arrays")?;
        let numbers = arrays.call_method1("numbers", (number, kind))?;
        if numbers.getattr("ndim")?.extract::<usize>()? == 0 {
            return alone(numbers.call_method0("item")?.extract()?);
        }
        let (found, warnings) = (PyList::empty(py), PyList::empty(py));
        let mut asked = Instant::now();
        for number in &arrays::read(&numbers)? {
            match one(*number) {
                Ok(solution) => {
                    let told = solution.warnings();
                    told.into_iter().try_for_each(|(code, text)| warnings.append((code, text, *number)))?;
                    found.append(Bound::new(py, solution)?)?;
                }
                Err(error) => found.append(error.into_value(py))?,
            }
            if asked.elapsed() > PATIENCE {
                py.check_signals()?;
                asked = Instant::now();
            }
        }
        py.import("recede._errors")?.call_method1("warn_many", (warnings, kind, found.len()))?;
        py.import("recede._solutions")?.call_method1("Solutions", (found, numbers))
    }

    /// Stresses and displacements, for a solution of this stack.
    fn field(&self, py: Python<'_>, solution: &Solution) -> PyResult<Field> {
        let field = self.solver.model.field(&solution.0.solution).map_err(|error| raised(py, error))?;
        Ok(Field::new(field, &self.solver))
    }

    /// "PlaneStrain", "PlaneStress" or "Axisymmetric".
    #[getter]
    fn geometry(&self) -> &'static str {
        self.solver.scene.geometry.name()
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

    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        scene::drawing(py, self.solver.model.stack(), None)
    }

    fn __repr__(&self) -> String {
        let recede::Scene { geometry, stack, .. } = &self.solver.scene;
        let items: Vec<&str> = stack.iter().map(recede::Item::name).collect();
        format!("<Model {}: {}>", geometry.name(), items.join(", "))
    }
}

fn force_of(kind: &str, number: f64) -> Force {
    match kind {
        "half_length" => Force::ForHalfLength(number),
        "depth" => Force::ForDepth(number),
        _ => Force::Given(number),
    }
}
