//! The pressure of a contact as a curve.
use crate::profile::{self, ContactProfile, profile_places};
use crate::scene::{Load, Loads, Punches, Scene};
use crate::solution::{Contact, Interface, Interval, Solution};
use crate::stack::Stack;

/// Pressures that are infinite somewhere are drawn up to so many times their mean.
const HIGHEST_DRAWN: f64 = 6.0;
/// Points of a curve.
const POINTS: usize = 200;

/// Fewest points between two places where a pressure may jump.
const FEWEST: usize = 3;
/// How near to such a place the last point is, in parts of the distance of two.
const INSIDE: f64 = 1e-9;

/// The pressure on each interval of a contact, denser towards its ends, where it falls like a root, with both sides of a jump;
/// where it rises without bound, under a sharp tip and at sharp corners, as far as a multiple of the mean.
pub(super) fn pressure(scene: &Scene, contact: &Contact) -> Vec<Vec<(f64, f64)>> {
    let mut punches = scene.top.punches().into_iter().flat_map(Punches::parts);
    let rises = contact.interface == Interface::Punch && punches.any(|(pressed, _)| pressed.shape().is_singular());
    let [left, right] = contact.ends();
    let mean = contact.resultant / scene.geometry.size(left, right);
    let most = if rises { HIGHEST_DRAWN * mean } else { f64::INFINITY };
    let at = |x: f64| Some(contact.pressure(x)).filter(|pressure| *pressure <= most).unwrap_or(f64::INFINITY);
    let jumps = jumps(scene, contact);
    let of = |&Interval { left, right, .. }: &Interval| {
        let curve: Vec<(f64, f64)> = places(&jumps, left, right).map(|x| (x, at(x))).collect();
        // down to zero at both ends, unless it rises there without bound
        let ends_low = |end: Option<&(f64, f64)>| end.is_some_and(|(_, p)| p.is_finite());
        let first = Some((left, 0.0)).filter(|_| ends_low(curve.first()));
        let last = Some((right, 0.0)).filter(|_| ends_low(curve.last()));
        first.into_iter().chain(curve).chain(last).collect()
    };
    let wide = contact.intervals().iter().filter(|interval| interval.left < interval.right);
    wide.map(of).collect()
}

/// The pressures on interfaces that weights press together, zero in their openings, between two places; none where fields are not known.
pub(super) fn under_weight(stack: &Stack, solution: &Solution, [from, to]: [f64; 2]) -> Vec<Vec<(f64, f64)>> {
    let places = profile_places(solution, Some(from.abs().max(to.abs())), POINTS);
    let places: Vec<f64> = places.into_iter().filter(|x| (from..=to).contains(x)).collect();
    let curve = |own: ContactProfile| {
        let gaps = own.gap.unwrap_or_default().into_iter().chain(std::iter::repeat(0.0));
        let at = |((x, p), gap): ((&f64, f64), f64)| (*x, if gap > 0.0 { 0.0 } else { p });
        places.iter().zip(own.pressure).zip(gaps).map(at).collect()
    };
    profile::under_weight(stack, solution, &places).unwrap_or_default().into_iter().map(curve).collect()
}

/// Places on an interval, denser towards its ends and towards jumps.
fn places(jumps: &[f64], left: f64, right: f64) -> impl Iterator<Item = f64> {
    let inner = jumps.iter().copied().filter(|x| *x > left && *x < right);
    let ends: Vec<f64> = [left].into_iter().chain(inner).chain([right]).collect();
    let count = (POINTS / (ends.len() - 1)).max(FEWEST);
    (1..ends.len()).flat_map(move |k| {
        let [middle, half] = [0.5 * (ends[k - 1] + ends[k]), 0.5 * (1.0 - INSIDE) * (ends[k] - ends[k - 1])];
        (0..=count).map(move |i| middle - half * (std::f64::consts::PI * i as f64 / count as f64).cos())
    })
}

/// Places where a given pressure jumps or begins, ascending.
fn jumps(scene: &Scene, contact: &Contact) -> Vec<f64> {
    let loads = scene.top.loads().filter(|_| contact.interface == Interface::Punch);
    let ends = |(load, at, _): (&Load, f64, f64)| {
        let [inner, outer] = [load.hole(), load.half_width()];
        [at - outer, at - inner, at + inner, at + outer]
    };
    let mut jumps: Vec<f64> = loads.into_iter().flat_map(Loads::parts).flat_map(ends).collect();
    jumps.sort_by(f64::total_cmp);
    jumps.dedup();
    jumps
}

/// Places of the lines on which loads press.
pub(super) fn lines(scene: &Scene) -> Vec<f64> {
    let parts = scene.top.loads().into_iter().flat_map(Loads::parts);
    parts.filter(|(load, ..)| **load == Load::Line).map(|(_, at, _)| at).collect()
}

/// The highest point of a curve, where it is finite.
pub(super) fn highest(curves: &[Vec<(f64, f64)>]) -> f64 {
    curves.iter().flatten().map(|(_, p)| *p).filter(|p| p.is_finite()).fold(0.0, f64::max)
}
