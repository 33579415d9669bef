//! The contact problem: half-lengths and pressures of all contacts, for one punch, or given loads, and one force on prepared kernels.
//!
//! An answer goes through the rooms in order: [`problem`], start ([`starts`]), Newton's method on the ends ([`ends`], with the
//! [`equations`] and their [`integrals`]) over refinement levels and the sign check ([`quality`]), and the one assembly of a
//! solution ([`answer`]). Where Newton's method fails, the quadratic programme is asked ([`programme`], [`intervals`]).
pub(crate) mod answer;
mod controlled;
mod ends;
mod equations;
mod error;
pub(crate) mod even;
mod integrals;
mod intervals;
pub(crate) mod problem;
mod programme;
pub(crate) mod quality;
pub(crate) mod starts;
mod tangent;
mod thin;

use std::borrow::Cow;

use crate::kernel::Kernel;
use crate::options::Options;
use crate::scene::{Punch, Top};
use crate::solution::{Carried, Interface, Solution, Stats};

pub(crate) use controlled::{Measured, press_to};
pub use error::{ContactError, Controlled, NoSolution};
pub(crate) use starts::table::Table;
pub(crate) use tangent::tangent;

use answer::Answer;
use ends::newton::Work;
use problem::Problem;
use problem::estimate::Estimate;
use problem::iteration::Operations;
use problem::load;
use problem::twin::Twin;
use quality::levels::{Start, refine};
use quality::{admissible, estimates};
use starts::formulas;
use starts::order::{Attempt, solve_in_order};

/// Presses a punch or loads with a force on a stack: the answer in the units of the scene. It may start from a table of solutions for
/// this kernel.
pub(crate) fn press(
    kernel: &Kernel,
    table: Option<&Table>,
    interfaces: &[Interface],
    top: &Top,
    force: f64,
    options: &Options,
) -> Result<Solution, ContactError> {
    let is_sought = kernel.contacts() > 1 || top.loads().is_none();
    if let Some((even, by)) = top.about_its_middle().filter(|_| is_sought) {
        let mut solution = press(kernel, table, interfaces, &even, force, options)?.moved(by);
        match top {
            Top::Loads(loads) => {
                solution.contacts[0] = load::contact(loads, interfaces[0], force, Twin::of(kernel.geometry()))
            }
            Top::Punches(_) => solution.punches = vec![Carried { force, tilt: 0.0, moment: 0.0 }],
        }
        return Ok(solution);
    }
    let table = table.filter(|_| top.material().is_none());
    let own = &*kernel_under(kernel, top, force);
    let problem = Problem::new(own, interfaces, top, force, options.tolerance);
    if problem.unknown().next().is_some() && !problem.is_even() {
        return Ok(Solution { force, ..intervals::anywhere(&problem, &formulas::anywhere(&problem))? });
    }
    // a table is for one kernel
    let table_of = |problem: &Problem| table.filter(|_| std::ptr::eq(problem.kernel, own));
    let solution = thin::solve(&problem, |problem| solve(problem, table_of(problem)))?;
    Ok(Solution { force, ..solution })
}

/// Whether punches have no sharp tips or corners but one even punch by itself, or the pressures of loads are known.
pub(crate) fn is_solvable(top: &Top, kernel: &Kernel) -> Result<(), ContactError> {
    let geometry = kernel.geometry();
    match top {
        Top::Punches(punches) if punches.alone().is_some_and(Punch::is_even) => Ok(()),
        Top::Punches(_) if top.about_its_middle().is_some() => Ok(()),
        Top::Punches(punches) if punches.parts().any(|(pressed, _)| pressed.shape().is_singular()) => {
            Err(ContactError::SharpPunches)
        }
        Top::Loads(loads) if !loads.are_known_in(geometry) => {
            Err(ContactError::LoadsUnknown { loads: loads.to_string(), geometry })
        }
        _ => Ok(()),
    }
}

/// The kernel with what an elastic punch adds to it, in a unit of length that suits contacts on a stack without one.
pub(crate) fn kernel_under<'a>(kernel: &'a Kernel, top: &Top, force: f64) -> Cow<'a, Kernel> {
    let kernel = match top.material() {
        Some(material) => Cow::Owned(kernel.under_half_plane(&material)),
        None => Cow::Borrowed(kernel),
    };
    match formulas::length(&kernel, top, force) {
        Some(length) => Cow::Owned(kernel.measured_in(length)),
        None => kernel,
    }
}

/// Solves from the first of the starting points that leads to an admissible solution.
fn solve(problem: &Problem, table: Option<&Table>) -> Result<Solution, ContactError> {
    if problem.unknown().next().is_none() {
        let stats = Stats { modes: vec![1; problem.contacts()], ..problem.kernel.stats() };
        let known = Answer {
            contacts: Vec::new(),
            min_pressure: 0.0,
            min_gap: 0.0,
            tilts: Vec::new(),
            stats,
            warnings: Vec::new(),
        };
        return Ok(known.into_solution(problem));
    }
    let mut work = Work { operations: Operations::at_most(problem.operations), ..Work::default() };
    if let Some(start) = table.and_then(|table| table.start(problem))
        && let Ok(attempt) = solve_from(problem, start, &mut work)
        && attempt.solution.warnings.is_empty()
    {
        return Ok(attempt.solution);
    }
    solve_in_order(
        problem,
        |start| solve_from(problem, start, &mut work),
        |expected, far| programme::answer(problem, expected, far),
    )
}

/// Newton's method over refinement levels, the sign check, and the answer.
fn solve_from(problem: &Problem, start: Start, work: &mut Work) -> Result<Attempt, ContactError> {
    work.operations.start();
    let refined = refine(problem, start, work)?;
    // a half-length that no pressure is sensitive to need not be known
    let is_unknown = |error: &Estimate| {
        error.worst().is_nan() || error.length > estimates::UNKNOWN && error.pressure > estimates::UNKNOWN
    };
    if refined.level.errors.iter().any(is_unknown) {
        return Err(problem.not_converged(&refined.level.support.half_lengths));
    }
    let check = admissible::check(problem, &refined.level)?;
    let recontacts = check.recontacts.iter().map(|recontact| problem.interfaces[recontact.contact]).collect();
    let solution = quality::answer::answer(problem, refined, check, work.clone()).into_solution(problem);
    Ok(Attempt { solution, recontacts })
}

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

    use super::*;
    use crate::contact::problem::Side;
    use crate::contact::problem::load::Given;
    use crate::stack::Stack;

    #[test]
    fn the_pressure_of_a_punch_given_as_a_load_makes_the_same_contacts() {
        let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
        let graded = Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
        let stack = || Stack::builder(Plane::Strain);
        for stack in [
            stack().layer(strip()).receding().layer(HalfPlane::new(0.5, 0.3).unwrap()),
            stack().layer(graded).receding().layer(strip()).receding().rigid(),
        ] {
            let stack = stack.build().unwrap();
            let (kernel, interfaces, options) = (Kernel::new(&stack).unwrap(), stack.contacts(), Options::default());
            let punch = Top::from(Punch::parabola(100.0).unwrap());
            for force in [1e-4, 0.02] {
                let expected = press(&kernel, None, &interfaces, &punch, force, &options).unwrap();
                let top = &expected.contacts[0];
                let given = Given::of(top.innermost().right / kernel.length(), &top.strips[0].coefficients);
                let mut problem = Problem::new(&kernel, &interfaces, &punch, force, options.tolerance);
                problem.sides[0] = Side::Known(given);
                let found = solve(&problem, None).unwrap();
                for (found, expected) in found.contacts[1..].iter().zip(&expected.contacts[1..]) {
                    assert!(
                        (found.innermost().right / expected.innermost().right - 1.0).abs() < 1e-10,
                        "{found:?} {expected:?}"
                    );
                    assert!((found.central_pressure / expected.central_pressure - 1.0).abs() < 1e-9);
                }
            }
        }
    }
}
