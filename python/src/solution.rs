//! Solutions and their contacts.
use std::sync::{Arc, OnceLock};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use recede::report::{Format, Report};
use recede::{Approach, ApproachError, Error, Force, Punch};

use crate::errors::raised;
use crate::field::Field;
use crate::model::Solver;

/// What a stack is pressed by.
#[derive(Clone)]
pub struct Pressed {
    pub punch: Punch,
    pub force: Force,
    pub tolerance: f64,
}

/// A solution with what it is one of.
struct Solved {
    solver: Arc<Solver>,
    pressed: Pressed,
    solution: recede::Solution,
    seconds: f64,
    approach: OnceLock<Result<Approach, ApproachError>>,
}

/// A solved scene.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Solution(Arc<Solved>);

impl Solution {
    pub fn new(solver: Arc<Solver>, pressed: Pressed, solution: recede::Solution, seconds: f64) -> Self {
        Self(Arc::new(Solved { solver, pressed, solution, seconds, approach: OnceLock::new() }))
    }

    pub fn solution(&self) -> &recede::Solution {
        &self.0.solution
    }

    /// Hands the warnings to Python's `warnings`.
    pub fn warn(&self, py: Python<'_>) -> PyResult<()> {
        let warnings = self.0.solution.warnings();
        if warnings.is_empty() {
            return Ok(());
        }
        let all: Vec<(&str, &str)> = warnings.iter().map(|w| (w.code.as_str(), &w.message[..])).collect();
        py.import("recede._errors")?.call_method1("warn", (all,)).map(drop)
    }

    fn approach_of(&self, py: Python<'_>) -> Result<Approach, ApproachError> {
        let Solved { solver, pressed, solution, approach, .. } = &*self.0;
        py.detach(|| approach.get_or_init(|| solver.model.approach(&pressed.punch, solution)).clone())
    }

    /// A number of the approach, if there is one.
    fn approach_number(&self, py: Python<'_>, of: impl Fn(&Approach) -> Option<f64>) -> PyResult<Option<f64>> {
        match self.approach_of(py) {
            Ok(approach) => Ok(of(&approach)),
            Err(ApproachError::Field(error)) => Err(raised(py, error)),
            Err(_) => Ok(None),
        }
    }

    /// The scene that it solves.
    fn scene(&self) -> recede::Scene {
        let Solved { solver, pressed, .. } = &*self.0;
        let mut scene = solver.scene.clone();
        (scene.punch, scene.force) = (pressed.punch.clone(), pressed.force);
        scene
    }

    fn written(&self, py: Python<'_>, format: Format) -> PyResult<String> {
        let (scene, approach) = (self.scene(), self.approach_of(py));
        let report = Report {
            scene: &scene,
            solution: &self.0.solution,
            approach: Some(&approach),
            max_shear: None,
            extremes: None,
            digits: None,
            seconds: self.0.seconds,
        };
        let mut text = Vec::new();
        report.write(format, &mut text)?;
        Ok(String::from_utf8_lossy(&text).into_owned())
    }

    fn picture(&self) -> recede::plot::Picture {
        recede::plot::stack(&self.scene(), self.0.solver.model.stack(), &self.0.solution)
    }
}

#[pymethods]
impl Solution {
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, pyo3::types::PyTuple>> {
        let contact = |index: usize| Contact { solved: Arc::clone(&self.0), index };
        pyo3::types::PyTuple::new(py, (0..self.0.solution.contacts().len()).map(contact))
    }

    #[getter]
    fn force(&self) -> f64 {
        self.0.solution.force()
    }

    #[getter]
    fn force_error(&self) -> f64 {
        self.0.solution.force_error()
    }

    #[getter]
    fn tolerance(&self) -> f64 {
        self.0.pressed.tolerance
    }

    #[getter]
    fn approach(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| Some(approach.value))
    }

    #[getter]
    fn approach_error(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| Some(approach.error))
    }

    #[getter]
    fn stiffness(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| approach.stiffness.value())
    }

    #[getter]
    fn stiffness_error(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.approach_number(py, |approach| approach.stiffness.error())
    }

    #[getter]
    fn min_pressure(&self) -> f64 {
        self.0.solution.min_pressure()
    }

    #[getter]
    fn min_gap(&self) -> f64 {
        self.0.solution.min_gap()
    }

    #[getter]
    fn modes(&self) -> usize {
        self.0.solution.modes()
    }

    #[getter]
    fn wavenumbers(&self) -> usize {
        self.0.solution.wavenumbers()
    }

    #[getter]
    fn newton_steps(&self) -> usize {
        self.0.solution.newton_steps()
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.0.seconds
    }

    /// (code, sentence) of each warning.
    #[getter]
    fn warnings(&self) -> Vec<(&str, &str)> {
        self.0.solution.warnings().iter().map(|w| (w.code.as_str(), &w.message[..])).collect()
    }

    fn field(&self, py: Python<'_>) -> PyResult<Field> {
        let field = self.0.solver.model.field(&self.0.solution).map_err(|error| raised(py, error))?;
        Ok(Field::new(field, &self.0.solver))
    }

    fn to_json(&self, py: Python<'_>) -> PyResult<String> {
        self.written(py, Format::Json)
    }

    fn svg(&self) -> String {
        self.picture().svg()
    }

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
        Ok((py.import("recede._text")?.getattr("solve_text")?, (self.scene().to_ron(), self.0.pressed.tolerance)))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.0.solution == other.get().0.solution)
    }

    fn __str__(&self, py: Python<'_>) -> PyResult<String> {
        self.written(py, Format::Table)
    }

    fn __repr__(&self) -> String {
        let of = |contact: &recede::Contact| format!("{}: {:.6e}", contact.interface, contact.reach());
        let contacts: Vec<String> = self.0.solution.contacts().iter().map(of).collect();
        format!("<Solution force {}; half-lengths {}>", self.0.solution.force(), contacts.join(", "))
    }
}

/// One contact of a solution.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Contact {
    solved: Arc<Solved>,
    index: usize,
}

impl Contact {
    fn inner(&self) -> &recede::Contact {
        &self.solved.solution.contacts()[self.index]
    }
}

#[pymethods]
impl Contact {
    #[getter]
    fn interface(&self) -> String {
        self.inner().interface.to_string()
    }

    #[getter]
    fn half_length(&self) -> Option<f64> {
        self.inner().half_length()
    }

    #[getter]
    fn half_length_error(&self) -> Option<f64> {
        self.inner().half_length_error()
    }

    #[getter]
    fn reach(&self) -> f64 {
        self.inner().reach()
    }

    #[getter]
    fn central_pressure(&self) -> f64 {
        self.inner().central_pressure
    }

    #[getter]
    fn central_pressure_error(&self) -> f64 {
        self.inner().central_pressure_error
    }

    #[getter]
    fn resultant(&self) -> f64 {
        self.inner().resultant
    }

    #[getter]
    fn peak_pressure(&self) -> f64 {
        self.inner().peak().pressure
    }

    #[getter]
    fn peak_pressure_error(&self) -> f64 {
        self.inner().peak().error
    }

    #[getter]
    fn peak_at(&self) -> f64 {
        self.inner().peak().x
    }

    #[getter]
    fn intervals<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let module = py.import("recede._solutions")?;
        let of = |interval: recede::Interval| {
            let recede::Interval { left, left_error, right, right_error, force, centroid } = interval;
            module.call_method1("Interval", (left, right, left_error, right_error, force, centroid))
        };
        self.inner().intervals().into_iter().map(of).collect()
    }

    fn pressure<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let contact = self.inner();
        at_places(py, x, |places| Ok(py.detach(|| places.iter().map(|x| contact.pressure(*x)).collect())))
    }

    fn gap<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let Solved { solver, pressed, solution, .. } = &*self.solved;
        at_places(py, x, |places| {
            let profile = py.detach(|| solver.model.profile(&pressed.punch, solution, places));
            let mut profile = profile.map_err(|error| solver.failed(py, &error.into()))?;
            profile.contacts.swap_remove(self.index).gap.ok_or_else(|| {
                let error = Error::Approach(ApproachError::Load);
                crate::errors::exception(py, &error)
            })
        })
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.inner() == other.get().inner())
    }

    fn __repr__(&self) -> String {
        let contact = self.inner();
        format!(
            "<Contact {}: half-length {:e}, pressure at x = 0 {:e}>",
            contact.interface,
            contact.reach(),
            contact.central_pressure
        )
    }
}

/// Values at places, in an array of the same shape; a number for a number.
fn at_places<'py>(
    py: Python<'py>,
    x: &Bound<'py, PyAny>,
    values: impl FnOnce(&[f64]) -> PyResult<Vec<f64>>,
) -> PyResult<Bound<'py, PyAny>> {
    let places = py.import("recede._arrays")?.call_method1("numbers", (x, "x"))?;
    let flat: PyReadonlyArray1<'_, f64> = places.call_method0("ravel")?.extract()?;
    let found = PyArray1::from_vec(py, values(flat.as_slice()?)?);
    shaped(found.into_any(), &places)
}

/// In the shape of another array; a number if that has no dimension.
pub fn shaped<'py>(found: Bound<'py, PyAny>, like: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let shape = like.getattr("shape")?;
    let found = found.call_method1("reshape", (&shape,))?;
    if shape.len()? == 0 { found.call_method0("item") } else { Ok(found) }
}

/// A dictionary of numbers.
pub fn dictionary<'py>(py: Python<'py>, fields: &[(&str, f64)]) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    fields.iter().try_for_each(|(name, value)| all.set_item(name, value))?;
    Ok(all)
}
