//! What is prescribed of punches in place of their forces, which are unknowns of the contact equations then.
use std::borrow::Cow;

use crate::contact::error::{ContactError, NoSolution};
use crate::contact::problem::{Prescribed, Problem};
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::scene::{Force, Pressed, Punch, Top};
use crate::solution::Controlled;

/// The force that is given, or the one that is expected to bring about what is prescribed.
pub(super) struct Drive<'a> {
    /// In the unit of the scene.
    pub(super) force: f64,
    /// What presses, with the forces that are expected of several punches.
    pub(super) top: Cow<'a, Top>,
    /// What is prescribed of the only punch beside it.
    prescribed: Option<Wanted>,
}

/// What is prescribed of one punch, in length.
struct Wanted {
    controlled: Controlled,
    value: f64,
    /// Values between which those are that a force brings about; infinite where there is no limit.
    between: [f64; 2],
    /// The punch as it is written in a scene.
    punch: String,
    /// The force that is expected, in the unit of the scene.
    force: f64,
    /// Whether the punch is expected to be too small.
    is_small: bool,
}

impl<'a> Drive<'a> {
    /// From the kernel with what an elastic punch adds to it.
    ///
    /// # Errors
    /// [`NoSolution::Unreachable`] if no force brings about what is prescribed, [`ContactError::LoadControlled`] and [`ContactError::UnevenPunch`] if nothing but the force
    /// can be prescribed.
    pub(super) fn new(top: &'a Top, kernel: &Kernel, force: Force) -> Result<Self, ContactError> {
        let given = |force: f64, top: Cow<'a, Top>| Ok(Self { force, top, prescribed: None });
        let each = top.punches().filter(|punches| punches.are_prescribed());
        let only_force = match (force, each) {
            (Force::OfEach, None) => return given(top.force(), Cow::Borrowed(top)),
            (Force::OfEach, Some(punches)) => {
                let expected = |(pressed, _): (&Pressed, f64)| {
                    let wanted = Wanted::new(kernel, pressed.shape(), pressed.at(), pressed.pressed_by());
                    wanted.map_or(Ok(pressed.force()), |wanted| Ok(wanted.reached()?.force))
                };
                let forces = punches.parts().map(expected).collect::<Result<Vec<f64>, ContactError>>()?;
                let top = Top::from(punches.with_forces(forces.into_iter()));
                return given(top.force(), Cow::Owned(top));
            }
            (Force::Given(force), None) => return given(force, Cow::Borrowed(top)),
            (Force::ForHalfLength(_), None) if top.loads().is_some() => {
                ContactError::LoadControlled(Controlled::HalfLength)
            }
            (Force::ForDepth(_), None) if top.loads().is_some() => ContactError::LoadControlled(Controlled::Approach),
            (Force::ForHalfLength(_) | Force::ForDepth(_), None) => ContactError::UnevenPunch,
            (_, Some(_)) | (Force::ForLeft(_) | Force::ForRight(_), None) => return Err(ContactError::UnevenPunch),
        };
        let punch = top.even_punch().ok_or(only_force)?;
        let prescribed = Wanted::new(kernel, punch, 0.0, force).map(Wanted::reached).transpose()?;
        let force = prescribed.as_ref().map_or(0.0, |wanted| wanted.force);
        Ok(Self { force, top: Cow::Borrowed(top), prescribed })
    }

    /// The problem that finds the force of a problem with a given one.
    pub(super) fn of<'b>(&self, problem: Problem<'b>) -> Problem<'b> {
        let length = problem.kernel.length();
        let Some(Wanted { controlled, value, .. }) = &self.prescribed else { return problem };
        let prescribed = match controlled {
            Controlled::Approach => Prescribed::Depth(value / (length * problem.force)),
            _ => Prescribed::End { side: 1.0, at: value / length },
        };
        Problem { prescribed: vec![(0, prescribed)], ..problem }
    }

    /// What an error means for what is prescribed.
    pub(super) fn unmet(&self, error: ContactError) -> ContactError {
        let (Some(wanted), ContactError::NoSolution(cause)) = (&self.prescribed, &error) else { return error };
        if wanted.is_small || matches!(cause, NoSolution::PunchTooSmall { .. }) {
            return wanted.unreachable();
        }
        let Wanted { controlled, value, punch, .. } = wanted;
        let (punch, cause) = (punch.clone(), Box::new(cause.clone()));
        NoSolution::ForceNotFound { controlled: *controlled, punch, wanted: *value, cause }.into()
    }
}

impl Wanted {
    /// What is prescribed of a punch with its tip at a place, as if it pressed by itself; nothing if that is a force.
    fn new(kernel: &Kernel, punch: &Punch, at: f64, force: Force) -> Option<Self> {
        let ([left, right], flat) = (punch.shape().ends(), punch.shape().flat());
        let (controlled, value, between) = match force {
            Force::Given(_) | Force::OfEach => return None,
            Force::ForDepth(depth) => (Controlled::Approach, depth, [f64::NEG_INFINITY, f64::INFINITY]),
            Force::ForHalfLength(half) => (Controlled::HalfLength, half, [flat, right]),
            Force::ForLeft(place) => (Controlled::Left, place, [at + left, at - flat]),
            Force::ForRight(place) => (Controlled::Right, place, [at + flat, at + right]),
        };
        let (force, is_small) = match controlled {
            Controlled::Approach => formulas::force_for_depth(kernel, punch, value),
            _ => (formulas::force_for_half_length(kernel, punch, (value - at).abs()), false),
        };
        Some(Self { controlled, value, between, punch: punch.label(kernel.geometry()), force, is_small })
    }

    /// Itself, if a force is expected to bring it about.
    fn reached(self) -> Result<Self, ContactError> {
        let [above, below] = self.between;
        let is_inside = above < self.value && self.value < below;
        if is_inside && self.force.is_normal() && self.force > 0.0 { Ok(self) } else { Err(self.unreachable()) }
    }

    fn unreachable(&self) -> ContactError {
        let [above, below] = self.between.map(|end| Some(end).filter(|end| end.is_finite()));
        let (controlled, punch, wanted) = (self.controlled, self.punch.clone(), self.value);
        NoSolution::Unreachable { controlled, punch, wanted, below, above }.into()
    }
}
