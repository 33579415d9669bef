//! Contacts in several intervals: bodies that touch about the middle and again farther out, or are apart about the middle.
//!
//! The quadratic programme tells where bodies touch, roughly; Newton's method finds where exactly, with more and more
//! pressures on each interval until two numbers of them agree.
mod derivatives;
mod equations;
mod gaps;
mod half_plane;
mod interval;
mod newton;

use crate::contact::answer::{Answer, Found, stats};
use crate::contact::ends::newton::LAYOUT_SERVES;
use crate::contact::even::RightInterval;
use crate::contact::integrals::layout::Layout;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{ROUNDING, SAFETY};
use crate::contact::problem::iteration::Operations;
use crate::contact::problem::twin::Twin;
use crate::contact::programme::ActiveIntervals;
use crate::contact::quality::estimates::UNKNOWN;
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::solution::{Solution, Stats, Strip, Warning, WarningCode};
use gaps::Check;
use interval::Interval;
use newton::{Way, converge};

/// Pressures on each interval: the first number of them, doubled until the tolerance is met, and the last.
const COARSEST: usize = 12;
const FINEST: usize = 96;

/// What Newton's method has done, all attempts together.
#[derive(Default)]
struct Work {
    /// Steps for each number of pressures.
    steps: Vec<usize>,
    operations: Operations,
}

impl Work {
    /// Counts integrals over `wavenumbers` of tests times fields, both of which are made `times` times; a Bessel function takes as
    /// long as some 64 multiplications. `None` if they are too many.
    fn spend(&mut self, fields: usize, tests: usize, wavenumbers: usize, times: usize) -> Option<()> {
        self.operations.spend((wavenumbers + fields) as f64 * tests as f64 * (fields + 64 * times) as f64)
    }
}

/// Ends and pressures for one number of pressures.
#[derive(Clone)]
struct Level {
    intervals: Vec<Interval>,
    /// c_j of each interval, per unit of P'.
    coefficients: Vec<Vec<f64>>,
    /// Length of the last step, relative.
    last_step: f64,
    /// For each contact, what is left of its kernel where integrals end, relative, over the wavenumber there.
    left_out: Vec<f64>,
}

/// Presses a punch on a stack some contacts of which have several parts, about where `active` says; `None` if no
/// admissible answer was found, or the pressure under the punch is of another kind.
pub(super) fn solve(problem: &Problem, active: &[ActiveIntervals]) -> Option<Solution> {
    let is_plane = problem.twin() == Twin::Plane;
    if !is_plane || problem.sides.iter().any(|side| side.is_flat() || side.is_sharp()) {
        return None;
    }
    // the programme may see many intervals where bodies graze each other, or several, far out, where there is one with next to no force
    let loaded = starting_intervals(problem, active, |active| active.loaded.clone())
        .filter(|loaded| loaded.iter().any(|interval| !interval.is_central()));
    let all = starting_intervals(problem, active, |active| active.intervals().to_vec())?;
    let merged = starting_intervals(problem, active, ActiveIntervals::merged)?;
    let mut starts: Vec<_> = loaded.into_iter().chain([all, merged]).collect();
    starts.dedup();
    let mut work = Work { operations: Operations::at_most(problem.operations), ..Work::default() };
    // few pressures take the least; where none of the ways converges with them, twice as many may
    for count in [COARSEST, 2 * COARSEST] {
        for (intervals, way) in starts.iter().flat_map(|intervals| Way::all().map(|way| (intervals, way))) {
            work.steps.clear();
            if let Some(first) = converge(problem, intervals.clone(), count, way, &mut work)
                && let Some(solution) = refine(problem, first, way, &mut work)
            {
                return Some(solution);
            }
        }
    }
    None
}

/// Goes on from a first solution with more and more pressures; `None` if that is no admissible answer.
fn refine(problem: &Problem, first: Level, way: Way, work: &mut Work) -> Option<Solution> {
    let mut count = first.count();
    let mut before = first;
    let mut best: Option<([Level; 2], Errors, usize)> = None;
    while 2 * count <= FINEST {
        count *= 2;
        let Some(level) = converge(problem, before.intervals.clone(), count, way, work) else { break };
        let errors = Errors::between(&level, &before);
        // more pressures do not help against what is due to something else
        let done = errors.worst() <= problem.tolerance.max(2.0 * errors.floor);
        if best.as_ref().is_none_or(|(_, best, _)| errors.worst() < best.worst()) {
            best = Some(([level.clone(), before], errors, count));
        }
        if done {
            break;
        }
        before = level;
    }
    let ([level, coarse], mut errors, count) = best?;
    if errors.ends.iter().flatten().any(|error| error.is_nan() || *error > UNKNOWN) || errors.worst().is_nan() {
        return None;
    }
    let mut warnings = Vec::new();
    if errors.worst() > problem.tolerance {
        let message = format!(
            "the tolerance {:e} is not met with {count} pressures on each interval of contacts of several intervals; the error \
             estimates tell what was reached",
            problem.tolerance
        );
        warnings.push(Warning::new(WarningCode::ToleranceNotMet, message));
    }
    let Check { min_pressure, min_gap, tensions } = gaps::check(problem, &level, &coarse, errors.worst())?;
    // pressures in tension are wrong by that
    errors.peaks.iter_mut().zip(&tensions).for_each(|(error, tension)| *error = error.max(SAFETY * tension));
    let stats =
        Stats { modes: vec![count; problem.contacts()], newton_steps: work.steps.clone(), ..stats(problem.kernel) };
    let contacts = found(&level, &errors);
    Some(Answer { contacts, min_pressure, min_gap, stats, warnings }.into_solution(problem))
}

/// Intervals to begin with, none where the pressure is given; `None` if a contact has none, or one that does not end.
fn starting_intervals(
    problem: &Problem,
    active: &[ActiveIntervals],
    which: impl Fn(&ActiveIntervals) -> Vec<[f64; 2]>,
) -> Option<Vec<Interval>> {
    let mut intervals = Vec::new();
    for (contact, active) in active.iter().enumerate().filter(|(contact, _)| !problem.is_known(*contact)) {
        let parts = which(active);
        if parts.is_empty() || parts.iter().any(|part| part[1].is_infinite()) {
            return None;
        }
        intervals.extend(parts.iter().map(|part| Interval::new(contact, *part)));
    }
    Some(intervals)
}

/// The innermost interval of each contact.
fn first_of_each(intervals: &[Interval]) -> impl Iterator<Item = usize> {
    (0..intervals.len())
        .filter(|i| i.checked_sub(1).is_none_or(|before| intervals[before].contact != intervals[*i].contact))
}

/// Where intervals end, from the middle outwards.
fn ends(intervals: &[Interval]) -> Vec<f64> {
    let own = |interval: &Interval| {
        if interval.is_central() { vec![interval.to()] } else { vec![interval.from(), interval.to()] }
    };
    intervals.iter().flat_map(own).collect()
}

/// Intervals like others, with other ends; `None` if they are none.
fn with_ends(intervals: &[Interval], ends: &[f64]) -> Option<Vec<Interval>> {
    let mut next = 0;
    let mut moved = Vec::with_capacity(intervals.len());
    for interval in intervals {
        let from = if interval.is_central() { 0.0 } else { ends[next] };
        next += usize::from(!interval.is_central());
        let to = ends[next];
        next += 1;
        if !to.is_finite() || to <= from || from <= 0.0 && !interval.is_central() {
            return None;
        }
        moved.push(Interval::new(interval.contact, [from, to]));
    }
    let apart = |pair: &[Interval]| pair[0].contact != pair[1].contact || pair[0].to() < pair[1].from();
    moved.windows(2).all(apart).then_some(moved)
}

/// The shorter of the intervals that meet in each end.
fn spacings(intervals: &[Interval]) -> Vec<f64> {
    let mut spacings = Vec::new();
    for (i, interval) in intervals.iter().enumerate() {
        let whole = interval.to() - interval.from();
        let same = |other: &&Interval| other.contact == interval.contact;
        if !interval.is_central() {
            let before = i.checked_sub(1).and_then(|before| intervals.get(before)).filter(same);
            // what is left of x = 0 is a mirror image
            spacings.push(whole.min(interval.from() - before.map_or(0.0, Interval::to)));
        }
        spacings.push(intervals.get(i + 1).filter(same).map_or(whole, |after| whole.min(after.from() - interval.to())));
    }
    spacings
}

/// Lengths of the contacts; a given pressure has those of the contact below.
struct Lengths {
    /// The outermost end of each contact.
    ends: Vec<f64>,
    /// Half of the shortest interval of each.
    shortest: Vec<f64>,
}

impl Lengths {
    fn of(problem: &Problem, intervals: &[Interval]) -> Self {
        let of = |i: usize| intervals.iter().filter(move |interval| interval.contact == i);
        let ends = (0..problem.contacts()).map(|i| of(i).map(Interval::to).fold(0.0, f64::max));
        let shortest =
            (0..problem.contacts()).map(|i| of(i).map(|interval| interval.half).fold(f64::INFINITY, f64::min));
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

/// The pressures with exactly the resultant of the force in each contact: the ends have moved since they were found.
fn in_equilibrium(intervals: &[Interval], mut coefficients: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let pairs = || intervals.iter().enumerate();
    let resultants: Vec<f64> = pairs()
        .map(|(_, interval)| {
            let own = pairs().filter(|(_, other)| other.contact == interval.contact);
            own.map(|(k, other)| coefficients[k][0] * other.resultant()).sum()
        })
        .collect();
    for (own, resultant) in coefficients.iter_mut().zip(resultants) {
        own.iter_mut().for_each(|c| *c /= resultant);
    }
    coefficients
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
    /// The most that is due to something else than the number of pressures.
    floor: f64,
}

impl Errors {
    fn between(level: &Level, before: &Level) -> Self {
        let change = |new: f64, old: f64| if new == 0.0 { 0.0 } else { SAFETY * (new / old - 1.0).abs() };
        // short waves are felt where an interval is short
        let rest =
            |interval: &Interval| level.last_step + 10.0 * ROUNDING + level.left_out[interval.contact] / interval.half;
        let ends = level.intervals.iter().zip(&before.intervals).map(|(new, old)| {
            let rest = rest(new);
            [change(new.from(), old.from()) + rest, change(new.to(), old.to()) + rest]
        });
        let peaks = level.peaks().zip(before.peaks()).zip(first_of_each(&level.intervals));
        let peaks = peaks.map(|((new, old), i)| {
            // none where the bodies are apart
            if new == 0.0 { 0.0 } else { change(new, old) + rest(&level.intervals[i]) }
        });
        let peaks = peaks.collect();
        let floor = largest(level.intervals.iter().map(rest));
        Self { ends: ends.collect(), peaks, floor }
    }

    fn worst(&self) -> f64 {
        largest(self.ends.iter().flatten().chain(&self.peaks).copied())
    }
}

impl Level {
    /// Pressures on each interval.
    fn count(&self) -> usize {
        self.coefficients[0].len()
    }

    /// p(0) of each contact, per unit of P'.
    fn peaks(&self) -> impl Iterator<Item = f64> {
        first_of_each(&self.intervals).map(|i| self.intervals[i].pressure(&self.coefficients[i], 0.0))
    }
}

/// What was found of each contact.
fn found(level: &Level, errors: &Errors) -> Vec<Found> {
    let mut contacts: Vec<(usize, Found)> = Vec::new();
    let all = level.intervals.iter().zip(&level.coefficients).zip(&errors.ends);
    let mut peaks = level.peaks().zip(&errors.peaks);
    for ((interval, coefficients), [from_error, to_error]) in all {
        let (from, to) = (interval.from(), interval.to());
        let part = RightInterval { from, from_error: from_error * from, to, to_error: to_error * to };
        let strip = if interval.is_central() {
            Strip::series(interval.half, coefficients.clone())
        } else {
            let every_other = |first: usize| coefficients.iter().skip(first).step_by(2).copied().collect();
            Strip { at: interval.middle, skew: every_other(1), ..Strip::series(interval.half, every_other(0)) }
        };
        match contacts.last_mut().filter(|(contact, _)| *contact == interval.contact) {
            None => {
                let (peak, error) = peaks.next().unwrap_or((0.0, &0.0));
                let peak_error = error * peak.abs();
                let own = Found { parts: vec![part], peak, peak_error, strips: vec![strip] };
                contacts.push((interval.contact, own));
            }
            Some((_, found)) => {
                found.parts.push(part);
                found.strips.push(strip);
            }
        }
    }
    contacts.into_iter().map(|(_, found)| found).collect()
}
