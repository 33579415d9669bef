//! How far a punch sinks, and how stiff the stack is under it.
//!
//! Inside its contact the top face follows the punch: v(x) = f(x) − f_min − δ, with the profile f and the approach δ. In plane problems that
//! is defined where displacements can be counted from a base that stays: δ over a half-plane grows without limit with the distance of
//! the point from which it is counted. In axisymmetric problems displacements vanish far away, and it is defined over any base.
//!
//! Both follow from the contact equations on the intervals of the solution. The stiffness is dP/dδ, while the forces on other punches stay as they are. Where these equations were not
//! solved, as for solutions of low accuracy, δ is what the displacements of the top face say.
use std::f64::consts::PI;

use crate::contact::{self, Asked, Sinking};
use crate::field::{DISPLACEMENTS, Field, FieldError, FieldPoint};
use crate::numeric::largest;
use crate::scene::{Pressed, Punch, Punches, Top};
use crate::solution::{Contact, Interface, Interval, Solution};
use crate::stack::Stack;

/// What is left of pressures and ends, as parts of these, changes an approach and a stiffness by no larger parts.
const SAFETY: f64 = 3.0;
/// Relative error of a sum over wavenumbers.
const ROUNDING: f64 = 1e-12;
/// Places in a contact at which a punch and the top face are compared.
const PLACES: usize = 8;

/// How far a punch has sunk into a stack since it touched it first, and the stiffness there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// The approach δ ≥ 0, in length.
    pub value: f64,
    /// Estimate of its absolute error.
    pub error: f64,
    /// The stiffness dP/dδ, force per unit length out of plane over length; in axisymmetric problems the whole force over length.
    pub stiffness: Stiffness,
}

/// The derivative of the force with respect to the approach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stiffness {
    /// It is known.
    Known {
        /// dP/dδ, in stress; in axisymmetric problems dF/dδ, force over length.
        value: f64,
        /// Estimate of its absolute error.
        error: f64,
    },
    /// The equations for it could not be solved.
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
    /// There are several punches, each with an approach of its own, or one that is not symmetric about its tip.
    #[error(
        "the approach is prescribed or asked for of one punch that is symmetric about its tip; several have one each"
    )]
    Punches,
    /// The solution is one of another stack, or the displacement of the top face cannot be computed.
    #[error(transparent)]
    Field(#[from] FieldError),
}

impl ApproachError {
    /// What to do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::Field(cause) => cause.hint().unwrap_or_default(),
            Self::Punches => "prescribe the force or the `depth` of each punch in its list".to_owned(),
            _ => "prescribe `force`, or where the contact under a punch ends: `half_length`, or in a list `left` or `right`".to_owned(),
        }
    }
}

/// The punches, if approaches are defined on a stack.
pub(crate) fn punches<'a>(top: &'a Top, stack: &Stack) -> Result<&'a Punches, ApproachError> {
    let punches = top.punches().ok_or(ApproachError::Load)?;
    // displacements vanish far from a force that does not act on a whole line
    if stack.geometry().is_axisymmetric() {
        return Ok(punches);
    }
    if stack.base().foundation().half_plane().is_some() {
        return Err(ApproachError::HalfPlane);
    }
    let has_elastic_core = |second: &Stack| second.base().foundation().half_plane().is_some();
    let is_elastic = top.material().is_some() || stack.second().is_some_and(has_elastic_core);
    if is_elastic { Err(ApproachError::ElasticPunch) } else { Ok(punches) }
}

/// The punch that is symmetric and not turned, if there is no other one, and an approach is defined for it on a stack.
pub(crate) fn defined<'a>(top: &'a Top, stack: &Stack) -> Result<&'a Punch, ApproachError> {
    punches(top, stack)?;
    top.even_punch().ok_or(ApproachError::Punches)
}

/// The approach of each punch, from left to right; one entry that says why where there are none.
pub(crate) fn of_each(asked: &Asked, stack: &Stack, solution: &Solution) -> Vec<Result<Approach, ApproachError>> {
    let punches = match punches(asked.top, stack) {
        Ok(punches) => punches,
        Err(error) => return vec![Err(error)],
    };
    match contact::sinking(asked, solution) {
        Some(all) => all.into_iter().map(|sinking| Ok(of_one(sinking, solution))).collect(),
        None => {
            (0..).zip(punches.parts()).map(|(number, (pressed, _))| of_face(number, pressed, stack, solution)).collect()
        }
    }
}

/// How far a punch has sunk by the displacements of the top face in its contact, which differ from the displacement of the punch by errors of the solution.
fn of_face(number: usize, pressed: &Pressed, stack: &Stack, solution: &Solution) -> Result<Approach, ApproachError> {
    let each = solution.contacts()[0].of_each_punch();
    let Interval { left, right, .. } = each[number].innermost();
    let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
    let place = |k: usize| middle + half * (PI * (k as f64 + 0.5) / PLACES as f64).cos();
    let places: Vec<f64> = (0..PLACES).map(place).collect();
    let field = Field::new(stack, solution);
    let faces = field.faces(&places, &DISPLACEMENTS)?;
    let (shape, tilt) = (pressed.shape().shape(), solution.punches().get(number).map_or(0.0, |own| own.tilt));
    let sunk = |(x, point): (&f64, &FieldPoint)| {
        let from_tip = x - pressed.at();
        let curved = field.gaps.height(Interface::Punch, *x);
        shape.height(from_tip) + tilt * from_tip - shape.lowest() + curved - point.v
    };
    let sunk: Vec<f64> = places.iter().zip(&faces[0].points).map(sunk).collect();
    let value = sunk.iter().sum::<f64>() / PLACES as f64;
    let spread = largest(sunk.iter().map(|own| (own - value).abs()));
    let error = SAFETY * (spread + (ROUNDING + relative_error(solution)) * value.abs());
    Ok(Approach { value, error, stiffness: Stiffness::NotComputed })
}

/// How far the tip of a punch has moved down since the punch, not turned, touched the top face with its lowest point, and the stiffness.
fn of_one(Sinking { depth, depth_error, stiffness, stiffness_error }: Sinking, solution: &Solution) -> Approach {
    let relative = ROUNDING + relative_error(solution);
    let error = |value: f64, error: f64| error + SAFETY * relative * value.abs();
    let is_known = stiffness > 0.0 && stiffness_error.is_finite();
    let stiffness = match is_known {
        true => Stiffness::Known { value: stiffness, error: error(stiffness, stiffness_error) },
        false => Stiffness::NotComputed,
    };
    Approach { value: depth, error: error(depth, depth_error), stiffness }
}

/// The sum of the relative errors of all ends and pressures.
fn relative_error(solution: &Solution) -> f64 {
    let of = |contact: &Contact| {
        let ([_, pressure], end) = (contact.middle_pressure, contact.end_error());
        let length: f64 = contact.intervals().iter().map(|one| one.right - one.left).sum();
        length * pressure / contact.resultant + end
    };
    solution.contacts().iter().map(of).filter(|error| error.is_finite()).sum::<f64>()
}
