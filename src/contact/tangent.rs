//! How the pressures of an answer grow with the force.
//!
//! They vanish at the ends of their contacts, or are the pressures of a flat punch: to first order the contacts stay as long as they are. What a unit
//! force adds is the pressure of contacts of these half-lengths that are joined, singular at their ends.
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::intervals::{self, Refused};
use crate::contact::problem::Problem;
use crate::contact::problem::iteration::Work;
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::scene::Top;
use crate::solution::{Contact, Interface, Solution};

/// Relative error of the pressures that a unit force adds; a hundredth of it takes ten times as long next to graded faces.
const TOLERANCE: f64 = 1e-9;
/// Multiplications at most, about a second: a stiffness is not worth more time than a solution. Half as many: a digit less of some long contacts.
const MOST: f64 = 2e10;

/// The pressures that a unit force adds to the pressures of a solution; `None` where a contact is not one interval about x = 0.
pub(crate) fn tangent(kernel: &Kernel, top: &Top, solution: &Solution) -> Option<Result<Solution, ContactError>> {
    let contacts = solution.contacts();
    let half_lengths: Vec<f64> = contacts.iter().map(Contact::half_length).collect::<Option<_>>()?;
    let interfaces: Vec<Interface> = contacts.iter().map(|contact| contact.interface).collect();
    let problem = Problem::joined(kernel, &interfaces, top, &half_lengths, TOLERANCE);
    let joined = intervals::of_formulas(&problem, &formulas::anywhere(&problem))?;
    let answer = intervals::solve(&problem, joined, &mut Refused::default(), &mut Work::at_most(MOST));
    let answer = answer.ok_or_else(|| NoSolution::NotConverged.into());
    Some(answer.map(|answer| answer.into_solution(&problem, 1.0, None)))
}
