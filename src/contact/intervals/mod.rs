//! Contacts in any list of intervals: bodies that touch about the middle and again farther out, are apart about the middle, or touch anywhere where
//! nothing is even.
mod anywhere;
mod columns;
mod equations;
mod gaps;
mod newton;
mod pressure;
mod space;
mod support;
#[cfg(test)]
mod tests;
mod waves;

use std::f64::consts::PI;

use crate::contact::answer::{Answer, Found};
use crate::contact::ends::newton::{LAYOUT_SERVES, Work};
use crate::contact::integrals::layout::Layout;
use crate::contact::problem::accuracy::{COARSE, ROUNDING, SAFETY};
use crate::contact::problem::iteration::Operations;
use crate::contact::problem::placed::Placed;
use crate::contact::problem::twin::Twin;
use crate::contact::problem::{Problem, Side};
use crate::contact::programme::ActiveIntervals;
use crate::contact::quality::estimates::UNKNOWN;
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::solution::{self, Stats, Strip, Warning, WarningCode};
pub(super) use anywhere::{Expected, solve as anywhere};
use gaps::Signs;
use newton::{Approximation, converge};
use support::{ContactInterval, Intervals, Parity};

/// Terms on each interval: the first number of them, doubled until the tolerance is met, and the last.
const COARSEST: usize = 12;
const FINEST: usize = 256;
/// Changes from level to level are said to fall at least this fast, and at most.
const MOST_FALL: f64 = 0.5;
const LEAST_FALL: f64 = 0.01;

/// Presses a punch on a stack some contacts of which have several intervals, about where `active` says; `None` if no admissible answer was
/// found, or the pressure under the punch is of another kind.
pub(super) fn solve(problem: &Problem, active: &[ActiveIntervals]) -> Option<Answer> {
    let is_plane = problem.twin() == Twin::Plane;
    if !is_plane || problem.sides.iter().any(Side::is_sharp) {
        return None;
    }
    // the quadratic programme may see many intervals where bodies graze each other, or several, far out, instead of one with next to no force
    let loaded = starting_intervals(problem, active, |active| active.loaded.clone())
        .filter(|loaded| loaded.0.iter().any(|interval| !interval.is_even()));
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
            if let Ok(first) = converge(problem, support.clone(), &counts, COARSE, &mut work)
                && let Some(answer) = refine(problem, first, &mut work)
            {
                return Some(answer);
            }
        }
    }
    None
}

/// As many terms as resolve waves so short that their compliance is the one of the layers at the faces of the contact alone.
fn resolved(problem: &Problem, interval: &ContactInterval) -> usize {
    let orders = 1.2 * interval.half * problem.kernel.governed_by_faces(interval.contact);
    let count = if interval.is_even() { 0.5 * orders } else { orders };
    (count as usize).min(FINEST / 2)
}

/// Goes on from a first solution with more and more terms; `None` if that is no admissible answer.
fn refine(problem: &Problem, first: Approximation, work: &mut Work) -> Option<Answer> {
    let mut before = first;
    let mut changes = [f64::INFINITY; 2];
    let mut stalls = false;
    let mut best: Option<([Approximation; 2], Errors)> = None;
    loop {
        let counts: Vec<usize> = before.counts.iter().map(|count| count + count / 2).collect();
        if counts.iter().any(|count| *count > FINEST) {
            break;
        }
        let Ok(level) = converge(problem, before.support.clone(), &counts, ROUNDING, work) else { break };
        let errors = Errors::between(&level, &before, &mut changes);
        // more terms do not help against what is due to something else
        let is_better = best.as_ref().is_none_or(|(_, best)| errors.worst() < best.worst());
        let is_done = errors.worst() <= problem.tolerance.max(2.0 * errors.floor);
        if is_better {
            best = Some(([level.clone(), before], errors));
        }
        // one change may be small by chance
        if is_done || !is_better && stalls {
            break;
        }
        (before, stalls) = (level, !is_better);
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
    let Signs { min_pressure, min_gap, tensions } = gaps::check(problem, &level, &coarse, errors.worst()).ok()?;
    // pressures in tension are wrong by that
    errors.peaks.iter_mut().zip(&tensions).for_each(|(error, tension)| *error = error.max(SAFETY * tension));
    let terms = |contact| {
        (0..level.counts.len()).filter(|k| level.support.0[*k].contact == contact).map(|k| level.counts[k]).max()
    };
    let stats = Stats {
        modes: (0..problem.contacts()).map(|contact| terms(contact).unwrap_or(1)).collect(),
        newton_steps: work.steps.clone(),
        ..problem.kernel.stats()
    };
    let contacts = found(problem, &level, &errors);
    Some(Answer { contacts, min_pressure, min_gap, tilts: tilts(problem, &level), stats, warnings })
}

/// Intervals to begin with, none where the pressure is given; `None` if a contact has none, or one that does not end, or if a flat punch
/// touches beside its middle only: no form of a pressure has one corner.
fn starting_intervals(
    problem: &Problem,
    active: &[ActiveIntervals],
    which: impl Fn(&ActiveIntervals) -> Vec<[f64; 2]>,
) -> Option<Intervals> {
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
        let corners = [problem.sides[contact].is_flat(); 2];
        intervals.extend(parts.iter().map(|part| ContactInterval::even(contact, *part).with_corners(corners)));
    }
    Some(Intervals(intervals))
}

/// Lengths of the contacts; a prescribed traction has the lengths of the contact below.
struct Lengths {
    /// As far as each contact reaches from x = 0.
    ends: Vec<f64>,
    /// Half of the shortest interval of each.
    shortest: Vec<f64>,
}

impl Lengths {
    fn of(problem: &Problem, support: &Intervals) -> Self {
        let contacts = 0..problem.contacts();
        let reach = |interval: &ContactInterval| interval.to().max(-interval.from());
        let ends = contacts.clone().map(|i| support.of(i).iter().map(reach).fold(0.0, f64::max));
        let half = |interval: &ContactInterval| interval.half;
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
    /// Estimates them from what has changed since the level before, and how much less that is than the largest changes then, of ends and of pressures.
    fn between(level: &Approximation, before: &Approximation, largest_changes: &mut [f64; 2]) -> Self {
        let apart = |(new, old): (&ContactInterval, &ContactInterval)| {
            let sizes = new.sizes();
            let moved = [new.from() - old.from(), new.to() - old.to()];
            [0, 1].map(|k| if moved[k] == 0.0 { 0.0 } else { (moved[k] / sizes[k]).abs() })
        };
        let ends: Vec<[f64; 2]> = level.support.0.iter().zip(&before.support.0).map(apart).collect();
        let by_contact = level.support.0.chunk_by(|a, b| a.contact == b.contact);
        let widest: Vec<usize> = by_contact.map(|intervals| level.widest(intervals[0].contact)).collect();
        let differ = |number: &usize| {
            // none where the bodies are apart
            let [new, old] = [level, before].map(|level| level.middle_pressure(*number));
            if new == old { 0.0 } else { (new / old - 1.0).abs() }
        };
        let peaks: Vec<f64> = widest.iter().map(differ).collect();
        let mut left = |kind: usize, change: f64| {
            let fall = change / std::mem::replace(&mut largest_changes[kind], change);
            let fall = if fall > 0.0 { fall.clamp(LEAST_FALL, MOST_FALL) } else { MOST_FALL };
            SAFETY * fall / (1.0 - fall)
        };
        let (of_ends, of_peaks) =
            (left(0, largest(ends.iter().flatten().copied())), left(1, largest(peaks.iter().copied())));
        let last = largest(level.steps.iter().map(|step| step.abs()));
        // short waves are felt where an interval is short
        let rest =
            |interval: &ContactInterval| last + 10.0 * ROUNDING + level.left_out[interval.contact] / interval.half;
        let rests: Vec<f64> = level.support.0.iter().map(rest).collect();
        let peak = |(number, change): (usize, f64)| {
            if level.middle_pressure(number) == 0.0 { 0.0 } else { of_peaks * change + rests[number] }
        };
        Self {
            ends: ends.iter().zip(&rests).map(|(own, rest)| own.map(|change| of_ends * change + rest)).collect(),
            peaks: widest.into_iter().zip(peaks).map(peak).collect(),
            floor: largest(rests),
        }
    }

    fn worst(&self) -> f64 {
        largest(self.ends.iter().flatten().chain(&self.peaks).copied())
    }
}

impl Approximation {
    /// The number of the interval of a contact whose pressure in the middle tells how well pressures are known: where something is even the first
    /// one, else the one with the largest force.
    fn widest(&self, contact: usize) -> usize {
        let first = self.support.0.partition_point(|interval| interval.contact < contact);
        let numbers = first..first + self.support.of(contact).len();
        let force = |number: usize| self.pressures[number].force();
        let others = numbers.filter(|number| self.support.0[*number].parity == Parity::None);
        others.max_by(|a, b| force(*a).total_cmp(&force(*b))).unwrap_or(first)
    }

    /// The pressure in the middle of an interval, per unit of P'; 0 of one beside x = 0 where all is even.
    fn middle_pressure(&self, number: usize) -> f64 {
        let interval = &self.support.0[number];
        if interval.parity == Parity::Pair { 0.0 } else { self.pressures[number].at(interval, 0.5 * PI) }
    }
}

/// The angles of punches that are not one at x = 0 and upright: against the layer below, and with all layers.
fn tilts(problem: &Problem, level: &Approximation) -> Vec<f64> {
    let Some(Side::Punches(punches)) = problem.sides.first() else { return Vec::new() };
    let below: f64 = level.rotations[1..].iter().flatten().sum();
    let of = |(punch, rotation): (&Placed, &f64)| punch.angle().unwrap_or(rotation + below);
    punches.iter().zip(&level.rotations[0]).map(of).collect()
}

/// What was found of each contact.
fn found(problem: &Problem, level: &Approximation, errors: &Errors) -> Vec<Found> {
    let mut peaks = errors.peaks.iter();
    let of = |contact: usize| {
        let first = level.support.0.partition_point(|interval| interval.contact < contact);
        let numbers = first..first + level.support.of(contact).len();
        let strip = |number: usize| {
            let (interval, pressure) = (&level.support.0[number], &level.pressures[number]);
            let terms = pressure.terms.iter().enumerate();
            let all: Vec<f64> = terms.map(|(m, y)| interval.unit() * y / interval.order(m) as f64).collect();
            let singular = match pressure.regular(interval).singular[..] {
                [q] => [q, q],
                [left, right] => [left, right],
                _ => [0.0; 2],
            };
            let corners = singular.map(|q| interval.unit() * q);
            if interval.is_even() {
                return Strip { corners, ..Strip::series(interval.half, all) };
            }
            let every_other = |first: usize| all.iter().skip(first).step_by(2).copied().collect();
            let series = Strip::series(interval.half, every_other(0));
            Strip { at: interval.middle, skew: every_other(1), corners, ..series }
        };
        let strips: Vec<Strip> = numbers.clone().map(strip).collect();
        let known = peaks.next().unwrap_or(&0.0);
        let ends = numbers.map(|number| {
            let (interval, sizes) = (&level.support.0[number], level.support.0[number].sizes());
            let error = |k: usize| if interval.corners[k] { 0.0 } else { errors.ends[number][k] * sizes[k] };
            let [from_error, to_error] = [0, 1].map(error);
            solution::Interval::new([interval.from(), from_error], [interval.to(), to_error])
        });
        let intervals: Vec<solution::Interval> = ends.collect();
        if level.support.of(contact).iter().all(|interval| interval.parity != Parity::None) {
            let peak = level.middle_pressure(first);
            return Found::even(&intervals, [peak, known * peak.abs()], &strips);
        }
        let peak = level.middle_pressure(level.widest(contact));
        let peak_error = known * peak.abs();
        let numbers = level.support.of(contact).iter().map(|interval| interval.punch).collect();
        Found { intervals, peak, peak_error, strips, punches: numbers }
    };
    problem.unknown().map(of).collect()
}
