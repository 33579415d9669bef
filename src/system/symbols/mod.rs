//! The symbolic form: which conditions hold, between which layers, and which layers they hold together.
pub(super) mod components;
pub(super) mod conditions;
pub(super) mod matrix;
pub(super) mod names;
