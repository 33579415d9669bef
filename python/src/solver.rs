//! Stacks with their kernels, and what they have solved. All objects of Python that come after a scene share these.
use std::sync::{Arc, OnceLock};
use std::time::Instant;

use pyo3::prelude::*;
use recede::{Approach, ApproachError, Error, Force, Options, Top};

use crate::errors::raised;
use crate::source::Source;

/// Makes a scene, with what it was made of, an object of Python.
type SceneObject = fn(Python<'_>, recede::Scene, Source) -> PyResult<Py<PyAny>>;

/// A scene's stack with its kernels.
pub struct Solver {
    /// The scene; each question brings a punch and a force in place of the ones in it.
    pub scene: recede::Scene,
    pub model: recede::Model,
    source: Source,
    /// Makes a scene an object of Python.
    scene_object: SceneObject,
}

impl Solver {
    pub fn new(
        py: Python<'_>,
        scene: recede::Scene,
        source: Source,
        many: bool,
        scene_object: SceneObject,
    ) -> PyResult<Self> {
        let stack = scene.stack().map_err(|error| source.failed(py, &error))?;
        let model = py.detach(|| recede::Model::new(stack));
        match model {
            Ok(model) => {
                let model = if many { model.for_many_loads() } else { model };
                Ok(Self { scene, model, source, scene_object })
            }
            Err(error) => Err(source.failed(py, &scene.locate(error))),
        }
    }

    /// The text of the scene; an exception if a layer is a function, which has none.
    pub fn text(&self) -> PyResult<String> {
        self.source.written(&self.scene)
    }

    /// The solution for a punch and a force.
    pub fn press(
        self: &Arc<Self>,
        py: Python<'_>,
        top: &Top,
        force: Force,
        tolerance: f64,
    ) -> Result<Arc<Solved>, Error> {
        let options = Options { tolerance };
        let begun = Instant::now();
        let solution = py.detach(|| self.model.press_with(top, force, &options))?;
        let (seconds, approaches) = (begun.elapsed().as_secs_f64(), OnceLock::new());
        let mut scene = self.scene.clone();
        (scene.top, scene.force) = (top.clone(), force);
        Ok(Arc::new(Solved { solver: Arc::clone(self), scene, solution, tolerance, seconds, approaches }))
    }

    /// The same for the punch and the force of the scene, whose text has a place for an error.
    pub fn solve(self: &Arc<Self>, py: Python<'_>, tolerance: f64) -> PyResult<Arc<Solved>> {
        let solved = self.press(py, &self.scene.top, self.scene.force, tolerance);
        solved.map_err(|error| self.failed(py, &self.scene.locate(error)))
    }

    pub fn failed(&self, py: Python<'_>, error: &Error) -> PyErr {
        self.source.failed(py, error)
    }
}

/// A solution with the solver and the scene that it belongs to.
pub struct Solved {
    pub solver: Arc<Solver>,
    /// The scene of the solver, with the punch or load and the force that were solved for.
    pub scene: recede::Scene,
    pub solution: recede::Solution,
    pub tolerance: f64,
    pub seconds: f64,
    pub approaches: OnceLock<Vec<Result<Approach, ApproachError>>>,
}

impl Solved {
    /// Its scene as an object of Python.
    pub fn scene_object(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let Self { solver, scene: own, .. } = self;
        if own.top == solver.scene.top && own.force == solver.scene.force {
            return (solver.scene_object)(py, own.clone(), solver.source.clone());
        }
        // a text of its own, in which numbers may vary; an error in it is about objects
        let scene = recede::Scene::from_ron(&solver.source.written(own)?).map_err(|error| raised(py, error))?;
        (solver.scene_object)(py, scene, Source::of_objects(py))
    }
}
