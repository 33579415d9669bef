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

use num_complex::Complex64;

use crate::contact::{self, ContactError};
use crate::field::{ContactPressure, DISPLACEMENTS, Field, FieldError, FieldPoint};
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::numeric::means::MeanWindow;
use crate::scene::{Gap, Pressed, Punch, Punches, Shape, Top};
use crate::solution::{Contact, Interface, Interval, Solution};
use crate::stack::Stack;

/// Two means need not be those in which most is missing.
const SAFETY: f64 = 3.0;
/// Places at which a punch and the top face are compared where layers that weights press together come apart.
const PLACES: usize = 8;
/// Relative error of displacements of the top face inside the stack, the sums of which end at a small part of the pressure.
const SUMMED: f64 = 1e-10;
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
pub(crate) fn of_each(
    top: &Top,
    stack: &Stack,
    kernel: &Kernel,
    solution: &Solution,
) -> Vec<Result<Approach, ApproachError>> {
    match punches(top, stack) {
        Ok(punches) => {
            (0..punches.parts().count()).map(|number| of_one(top, number, stack, kernel, solution)).collect()
        }
        Err(error) => vec![Err(error)],
    }
}

/// The approach of each punch from the displacements of the top face, where layers that weights press together come apart; stiffnesses are not computed then.
pub(crate) fn with_openings(top: &Top, stack: &Stack, solution: &Solution) -> Vec<Result<Approach, ApproachError>> {
    let all = match punches(top, stack) {
        Ok(punches) => punches.parts().zip(solution.contacts()[0].of_each_punch()).enumerate(),
        Err(error) => return vec![Err(error)],
    };
    let field = Field::new(stack, solution);
    let of = |(number, ((pressed, _), contact)): (usize, ((&Pressed, f64), Contact))| {
        let Interval { left, right, .. } = contact.innermost();
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let place = |k: usize| middle + half * (PI * (k as f64 + 0.5) / PLACES as f64).cos();
        let places: Vec<f64> = (0..PLACES).map(place).collect();
        let faces = field.faces(&places, &DISPLACEMENTS)?;
        let (shape, tilt) = (pressed.shape().shape(), solution.punches().get(number).map_or(0.0, |own| own.tilt));
        // the same at all places, but for errors
        let sunk = |(x, point): (&f64, &FieldPoint)| {
            let from_tip = x - pressed.at();
            shape.height(from_tip) + tilt * from_tip - shape.lowest() - point.v
        };
        let sunk: Vec<f64> = places.iter().zip(&faces[0].points).map(sunk).collect();
        let value = sunk.iter().sum::<f64>() / PLACES as f64;
        let spread = largest(sunk.iter().map(|own| (own - value).abs()));
        let error = SAFETY * (spread + (SUMMED + relative_error(solution, true)) * value.abs());
        Ok(Approach { value, error, stiffness: Stiffness::NotComputed })
    };
    all.map(of).collect()
}

/// The approach and the stiffness of the punch, if there is no other one.
pub(crate) fn approach(
    top: &Top,
    stack: &Stack,
    kernel: &Kernel,
    solution: &Solution,
) -> Result<Approach, ApproachError> {
    defined(top, stack)?;
    of_one(top, 0, stack, kernel, solution)
}

/// How far the tip of the punch of this number has moved down since the punch, not turned, touched the top face with its lowest point; and the stiffness if it is even and alone.
fn of_one(
    top: &Top,
    number: usize,
    stack: &Stack,
    kernel: &Kernel,
    solution: &Solution,
) -> Result<Approach, ApproachError> {
    let punch = top.punches().and_then(|punches| punches.parts().nth(number));
    let (pressed, _) = punch.ok_or(ApproachError::Load)?;
    let material = top.material();
    let kernel = material.map_or(Cow::Borrowed(kernel), |material| Cow::Owned(kernel.under_half_plane(&material)));
    let [value, second] = sunk(Some((pressed, &stack.gaps().0)), number, &kernel, solution);
    let relative = ROUNDING + relative_error(solution, true);
    let error = SAFETY * ((value - second).abs() + relative * value.abs());
    let stiffness = match top.even_punch().and_then(|_| contact::tangent(&kernel, top, solution)) {
        Some(Ok(tangent)) => stiffness(&kernel, solution, &tangent),
        Some(Err(ContactError::Unresolved(cause))) => return Err(FieldError::Unresolved(cause).into()),
        Some(Err(_)) | None => Stiffness::NotComputed,
    };
    Ok(Approach { value, error, stiffness })
}

/// The stiffness from the pressures that a unit force adds.
fn stiffness(kernel: &Kernel, solution: &Solution, tangent: &Solution) -> Stiffness {
    let [compliance, second] = sunk(None, 0, kernel, tangent);
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

/// How far a punch, or a flat one, has sunk into the top face, twice: with two means over the middle of each contact. They differ by the errors of the
/// pressures.
fn sunk(
    pressed: Option<(&Pressed, &[(Interface, Gap)])>,
    number: usize,
    kernel: &Kernel,
    solution: &Solution,
) -> [f64; 2] {
    let (length, is_round) = (kernel.length(), kernel.geometry().is_axisymmetric());
    let (all, is_even) = (|| solution.contacts().iter(), solution.about().is_some());
    let mut windows = windows(solution, number);
    // layers between two windows at different places turn
    let turned = windows.windows(2).zip(solution.rotations());
    let turned: f64 = turned.map(|(pair, angle)| angle * (pair[0].middle - pair[1].middle)).sum();
    let mut sunk = [-turned; 2];
    let mut add = |means: [f64; 2]| sunk.iter_mut().zip(means).for_each(|(sunk, mean)| *sunk += mean);
    if let Some((pressed, gaps)) = pressed {
        let tilt = solution.punches().get(number).map_or(0.0, |carried| carried.tilt);
        add(mean_heights(&windows[0], &pressed.shape().shape(), pressed.at(), tilt, is_round));
        for (window, contact) in windows.iter().zip(all()) {
            let gap = gaps.iter().find(|(interface, _)| *interface == contact.interface);
            gap.iter().for_each(|(_, gap)| add(mean_heights(window, &gap.shape(), 0.0, 0.0, is_round)));
        }
    }
    // places count from where all is even, or from the middle of the window under the punch, in units of L
    let from = solution.about().unwrap_or(windows[0].middle);
    for window in &mut windows {
        *window = MeanWindow { middle: (window.middle - from) / length, half: window.half / length };
    }
    let end = |contact: &Contact| largest(contact.ends().map(|end| (end - from).abs() / length));
    let ends: Vec<f64> = all().map(end).collect();
    let unit = kernel.modulus() * if is_round { length } else { 1.0 };
    let pressures: Vec<ContactPressure> = all().map(|contact| ContactPressure::new(contact, is_even, from)).collect();
    for (own, pressure) in kernel.depth(&windows, &ends, (NEGLIGIBLE, 2)).iter().zip(&pressures) {
        let wavenumbers: Vec<f64> = own.zeta.iter().map(|zeta| zeta / length).collect();
        let variations: Vec<Complex64> =
            pressure.transforms(&wavenumbers).into_iter().map(|transform| transform.variation).collect();
        for (mean, sunk) in sunk.iter_mut().enumerate() {
            let of = |k: usize| {
                let even = own.all[mean][k] * variations[k].re + own.resultant[mean][k] * pressure.resultant();
                let moment = pressure.long_waves(wavenumbers[k]).im;
                let odd = own.odd[mean][k] * variations[k].im + own.moment[mean][k] * moment;
                own.zeta[k] * if is_even { even } else { even + odd }
            };
            *sunk += (0..wavenumbers.len()).map(of).sum::<f64>() / unit;
        }
    }
    sunk
}

/// Where displacements are averaged under the punch of this number and below.
fn windows(solution: &Solution, number: usize) -> Vec<MeanWindow> {
    let touching = |(i, contact): (usize, &Contact)| -> Vec<[f64; 2]> {
        if contact.about.is_some() {
            let [middle, right] = [contact.touching()[0], contact.innermost().right];
            return vec![[2.0 * middle - right, right]];
        }
        let of_punch = (i == 0).then(|| contact.of_each_punch().into_iter().nth(number)).flatten();
        of_punch.as_ref().unwrap_or(contact).intervals().iter().map(|own| [own.left, own.right]).collect()
    };
    MeanWindow::on_contacts(&solution.contacts().iter().enumerate().map(touching).collect::<Vec<_>>())
}

/// How much higher than at its lowest point, before it was turned, a punch at a place is on average over a window, or a gap.
fn mean_heights(window: &MeanWindow, shape: &Shape, at: f64, tilt: f64, is_round: bool) -> [f64; 2] {
    let lowest = shape.lowest();
    // powers are not smooth at the tip
    let starts: Vec<f64> = shape.starts().into_iter().chain([0.0]).map(|start| start + at).collect();
    window.of_profile(is_round, |x| shape.height(x - at) - lowest + tilt * (x - at), &starts)
}
