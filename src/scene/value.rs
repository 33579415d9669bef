//! Why a punch, a load, a force or a spring cannot be made of some numbers.
use recede_layers::{LayerError, OutOfRange};

use super::HeightsError;

/// Most loads, or punches, in a list.
const MOST_AT_ONCE: usize = 1000;

/// A list of loads or punches that is none. Punches have their numbers in the list, from 1 on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ListError {
    /// Too few or too many of them.
    #[error("there are {found} {what}; allowed are 1 to {MOST_AT_ONCE}")]
    Count {
        /// The word for the members, `loads` or `punches`.
        what: &'static str,
        /// How many there are.
        found: usize,
    },
    /// Forces so large that their sum is not finite.
    #[error("the forces of the {0} are together beyond the largest number")]
    Sum(&'static str),
    /// A punch of which none, or more than one, of a force, a depth, a left and a right end is given, and how many are.
    #[error("{0} of `force`, `depth`, `left` and `right` are given; each of several punches has exactly one of them")]
    Pressed(usize),
    /// The punch of this number is elastic, and stands beside others, away from x = 0, or is turned.
    #[error("punch {0} is elastic; allowed is an elastic punch alone, at x = 0 and without tilt")]
    Elastic(usize),
    /// A flat punch that would fall over.
    #[error(
        "the eccentricity of punch {number} is {eccentricity:?}; allowed is a number smaller in size than the half-width of the flat punch, \
         {half_width:?}: beyond its corner it would fall over"
    )]
    Eccentricity {
        /// Which punch.
        number: usize,
        /// The eccentricity of its force, in length.
        eccentricity: f64,
        /// Half-width of the punch, in length.
        half_width: f64,
    },
    /// Two punches, the flat parts or tips of which are not apart.
    #[error("punch {}, {}, and punch {}, {}, overlap", .numbers[0], .names[0], .numbers[1], .names[1])]
    Overlap {
        /// Which punches.
        numbers: [usize; 2],
        /// The shapes of the punches, and the places of their tips on x.
        names: [String; 2],
    },
}

impl ListError {
    /// The number of the punch that it is about, and the fields in which the mistake is, from the outermost on; `None` if it is about all of them.
    pub(super) fn place(&self) -> Option<(usize, &'static [&'static str])> {
        match self {
            Self::Count { .. } | Self::Sum(_) | Self::Pressed(_) => None,
            Self::Elastic(number) => Some((*number, &["shape"])),
            Self::Eccentricity { number, .. } => Some((*number, &["tilt", "eccentricity"])),
            Self::Overlap { numbers: [_, number], .. } => Some((*number, &["at"])),
        }
    }
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
        /// The name of the number, as in a scene.
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
    /// A list of loads or punches that is none.
    #[error(transparent)]
    List(#[from] ListError),
}

impl ValueError {
    /// Checks the number given for `quantity`.
    pub(super) fn checked<Q: TryFrom<f64, Error = OutOfRange>>(quantity: &'static str, value: f64) -> Result<Q, Self> {
        Q::try_from(value).map_err(|reason| Self::OutOfRange { quantity, reason })
    }
}

/// Checks how many loads or punches are in a list, and the sum of their forces.
pub(super) fn check_list(what: &'static str, found: usize, force: f64) -> Result<(), ListError> {
    match found {
        1..=MOST_AT_ONCE if force.is_finite() => Ok(()),
        1..=MOST_AT_ONCE => Err(ListError::Sum(what)),
        _ => Err(ListError::Count { what, found }),
    }
}
