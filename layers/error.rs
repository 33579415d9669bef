//! Errors of this crate.

/// Why a layer could not be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LayerError {
    /// A number outside its range.
    #[error("{field}: {reason}")]
    Field {
        /// The field's name as in the scene file.
        field: &'static str,
        /// What was found and what is allowed.
        #[source]
        reason: crate::quantity::OutOfRange,
    },
    /// A graded layer whose modulus varies by more than double precision can carry.
    #[error("beta * thickness is {found:?}; allowed is |beta * thickness| <= {limit:?}")]
    TooSteep {
        /// The product of the grading exponent and the thickness, dimensionless.
        found: f64,
        /// The largest magnitude allowed.
        limit: f64,
    },
}

impl LayerError {
    /// The number given for `field` is out of its range.
    pub fn field(field: &'static str, reason: crate::quantity::OutOfRange) -> Self {
        Self::Field { field, reason }
    }

    /// Checks the number given for `field`.
    pub(crate) fn checked<Q: TryFrom<f64, Error = crate::quantity::OutOfRange>>(
        field: &'static str,
        value: f64,
    ) -> Result<Q, Self> {
        Q::try_from(value).map_err(|reason| Self::field(field, reason))
    }
}
