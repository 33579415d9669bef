//! What a solution has to fulfil, and how it is found.

/// What a solution has to fulfil, and how it is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Relative error allowed in half-lengths and in the pressures at x = 0, dimensionless, 1e-13 ..= 1e-2.
    pub tolerance: f64,
    /// Discretisation of the contact equations.
    pub method: Method,
}

/// Discretisation of the contact equations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Method {
    /// Sine series, tested with Chebyshev polynomials
    ///
    /// Integrals over the wavenumber: fast and exact.
    #[default]
    Galerkin,
    /// Pressures at nodes: slower, an independent check
    ///
    /// Slopes are compared at places between the nodes, and kernels are functions of the distance; next to graded faces it is less exact.
    /// The error estimate is the difference between the answers for two numbers of nodes.
    Collocation,
}

impl Default for Options {
    /// Ten digits, by the Galerkin method.
    fn default() -> Self {
        Self { tolerance: 1e-10, method: Method::default() }
    }
}

/// Why options say nothing that can be fulfilled.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum OptionsError {
    /// Collocation is for plane problems.
    #[error("method: found `collocation`, allowed in axisymmetric problems is `galerkin`")]
    CollocationIsPlane,
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
