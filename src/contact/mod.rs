//! The contact problem: half-lengths and pressures of all contacts, for one punch and force on prepared kernels.
mod admissible;
mod basis;
mod collocation;
mod galerkin;
mod layout;
mod level;
mod newton;
mod pressures;
mod punch;
mod refine;
mod start;

use crate::error::{Error, NoSolution};
use crate::kernel::{self, Kernel};
use crate::options::{Method, Options};
use crate::scene::Punch;
use crate::solution::{Contact, Interface, Solution, Stats};

use level::{Level, coefficients};
use newton::Converged;
use punch::Indentation;
use refine::refine;

/// What is tried one after the other until a root is admissible: receding contacts from multiples of what the formulas
/// say, then pressures that are resolved better from the outset, as next to thin, stiff coatings.
const ATTEMPTS: [(f64, usize); 7] = [(1.0, 1), (0.4, 1), (2.0, 1), (0.15, 1), (5.0, 1), (1.0, 8), (1.0, 32)];

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
    let indentation = Indentation::new(punch, kernel, force);
    if punch.load().is_some() && options.method == Method::Collocation {
        return Err(Error::LoadByCollocation);
    }
    if options.method == Method::Collocation {
        let starts = start::half_lengths(kernel, &indentation)?;
        return collocation::press(kernel, interfaces, indentation, &starts, options);
    }
    solve(kernel, interfaces, &indentation, options)
}

/// Starts from formulas, and refines until the answer is admissible and good enough.
fn solve(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
) -> Result<Solution, Error> {
    let starts = start::half_lengths(kernel, indentation)?;
    let mut work = newton::Work::default();
    if indentation.given().is_some() && starts.len() == 1 {
        // nothing is unknown
        let level = Level::new(Converged::known(starts), kernel, indentation, 0.0);
        let check = admissible::Check { min_pressure: 0.0, min_gap: 0.0 };
        return Ok(solution(kernel, interfaces, indentation, level, check, work, Vec::new()));
    }
    first_admissible(&starts, &ATTEMPTS, |half_lengths, finer, root| {
        // a root that was found needs no finer start
        if root && finer > 1 {
            return None;
        }
        let found = refine(kernel, interfaces, indentation, half_lengths, finer, options, &mut work);
        Some(found.and_then(|(level, warnings)| {
            let check = admissible::check(kernel, interfaces, indentation, &level)?;
            Ok(solution(kernel, interfaces, indentation, level, check, work.clone(), warnings))
        }))
    })
}

/// Tries multiples of the receding half-lengths one after the other until an answer is admissible, or the punch too
/// small. `solve` is told how much finer to begin and whether a root was found before; it may pass.
fn first_admissible(
    starts: &[f64],
    attempts: &[(f64, usize)],
    mut solve: impl FnMut(Vec<f64>, usize, bool) -> Option<Result<Solution, Error>>,
) -> Result<Solution, Error> {
    let mut failure: Option<NoSolution> = None;
    for &(factor, finer) in attempts {
        // a single contact has no receding ones to start differently
        if starts.len() == 1 && factor != 1.0 {
            continue;
        }
        let half_lengths = starts.iter().enumerate().map(|(i, a)| if i == 0 { *a } else { a * factor }).collect();
        let root = !matches!(failure, None | Some(NoSolution::NotConverged { .. }));
        match solve(half_lengths, finer, root) {
            // a root that is not admissible says more than none
            Some(Err(Error::NoSolution(found))) if !matches!(found, NoSolution::PunchTooSmall { .. }) => {
                failure = failure.filter(|_| root).or(Some(found));
            }
            Some(decided) => return decided,
            None => {}
        }
    }
    Err(failure.unwrap_or(NoSolution::NotConverged { half_lengths: starts.to_vec() }).into())
}

/// What it took to evaluate the stack.
fn stats(kernel: &Kernel) -> Stats {
    let kernel::Work { wavenumbers, layers, unfelt } = kernel.work();
    let (dropped, merged) = (kernel.dropped(), kernel.merged());
    Stats { dropped, merged, wavenumbers, layers, unfelt, uncoupled: kernel.uncoupled_values(), ..Stats::default() }
}

/// The answer in the units of the scene.
fn solution(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    level: Level,
    check: admissible::Check,
    work: newton::Work,
    warnings: Vec<String>,
) -> Solution {
    let pressure_unit = kernel.modulus() * indentation.force;
    let contacts = interfaces
        .iter()
        .enumerate()
        .map(|(i, interface)| {
            let extent = level.half_lengths[i] * kernel.length();
            let pressure_unit = pressure_unit * 2.0 / level.half_lengths[i];
            let mut coefficients = coefficients(&level.modes[i]);
            coefficients.iter_mut().for_each(|c| *c *= pressure_unit);
            let mut peak_pressure = level.peaks[i] * pressure_unit;
            let mut half_length = extent;
            if let (0, Some((load, _))) = (i, indentation.load(0)) {
                let resultant = indentation.force * kernel.modulus() * kernel.length();
                (half_length, peak_pressure) = (load.half_width(), load.peak_pressure(resultant));
            }
            let [length_error, pressure_error] = level.errors[i];
            Contact {
                interface: *interface,
                half_length,
                half_length_error: length_error * half_length,
                peak_pressure,
                peak_pressure_error: if peak_pressure.is_finite() { pressure_error * peak_pressure } else { 0.0 },
                resultant: 0.5 * std::f64::consts::PI * extent * coefficients[0],
                coefficients,
                found: level.counts[i],
                extent,
            }
        })
        .collect();
    Solution {
        contacts,
        min_pressure: check.min_pressure * pressure_unit,
        min_gap: check.min_gap * indentation.force * kernel.length(),
        stats: Stats {
            modes: level.counts,
            newton_steps: work.steps,
            factorisations: work.factorisations,
            interpolated: work.interpolated,
            ..stats(kernel)
        },
        warnings,
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

    use super::punch::Given;
    use super::*;
    use crate::stack::Stack;

    #[test]
    fn the_pressure_of_a_punch_given_as_a_load_makes_the_same_contacts() {
        let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
        let graded = Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
        let stack = || Stack::builder(Plane::Strain);
        for stack in [
            stack().layer(strip()).receding().layer(HalfPlane::new(0.5, 0.3).unwrap()),
            stack().layer(graded).receding().layer(strip()).receding().rigid(),
        ] {
            let stack = stack.build().unwrap();
            let (kernel, interfaces, options) = (Kernel::new(&stack).unwrap(), stack.contacts(), Options::default());
            let punch = Punch::parabola(100.0).unwrap();
            for force in [1e-4, 0.02] {
                let expected = press(&kernel, &interfaces, &punch, force, &options).unwrap();
                let top = &expected.contacts[0];
                let given = Given::of(top.half_length / kernel.length(), &top.coefficients);
                let indentation = Indentation::new(&punch, &kernel, force).with(given);
                let found = solve(&kernel, &interfaces, &indentation, &options).unwrap();
                for (found, expected) in found.contacts[1..].iter().zip(&expected.contacts[1..]) {
                    assert!((found.half_length / expected.half_length - 1.0).abs() < 1e-10, "{found:?} {expected:?}");
                    assert!((found.peak_pressure / expected.peak_pressure - 1.0).abs() < 1e-9);
                }
            }
        }
    }
}
