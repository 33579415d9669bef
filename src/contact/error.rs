//! Why a contact problem has no solution that could be found.
use crate::geometry::Geometry;
use crate::solution::{Controlled, Interface};
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
    /// No force, and no weights that press all layers together, or a punch.
    #[error("the force is 0, which is for given loads on layers that weights, or a pressure on top, press together")]
    NoForce,
    /// Loads about several axes on layers that come apart, where what each load does alone cannot be added up.
    #[error("loads at places (x, y) are added up, which does not hold where layers come apart, as at {interface}")]
    NotSuperposed {
        /// The first interface at which they do.
        interface: Interface,
    },
    /// A half-length or a depth of a punch that is not symmetric, or of several, or a force of several of which something else is prescribed.
    #[error(
        "the punch is not symmetric about its tip, or is one of several: what is prescribed stands beside it in the list of punches"
    )]
    UnevenPunch,
    /// A covered punch on a stack that has no layers of it.
    #[error("the punch is covered, and the stack below was made without its layers")]
    NotUnderCover,
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
    /// A punch on a face whose edges bend up more than the punch does.
    #[error(
        "the face under {punch} is curved before it is loaded: its slope grows by {curvature:e} per length, so that it rises to the punch far away, without end"
    )]
    FaceRises {
        /// The punch as it is written in a scene.
        punch: String,
        /// The curvature of the face, in 1/length.
        curvature: f64,
    },
    /// The layers' fields cannot be computed.
    #[error(transparent)]
    Unresolved(#[from] Unresolved),
    /// The scene is well posed, but no admissible contact was found.
    #[error(transparent)]
    NoSolution(#[from] NoSolution),
}

impl ContactError {
    /// What it means at a contact below the uppermost one, where it is about a gap in place of a punch.
    pub(super) fn at(self, contact: usize) -> Self {
        match self {
            Self::NoSolution(NoSolution::PunchTooSmall { punch: gap, edge }) if contact > 0 => {
                NoSolution::GapEnds { gap, edge }.into()
            }
            other => other,
        }
    }

    /// Whether the input is at fault, rather than the solver unable to find an admissible solution.
    pub fn is_input(&self) -> bool {
        match self {
            Self::NotCollocated
            | Self::FaceRises { .. }
            | Self::LoadControlled(_)
            | Self::LoadsUnknown { .. }
            | Self::NotSuperposed { .. }
            | Self::NoForce
            | Self::UnevenPunch
            | Self::NotUnderCover
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
                        "about an axis every load is in the middle or at a place (x, y), and the half_width of a `Ring` is at least a ten-thousandth \
                         of its radius"
                    }
                    _ => "a ring is known about an axis only: in the plane give a load on either side",
                }
                .to_owned(),
            ),
            Self::NoForce => Some("give a force > 0, or leave out the punch and give all layers a `specific_weight`".to_owned()),
            Self::NotSuperposed { .. } => Some("bond the layers, or let one load press about the axis: `load: ...`".to_owned()),
            Self::FaceRises { .. } => Some("take a punch that ends, or one that is curved more, or give its pressure as `load`".to_owned()),
            Self::NotUnderCover => Some("take `Scene::stack`, or add them by `Stack::under`".to_owned()),
            Self::UnevenPunch => Some(
                "write it as one of `punches: [(shape: ..., at: ..., force: ...), ...]`, with `force`, `depth`, `left` or `right`"
                    .to_owned(),
            ),
            Self::PunchFalls { .. } => Some("turn it less, or let it turn by its force: `Free(eccentricity: ...)`".to_owned()),
            Self::Unresolved(cause) => Some(cause.hint()),
            Self::NoSolution(cause) => cause.hint(),
        }
    }
}

/// Why no admissible contact was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoSolution {
    /// Layers that weights press together come apart about an axis, which is not solved for.
    #[error("the layers at the contact {interface} come apart at {x:.6}{}", closed_up_to(*.critical_force))]
    LiftsOff {
        /// The interface.
        interface: Interface,
        /// Where it opens.
        x: f64,
        /// The force up to which nothing opens; NaN if it was not found.
        critical_force: f64,
    },
    /// The contact would reach past the edge of the punch.
    #[error("the punch {punch} cannot carry the force: the contact would reach its edge, {edge:?} from its middle")]
    PunchTooSmall {
        /// The punch as it is written in a scene.
        punch: String,
        /// Half-width of the punch, its radius in axisymmetric problems, in length.
        edge: f64,
    },
    /// The contact between two layers would reach the end of the gap that is given between them.
    #[error("the contact that closes the gap {gap} would reach its end, {edge:?} from its middle")]
    GapEnds {
        /// The gap as it is written in a scene.
        gap: String,
        /// Where it ends, in length.
        edge: f64,
    },
    /// The contacts under two punches would grow together.
    #[error("the contacts under punch {left} and punch {} would meet: each place is pressed by one punch only", .left + 1)]
    PunchesMeet {
        /// The number of the punch on the left, from 1.
        left: usize,
    },
    /// No force makes the contact as long, or the punch sink as far, as wanted.
    #[error("no force makes the {controlled} {punch} {wanted:?}; {}", reachable(*.below, *.above))]
    Unreachable {
        /// What is prescribed.
        controlled: Controlled,
        /// The punch as it is written in a scene.
        punch: String,
        /// What it was to be, in length.
        wanted: f64,
        /// The value that no force exceeds, in length.
        below: Option<f64>,
        /// The value that any force exceeds, in length.
        above: Option<f64>,
    },
    /// The force was not found that makes the contact as long, or the punch sink as far, as wanted.
    #[error("the force was not found that makes the {controlled} {punch} {wanted:?}: {cause}")]
    ForceNotFound {
        /// What is prescribed.
        controlled: Controlled,
        /// The punch as it is written in a scene.
        punch: String,
        /// What it was to be, in length.
        wanted: f64,
        /// Why the solver failed.
        cause: Box<NoSolution>,
    },
    /// The ends of the contacts did not converge: what was tried last tells nothing of them.
    #[error("the ends of the contacts did not converge")]
    NotConverged,
}

/// Up to which force nothing opens, if that is known.
fn closed_up_to(force: f64) -> String {
    if force.is_nan() { String::new() } else { format!(": all is closed up to the force {force:.9e} only") }
}

/// Which values are reached.
fn reachable(below: Option<f64>, above: Option<f64>) -> String {
    match (below, above) {
        (Some(below), Some(above)) if below == above => format!("it is {below:?} under any force"),
        // a contact is longer than the flat part of its punch, and shorter than the punch
        (Some(below), Some(above)) => format!("reachable are values between {above:?} and {below:?}"),
        (Some(below), None) => format!("reachable are values below {below:?}"),
        (None, Some(above)) => format!("reachable are values above {above:?}"),
        (None, None) => "the contact would reach the edge of the punch".to_owned(),
    }
}

impl NoSolution {
    /// Whether the input is at fault, rather than the solver unable to find an admissible solution.
    pub fn is_input(&self) -> bool {
        matches!(
            self,
            Self::LiftsOff { .. }
                | Self::PunchTooSmall { .. }
                | Self::GapEnds { .. }
                | Self::PunchesMeet { .. }
                | Self::Unreachable { .. }
        )
    }

    /// What to do about it, if that can be said.
    pub fn hint(&self) -> Option<String> {
        let hint = match self {
            Self::PunchTooSmall { .. } => return None,
            Self::LiftsOff { .. } => "press with a smaller force, or with more weight",
            Self::GapEnds { .. } => "give the gap farther out, or press with a smaller force",
            Self::PunchesMeet { .. } => "put them farther apart, or press with smaller forces",
            Self::NotConverged => {
                "contacts hundreds of times longer than a layer next to them is thick need more modes than there are: \
                 try a smaller force or radius, a looser tolerance, or leave out a layer too thin to matter"
            }
            Self::Unreachable { controlled: Controlled::Approach, .. } => {
                "prescribe a smaller approach, or make the punch wider"
            }
            Self::Unreachable { .. } => {
                "a contact is wider than the flat part of its punch and narrower than the punch: prescribe one that is reached, or the force"
            }
            Self::ForceNotFound { .. } => {
                "prescribe the force: a half-length jumps where intervals of a contact meet, and there no force brings it about"
            }
        };
        Some(hint.to_owned())
    }
}
