//! How far punches have sunk, and how stiff the layers are under them, from the contact equations of a solution.
//!
//! On given intervals these equations are linear: under punches that have sunk by the depths δ the forces are F = F₀ + Kδ, where profiles, gaps and weights make F₀. No pressure is
//! singular at an end that moves, so that these ends stay where they are to first order while forces grow, and K is the stiffness. Errors of ends change δ by their squares.
use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::contact::integrals::layout::{Layout, Lengths, negligible};
use crate::contact::intervals::equations::{Equations, fewer};
use crate::contact::intervals::errors::{LEAST_FALL_GRADED, beyond};
use crate::contact::intervals::kept::operations;
use crate::contact::intervals::support::Intervals;
use crate::contact::intervals::system::System;
use crate::contact::intervals::{of_formulas, of_solution};
use crate::contact::problem::{Prescribed, Problem};
use crate::numeric::means::FELT;
use crate::solution::Solution;

/// How far a punch has sunk, and dP/dδ while the forces on others stay as they are; errors are due to missing terms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sinking {
    pub(crate) depth: f64,
    pub(crate) depth_error: f64,
    pub(crate) stiffness: f64,
    pub(crate) stiffness_error: f64,
}

/// The intervals of a solution in units of L, with the numbers of terms on these; `None` where they are not known.
pub(super) fn intervals_of(problem: &Problem, solution: &Solution) -> Option<(Intervals, Vec<usize>)> {
    let support = of_formulas(problem, &of_solution(problem, solution))?.held(problem);
    let counts = solution.stats.terms.concat();
    (counts.len() == support.0.len()).then_some((support, counts))
}

/// How far each punch has sunk, in the units of the scene; `None` where the equations on these intervals take too long, or have no solution in double precision.
pub(crate) fn sinking(problem: Problem, solution: &Solution) -> Option<Vec<Sinking>> {
    let punches = problem.groups(0).len();
    let problem =
        Problem { prescribed: (0..punches).map(|punch| (punch, Prescribed::Depth(0.0))).collect(), ..problem };
    let (support, mut counts) = intervals_of(&problem, solution)?;
    // means take a part of many terms of a pressure that is not smooth
    let rough =
        support.0.iter().zip(&mut counts).filter(|(interval, _)| !problem.is_smooth(interval.contact, interval.punch));
    rough.for_each(|(_, count)| *count = (*count).max(2 * FELT));
    let negligible = negligible(problem.tolerance);
    let lengths = Lengths::of(&problem, &support, &counts, negligible);
    let layout = Layout::new(problem.kernel, &lengths, negligible, 0.0)?;
    if operations(&layout, &support, &counts)[0] > problem.operations {
        return None;
    }
    let equations = Equations::new(&problem, &layout, &support, &counts);
    let (system, few) = (equations.system()?, fewer(&counts));
    let levels = [&counts, &few, &fewer(&few)].map(|counts| equations.sunk_in(&system, counts));
    let [all, some, least] = levels.map(Option::unwrap_or_default);
    let (depth, force) = (problem.force * problem.kernel.length(), problem.total_force());
    let of = |(punch, own): (usize, &[f64; 2])| {
        let [some, least] = [&some, &least].map(|level| level.get(punch).copied().unwrap_or([f64::INFINITY; 2]));
        let error = |k: usize| beyond([own[k] - some[k], some[k] - least[k]], LEAST_FALL_GRADED);
        let stiffness = force / depth * problem.groups(0)[punch].share;
        Sinking {
            depth: own[0] * depth,
            depth_error: error(0) * depth,
            stiffness: own[1] * stiffness,
            stiffness_error: error(1) * stiffness,
        }
    };
    let found: Vec<Sinking> = all.iter().enumerate().map(of).collect();
    let is_known = |own: &Sinking| own.depth.is_finite() && own.depth_error.is_finite();
    (found.len() == punches && found.iter().all(is_known)).then_some(found)
}

impl Equations<'_> {
    /// The depth of each punch and the stiffness under it, in units of L and P', from the equations with no more than these numbers of terms; `None` if they have no solution.
    fn sunk_in(&self, system: &System, counts: &[usize]) -> Option<Vec<[f64; 2]>> {
        let mut part = system.part(&self.kept(counts));
        let (punches, border) = (self.problem.prescribed.len(), part.right.left.len());
        let factors = part.factorised()?;
        let (first, last) = (border - punches, border - self.turning.len() - punches);
        let at_rest = factors.solve(&part.right)?.q[last..last + punches].to_vec();
        part.right.terms.fill(0.0);
        let mut stiffness = Mat::zeros(punches, punches);
        for punch in 0..punches {
            part.right.left.fill(0.0);
            part.right.left[first + punch] = 1.0;
            stiffness.col_as_slice_mut(punch).copy_from_slice(&factors.solve(&part.right)?.q[last..last + punches]);
        }
        let compliance = stiffness.partial_piv_lu().solve(Mat::<f64>::identity(punches, punches));
        let of = |punch: usize| {
            let depth = (0..punches).map(|other| compliance[(punch, other)] * (1.0 - at_rest[other])).sum();
            [depth, compliance[(punch, punch)].recip()]
        };
        Some((0..punches).map(of).collect())
    }
}
