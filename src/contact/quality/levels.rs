//! More and more modes, until the tolerance is met.
use crate::contact::ends::newton::{Newton, Work, not_converged};
use crate::contact::error::ContactError;
use crate::contact::integrals::layout::negligible;
use crate::contact::problem::modes::{Modes, weight};
use crate::contact::problem::profile::Indentation;
use crate::contact::quality::admissible;
use crate::contact::quality::estimate::{BEST, LOST, Level};
use crate::kernel::Kernel;
use crate::options::Options;
use crate::solution::Interface;

/// Modes of the coarsest level.
pub(crate) const COARSEST: usize = 8;
/// Modes of the finest level.
pub(crate) const FINEST: usize = 512;
/// Orders of the modes solved for, 2 per mode, reach this part of the turning point of the first wave that feels no more
/// than the faces.
const PER_WAVE: f64 = 0.6;
/// Modes of the first steps at most.
const MOST_COARSE: usize = 64;
/// Modes at most, all contacts together: what memory allows.
const MOST: usize = 1024;
/// Modes next to a graded face for ten digits.
const GRADED: usize = 40;
/// Modes that follow row by row: half as many as are solved for, at least these.
const MORE: usize = 16;
/// These, where the last modes are seen to be nothing before.
const LEAST_MORE: usize = 4;
/// Half of them will do for tolerances from here on.
const FEW_DIGITS: f64 = 1e-5;
/// Where there are too many wavenumbers, so many times more counts as negligible, up to what this tolerance allows.
const LOOSER: f64 = 30.0;
const LOOSEST: f64 = 1e-10;

/// What is known to begin with.
pub(crate) enum Start {
    /// Half-lengths from formulas, and by how much finer than usual the first steps are to be.
    Formulas { half_lengths: Vec<f64>, finer: usize },
    /// Half-lengths as right as any answer, almost, and how large modes are there.
    Nearby { half_lengths: Vec<f64>, modes: Modes },
}

/// Solves with more and more modes until the tolerance is met.
pub(crate) fn refine(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Indentation,
    start: Start,
    options: &Options,
    work: &mut Work,
) -> Result<(Level, Vec<String>), ContactError> {
    let (half_lengths, finer, nearby) = match start {
        Start::Formulas { half_lengths, finer } => (half_lengths, finer, None),
        Start::Nearby { half_lengths, modes } => (half_lengths, 1, Some(modes)),
    };
    let n = half_lengths.len();
    let finest = FINEST.min(MOST / n);
    let mut newton = Newton::new(kernel, punch, work.clone());
    let mut solved = coarsest(kernel, &half_lengths, finest / 2);
    let mut coarse: Vec<usize> =
        solved.iter().map(|modes| (modes / 2 * finer).min(MOST_COARSE.min(finest)).max(COARSEST)).collect();
    // all modes of a given pressure are known together
    let first = usize::from(punch.given().is_some());
    solved[..first].fill(1);
    coarse[..first].fill(1);
    let tolerance = options.tolerance.max(BEST);
    let mut judged = nearby.is_none();
    let (mut half_lengths, rough) = match nearby {
        None => newton.approach(half_lengths, &coarse, tolerance)?,
        Some(mut modes) => {
            modes.iter_mut().zip(&coarse).for_each(|(modes, coarse)| modes.truncate(*coarse));
            (half_lengths, modes)
        }
    };
    // next to a graded face modes fall like a power
    let graded: Vec<bool> = (0..n).map(|i| !kernel.far(i).is_constant()).collect();
    let power = (1e-10 / tolerance).powf(1.0 / 6.0);
    let mut modes: Vec<usize> = solved
        .iter()
        .zip(&rough)
        .map(|(solved, rough)| with_more(*solved, tolerance).min(felt(rough, *solved, tolerance)))
        .collect();
    modes[..first].fill(1);
    for i in (first..n).filter(|i| graded[*i]) {
        let wanted = (GRADED as f64 * power) as usize;
        if wanted > modes[i] {
            modes[i] = wanted.next_multiple_of(4).min(finest);
            solved[i] = solved[i].max((modes[i] / 3).next_multiple_of(4));
        }
    }
    // what a punch that is not smooth does to the contact below is felt by all modes of that
    let as_many = |counts: &mut [usize]| {
        if let [first, second, ..] = counts
            && !punch.is_smooth()
        {
            *first = (*first).max(*second);
        }
    };
    as_many(&mut solved);
    as_many(&mut modes);
    let mut warnings = Vec::new();
    let mut before: Option<Level> = None;
    let mut fewer = coarse.clone();
    loop {
        let mut allowed = tolerance;
        let found = loop {
            newton.crowded = false;
            let found = newton.converge(half_lengths.clone(), &fewer, &solved, &modes, allowed);
            if found.is_ok() || !newton.crowded || allowed > LOOSEST {
                break found;
            }
            // fewer wavenumbers will do for more modes rather than none
            allowed *= LOOSER;
        };
        *work = newton.work.clone();
        let whole = found.as_ref().is_ok_and(|found| found.whole.contains(&true));
        let level = match (found, before.take()) {
            (Ok(found), _) => {
                let mut level = Level::new(found, kernel, punch, negligible(allowed));
                level.doubt(&half_lengths);
                level
            }
            // what memory or rounding do not allow leaves the level before, or one of few digits
            (Err(_), Some(level)) => {
                warnings.push(not_met(options, &modes));
                return Ok((level, warnings));
            }
            (Err(_), None) => {
                let mut modes: Vec<usize> = coarse.iter().map(|solved| with_more(*solved, FEW_DIGITS)).collect();
                modes[..first].fill(1);
                let found = newton.converge(half_lengths, &coarse, &coarse, &modes, FEW_DIGITS)?;
                let fewer: Vec<usize> = coarse.iter().map(|modes| modes.div_ceil(2)).collect();
                let (rough, _) = newton.approach(found.half_lengths.clone(), &fewer, FEW_DIGITS)?;
                *work = newton.work.clone();
                let mut level = Level::new(found, kernel, punch, negligible(FEW_DIGITS));
                level.doubt(&rough);
                if level.worst_error() > tolerance {
                    warnings.push(not_met(options, &modes));
                }
                return Ok((level, warnings));
            }
        };
        // what few modes miss is not told by a start that has them all
        if !judged && (whole || level.worst_error() > LOST) {
            return Err(not_converged(kernel, punch, &level.half_lengths));
        }
        judged = true;
        if level.worst_error() <= tolerance {
            if options.tolerance < BEST {
                warnings.push(format!(
                    "a tolerance of {:e} is beyond double precision; the error estimates tell what was reached",
                    options.tolerance
                ));
            }
            return Ok((level, warnings));
        }
        if level.settled.iter().all(|settled| *settled) {
            admissible::pushes(kernel, interfaces, punch, &level, f64::INFINITY)?;
        }
        let error = |i: usize| level.own_errors[i];
        let enough = |i: usize| error(i) <= 0.1 * tolerance;
        if (0..n).all(|i| solved[i] >= finest || enough(i)) {
            warnings.push(not_met(options, &modes));
            return Ok((level, warnings));
        }
        for i in (0..n).filter(|i| !enough(*i)) {
            // pressures that settle need not be solved for, only continued
            let grown =
                if graded[i] && level.settled[i] { (error(i) / tolerance).powf(0.2).clamp(1.25, 2.0) } else { 2.0 };
            let wanted = |count: usize| ((count as f64 * grown) as usize).next_multiple_of(4);
            solved[i] = wanted(solved[i]).min(finest);
            modes[i] = wanted(modes[i]).max(with_more(solved[i], tolerance)).min(with_more(finest, tolerance));
        }
        as_many(&mut solved);
        as_many(&mut modes);
        fewer = level.counts.clone();
        half_lengths = level.half_lengths.clone();
        before = Some(level);
    }
}

fn not_met(options: &Options, modes: &[usize]) -> String {
    format!(
        "the tolerance {:e} is not met with {} modes; the error estimates tell what was reached",
        options.tolerance,
        modes.iter().max().unwrap_or(&0)
    )
}

/// Modes that are solved for, and those that follow row by row.
fn with_more(solved: usize, tolerance: f64) -> usize {
    let least = if tolerance < FEW_DIGITS { MORE } else { MORE / 2 };
    solved + (solved / 2).max(least)
}

/// Modes that follow row by row may be few where the last of the rough ones are nothing already.
fn felt(rough: &[f64], solved: usize, tolerance: f64) -> usize {
    let last = weight(rough, rough.len().saturating_sub(2)..rough.len());
    if last < tolerance { solved + LEAST_MORE } else { usize::MAX }
}

/// Modes to begin with: enough for waves that feel no more than the faces of a contact.
fn coarsest(kernel: &Kernel, half_lengths: &[f64], finest: usize) -> Vec<usize> {
    let modes = |(i, a): (usize, &f64)| {
        let wanted = (PER_WAVE * a * kernel.settles(i)).min(finest as f64).max(COARSEST as f64);
        (wanted as usize).next_multiple_of(4)
    };
    half_lengths.iter().enumerate().map(modes).collect()
}
