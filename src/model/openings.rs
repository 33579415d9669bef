//! Layers that weights press together: solutions while all is closed, the force under which they begin to come apart, and solutions with openings.
use super::Model;
use crate::contact::{self, Asked, ContactError, NoSolution};
use crate::errors::Error;
use crate::kernel::Kernel;
use crate::options::Options;
use crate::scene::{Force, Top};
use crate::solution::{ClosedInterface, Interface, Separation, Solution};
use crate::weights::Weights;

impl Model {
    /// A solution with the interfaces that weights keep closed, from the one while all is closed.
    pub(super) fn with_closed(
        &self,
        (top, force): (&Top, Force),
        options: &Options,
        solution: Result<Solution, ContactError>,
    ) -> Result<Solution, Error> {
        let Some((_, weights)) = &self.closed else { return Ok(solution?) };
        let solution = match solution {
            Err(ContactError::NoSolution(cause)) if !cause.is_input() && !self.stack.geometry().is_axisymmetric() => {
                return self.opened((top, force, weights), options.tolerance, None, &[]);
            }
            found => found?,
        };
        let (closed, tensile) = weights.under(&solution);
        let Some((number, _)) = tensile else { return Ok(Solution { closed, ..solution }) };
        if !self.stack.geometry().is_axisymmetric() {
            return self.opened((top, force, weights), options.tolerance, Some(&solution), tensile.as_slice());
        }
        let ClosedInterface { interface, smallest_at: x, .. } = closed[number - 1];
        let critical_force = self.separation_of(top, &solution).map_or(f64::NAN, |own| own.critical_force);
        Err(NoSolution::LiftsOff { interface, x, critical_force }.into())
    }

    /// The solution with openings, from the solution while all is closed, if there is one, and from where layers would pull.
    fn opened(
        &self,
        (top, force, weights): (&Top, Force, &Weights),
        tolerance: f64,
        closed: Option<&Solution>,
        tensile: &[(usize, [f64; 2])],
    ) -> Result<Solution, Error> {
        let (interfaces, laminates) = (self.stack.contacts(), || Kernel::new(&self.stack).ok());
        let asked = Asked { tolerance, laminates: Some(&laminates), ..self.asked(top, &Options::default()) };
        Ok(contact::open(&Self::with_weights(&asked, weights, &interfaces), force, closed, tensile)?)
    }

    /// The solution while all is closed under all forces of another one scaled by a factor; nothing if a punch cannot carry them.
    fn scaled(&self, top: &Top, solution: &Solution, factor: f64) -> Result<Option<Solution>, ContactError> {
        let forces = solution.punches().iter().map(|carried| factor * carried.force);
        let scaled = top.punches().filter(|_| !solution.punches().is_empty()).map(|all| all.given(forces).into());
        let top = scaled.unwrap_or_else(|| top.clone());
        let force = Force::Given(factor * solution.force());
        match contact::press(&self.asked(&top, &Options::default()), force) {
            Err(ContactError::NoSolution(cause)) if cause.is_input() => Ok(None),
            found => found.map(Some),
        }
    }

    /// When layers that weights press together begin to come apart, if all forces on the top are scaled together; `None` if nothing presses layers together, or if no force
    /// that the punch can carry was found to part them before the contact above is some forty times as long as layers spread a pressure.
    ///
    /// ```
    /// use recede::{Model, Scene};
    /// let scene = Scene::from_ron("Scene(geometry: PlaneStrain, load: Line, force: 20.0, stack: [
    ///     Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0), Receding, Rigid])")?;
    /// let model = Model::new(scene.stack()?)?;
    /// let separation = model.separation(&scene.top, &model.press(&scene.top, scene.force)?)?.unwrap();
    /// assert!((separation.critical_force - 44.139105985).abs() < 1e-8 && (separation.x - 1.770537706).abs() < 1e-8);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Field`] if the solution is one of another stack.
    pub fn separation(&self, top: impl Into<Top>, solution: &Solution) -> Result<Option<Separation>, Error> {
        self.check_owns(solution)?;
        Ok(self.separation_of(&top.into(), solution))
    }

    fn separation_of(&self, top: &Top, solution: &Solution) -> Option<Separation> {
        let (_, weights) = self.closed.as_ref().filter(|_| solution.force() > 0.0)?;
        weights.separation(solution, top.loads().is_some() && !weights.has_dents(), |factor| {
            self.scaled(top, solution, factor)
        })
    }

    /// The same question where interfaces are closed but for openings.
    pub(super) fn with_weights<'a>(asked: &Asked<'a>, weights: &'a Weights, interfaces: &'a [Interface]) -> Asked<'a> {
        let (kernel, by_dents) = (&weights.kernel, &weights.by_dents[..]);
        Asked { kernel, interfaces, weights: &weights.interfaces, by_dents, ..*asked }
    }
}
