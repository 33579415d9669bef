//! How far a half-length and a pressure may be from the truth.
use crate::numeric;

/// Errors of a contact, estimated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Estimate {
    /// Of the half-length.
    pub(crate) length: f64,
    /// Of the pressure at x = 0.
    pub(crate) pressure: f64,
}

impl Estimate {
    pub(crate) const fn new(length: f64, pressure: f64) -> Self {
        Self { length, pressure }
    }

    /// The same for both.
    pub(crate) const fn both(error: f64) -> Self {
        Self { length: error, pressure: error }
    }

    /// The larger of both; NaN if one of them is.
    pub(crate) fn worst(self) -> f64 {
        numeric::largest([self.length, self.pressure])
    }

    /// Whether neither error is larger than the same error of another answer.
    pub(crate) fn is_within(self, other: Self) -> bool {
        self.length <= other.length && self.pressure <= other.pressure
    }
}
