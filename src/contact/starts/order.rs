//! In which order lists of intervals to begin with are tried until one leads to an answer.
//!
//! 1. Where formulas of contact mechanics expect contacts ([`formulas`]), with few terms.
//! 2. Where the coarse quadratic programme sees contacts. It is asked once, and has one solution whatever the start. Where the force is to be found it is not known
//!    to the programme: where contacts are under the force that is expected.
//! 3. Both again, with more terms.
//! 4. The pressures of the fine quadratic programme are the answer, of low accuracy and with a warning.
use crate::contact::answer::Answer;
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals::{self, Intervals, Refused};
use crate::contact::problem::accuracy::COARSE;
use crate::contact::problem::iteration::Work;
use crate::contact::problem::{Prescribed, Problem};
use crate::contact::programme;
use crate::contact::starts::formulas;
use crate::solution::{Contact, Interval};

/// What tells the list to begin with.
#[derive(Clone, Copy)]
enum Start {
    Formulas,
    Programme,
}

/// What is tried one after the other, with how many times the usual number of terms: few terms take the least; where they lead nowhere, twice as many may not.
const TRIED: [(Start, usize); 6] = [
    (Start::Formulas, 1),
    (Start::Programme, 1),
    (Start::Formulas, 2),
    (Start::Formulas, 4),
    (Start::Programme, 2),
    (Start::Programme, 4),
];

/// Where contacts are under the force that is expected to bring about what is prescribed: below the punch, as much longer or shorter as the contact of the punch is to be.
fn under_expected_force(problem: &Problem) -> Option<Intervals> {
    let given = Problem { prescribed: None, ..problem.on(problem.kernel, problem.interfaces, COARSE) };
    let mut contacts = solve_in_order(&given).ok()?.contacts;
    if let Some(Prescribed::HalfLength(half)) = problem.prescribed {
        let found = contacts.first()?.half_length()?;
        for contact in &mut contacts {
            let Some(own) = contact.half_length() else { continue };
            let half = half.hypot((own * own - found * found).max(0.0).sqrt());
            contact.intervals = vec![Interval::new([-half, 0.0], [half, 0.0])];
        }
    }
    intervals::of_contacts(problem, &contacts)
}

/// Presses punches or loads.
///
/// # Errors
/// [`NoSolution`], with the reason if one is known.
pub(crate) fn solve_in_order(problem: &Problem) -> Result<Answer, ContactError> {
    // formulas may expect contacts that are too long: the punch is too small for certain if it is for the shortest one there can be under a given force
    if problem.prescribed.is_none()
        && problem.too_small(&formulas::half_lengths(problem)).is_some()
        && let Some(error) = problem.too_small(&formulas::shortest(problem))
    {
        return Err(error);
    }
    let expected = formulas::anywhere(problem);
    let of_formulas = intervals::of_formulas(problem, &expected);
    let ask = |far: f64| {
        if problem.prescribed.is_some() {
            return under_expected_force(problem).into_iter().collect();
        }
        intervals::of_programme(problem, &programme::active(problem, &expected, far).unwrap_or_default())
    };
    let mut work = Work::at_most(problem.operations);
    let (mut refused, mut seen) = (Refused::default(), None);
    let solved = TRIED.into_iter().find_map(|(start, finer)| {
        let lists = match start {
            Start::Formulas => of_formulas.as_slice(),
            Start::Programme => seen.get_or_insert_with(|| ask(refused.far)),
        };
        lists.iter().find_map(|list| intervals::solve(problem, list.clone(), finer, &mut refused, &mut work))
    });
    let low = || problem.prescribed.map_or_else(|| programme::answer(problem, &expected, refused.far), |_| None);
    let Some(answer) = solved.or_else(low) else {
        return Err(refused.reason.unwrap_or_else(|| NoSolution::NotConverged.into()));
    };
    let reaches: Vec<f64> = answer.contacts.iter().map(Contact::reach).collect();
    problem.too_small(&reaches).map_or(Ok(answer), Err)
}
