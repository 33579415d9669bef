//! Why a contact problem has no solution that could be found.
use crate::geometry::Geometry;
use crate::system::Unresolved;

/// Why a contact problem was not solved.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// Contacts of a kind that collocation does not know.
    #[error("collocation checks intervals, and discs about an axis, but no rings")]
    NotCollocated,
    /// A given pressure, and a half-length of the contact under a punch, or its approach.
    #[error("{}: under a given pressure there is nothing that a force could be found for", .0.field())]
    LoadControlled(Controlled),
    /// A given pressure that is not known in a geometry.
    #[error("the load {loads} is not known in this geometry, {}", .geometry.name())]
    LoadsUnknown {
        /// The loads as they are written in a scene.
        loads: String,
        /// The geometry.
        geometry: Geometry,
    },
    /// A half-length or a depth of a punch that is not symmetric, or of several.
    #[error("the punch is not symmetric about its tip, or is one of several: only forces can be prescribed")]
    UnevenPunch,
    /// A punch that is turned so far that one of its sides falls from the tip on, without end.
    #[error(
        "{punch} is turned by {angle}, so that one of its sides falls away from its tip without end; allowed are angles less than its slopes"
    )]
    PunchFalls {
        /// The punch as it is written in a scene.
        punch: String,
        /// The angle by which it is turned, in radians.
        angle: f64,
    },
    /// The layers' fields cannot be computed.
    #[error(transparent)]
    Unresolved(#[from] Unresolved),
    /// The scene is well posed, but no admissible contact was found.
    #[error(transparent)]
    NoSolution(#[from] NoSolution),
}

impl ContactError {
    /// Whether the input is at fault, rather than the solver unable to find an admissible solution.
    pub fn is_input(&self) -> bool {
        match self {
            Self::NotCollocated
            | Self::LoadControlled(_)
            | Self::LoadsUnknown { .. }
            | Self::UnevenPunch
            | Self::PunchFalls { .. } => true,
            Self::Unresolved(_) => false,
            Self::NoSolution(cause) => cause.is_input(),
        }
    }

    /// What to do about it, if that can be said.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::NotCollocated => Some("leave out `--method collocation`".to_owned()),
            Self::LoadControlled(_) => Some("give the force instead, the resultant of the pressure".to_owned()),
            Self::LoadsUnknown { geometry, .. } => Some(
                match geometry {
                    Geometry::Axisymmetric => {
                        "about an axis every load is in the middle, and the half_width of a `Ring` is at least a ten-thousandth \
                         of its radius"
                    }
                    _ => "a ring is known about an axis only: in the plane give a load on either side",
                }
                .to_owned(),
            ),
            Self::UnevenPunch => Some("prescribe `force`".to_owned()),
            Self::PunchFalls { .. } => Some("turn it less, or let it turn by its force: `Free(eccentricity: ...)`".to_owned()),
            Self::Unresolved(cause) => Some(cause.hint()),
            Self::NoSolution(cause) => cause.hint(),
        }
    }
}

/// What is prescribed in place of a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Controlled {
    /// The half-length of the contact under the punch.
    HalfLength,
    /// The approach of the punch: how far it sinks.
    Approach,
}

impl Controlled {
    /// The name of the field of a scene that says it.
    fn field(self) -> &'static str {
        match self {
            Self::HalfLength => "half_length",
            Self::Approach => "depth",
        }
    }
}

impl std::fmt::Display for Controlled {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::HalfLength => "`half_length` of the contact under the punch",
            Self::Approach => "approach of the punch",
        })
    }
}

/// Why no admissible contact was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoSolution {
    /// The contact would reach past the edge of the punch.
    #[error("the punch {punch} cannot carry the force: the contact would reach its edge, {edge:?} from its middle")]
    PunchTooSmall {
        /// The punch as it is written in a scene.
        punch: String,
        /// Half-width of the punch, its radius in axisymmetric problems, in length.
        edge: f64,
    },
    /// The contacts under two punches would grow together.
    #[error("the contacts under punch {left} and punch {} would meet: each place is pressed by one punch only", .left + 1)]
    PunchesMeet {
        /// The number of the punch on the left, from 1.
        left: usize,
    },
    /// No force makes the contact as long, or the punch sink as far, as wanted.
    #[error("no force makes the {controlled} {punch} {wanted:?}; {}", reachable(*.controlled, *.below, *.above))]
    Unreachable {
        /// What is prescribed.
        controlled: Controlled,
        /// The punch as it is written in a scene.
        punch: String,
        /// What it was to be, in length.
        wanted: f64,
        /// The largest value below it that a force brings about, or that no force exceeds, in length.
        below: Option<f64>,
        /// The smallest value above it that a force brings about, or that any force exceeds, in length.
        above: Option<f64>,
    },
    /// The force was not found that makes the contact as long, or the punch sink as far, as wanted: forces tried were not solved for.
    #[error(
        "the force was not found that makes the {controlled} {punch} {wanted:?}; {}{}",
        reachable(*.controlled, *.below, *.above),
        .cause.as_ref().map(|cause| format!("; in between {cause}")).unwrap_or_default()
    )]
    ForceNotFound {
        /// What is prescribed.
        controlled: Controlled,
        /// The punch as it is written in a scene.
        punch: String,
        /// What it was to be, in length.
        wanted: f64,
        /// The largest value below it that was found, in length.
        below: Option<f64>,
        /// The smallest value above it that was found, in length.
        above: Option<f64>,
        /// Why the solver failed at the force tried last; `None` if the search did not end.
        cause: Option<Box<NoSolution>>,
    },
    /// The ends of the contacts did not converge: what was tried last tells nothing of them.
    #[error("the ends of the contacts did not converge")]
    NotConverged,
}

/// Which values are reached on either side of one that is not.
fn reachable(controlled: Controlled, below: Option<f64>, above: Option<f64>) -> String {
    let (one, several) = match controlled {
        Controlled::HalfLength => ("value", "values"),
        Controlled::Approach => ("approach", "approaches"),
    };
    match (below, above) {
        (Some(below), Some(above)) if below == above => format!("it is {below:?} under any force"),
        // a contact is longer than the flat part of its punch, and shorter than the punch
        (Some(below), Some(above)) if below > above => {
            format!("reachable are {several} between {above:?} and {below:?}")
        }
        (Some(below), Some(above)) => format!("{several} up to {below:?} and from {above:?} on were reached"),
        (Some(below), None) => format!("{several} up to {below:?} were reached"),
        (None, Some(above)) => format!("reachable are {several} above {above:?}"),
        (None, None) => format!("no {one} was reached"),
    }
}

impl NoSolution {
    /// Whether the input is at fault, rather than the solver unable to find an admissible solution.
    pub fn is_input(&self) -> bool {
        matches!(self, Self::PunchTooSmall { .. } | Self::PunchesMeet { .. } | Self::Unreachable { .. })
    }

    /// What to do about it, if that can be said.
    pub fn hint(&self) -> Option<String> {
        let hint = match self {
            Self::PunchTooSmall { .. } => return None,
            Self::PunchesMeet { .. } => "put them farther apart, or press with smaller forces",
            Self::NotConverged => {
                "contacts hundreds of times longer than a layer next to them is thick need more modes than there are: \
                 try a smaller force or radius, a looser tolerance, or leave out a layer too thin to matter"
            }
            Self::Unreachable { controlled: Controlled::Approach, .. } => {
                "the contact would reach the edge of the punch: prescribe a smaller approach, or make the punch wider"
            }
            Self::Unreachable { controlled: Controlled::HalfLength, .. } => {
                "a contact is wider than the flat part of its punch, narrower than the punch, and its `half_length` jumps \
                 where intervals of it meet: prescribe one that is reached, or the force"
            }
            Self::ForceNotFound { .. } => "prescribe the force, or a value next to those that were reached",
        };
        Some(hint.to_owned())
    }
}
