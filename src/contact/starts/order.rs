//! In which order starting points are tried until one leads to an admissible solution.
//!
//! 1. Closed-form estimates of the half-lengths ([`super::formulas`]).
//! 2. The coarse quadratic programme, asked once the former have failed: it cannot converge to a non-physical root. Where it
//!    sees several intervals in a contact, [`intervals`] solves for these; else Newton's method begins at its ends.
//! 3. If that fails, [`intervals`] looks for the list of intervals from there, and from the closed-form estimates.
//! 4. The fine quadratic programme gives the low-accuracy answer, with a warning, unless there is a solution with a large error
//!    estimate that has the same pressures.
use crate::contact::answer::{Answer, Found};
use crate::contact::ends::newton::Work;
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::COARSE;
use crate::contact::problem::estimate::Estimate;
use crate::contact::problem::iteration::Operations;
use crate::contact::programme::{self, ActiveIntervals};
use crate::contact::quality::admissible;
use crate::contact::quality::answer::answer;
use crate::contact::quality::estimates::{ENDLESS, UNKNOWN};
use crate::contact::quality::levels::{Start, refine};
use crate::contact::starts::formulas;
use crate::numeric::largest;
use crate::solution::Interface;

/// The quadratic programme confirms half-lengths that differ from its own by less than this, in the logarithm.
const CONFIRMED: f64 = 0.1;

/// An admissible answer, and the contacts with intervals of re-contact the force in which is left out.
struct Attempt {
    answer: Answer,
    recontacts: Vec<Interface>,
}

/// Tries starting points in order of cost, as above.
pub(crate) fn solve_in_order(problem: &Problem) -> Result<Answer, ContactError> {
    let work = Work { operations: Operations::at_most(problem.operations), ..Work::default() };
    let mut search = Search { problem, work, expected: Vec::new(), doubtful: None, several: None, far: 0.0 };
    search.expected = formulas::half_lengths(problem);
    // formulas may expect contacts that are too long: the punch is too small for certain if it is for the shortest one there can be
    if problem.too_small(&search.expected).is_some()
        && let Some(error) = problem.too_small(&formulas::shortest(problem))
    {
        return Err(error);
    }
    let answer = match search.run()? {
        Outcome::Solved(answer) => *answer,
        Outcome::Failed(failure) => {
            let doubtful = search.doubtful.take().filter(|(_, attempt)| search.knows_all(attempt));
            match (doubtful, programme::answer(problem, &search.expected, search.far)) {
                // the quadratic programme has one solution only; its pressures decide, not its ends, which it resolves badly where
                // pressures are small
                (Some((_, attempt)), Some(low)) if !agree(&attempt.answer, &low) => low,
                (Some((_, attempt)), _) => attempt.answer,
                (None, low) => low.ok_or(*failure)?,
            }
        }
    };
    let reaches: Vec<f64> = answer.contacts.iter().map(Found::reach).collect();
    problem.too_small(&reaches).map_or(Ok(answer), Err)
}

/// How a step of the search ended, unless there is no solution for certain.
enum Outcome {
    Solved(Box<Answer>),
    Failed(Box<ContactError>),
}

struct Search<'a> {
    problem: &'a Problem<'a>,
    work: Work,
    /// Half-lengths by formulas.
    expected: Vec<f64>,
    /// The best solution with a large error estimate, how many of its ends are not known, and the estimate of the others: Newton's
    /// method may have converged to a non-physical root.
    doubtful: Option<((usize, f64), Attempt)>,
    /// A contact that has several intervals for certain.
    several: Option<Interface>,
    /// How far out the quadratic programme has looked for contact.
    far: f64,
}

impl Search<'_> {
    fn run(&mut self) -> Result<Outcome, ContactError> {
        let problem = self.problem;
        let failure = match self.attempt(Start::Guess { half_lengths: self.expected.clone() })? {
            Outcome::Failed(failure) => failure,
            solved => return Ok(solved),
        };
        let start = intervals::of_formulas(problem, &formulas::anywhere(problem));
        if let Ok(answer) =
            intervals::solve(problem, start.as_slice(), &intervals::ROUNDS[..1], &mut self.work.operations)
        {
            return Ok(Outcome::Solved(Box::new(answer)));
        }
        self.far = match *failure {
            ContactError::NoSolution(NoSolution::Penetration { x, .. }) => x / problem.kernel.length(),
            _ => 0.0,
        };
        let active = programme::active(problem, &self.expected, self.far).unwrap_or_default();
        let mut starts = intervals::of_programme(problem, &active);
        let certain = several(problem, &active, true);
        // intervals of re-contact that a solution leaves out may be short
        let left_out = self.doubtful.as_ref().is_some_and(|(_, attempt)| !attempt.recontacts.is_empty());
        if certain.is_some() || left_out && several(problem, &active, false).is_some() {
            if let Ok(answer) =
                intervals::solve(problem, &std::mem::take(&mut starts), &intervals::ROUNDS, &mut self.work.operations)
            {
                return Ok(Outcome::Solved(Box::new(answer)));
            }
            // one of the intervals may carry a force next to nothing
            self.several = certain.map(|i| problem.interfaces[i]);
        }
        if let Some(answer) = self.confirmed(&active) {
            return Ok(Outcome::Solved(Box::new(answer)));
        }
        let failure = match self.attempt(Start::Cold { half_lengths: self.ends(&active) })? {
            Outcome::Failed(failure) => failure,
            solved => return Ok(solved),
        };
        for (starts, finer) in [(&starts[..], &intervals::ROUNDS[..]), (start.as_slice(), &intervals::ROUNDS[1..])] {
            if let Ok(answer) = intervals::solve(problem, starts, finer, &mut self.work.operations) {
                return Ok(Outcome::Solved(Box::new(answer)));
            }
        }
        Ok(Outcome::Failed(certain.map_or(failure, |i| Box::new(self.error(&active, i)))))
    }

    /// Newton's method from a start; a solution that may belong to a non-physical root is kept aside.
    fn attempt(&mut self, start: Start) -> Result<Outcome, ContactError> {
        let attempt = match self.solve_from(start) {
            Ok(attempt) => attempt,
            Err(failure @ ContactError::NoSolution(_)) => return Ok(Outcome::Failed(Box::new(failure))),
            Err(error) => return Err(error),
        };
        let contacts = &attempt.answer.contacts;
        let errors = contacts.iter().map(|contact| contact.innermost().end_error());
        let endless = errors.clone().filter(|error| *error >= ENDLESS).count();
        let worst = largest(errors.filter(|error| error.is_nan() || *error < ENDLESS));
        let knows_all = self.knows_all(&attempt);
        // a solution of few digits may know more ends
        let knows_most = self.doubtful.as_ref().is_none_or(|((fewer, _), _)| endless <= *fewer);
        if knows_all && knows_most && (attempt.answer.warnings.is_empty() || worst <= COARSE) {
            return Ok(Outcome::Solved(Box::new(attempt.answer)));
        }
        if knows_all && self.doubtful.as_ref().is_none_or(|(least, _)| (endless, worst) < *least) {
            self.doubtful = Some(((endless, worst), attempt));
        }
        Ok(Outcome::Failed(Box::new(NoSolution::NotConverged.into())))
    }

    /// Newton's method over refinement levels, the sign check, and the answer.
    fn solve_from(&mut self, start: Start) -> Result<Attempt, ContactError> {
        let problem = self.problem;
        self.work.operations.start();
        let refined = refine(problem, start, &mut self.work)?;
        // a half-length that no pressure is sensitive to need not be known
        let is_unknown =
            |error: &Estimate| error.worst().is_nan() || error.length > UNKNOWN && error.pressure > UNKNOWN;
        if refined.level.errors.iter().any(is_unknown) {
            return Err(problem.not_converged(&refined.level.support.half_lengths));
        }
        let check = admissible::check(problem, &refined.level)?;
        let recontacts = check.recontacts.iter().map(|recontact| problem.interfaces[recontact.contact]).collect();
        Ok(Attempt { answer: answer(problem, refined, check, self.work.clone()), recontacts })
    }

    /// Whether a solution misses no re-contact interval that the quadratic programme has found.
    fn knows_all(&self, attempt: &Attempt) -> bool {
        self.several.is_none_or(|interface| attempt.recontacts.contains(&interface))
    }

    /// The doubtful solution, if the quadratic programme has found the same contacts.
    fn confirmed(&mut self, active: &[ActiveIntervals]) -> Option<Answer> {
        let unknown = self.problem.unknown().filter_map(|i| active.get(i));
        let seen: Vec<f64> = unknown.map(ActiveIntervals::end).collect();
        let is_same = |answer: &Answer| {
            let ends = answer.contacts.iter().map(Found::innermost).zip(&seen);
            let mut known = ends.filter(|(end, _)| end.end_error() < CONFIRMED);
            !seen.is_empty() && known.all(|(end, seen)| (end.right / seen).ln().abs() < CONFIRMED)
        };
        let (_, attempt) = self.doubtful.take_if(|(_, attempt)| is_same(&attempt.answer))?;
        Some(attempt.answer)
    }

    /// Where the quadratic programme sees the ends of the contacts about the middle; as expected where it sees none.
    fn ends(&self, active: &[ActiveIntervals]) -> Vec<f64> {
        let end = |(i, expected): (usize, &f64)| match active.get(i).map_or(0.0, ActiveIntervals::end) {
            _ if self.problem.sides[i].is_flat() => *expected,
            0.0 => *expected,
            end => end,
        };
        self.expected.iter().enumerate().map(end).collect()
    }

    /// The error that says where contact i touches.
    fn error(&self, active: &[ActiveIntervals], i: usize) -> ContactError {
        let length = self.problem.kernel.length();
        let parts = active[i].intervals().iter().map(|part| part.map(|x| x * length)).collect();
        NoSolution::Parts { interface: self.problem.interfaces[i], parts }.into()
    }
}

/// Whether the pressures of two answers at x = 0 are the same but for their errors.
fn agree(one: &Answer, other: &Answer) -> bool {
    let mut pairs = one.contacts.iter().zip(&other.contacts).filter(|(one, _)| one.peak.is_finite());
    pairs.all(|(a, b)| (a.peak - b.peak).abs() <= a.peak_error + b.peak_error)
}

/// The contact in which bodies touch in several intervals, or in none about the middle.
fn several(problem: &Problem, active: &[ActiveIntervals], certain: bool) -> Option<usize> {
    let finite = |active: &ActiveIntervals| active.resolved.iter().filter(|part| part[1].is_finite()).count();
    // layers that lie flat on each other far away touch without a force: such an interval is no contradiction
    let count = |active: &ActiveIntervals| if certain { finite(active) } else { active.separate.len() };
    // a contact with a gap about x = 0 has two intervals, one on either side
    let open = |active: &ActiveIntervals| match active.resolved[..] {
        [[from, to]] => !certain && from > 0.0 && to.is_finite(),
        _ => false,
    };
    // under a punch, an interval off the middle is an artefact of a grid too coarse for it
    let plausible = |i: usize, active: &ActiveIntervals| {
        problem.sides[i].profile().is_none() || active.separate.first().is_some_and(|part| part[0] == 0.0)
    };
    let mut all = active.iter().enumerate();
    all.find(|(i, active)| open(active) || count(active) > 1 && plausible(*i, active)).map(|(i, _)| i)
}
