//! A stack with its kernels, computed once and used for any punch and load.
mod openings;

use std::sync::Arc;

use crate::approach::{self, Approach, ApproachError};
use crate::collocation::{self, Collocated};
use crate::contact::{self, Asked, ContactError, Curves, NoSolution};
use crate::errors::Error;
use crate::field::{Field, FieldError};
use crate::kernel::Kernel;
use crate::options::Options;
use crate::profile::{self, FaceProfiles};
use crate::scene::{Force, Load, Loads, Pressed, Punch, Scene, Top};
use crate::solution::{ClosedInterface, Interface, Ledger, OwnerKey, Solution};
use crate::stack::{Gaps, Stack};
use crate::weights::Weights;

/// A force is next to nothing if it is this part of what weights press with on a length of the thickness: far below rounding.
const NOTHING: f64 = 1e-24;

/// A stack with its kernels: the flexibilities of its laminates over the wavenumber.
///
/// Nothing in it depends on punch, load or contact length, so one model serves any number of them; see
/// [`Self::for_many_loads`] where they are very many.
///
/// ```
/// use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
/// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
/// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
/// let model = Model::new(stack)?;
/// for force in [0.001, 0.002] {
///     let solution = model.press(&Punch::cylinder(500.0)?, force)?;
///     let [punch, receding] = solution.contacts() else { unreachable!() };
///     assert!(punch.reach() < receding.reach());
/// }
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    stack: Stack,
    /// The key of the stack, by which a solution is known to belong to it.
    key: OwnerKey,
    interfaces: Vec<Interface>,
    gaps: Gaps,
    kernel: Kernel,
    /// The stack that is solved for, in which interfaces that weights press together are closed, and the weights on these interfaces; `None` if nothing presses layers together.
    closed: Option<(Stack, Weights)>,
    curves: Option<Arc<Curves>>,
}

impl Model {
    /// How many numbers the model stores, about.
    pub(crate) fn stored_numbers(&self) -> usize {
        let of_weights = self.closed.as_ref().map_or(0, |(_, weights)| weights.kernel.stored_numbers());
        self.kernel.stored_numbers() + of_weights + self.curves.as_ref().map_or(0, |curves| curves.stored_numbers())
    }

    /// Evaluates the stack's flexibilities.
    ///
    /// # Errors
    /// [`Error::Unresolved`] if a layer's fields are not finite at some wavenumber, or vary too fast with it.
    pub fn new(stack: Stack) -> Result<Self, Error> {
        stack.check_faces()?;
        let weights = Weights::of(&stack)?;
        let closed = weights.and_then(|weights| Some((stack.closed()?, weights)));
        let own = closed.as_ref().map_or(&stack, |(closed, _)| closed);
        let (kernel, key) = (Kernel::new(own)?, OwnerKey::new(stack.key()));
        let (interfaces, gaps) = (own.contacts(), own.gaps());
        Ok(Self { key, interfaces, gaps, stack, kernel, closed, curves: None })
    }

    /// The same model for many forces under a few punches: it keeps solutions at fixed forces, each of them found when it is first needed, and interpolates between
    /// these. The first force takes a dozen solutions, one more some microseconds.
    ///
    /// Numbers differ from the numbers of the model as it was in digits beyond the tolerance only, and like them they depend
    /// neither on what was pressed before nor on threads that share the model.
    #[must_use]
    pub fn for_many_loads(self) -> Self {
        Self { curves: Some(Arc::default()), ..self }
    }

    /// The stack.
    pub fn stack(&self) -> &Stack {
        &self.stack
    }

    /// Presses a punch or loads with a force (per unit length out of plane) on the stack, to ten digits. The force is a number, or, under a
    /// punch, [`Force::ForHalfLength`] or [`Force::ForDepth`].
    ///
    /// # Errors
    /// As [`Self::press_with`].
    pub fn press(&self, top: impl Into<Top>, force: impl Into<Force>) -> Result<Solution, Error> {
        self.press_with(top, force, &Options::default())
    }

    /// Presses a punch or loads with a force (per unit length out of plane) on the stack.
    ///
    /// # Errors
    /// [`Error::Value`] or [`Error::Options`] if a number is not legal; [`Error::Stack`] if an elastic punch is stiffer
    /// or softer than the layers beyond [`MAX_CONTRAST`](crate::MAX_CONTRAST); [`Error::NoSolution`] if no contact
    /// lengths were found that satisfy the Signorini conditions (no tension, no penetration); [`Error::Contact`] for loads at several places (x, y) on a stack with receding interfaces.
    pub fn press_with(
        &self,
        top: impl Into<Top>,
        force: impl Into<Force>,
        options: &Options,
    ) -> Result<Solution, Error> {
        let top = &top.into();
        let force = force.into().checked()?;
        options.check()?;
        if let Some(material) = top.material() {
            self.stack.check_punch(&material)?;
        }
        if let Some(cover) = top.punch().and_then(Punch::cover) {
            let second = Stack::of_second(self.stack.geometry(), cover)?;
            if self.stack.second().is_none_or(|own| own.key() != second.key()) {
                return Err(ContactError::NotUnderCover.into());
            }
        }
        if force == Force::Given(0.0) {
            let (load, small) = self.next_to_nothing(top).ok_or(ContactError::NoForce)?;
            let mut solution = self.press_with(load, small, options)?;
            solution.force = 0.0;
            (solution.contacts[0].resultant, solution.contacts[0].central_pressure) = (0.0, 0.0);
            return Ok(solution);
        }
        let asked = self.asked(top, options);
        asked.is_solvable()?;
        if let Some((loads, axes)) = top.loads().and_then(|loads| Some((loads, loads.axes()?))) {
            return self.superpose((loads, axes), force, options);
        }
        // given loads alone ask for no contact
        let is_known = top.loads().is_some() && self.kernel.contacts() == 1;
        let sinks = |(pressed, _): (&Pressed, f64)| matches!(pressed.pressed_by(), Force::ForDepth(_));
        match force {
            Force::ForDepth(_) => approach::defined(top, self.solved()).map(|_| ())?,
            Force::OfEach if top.punches().is_some_and(|punches| punches.parts().any(sinks)) => {
                approach::punches(top, self.solved()).map(|_| ())?;
            }
            _ => {}
        }
        let press = |tolerance: f64, force: Force| contact::press(&Asked { tolerance, ..asked }, force);
        let solution = match self.curves.as_ref().filter(|_| !is_known) {
            Some(curves) => curves.press(top, options.tolerance, force, press),
            None => press(options.tolerance, force),
        };
        self.with_closed((top, force), options, solution)
    }

    /// A load that is nothing to weights on all interfaces, with its force, where none is given; `None` if weights do not press all layers together, or under a punch.
    fn next_to_nothing(&self, top: &Top) -> Option<(Load, f64)> {
        let (_, weights) = self.closed.as_ref().filter(|_| top.loads().is_some() && self.stack.loose() == 0)?;
        let pressure = weights.interfaces.iter().map(|(_, pressure)| *pressure).fold(f64::INFINITY, f64::min);
        let thickness = self.stack.total_thickness();
        Some((Load::uniform(thickness).ok()?, NOTHING * pressure * thickness))
    }

    /// Presses loads about axes of their own, each alone: where no contact is to be found, what they do is added up.
    fn superpose(
        &self,
        (loads, axes): (&Loads, Vec<[f64; 2]>),
        force: Force,
        options: &Options,
    ) -> Result<Solution, Error> {
        if let Some(interface) = self.stack.contacts().get(1) {
            return Err(ContactError::NotSuperposed { interface: *interface }.into());
        }
        let own = |share: f64| match force {
            Force::Given(_) | Force::OfEach => Force::Given(share * force.given().unwrap_or_else(|| loads.force())),
            other => other,
        };
        let press = |(load, _, share): (&Load, f64, f64)| self.press_with(load.clone(), own(share), options);
        let mut all = loads.parts().map(press).collect::<Result<Vec<_>, _>>()?;
        let force = all.iter().map(Solution::force).sum();
        let contacts = all.iter().flat_map(|found| found.contacts.clone()).collect();
        let last = all.pop().ok_or(NoSolution::NotConverged)?;
        Ok(Solution { contacts, axes, force, ..last })
    }

    /// The stack whose field a solution has: where layers come apart, the one with all its laminates.
    fn stack_of(&self, solution: &Solution) -> &Stack {
        if self.check_closed(solution).is_ok() { self.solved() } else { &self.stack }
    }

    /// The stack that is solved for: interfaces that weights press together are closed.
    fn solved(&self) -> &Stack {
        self.closed.as_ref().map_or(&self.stack, |(closed, _)| closed)
    }

    /// The question for the solver, without the force.
    fn asked<'a>(&'a self, top: &'a Top, options: &Options) -> Asked<'a> {
        Asked {
            stack: &self.key,
            kernel: &self.kernel,
            interfaces: &self.interfaces,
            top,
            gaps: &self.gaps.0,
            weights: &[],
            by_dents: &[],
            hollow: self.closed.as_ref().and_then(|(_, weights)| weights.hollow.as_ref()),
            tolerance: options.tolerance,
            laminates: None,
        }
    }

    /// Checks a solution of this model by collocation, which shares no discretisation with the solver: for each contact the gap that is left where the
    /// bodies are said to touch, and by how much the pressures have to change to close it. Pressures that are given are not checked.
    ///
    /// ```
    /// use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
    /// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
    /// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// let (model, punch) = (Model::new(stack)?, Punch::cylinder(500.0)?);
    /// let solution = model.press(&punch, 0.002)?;
    /// for contact in model.collocate(&punch, &solution)? {
    ///     assert!(contact.residual < 1e-10 && contact.pressure_difference < 1e-9);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Contact`] if a contact is a ring about an axis; [`Error::Field`] if the solution is one of another stack, or the fields cannot be computed.
    pub fn collocate(&self, top: impl Into<Top>, solution: &Solution) -> Result<Vec<Collocated>, Error> {
        self.check_closed(solution)?;
        if !solution.axes().is_empty() {
            return Ok(Vec::new());
        }
        let top = top.into();
        let kernel = self.asked(&top, &Options::default()).kernel_under(solution.force()).into_owned();
        collocation::check(&top, self.solved(), &kernel, solution)
    }

    /// The unknowns and rows of the contact equations that a solution of this model solves; none where all pressures are given.
    ///
    /// # Errors
    /// [`Error::Field`] if the solution is one of another stack; [`Error::NoSolution`] if it is of low accuracy, since the contact equations were not solved then.
    pub fn ledger(&self, top: impl Into<Top>, solution: &Solution) -> Result<Ledger, Error> {
        self.check_owns(solution)?;
        if !solution.axes().is_empty() {
            return Ok(Ledger { unknowns: Vec::new(), rows: Vec::new() });
        }
        let (top, interfaces) = (top.into(), self.stack.contacts());
        let asked = self.asked(&top, &Options::default());
        let weights = self.closed.as_ref().filter(|_| self.check_closed(solution).is_err());
        let ledger = match weights {
            Some((_, weights)) if solution.force() == 0.0 => {
                let (load, small) = self.next_to_nothing(asked.top).ok_or(ContactError::NoForce)?;
                let (top, solution) = (load.into(), Solution { force: small, ..solution.clone() });
                let asked = Asked { top: &top, ..asked };
                contact::ledger(&Self::with_weights(&asked, weights, &interfaces), &solution)
            }
            Some((_, weights)) => contact::ledger(&Self::with_weights(&asked, weights, &interfaces), solution),
            None => contact::ledger(&asked, solution),
        };
        ledger.ok_or_else(|| NoSolution::NotConverged.into())
    }

    /// Refuses a solution of another stack, and one with openings, or with dents that weights press flat.
    fn check_closed(&self, solution: &Solution) -> Result<(), FieldError> {
        self.check_owns(solution)?;
        let is_open = |own: &ClosedInterface| !own.openings.is_empty();
        let has_dents = self.closed.as_ref().is_some_and(|(_, weights)| weights.has_dents());
        if has_dents || solution.closed().iter().any(is_open) { Err(FieldError::Openings) } else { Ok(()) }
    }

    /// Refuses a solution of another stack.
    fn check_owns(&self, solution: &Solution) -> Result<(), FieldError> {
        if solution.stack.as_ref() == Some(&self.key) { Ok(()) } else { Err(FieldError::OtherStack) }
    }

    /// Stresses and displacements inside the stack, for a solution of this model or of another model of an equal stack.
    ///
    /// # Errors
    /// [`FieldError::OtherStack`] if the solution is one of another stack.
    pub fn field(&self, solution: &Solution) -> Result<Field, FieldError> {
        self.check_owns(solution)?;
        Ok(Field::new(self.stack_of(solution), solution))
    }

    /// Pressures and gaps of all contacts, displacements and slopes of all faces, at places along x, for a solution of this model.
    ///
    /// Gaps are right to about 1e-10 of the displacements of the faces.
    ///
    /// ```
    /// use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
    /// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
    /// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// let (model, punch) = (Model::new(stack)?, Punch::cylinder(500.0)?);
    /// let solution = model.press(&punch, 0.002)?;
    /// let end = solution.contacts()[1].reach();
    /// let profile = model.profile(&punch, &solution, &[0.9 * end, 1.1 * end])?;
    /// // the strip lifts off beyond the end of its contact
    /// let gap = profile.contacts[1].gap.as_ref().unwrap();
    /// assert!(gap[0] == 0.0 && gap[1] > 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`FieldError::OtherStack`] if the solution is one of another stack; others if the fields cannot be computed.
    pub fn profile(&self, top: impl Into<Top>, solution: &Solution, x: &[f64]) -> Result<FaceProfiles, FieldError> {
        self.check_owns(solution)?;
        profile::profile(&top.into(), self.stack_of(solution), solution, x)
    }

    /// How far the punch has sunk into the stack since it touched it first, and the stiffness dP/dδ, for a solution of this model.
    ///
    /// ```
    /// use recede::{ApproachError, HalfPlane, Model, Plane, Punch, Scene, Stack};
    /// let scene = Scene::from_ron("Scene(geometry: PlaneStrain, punch: Flat(half_width: 0.5), force: 0.01, stack: [
    ///     Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Bonded, Rigid])")?;
    /// let model = Model::new(scene.stack()?)?;
    /// let approach = model.approach(&scene.top, &model.press(&scene.top, scene.force)?)?;
    /// // under a flat punch the force is proportional to the approach
    /// assert!((approach.stiffness.value().unwrap() * approach.value / 0.01 - 1.0).abs() < 1e-9);
    ///
    /// let half_plane = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
    /// let solution = half_plane.press(&scene.top, 0.01)?;
    /// assert_eq!(half_plane.approach(&scene.top, &solution), Err(ApproachError::HalfPlane));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ApproachError::HalfPlane`], [`ApproachError::ElasticPunch`] or [`ApproachError::Load`] where no approach is defined; [`ApproachError::Punches`] for
    /// several punches;
    /// [`ApproachError::Field`] if the solution is one of another stack, or the displacement cannot be computed.
    pub fn approach(&self, top: impl Into<Top>, solution: &Solution) -> Result<Approach, ApproachError> {
        let top = &top.into();
        approach::defined(top, self.solved())?;
        self.approaches(top, solution).swap_remove(0)
    }

    /// The approach of each punch, from left to right, also of punches that are several, turned or not at x = 0: how far its tip has moved down since the
    /// punch, not turned, touched the top face with its lowest point. Stiffnesses are derivatives while the forces on other punches stay as they are.
    /// Where there is none for all punches, one entry says why.
    ///
    /// ```
    /// use recede::{Model, Scene};
    /// let scene = Scene::from_ron("Scene(geometry: PlaneStrain, punches: [
    ///     (shape: Parabola(radius: 100), at: -1, force: 0.001), (shape: Parabola(radius: 100), at: 1, force: 0.001)],
    ///     stack: [Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Bonded, Rigid])")?;
    /// let model = Model::new(scene.stack()?)?;
    /// let solution = model.press(&scene.top, scene.force)?;
    /// let [left, right] = &model.approaches(&scene.top, &solution)[..] else { unreachable!() };
    /// let [left, right] = [left.clone()?.value, right.clone()?.value];
    /// assert!(left > 0.0 && (left / right - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn approaches(&self, top: impl Into<Top>, solution: &Solution) -> Vec<Result<Approach, ApproachError>> {
        if let Err(error) = self.check_owns(solution) {
            return vec![Err(error.into())];
        }
        let (top, interfaces) = (top.into(), self.stack.contacts());
        let asked = self.asked(&top, &Options::default());
        let weights = self.closed.as_ref().filter(|_| self.check_closed(solution).is_err());
        match weights {
            Some((_, weights)) => {
                approach::of_each(&Self::with_weights(&asked, weights, &interfaces), self.solved(), solution)
            }
            None => approach::of_each(&asked, self.solved(), solution),
        }
    }
}

impl Scene {
    /// The checked structure of the scene's stack.
    ///
    /// # Errors
    /// As [`Stack::from_items`], with line and column if the scene was read from a text.
    pub fn stack(&self) -> Result<Stack, Error> {
        let stack = Stack::from_items_under(self.geometry, self.pressure_on_top, &self.stack);
        let stack = match self.top.punch().and_then(Punch::cover) {
            Some(cover) => stack.and_then(|stack| stack.under(Stack::of_second(self.geometry, cover)?)),
            None => stack,
        };
        stack.map_err(|error| self.locate(error.into()))
    }
}

/// Solves a scene to ten digits.
///
/// ```
/// let text = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [
///     HalfPlane(shear_modulus: 1, poisson: 0.25)])";
/// let solution = recede::solve(&recede::Scene::from_ron(text)?)?;
/// let hertz = (500.0 * 0.002 * 3.0 / (2.0 * std::f64::consts::PI)).sqrt();
/// assert!((solution.contacts()[0].reach() / hertz - 1.0).abs() < 1e-12);
/// # Ok::<(), recede::Error>(())
/// ```
///
/// # Errors
/// As [`Scene::stack`], [`Model::new`] and [`Model::press`].
pub fn solve(scene: &Scene) -> Result<Solution, Error> {
    Model::new(scene.stack()?).and_then(|model| model.press(&scene.top, scene.force)).map_err(|e| scene.locate(e))
}

#[cfg(test)]
mod tests {
    use recede_layers::{HalfPlane, Homogeneous, Plane};

    use super::*;
    use crate::scene::Punch;

    #[test]
    fn a_field_is_that_of_a_solution_of_the_same_stack() {
        let model = |thicknesses: &[f64], modulus: f64| {
            let layers = thicknesses.iter().fold(Stack::builder(Plane::Strain), |stack, thickness| {
                stack.layer(Homogeneous::new(*thickness, modulus, 0.25).unwrap()).receding()
            });
            Model::new(layers.layer(HalfPlane::new(1.0, 0.25).unwrap()).build().unwrap()).unwrap()
        };
        let press = |model: &Model| model.press(Punch::parabola(500.0).unwrap(), 2e-3).unwrap();
        let own = model(&[1.0, 1.0], 1.0);
        for other in [model(&[], 1.0), model(&[1.0], 1.0), model(&[1.0, 1.0], 2.0), model(&[1.0, 1.5], 1.0)] {
            for (model, solution) in [(&own, press(&other)), (&other, press(&own))] {
                assert!(matches!(model.field(&solution), Err(FieldError::OtherStack)));
            }
        }
        let rebuilt = model(&[1.0, 1.0], 1.0).for_many_loads();
        assert_eq!(
            rebuilt.field(&press(&own)).unwrap().at(0.3, 0.5).unwrap(),
            own.field(&press(&own)).unwrap().at(0.3, 0.5).unwrap()
        );
    }

    #[test]
    fn couplings_that_vanish_do_not_matter() {
        let strip = |thickness, modulus| Homogeneous::new(thickness, modulus, 0.25).unwrap();
        let ground = HalfPlane::new(1.0, 0.25).unwrap();
        let stack = Stack::builder(Plane::Strain).layer(strip(1.0, 1.0)).receding().layer(strip(20.0, 3.0));
        let model = Model::new(stack.receding().layer(ground).build().unwrap()).unwrap();
        let all = Model { kernel: model.kernel.with_all_couplings(), ..model.clone() };
        assert!(model.kernel.stats().uncoupled > 0);
        assert_eq!(all.kernel.stats().uncoupled, 0);
        let [found, expected] = [&model, &all].map(|model| model.press(Punch::parabola(500.0).unwrap(), 2e-3).unwrap());
        for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
            assert!((found.innermost().right / expected.innermost().right - 1.0).abs() < 1e-12);
            assert!((found.central_pressure / expected.central_pressure - 1.0).abs() < 1e-12);
        }
    }
}
