//! A converged level is admissible only if no pressure is in tension and no gap is penetrated (Signorini conditions).
//!
//! The equations for the half-lengths have other roots besides the physical one; the contact problem itself, a quadratic
//! programme, has one solution only, and these two signs tell it.
use crate::contact::problem::accuracy::{COARSE, NO_GAP, PER_MODE, PLACES, SAFETY, ZERO};
use std::f64::consts::{FRAC_PI_2, PI};

use crate::contact::equations::assemble::Equations;
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::integrals::basis::Basis;
use crate::contact::integrals::layout::{FIELDS, Layout};
use crate::contact::problem::Problem;
use crate::contact::problem::abel;
use crate::contact::problem::modes::{COARSEST, FINEST, alternating, order};
use crate::contact::problem::profile::Profile;
use crate::contact::problem::twin::Twin;
use crate::contact::quality::estimates::Level;

use crate::kernel::Kernel;
use crate::numeric::trigonometry::sin_cos;
use crate::numeric::vector::{LANES, vectorised};
use crate::solution::jacobi_sums;

/// A pressure may be wrong anywhere by this many times the part that its highest modes have in it.
const UNRESOLVED: f64 = 10.0;
/// More modes do not change a tension of more than this part of the largest pressure. Twice as much: non-physical roots are
/// refined for longer; half as much: admissible ones may be given up, and are found again from the quadratic programme.
const GROSS: f64 = 0.05;

/// What the check found, in units of the kernel per unit of P'.
#[derive(Default)]
pub(crate) struct Check {
    pub(crate) min_pressure: f64,
    /// Of each contact.
    pub(crate) tensions: Vec<Tension>,
    pub(crate) min_gap: f64,
    /// Intervals of re-contact with next to no force.
    pub(crate) recontacts: Vec<Recontact>,
}

/// The tension in a contact for want of modes.
#[derive(Clone, Copy, Default)]
pub(crate) struct Tension {
    /// As a part of the largest pressure.
    part: f64,
    /// The part of the half-length, up to the end, in which the pressure is hardly larger than the tension elsewhere: where the contact ends
    /// is not known any better.
    end: f64,
}

/// Penetration outside a contact so small that a force next to nothing, in an interval of re-contact, would remove it.
pub(crate) struct Recontact {
    pub(crate) contact: usize,
    /// Where, in units of L.
    pub(crate) x: f64,
    /// The moment of that force about the end of the contact, over force times half-length.
    pub(crate) moment: f64,
    /// The laminate that bends there, between this contact and the next.
    pub(crate) laminate: usize,
}

impl Recontact {
    /// By how much the ends of the contacts of the laminate may move because of it, relative. A pressure that grows like the root of the
    /// distance d from its end has a moment like d^(5/2): hence the power 2/5.
    pub(crate) fn moves(&self) -> f64 {
        self.moment.powf(0.4)
    }
}

impl Level {
    /// Adds to the errors what an answer is seen to be wrong by: tension, and the force in intervals of re-contact, which is left out.
    pub(crate) fn admit(&mut self, check: &Check) {
        for (error, tension) in self.errors.iter_mut().zip(&check.tensions) {
            error.length = error.length.max(tension.end);
            if tension.part > ZERO {
                error.pressure = error.pressure.max(SAFETY * tension.part);
            }
        }
        for recontact in &check.recontacts {
            for error in &mut self.errors[recontact.laminate..=recontact.laminate + 1] {
                error.length += recontact.moves();
            }
            self.errors.iter_mut().for_each(|error| error.pressure += recontact.moment);
        }
    }
}

/// Smallest pressure inside and smallest gap outside the contacts; an error if one of them is negative.
pub(crate) fn check(problem: &Problem, level: &Level) -> Result<Check, ContactError> {
    // no pressure is less certain than the answer
    let most = COARSE.max(level.worst_error());
    let (min_pressure, tensions) = check_pressures(problem, level, most)?;
    let mut check = Check { min_pressure, tensions, min_gap: 0.0, recontacts: Vec::new() };
    for (i, gaps) in gaps(problem, level)?.into_iter().enumerate() {
        if level.support.decay(i).is_some() {
            // beyond a decayed pressure the gap is as small as the pressure
            continue;
        }
        let largest = gaps.iter().fold(0.0, |largest: f64, (_, gap)| largest.max(gap.abs()));
        let allowed = NO_GAP.max(UNRESOLVED * level.worst_error());
        if let Some((first, _)) = gaps.iter().find(|(_, gap)| *gap < -allowed * largest) {
            match recontact(problem.kernel, i, &level.support.half_lengths, &gaps, allowed * largest) {
                Some(recontact) if recontact.moment <= COARSE => check.recontacts.push(recontact),
                _ => {
                    let x = first * problem.kernel.length();
                    return Err(NoSolution::Penetration { interface: problem.interfaces[i], x }.into());
                }
            }
        }
        check.min_gap = gaps.iter().fold(check.min_gap, |least, (_, gap)| least.min(*gap));
    }
    Ok(check)
}

/// The moment that would remove the penetration outside contact i: the more slender of the laminates above and below is a beam there,
/// clamped where its contacts end (3EI/l³ per unit deflection). `None` without a laminate, or if there is penetration of more than
/// `allowed` before.
pub(crate) fn recontact(
    kernel: &Kernel,
    i: usize,
    half_lengths: &[f64],
    gaps: &[(f64, f64)],
    allowed: f64,
) -> Option<Recontact> {
    let laminates = kernel.laminates();
    let neighbours = i.checked_sub(1).into_iter().chain([i]).filter(|laminate| *laminate < laminates.len());
    let laminate = neighbours.min_by(|a, b| laminates[*a].1.total_cmp(&laminates[*b].1))?;
    let (thickness, stiffness) = laminates[laminate];
    let end = half_lengths[laminate].max(half_lengths[laminate + 1]);
    if gaps.iter().any(|(x, gap)| *x <= end && *gap < -allowed) {
        return None;
    }
    let moment = |(x, gap): &(f64, f64)| {
        // no beam is shorter than thick
        let length = (x - end).max(thickness);
        (*x, 3.0 * stiffness * (-gap).max(0.0) / (length * length * end))
    };
    let (x, moment) = gaps.iter().map(moment).max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(Recontact { contact: i, x, moment, laminate })
}

/// Smallest pressure inside the contacts, and the tension of each; an error if that is more than the uncertainty of its highest modes, or
/// more than `most` of its largest pressure.
pub(crate) fn check_pressures(
    problem: &Problem,
    level: &Level,
    most: f64,
) -> Result<(f64, Vec<Tension>), ContactError> {
    let (mut min_pressure, mut tensions) = (0.0f64, Vec::with_capacity(level.modes.len()));
    for (i, side) in problem.sides.iter().enumerate() {
        if side.is_joined() {
            tensions.push(Tension::default());
            continue;
        }
        let least = Least::of(problem.twin(), level, i);
        // where a pressure decays, any tension is a truncation error
        let most = if level.support.decay(i).is_some() { most.min(NO_GAP) } else { most };
        if least.pressure < -ZERO * least.largest - (UNRESOLVED * least.uncertainty).min(most * least.largest) {
            return Err(least.tension(problem, level, i));
        }
        if level.remainders[i].is_some() && least.pressure < -NO_GAP * least.largest {
            // the series is not known well enough there to tell tension from truncation
            return Err(problem.not_converged(&level.support.half_lengths));
        }
        min_pressure = min_pressure.min(least.pressure);
        tensions.push(Tension { part: (-least.pressure / least.largest).max(0.0), end: least.end });
    }
    Ok((min_pressure, tensions))
}

/// An error if a contact is in such tension that more modes will not change that.
pub(crate) fn check_gross_tension(problem: &Problem, level: &Level) -> Result<(), ContactError> {
    for i in problem.unknown().filter(|i| level.remainders[*i].is_none() && !problem.sides[*i].is_joined()) {
        let least = Least::of(problem.twin(), level, i);
        if least.pressure < -GROSS * least.largest {
            return Err(least.tension(problem, level, i));
        }
    }
    Ok(())
}

/// The smallest pressure of a contact.
struct Least {
    pressure: f64,
    /// Where it is: x/a.
    s: f64,
    /// The largest pressure.
    largest: f64,
    /// By how much the highest modes may change the pressure there.
    uncertainty: f64,
    /// The part of the half-length, up to the end, in which pressures are hardly larger than the tension.
    end: f64,
}

impl Least {
    /// The error that says so, where it is tension.
    fn tension(&self, problem: &Problem, level: &Level, i: usize) -> ContactError {
        let length = problem.kernel.length();
        let half_lengths: Vec<f64> = level.support.half_lengths.iter().map(|a| a * length).collect();
        let (interface, x) = (problem.interfaces[i], self.s * half_lengths[i]);
        NoSolution::Tension { interface, x, half_lengths }.into()
    }

    fn of(twin: Twin, level: &Level, i: usize) -> Self {
        let modes = &level.modes[i];
        let mut pressures = pressures(twin, modes, modes.len());
        let mut largest = pressures.iter().fold(0.0, |largest: f64, p| largest.max(p.abs()));
        if let Some(intensity) = level.support.intensity(i) {
            // as large as in the middle, not as next to the corners
            largest = largest.max(intensity.abs());
            let places = pressures.len();
            for (place, pressure) in pressures.iter_mut().enumerate() {
                let sine = angle(place, places).sin();
                *pressure += twin.edge() * intensity / PI * (sine.recip() - 2.0 * twin.norm * sine);
            }
        }
        let least = |least: (usize, f64), (k, p): (usize, &f64)| if *p < least.1 { (k, *p) } else { least };
        let (place, pressure) = pressures.iter().enumerate().fold((0, f64::INFINITY), least);
        let uncertainty = match &level.remainders[i] {
            // next to where the punch is not smooth pressures are less certain than elsewhere
            Some(remainder) => {
                let remainder = self::pressures(twin, remainder, modes.len());
                let near = place.saturating_sub(4 * PER_MODE)..(place + 4 * PER_MODE).min(remainder.len());
                remainder[near].iter().fold(0.0, |most: f64, p| most.max(p.abs()))
            }
            None => level.tails[i] * largest,
        };
        let is_middle = place + 1 == pressures.len();
        let s = |place: usize| angle(place, pressures.len()).cos();
        let end = match pressures.iter().position(|own| *own > -SAFETY * pressure) {
            // the corner of a flat punch is known
            _ if pressure >= 0.0 || level.support.intensity(i).is_some() => 0.0,
            // next to the end
            Some(0) => 0.0,
            Some(first) => 1.0 - s(first),
            None => 1.0,
        };
        Self { pressure, s: if is_middle { 0.0 } else { s(place) }, largest, uncertainty, end }
    }
}

/// The angle φ of a place, x = a cos φ.
fn angle(place: usize, places: usize) -> f64 {
    FRAC_PI_2 * (place + 1) as f64 / places as f64
}

/// The pressures at [`PER_MODE`] places per mode of `resolved`, from the end of the contact to its middle.
fn pressures(twin: Twin, modes: &[f64], resolved: usize) -> Vec<f64> {
    let coefficients = twin.coefficients(modes);
    let places = PER_MODE * resolved;
    let mut pressures = vec![0.0; places];
    vectorised(
        #[inline(always)]
        || {
            for (block, out) in pressures.chunks_mut(LANES).enumerate() {
                let phi: [f64; LANES] = std::array::from_fn(|lane| angle(block * LANES + lane, places));
                let (mut sine, cosine) = sin_cos(&phi);
                if twin == Twin::Round {
                    out.copy_from_slice(&jacobi_sums(&coefficients, cosine)[..out.len()]);
                    continue;
                }
                // sin(3φ), sin(5φ), ... from sin φ
                let turn: [f64; LANES] = std::array::from_fn(|lane| 4.0 * cosine[lane] * cosine[lane] - 2.0);
                let [mut before, mut pressure] = [sine.map(|sine| -sine), [0.0; LANES]];
                for c in &coefficients {
                    for lane in 0..LANES {
                        pressure[lane] += c * sine[lane];
                        let next = turn[lane] * sine[lane] - before[lane];
                        before[lane] = sine[lane];
                        sine[lane] = next;
                    }
                }
                out.copy_from_slice(&pressure[..out.len()]);
            }
        },
    );
    pressures
}

/// The slope transforms of all contacts at real wavenumbers that resolve fields out to the span.
fn transforms(problem: &Problem, level: &Level, modes: &[Vec<f64>]) -> Option<Waves> {
    let half_lengths = &level.support.half_lengths;
    let span = problem.span(half_lengths);
    let counts: Vec<usize> = modes.iter().map(Vec::len).collect();
    let layout = Layout::new(problem.kernel, half_lengths, &problem.orders(&counts), FIELDS, span)?;
    let bases = Basis::all(&layout, problem, half_lengths, &counts);
    let strong = vec![false; counts.len() - 1];
    let equations = Equations::new(&layout, &bases, &counts, &strong, &level.support);
    let mut slopes = equations.responses(modes);
    slopes.iter_mut().zip(&layout.own).for_each(|(slopes, own)| slopes.resize(own.reach, 0.0));
    let limits = layout.own.iter().map(|own| own.limit).collect();
    Some(Waves { zeta: layout.zeta, limits, slopes })
}

/// What is needed of the equations to find gaps.
struct Waves {
    zeta: Vec<f64>,
    /// g∞ of each contact.
    limits: Vec<f64>,
    /// Slope transforms, weights included and g∞ left out.
    slopes: Vec<Vec<f64>>,
}

/// Places x > a (in units of L) outside each contact, and the gap there per unit of P'.
fn gaps(problem: &Problem, level: &Level) -> Result<Vec<Vec<(f64, f64)>>, ContactError> {
    let truncated = |most: usize| -> Vec<Vec<f64>> {
        let own = |modes: &Vec<f64>| {
            let above = modes.iter().rposition(|y| y.abs() > ZERO).map_or(1, |last| last + 1);
            modes[..above.min(most)].to_vec()
        };
        level.modes.iter().map(own).collect()
    };
    // fewer where contacts are of such different lengths that tables would not fit in memory
    let most = std::iter::successors(Some(FINEST / 4), |most| Some(most / 2)).take_while(|most| *most >= COARSEST);
    let found = most.into_iter().find_map(|most| {
        let modes = truncated(most);
        transforms(problem, level, &modes).map(|waves| (modes, waves))
    });
    let (modes, waves) = found.ok_or_else(|| problem.not_converged(&level.support.half_lengths))?;
    Ok((0..modes.len()).map(|i| gaps_outside(problem, level, i, &modes[i], &waves)).collect())
}

/// Places outside contact i, and the gap there; none outside a given pressure or a flat punch.
fn gaps_outside(problem: &Problem, level: &Level, i: usize, modes: &[f64], waves: &Waves) -> Vec<(f64, f64)> {
    let side = &problem.sides[i];
    if problem.is_known(i) || side.is_flat() {
        return Vec::new();
    }
    let (a, limit) = (level.support.half_lengths[i], waves.limits[i]);
    let mut end = problem.span(&level.support.half_lengths);
    if let Some(edge) = side.edge() {
        end = end.min(edge);
    }
    // next to the contact, and far from it
    let mut steps = [0.5 * a.min(end - a), end - a].map(|reach| reach / PLACES as f64);
    let fall = side.profile().map_or(0.0, Profile::last_fall) - a;
    if fall > 0.0 {
        // such steps that one of them ends where the profile is lowest
        steps[1] = fall / (fall / steps[1]).ceil().min(PLACES as f64);
    }
    let regular = vectorised(
        #[inline(always)]
        || deflections(&waves.zeta, &waves.slopes[i], a, steps),
    );
    let mut gaps = Vec::with_capacity(2 * PLACES);
    for (step, regular) in steps.into_iter().zip(regular) {
        let places: [f64; PLACES] = std::array::from_fn(|k| a + step * (k + 1) as f64);
        let of = |elastic: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
            (0..PLACES).map(|k| (places[k], side.height(places[k]) - side.height(a) - elastic(k))).collect()
        };
        gaps.extend(match problem.twin() {
            Twin::Plane => of(&|k| 2.0 * (limit * cauchy_deflection(modes, places[k] / a) + regular[k]) / PI),
            // the modes themselves bring nothing to the transform beyond a
            Twin::Round => {
                let transformed = of(&|k| 2.0 * regular[k]);
                places.into_iter().zip(abel::gaps(a, &transformed)).collect()
            }
        });
    }
    gaps
}

/// ∫ s(ζ) (cos ζa − cos ζx)/ζ for x = a + step, a + 2 step, ... with each of two steps: neighbouring cosines follow from
/// each other.
#[inline(always)]
fn deflections(zeta: &[f64], slopes: &[f64], a: f64, steps: [f64; 2]) -> [[f64; PLACES]; 2] {
    let mut parts = [[[0.0; LANES]; PLACES]; 2];
    for (zetas, slopes) in zeta.chunks(LANES).zip(slopes.chunks(LANES)) {
        // nothing where there are none left
        let [mut zeta, mut weight] = [[0.0; LANES]; 2];
        for (lane, (wave, slope)) in zetas.iter().zip(slopes).enumerate() {
            (zeta[lane], weight[lane]) = (*wave, slope / wave);
        }
        let (sin, cos) = sin_cos(&zeta.map(|zeta| zeta * a));
        for (parts, step) in parts.iter_mut().zip(steps) {
            let (sin_step, cos_step) = sin_cos(&zeta.map(|zeta| zeta * step));
            let (mut before, mut here) = (cos, cos);
            for lane in 0..LANES {
                here[lane] = cos[lane] * cos_step[lane] - sin[lane] * sin_step[lane];
            }
            for part in parts {
                let mut next = [0.0; LANES];
                for lane in 0..LANES {
                    part[lane] += weight[lane] * (cos[lane] - here[lane]);
                    next[lane] = 2.0 * cos_step[lane] * here[lane] - before[lane];
                }
                (before, here) = (here, next);
            }
        }
    }
    parts.map(|parts| parts.map(|part| part.iter().sum()))
}

/// Σ y_m ∫ from a to x of ∫ J_j(ζa) sin(ζx) dζ/ζ dx / a = (−1)^m/j ∫ e^(−jt) sinh t dt, x = a cosh t, j = 2m + 1.
fn cauchy_deflection(modes: &[f64], ratio: f64) -> f64 {
    let t = ratio.acosh();
    let square = (-2.0 * t).exp();
    // (1 − e^(−kt))/k for k = j − 1, and its limit
    let (mut first, mut power, mut sum) = (t, 1.0, 0.0);
    for (m, y) in modes.iter().enumerate() {
        power *= square;
        let second = (1.0 - power) / (order(m) + 1.0);
        sum += alternating(m) * 0.5 * (first - second) / order(m) * y;
        first = second;
    }
    sum
}
