//! What is prescribed of a punch in place of its force, which is an unknown of the contact equations then.
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::problem::{Prescribed, Problem};
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::scene::{Force, Top};
use crate::solution::Controlled;

/// The force that is given, or the one that is expected to bring about what is prescribed.
#[derive(Default)]
pub(super) struct Drive {
    /// In the unit of the scene.
    pub(super) force: f64,
    /// What is prescribed, and how large in length.
    prescribed: Option<(Controlled, f64)>,
    /// The punch as it is written in a scene.
    punch: String,
    /// Half-lengths between which the contact under the punch ends, if a half-length is prescribed.
    between: [Option<f64>; 2],
    /// Whether the punch is expected to be too small.
    is_small: bool,
}

impl Drive {
    /// From the kernel with what an elastic punch adds to it.
    ///
    /// # Errors
    /// [`NoSolution::Unreachable`] if no force brings about what is prescribed, [`ContactError::LoadControlled`] and [`ContactError::UnevenPunch`] if nothing but the force
    /// can be prescribed.
    pub(super) fn new(top: &Top, kernel: &Kernel, force: Force) -> Result<Self, ContactError> {
        let (controlled, wanted) = match force {
            Force::Given(force) => return Ok(Self { force, ..Self::default() }),
            Force::ForHalfLength(wanted) => (Controlled::HalfLength, wanted),
            Force::ForDepth(wanted) => (Controlled::Approach, wanted),
        };
        let only_force =
            if top.loads().is_some() { ContactError::LoadControlled(controlled) } else { ContactError::UnevenPunch };
        let punch = top.even_punch().ok_or(only_force)?;
        let (prescribed, label) = (Some((controlled, wanted)), punch.label(kernel.geometry()));
        let mut drive = Self { prescribed, punch: label, ..Self::default() };
        match controlled {
            Controlled::HalfLength => {
                drive.force = formulas::force_for_half_length(kernel, punch, wanted);
                drive.between = [Some(punch.shape().flat()), punch.max_half_length()];
                let [above, below] = drive.between;
                drive.is_small =
                    above.is_some_and(|above| wanted <= above) || below.is_some_and(|below| wanted >= below);
            }
            Controlled::Approach => (drive.force, drive.is_small) = formulas::force_for_depth(kernel, punch, wanted),
        }
        let is_reached = drive.force.is_normal() && !(drive.is_small && controlled == Controlled::HalfLength);
        if is_reached { Ok(drive) } else { Err(drive.unmet(NoSolution::NotConverged.into())) }
    }

    /// The problem that finds the force of a problem with a given one.
    pub(super) fn of<'b>(&self, problem: Problem<'b>) -> Problem<'b> {
        let length = problem.kernel.length();
        let prescribed = self.prescribed.map(|(controlled, wanted)| match controlled {
            Controlled::HalfLength => Prescribed::HalfLength(wanted / length),
            Controlled::Approach => Prescribed::Depth(wanted / (length * problem.force)),
        });
        Problem { prescribed, ..problem }
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
