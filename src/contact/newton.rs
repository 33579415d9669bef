//! Newton's method for the logarithms of the half-lengths, with given numbers of modes.
use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::error::{Error, NoSolution};
use crate::kernel::Kernel;

use super::basis::Basis;
use super::galerkin::Equations;
use super::layout::Layout;
use super::pressures::{Pressures, solve};
use super::punch::Indentation;

/// Longest step in the logarithm of a half-length.
const LONGEST_STEP: f64 = 0.5;
/// A layout serves half-lengths that differ by this much, in the logarithm.
const LAYOUT_SERVES: f64 = 0.1;
/// Steps per level; the first steps may take three times as many.
const STEPS: usize = 12;
/// A level that converges slowly (for want of modes) is left with the last step shorter than this.
const ROUGHLY: f64 = 1e-2;
/// Farther from the start, in the logarithm of a half-length, Newton's method is lost.
const FARTHEST: f64 = 4.0;

/// Where Newton's method has come to.
pub(super) struct Converged {
    /// Half-lengths in units of L.
    pub(super) half_lengths: Vec<f64>,
    /// Pressures there.
    pub(super) pressures: Pressures,
    /// By how much the iterated modes shifted the logarithms of the half-lengths.
    pub(super) shift: Vec<f64>,
    /// By how much further rounds of iteration would, about.
    pub(super) unsettled: Vec<f64>,
    /// Length of the last step if the next one would still be needed, else 0.
    pub(super) missing: f64,
}

/// Newton's method with given numbers of modes, until steps are shorter than `enough`.
pub(super) fn converge(
    kernel: &Kernel,
    punch: &Indentation,
    mut half_lengths: Vec<f64>,
    modes: &[usize],
    iterated: &[usize],
    enough: f64,
    steps: &mut usize,
) -> Result<Converged, Error> {
    let orders: Vec<usize> = iterated.iter().map(|modes| 2 * modes).collect();
    let start = half_lengths.clone();
    let mut layout: Option<(Layout, Vec<f64>)> = None;
    for count in 1.. {
        let near = |about: &[f64], by: f64| half_lengths.iter().zip(about).all(|(a, b)| (a / b).ln().abs() <= by);
        if !near(&start, FARTHEST) {
            break;
        }
        if !layout.as_ref().is_some_and(|(_, about)| near(about, LAYOUT_SERVES)) {
            layout = Layout::new(kernel, &half_lengths, &orders, 0.0).map(|new| (new, half_lengths.clone()));
        }
        let Some((layout, _)) = &layout else { break };
        let bases: Vec<Basis> =
            (0..half_lengths.len()).map(|i| Basis::new(layout, &layout.own[i], half_lengths[i], iterated[i])).collect();
        let slopes = punch.slopes(half_lengths[0], iterated[0]);
        let mut pressures = solve(&Equations::new(layout, &bases, &slopes, modes), iterated);
        *steps += 1;
        let factor = pressures.jacobian.partial_piv_lu();
        let newton = |values: &[f64]| -> Vec<f64> {
            let right = Mat::from_fn(values.len(), 1, |i, _| -values[i]);
            factor.solve(&right).col(0).iter().copied().collect()
        };
        let step = newton(&pressures.residual);
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
            for (step, sensitivity) in step.iter().zip(&pressures.sensitivity) {
                for (modes, sensitivity) in pressures.modes.iter_mut().zip(sensitivity) {
                    for (y, dy) in modes.iter_mut().zip(sensitivity) {
                        *y += step * dy;
                    }
                }
            }
            let shift = newton(&pressures.correction);
            let unsettled = newton(&pressures.unsettled_residual);
            let missing = if longest < enough { 0.0 } else { longest };
            return Ok(Converged { half_lengths, pressures, shift, unsettled, missing });
        }
        if count >= 3 * STEPS {
            break;
        }
    }
    Err(not_converged(kernel, punch, &half_lengths))
}

/// The error of a lost Newton iteration: at the edge of the punch, the punch is to blame.
pub(super) fn not_converged(kernel: &Kernel, punch: &Indentation, half_lengths: &[f64]) -> Error {
    if let Some(error) = punch.too_small(half_lengths[0]) {
        return error;
    }
    NoSolution::NotConverged { half_lengths: half_lengths.iter().map(|a| a * kernel.length()).collect() }.into()
}
