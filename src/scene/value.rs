//! Why a punch, a load, a force or a spring cannot be made of some numbers.
use recede_layers::{LayerError, OutOfRange};

use super::HeightsError;

/// Most loads in a list.
pub(super) const MOST_LOADS: usize = 1000;

/// A list of loads that is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LoadsError {
    /// Too few or too many of them.
    #[error("there are {0} loads; allowed are 1 to {MOST_LOADS}")]
    Count(usize),
    /// Forces so large that their sum is not finite.
    #[error("the forces of the loads are together beyond the largest number")]
    Sum,
}

/// Why a punch, a load, a force or a spring cannot be made of some numbers.
///
/// ```
/// let error = recede::Punch::cylinder(-1.0).unwrap_err();
/// assert!(error.to_string().starts_with("radius: "));
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ValueError {
    /// A number is outside its range.
    #[error("{quantity}: {reason}")]
    OutOfRange {
        /// What the number is, as in a scene.
        quantity: &'static str,
        /// What was found and what is allowed.
        #[source]
        reason: OutOfRange,
    },
    /// Heights that do not describe a punch.
    #[error(transparent)]
    Heights(#[from] HeightsError),
    /// Elastic constants that make no material.
    #[error(transparent)]
    Material(#[from] LayerError),
    /// A list of loads that is none.
    #[error(transparent)]
    Loads(#[from] LoadsError),
}

impl ValueError {
    /// Checks the number given for `quantity`.
    pub(super) fn checked<Q: TryFrom<f64, Error = OutOfRange>>(quantity: &'static str, value: f64) -> Result<Q, Self> {
        Q::try_from(value).map_err(|reason| Self::OutOfRange { quantity, reason })
    }
}
