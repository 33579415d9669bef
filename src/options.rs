//! What a solution has to fulfil.

/// What a solution has to fulfil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Relative error allowed in half-lengths and in the pressures at x = 0, dimensionless, 1e-13 ..= 1e-2.
    pub tolerance: f64,
}

impl Default for Options {
    /// Ten digits.
    fn default() -> Self {
        Self { tolerance: 1e-10 }
    }
}

/// Why options say nothing that can be fulfilled.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum OptionsError {
    /// A relative tolerance that double precision cannot reach, or that says nothing.
    #[error("tolerance: found {found:?}, allowed is 1e-13 <= tolerance <= 1e-2")]
    Tolerance {
        /// The tolerance asked for.
        found: f64,
    },
}

impl Options {
    /// Checks what a solution has to fulfil.
    pub(crate) fn check(&self) -> Result<(), OptionsError> {
        let found = self.tolerance;
        if (1e-13..=1e-2).contains(&found) { Ok(()) } else { Err(OptionsError::Tolerance { found }) }
    }
}
