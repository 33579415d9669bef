//! Where Newton's method starts, and in which order starting points are tried.
pub(crate) mod formulas;
pub(crate) mod order;
