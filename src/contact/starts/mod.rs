//! Where Newton's method starts, and in which order starts are tried.
pub(crate) mod formulas;
pub(crate) mod order;
