//! More and more modes, until the tolerance is met.
use crate::error::Error;
use crate::kernel::Kernel;
use crate::options::Options;
use crate::solution::Interface;

use super::admissible;
use super::level::{BEST, Level};
use super::newton::{converge, not_converged};
use super::punch::Indentation;

/// Modes of the coarsest level.
const COARSEST: usize = 8;
/// Modes of the finest level.
const FINEST: usize = 512;
/// Modes to begin with per half-length in units of the thickness next to it, and at most.
const PER_THICKNESS: f64 = 2.0;
const MOST_COARSE: usize = 64;

/// Solves with more and more modes until the tolerance is met.
pub(super) fn refine(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Indentation,
    mut half_lengths: Vec<f64>,
    finer: usize,
    options: &Options,
    steps: &mut usize,
) -> Result<(Level, Vec<String>), Error> {
    let mut modes = coarsest(kernel, &half_lengths)?;
    modes.iter_mut().for_each(|modes| *modes = (*modes * finer).min(FINEST / 2));
    let mut warnings = Vec::new();
    let mut slow = 0;
    half_lengths = converge(kernel, punch, half_lengths, &modes, &modes, 1e-3, steps)?.half_lengths;
    let mut before: Option<Level> = None;
    loop {
        let iterated: Vec<usize> = modes.iter().map(|modes| 2 * modes).collect();
        let found = converge(kernel, punch, half_lengths, &modes, &iterated, 1e-7, steps)?;
        let settled = found.missing == 0.0;
        slow = if settled { 0 } else { slow + 1 };
        let level = Level::new(found, &modes, before.as_ref());
        if settled {
            admissible::pushes(kernel, interfaces, &level)?;
        }
        if slow > 2 {
            return Err(not_converged(kernel, punch, &level.half_lengths));
        }
        if level.worst_error() <= options.tolerance.max(BEST) {
            if options.tolerance < BEST {
                warnings.push(format!(
                    "a tolerance of {:e} is beyond double precision; the error estimates tell what was reached",
                    options.tolerance
                ));
            }
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
        half_lengths = level.half_lengths.clone();
        before = Some(level);
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
