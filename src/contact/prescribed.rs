//! What is prescribed of punches in place of their forces, which are unknowns of the contact equations then.
use std::borrow::Cow;

use crate::contact::error::{ContactError, NoSolution};
use crate::contact::problem::{Prescribed, Problem};
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::scene::{Force, Pressed, Top};
use crate::solution::Controlled;

/// The force that is given, or the one that is expected to bring about what is prescribed.
pub(super) struct Drive<'a> {
    /// In the unit of the scene.
    pub(super) force: f64,
    /// What presses, with the forces that are expected of punches.
    pub(super) top: Cow<'a, Top>,
    /// What is prescribed, and how large in length.
    prescribed: Option<(Controlled, f64)>,
    /// The punch as it is written in a scene.
    punch: String,
    /// Half-lengths between which the contact under the punch ends, if a half-length is prescribed.
    between: [Option<f64>; 2],
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
        let (between, is_small, borrowed) = ([None; 2], false, Cow::Borrowed(top));
        let given = |force: f64, top: Cow<'a, Top>| Self {
            force,
            top,
            prescribed: None,
            punch: String::new(),
            between,
            is_small,
        };
        let each = top.punches().filter(|punches| punches.are_prescribed());
        let (controlled, wanted) = match (force, each) {
            (Force::OfEach, None) => return Ok(given(top.force(), borrowed)),
            (Force::OfEach, Some(punches)) => {
                let forces = punches.parts().map(|(pressed, _)| expected(kernel, pressed));
                let top = Top::from(punches.with_forces(forces.collect::<Result<Vec<f64>, _>>()?.into_iter()));
                return Ok(given(top.force(), Cow::Owned(top)));
            }
            (_, Some(_)) | (Force::ForLeft(_) | Force::ForRight(_), None) => return Err(ContactError::UnevenPunch),
            (Force::Given(force), None) => return Ok(given(force, borrowed)),
            (Force::ForHalfLength(wanted), None) => (Controlled::HalfLength, wanted),
            (Force::ForDepth(wanted), None) => (Controlled::Approach, wanted),
        };
        let only_force =
            if top.loads().is_some() { ContactError::LoadControlled(controlled) } else { ContactError::UnevenPunch };
        let punch = top.even_punch().ok_or(only_force)?;
        let (prescribed, label) = (Some((controlled, wanted)), punch.label(kernel.geometry()));
        let mut drive = Self { prescribed, punch: label, ..given(0.0, borrowed) };
        match controlled {
            Controlled::HalfLength => {
                drive.force = formulas::force_for_half_length(kernel, punch, wanted);
                drive.between = [Some(punch.shape().flat()), punch.max_half_length()];
                let [above, below] = drive.between;
                drive.is_small =
                    above.is_some_and(|above| wanted <= above) || below.is_some_and(|below| wanted >= below);
            }
            _ => (drive.force, drive.is_small) = formulas::force_for_depth(kernel, punch, wanted),
        }
        let is_reached = drive.force.is_normal() && !(drive.is_small && controlled == Controlled::HalfLength);
        if is_reached { Ok(drive) } else { Err(drive.unmet(NoSolution::NotConverged.into())) }
    }

    /// The problem that finds the force of a problem with a given one.
    pub(super) fn of<'b>(&self, problem: Problem<'b>) -> Problem<'b> {
        let length = problem.kernel.length();
        let Some((controlled, wanted)) = self.prescribed else { return problem };
        let prescribed = match controlled {
            Controlled::Approach => Prescribed::Depth(wanted / (length * problem.force)),
            _ => Prescribed::End { side: 1.0, at: wanted / length },
        };
        Problem { prescribed: vec![(0, prescribed)], ..problem }
    }

    /// What an error means for what is prescribed.
    pub(super) fn unmet(&self, error: ContactError) -> ContactError {
        let (Some((controlled, wanted)), ContactError::NoSolution(cause)) = (self.prescribed, &error) else {
            return error;
        };
        let (punch, [above, below]) = (self.punch.clone(), self.between);
        if self.is_small || matches!(cause, NoSolution::PunchTooSmall { .. }) {
            return NoSolution::Unreachable { controlled, punch, wanted, below, above }.into();
        }
        NoSolution::ForceNotFound { controlled, punch, wanted, cause: Box::new(cause.clone()) }.into()
    }
}

/// The force, in the unit of the scene, that one of several punches is expected to have, as by itself.
fn expected(kernel: &Kernel, pressed: &Pressed) -> Result<f64, ContactError> {
    let (shape, at) = (pressed.shape(), pressed.at());
    let ([left, right], flat) = (shape.shape().ends(), shape.shape().flat());
    let (controlled, wanted, between) = match pressed.pressed_by() {
        Force::ForDepth(depth) => (Controlled::Approach, depth, [0.0, f64::INFINITY]),
        Force::ForLeft(place) => (Controlled::Left, place, [at + left, at - flat]),
        Force::ForRight(place) => (Controlled::Right, place, [at + flat, at + right]),
        _ => return Ok(pressed.force()),
    };
    let force = match controlled {
        Controlled::Approach => formulas::force_for_depth(kernel, shape, wanted).0,
        _ => formulas::force_for_half_length(kernel, shape, (wanted - at).abs()),
    };
    let is_inside = between[0] < wanted && wanted < between[1];
    if is_inside && force.is_normal() && force > 0.0 {
        return Ok(force);
    }
    let [above, below] = between.map(|end| Some(end).filter(|end| end.is_finite()));
    Err(NoSolution::Unreachable { controlled, punch: shape.label(kernel.geometry()), wanted, below, above }.into())
}
