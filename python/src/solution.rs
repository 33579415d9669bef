//! Solutions.
use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use recede::report::{Format, Report};
use recede::{Approach, ApproachError, FieldError};

use crate::arrays;
use crate::contact::{Contact, extent};
use crate::errors::raised;
use crate::field::{Field, units};
use crate::solver::Solved;

/// A solved scene. In a notebook it shows a table and the picture.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Solution(pub Arc<Solved>);

impl Solution {
    /// Hands the warnings to Python's `warnings`.
    pub fn warn(&self, py: Python<'_>) -> PyResult<()> {
        let warnings = self.0.solution.warnings();
        if warnings.is_empty() {
            return Ok(());
        }
        let all: Vec<(&str, &str)> = warnings.iter().map(|w| (w.code.as_str(), &w.message[..])).collect();
        py.import("recede._errors")?.call_method1("warn", (all,)).map(drop)
    }

    /// The approach of each punch, computed once.
    fn approaches(&self, py: Python<'_>) -> &[Result<Approach, ApproachError>] {
        let Solved { solver, scene, solution, approaches, .. } = &*self.0;
        py.detach(|| approaches.get_or_init(|| solver.model.approaches(&scene.top, solution)))
    }

    /// A number of the approach, if there is one.
    fn approach_number(&self, py: Python<'_>, of: impl Fn(&Approach) -> Option<f64>) -> PyResult<Option<f64>> {
        match self.approaches(py) {
            [Ok(approach)] => Ok(of(approach)),
            // not told where layers come apart
            [Err(ApproachError::Field(FieldError::Openings))] => Ok(None),
            [Err(ApproachError::Field(error))] => Err(raised(py, error.clone())),
            _ => Ok(None),
        }
    }

    /// A part of its scene, by the name of the argument.
    fn part<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        py.import("recede._text")?.call_method1("part", (self.0.scene.to_json(), name))
    }

    fn written(&self, py: Python<'_>, format: Format, max_shear: bool, extremes: bool) -> PyResult<String> {
        let Solved { solver, scene, solution, seconds, .. } = &*self.0;
        let failed = |error: FieldError| solver.failed(py, &error.into());
        let field = || solver.model.field(solution);
        let max_shear = max_shear.then(|| py.detach(|| field()?.max_shear())).transpose().map_err(failed)?;
        let extremes = extremes.then(|| py.detach(|| field()?.extremes())).transpose().map_err(failed)?;
        let separation =
            py.detach(|| solver.model.separation(&scene.top, solution)).map_err(|error| solver.failed(py, &error))?;
        let report = Report {
            scene,
            solution,
            separation,
            approaches: self.approaches(py),
            max_shear,
            extremes: extremes.as_ref(),
            collocated: None,
            digits: None,
            seconds: *seconds,
        };
        let mut text = Vec::new();
        report.write(format, &mut text)?;
        Ok(String::from_utf8_lossy(&text).into_owned())
    }

    fn picture(&self) -> recede::plot::Picture {
        recede::plot::stack(&self.0.scene, self.0.solver.model.stack(), &self.0.solution)
    }
}

#[pymethods]
impl Solution {
    /// The contacts from the top down, the punch first; `contacts["2|3"]` is the one between the layers 2 and 3.
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let contact = |index: usize| Contact::new(Arc::clone(&self.0), index);
        let all = PyTuple::new(py, (0..self.0.solution.contacts().len()).map(contact))?;
        py.import("recede._solutions")?.call_method1("Contacts", (all,))
    }

    /// The force that presses, per unit length out of the plane, or the whole force in axisymmetric scenes.
    #[getter]
    fn force(&self) -> f64 {
        self.0.solution.force()
    }

    /// Estimate of its absolute error; 0 if it was given.
    #[getter]
    fn force_error(&self) -> f64 {
        self.0.solution.force_error()
    }

    /// The relative error that was aimed at.
    #[getter]
    fn tolerance(&self) -> f64 {
        self.0.tolerance
    }

    /// How far the punch has sunk, in length; None where that is not defined, such as over a half-plane in plane scenes.
    #[getter]
    fn approach(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| Some(approach.value))
    }

    /// Estimate of its absolute error.
    #[getter]
    fn approach_error(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| Some(approach.error))
    }

    /// The derivative of the force with respect to the approach; None where it is not known.
    #[getter]
    fn stiffness(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| approach.stiffness.value())
    }

    /// Estimate of its absolute error.
    #[getter]
    fn stiffness_error(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| approach.stiffness.error())
    }

    /// What each punch carries, from left to right; none for loads, and for one punch at x = 0 that is not turned.
    #[getter]
    fn carried<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (module, all) = (py.import("recede._solutions")?, self.0.solution.punches());
        let approaches = if all.is_empty() { &[] } else { self.approaches(py) };
        let of = |(k, carried): (usize, &recede::Carried)| {
            let found = approaches.get(k).and_then(|found| found.as_ref().ok());
            let [approach, error] = [found.map(|found| found.value), found.map(|found| found.error)];
            module.call_method1("Carried", (carried.force, carried.tilt, carried.moment, approach, error))
        };
        all.iter().enumerate().map(of).collect()
    }

    /// The interfaces that weights, or a pressure on top, keep closed but for openings, from the top down; they are no contacts.
    #[getter]
    fn closed<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let module = py.import("recede._solutions")?;
        let of = |own: &recede::ClosedInterface| {
            let opening = |one: &recede::Opening| {
                let numbers =
                    (one.left, one.right, one.left_error, one.right_error, one.largest_gap, one.largest_gap_at);
                module.call_method1("Opening", numbers)
            };
            let openings = PyTuple::new(py, own.openings.iter().map(opening).collect::<PyResult<Vec<_>>>()?)?;
            let pressures = (own.weight, own.central_pressure, own.central_pressure_error);
            let (weight, central, error) = pressures;
            let least = (own.smallest_pressure, own.smallest_at);
            module.call_method1(
                "ClosedInterface",
                (own.interface.to_string(), weight, central, error, least.0, least.1, openings),
            )
        };
        self.0.solution.closed().iter().map(of).collect()
    }

    /// When layers that weights press together begin to come apart, if all forces are scaled together; or None.
    #[getter]
    fn separation<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Solved { solver, scene, solution, .. } = &*self.0;
        let found = py.detach(|| solver.model.separation(&scene.top, solution));
        let make = |own: recede::Separation| {
            let numbers = (own.critical_force, own.critical_force_error, own.interface.to_string(), own.x);
            py.import("recede._solutions")?.call_method1("Separation", numbers)
        };
        found.map_err(|error| solver.failed(py, &error))?.map(make).transpose()
    }

    /// The angles by which the layers above each receding interface are turned: the means of their slopes far to the left and far to the right.
    #[getter]
    fn rotations(&self) -> Vec<f64> {
        self.0.solution.rotations().to_vec()
    }

    /// Smallest pressure found inside the contacts, in stress.
    #[getter]
    fn min_pressure(&self) -> f64 {
        self.0.solution.min_pressure()
    }

    /// Smallest gap found outside the contacts, in length.
    #[getter]
    fn min_gap(&self) -> f64 {
        self.0.solution.min_gap()
    }

    /// Largest number of modes of a pressure.
    #[getter]
    fn modes(&self) -> usize {
        self.0.solution.modes()
    }

    /// Number of wavenumbers at which the stack was evaluated.
    #[getter]
    fn wavenumbers(&self) -> usize {
        self.0.solution.wavenumbers()
    }

    /// Newton steps taken.
    #[getter]
    fn newton_steps(&self) -> usize {
        self.0.solution.newton_steps()
    }

    /// The time that it took, without the kernels of the stack.
    #[getter]
    fn seconds(&self) -> f64 {
        self.0.seconds
    }

    /// (code, sentence) of each warning; they were handed to Python's `warnings`, too.
    #[getter]
    pub fn warnings(&self) -> Vec<(&str, &str)> {
        self.0.solution.warnings().iter().map(|w| (w.code.as_str(), &w.message[..])).collect()
    }

    /// The scene that was solved.
    #[getter]
    fn scene(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.0.scene_object(py)
    }

    /// The punch that presses; None where a load takes its place.
    #[getter]
    fn punch<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.part(py, "punch")
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

    /// Stresses and displacements.
    fn field(&self, py: Python<'_>) -> PyResult<Field> {
        let field = self.0.solver.model.field(&self.0.solution).map_err(|error| raised(py, error))?;
        Ok(Field::new(field, &self.0.solver))
    }

    /// Pressures and gaps of all contacts, displacements and slopes of all faces, along x: a table with the columns of `recede profile`,
    /// at places that are dense next to the ends of the contacts. Infinite beyond the edge of a punch.
    ///
    /// Args:
    ///     to: how far to go on both sides, in length; twice as far as the bodies touch if not given.
    ///     points: how many places, about.
    #[pyo3(signature = (to=None, *, points=400))]
    fn profile<'py>(&self, py: Python<'py>, to: Option<f64>, points: usize) -> PyResult<Bound<'py, PyAny>> {
        let Solved { solver, scene, solution, .. } = &*self.0;
        if to.is_some_and(|to| !(to.is_finite() && to > 0.0)) {
            return Err(PyValueError::new_err("`to` has to be a length > 0"));
        }
        let profile = py.detach(|| {
            let places = recede::profile_places(solution, to, points);
            solver.model.profile(&scene.top, solution, &places)
        });
        let profile = profile.map_err(|error| solver.failed(py, &error.into()))?;
        let columns = arrays::columns(py, recede::report::profile_columns(&profile))?;
        py.import("recede._table")?.call_method1("Columns", (columns,))
    }

    /// Draws the pressures of all contacts with `matplotlib`, and returns the axes.
    ///
    /// Args:
    ///     ax: axes to draw on; new ones if not given.
    #[pyo3(signature = (ax=None))]
    fn plot<'py>(&self, py: Python<'py>, ax: Option<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        let scene = &self.0.scene;
        let (profile, along) = (self.profile(py, None, 400)?, scene.geometry.words().along);
        py.import("recede._plots")?.call_method1("pressures", (profile, ax, along, units(scene)))
    }

    /// All numbers as JSON, as `recede solve --format json` writes them.
    ///
    /// Args:
    ///     max_shear: with the largest shear stress, see `Field.max_shear`.
    ///     extremes: with the stresses by which layers and bonds break, see `Field.extremes`.
    #[pyo3(signature = (*, max_shear=false, extremes=false))]
    fn to_json(&self, py: Python<'_>, max_shear: bool, extremes: bool) -> PyResult<String> {
        self.written(py, Format::Json, max_shear, extremes)
    }

    /// The stack to scale with its contacts, and the pressures below it, as SVG.
    fn svg(&self) -> String {
        self.picture().svg()
    }

    /// The same as PNG.
    fn png<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, pyo3::types::PyBytes>> {
        let bytes =
            self.picture().png().map_err(|error| pyo3::exceptions::PyRuntimeError::new_err(error.to_string()))?;
        Ok(pyo3::types::PyBytes::new(py, &bytes))
    }

    fn _repr_svg_(&self) -> String {
        self.svg()
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("recede._html")?.call_method1("solution", (slf,))
    }

    fn __copy__(slf: Bound<'_, Self>) -> Bound<'_, Self> {
        slf
    }

    fn __deepcopy__<'py>(slf: Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String, f64))> {
        self.0.solver.text()?;
        Ok((py.import("recede._text")?.getattr("solve_text")?, (self.0.scene.to_ron(), self.0.tolerance)))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.0.solution == other.get().0.solution)
    }

    fn __str__(&self, py: Python<'_>) -> PyResult<String> {
        self.written(py, Format::Table, false, false)
    }

    fn __repr__(&self) -> String {
        let of = |contact: &recede::Contact| format!("{} {}", contact.interface, extent(contact));
        let contacts: Vec<String> = self.0.solution.contacts().iter().map(of).collect();
        format!("<Solution force {}; contacts {}>", self.0.solution.force(), contacts.join(", "))
    }
}
