//! The contact problem: intervals and pressures of all contacts, for one punch, or given loads, and one force on prepared kernels.
//!
//! An answer goes through the rooms in order: [`problem`], lists of intervals to begin with ([`starts`]), the intervals where no pressure is singular and nothing is negative
//! ([`intervals`], with their [`integrals`]), and the one assembly of a solution ([`answer`]). Where the first lists fail, the quadratic programme is asked ([`programme`]).
pub(crate) mod answer;
mod error;
mod integrals;
mod interpolation;
mod intervals;
mod prescribed;
pub(crate) mod problem;
mod programme;
pub(crate) mod starts;
mod thin;

use std::borrow::Cow;
use std::cell::LazyCell;

use crate::kernel::Kernel;
use crate::numeric::waves::Waves;
use crate::scene::{Force, Gap, Top};
use crate::solution::{Controlled, Interface, Ledger, OwnerKey, Solution};

pub use error::{ContactError, NoSolution};
pub(crate) use interpolation::Curves;

use answer::Answer;
use intervals::Refused;
pub(crate) use intervals::Sinking;
use prescribed::Drive;
use problem::iteration::Work;
use problem::{Expected, Prescribed, Problem};
use starts::formulas;
use starts::order::{of_low_accuracy, solve_from, solve_in_order};

/// Of the work for one answer, what goes into openings at most from the closed state: with twice as much, scenes that are not solved take twice the time.
const OPENINGS: f64 = 0.25;

/// What is asked of the solver: everything but the force.
pub(crate) struct Asked<'a> {
    /// The stack, to which solutions belong.
    pub(crate) stack: &'a OwnerKey,
    pub(crate) kernel: &'a Kernel,
    pub(crate) interfaces: &'a [Interface],
    pub(crate) top: &'a Top,
    /// Gaps between layers before anything is loaded.
    pub(crate) gaps: &'a [(Interface, Gap)],
    /// The pressures of weights and on top that keep interfaces closed but for openings.
    pub(crate) weights: &'a [(Interface, f64)],
    /// What dents that are pressed flat do to these, and how far they lower the face above.
    pub(crate) by_dents: &'a [Waves],
    pub(crate) hollow: Option<&'a Waves>,
    /// What makes the kernel of all layers that may come apart, where weights press some of them together.
    pub(crate) laminates: Option<&'a dyn Fn() -> Option<Kernel>>,
    /// Relative error wanted.
    pub(crate) tolerance: f64,
}

/// Presses a punch or loads on a stack with a force, or so that the contact is as long, or the punch sinks as far, as prescribed: the answer in the units of the scene.
pub(crate) fn press(asked: &Asked, force: Force) -> Result<Solution, ContactError> {
    let drive = Drive::new(asked.top, &asked.kernel_with_punch(), force)?;
    let asked = &Asked { top: &drive.top, ..*asked };
    let own = &*asked.kernel_under(drive.force);
    let problem = drive.of(asked.problem(own, drive.force));
    if matches!(force, Force::ForHalfLength(_)) && !problem.is_even() {
        return Err(ContactError::UnevenPunch);
    }
    let answer = if problem.unknown().next().is_none() { Ok(Answer::known(&problem)) } else { solve(&problem) };
    let answer = answer.map_err(|error| drive.unmet(error))?;
    Ok(answer.into_solution(&problem, drive.force, Some(asked.stack)))
}

/// The answer of Newton's method or, where that fails, of the quadratic programme.
fn solve(problem: &Problem) -> Result<Answer, ContactError> {
    let mut refused = Refused::default();
    let answer = match problem.is_even() {
        true => thin::solve(problem, &mut refused),
        false => solve_in_order(problem, None, &mut refused),
    };
    let expected = || formulas::anywhere(problem);
    answer.or_else(|error| of_low_accuracy(problem, (&expected(), || Some(problem.kernel)), &refused, error))
}

/// Presses on layers that weights press together, and that come apart in places: from the solution while all is closed, if there is one, and from where the layers would pull then, or
/// else from where the quadratic programme sees contacts and openings.
pub(crate) fn open(
    asked: &Asked,
    force: Force,
    closed: Option<&Solution>,
    openings: &[(usize, [f64; 2])],
) -> Result<Solution, ContactError> {
    let own = asked.kernel_with_punch();
    let drive = Drive::new(asked.top, &own, force)?;
    let top = closed.map_or_else(|| drive.top.clone().into_owned(), |closed| asked.top_of(closed));
    let asked = &Asked { top: &top, ..*asked };
    let force = closed.map_or(drive.force, Solution::force);
    let problem = drive.of(asked.problem(&own, force));
    let expected = match closed {
        Some(closed) => intervals::of_solution(&problem, closed),
        None => formulas::anywhere(&problem),
    };
    let opening = |(number, ends): &(usize, [f64; 2])| Expected {
        contact: own.lowest() + number,
        punch: 0,
        ends: ends.map(|x| x / own.length() - problem.origin),
    };
    let expected: Vec<Expected> = expected.into_iter().chain(openings.iter().map(opening)).collect();
    let start = closed.and_then(|_| intervals::of_formulas(&problem, &expected));
    let laminates = LazyCell::new(|| {
        let laminates = asked.laminates?()?;
        let asked = Asked { kernel: &laminates, ..*asked };
        Some(asked.kernel_with_punch().measured_in(own.length()))
    });
    let coarse = (&expected[..], || laminates.as_ref());
    let (mut refused, mut work) = (Refused::default(), Work::at_most(OPENINGS * problem.operations));
    let first = start.and_then(|start| intervals::solve(&problem, start, &mut refused, &mut work));
    let answer = first.map_or_else(|| solve_from(&problem, None, coarse, &mut refused), Ok);
    let answer = answer.or_else(|error| of_low_accuracy(&problem, coarse, &refused, error));
    let answer = answer.map_err(|error| drive.unmet(error))?;
    Ok(answer.into_solution(&problem, force, Some(asked.stack)))
}

/// The contact equations of a solution in words, see [`intervals::ledger`].
pub(crate) fn ledger(asked: &Asked, solution: &Solution) -> Option<Ledger> {
    let top = asked.top_of(solution);
    let asked = &Asked { top: &top, ..*asked };
    let own = &*asked.kernel_under(solution.force());
    intervals::ledger(&asked.problem_of(own, solution), solution)
}

/// How far each punch of a solution has sunk, and the stiffness under it; see [`intervals::sinking`].
pub(crate) fn sinking(asked: &Asked, solution: &Solution) -> Option<Vec<Sinking>> {
    let top = asked.top_of(solution);
    let asked = &Asked { top: &top, ..*asked };
    let own = &*asked.kernel_under(solution.force());
    let problem = asked.problem_of(own, solution);
    thin::sinking(problem, solution)
}

impl Asked<'_> {
    /// Whether the pressures of loads are known, and punches rise on both sides.
    pub(crate) fn is_solvable(&self) -> Result<(), ContactError> {
        let geometry = self.kernel.geometry();
        match self.top {
            Top::Punches(punches) => {
                let on_top = self.gaps.iter().find(|(interface, _)| *interface == Interface::Punch);
                let curvature = on_top.map_or(0.0, |(_, gap)| gap.curvature);
                let Some((pressed, _)) = punches.parts().find(|(pressed, _)| pressed.falls(curvature)) else {
                    return Ok(());
                };
                let (punch, angle) = (pressed.shape().label(geometry), pressed.tilt().angle().unwrap_or_default());
                Err(match pressed.falls(0.0) {
                    true => ContactError::PunchFalls { punch, angle },
                    false => ContactError::FaceRises { punch, curvature: -curvature },
                })
            }
            Top::Loads(loads) if !loads.are_known_in(geometry) => {
                Err(ContactError::LoadsUnknown { loads: loads.to_string(), geometry })
            }
            _ => Ok(()),
        }
    }

    /// The kernel with what an elastic punch adds to it, in a unit of length that suits contacts on a stack without one.
    pub(crate) fn kernel_under(&self, force: f64) -> Cow<'_, Kernel> {
        let kernel = self.kernel_with_punch();
        match formulas::length(&kernel, (self.top, self.gaps), force) {
            Some(length) => Cow::Owned(kernel.measured_in(length)),
            None => kernel,
        }
    }

    /// The kernel with what an elastic punch adds to it.
    fn kernel_with_punch(&self) -> Cow<'_, Kernel> {
        match self.top.material() {
            Some(material) => Cow::Owned(self.kernel.under_half_plane(&material)),
            None => Cow::Borrowed(self.kernel),
        }
    }

    /// What presses, with the forces of a solution.
    fn top_of(&self, solution: &Solution) -> Top {
        let forces = solution.punches.iter().map(|carried| carried.force).chain([solution.force]);
        self.top.punches().map_or_else(|| self.top.clone(), |punches| punches.with_forces(forces).into())
    }

    /// The problem of a solution, on its kernel.
    fn problem_of<'b>(&'b self, kernel: &'b Kernel, solution: &Solution) -> Problem<'b> {
        let half_length =
            || (solution.contacts[0].innermost().right - solution.about().unwrap_or(0.0)) / kernel.length();
        let mut problem = self.problem(kernel, solution.force());
        if problem.prescribed.is_empty() {
            problem.prescribed.extend(solution.controlled.map(|controlled| match controlled {
                Controlled::HalfLength => (0, Prescribed::End { side: 1.0, at: half_length() }),
                _ => (0, Prescribed::Depth(0.0)),
            }));
        }
        problem
    }

    /// The problem on its kernel with a force in the units of the scene.
    pub(crate) fn problem<'b>(&'b self, kernel: &'b Kernel, force: f64) -> Problem<'b> {
        let loaded = (self.top, self.gaps, self.hollow);
        match kernel.has_openings() {
            true => {
                let pressed = (self.weights, self.by_dents);
                Problem::opened(kernel, self.interfaces, loaded, pressed, force, self.tolerance)
            }
            false => Problem::new(kernel, self.interfaces, loaded, force, self.tolerance),
        }
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

    use super::*;
    use crate::contact::problem::Side;
    use crate::contact::problem::load::Given;
    use crate::scene::Punch;
    use crate::stack::Stack;
    use crate::{Model, Options};

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
            let (kernel, interfaces) = (Kernel::new(&stack).unwrap(), stack.contacts());
            let punch = Top::from(Punch::parabola(100.0).unwrap());
            for force in [1e-4, 0.02] {
                let expected = Model::new(stack.clone()).unwrap().press(&punch, force).unwrap();
                let top = &expected.contacts[0];
                let given = Given::of(top.innermost().right / kernel.length(), &top.strips[0].coefficients);
                let mut problem =
                    Problem::new(&kernel, &interfaces, (&punch, &[], None), force, Options::default().tolerance);
                problem.sides[0] = Side::Known(given);
                let found = solve(&problem).unwrap().into_solution(&problem, force, None);
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
