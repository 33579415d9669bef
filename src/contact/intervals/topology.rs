//! How the list of intervals changes until no pressure and no gap is negative.
use std::f64::consts::PI;

use crate::contact::answer::Answer;
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals::gaps::Fault;
use crate::contact::intervals::newton::{Approximation, Failure, TOGETHER, converge};
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::intervals::{first_count, refine};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, SAFETY};
use crate::contact::problem::iteration::Work;
use crate::contact::problem::twin::Twin;

/// Changes of the list at most.
const MOST_CHANGES: usize = 30;
/// The usual number of terms is multiplied by this at most before a list is changed.
const FINER: usize = 16;

/// Presses punches or loads, from a list of intervals where contacts may be, with the usual number of terms times `finer`; `None`, with what is known of the reason, if no
/// list was found without tension and penetration.
pub(crate) fn solve(
    problem: &Problem,
    start: Intervals,
    finer: usize,
    refused: &mut Refused,
    work: &mut Work,
) -> Option<Answer> {
    work.start();
    let note = |last: Intervals| refused.reason = refused.reason.take().or_else(|| outgrown(problem, &last.0));
    follow(problem, start, finer, work, &mut refused.far).map_err(note).ok()
}

/// Why lists of intervals lead to no answer.
#[derive(Debug, Default)]
pub(crate) struct Refused {
    /// [`NoSolution::PunchTooSmall`] if a contact has grown to the edge of its punch, [`NoSolution::PunchesMeet`] if two have grown together; else nothing.
    pub(crate) reason: Option<ContactError>,
    /// How far from x = 0 bodies were seen to penetrate each other.
    pub(crate) far: f64,
}

/// Changes a list of intervals until it is an answer, with the usual number of terms times `finer`, or leaves intervals out that carry next to nothing; the last list if
/// it does not become one.
fn follow(
    problem: &Problem,
    support: Intervals,
    finer: usize,
    work: &mut Work,
    far: &mut f64,
) -> Result<Answer, Intervals> {
    let mut penetrating = None;
    changed(problem, support, finer, &mut penetrating, work).or_else(|last| {
        let Some((level, at)) = penetrating else { return Err(last) };
        *far = far.max(at.abs());
        refine(problem, level, true, work).map_err(|_| last)
    })
}

/// The same without leaving any out, and the first solution in which bodies penetrate each other, and where.
fn changed(
    problem: &Problem,
    mut support: Intervals,
    mut finer: usize,
    penetrating: &mut Option<(Approximation, f64)>,
    work: &mut Work,
) -> Result<Answer, Intervals> {
    for _ in 0..MOST_CHANGES {
        support = support.held(problem);
        // discs are all there is about an axis
        if support.0.iter().any(|interval| interval.twin == Twin::Round && !interval.is_even()) {
            break;
        }
        work.steps.clear();
        let of = |finer: usize| support.0.iter().map(|interval| first_count(problem, interval, finer)).collect();
        let (mut counts, most): (Vec<usize>, Vec<usize>) = (of(finer), of(FINER));
        // the list is not changed for what more terms may mend
        let may_grow = finer < FINER && counts != most;
        support.equalise(&mut counts);
        support = match converge(problem, support, None, &counts, COARSE, work) {
            Ok(level) => match tension(problem, &level) {
                Tension::Split(split) if !may_grow => split,
                Tension::Split(_) | Tension::Unresolved if finer < FINER => {
                    finer *= 2;
                    level.support
                }
                _ => match checked(problem, &level, work) {
                    Ok(answer) => return Ok(answer),
                    Err(Some(_)) if may_grow => {
                        finer *= 2;
                        level.support
                    }
                    Err(Some((next, at))) => {
                        penetrating.get_or_insert((level, at));
                        next
                    }
                    Err(None) => return Err(level.support),
                },
            },
            Err(Failure::Changed(next)) => next,
            Err(Failure::Stuck(last)) => return Err(last),
        };
    }
    Err(support)
}

/// The error that a punch is too small, if an interval under it has grown to its edge, or that the intervals of two punches meet.
fn outgrown(problem: &Problem, intervals: &[ContactInterval]) -> Option<ContactError> {
    let too_small = intervals.iter().find_map(|interval| {
        let punch = problem.placed(interval.contact, interval.punch)?;
        [interval.from(), interval.to()].into_iter().find_map(|end| punch.too_small(end))
    });
    let meet = |pair: &[ContactInterval]| {
        let is_short = pair[1].from() - pair[0].to() < TOGETHER * pair[0].half.min(pair[1].half);
        let are_two = pair[0].contact == pair[1].contact && pair[0].punch != pair[1].punch;
        (is_short && are_two).then(|| NoSolution::PunchesMeet { left: pair[0].punch + 1 }.into())
    };
    too_small.or_else(|| intervals.windows(2).find_map(meet))
}

/// The answer, or a list that is nearer to it, if there is one, with the place where bodies penetrate each other.
fn checked(problem: &Problem, level: &Approximation, work: &mut Work) -> Result<Answer, Option<(Intervals, f64)>> {
    refine(problem, level.clone(), false, work).map_err(|fault| match fault {
        Some(Fault::Penetration { contact, punch, at, over }) => {
            Some((with_interval(&level.support, (contact, punch), at, over), at))
        }
        Some(Fault::Tension | Fault::Unknown) | None => None,
    })
}

/// What is done about tension within intervals.
enum Tension {
    None,
    /// As much as terms that are missing may make.
    Unresolved,
    /// The list with an interval split about where its pressure is negative.
    Split(Intervals),
}

/// Looks for negative pressures, and whether fewer terms have them, too.
fn tension(problem: &Problem, level: &Approximation) -> Tension {
    let mut found = Tension::None;
    let all = level.support.0.iter().zip(&level.solved.pressures).zip(&level.coarser[0].pressures).enumerate();
    for (number, ((interval, pressure), coarser)) in
        all.filter(|(_, ((interval, _), _))| !problem.sides[interval.contact].is_joined())
    {
        let places = pressure.places(interval);
        let [own, coarser] = [pressure, coarser].map(|pressure| pressure.regular(interval).inside(interval, places));
        let mean = pressure.mean(interval);
        let is_negative = |k: &usize| own[*k] < -COARSE * mean;
        let is_certain = |k: &usize| is_negative(k) && own[*k] < -SAFETY * (own[*k] - coarser[*k]).abs();
        let Some(first) = (0..own.len()).find(is_certain) else {
            if (0..own.len()).any(|k| is_negative(&k)) {
                found = Tension::Unresolved;
            }
            continue;
        };
        let last = (first..own.len()).take_while(|k| own[*k] < 0.0).last().unwrap_or(first);
        let first = (0..=first).rev().take_while(|k| own[*k] < 0.0).last().unwrap_or(first);
        let place = |k: usize| interval.place(PI * (k + 1) as f64 / places as f64);
        // tension about the middle of what is even leaves the outer part only
        let inner = (!interval.is_even() || last + 1 < own.len()).then(|| [interval.from(), place(last)]);
        let [left, right] = interval.corners;
        let inner = inner.map(|ends| interval.between(ends).with_corners([left && !interval.is_even(), false]));
        let outer = interval.between([place(first), interval.to()]).with_corners([false, right]);
        let parts: Vec<ContactInterval> = inner.into_iter().chain([outer]).filter(|part| part.half > 0.0).collect();
        if parts.is_empty() {
            found = Tension::Unresolved;
            continue;
        }
        let mut all = level.support.0.clone();
        all.splice(number..=number, parts);
        return Tension::Split(Intervals(all));
    }
    found
}

/// The list with an interval about a place of penetration, half as wide as that.
fn with_interval(support: &Intervals, (contact, punch): (usize, usize), at: f64, over: [f64; 2]) -> Intervals {
    let mut all = support.0.clone();
    let ends = over.map(|end| 0.5 * (at + end));
    let interval = ContactInterval { contact, punch, ..all[0] }.between(ends);
    let place = all.partition_point(|other| (other.contact, other.middle) < (contact, interval.middle));
    all.insert(place, interval);
    Intervals(all)
}
