//! The force under which the contact of the punch has a prescribed half-length.
//!
//! The half-length grows with the force: the logarithm of the one is found as a function of that of the other by the secant
//! method, kept between forces known to be too small and too large.
use crate::error::{Error, NoSolution};
use crate::kernel::Kernel;
use crate::options::{Method, Options};
use crate::scene::Punch;
use crate::solution::{Interface, Solution, Stats};

use super::level::BEST;
use super::punch::Indentation;
use super::{Lattice, press, start};

/// The half-length is met to this part of the tolerance.
const MET: f64 = 0.1;
/// Forces tried at most.
const TRIALS: usize = 60;
/// Longest step in the logarithm of the force.
const LONGEST: f64 = 3.0;
/// Half-lengths by which the slope of the first guess is found differ by this, in the logarithm.
const APART: f64 = -1e-3;

/// Presses a punch on a stack until its contact is as long as wanted.
pub(crate) fn press_to(
    kernel: &Kernel,
    lattice: Option<&Lattice>,
    interfaces: &[Interface],
    punch: &Punch,
    half_length: f64,
    options: &Options,
) -> Result<Solution, Error> {
    if punch.load().is_some() {
        return Err(Error::LoadWithHalfLength);
    }
    let unreachable = || Error::from(NoSolution::HalfLength { punch: punch.label(), half_length });
    let flat = punch.shape().flat();
    if half_length <= flat || punch.max_half_length().is_some_and(|edge| half_length >= edge) {
        return Err(unreachable());
    }
    let expected = |half_length: f64| expected(kernel, punch, half_length).ln();
    let mut trial = expected(half_length);
    // d ln P / d ln a
    let mut slope = (expected(half_length * APART.exp()) - trial) / APART;
    let floor = if options.method == Method::Collocation { options.tolerance } else { BEST };
    let enough = MET * options.tolerance.max(floor);
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut last: Option<(f64, f64)> = None;
    let mut all = Stats::default();
    for _ in 0..TRIALS {
        let force = trial.exp();
        if !force.is_normal() {
            break;
        }
        let mut solution = match press(kernel, lattice, interfaces, punch, force, options) {
            Ok(solution) => solution,
            // so much that the punch is too small for it
            Err(Error::NoSolution(NoSolution::PunchTooSmall { .. })) => {
                high = trial;
                trial = if low.is_finite() { 0.5 * (low + high) } else { high - LONGEST };
                continue;
            }
            Err(error) => return Err(error),
        };
        all.newton_steps.append(&mut solution.stats.newton_steps);
        all.factorisations += solution.stats.factorisations;
        all.interpolated += solution.stats.interpolated;
        let Some(found) = solution.contacts.first() else { return Err(unreachable()) };
        let missing = (half_length / found.half_length).ln();
        if let Some((earlier, before)) = last
            && before != missing
        {
            let secant = (trial - earlier) / (before - missing);
            slope = if secant.is_finite() && secant > 0.0 { secant } else { slope };
        }
        if missing.abs() <= enough {
            let relative = found.half_length_error / found.half_length + missing.abs();
            let force_error = slope * relative * solution.force;
            let Stats { newton_steps, factorisations, interpolated, .. } = all;
            let stats = Stats { newton_steps, factorisations, interpolated, ..solution.stats };
            return Ok(Solution { force_error, stats, ..solution });
        }
        if missing > 0.0 {
            low = low.max(trial)
        } else {
            high = high.min(trial)
        }
        last = Some((trial, missing));
        let next = trial + (slope * missing).clamp(-LONGEST, LONGEST);
        trial = if low < next && next < high { next } else { 0.5 * (low + high) };
        if trial == low || trial == high {
            break;
        }
    }
    Err(unreachable())
}

/// The force that Hertz's formula expects, on the compliance that the whole stack has for waves as long as the contact.
fn expected(kernel: &Kernel, punch: &Punch, half_length: f64) -> f64 {
    let with_punch = punch.material().map(|material| kernel.under_half_plane(&material));
    let kernel = with_punch.as_ref().unwrap_or(kernel);
    let unit = kernel.modulus() * kernel.length();
    unit * start::force(kernel, &Indentation::new(punch, kernel, unit), half_length / kernel.length())
}
