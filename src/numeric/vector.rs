//! Loops compiled for the vector instructions that the processor turns out to have.

/// Runs `work` with the widest vector instructions there are. What it calls must be inlined to profit.
///
/// No product and sum are fused, so that results are the same on all processors.
#[inline(always)]
pub(crate) fn vectorised<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}
