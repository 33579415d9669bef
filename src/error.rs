//! Everything that can go wrong, in one type.
use recede_layers::{LayerError, OutOfRange};

use crate::options::Options;
use crate::scene::HeightsError;
use crate::scene::LoadsError;
use crate::scene::SceneError;
use crate::solution::Interface;
use crate::stack::StackError;
use crate::sweep::AxisError;

/// Why a scene could not be read or solved.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Error {
    /// The text of a scene is wrong at some place.
    #[error(transparent)]
    Scene(Box<SceneError>),
    /// The items of a stack do not fit together.
    #[error(transparent)]
    Stack(#[from] StackError),
    /// A layer cannot be made of these numbers.
    #[error(transparent)]
    Layer(#[from] LayerError),
    /// Heights that do not describe a punch.
    #[error(transparent)]
    Heights(#[from] HeightsError),
    /// A list of loads that is none.
    #[error(transparent)]
    Loads(#[from] LoadsError),
    /// Something is no axis of a sweep.
    #[error(transparent)]
    Axis(#[from] AxisError),
    /// A number is outside its range.
    #[error("{quantity}: {reason}")]
    OutOfRange {
        /// What the number is, as in a scene.
        quantity: &'static str,
        /// What was found and what is allowed.
        #[source]
        reason: OutOfRange,
    },
    /// A relative tolerance that double precision cannot reach, or that says nothing.
    #[error("tolerance: found {found:?}, allowed is 1e-13 <= tolerance <= 1e-2")]
    Tolerance {
        /// The tolerance asked for.
        found: f64,
    },
    /// A given pressure, and a method that wants a punch.
    #[error("a given pressure in place of a punch is solved for by the Galerkin method only")]
    LoadByCollocation,
    /// A flat punch with sharp corners, and a method that wants pressures that end at 0.
    #[error("a flat punch with sharp corners is solved for by the Galerkin method only")]
    FlatByCollocation,
    /// A given pressure, and a half-length of the contact under a punch.
    #[error("half_length: a given pressure has no contact whose half-length a force could be found for")]
    LoadWithHalfLength,
    /// The layers' fields cannot be computed.
    #[error("the fields of the layers cannot be computed at wavenumber {wavenumber:e}")]
    Unresolved {
        /// The wavenumber in question, in 1/length.
        wavenumber: f64,
    },
    /// A field was asked for where there is nothing.
    #[error("{place}: there is no layer; allowed is {allowed}")]
    Outside {
        /// Where.
        place: String,
        /// Where there is something.
        allowed: String,
    },
    /// A field was asked for so far away that it would take too many wavenumbers.
    #[error("x = {x:?} is too far from the contacts for the field to be computed there")]
    TooFar {
        /// The farthest of the places asked for, in length.
        x: f64,
    },
    /// The search for the largest shear stress would take too long.
    #[error(
        "the search for the largest shear stress would evaluate layers {evaluations:.1e} times at a step; allowed are \
         {allowed:.1e}"
    )]
    TooLong {
        /// Evaluations of layers in one step, all wavenumbers together.
        evaluations: f64,
        /// The most that are allowed.
        allowed: f64,
    },
    /// A field was asked for with the solution of another stack.
    #[error("the solution is one of another stack than that of the model: its pressures do not belong to these layers")]
    OtherStack,
    /// The scene is well posed, but no admissible contact was found.
    #[error(transparent)]
    NoSolution(#[from] NoSolution),
}

/// Why no admissible contact was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoSolution {
    /// The contact would reach past the edge of the punch.
    #[error("the punch {punch} cannot carry the force: the contact would reach its edge at x = {edge:?}")]
    PunchTooSmall {
        /// The punch as it is written in a scene.
        punch: String,
        /// Half-width of the punch, in length.
        edge: f64,
    },
    /// No force makes the contact as long as wanted.
    #[error(
        "no force makes the half-length of the contact under the punch {punch} {half_length:?}; {}",
        reachable(*.below, *.above)
    )]
    HalfLength {
        /// The punch as it is written in a scene.
        punch: String,
        /// The half-length wanted, in length.
        half_length: f64,
        /// The largest half-length below it that a force brings about, or that no force exceeds, in length.
        below: Option<f64>,
        /// The smallest half-length above it that a force brings about, or that any force exceeds, in length.
        above: Option<f64>,
    },
    /// The force was not found that makes the contact as long as wanted: forces tried were not solved for.
    #[error(
        "the force was not found that makes the half-length of the contact under the punch {punch} {half_length:?}; {}{}",
        reachable(*.below, *.above),
        .cause.as_ref().map(|cause| format!("; in between {cause}")).unwrap_or_default()
    )]
    ForceNotFound {
        /// The punch as it is written in a scene.
        punch: String,
        /// The half-length wanted, in length.
        half_length: f64,
        /// The largest half-length below it that was found, in length.
        below: Option<f64>,
        /// The smallest half-length above it that was found, in length.
        above: Option<f64>,
        /// Why the solver failed at the force tried last; `None` if the search did not end.
        cause: Option<Box<NoSolution>>,
    },
    /// The half-lengths of the contacts did not settle.
    #[error("the half-lengths of the contacts did not converge; the last were {half_lengths:?}")]
    NotConverged {
        /// The last half-lengths tried, from the top down, in length.
        half_lengths: Vec<f64>,
    },
    /// A contact would have to pull.
    #[error("the contact at {} would have to pull at x = {x:e}: no pressure there may be negative", place(.interface))]
    Tension {
        /// The contact.
        interface: Interface,
        /// Where, in length.
        x: f64,
    },
    /// Bodies touch in more than one interval, and where exactly was not found.
    #[error("the contact at {} is not one interval: the bodies touch where {}", place(.interface), intervals(.parts))]
    Parts {
        /// The contact.
        interface: Interface,
        /// Intervals of |x| in which they touch, right to some per cent, ascending, in length; the last may be infinite.
        parts: Vec<[f64; 2]>,
    },
    /// Two bodies would overlap.
    #[error("the bodies at {} would overlap at x = {x:e}: no gap outside the contact may be negative", place(.interface))]
    Overlap {
        /// The contact outside which they overlap.
        interface: Interface,
        /// Where, in length.
        x: f64,
    },
}

fn place(interface: &Interface) -> String {
    match interface {
        Interface::Punch => "the punch".to_owned(),
        between => format!("the interface {between}"),
    }
}

/// Which half-lengths are reached on either side of one that is not.
fn reachable(below: Option<f64>, above: Option<f64>) -> String {
    match (below, above) {
        (Some(below), Some(above)) if below == above => format!("it is {below:?} under any force"),
        // a contact is longer than the flat part of its punch, and shorter than the punch
        (Some(below), Some(above)) if below > above => {
            format!("reachable are half-lengths between {above:?} and {below:?}")
        }
        (Some(below), Some(above)) => format!("half-lengths up to {below:?} and from {above:?} on were reached"),
        (Some(below), None) => format!("half-lengths up to {below:?} were reached"),
        (None, Some(above)) => format!("reachable are half-lengths above {above:?}"),
        (None, None) => "no half-length was reached".to_owned(),
    }
}

fn intervals(parts: &[[f64; 2]]) -> String {
    let interval = |[from, to]: &[f64; 2]| match *from {
        0.0 => format!("|x| < {to:.3e}"),
        _ if to.is_infinite() => format!("|x| > {from:.3e}"),
        _ => format!("{from:.3e} < |x| < {to:.3e}"),
    };
    parts.iter().map(interval).collect::<Vec<_>>().join(" and ")
}

impl Error {
    /// Whether the input is at fault, rather than the solver unable to find an admissible solution.
    ///
    /// ```
    /// assert!(recede::Punch::cylinder(-1.0).unwrap_err().is_input());
    /// ```
    pub fn is_input(&self) -> bool {
        match self {
            Self::Scene(_) | Self::Stack(_) | Self::Layer(_) | Self::Heights(_) | Self::Loads(_) | Self::Axis(_) => {
                true
            }
            Self::OutOfRange { .. } | Self::Tolerance { .. } => true,
            Self::LoadByCollocation | Self::FlatByCollocation | Self::LoadWithHalfLength => true,
            Self::Outside { .. } | Self::TooFar { .. } | Self::OtherStack => true,
            Self::Unresolved { .. } | Self::TooLong { .. } => false,
            Self::NoSolution(cause) => {
                matches!(cause, NoSolution::PunchTooSmall { .. } | NoSolution::HalfLength { .. })
            }
        }
    }

    /// What to do about it, if that can be said.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Scene(error) => error.hint().map(str::to_owned),
            Self::Stack(error) => error.hint(),
            Self::NoSolution(NoSolution::NotConverged { .. }) => Some(
                "contacts hundreds of times longer than a layer next to them is thick need more modes than there are: \
                 try a smaller force or radius, a looser tolerance, or leave out a layer too thin to matter"
                    .to_owned(),
            ),
            Self::NoSolution(NoSolution::Parts { .. }) => Some(
                "its parts could not be found more exactly than that: other stiffnesses, thicknesses or another force may \
                 make it one interval, or easier to solve"
                    .to_owned(),
            ),
            Self::NoSolution(NoSolution::Tension { .. } | NoSolution::Overlap { .. }) => Some(
                "the contact may be more than one interval (open in the middle, touching again farther out), which is not \
                 always solved, or too long for the layers next to it, which a smaller force shortens"
                    .to_owned(),
            ),
            Self::NoSolution(NoSolution::HalfLength { .. }) => Some(
                "a contact is longer than the flat part of its punch, shorter than the punch, and its half-length jumps where \
                 intervals of it meet: prescribe one that is reached, or the force"
                    .to_owned(),
            ),
            Self::NoSolution(NoSolution::ForceNotFound { .. }) => {
                Some("prescribe the force, or a half-length next to those that were reached".to_owned())
            }
            Self::Unresolved { .. } => Some(
                "a material may vary too fast with the depth next to a contact, like a power of it that is no whole number: \
                 `recede::layers::conformance::examine` examines a layer of one's own"
                    .to_owned(),
            ),
            Self::FlatByCollocation => {
                Some("round its corners a little: `RoundedFlat(half_width: ..., radius: ...)`".to_owned())
            }
            Self::TooLong { .. } => Some("`recede field` gives the stress at points and on grids".to_owned()),
            Self::OtherStack => Some("ask the model that was pressed, or one of an equal stack, for the field".to_owned()),
            Self::LoadWithHalfLength => Some("give the force instead, the resultant of the pressure".to_owned()),
            _ => None,
        }
    }

    /// Checks what a solution is to fulfil.
    pub(crate) fn check_tolerance(options: &Options) -> Result<(), Self> {
        let found = options.tolerance;
        if (1e-13..=1e-2).contains(&found) { Ok(()) } else { Err(Self::Tolerance { found }) }
    }

    /// Checks the number given for `quantity`.
    pub(crate) fn checked<Q: TryFrom<f64, Error = OutOfRange>>(quantity: &'static str, value: f64) -> Result<Q, Self> {
        Q::try_from(value).map_err(|reason| Self::OutOfRange { quantity, reason })
    }
}

impl From<SceneError> for Error {
    fn from(error: SceneError) -> Self {
        Self::Scene(Box::new(error))
    }
}
