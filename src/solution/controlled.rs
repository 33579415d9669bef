//! What is prescribed in place of a force.
use std::fmt;

/// What is prescribed in place of a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Controlled {
    /// The half-length of the contact under the punch.
    HalfLength,
    /// The approach of the punch: how far it sinks.
    Approach,
    /// The left end of the contact under one of several punches.
    Left,
    /// The right end.
    Right,
}

impl Controlled {
    /// The name of the field of a scene that says it.
    pub(crate) fn field(self) -> &'static str {
        match self {
            Self::HalfLength => "half_length",
            Self::Approach => "depth",
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

impl fmt::Display for Controlled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::HalfLength => "`half_length` of the contact under the punch",
            Self::Approach => "approach of the punch",
            Self::Left => "left end of the contact under the punch",
            Self::Right => "right end of the contact under the punch",
        })
    }
}
