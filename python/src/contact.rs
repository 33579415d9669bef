//! Contacts of solutions.
use std::sync::Arc;

use pyo3::prelude::*;
use recede::{ApproachError, Error};

use crate::arrays;
use crate::errors::raised;
use crate::solver::Solved;

/// One contact of a solution. Pressures are positive in compression.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Contact {
    solved: Arc<Solved>,
    index: usize,
}

impl Contact {
    pub fn new(solved: Arc<Solved>, index: usize) -> Self {
        Self { solved, index }
    }

    fn inner(&self) -> &recede::Contact {
        &self.solved.solution.contacts()[self.index]
    }

    /// As in reports: a load is no punch.
    fn name(&self) -> String {
        self.solved.scene.top.contact_name(self.inner().interface)
    }
}

#[pymethods]
impl Contact {
    /// Which contact: "punch" (or "load"), or "2|3" between the layers 2 and 3.
    #[getter]
    fn interface(&self) -> String {
        self.name()
    }

    /// Half-length (radius) of a contact that is one interval, in length; None if it is none, or several.
    #[getter]
    fn half_length(&self) -> Option<f64> {
        self.inner().half_length()
    }

    /// Estimate of its absolute error.
    #[getter]
    fn half_length_error(&self) -> Option<f64> {
        self.inner().half_length_error()
    }

    /// As far as the bodies touch, in length.
    #[getter]
    fn reach(&self) -> f64 {
        self.inner().reach()
    }

    /// Pressure at x = 0, in stress; infinite under a sharp tip.
    #[getter]
    fn central_pressure(&self) -> f64 {
        self.inner().central_pressure
    }

    /// Estimate of its absolute error.
    #[getter]
    fn central_pressure_error(&self) -> f64 {
        self.inner().central_pressure_error
    }

    /// Resultant of the pressure.
    #[getter]
    fn resultant(&self) -> f64 {
        self.inner().resultant
    }

    /// Largest pressure, in stress.
    #[getter]
    fn peak_pressure(&self) -> f64 {
        self.inner().peak().pressure
    }

    /// Estimate of its absolute error.
    #[getter]
    fn peak_pressure_error(&self) -> f64 {
        self.inner().peak().error
    }

    /// Where it is, x >= 0, in length.
    #[getter]
    fn peak_at(&self) -> f64 {
        self.inner().peak().x
    }

    /// All intervals in which the bodies touch, from left to right.
    #[getter]
    fn intervals<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let module = py.import("recede._solutions")?;
        let of = |interval: &recede::Interval| {
            let recede::Interval { left, left_error, right, right_error, force, centroid } = interval;
            module.call_method1("Interval", (left, right, left_error, right_error, force, centroid))
        };
        self.inner().intervals().iter().map(of).collect()
    }

    /// Pressure at places x, in stress; 0 outside the contact, NaN where x is NaN.
    fn pressure<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let contact = self.inner();
        at_places(py, x, |places| Ok(py.detach(|| places.iter().map(|x| contact.pressure(*x)).collect())))
    }

    /// How far the bodies are apart at places x, in length; 0 where they touch, NaN where x is NaN.
    fn gap<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let Solved { solver, scene, solution, .. } = &*self.solved;
        at_places(py, x, |places| {
            let profile = py.detach(|| solver.model.profile(&scene.top, solution, places));
            let mut profile = profile.map_err(|error| solver.failed(py, &error.into()))?;
            profile.contacts.swap_remove(self.index).gap.ok_or_else(|| {
                let error = Error::Approach(ApproachError::Load);
                raised(py, error)
            })
        })
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.inner() == other.get().inner())
    }

    fn __repr__(&self) -> String {
        let contact = self.inner();
        format!("<Contact {}: {}, pressure at x = 0 {:e}>", self.name(), extent(contact), contact.central_pressure)
    }
}

/// How far a contact reaches: its half-length, or its outermost ends.
pub(crate) fn extent(contact: &recede::Contact) -> String {
    let ends = || (contact.intervals().first(), contact.intervals().last());
    match (contact.half_length(), ends()) {
        (Some(half_length), _) => format!("half-length {half_length:.6e}"),
        (None, (Some(first), Some(last))) => format!("from {:.6e} to {:.6e}", first.left, last.right),
        (None, _) => String::new(),
    }
}

/// Values at places, in an array of the same shape; a number for a number, and NaN for NaN.
fn at_places<'py>(
    py: Python<'py>,
    x: &Bound<'py, PyAny>,
    values: impl FnOnce(&[f64]) -> PyResult<Vec<f64>>,
) -> PyResult<Bound<'py, PyAny>> {
    let like = py.import("recede._arrays")?.call_method1("numbers", (x, "x"))?;
    let mut places = arrays::read(&like)?;
    let numbers: Vec<f64> = places.iter().copied().filter(|x| !x.is_nan()).collect();
    let mut found = values(&numbers)?.into_iter();
    places.iter_mut().filter(|x| !x.is_nan()).zip(&mut found).for_each(|(x, value)| *x = value);
    let shape = like.getattr("shape")?;
    let found = arrays::array(py, &places)?.call_method1("reshape", (&shape,))?;
    if shape.len()? == 0 { found.call_method0("item") } else { Ok(found) }
}
