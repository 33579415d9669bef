//! Where Newton's method starts: half-lengths from formulas of contact mechanics, right to some ten per cent.
use crate::contact::problem::accuracy::COARSE;
use crate::contact::problem::load::Given;
use crate::contact::problem::placed::Placed;
use crate::contact::problem::profile::PunchProfile;
use crate::contact::problem::twin::Twin;
use crate::contact::problem::{Expected, Prescribed, Problem, Side};
use crate::kernel::Kernel;
use crate::numeric::longest;
use crate::scene::{Gap, Punch, Top};
use crate::solution::Interface;
use std::f64::consts::{LN_2, PI};

/// Half-length of the contact of a strip of thickness 1 that a line load presses on a rigid base.
const ON_RIGID_BASE: f64 = 0.857;
/// Half-length of the contact of a plate that a line load presses on a half-plane so soft that nothing matters but how the
/// plate bends, in units of (D/E*)^(1/3).
const ON_SOFT_BASE: f64 = 2.804;
/// The same under a point load in the axisymmetric case: radii.
const ROUND: [f64; 2] = [1.093, 3.70];
/// What lies between is the sum of both in this power, to 1.5 per cent for a strip on a half-plane of any stiffness.
const BETWEEN: f64 = 3.4;
/// The wavenumber that stands for a pressure of half-length a is this over a.
pub(crate) const TYPICAL: f64 = 1.2;

/// The mean of a profile about the middle of a contact is about its height there, in half-lengths.
const MEAN: f64 = 0.2;
/// The transform of Hertz's pressure times the mean of a wave is about exp(−z²/7), z = ζa.
const BELL: f64 = 1.0 / 7.0;
/// Binary logarithms of the longest and the shortest waves by which a depth is estimated, times the half-length.
const LONGEST: i32 = -20;
const SHORTEST: i32 = 3;

/// The force P' at which the contact under a punch, the uppermost one, is expected to have a half-length (in units of L), for
/// an indentation by P' = 1.
pub(crate) fn force(kernel: &Kernel, profile: &PunchProfile, half_length: f64) -> f64 {
    force_on(kernel, profile, half_length, Kernel::closed)
}

/// The same on a stack with another compliance at a wavenumber.
fn force_on(
    kernel: &Kernel,
    profile: &PunchProfile,
    half_length: f64,
    compliance: impl Fn(&Kernel, f64) -> f64,
) -> f64 {
    let twin = Twin::of(kernel.geometry());
    twin.force_under(profile.first_row(half_length), half_length, compliance(kernel, TYPICAL / half_length))
}

/// The length of the contact itself, in the unit of the scene, where the stack has none: the length of a given pressure, or what
/// Hertz's formula expects. `None` if the stack has a length, or if nothing has one, as a line load on a half-plane.
pub(crate) fn length(kernel: &Kernel, (top, gaps): (&Top, &[(Interface, Gap)]), force: f64) -> Option<f64> {
    if !kernel.has_no_length() {
        return None;
    }
    let length = match top {
        Top::Loads(loads) => loads.reach(),
        Top::Punches(_) => kernel.length() * half_lengths(&Problem::new(kernel, &[], (top, gaps, None), force, 0.0))[0],
    };
    (length.is_normal() && length > 0.0).then_some(length)
}

/// The force, in the unit of the scene, under which the contact of a symmetric punch is expected to have a half-length; not a normal number where doubles do not hold it.
pub(crate) fn force_for_half_length(kernel: &Kernel, punch: &Punch, half_length: f64) -> f64 {
    let (twin, length) = (Twin::of(kernel.geometry()), kernel.length());
    let (profile, half_length) = (PunchProfile::new(punch, length, 1.0, twin), half_length / length);
    let force = force(kernel, &profile, half_length);
    // where a wave as long would lift what bends: the faces alone
    let of_faces = || profile.first_row(half_length) * half_length / kernel.asymptote(0).limit;
    twin.total_force(if force.is_normal() && force > 0.0 { force } else { of_faces() }, kernel.modulus(), length)
}

/// The force, in the unit of the scene, under which a symmetric punch is expected to sink so far, and whether its contact is expected to reach the edge of the punch.
pub(crate) fn force_for_depth(kernel: &Kernel, punch: &Punch, depth: f64) -> (f64, bool) {
    let (twin, length) = (Twin::of(kernel.geometry()), kernel.length());
    let (profile, depth) = (PunchProfile::new(punch, length, 1.0, twin), depth / length);
    let total = |force: f64| twin.total_force(force, kernel.modulus(), length);
    if let Some(half_length) = profile.flat() {
        return (total(depth / moved(kernel, half_length)), false);
    }
    let sunk = |half_length: f64| {
        profile.height_above_lowest(MEAN * half_length)
            + force(kernel, &profile, half_length) * moved(kernel, half_length)
    };
    let half_length = where_one(&profile, |half_length| sunk(half_length) / depth);
    let is_small = profile.edge().is_some_and(|edge| sunk((1.0 - COARSE) * edge) <= depth);
    (total(force(kernel, &profile, half_length)), is_small)
}

/// How far a pressure with P' = 1 on a contact, about as Hertz's, moves the faces of the closed stack towards each other about its middle, in units of L.
fn moved(kernel: &Kernel, half_length: f64) -> f64 {
    let twin = Twin::of(kernel.geometry());
    let part = if twin == Twin::Round { LN_2 } else { LN_2 / PI };
    let waves = (LONGEST..=SHORTEST).map(|power| f64::from(power).exp2() / half_length);
    let of = |zeta: f64| kernel.closed(zeta) * (-BELL * (zeta * half_length).powi(2)).exp() * twin.measure(zeta);
    part * waves.map(of).sum::<f64>()
}

/// Half-lengths in units of L, from the top down.
pub(crate) fn half_lengths(problem: &Problem) -> Vec<f64> {
    let mut half_lengths: Vec<f64> = Vec::with_capacity(problem.contacts());
    for (i, side) in problem.sides.iter().enumerate() {
        half_lengths.push(match side {
            Side::Known(given) => given.half_length,
            Side::Punches(all) if i == 0 => {
                all.iter().map(|punch| longest(under(problem.kernel, punch))).fold(0.0, f64::max)
            }
            _ => half_length(problem, i)
                .unwrap_or_else(|| half_lengths[i - 1].hypot(carried(problem.kernel, i - 1)).min(in_gap(problem, i))),
        });
    }
    half_lengths
}

/// The half-length under an even punch; `None` for others.
fn half_length(problem: &Problem, contact: usize) -> Option<f64> {
    match &problem.sides[contact] {
        Side::Profile(profile) if contact == 0 => problem
            .prescribed_end()
            .or_else(|| Some(profile.flat().unwrap_or_else(|| under_punch(problem.kernel, profile, Kernel::closed)))),
        _ => None,
    }
}

/// The half-length of a contact that closes a gap, by Hertz on the bodies at its faces; infinite where there was no gap.
fn in_gap(problem: &Problem, contact: usize) -> f64 {
    let at_faces = |kernel: &Kernel, zeta: f64| kernel.compliances(zeta)[contact];
    let of = |profile: &PunchProfile| profile.flat().unwrap_or_else(|| under_punch(problem.kernel, profile, at_faces));
    match &problem.sides[contact] {
        Side::Profile(profile) => of(profile),
        Side::Punches(all) => all.iter().map(|gap| of(&gap.alone())).fold(f64::INFINITY, f64::min),
        _ => f64::INFINITY,
    }
}

/// Where contacts may be that are not even: under each punch as by itself, below each load or contact as far as it would touch by itself, as one where
/// these overlap.
pub(crate) fn anywhere(problem: &Problem) -> Vec<Expected> {
    let mut above: Vec<[f64; 2]> = problem.sides[0].given().map(Given::places).unwrap_or_default();
    let mut all = Vec::new();
    for contact in problem.unknown().filter(|contact| !problem.is_opened(*contact)) {
        let mut own: Vec<[f64; 2]> = Vec::new();
        if let (Side::Punches(punches), 0) = (&problem.sides[contact], contact) {
            let of = |(number, punch): (usize, &Placed)| {
                let held = problem.prescribed.iter().find_map(|(own, prescribed)| match prescribed {
                    Prescribed::End { side, at } if *own == number => Some(side * (at - punch.lowest())),
                    _ => None,
                });
                match held.filter(|half| *half > 0.0) {
                    Some(half) => inside(punch, [punch.lowest() - half, punch.lowest() + half]),
                    None => under(problem.kernel, punch),
                }
            };
            own = punches.iter().enumerate().map(of).collect();
            all.extend(own.iter().enumerate().map(|(punch, ends)| Expected { contact, punch, ends: *ends }));
        } else if let Some(half) = half_length(problem, contact) {
            own = vec![[-half, half]];
            all.push(Expected { contact, punch: 0, ends: own[0] });
        } else {
            let (carried, in_gap) = (carried(problem.kernel, contact - 1), in_gap(problem, contact));
            for [left, right] in &above {
                let (middle, half) = (0.5 * (left + right), (0.5 * (right - left)).hypot(carried).min(in_gap));
                match own.last_mut().filter(|last| middle - half <= last[1]) {
                    Some(last) => last[1] = last[1].max(middle + half),
                    None => own.push([middle - half, middle + half]),
                }
            }
            all.extend(own.iter().map(|ends| Expected { contact, punch: 0, ends: *ends }));
        }
        above = own;
    }
    all
}

/// From where to where the contact under a punch anywhere is expected: about the line of action of a force that may turn it, or about its lowest place. A flat punch is touched
/// over its whole width, or, as on a half-plane, from a corner to three times as far beyond a force in the outer quarter of it.
fn under(kernel: &Kernel, punch: &Placed) -> [f64; 2] {
    let (middle, ends) = (punch.line_of_action().unwrap_or_else(|| punch.lowest()), punch.ends());
    if punch.corner(1.0).is_some() {
        let [from_left, from_right] = ends.map(|end| 4.0 * (middle - end));
        return [ends[0].max(ends[1] + from_right), ends[1].min(ends[0] + from_left)];
    }
    let half = under_punch(kernel, &punch.alone(), Kernel::closed);
    inside(punch, [middle - half, middle + half])
}

/// The nearest places on a punch, next to its edges.
fn inside(punch: &Placed, [left, right]: [f64; 2]) -> [f64; 2] {
    let of =
        |x: f64, end: f64| if (x - punch.at()).abs() < (end - punch.at()).abs() { x } else { 0.5 * (end + punch.at()) };
    let ends = punch.ends();
    [of(left, ends[0]), of(right, ends[1])]
}

/// Half-length of the contact below a laminate (in units of L) that a line load presses.
pub(crate) fn carried(kernel: &Kernel, laminate: usize) -> f64 {
    let (thickness, rigidity) = kernel.laminates()[laminate];
    let [on_rigid_base, on_soft_base] = match Twin::of(kernel.geometry()) {
        Twin::Plane => [ON_RIGID_BASE, ON_SOFT_BASE],
        Twin::Round => ROUND,
    };
    let mut local = on_rigid_base * thickness;
    for _ in 0..4 {
        let zeta = TYPICAL / local;
        let below = (kernel.compliances(zeta)[laminate + 1] - kernel.equal_pressure_bottom(laminate, zeta)).max(0.0);
        let soft = on_soft_base * (0.5 * rigidity * below).cbrt();
        local = ((on_rigid_base * thickness).powf(BETWEEN) + soft.powf(BETWEEN)).powf(BETWEEN.recip());
    }
    local
}

/// By Hertz, on the compliance that the whole stack has for waves as long as the contact: where [`force_on`] is 1, or next to the edge of a
/// punch under which it is 1 nowhere.
fn under_punch(kernel: &Kernel, profile: &PunchProfile, compliance: impl Fn(&Kernel, f64) -> f64) -> f64 {
    where_one(profile, |half_length| force_on(kernel, profile, half_length, &compliance))
}

/// The half-length, no longer than the punch, at which something that grows with it is 1.
fn where_one(profile: &PunchProfile, grows: impl Fn(f64) -> f64) -> f64 {
    // as far as doubles reach
    let longest = 300.0 * std::f64::consts::LN_10;
    let (mut low, mut high) = (-longest, profile.edge().map_or(longest, f64::ln));
    // the logarithm of the force is nearly linear in the logarithm of the half-length
    let (mut x, mut slope) = (0.0_f64.min(high - 0.3), 2.0);
    let mut last: Option<(f64, f64)> = None;
    while high - low > COARSE {
        let missing = match grows(x.exp()) {
            // where a profile falls, the force on a contact may be negative: far too little
            value if value <= 0.0 => f64::INFINITY,
            value => -value.ln(),
        };
        if missing > 0.0 {
            low = x
        } else {
            high = x
        }
        if let Some((before, was)) = last {
            let secant = (was - missing) / (x - before);
            slope = if secant > 0.0 && secant.is_finite() { secant } else { slope };
        }
        last = missing.is_finite().then_some((x, missing));
        let next = x + missing / slope;
        let inside = low < next && next < high;
        let found = inside && (next - x).abs() < COARSE;
        x = if inside { next } else { 0.5 * (low + high) };
        if found {
            break;
        }
    }
    x.exp()
}
