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
