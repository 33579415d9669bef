//! In which order lists of intervals to begin with are tried until one leads to an answer.
//!
//! 1. Where formulas of contact mechanics expect contacts ([`formulas`]), with few terms.
//! 2. Where all is even: where the quadratic programme sees contacts. It is asked once, and has one solution whatever the start.
//! 3. Both again, with more terms.
//! 4. Where all is even: the pressures of the quadratic programme are the answer, of low accuracy and with a warning.
use std::cell::{OnceCell, RefCell};

use crate::contact::answer::{Answer, Found};
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals::{self, Intervals, ROUNDS, Refused};
use crate::contact::problem::Problem;
use crate::contact::problem::iteration::Operations;
use crate::contact::programme;
use crate::contact::starts::formulas;

/// Presses punches or loads.
///
/// # Errors
/// [`NoSolution`], with the reason if one is known.
pub(crate) fn solve_in_order(problem: &Problem) -> Result<Answer, ContactError> {
    let expected = formulas::half_lengths(problem);
    // formulas may expect contacts that are too long: the punch is too small for certain if it is for the shortest one there can be
    if problem.too_small(&expected).is_some()
        && let Some(error) = problem.too_small(&formulas::shortest(problem))
    {
        return Err(error);
    }
    let mut operations = Operations::at_most(problem.operations);
    let failed = RefCell::new(Refused::default());
    let mut solve = |starts: &[Intervals], finer: &[usize]| {
        let solved = intervals::solve(problem, starts, finer, &mut operations);
        let note = |refused: Refused| {
            let mut all = failed.borrow_mut();
            all.reason = all.reason.take().or(refused.reason);
            all.far = all.far.max(refused.far);
        };
        solved.map_err(note).ok()
    };
    let start = intervals::of_formulas(problem, &formulas::anywhere(problem));
    let ask = || {
        let far = failed.borrow().far;
        if problem.is_even() { programme::cycles(problem, &expected, far) } else { Vec::new() }
    };
    let cycles = OnceCell::new();
    let seen = || intervals::of_programme(problem, &programme::touching(cycles.get_or_init(ask)));
    let solved = solve(start.as_slice(), &ROUNDS[..1])
        .or_else(|| solve(seen().as_slice(), &ROUNDS[..1]))
        .or_else(|| solve(start.as_slice(), &ROUNDS[1..]))
        .or_else(|| solve(seen().as_slice(), &ROUNDS[1..]));
    let answer = match solved {
        Some(answer) => answer,
        None => {
            let low = programme::answer(problem, cycles.get_or_init(ask));
            low.ok_or_else(|| failed.take().reason.unwrap_or_else(|| NoSolution::NotConverged.into()))?
        }
    };
    let reaches: Vec<f64> = answer.contacts.iter().map(Found::reach).collect();
    problem.too_small(&reaches).map_or(Ok(answer), Err)
}
