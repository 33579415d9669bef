//! Refinement levels, error estimates, and the signs of pressures and gaps.
pub(crate) mod admissible;
pub(crate) mod estimate;
pub(crate) mod levels;
