//! In which order lists of intervals to begin with are tried until one leads to an answer.
//!
//! 1. Where contacts were found without layers that are thin against them, or else where formulas of contact mechanics expect them ([`formulas`]).
//! 2. Where the coarse quadratic programme sees contacts. It is asked once, and has one solution whatever the start. Where the force is to be found it is not known
//!    to the programme: where contacts are under the force that is expected.
//! 3. The pressures of the fine quadratic programme are the answer, of low accuracy and with a warning.
//!
//! Layers that weights press together begin closed, with an opening where they would pull most; 2 and 3 follow for contacts and openings together.
use crate::contact::answer::Answer;
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals::{self, Intervals, Refused};
use crate::contact::problem::accuracy::COARSE;
use crate::contact::problem::iteration::Work;
use crate::contact::problem::{Expected, Problem};
use crate::contact::programme;
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::solution::{Contact, Interval};

/// Presses punches or loads by Newton's method, from where contacts were found nearly, or where formulas expect them, or where the coarse programme sees them.
///
/// # Errors
/// [`NoSolution`], with the reason if one is known.
pub(crate) fn solve_in_order(
    problem: &Problem,
    near: Option<&[Contact]>,
    refused: &mut Refused,
) -> Result<Answer, ContactError> {
    let expected = formulas::anywhere(problem);
    let first = near.and_then(|contacts| intervals::of_contacts(problem, contacts));
    let first = first.or_else(|| intervals::of_formulas(problem, &expected));
    solve_from(problem, first, (&expected, || Some(problem.kernel)), refused)
}

/// The same from a first list, if there is one; the quadratic programme begins where contacts and openings are expected, on the kernel in which all layers that may come apart are laminates of their own.
///
/// # Errors
/// [`NoSolution`], with the reason if one is known.
pub(crate) fn solve_from<'k>(
    problem: &Problem,
    first: Option<Intervals>,
    (expected, laminates): (&[Expected], impl Fn() -> Option<&'k Kernel>),
    refused: &mut Refused,
) -> Result<Answer, ContactError> {
    let mut work = Work::at_most(problem.operations);
    let mut solve = |list: Intervals, refused: &mut Refused| intervals::solve(problem, list, refused, &mut work);
    let mut solved = first.and_then(|list| solve(list, refused));
    if solved.is_none() {
        let second = match problem.prescribed.is_empty() || problem.kernel.has_openings() {
            false => under_expected_force(problem),
            true => laminates()
                .and_then(|laminates| programme::touching(problem, laminates, expected, refused.far))
                .and_then(|touching| intervals::of_formulas(problem, &touching)),
        };
        solved = second.and_then(|list| solve(list, refused));
    }
    let refuse = || refused.reason.clone().unwrap_or_else(|| NoSolution::NotConverged.into());
    solved.ok_or_else(refuse).and_then(|answer| on_punches(problem, answer))
}

/// The pressures of the fine programme where Newton's method has failed.
///
/// # Errors
/// The error of Newton's method where the programme has no solution, or one with an error that is too large.
pub(crate) fn of_low_accuracy<'k>(
    problem: &Problem,
    (expected, laminates): (&[Expected], impl Fn() -> Option<&'k Kernel>),
    refused: &Refused,
    error: ContactError,
) -> Result<Answer, ContactError> {
    let laminates = if problem.prescribed.is_empty() { laminates() } else { None };
    let answer = laminates.and_then(|laminates| programme::answer(problem, laminates, expected, refused.far));
    answer.ok_or(error).and_then(|answer| on_punches(problem, answer))
}

/// Where contacts are under the force that is expected to bring about what is prescribed: below the punch, as much longer or shorter as the contact of the punch is to be.
fn under_expected_force(problem: &Problem) -> Option<Intervals> {
    let given = Problem { prescribed: Vec::new(), ..problem.on(problem.kernel, problem.interfaces, COARSE) };
    let mut refused = Refused::default();
    let answer = solve_in_order(&given, None, &mut refused);
    let of_low_accuracy =
        |error| of_low_accuracy(&given, (&formulas::anywhere(&given), || Some(given.kernel)), &refused, error);
    let mut contacts = answer.or_else(of_low_accuracy).ok()?.contacts;
    if let Some(half) = problem.prescribed_end().filter(|_| problem.is_even()) {
        let found = contacts.first()?.half_length()?;
        for contact in &mut contacts {
            let Some(own) = contact.half_length() else { continue };
            let half = half.hypot((own * own - found * found).max(0.0).sqrt());
            contact.intervals = vec![Interval::new([-half, 0.0], [half, 0.0])];
        }
    }
    intervals::of_contacts(problem, &contacts)
}

/// An answer whose contacts do not reach beyond their punches.
fn on_punches(problem: &Problem, answer: Answer) -> Result<Answer, ContactError> {
    let mut reaches = vec![0.0; problem.contacts()];
    problem.unknown().zip(&answer.contacts).for_each(|(contact, found)| reaches[contact] = found.reach());
    problem.too_small(&reaches).map_or(Ok(answer), Err)
}
