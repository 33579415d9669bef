//! The contact equations at given ends, and their solution with the resultants eliminated.
pub(crate) mod assemble;
pub(crate) mod condensed;
mod edges;
