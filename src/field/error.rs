//! Errors of the computation of stresses and displacements.
use crate::system::Unresolved;

/// Why stresses and displacements cannot be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FieldError {
    /// The layers' fields cannot be computed.
    #[error(transparent)]
    Unresolved(#[from] Unresolved),
    /// The field was requested at a point outside all layers.
    #[error("{place}: there is no layer; allowed is {allowed}")]
    Outside {
        /// Where.
        place: String,
        /// The depths of the layers.
        allowed: String,
    },
    /// The field was requested so far away, the farthest point at this distance from the middle, that it would take too many wavenumbers.
    #[error("a place {0:?} from the middle is too far from the contacts for the field to be computed there")]
    TooFar(f64),
    /// Places where stresses are largest were requested under loads at several places (x, y).
    #[error("loads press at several places (x, y): where stresses are largest is searched for about one axis only")]
    Superposed,
    /// A point with this y was requested of a field that has none.
    #[error("y = {0:?} is asked for; y other than 0 is for loads at several places (x, y) of an axisymmetric scene")]
    NoSpace(f64),
    /// A check by collocation was requested where layers that weights press together come apart.
    #[error("layers that weights press together come apart, and checks by collocation are not made then")]
    Openings,
    /// The field was requested for the solution of another stack.
    #[error("the solution is of another stack than the model: its pressures do not belong to these layers")]
    OtherStack,
}

impl FieldError {
    /// Whether the input is at fault.
    pub fn is_input(&self) -> bool {
        matches!(
            self,
            Self::Outside { .. }
                | Self::TooFar(_)
                | Self::Superposed
                | Self::NoSpace(_)
                | Self::Openings
                | Self::OtherStack
        )
    }

    /// What to do about it, if that can be said.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Unresolved(cause) => Some(cause.hint()),
            Self::OtherStack => {
                Some("ask the model that was pressed, or one of an equal stack, for the field".to_owned())
            }
            Self::Openings => Some("press with less than the critical force".to_owned()),
            Self::Superposed => Some("ask for points or grids: `recede field --at X,Y,DEPTH`, or `--y Y`".to_owned()),
            Self::NoSpace(_) => Some("write `loads: [(load: ..., at: (x, y), force: P), ...]`".to_owned()),
            Self::Outside { .. } | Self::TooFar(_) => None,
        }
    }
}
