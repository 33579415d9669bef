//! Intervals with next to no force, far out, that are left out.
use crate::contact::problem::Problem;
use crate::kernel::Kernel;
use crate::solution::{Warning, WarningCode};

/// Penetration outside a contact so small that a force next to nothing, in an interval of re-contact, would remove it.
pub(super) struct Recontact {
    pub(super) contact: usize,
    /// Where, in units of L.
    pub(super) x: f64,
    /// The moment of that force about the end of the contact, over force times half-length.
    pub(super) moment: f64,
    /// The laminate that bends there, between this contact and the next.
    pub(super) laminate: usize,
}

impl Recontact {
    /// By how much the ends of the contacts of the laminate may move because of it, relative. A pressure that grows like the root of the
    /// distance d from its end has a moment like d^(5/2): hence the power 2/5.
    pub(super) fn moves(&self) -> f64 {
        self.moment.powf(0.4)
    }

    /// What is to be said of an interval that is left out.
    pub(super) fn warning(&self, problem: &Problem) -> Warning {
        let message = format!(
            "the bodies at the contact {} are in contact again about {:.3e} from the middle; the force there, with {:.0e} of the moment \
             of the total force, is left out",
            problem.interfaces[self.contact],
            self.x * problem.kernel.length(),
            self.moment
        );
        Warning::new(WarningCode::RecontactLeftOut, message)
    }
}

/// The moment that would remove the penetration outside contact i: the more slender of the laminates above and below is a beam there,
/// clamped where its contacts end (3EI/l³ per unit deflection). `None` without a laminate, or if there is penetration of more than
/// `allowed` before.
pub(super) fn recontact(
    kernel: &Kernel,
    i: usize,
    half_lengths: &[f64],
    gaps: &[(f64, f64)],
    allowed: f64,
) -> Option<Recontact> {
    let laminates = kernel.laminates();
    let neighbours = i.checked_sub(1).into_iter().chain([i]).filter(|laminate| *laminate < laminates.len());
    let laminate = neighbours.min_by(|a, b| laminates[*a].1.total_cmp(&laminates[*b].1))?;
    let (thickness, stiffness) = laminates[laminate];
    let end = half_lengths[laminate].max(half_lengths[laminate + 1]);
    if gaps.iter().any(|(x, gap)| *x <= end && *gap < -allowed) {
        return None;
    }
    let moment = |(x, gap): &(f64, f64)| {
        // no beam is shorter than thick
        let length = (x - end).max(thickness);
        (*x, 3.0 * stiffness * (-gap).max(0.0) / (length * length * end))
    };
    let (x, moment) = gaps.iter().map(moment).max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(Recontact { contact: i, x, moment, laminate })
}
