//! What Newton's method has found with given numbers of modes, and all that tells how good it is.
use crate::contact::ends::frozen::Faded;
use crate::contact::equations::assemble::Rows;
use crate::contact::equations::condensed::Influences;
use crate::contact::integrals::layout::Layout;
use crate::contact::problem::modes::Modes;

/// Where Newton's method has come to.
pub(crate) struct Converged {
    /// Half-lengths in units of L.
    pub(crate) half_lengths: Vec<f64>,
    /// y_im of contact i, y_i0 = 1.
    pub(crate) modes: Modes,
    /// q, the amplitude of the pressure next to the corners of the punch, if it has any.
    pub(crate) corners: Option<f64>,
    /// Modes solved for.
    pub(crate) solved: Vec<usize>,
    /// By how much the modes beyond those solved for changed the logarithms of the half-lengths.
    pub(crate) shift: Vec<f64>,
    /// Whether all modes were solved for.
    pub(crate) whole: Vec<bool>,
    /// By how much further rounds would change the logarithms of the half-lengths, and Σ y_m/order.
    pub(crate) unsettled: Vec<[f64; 2]>,
    pub(crate) influences: Influences,
    /// What is known of the ends of contacts that fade.
    pub(crate) faded: Vec<Option<Faded>>,
    /// The last layout, and what the kernels make there of the pressures, almost.
    pub(crate) waves: Option<(Layout, Vec<Rows>)>,
}

impl Converged {
    /// A given pressure and no other contact.
    pub(crate) fn known(half_lengths: Vec<f64>) -> Self {
        Self {
            half_lengths,
            modes: vec![vec![1.0]],
            corners: None,
            solved: vec![1],
            shift: vec![0.0],
            whole: vec![false],
            unsettled: vec![[0.0; 2]],
            influences: Influences { rounding: vec![0.0], lengths: vec![vec![0.0]], peaks: vec![vec![0.0]] },
            faded: vec![None],
            waves: None,
        }
    }
}
