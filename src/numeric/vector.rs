//! Loops compiled for the vector instructions that the processor turns out to have.

/// Numbers that loops take together: as many doubles as the widest vectors have.
pub(crate) const LANES: usize = 8;
/// Numbers that are taken together.
pub(crate) type Lanes = [f64; LANES];

/// Runs `work`, a closure marked `#[inline(always)]` like all that it calls, with the widest vector instructions there are.
///
/// No product and sum are fused, so that results are the same on all processors.
#[inline(always)]
pub(crate) fn vectorised<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}
