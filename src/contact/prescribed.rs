//! What is prescribed of a punch in place of its force, which is an unknown of the contact equations then.
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::problem::{Prescribed, Problem};
use crate::contact::starts::formulas;
use crate::geometry::Geometry;
use crate::kernel::Kernel;
use crate::scene::{Force, Punch, Top};
use crate::solution::Controlled;

/// The force that is given, or the one that is expected to bring about what is prescribed.
pub(super) struct Drive<'a> {
    /// In the unit of the scene.
    pub(super) force: f64,
    prescribed: Option<Wanted<'a>>,
}

/// What is prescribed, in length.
struct Wanted<'a> {
    controlled: Controlled,
    wanted: f64,
    punch: &'a Punch,
    geometry: Geometry,
    /// Whether the punch is expected to be large enough.
    fits: bool,
}

impl<'a> Drive<'a> {
    /// From the kernel with what an elastic punch adds to it.
    ///
    /// # Errors
    /// [`NoSolution::Unreachable`] if no force brings about what is prescribed, [`ContactError::LoadControlled`] and [`ContactError::UnevenPunch`] if nothing but the force
    /// can be prescribed.
    pub(super) fn new(top: &'a Top, kernel: &Kernel, force: Force) -> Result<Self, ContactError> {
        let (controlled, wanted) = match force {
            Force::Given(force) => return Ok(Self { force, prescribed: None }),
            Force::ForHalfLength(wanted) => (Controlled::HalfLength, wanted),
            Force::ForDepth(wanted) => (Controlled::Approach, wanted),
        };
        let only_force =
            if top.loads().is_some() { ContactError::LoadControlled(controlled) } else { ContactError::UnevenPunch };
        let punch = top.even_punch().ok_or(only_force)?;
        let (force, fits) = match controlled {
            Controlled::HalfLength => (formulas::force_for_half_length(kernel, punch, wanted), true),
            Controlled::Approach => formulas::force_for_depth(kernel, punch, wanted),
        };
        let own = Wanted { controlled, wanted, punch, geometry: kernel.geometry(), fits };
        let [above, below] = own.reachable();
        if above.is_some_and(|above| wanted <= above) || below.is_some_and(|below| wanted >= below) {
            return Err(own.unreachable());
        }
        if force.is_normal() {
            Ok(Self { force, prescribed: Some(own) })
        } else {
            Err(own.unmet(NoSolution::NotConverged))
        }
    }

    /// The problem that finds the force of a problem with a given one.
    pub(super) fn of<'b>(&self, problem: Problem<'b>) -> Problem<'b> {
        let length = problem.kernel.length();
        let prescribed = self.prescribed.as_ref().map(|own| match own.controlled {
            Controlled::HalfLength => Prescribed::HalfLength(own.wanted / length),
            Controlled::Approach => Prescribed::Depth(own.wanted / (length * problem.force)),
        });
        Problem { prescribed, ..problem }
    }

    /// What an error means for what is prescribed.
    pub(super) fn unmet(&self, error: ContactError) -> ContactError {
        match (&self.prescribed, error) {
            (Some(own), ContactError::NoSolution(cause)) => own.unmet(cause),
            (_, error) => error,
        }
    }
}

impl Wanted<'_> {
    /// Half-lengths between which the contact under the punch ends, if a half-length is prescribed.
    fn reachable(&self) -> [Option<f64>; 2] {
        match self.controlled {
            Controlled::HalfLength => [Some(self.punch.shape().flat()), self.punch.max_half_length()],
            Controlled::Approach => [None; 2],
        }
    }

    /// The error that no force brings it about.
    fn unreachable(&self) -> ContactError {
        let (Self { controlled, wanted, .. }, [above, below]) = (self, self.reachable());
        let (controlled, wanted, punch) = (*controlled, *wanted, self.punch.label(self.geometry));
        NoSolution::Unreachable { controlled, punch, wanted, below, above }.into()
    }

    /// What it means for it that there is no solution.
    fn unmet(&self, cause: NoSolution) -> ContactError {
        if !self.fits || matches!(cause, NoSolution::PunchTooSmall { .. }) {
            return self.unreachable();
        }
        let Self { controlled, wanted, .. } = self;
        let (controlled, wanted) = (*controlled, *wanted);
        let (punch, cause) = (self.punch.label(self.geometry), Box::new(cause));
        NoSolution::ForceNotFound { controlled, punch, wanted, cause }.into()
    }
}
