//! How far a punch sinks, and how stiff the stack is under it.
//!
//! Inside its contact the top face follows the punch: v(x) = f(x) − f_min − δ, with the profile f and the approach δ. In plane problems that
//! is defined where displacements can be counted from a base that stays: δ over a half-plane grows without limit with the distance of
//! the point from which it is counted. In axisymmetric problems displacements vanish far away, and it is defined over any base.
//!
//! Displacements are averaged over each contact, under the punch and below: the means at a contact tell how the bodies above and below it are
//! placed, since they touch there.
//!
//! The stiffness is dP/dδ. Contact pressures vanish at the ends of their contacts, so that to first order the contacts stay as long as they
//! are while the force grows: the derivative of the pressures with respect to the force is the pressure of a flat punch, and of layers that are
//! joined, on contacts of these half-lengths.
use std::borrow::Cow;
use std::f64::consts::PI;

use crate::contact::{self, ContactError};
use crate::field::{ContactPressure, Field, FieldError};
use crate::kernel::Kernel;
use crate::numeric::means::MeanWindow;
use crate::scene::{Pressed, Punch, Punches, Top};
use crate::solution::{Contact, Solution};
use crate::stack::Stack;

/// Displacements are looked at so far from the middle of a contact under one of several punches, in half-lengths.
const PLACE: f64 = 0.3;
/// Two means need not be those in which most is missing.
const SAFETY: f64 = 3.0;
/// Relative error of a sum over wavenumbers.
const ROUNDING: f64 = 1e-12;
/// Waves of which no mean has more than this are left out.
const NEGLIGIBLE: f64 = 1e-13;

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
    /// There are several punches, each with an approach of its own, or one that is not symmetric about its tip.
    #[error(
        "the approach is prescribed or asked for of one punch that is symmetric about its tip; several have one each"
    )]
    Punches,
    /// The displacement of the top face cannot be computed.
    #[error(transparent)]
    Field(#[from] FieldError),
}

impl ApproachError {
    /// What to do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::Field(cause) => cause.hint().unwrap_or_default(),
            Self::Punches => "prescribe the force of each punch".to_owned(),
            _ => "prescribe `force`, or `half_length` of the contact under a punch".to_owned(),
        }
    }
}

/// The punches, if approaches are defined on a stack.
fn punches<'a>(top: &'a Top, stack: &Stack) -> Result<&'a Punches, ApproachError> {
    let punches = top.punches().ok_or(ApproachError::Load)?;
    // displacements vanish far from a force that does not act on a whole line
    if stack.geometry().is_axisymmetric() {
        return Ok(punches);
    }
    if stack.base().foundation().half_plane().is_some() {
        return Err(ApproachError::HalfPlane);
    }
    if top.material().is_some() { Err(ApproachError::ElasticPunch) } else { Ok(punches) }
}

/// The punch that is symmetric and not turned, if there is no other one, and an approach is defined for it on a stack.
pub(crate) fn defined<'a>(top: &'a Top, stack: &Stack) -> Result<&'a Punch, ApproachError> {
    punches(top, stack)?;
    top.even_punch().ok_or(ApproachError::Punches)
}

/// The approach of each punch, from left to right; one entry that says why where there are none.
pub(crate) fn of_each(
    top: &Top,
    stack: &Stack,
    kernel: &Kernel,
    solution: &Solution,
) -> Vec<Result<Approach, ApproachError>> {
    let one = approach(top, stack, kernel, solution);
    match punches(top, stack) {
        Ok(punches) if one == Err(ApproachError::Punches) => {
            let all = several(punches, stack, solution).map(|all| all.into_iter().map(Ok).collect());
            all.unwrap_or_else(|error| vec![Err(error.into())])
        }
        _ => vec![one],
    }
}

/// How far the tip of each punch has moved down since the punch, not turned, touched the top face with its lowest point, from two places at which it touches
/// the face.
fn several(punches: &Punches, stack: &Stack, solution: &Solution) -> Result<Vec<Approach>, FieldError> {
    let relative = ROUNDING + relative_error(solution, true);
    let touching = |contact: &Contact| {
        let widest = contact.intervals().iter().max_by(|a, b| a.force.total_cmp(&b.force)).copied().unwrap_or_default();
        [-PLACE, PLACE].map(|part| 0.5 * ((1.0 - part) * widest.left + (1.0 + part) * widest.right))
    };
    let contacts = solution.contacts().first().map(Contact::of_each_punch).unwrap_or_default();
    let places: Vec<[f64; 2]> = contacts.iter().map(touching).collect();
    // one sum for all
    let moved = Field::new(stack, solution).grid(&places.concat(), &[0.0])?;
    let of = |(k, ((pressed, _), places)): (usize, ((&Pressed, f64), &[f64; 2]))| {
        let tilt = solution.punches().get(k).map_or(0.0, |carried| carried.tilt);
        let lowest = pressed.shape().shape().lowest();
        let [left, right] = [0, 1].map(|side| {
            let from_tip = places[side] - pressed.at();
            pressed.shape().profile(from_tip) - lowest + tilt * from_tip - moved.points()[2 * k + side].v
        });
        let (value, error) = (0.5 * (left + right), (left - right).abs());
        Approach { value, error: SAFETY * (error + relative * value.abs()), stiffness: Stiffness::NotComputed }
    };
    Ok(punches.parts().zip(&places).enumerate().map(of).collect())
}

/// The approach and the stiffness.
pub(crate) fn approach(
    top: &Top,
    stack: &Stack,
    kernel: &Kernel,
    solution: &Solution,
) -> Result<Approach, ApproachError> {
    let punch = defined(top, stack)?;
    let lowest = punch.shape().lowest();
    let [value, second] = sunk(|x| punch.profile(x) - lowest, punch, kernel, solution);
    let relative = ROUNDING + relative_error(solution, true);
    let error = SAFETY * ((value - second).abs() + relative * value.abs());
    let stiffness = match contact::tangent(kernel, top, solution) {
        Some(Ok(tangent)) => stiffness(punch, kernel, solution, &tangent),
        Some(Err(ContactError::Unresolved(cause))) => return Err(FieldError::Unresolved(cause).into()),
        Some(Err(_)) | None => Stiffness::NotComputed,
    };
    Ok(Approach { value, error, stiffness })
}

/// The stiffness from the pressures that a unit force adds.
fn stiffness(punch: &Punch, kernel: &Kernel, solution: &Solution, tangent: &Solution) -> Stiffness {
    let [compliance, second] = sunk(|_| 0.0, punch, kernel, tangent);
    let contacts = solution.contacts().iter().zip(tangent.contacts()).enumerate();
    // an end that moves by da changes the compliance by 2πa q²/E* da, with the singular pressure q/√(1 − x²/a²): the energy release
    // rate of a crack that closes
    let ends = contacts.map(|(i, (contact, tangent))| {
        let corners: f64 = tangent.strips.iter().map(|strip| strip.corners[1]).sum();
        let (a, error) = (contact.half_length().unwrap_or(0.0), contact.half_length_error().unwrap_or(0.0));
        let around = if kernel.geometry().is_axisymmetric() { PI * a } else { 1.0 };
        2.0 * PI * around * a * corners * corners / kernel.contact_modulus(i) * error
    });
    let relative = ROUNDING + relative_error(tangent, false);
    let error = SAFETY * (ends.sum::<f64>() + (compliance - second).abs() + relative * compliance.abs());
    let value = compliance.recip();
    let is_known = compliance > 0.0 && value.is_finite();
    if is_known { Stiffness::Known { value, error: error * value * value } } else { Stiffness::NotComputed }
}

/// The sum of the errors of all pressures, as parts of the mean pressures, and with `ends` also of the half-lengths.
fn relative_error(solution: &Solution, ends: bool) -> f64 {
    let of = |contact: &Contact| {
        let ([_, pressure], end) = (contact.middle_pressure, contact.end_error());
        let length: f64 = contact.intervals().iter().map(|one| one.right - one.left).sum();
        length * pressure / contact.resultant + if ends { end } else { 0.0 }
    };
    solution.contacts().iter().map(of).filter(|error| error.is_finite()).sum::<f64>()
}

/// How far a punch has sunk into the top face, twice: with two means over the middle of each contact. They differ by the errors of the
/// pressures.
fn sunk(profile: impl Fn(f64) -> f64, punch: &Punch, kernel: &Kernel, solution: &Solution) -> [f64; 2] {
    let kernel =
        punch.material().map_or(Cow::Borrowed(kernel), |material| Cow::Owned(kernel.under_half_plane(&material)));
    // places count from the tip, in units of L
    let (tip, length) = (solution.about().unwrap_or(0.0), kernel.length());
    let window = |contact: &Contact| {
        let [middle, _] = contact.touching();
        MeanWindow { middle: (middle - tip) / length, half: (contact.innermost().right - middle) / length }
    };
    let mut windows: Vec<MeanWindow> = solution.contacts().iter().map(window).collect();
    MeanWindow::equalise(&mut windows);
    let ends: Vec<f64> = solution.contacts().iter().map(|contact| contact.half_span() / length).collect();
    let is_round = kernel.geometry().is_axisymmetric();
    let starts: Vec<f64> = punch.shape().starts().iter().map(|start| start / length).collect();
    let mut sunk = windows.first().map_or([0.0; 2], |top| top.of_profile(is_round, |x| profile(x * length), &starts));
    let unit = kernel.modulus() * if is_round { length } else { 1.0 };
    let pressure = |contact| ContactPressure::new(contact, true, tip);
    let pressures: Vec<ContactPressure> = solution.contacts().iter().map(pressure).collect();
    kernel.depth(&windows, &ends, (NEGLIGIBLE, 2), |own| {
        let wavenumbers: Vec<f64> = own.zeta.iter().map(|zeta| zeta / length).collect();
        let pressure = &pressures[own.contact];
        let transforms = pressure.transforms(&wavenumbers).into_iter();
        let variations: Vec<f64> = transforms.map(|transform| transform.variation.re).collect();
        for (mean, sunk) in sunk.iter_mut().enumerate() {
            let weights = own.all[mean].iter().zip(&own.resultant[mean]).zip(own.zeta);
            let of =
                |(((all, of), zeta), own): (((&f64, &f64), &f64), &f64)| zeta * (all * own + of * pressure.resultant());
            *sunk += weights.zip(&variations).map(of).sum::<f64>() / unit;
        }
    });
    sunk
}
