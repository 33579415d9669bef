//! How the list of intervals changes until no pressure and no gap is negative.
use crate::contact::answer::Answer;
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals::changes::TOGETHER;
use crate::contact::intervals::gaps::Fault;
use crate::contact::intervals::newton::{Approximation, Failure, converge};
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::intervals::tension::{Tension, tension};
use crate::contact::intervals::{first_count, refine};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, SLOW};
use crate::contact::problem::iteration::Work;
use crate::contact::problem::twin::Twin;

/// Presses punches or loads, from a list of intervals where contacts may be; `None`, with what is known of the reason, if no
/// list was found without tension and penetration.
pub(crate) fn solve(problem: &Problem, start: Intervals, refused: &mut Refused, work: &mut Work) -> Option<Answer> {
    work.start();
    let mut penetrating = None;
    let solved = changed(problem, start, &mut penetrating, work).or_else(|last| {
        let Some((level, at)) = penetrating else { return Err(last) };
        refused.far = refused.far.max(at.abs());
        // intervals that carry next to nothing are left out, and no other start follows
        work.finish();
        refine(problem, level, true, work).map_err(|_| last)
    });
    solved.map_err(|last| refused.reason = outgrown(problem, &last.0).or_else(|| refused.reason.take())).ok()
}

/// Why lists of intervals lead to no answer.
#[derive(Debug, Default)]
pub(crate) struct Refused {
    /// [`NoSolution::PunchTooSmall`] if a contact has grown to the edge of its punch, [`NoSolution::PunchesMeet`] if two have grown together; else nothing.
    pub(crate) reason: Option<ContactError>,
    /// How far from x = 0 bodies were seen to penetrate each other.
    pub(crate) far: f64,
}

/// Changes a list of intervals until it is an answer without leaving any out, and notes the first solution in which bodies penetrate each other, and where; the last list if it
/// does not become one.
fn changed(
    problem: &Problem,
    mut support: Intervals,
    penetrating: &mut Option<(Approximation, f64)>,
    work: &mut Work,
) -> Result<Answer, Intervals> {
    // the usual number of terms is multiplied by 16 at most before a list is changed
    let (mut finer, mut deepest, may_grow) = (1, None, |finer: usize| finer < 16);
    let mut before: Vec<(Intervals, usize)> = Vec::new();
    for _ in 0..30 {
        support = support.held(problem);
        // no list twice, but with more terms
        let is_known = |finer: usize| before.iter().any(|(list, terms)| *terms == finer && list.is_near(&support));
        while is_known(finer) && may_grow(finer) {
            finer *= 2;
        }
        if is_known(finer) {
            break;
        }
        before.push((support.clone(), finer));
        // discs are all there is about an axis
        if support.0.iter().any(|interval| interval.twin == Twin::Round && !interval.is_even()) {
            break;
        }
        work.steps.clear();
        let count = |interval: &ContactInterval| first_count(problem, interval, finer);
        let mut counts: Vec<usize> = support.0.iter().map(count).collect();
        support.equalise(&mut counts);
        let start = support.clone();
        support = match converge(problem, support, None, &counts, COARSE, work) {
            Ok(level) => match examined(problem, &level, may_grow(finer), work) {
                Ok(answer) => return Ok(answer),
                Err(None) => return Err(level.support),
                Err(Some(wrong)) if may_grow(finer) && deepest.is_none_or(|last| wrong.is_mended_since(last)) => {
                    (finer, deepest) = (2 * finer, Some((wrong.at, wrong.depth)));
                    level.support
                }
                Err(Some(Wrong { next, at, .. })) => {
                    if let Some(at) = at {
                        // an answer without the new interval may have to do
                        work.start();
                        penetrating.get_or_insert((level, at));
                    }
                    (finer, deepest) = (1, None);
                    next
                }
            },
            Err(Failure::Changed(next)) => next,
            Err(Failure::Stuck(last)) if may_grow(finer) && last.opens() => {
                finer *= 2;
                start
            }
            Err(Failure::Stuck(last)) => return Err(last),
        };
    }
    Err(support)
}

/// What is wrong with the signs of a solution.
struct Wrong {
    /// The list that is nearer to the answer: the same one where more terms are to tell.
    next: Intervals,
    /// The largest tension or, at a place, penetration; infinite where more terms are to tell.
    depth: f64,
    at: Option<f64>,
}

impl Wrong {
    /// Whether the terms that were added since the last solution on the list have mended much of it: the list is not changed for what more of them mend.
    fn is_mended_since(&self, (at, depth): (Option<f64>, f64)) -> bool {
        self.depth.is_infinite() || at.is_some() != self.at.is_some() || self.depth < SLOW * depth
    }
}

/// The answer that follows from a solution, or what is wrong with its signs; nothing if there is no answer for another reason.
fn examined(
    problem: &Problem,
    level: &Approximation,
    may_grow: bool,
    work: &mut Work,
) -> Result<Answer, Option<Wrong>> {
    match tension(problem, level) {
        Tension::Certain(next, depth) => return Err(Some(Wrong { next, depth, at: None })),
        Tension::Unresolved if may_grow => {
            let (next, depth) = (level.support.clone(), f64::INFINITY);
            return Err(Some(Wrong { next, depth, at: None }));
        }
        Tension::Unresolved | Tension::None => {}
    }
    refine(problem, level.clone(), false, work).map_err(|fault| match fault {
        Some(Fault::Penetration { contact, punch, at, depth, over }) => {
            let next = with_interval(problem, &level.support, (contact, punch), at, over);
            Some(Wrong { next, depth, at: Some(at) })
        }
        // a short opening may not be there with few terms
        Some(Fault::Tension) | None if may_grow && level.support.opens() => {
            Some(Wrong { next: level.support.clone(), depth: f64::INFINITY, at: None })
        }
        Some(Fault::Tension | Fault::Unknown) | None => None,
    })
}

/// The error that a punch is too small, if an interval under it has grown to its edge, or that the intervals of two punches meet.
fn outgrown(problem: &Problem, intervals: &[ContactInterval]) -> Option<ContactError> {
    let too_small = intervals.iter().find_map(|interval| {
        let punch = problem.placed(interval.contact, interval.punch)?;
        let error = [interval.from(), interval.to()].into_iter().find_map(|end| punch.too_small(end))?;
        Some(error.at(interval.contact))
    });
    let meet = |pair: &[ContactInterval]| {
        let is_short = pair[1].from() - pair[0].to() < TOGETHER * pair[0].half.min(pair[1].half);
        let are_two = pair[0].contact == pair[1].contact && pair[0].punch != pair[1].punch;
        (is_short && are_two).then(|| NoSolution::PunchesMeet { left: pair[0].punch + 1 }.into())
    };
    too_small.or_else(|| intervals.windows(2).find_map(meet))
}

impl Intervals {
    /// Whether something opens.
    fn opens(&self) -> bool {
        self.0.iter().any(|interval| interval.opens)
    }

    /// Whether another list has the ends of this one, but for a thousandth of the half-lengths.
    fn is_near(&self, other: &Self) -> bool {
        let is_like = |(one, other): (&ContactInterval, &ContactInterval)| {
            let moved = [one.from() - other.from(), one.to() - other.to()];
            (one.contact, one.punch) == (other.contact, other.punch)
                && moved.iter().all(|by| by.abs() < 1e-3 * one.half)
        };
        self.0.len() == other.0.len() && self.0.iter().zip(&other.0).all(is_like)
    }
}

/// The list with an interval about a place of penetration, half as wide as that, or about x = 0 if all is even and it reaches so far.
fn with_interval(
    problem: &Problem,
    support: &Intervals,
    (contact, punch): (usize, usize),
    at: f64,
    over: [f64; 2],
) -> Intervals {
    let mut all = support.0.clone();
    let is_middle = problem.is_even() && over[0] <= 0.0;
    let ends = over.map(|end| if is_middle && end <= 0.0 { 0.0 } else { 0.5 * (at + end) });
    let interval = match problem.is_opened(contact) {
        true => ContactInterval::opening(problem, contact, ends),
        false => ContactInterval { contact, punch, ..all[0] }.between(ends),
    };
    let place = all.partition_point(|other| (other.contact, other.middle) < (contact, interval.middle));
    all.insert(place, interval);
    Intervals(all)
}
