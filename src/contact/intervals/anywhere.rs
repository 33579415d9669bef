//! Intervals where nothing is even: where they begin, and how their list changes until no pressure and no gap is negative.
use std::f64::consts::PI;

use crate::contact::answer::Answer;
use crate::contact::ends::newton::Work;
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals::gaps::{self, Fault};
use crate::contact::intervals::newton::{Approximation, Failure, converge};
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::intervals::{COARSEST, refine, resolved};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, PER_MODE};
use crate::contact::problem::iteration::Operations;

/// Changes of the list at most.
const MOST_CHANGES: usize = 30;

/// An interval to begin with, in units of L.
pub(crate) struct Expected {
    pub(crate) contact: usize,
    pub(crate) punch: usize,
    pub(crate) ends: [f64; 2],
}

/// Presses punches or loads that are not even, from where contacts are expected.
///
/// # Errors
/// [`NoSolution::NotConverged`] if no list of intervals was found without tension and penetration.
pub(crate) fn solve(problem: &Problem, expected: &[Expected]) -> Result<Answer, ContactError> {
    let mut work = Work { operations: Operations::at_most(problem.operations), ..Work::default() };
    let of = |Expected { contact, punch, ends }: &Expected| ContactInterval::anywhere(*contact, *punch, *ends);
    let mut support = Intervals(expected.iter().map(of).collect());
    for _ in 0..MOST_CHANGES {
        work.steps.clear();
        let counts: Vec<usize> =
            support.0.iter().map(|interval| resolved(problem, interval).clamp(COARSEST, 4 * COARSEST)).collect();
        let next = match converge(problem, support.clone(), &counts, COARSE, &mut work) {
            Ok(level) => match negative(&level) {
                Some(split) => Some(split),
                None => match checked(problem, &level, &mut work) {
                    Ok(answer) => return Ok(answer),
                    Err(next) => next,
                },
            },
            Err(failure) => changed(failure),
        };
        let Some(next) = next else { break };
        support = next;
    }
    Err(NoSolution::NotConverged.into())
}

/// The answer, or a list that is nearer to it, if there is one.
fn checked(problem: &Problem, level: &Approximation, work: &mut Work) -> Result<Answer, Option<Intervals>> {
    match gaps::check(problem, level, level, COARSE) {
        Ok(_) => refine(problem, level.clone(), work).ok_or(None),
        Err(Fault::Penetration { contact, punch, at, over }) => {
            Err(Some(with_interval(&level.support, (contact, punch), at, over)))
        }
        Err(Fault::Tension | Fault::Unknown) => Err(None),
    }
}

/// The list with an interval split where its pressure is negative between places where it is not; `None` if none is.
fn negative(level: &Approximation) -> Option<Intervals> {
    for (number, (interval, pressure)) in level.support.0.iter().zip(&level.pressures).enumerate() {
        let places = 2 * PER_MODE * pressure.terms.len();
        let phi = |k: usize| PI * k as f64 / places as f64;
        let regular = pressure.regular();
        let all: Vec<f64> = (1..places).map(|k| regular.at(interval, phi(k))).collect();
        let largest = all.iter().copied().fold(0.0, f64::max);
        let is_negative = |k: &usize| all[*k] < -COARSE * largest;
        let Some(first) = (0..all.len()).find(is_negative) else { continue };
        let last = (first..all.len()).take_while(|k| all[*k] < 0.0).last().unwrap_or(first);
        let place = |k: usize| interval.middle + interval.half * phi(k + 1).cos();
        let mut parts = level.support.0.clone();
        let ends = [[interval.from(), place(last)], [place(first), interval.to()]];
        let parts_of = ends.map(|ends| ContactInterval::anywhere(interval.contact, interval.punch, ends));
        parts.splice(number..=number, parts_of.into_iter().filter(|part| part.half > 0.0));
        return Some(Intervals(parts));
    }
    None
}

/// The list with an interval about a place of penetration, half as wide as that.
fn with_interval(support: &Intervals, (contact, punch): (usize, usize), at: f64, over: [f64; 2]) -> Intervals {
    let mut all = support.0.clone();
    let ends = over.map(|end| 0.5 * (at + end));
    let interval = ContactInterval::anywhere(contact, punch, ends);
    let place = all.partition_point(|other| (other.contact, other.middle) < (contact, interval.middle));
    all.insert(place, interval);
    Intervals(all)
}

/// The list after a failure: without an interval that vanishes, or with two as one that meet.
fn changed(failure: Failure) -> Option<Intervals> {
    match failure {
        Failure::Vanishes(Intervals(mut all), number) => {
            all.remove(number);
            Some(Intervals(all))
        }
        Failure::Meet(Intervals(mut all), number) => {
            let next = all.remove(number + 1);
            let own = &mut all[number];
            *own = ContactInterval::anywhere(own.contact, own.punch, [own.from(), next.to()]);
            Some(Intervals(all))
        }
        Failure::Other => None,
    }
}
