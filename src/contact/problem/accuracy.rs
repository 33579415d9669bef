//! Numbers by which accuracy is judged, the same in all rooms.

/// What rounding leaves of a half-length, relative: kernels are resolved to this part of themselves. Newton's steps that are
/// shorter are none.
pub(crate) const ROUNDING: f64 = 1e-13;
/// Error estimates are this many times the difference they are made from, since neither the modes that are missing nor the next
/// refinement are known. Twice as much: all estimates are larger, and more modes are asked for.
pub(crate) const SAFETY: f64 = 3.0;
/// Smaller parts of what is wanted, in half-lengths, steps or tolerances, are left to chance: what is done about them changes no digit.
pub(crate) const MINOR: f64 = 0.01;
/// Relative accuracy of a coarse solution. First steps leave this much of half-lengths and of kernels; errors, sensitivities and forces
/// that are smaller do not decide whether an answer is accepted. Twice as much: nothing changes but rounding.
pub(crate) const COARSE: f64 = 1e-4;
/// Sweeps, and steps with kept derivatives, that change this much of what the one before changed do not end.
pub(crate) const SLOW: f64 = 0.5;
/// Steps without progress after which an iteration is given up: a step shorter than all before, or fewer violated inequalities. Of those
/// that converge one was seen to need 18, all others nine at most. Twice as many: scenes that are not solved take twice the time.
pub(crate) const PATIENCE: usize = 20;
/// Gaps are looked at in this many places next to a contact, and as many farther out.
pub(crate) const PLACES: usize = 24;
/// Multiplications at most, all starts together: some seconds. Twice as many: scenes that are not solved take twice the time.
pub(crate) const MOST_OPERATIONS: f64 = 1e11;
/// No answer is judged better than this.
pub(crate) const BEST: f64 = 5.0 * ROUNDING;
/// Ends with larger relative errors are not known.
pub(crate) const UNKNOWN: f64 = 0.03;
/// The relative error of the half-length of a decaying contact, no end of which is found.
pub(crate) const ENDLESS: f64 = 1.0;
