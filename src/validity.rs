//! The limits of linear elasticity: warnings where strains or slopes are no longer small.
use crate::geometry::Geometry;
use crate::kernel::Kernel;
use crate::scene::{Pressed, Punch, Punches, Top};
use crate::solution::{Contact, Interval, Warning, WarningCode};

/// A contact longer than this part of the radius of its punch is long: strains under a cylinder are about a/(4R).
const LONG: f64 = 0.3;
/// Slopes above this are steep: sine and tangent differ by 5 %.
const STEEP: f64 = 0.3;
/// A mean pressure above this part of the modulus of its contact is large: strains are about as large.
const LARGE: f64 = 0.1;
/// Places in each interval at which the slope of a punch is evaluated.
const PLACES: usize = 32;

/// The warnings for the contacts of a stack with this kernel under a punch or load.
pub(crate) fn warnings(top: &Top, kernel: &Kernel, contacts: &[Contact]) -> Vec<Warning> {
    let Some(first) = contacts.first() else { return Vec::new() };
    let each = first.of_each_punch();
    let punches = top.punches().into_iter().flat_map(Punches::parts).zip(&each).enumerate();
    let shape = punches.filter_map(|(k, ((pressed, _), contact))| {
        let name = if each.len() == 1 { "the punch".to_owned() } else { format!("punch {}", k + 1) };
        let [left, right] = contact.ends().map(|end| (end - pressed.at()).abs());
        match radius(pressed.shape()) {
            Some(radius) => long(&name, left.max(right) / radius, kernel.geometry()),
            None => steep(&name, pressed, contact),
        }
    });
    let pressures = contacts.iter().enumerate().filter_map(|(i, contact)| {
        large(&top.contact_name(contact.interface), contact, kernel.geometry(), kernel.contact_modulus(i))
    });
    shape.chain(pressures).collect()
}

/// The radius of a punch that is round all over.
fn radius(punch: &Punch) -> Option<f64> {
    match punch {
        Punch::Cylinder { radius } | Punch::Parabola { radius } => Some(radius.get()),
        Punch::ElasticCylinder(cylinder) => Some(cylinder.radius()),
        Punch::Covered(covered) => Some(covered.radius()),
        _ => None,
    }
}

fn long(name: &str, ratio: f64, geometry: Geometry) -> Option<Warning> {
    let message = format!(
        "the contact under {name} is long: the {} is {ratio:.2} of the radius of the punch, and above {LONG} linear \
         elasticity is an approximation only",
        geometry.words().half_length
    );
    (ratio > LONG).then(|| Warning::new(WarningCode::LongContact, message))
}

/// The steepest place of a punch that is not round, in its contact.
fn steep(name: &str, pressed: &Pressed, contact: &Contact) -> Option<Warning> {
    let (punch, angle) = (pressed.shape(), pressed.tilt().angle().unwrap_or(0.0));
    if punch.is_singular() && !punch.is_sharp() {
        return None;
    }
    let places = |&Interval { left, right, .. }: &Interval| {
        let step = (right - left) / PLACES as f64;
        (0..=PLACES).map(move |k| left + step * k as f64)
    };
    let slopes = contact.intervals().iter().flat_map(places).map(|x| (punch.slope(x - pressed.at()) + angle).abs());
    let steepest = slopes.fold(0.0, f64::max);
    let message = format!(
        "{name} is steep: its slope in the contact is {steepest:.2}, and above {STEEP} linear elasticity is an \
         approximation only"
    );
    (steepest > STEEP).then(|| Warning::new(WarningCode::SteepPunch, message))
}

/// The largest mean pressure of the intervals of a contact, compared with E*.
fn large(name: &str, contact: &Contact, geometry: Geometry, modulus: f64) -> Option<Warning> {
    let mean = |interval: &Interval| interval.force / geometry.size(interval.left, interval.right);
    // a line load has no mean pressure
    let pressures = contact.intervals().iter().map(mean).filter(|mean| mean.is_finite()).fold(0.0, f64::max);
    let ratio = pressures / modulus;
    let message = format!(
        "the pressure of the contact {name} is large: its mean is {ratio:.2} of the modulus E* of the contact, and above {LARGE} \
         linear elasticity is an approximation only"
    );
    (ratio > LARGE).then(|| Warning::new(WarningCode::LargePressure, message))
}
