//! The ends of the contacts: Newton's method, iterated Galerkin sweeps, and ends that nothing depends on.
pub(crate) mod broyden;
mod frozen;
pub(crate) mod newton;
mod sweeps;

use crate::contact::equations::condensed::Influences;
use crate::contact::problem::estimate::Estimate;
use crate::contact::problem::modes::Modes;
use crate::contact::problem::support::Support;
use crate::solution::Stopped;

/// What Newton's method has found with given numbers of modes, and all that tells how good it is.
pub(crate) struct Converged {
    pub(crate) support: Support,
    /// y_im of contact i, y_i0 = 1.
    pub(crate) modes: Modes,
    /// Modes solved for.
    pub(crate) solved: Vec<usize>,
    /// By how much the modes beyond those solved for changed the logarithms of the half-lengths.
    pub(crate) corrections: Vec<f64>,
    /// Whether all modes were solved for.
    pub(crate) fully_solved: Vec<bool>,
    /// The sweep residual: by how much further sweeps would change the logarithms of the half-lengths, and Σ y_m/order.
    pub(crate) residuals: Vec<Estimate>,
    pub(crate) influences: Influences,
    /// Why the sweeps ended.
    pub(crate) stopped: Stopped,
}
