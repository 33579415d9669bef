//! A converged answer counts only if no pressure pulls and no gap is overlapped.
//!
//! The equations for the half-lengths have other roots besides the physical one; the contact problem itself, a convex
//! programme, has one solution only, and these two signs tell it.
use std::f64::consts::{FRAC_PI_2, PI};

use crate::Error;
use crate::error::NoSolution;
use crate::kernel::Kernel;
use crate::solution::Interface;

use super::basis::Basis;
use super::galerkin::{Equations, alternating, order};
use super::layout::{COARSE, Layout};
use super::level::{Level, coefficients};
use super::newton::not_converged;
use super::punch::Indentation;

/// Pressures are looked at in this many places per mode.
const PER_MODE: usize = 3;
/// Gaps are looked at in this many places per contact.
const GAPS: usize = 24;
/// Gaps are sums over so many modes: what the higher ones do is felt next to the edge only, where the pressures tell.
const GAP_MODES: usize = 128;
/// Modes y_m, the first of which is 1, below this are not felt there.
const UNFELT: f64 = 1e-7;
/// What is below zero by less than this part of the largest value is zero.
const ZERO: f64 = 1e-7;

/// The same for gaps, which are found by quadrature and from the lower modes only.
const NO_GAP: f64 = 1e-5;
/// So many times the part of its highest modes a pressure may be wrong anywhere.
const UNRESOLVED: f64 = 10.0;
/// Places around a pull at which the highest modes are looked at.
const NEAR: usize = 4 * PER_MODE;
/// Pressures under a punch that is not smooth pull by no more than this part of the largest.
const PULL: f64 = 1e-6;

/// What the check found, in units of the kernel per unit of P'.
pub(super) struct Check {
    pub(super) min_pressure: f64,
    pub(super) min_gap: f64,
}

/// Smallest pressure inside and smallest gap outside the contacts.
pub(super) fn check(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Indentation,
    level: &Level,
) -> Result<Check, Error> {
    let mut check = Check { min_pressure: pushes(kernel, interfaces, punch, level)?, min_gap: 0.0 };
    for (i, gaps) in gaps(kernel, punch, level)?.into_iter().enumerate() {
        let largest = gaps.iter().fold(0.0, |largest: f64, (_, gap)| largest.max(gap.abs()));
        let little = NO_GAP.max(UNRESOLVED * level.worst_error());
        for (x, gap) in gaps {
            if gap < -little * largest {
                let x = x * kernel.length();
                return Err(NoSolution::Overlap { interface: interfaces[i], x }.into());
            }
            check.min_gap = check.min_gap.min(gap);
        }
    }
    Ok(check)
}

/// Smallest pressure inside the contacts; an error if one pulls by more than its highest modes may feign.
pub(super) fn pushes(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Indentation,
    level: &Level,
) -> Result<f64, Error> {
    let mut min_pressure = 0.0f64;
    for (i, modes) in level.modes.iter().enumerate() {
        let mut pressures = pressures(modes, modes.len());
        let mut largest = pressures.iter().fold(0.0, |largest: f64, p| largest.max(p.abs()));
        if i == 0 && level.corners != 0.0 {
            // as large as in the middle, not as next to the corners
            largest = largest.max(level.corners.abs());
            let places = pressures.len();
            for (place, pressure) in pressures.iter_mut().enumerate() {
                let sine = angle(place, places).sin();
                *pressure += 0.5 * level.corners / PI * (sine.recip() - 2.0 * sine);
            }
        }
        let (place, pressure) = pressures
            .iter()
            .enumerate()
            .fold((0, f64::INFINITY), |least, (k, p)| if *p < least.1 { (k, *p) } else { least });
        let feigned = match level.rest.as_ref().filter(|_| i == 0) {
            // next to where the punch is not smooth pressures are less certain than elsewhere
            Some(rest) => {
                let rest = self::pressures(rest, modes.len());
                let near = place.saturating_sub(NEAR)..(place + NEAR).min(rest.len());
                rest[near].iter().fold(0.0, |most: f64, p| most.max(p.abs()))
            }
            None => level.tails[i] * largest,
        };
        if pressure < -ZERO * largest - UNRESOLVED * feigned {
            let middle = place + 1 == pressures.len();
            let s = if middle { 0.0 } else { angle(place, pressures.len()).cos() };
            let x = s * level.half_lengths[i] * kernel.length();
            return Err(NoSolution::Tension { interface: interfaces[i], x }.into());
        }
        if level.rest.is_some() && i == 0 && pressure < -PULL * largest {
            // it cannot be said whether this is a pull
            return Err(not_converged(kernel, punch, &level.half_lengths));
        }
        min_pressure = min_pressure.min(pressure);
    }
    Ok(min_pressure)
}

/// The angle φ of a place, x = a cos φ.
fn angle(place: usize, places: usize) -> f64 {
    FRAC_PI_2 * (place + 1) as f64 / places as f64
}

/// The pressures at so many places per mode of `resolved`, from the end of the contact to its middle.
fn pressures(modes: &[f64], resolved: usize) -> Vec<f64> {
    let coefficients = coefficients(modes);
    let places = PER_MODE * resolved;
    let at = |place: usize| {
        let phi = angle(place, places);
        // sin(3φ), sin(5φ), ... from sin φ
        let turn = 2.0 * (2.0 * phi).cos();
        let (mut before, mut sine, mut pressure) = (-phi.sin(), phi.sin(), 0.0);
        for c in &coefficients {
            pressure += c * sine;
            (before, sine) = (sine, turn * sine - before);
        }
        pressure
    };
    (0..places).map(at).collect()
}

/// Places x > a (in units of L) outside each contact, and the gap there per unit of P'.
fn gaps(kernel: &Kernel, punch: &Indentation, level: &Level) -> Result<Vec<Vec<(f64, f64)>>, Error> {
    let n = level.half_lengths.len();
    let longest = level.half_lengths.iter().fold(0.0, |a: f64, b| a.max(*b));
    let span = 2.0 * longest + 2.0;
    let felt = |modes: &Vec<f64>| {
        let above = modes.iter().rposition(|y| y.abs() > UNFELT).map_or(1, |last| last + 1);
        modes[..above.min(GAP_MODES)].to_vec()
    };
    let modes: Vec<Vec<f64>> = level.modes.iter().map(felt).collect();
    let mut orders: Vec<usize> = modes.iter().map(|modes| 2 * modes.len()).collect();
    if punch.given().is_some() {
        orders[0] = 0;
    }
    let layout = Layout::new(kernel, &level.half_lengths, &orders, COARSE, span)
        .ok_or_else(|| not_converged(kernel, punch, &level.half_lengths))?;
    let basis = |i: usize| match punch.given().filter(|_| i == 0) {
        Some(given) => Basis::given(&layout, given),
        None => Basis::new(&layout, i, level.half_lengths[i], modes[i].len(), Vec::new()),
    };
    let bases: Vec<Basis> = (0..n).map(basis).collect();
    let counts: Vec<usize> = modes.iter().map(Vec::len).collect();
    let linked = vec![false; n - 1];
    let equations = Equations::new(&layout, &bases, &counts, &linked).with_corners(punch.flat().map(|_| level.corners));
    let transforms = equations.responses(&modes);
    let mut gaps = Vec::with_capacity(n);
    for (i, modes) in modes.iter().enumerate() {
        let (a, limit) = (level.half_lengths[i], layout.own[i].limit);
        let mut end = span;
        if let (0, Some(edge)) = (i, punch.max_half_length()) {
            end = end.min(edge);
        }
        let mut own = Vec::new();
        if i == 0 && (punch.given().is_some() || punch.flat().is_some()) {
            // where nothing presses there is no gap to be looked at
            gaps.push(own);
            continue;
        }
        // next to the contact, and far from it
        for reach in [0.5 * a.min(end - a), end - a] {
            let step = reach / GAPS as f64;
            let rest = deflections(&layout.zeta, &transforms[i][..layout.own[i].reach], a, step);
            own.extend(rest.into_iter().enumerate().map(|(k, rest)| {
                let x = a + step * (k + 1) as f64;
                let t = (x / a).acosh();
                let opened = if i == 0 { punch.profile(x) - punch.profile(a) } else { 0.0 };
                let cauchy: f64 = modes.iter().enumerate().map(|(m, y)| y * cauchy_deflection(m, t)).sum();
                (x, opened - 2.0 * (limit * cauchy + rest) / PI)
            }));
        }
        gaps.push(own);
    }
    Ok(gaps)
}

/// ∫ s(ζ) (cos ζa − cos ζx)/ζ for x = a + step, a + 2 step, ...: neighbouring cosines follow from each other.
fn deflections(zeta: &[f64], slopes: &[f64], a: f64, step: f64) -> Vec<f64> {
    let mut sums = vec![0.0; GAPS];
    for (zeta, slope) in zeta.iter().zip(slopes) {
        let weight = slope / zeta;
        let (sin, cos) = (zeta * a).sin_cos();
        let (sin_step, cos_step) = (zeta * step).sin_cos();
        let mut before = cos;
        let mut here = cos * cos_step - sin * sin_step;
        for sum in &mut sums {
            *sum += weight * (cos - here);
            (before, here) = (here, 2.0 * cos_step * here - before);
        }
    }
    sums
}

/// ∫ from a to x = a cosh t of ∫ J_j(ζa) sin(ζx) dζ/ζ dx / a = (−1)^m/j ∫ e^(−jt) sinh t dt, j = 2m + 1.
fn cauchy_deflection(m: usize, t: f64) -> f64 {
    let j = order(m);
    let first = if m == 0 { t } else { -(-(j - 1.0) * t).exp_m1() / (j - 1.0) };
    let second = -(-(j + 1.0) * t).exp_m1() / (j + 1.0);
    alternating(m) * 0.5 * (first - second) / j
}
