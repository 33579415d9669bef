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
/// Steps per level.
const STEPS: usize = 60;

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
    let mut steps = 0;
    let mut half_lengths = start::half_lengths(kernel, &indentation)?;
    let mut modes = vec![COARSEST; kernel.contacts()];
    let mut warnings = Vec::new();
    let level = loop {
        let level = solve_level(kernel, &indentation, half_lengths, &modes, &mut steps)?;
        let worst = level.errors.iter().flatten().fold(0.0, |worst: f64, error| worst.max(*error));
        if std::env::var("RECEDE_TRACE").is_ok() {
            eprintln!("{modes:?} {:?} {:?} p0 {:?} tail {:?} steps {steps}", level.half_lengths, level.errors, level.modes.iter().map(|m| peak(m)).collect::<Vec<_>>(), level.modes.iter().map(|m| m[m.len()-4..].iter().enumerate().map(|(k,y)| y/(2*(k+m.len()-4)+1) as f64/3.14).collect::<Vec<_>>()).collect::<Vec<_>>());
        }
        if worst <= options.tolerance {
            break level;
        }
        let finest = modes.iter().max().is_none_or(|modes| *modes >= FINEST);
        if finest {
            warnings.push(format!(
                "the tolerance {:e} is not met with {FINEST} modes; the error estimates tell what was reached",
                options.tolerance
            ));
            break level;
        }
        for (modes, tail) in modes.iter_mut().zip(&level.tails) {
            if *tail > 0.01 * options.tolerance {
                *modes *= 2;
            }
        }
        half_lengths = level.half_lengths;
    };
    let check = admissible::check(kernel, interfaces, &indentation, &level)?;
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
    Ok(Solution {
        contacts,
        min_pressure: check.min_pressure * pressure_unit,
        min_gap: check.min_gap * indentation.force * kernel.length(),
        modes: modes.into_iter().max().unwrap_or(0),
        wavenumbers: kernel.samples(),
        newton_steps: steps,
        warnings,
    })
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

/// Newton's method with the given numbers of modes.
fn solve_level(
    kernel: &Kernel,
    punch: &Indentation,
    mut half_lengths: Vec<f64>,
    modes: &[usize],
    steps: &mut usize,
) -> Result<Level, Error> {
    let iterated: Vec<usize> = modes.iter().map(|modes| 2 * modes).collect();
    let orders: Vec<usize> = iterated.iter().map(|modes| 2 * modes).collect();
    let mut layout: Option<(Layout, Vec<f64>)> = None;
    for _ in 0..STEPS {
        let served = |about: &[f64]| {
            half_lengths.iter().zip(about).all(|(a, about)| (a / about).ln().abs() <= LAYOUT_SERVES)
        };
        let (layout, _) = match layout.take() {
            Some((kept, about)) if served(&about) => layout.insert((kept, about)),
            _ => layout.insert((Layout::new(kernel, &half_lengths, &orders, 0.0), half_lengths.clone())),
        };
        let bases: Vec<Basis> = (0..half_lengths.len())
            .map(|i| Basis::new(layout, &layout.own[i], half_lengths[i], iterated[i]))
            .collect();
        let slopes = punch.slopes(half_lengths[0], iterated[0]);
        let mut galerkin = Equations::new(layout, &bases, &slopes, modes).solve(&iterated);
        *steps += 1;
        let factor = galerkin.jacobian.partial_piv_lu();
        let column = |values: &[f64]| Mat::from_fn(values.len(), 1, |i, _| -values[i]);
        let step = factor.solve(&column(&galerkin.residual));
        let longest = (0..half_lengths.len()).fold(0.0, |longest: f64, i| longest.max(step[(i, 0)].abs()));
        if !longest.is_finite() {
            return Err(NoSolution::NotConverged { half_lengths: physical(kernel, &half_lengths) }.into());
        }
        let shorten = (LONGEST_STEP / longest).min(1.0);
        for (i, a) in half_lengths.iter_mut().enumerate() {
            *a *= (shorten * step[(i, 0)]).exp();
        }
        if let Some(limit) = punch.max_half_length()
            && half_lengths[0] >= limit
        {
            half_lengths[0] = 0.5 * (limit + bases[0].half_length);
        }
        if longest < 1e-7 {
            for (by, sensitivity) in galerkin.sensitivity.iter().enumerate() {
                for (modes, sensitivity) in galerkin.modes.iter_mut().zip(sensitivity) {
                    for (y, dy) in modes.iter_mut().zip(sensitivity) {
                        *y += step[(by, 0)] * dy;
                    }
                }
            }
            let shift = factor.solve(&column(&galerkin.correction));
            return Ok(Level::new(half_lengths, modes, galerkin, |i| shift[(i, 0)]));
        }
    }
    Err(NoSolution::NotConverged { half_lengths: physical(kernel, &half_lengths) }.into())
}

fn physical(kernel: &Kernel, half_lengths: &[f64]) -> Vec<f64> {
    half_lengths.iter().map(|a| a * kernel.length()).collect()
}

impl Level {
    /// Errors are judged by what the iterated modes changed, and by how fast they fall.
    fn new(half_lengths: Vec<f64>, modes: &[usize], galerkin: Galerkin, shift: impl Fn(usize) -> f64) -> Self {
        let mut errors = Vec::new();
        let mut tails = Vec::new();
        for (i, y) in galerkin.modes.iter().enumerate() {
            let size = |range: std::ops::Range<usize>| -> f64 {
                range.map(|m| (y[m] / (2 * m + 1) as f64).abs()).sum::<f64>() / std::f64::consts::PI
            };
            let (solved, all) = (modes[i], y.len());
            let falls = size((solved + all) / 2..all) / size(solved..all).max(f64::MIN_POSITIVE);
            let length = shift(i).abs() * falls + ROUNDING;
            let fewer = peak(&y[..(3 * all).div_ceil(4)]);
            errors.push([length, (fewer / peak(y) - 1.0).abs() + 3.0 * length]);
            tails.push(size(solved..all) / peak(y));
        }
        Self { half_lengths, modes: galerkin.modes, solved: modes.to_vec(), errors, tails }
    }
}
