//! The contact problem: what presses, what is closed, and where.
pub(crate) mod load;
pub(crate) mod modes;
pub(crate) mod profile;
pub(crate) mod support;
