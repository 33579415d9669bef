//! How far a punch sinks, and how stiff the stack is under it.
//!
//! Inside its contact the top face follows the punch: v(x) = f(x) − f_min − δ, with the profile f and the approach δ. In plane problems that
//! is defined where displacements can be counted from a base that stays: δ over a half-plane grows without limit with the distance of
//! the point from which it is counted.
//!
//! The stiffness is dP/dδ. Contact pressures vanish at the ends of their contacts, so that to first order the contacts stay as long as they
//! are while the force grows: the derivative of the pressures with respect to the force is that of a flat punch, and of layers that are
//! joined, on contacts of these half-lengths.
use crate::contact::{self, ContactError, Measured};
use crate::field::{Field, FieldError, Point};
use crate::kernel::Kernel;
use crate::scene::Punch;
use crate::solution::{Contact, Interface, Solution};
use crate::stack::Stack;

/// Where the top face is looked at a second time, between the middle of the contact and its end: how far the approach differs there tells
/// how accurate it is.
const SECOND: f64 = 0.6;
/// Two places of a contact need not be those where most is missing.
const SAFETY: f64 = 3.0;
/// Relative error of a sum over wavenumbers.
const ROUNDING: f64 = 1e-12;

/// How far a punch has sunk into a stack since it touched it first, and the stiffness there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// The approach δ ≥ 0, in length.
    pub value: f64,
    /// Estimate of its absolute error.
    pub error: f64,
    /// The stiffness dP/dδ, force per unit length out of plane over length.
    pub stiffness: Stiffness,
}

/// The derivative of the force with respect to the approach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stiffness {
    /// It is known.
    Known {
        /// dP/dδ, in stress.
        value: f64,
        /// Estimate of its absolute error.
        error: f64,
    },
    /// It is not computed for contacts of several intervals, nor where the equations for it could not be solved.
    NotComputed,
}

impl Stiffness {
    /// The value, if it is known.
    pub fn value(self) -> Option<f64> {
        if let Self::Known { value, .. } = self { Some(value) } else { None }
    }

    /// The estimate of its absolute error, if it is known.
    pub fn error(self) -> Option<f64> {
        if let Self::Known { error, .. } = self { Some(error) } else { None }
    }
}

/// Why there is no approach.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ApproachError {
    /// The base is a half-plane.
    #[error(
        "over a half-plane the approach is not defined in plane problems: it grows without limit with the depth from which it is counted"
    )]
    HalfPlane,
    /// The punch is elastic.
    #[error(
        "the approach of an elastic punch is not defined in plane problems: it grows without limit with the distance from which it is counted"
    )]
    ElasticPunch,
    /// There is no punch.
    #[error("a prescribed traction has no approach")]
    Load,
    /// The displacement of the top face cannot be computed.
    #[error(transparent)]
    Field(#[from] FieldError),
}

impl ApproachError {
    /// What to do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::Field(cause) => cause.hint().unwrap_or_default(),
            _ => "prescribe the force, or the half-length of the contact under a punch".to_owned(),
        }
    }
}

/// Whether an approach is defined for a punch on a stack.
pub(crate) fn defined(punch: &Punch, stack: &Stack) -> Result<(), ApproachError> {
    if stack.base().foundation().half_plane().is_some() {
        return Err(ApproachError::HalfPlane);
    }
    if punch.load().is_some() {
        return Err(ApproachError::Load);
    }
    if punch.material().is_some() { Err(ApproachError::ElasticPunch) } else { Ok(()) }
}

/// The approach alone, with its error.
pub(crate) fn depth(punch: &Punch, stack: &Stack, solution: &Solution) -> Result<Measured, ApproachError> {
    let Sunk { at, v, apart } = Sunk::new(stack, solution)?;
    let lowest = punch.lowest();
    let [value, second] = [0, 1].map(|k| punch.profile(at[k]) - lowest - v[k]);
    let relative = ROUNDING + relative_error(solution, true);
    Ok(Measured { value, error: SAFETY * ((value - second).abs() + apart + relative * value.abs()) })
}

/// The approach and the stiffness.
pub(crate) fn approach(
    punch: &Punch,
    stack: &Stack,
    kernel: &Kernel,
    solution: &Solution,
) -> Result<Approach, ApproachError> {
    defined(punch, stack)?;
    let Measured { value, error } = depth(punch, stack, solution)?;
    let stiffness = match contact::tangent(kernel, punch, solution) {
        Some(Ok(tangent)) => stiffness(stack, kernel, solution, &tangent)?,
        Some(Err(ContactError::Unresolved(cause))) => return Err(FieldError::Unresolved(cause).into()),
        Some(Err(_)) | None => Stiffness::NotComputed,
    };
    Ok(Approach { value, error, stiffness })
}

/// The stiffness from the pressures that a unit force adds.
fn stiffness(
    stack: &Stack,
    kernel: &Kernel,
    solution: &Solution,
    tangent: &Solution,
) -> Result<Stiffness, ApproachError> {
    let Sunk { v, apart, .. } = Sunk::new(stack, tangent)?;
    let compliance = -v[0];
    let contacts = solution.contacts().iter().zip(tangent.contacts()).enumerate();
    // an end that moves by da changes the compliance by 2πa q²/E* da, with the singular pressure q/√(1 − x²/a²): the energy release
    // rate of a crack that closes
    let ends = contacts.map(|(i, (contact, tangent))| {
        let corners: f64 = tangent.strips.iter().map(|strip| strip.corners).sum();
        let (a, error) = (contact.half_length().unwrap_or(0.0), contact.half_length_error().unwrap_or(0.0));
        2.0 * std::f64::consts::PI * a * corners * corners / kernel.contact_modulus(i, None) * error
    });
    let relative = ROUNDING + relative_error(tangent, false);
    let error = SAFETY * (ends.sum::<f64>() + (v[0] - v[1]).abs() + apart + relative * compliance.abs());
    let value = compliance.recip();
    if compliance > 0.0 && value.is_finite() {
        Ok(Stiffness::Known { value, error: error * value * value })
    } else {
        Ok(Stiffness::NotComputed)
    }
}

/// The sum of the errors of all pressures, as parts of the mean pressures, and with `ends` also of the half-lengths.
fn relative_error(solution: &Solution, ends: bool) -> f64 {
    let of = |contact: &Contact| {
        let a = contact.reach();
        let end = contact.innermost().to_error / contact.innermost().to;
        // nothing depends on an end that is not known at all
        2.0 * a * contact.central_pressure_error / contact.resultant + if ends && end < 1.0 { end } else { 0.0 }
    };
    solution.contacts().iter().map(of).filter(|error| error.is_finite()).sum::<f64>()
}

/// The displacement of the top face at two places of the contact under the punch.
struct Sunk {
    at: [f64; 2],
    v: [f64; 2],
    /// How far bodies are from touching each other at the second place of each contact below: they are joined at the first.
    apart: f64,
}

impl Sunk {
    fn new(stack: &Stack, solution: &Solution) -> Result<Self, FieldError> {
        let field = Field::new(stack, solution);
        let face = |number: usize, side: usize| {
            let depth = field.layers().find(|(layer, _)| *layer == number).map(|(_, ends)| ends[side]);
            depth.filter(|depth| depth.is_finite())
        };
        let mut points = Vec::new();
        for contact in solution.contacts() {
            let [first, second] = places(contact);
            let faces = match contact.interface {
                Interface::Punch => vec![(first, None, Some(0.0)), (second, None, Some(0.0))],
                // a rigid base without layers has no face, and stays where it is
                Interface::Between { above, below } => {
                    vec![(second, Some(above), face(above, 1)), (second, Some(below), face(below, 0))]
                }
            };
            points.extend(faces.into_iter().map(|(x, layer, depth)| depth.map(|depth| Point { x, depth, layer })));
        }
        let asked: Vec<Point> = points.iter().flatten().copied().collect();
        let mut found = field.points(&asked)?.into_iter();
        let v: Vec<f64> =
            points.iter().map(|point| point.and_then(|_| found.next()).map_or(0.0, |there| there.v)).collect();
        let apart = v.chunks(2).skip(1).map(|faces| (faces[0] - faces[1]).abs()).sum();
        let at = solution.contacts().first().map_or([0.0; 2], places);
        Ok(Self { at, v: [v[0], v[1]], apart })
    }
}

/// Two places inside a contact: where its bodies are joined, and one between that and the end.
fn places(contact: &Contact) -> [f64; 2] {
    let (first, end) = (contact.inside(), contact.innermost().to);
    [first, first + SECOND * (end - first)]
}
