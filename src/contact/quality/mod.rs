//! Refinement levels, error estimates, and the signs of pressures and gaps.
pub(crate) mod admissible;
pub(crate) mod answer;
pub(crate) mod estimates;
pub(crate) mod levels;
