//! The contact problem: half-lengths and pressures of all contacts, for one punch and force on prepared kernels.
mod admissible;
mod basis;
mod collocation;
mod convex;
mod galerkin;
mod layout;
mod level;
mod newton;
mod pressures;
mod punch;
mod refine;
mod start;
mod tail;

use crate::error::{Error, NoSolution};
use crate::kernel::Kernel;
use crate::options::{Method, Options};
use crate::scene::Punch;
use crate::solution::{Contact, Interface, Solution};

use level::{Level, coefficients};
use punch::Indentation;
use refine::refine;

/// Pressures are resolved so many times better from the outset, one after the other, as next to thin, stiff coatings.
const FINER: [usize; 3] = [1, 8, 32];

/// Half-lengths with larger relative errors are none.
const UNUSABLE: f64 = 0.03;
/// How often a contact that would have to pull is tried again with an end where it would.
const SHORTER: usize = 3;

/// Presses a punch with a force on a stack: the answer in the units of the scene.
pub(crate) fn press(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Punch,
    force: f64,
    options: &Options,
) -> Result<Solution, Error> {
    let with_punch = punch.material().map(|material| kernel.under_half_plane(&material));
    let kernel = with_punch.as_ref().unwrap_or(kernel);
    let indentation = Indentation::new(punch, kernel.length(), force / (kernel.modulus() * kernel.length()));
    if options.method == Method::Collocation {
        return collocation::press(kernel, interfaces, &indentation, options);
    }
    let mut steps = 0;
    from_any_start(kernel, interfaces, &indentation, |half_lengths, finer| {
        let (level, warnings) = refine(kernel, interfaces, &indentation, half_lengths, finer, options, &mut steps)?;
        if level.errors.iter().any(|[half_length, _]| *half_length > UNUSABLE) {
            return Err(newton::not_converged(kernel, &indentation, &level.half_lengths));
        }
        let check = admissible::check(kernel, interfaces, &indentation, &level)?;
        Ok(solution(kernel, interfaces, &indentation, level, check, steps, warnings))
    })
}

/// Solves from half-lengths that formulas expect, and where that fails from those of the convex programme. `solve` is
/// told, too, how much finer to begin.
fn from_any_start(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    mut solve: impl FnMut(Vec<f64>, usize) -> Result<Solution, Error>,
) -> Result<Solution, Error> {
    let expected = start::half_lengths(kernel, indentation)?;
    let mut failure = match solve(expected.clone(), 1) {
        Err(Error::NoSolution(failure)) if !matches!(failure, NoSolution::PunchTooSmall { .. }) => failure,
        decided => return decided,
    };
    let zones = convex::zones(kernel, indentation, &expected);
    let several = |certain: bool| -> Option<Error> {
        let parts = |zones: &convex::Zones| if certain { zones.sure.len() } else { zones.apart.len() };
        // under the middle of the punch there is always contact: a zone too short for the grid says nothing
        let plausible =
            |i: usize, zones: &convex::Zones| i > 0 || zones.apart.first().is_some_and(|part| part[0] == 0.0);
        let mut all = zones.as_ref()?.iter().enumerate();
        let (i, _) = all.find(|(i, zones)| parts(zones) > 1 && plausible(*i, zones))?;
        let parts = zones.as_ref()?[i].hull().iter().map(|part| part.map(|x| x * kernel.length())).collect();
        Some(NoSolution::Parts { interface: interfaces[i], parts }.into())
    };
    if let Some(error) = several(true) {
        return Err(error);
    }
    let ends = expected.iter().enumerate().map(|(i, expected)| {
        let end = zones.as_ref().map_or(0.0, |zones| zones[i].end());
        if end > 0.0 { end } else { *expected }
    });
    let ends: Vec<f64> = ends.collect();
    for finer in FINER {
        let mut half_lengths = ends.clone();
        for _ in 0..SHORTER {
            match solve(half_lengths.clone(), finer) {
                Err(Error::NoSolution(found)) => failure = found,
                decided => return decided,
            }
            // there are roots whose contacts reach past where they should end
            let NoSolution::Tension { interface, x } = failure else { break };
            let Some(pulling) = interfaces.iter().position(|contact| *contact == interface) else { break };
            half_lengths[pulling] = x / kernel.length();
        }
    }
    Err(several(false).unwrap_or(failure.into()))
}

/// The answer in the units of the scene.
fn solution(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    level: Level,
    check: admissible::Check,
    newton_steps: usize,
    warnings: Vec<String>,
) -> Solution {
    let pressure_unit = kernel.modulus() * indentation.force;
    let contacts = interfaces
        .iter()
        .enumerate()
        .map(|(i, interface)| {
            let half_length = level.half_lengths[i] * kernel.length();
            let pressure_unit = pressure_unit * 2.0 / level.half_lengths[i];
            let mut coefficients = coefficients(&level.modes[i]);
            coefficients.iter_mut().for_each(|c| *c *= pressure_unit);
            let peak_pressure = level.peaks[i] * pressure_unit;
            let [length_error, pressure_error] = level.errors[i];
            Contact {
                interface: *interface,
                half_length,
                half_length_error: length_error * half_length,
                peak_pressure,
                peak_pressure_error: if peak_pressure.is_finite() { pressure_error * peak_pressure } else { 0.0 },
                resultant: 0.5 * std::f64::consts::PI * half_length * coefficients[0],
                coefficients,
                found: level.counts[i],
            }
        })
        .collect();
    Solution {
        contacts,
        min_pressure: check.min_pressure * pressure_unit,
        min_gap: check.min_gap * indentation.force * kernel.length(),
        modes: level.counts.iter().copied().max().unwrap_or(0),
        wavenumbers: kernel.samples(),
        newton_steps,
        warnings,
    }
}
