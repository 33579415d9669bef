//! Contacts in any list of intervals: bodies that touch about the middle and again farther out, or are apart about the middle.
mod columns;
mod equations;
mod gaps;
mod newton;
mod pressure;
mod support;
#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use crate::contact::answer::{Answer, Found, stats};
use crate::contact::ends::newton::LAYOUT_SERVES;
use crate::contact::even::RightInterval;
use crate::contact::integrals::layout::Layout;
use crate::contact::problem::accuracy::{COARSE, ROUNDING, SAFETY};
use crate::contact::problem::iteration::Operations;
use crate::contact::problem::twin::Twin;
use crate::contact::problem::{Problem, Side};
use crate::contact::programme::ActiveIntervals;
use crate::contact::quality::estimates::UNKNOWN;
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::solution::{Solution, Stats, Strip, Warning, WarningCode};
use gaps::Check;
use newton::{Level, converge};
use support::{Interval, Support};

/// Terms on each interval: the first number of them, doubled until the tolerance is met, and the last.
const COARSEST: usize = 12;
const FINEST: usize = 256;
/// Changes from level to level are said to fall at least this fast, and at most.
const MOST_FALL: f64 = 0.5;
const LEAST_FALL: f64 = 0.01;

/// What Newton's method has done, all attempts together.
#[derive(Default)]
struct Work {
    /// Steps for each number of terms.
    steps: Vec<usize>,
    operations: Operations,
}

impl Work {
    /// Counts the products of this number of columns; a Bessel function takes as long as some 64 multiplications. `None` if they are too many.
    fn spend(&mut self, columns: usize, wavenumbers: usize) -> Option<()> {
        let columns = columns as f64;
        self.operations.spend(wavenumbers as f64 * columns * (columns + 64.0) + columns.powi(3) / 3.0)
    }
}

/// Presses a punch on a stack some contacts of which have several intervals, about where `active` says; `None` if no admissible answer was
/// found, or the pressure under the punch is of another kind.
pub(super) fn solve(problem: &Problem, active: &[ActiveIntervals]) -> Option<Solution> {
    let is_plane = problem.twin() == Twin::Plane;
    if !is_plane || problem.sides.iter().any(Side::is_sharp) {
        return None;
    }
    // the quadratic programme may see many intervals where bodies graze each other, or several, far out, instead of one with next to no force
    let loaded = starting_intervals(problem, active, |active| active.loaded.clone())
        .filter(|loaded| loaded.0.iter().any(|interval| !interval.is_central()));
    let all = starting_intervals(problem, active, |active| active.intervals().to_vec())?;
    let merged = starting_intervals(problem, active, ActiveIntervals::merged)?;
    let mut starts: Vec<_> = loaded.into_iter().chain([all, merged]).collect();
    starts.dedup();
    let mut work = Work { operations: Operations::at_most(problem.operations), ..Work::default() };
    // few terms take the least; where they do not converge, twice as many may
    for count in [COARSEST, 2 * COARSEST, 4 * COARSEST] {
        for support in &starts {
            work.steps.clear();
            let counts: Vec<usize> =
                support.0.iter().map(|interval| resolved(problem, interval).clamp(count, 4 * COARSEST)).collect();
            if let Some(first) = converge(problem, support.clone(), &counts, COARSE, &mut work)
                && let Some(solution) = refine(problem, first, &mut work)
            {
                return Some(solution);
            }
        }
    }
    None
}

/// As many terms as resolve waves so short that their compliance is the one of the layers at the faces of the contact alone.
fn resolved(problem: &Problem, interval: &Interval) -> usize {
    let orders = 1.2 * interval.half * problem.kernel.governed_by_faces(interval.contact);
    let count = if interval.is_central() { 0.5 * orders } else { orders };
    (count as usize).min(FINEST / 2)
}

/// Goes on from a first solution with more and more terms; `None` if that is no admissible answer.
fn refine(problem: &Problem, first: Level, work: &mut Work) -> Option<Solution> {
    let mut before = first;
    let mut change = f64::INFINITY;
    let mut best: Option<([Level; 2], Errors)> = None;
    loop {
        let counts: Vec<usize> = before.counts.iter().map(|count| count + count / 2).collect();
        if counts.iter().any(|count| *count > FINEST) {
            break;
        }
        let Some(level) = converge(problem, before.support.clone(), &counts, ROUNDING, work) else { break };
        let errors = Errors::between(&level, &before, &mut change);
        // more terms do not help against what is due to something else
        let done = errors.worst() <= problem.tolerance.max(2.0 * errors.floor);
        if best.as_ref().is_none_or(|(_, best)| errors.worst() < best.worst()) {
            best = Some(([level.clone(), before], errors));
        }
        if done {
            break;
        }
        before = level;
    }
    let ([level, coarse], mut errors) = best?;
    if errors.ends.iter().flatten().any(|error| error.is_nan() || *error > UNKNOWN) || errors.worst().is_nan() {
        return None;
    }
    let mut warnings = Vec::new();
    if errors.worst() > problem.tolerance {
        let message = format!(
            "the tolerance {:e} is not met with {} pressures on each interval of contacts of several intervals; the error estimates tell \
             what was reached",
            problem.tolerance,
            level.counts.iter().copied().fold(0, usize::max)
        );
        warnings.push(Warning::new(WarningCode::ToleranceNotMet, message));
    }
    let Check { min_pressure, min_gap, tensions } = gaps::check(problem, &level, &coarse, errors.worst())?;
    // pressures in tension are wrong by that
    errors.peaks.iter_mut().zip(&tensions).for_each(|(error, tension)| *error = error.max(SAFETY * tension));
    let terms = |contact| {
        (0..level.counts.len()).filter(|k| level.support.0[*k].contact == contact).map(|k| level.counts[k]).max()
    };
    let stats = Stats {
        modes: (0..problem.contacts()).map(|contact| terms(contact).unwrap_or(1)).collect(),
        newton_steps: work.steps.clone(),
        ..stats(problem.kernel)
    };
    let contacts = found(problem, &level, &errors);
    Some(Answer { contacts, min_pressure, min_gap, stats, warnings }.into_solution(problem))
}

/// Intervals to begin with, none where the pressure is given; `None` if a contact has none, or one that does not end, or if a flat punch
/// touches beside its middle only: no form of a pressure has one corner.
fn starting_intervals(
    problem: &Problem,
    active: &[ActiveIntervals],
    which: impl Fn(&ActiveIntervals) -> Vec<[f64; 2]>,
) -> Option<Support> {
    let mut intervals = Vec::new();
    for (contact, active) in active.iter().enumerate().filter(|(contact, _)| !problem.is_known(*contact)) {
        let mut parts = which(active);
        if let Some(edge) = problem.sides[contact].edge().filter(|_| problem.sides[contact].is_flat()) {
            let [[0.0, to]] = &mut parts[..] else { return None };
            *to = edge;
        }
        if parts.is_empty() || parts.iter().any(|part| part[1].is_infinite()) {
            return None;
        }
        intervals.extend(parts.iter().map(|part| Interval::new(contact, *part)));
    }
    Some(Support(intervals))
}

/// Lengths of the contacts; a prescribed traction has the lengths of the contact below.
struct Lengths {
    /// The outermost end of each contact.
    ends: Vec<f64>,
    /// Half of the shortest interval of each.
    shortest: Vec<f64>,
}

impl Lengths {
    fn of(problem: &Problem, support: &Support) -> Self {
        let contacts = 0..problem.contacts();
        let ends = contacts.clone().map(|i| support.of(i).last().map_or(0.0, Interval::to));
        let half = |interval: &Interval| interval.half;
        let shortest = contacts.map(|i| support.of(i).iter().map(half).fold(f64::INFINITY, f64::min));
        let (mut ends, mut shortest): (Vec<f64>, Vec<f64>) = (ends.collect(), shortest.collect());
        for (i, side) in problem.sides.iter().enumerate() {
            if let Some(given) = side.given() {
                (ends[i], shortest[i]) = (given.half_length.max(ends[i + 1]), shortest[i + 1]);
            }
        }
        Self { ends, shortest }
    }

    /// Whether a layout that was made for contacts with these ends serves them.
    fn are_near(&self, about: &[f64]) -> bool {
        self.ends.iter().zip(about).all(|(a, b)| (a / b - 1.0).abs() < LAYOUT_SERVES)
    }
}

/// What is left of the kernel of a contact where its integrals end, relative to its limit, over the wavenumber there.
fn left_out(kernel: &Kernel, layout: &Layout, i: usize, shortest: f64, negligible: f64) -> f64 {
    let end = layout.zeta[..layout.own[i].reach].last().copied().unwrap_or(0.0);
    if kernel.vanishes(i, shortest, negligible) <= end {
        return 0.0;
    }
    (kernel.remainder(i, end) / kernel.asymptote(i).limit).abs() / end
}

/// By how much two levels differ.
struct Errors {
    /// Of the ends of each interval, relative.
    ends: Vec<[f64; 2]>,
    /// Of p(0) of each contact, relative.
    peaks: Vec<f64>,
    /// The most that is due to something else than the number of terms.
    floor: f64,
}

impl Errors {
    /// Estimates them from what has changed since the level before, and how much less that is than what had changed then, `largest`.
    fn between(level: &Level, before: &Level, largest_change: &mut f64) -> Self {
        let apart = |new: f64, old: f64| if new == 0.0 { 0.0 } else { (new / old - 1.0).abs() };
        let changes = level.support.0.iter().zip(&before.support.0);
        let changes = changes.flat_map(|(new, old)| [apart(new.from(), old.from()), apart(new.to(), old.to())]);
        let all = largest(changes);
        let fall =
            if largest_change.is_finite() { (all / *largest_change).clamp(LEAST_FALL, MOST_FALL) } else { MOST_FALL };
        *largest_change = all;
        let change = |new: f64, old: f64| SAFETY * fall / (1.0 - fall) * apart(new, old);
        let last = largest(level.steps.iter().map(|step| step.abs()));
        // short waves are felt where an interval is short
        let rest = |interval: &Interval| last + 10.0 * ROUNDING + level.left_out[interval.contact] / interval.half;
        let ends = level.support.0.iter().zip(&before.support.0).map(|(new, old)| {
            let rest = rest(new);
            [change(new.from(), old.from()) + rest, change(new.to(), old.to()) + rest]
        });
        let firsts = level.support.0.iter().enumerate().filter(|(number, interval)| {
            number.checked_sub(1).is_none_or(|before| level.support.0[before].contact != interval.contact)
        });
        let peak = |(number, interval): (usize, &Interval)| {
            // none where the bodies are apart
            let [new, old] = [level, before].map(|level| level.peak(number));
            if new == 0.0 { 0.0 } else { change(new, old) + rest(interval) }
        };
        let peaks = firsts.map(peak).collect();
        let floor = largest(level.support.0.iter().map(rest));
        Self { ends: ends.collect(), peaks, floor }
    }

    fn worst(&self) -> f64 {
        largest(self.ends.iter().flatten().chain(&self.peaks).copied())
    }
}

impl Level {
    /// The pressure at x = 0 of an interval, per unit of P'.
    fn peak(&self, number: usize) -> f64 {
        let interval = &self.support.0[number];
        if interval.is_central() { self.pressures[number].at(interval, 0.5 * PI) } else { 0.0 }
    }
}

/// What was found of each contact.
fn found(problem: &Problem, level: &Level, errors: &Errors) -> Vec<Found> {
    let mut peaks = errors.peaks.iter();
    let of = |contact: usize| {
        let is_flat = problem.sides[contact].is_flat();
        let first = level.support.0.partition_point(|interval| interval.contact < contact);
        let numbers = first..first + level.support.of(contact).len();
        let peak = level.peak(first);
        let parts = numbers.clone().map(|number| {
            let (interval, [from_error, to_error]) = (&level.support.0[number], errors.ends[number]);
            let (from, to) = (interval.from(), interval.to());
            let to_error = if is_flat { 0.0 } else { to_error * to };
            RightInterval { from, from_error: from_error * from, to, to_error }
        });
        let strips = numbers.map(|number| {
            let (interval, pressure) = (&level.support.0[number], &level.pressures[number]);
            let terms = pressure.terms.iter().enumerate();
            let all: Vec<f64> = terms.map(|(m, y)| interval.unit() * y / interval.order(m) as f64).collect();
            if interval.is_central() {
                let corners = if is_flat { interval.unit() * pressure.singular[0] } else { 0.0 };
                return Strip { corners, ..Strip::series(interval.half, all) };
            }
            let every_other = |first: usize| all.iter().skip(first).step_by(2).copied().collect();
            Strip { at: interval.middle, skew: every_other(1), ..Strip::series(interval.half, every_other(0)) }
        });
        let peak_error = peaks.next().unwrap_or(&0.0) * peak.abs();
        Found { parts: parts.collect(), peak, peak_error, strips: strips.collect() }
    };
    problem.unknown().map(of).collect()
}
