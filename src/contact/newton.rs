//! Newton's method for the logarithms of the half-lengths, on more and more modes.
use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::error::NoSolution;
use crate::kernel::Kernel;
use crate::model::Options;
use crate::scene::Punch;
use crate::solution::{Contact, Interface, Solution};
use crate::Error;

use super::admissible;
use super::basis::Basis;
use super::galerkin::{Equations, Galerkin};
use super::layout::Layout;
use super::punch::Indentation;
use super::start;

/// Modes of the coarsest level.
const COARSEST: usize = 8;
/// Modes of the finest level.
const FINEST: usize = 512;
/// Longest step in the logarithm of a half-length.
const LONGEST_STEP: f64 = 0.5;
/// A layout serves half-lengths that differ by this much, in the logarithm.
const LAYOUT_SERVES: f64 = 0.1;
/// What rounding leaves, relative.
const ROUNDING: f64 = 1e-14;
/// Steps per level; the first steps may take three times as many.
const STEPS: usize = 12;
/// A level that converges slowly (for want of modes) is left with the last step shorter than this.
const ROUGHLY: f64 = 1e-2;
/// Farther from the start, in the logarithm of a half-length, Newton's method is lost.
const FARTHEST: f64 = 4.0;
/// Receding contacts start from these multiples of what the formulas say, one after the other, until a root is admissible.
const STARTS: [f64; 5] = [1.0, 0.4, 2.0, 0.15, 5.0];
/// Modes to begin with per half-length in units of the thickness next to it, and at most.
const PER_THICKNESS: f64 = 2.0;
const MOST_COARSE: usize = 64;
/// More wavenumbers than this no admissible scene was seen to need.
const MOST_WAVENUMBERS: usize = 8_000;

/// Half-lengths and pressures at one level of refinement.
pub(super) struct Level {
    /// Half-lengths in units of L.
    pub(super) half_lengths: Vec<f64>,
    /// y_ij per unit of P', see [`super::galerkin`].
    pub(super) modes: Vec<Vec<f64>>,
    /// How many of the modes were solved for, not iterated.
    pub(super) solved: Vec<usize>,
    /// Relative errors of half-lengths and of pressures at x = 0, estimated.
    errors: Vec<[f64; 2]>,
    /// Part of the highest modes in the pressure of a contact.
    tails: Vec<f64>,
}

/// Presses a punch with a force on a stack: the answer in the units of the scene.
pub(crate) fn press(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Punch,
    force: f64,
    options: &Options,
) -> Result<Solution, Error> {
    let indentation = Indentation::new(punch, kernel.length(), force / (kernel.modulus() * kernel.length()));
    let starts = start::half_lengths(kernel, &indentation)?;
    let mut steps = 0;
    let mut failure: Option<NoSolution> = None;
    for factor in STARTS {
        let half_lengths = starts.iter().enumerate().map(|(i, a)| if i == 0 { *a } else { a * factor }).collect();
        let found = refine(kernel, interfaces, &indentation, half_lengths, options, &mut steps).and_then(|(level, warnings)| {
            let check = admissible::check(kernel, interfaces, &indentation, &level)?;
            Ok(solution(kernel, interfaces, &indentation, level, check, steps, warnings))
        });
        match found {
            // a root that is not admissible says more than none
            Err(Error::NoSolution(found)) if kernel.contacts() > 1 => match failure {
                Some(NoSolution::NotConverged { .. }) | None => failure = Some(found),
                Some(_) => {}
            },
            decided => return decided,
        }
    }
    Err(Error::NoSolution(failure.unwrap_or(NoSolution::NotConverged { half_lengths: starts })))
}

/// Solves with more and more modes until the tolerance is met.
fn refine(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Indentation,
    mut half_lengths: Vec<f64>,
    options: &Options,
    steps: &mut usize,
) -> Result<(Level, Vec<String>), Error> {
    let mut modes = coarsest(kernel, &half_lengths)?;
    let mut warnings = Vec::new();
    let mut slow = 0;
    half_lengths = converge(kernel, punch, half_lengths, &modes, &modes, 1e-3, steps)?.0;
    loop {
        let iterated: Vec<usize> = modes.iter().map(|modes| 2 * modes).collect();
        let (found, galerkin, shift, missing) = converge(kernel, punch, half_lengths, &modes, &iterated, 1e-7, steps)?;
        let level = Level::new(found, &modes, galerkin, &shift, missing);
        admissible::pushes(kernel, interfaces, &level, ROUGHLY)?;
        slow = if missing > 0.0 { slow + 1 } else { 0 };
        if slow > 2 {
            return Err(not_converged(kernel, punch, &level.half_lengths));
        }
        let worst = level.errors.iter().flatten().fold(0.0, |worst: f64, error| worst.max(*error));
        if worst <= options.tolerance {
            return Ok((level, warnings));
        }
        if modes.iter().any(|modes| *modes >= FINEST) {
            warnings.push(format!(
                "the tolerance {:e} is not met with {FINEST} modes; the error estimates tell what was reached",
                options.tolerance
            ));
            return Ok((level, warnings));
        }
        for (modes, tail) in modes.iter_mut().zip(&level.tails) {
            if *tail > 0.01 * options.tolerance {
                *modes *= 2;
            }
        }
        half_lengths = level.half_lengths;
    }
}

/// Modes to begin with: enough for pressures that vary on the scale of the laminates next to a contact.
fn coarsest(kernel: &Kernel, half_lengths: &[f64]) -> Result<Vec<usize>, Error> {
    let laminates = kernel.laminates()?;
    let modes = |(i, a): (usize, &f64)| {
        let next = laminates[i.saturating_sub(1)..(i + 1).min(laminates.len())].iter();
        let thinnest = next.map(|(thickness, _)| *thickness).fold(f64::INFINITY, f64::min);
        let wanted = (PER_THICKNESS * a / thinnest).clamp(COARSEST as f64, MOST_COARSE as f64);
        (wanted as usize).next_power_of_two()
    };
    Ok(half_lengths.iter().enumerate().map(modes).collect())
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
            let coefficients = coefficients(&level.modes[i], pressure_unit);
            let peak_pressure = peak(&level.modes[i]) * pressure_unit;
            let [length_error, pressure_error] = level.errors[i];
            Contact {
                interface: *interface,
                half_length,
                half_length_error: length_error * half_length,
                peak_pressure,
                peak_pressure_error: pressure_error * peak_pressure,
                resultant: 0.5 * std::f64::consts::PI * half_length * coefficients[0],
                coefficients,
            }
        })
        .collect();
    Solution {
        contacts,
        min_pressure: check.min_pressure * pressure_unit,
        min_gap: check.min_gap * indentation.force * kernel.length(),
        modes: level.solved.into_iter().max().unwrap_or(0),
        wavenumbers: kernel.samples(),
        newton_steps,
        warnings,
    }
}

/// p(0) per unit of μ₀P', Σ y_j/(πj). Next to a graded face the terms fall like ± j⁻⁴, alternating, since the pressure
/// has a logarithm at its ends: the last partial sums are averaged, which leaves little of what is missing.
fn peak(modes: &[f64]) -> f64 {
    const AVERAGED: [f64; 6] = [63.0 / 64.0, 57.0 / 64.0, 42.0 / 64.0, 22.0 / 64.0, 7.0 / 64.0, 1.0 / 64.0];
    let last = modes.len().saturating_sub(AVERAGED.len());
    let terms = modes.iter().enumerate().map(|(m, y)| {
        let weight = m.checked_sub(last).map_or(1.0, |k| AVERAGED[k]);
        weight * y / (2 * m + 1) as f64
    });
    terms.sum::<f64>() / std::f64::consts::PI
}

/// c_j of p = Σ c_j sin jφ, x = a cos φ, from y_j = π j (−1)^((j−1)/2) c_j.
fn coefficients(modes: &[f64], unit: f64) -> Vec<f64> {
    let sign = |m: usize| if m % 2 == 0 { 1.0 } else { -1.0 };
    modes
        .iter()
        .enumerate()
        .map(|(m, y)| sign(m) * unit * y / ((2 * m + 1) as f64 * std::f64::consts::PI))
        .collect()
}

/// Newton's method with given numbers of modes, until steps are shorter than `enough`: half-lengths, pressures, the
/// shift of ln a due to iterated modes, and the length of the last step if that was not enough.
fn converge(
    kernel: &Kernel,
    punch: &Indentation,
    mut half_lengths: Vec<f64>,
    modes: &[usize],
    iterated: &[usize],
    enough: f64,
    steps: &mut usize,
) -> Result<(Vec<f64>, Galerkin, Vec<f64>, f64), Error> {
    let orders: Vec<usize> = iterated.iter().map(|modes| 2 * modes).collect();
    let start = half_lengths.clone();
    let mut layout: Option<(Layout, Vec<f64>)> = None;
    for count in 1.. {
        let near = |about: &[f64], by: f64| half_lengths.iter().zip(about).all(|(a, b)| (a / b).ln().abs() <= by);
        if !near(&start, FARTHEST) {
            break;
        }
        let (layout, _) = match layout.take() {
            Some((kept, about)) if near(&about, LAYOUT_SERVES) => layout.insert((kept, about)),
            _ => layout.insert((Layout::new(kernel, &half_lengths, &orders, 0.0), half_lengths.clone())),
        };
        if layout.zeta.len() > MOST_WAVENUMBERS {
            break;
        }
        let bases: Vec<Basis> = (0..half_lengths.len())
            .map(|i| Basis::new(layout, &layout.own[i], half_lengths[i], iterated[i]))
            .collect();
        let slopes = punch.slopes(half_lengths[0], iterated[0]);
        let mut galerkin = Equations::new(layout, &bases, &slopes, modes).solve(iterated);
        *steps += 1;
        let factor = galerkin.jacobian.partial_piv_lu();
        let newton = |values: &[f64]| -> Vec<f64> {
            let right = Mat::from_fn(values.len(), 1, |i, _| -values[i]);
            factor.solve(&right).col(0).iter().copied().collect()
        };
        let step = newton(&galerkin.residual);
        if step.iter().any(|step| !step.is_finite()) {
            break;
        }
        let longest = step.iter().fold(0.0, |longest: f64, step| longest.max(step.abs()));
        let shorten = (LONGEST_STEP / longest).min(1.0);
        for (a, step) in half_lengths.iter_mut().zip(&step) {
            *a *= (shorten * step).exp();
        }
        if let Some(limit) = punch.max_half_length()
            && half_lengths[0] >= limit
        {
            half_lengths[0] = 0.5 * (limit + bases[0].half_length);
        }
        if longest < enough || count >= STEPS && longest < ROUGHLY {
            for (step, sensitivity) in step.iter().zip(&galerkin.sensitivity) {
                for (modes, sensitivity) in galerkin.modes.iter_mut().zip(sensitivity) {
                    for (y, dy) in modes.iter_mut().zip(sensitivity) {
                        *y += step * dy;
                    }
                }
            }
            let shift = newton(&galerkin.correction);
            let missing = if longest < enough { 0.0 } else { longest };
            return Ok((half_lengths, galerkin, shift, missing));
        }
        if count >= 3 * STEPS {
            break;
        }
    }
    Err(not_converged(kernel, punch, &half_lengths))
}

/// The error of a lost Newton iteration: at the edge of the punch, the punch is to blame.
fn not_converged(kernel: &Kernel, punch: &Indentation, half_lengths: &[f64]) -> Error {
    if let Some(error) = punch.too_small(half_lengths[0]) {
        return error;
    }
    NoSolution::NotConverged { half_lengths: half_lengths.iter().map(|a| a * kernel.length()).collect() }.into()
}

impl Level {
    /// Errors are judged by what the iterated modes changed, and by how fast they fall.
    fn new(half_lengths: Vec<f64>, modes: &[usize], galerkin: Galerkin, shift: &[f64], missing: f64) -> Self {
        let mut errors = Vec::new();
        let mut tails = Vec::new();
        for (i, y) in galerkin.modes.iter().enumerate() {
            let size = |range: std::ops::Range<usize>| -> f64 {
                range.map(|m| (y[m] / (2 * m + 1) as f64).abs()).sum::<f64>() / std::f64::consts::PI
            };
            let (solved, all) = (modes[i], y.len());
            let falls = size((solved + all) / 2..all) / size(solved..all).max(f64::MIN_POSITIVE);
            let length = shift[i].abs() * falls * falls + missing + ROUNDING;
            let fewer = peak(&y[..(3 * all).div_ceil(4)]);
            errors.push([length, (fewer / peak(y) - 1.0).abs() + 3.0 * length]);
            tails.push(size(solved..all) / peak(y));
        }
        Self { half_lengths, modes: galerkin.modes, solved: modes.to_vec(), errors, tails }
    }
}
