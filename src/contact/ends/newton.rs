//! Newton's method for the ends of the contacts, with given numbers of modes: the unknowns are the logarithms of the
//! half-lengths, and the intensities of edge singularities.
use crate::contact::ends::broyden::Secants;
use crate::contact::ends::frozen::Decaying;
use crate::contact::equations::assemble::Equations;
use crate::contact::equations::condensed::{Drift, Linearised, Pressures, solve};
use crate::contact::error::ContactError;
use crate::contact::integrals::basis::Basis;
use crate::contact::integrals::layout::Layout;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, MINOR, SLOW};
use crate::contact::problem::iteration::{Operations, Progress};
use crate::contact::problem::modes::{COARSEST, Modes};
use crate::contact::problem::support::{End, Support, longest};
use crate::kernel::Kernel;
use crate::solution::Stopped;

/// Longest step in the logarithm of a half-length.
const LONGEST_STEP: f64 = 0.5;
/// A layout serves half-lengths that differ by this much, in the logarithm.
pub(crate) const LAYOUT_SERVES: f64 = 0.1;
/// Farther from the start, in the logarithm of a half-length, Newton's method is taken to diverge.
const FARTHEST: f64 = 4.0;
/// Iterated Galerkin sweeps begin when what is left of a Newton step is below this.
pub(crate) const NEARBY: f64 = 1e-5;
/// What a Newton step with few modes leaves when derivatives are kept from there on, and what is to be left in the end.
const ROUGHLY: f64 = 2.5e-3;
/// A laminate that bends this much more easily than its contacts are squeezed couples their pressures strongly.
const STRONG: f64 = 1e4;

/// What Newton's method has done, all attempts together.
#[derive(Clone, Default)]
pub(crate) struct Work {
    /// Steps and sweeps on each level.
    pub(crate) steps: Vec<usize>,
    /// Wavenumbers of all layouts, tails included.
    pub(crate) interpolated: usize,
    /// Systems factorised.
    pub(crate) factorisations: usize,
    /// Why each refinement level ended.
    pub(crate) stopped: Vec<Stopped>,
    pub(crate) operations: Operations,
}

impl Work {
    pub(crate) fn step(&mut self) {
        if let Some(steps) = self.steps.last_mut() {
            *steps += 1;
        }
    }
}

/// Newton's method for one contact problem.
pub(crate) struct Newton<'a> {
    pub(crate) problem: &'a Problem<'a>,
    pub(crate) work: Work,
    /// Whether the node budget was exceeded at some layout.
    pub(crate) budget_exceeded: bool,
    decaying: Decaying,
}

/// When Newton's method is done.
#[derive(Clone, Copy)]
pub(crate) struct Aim {
    /// Parts of kernels that count as negligible.
    pub(crate) negligible: f64,
    /// What the next step would leave.
    pub(crate) step: f64,
    /// Ends on which less than this depends stay where they are.
    pub(crate) ends: f64,
}

/// A support with the solution of the equations there.
pub(crate) struct Point {
    pub(crate) support: Support,
    pub(crate) pressures: Pressures,
    pub(crate) linearised: Linearised,
    pub(crate) layout: Layout,
}

/// A layout, and the half-lengths it was made for.
struct LaidOut {
    layout: Layout,
    about: Vec<f64>,
}

impl<'a> Newton<'a> {
    pub(crate) fn new(problem: &'a Problem, work: Work) -> Self {
        Self { problem, work, budget_exceeded: false, decaying: Decaying::default() }
    }

    /// A coarse solution: goes on with given numbers of modes until the half-lengths are right to what [`Self::converge`]
    /// needs for this tolerance. These, and the modes.
    pub(crate) fn coarse(
        &mut self,
        half_lengths: Vec<f64>,
        counts: &[usize],
        tolerance: f64,
    ) -> Result<(Vec<f64>, Modes), ContactError> {
        // strongly coupled contacts are sensitive to small changes of derivatives, and their truncation error is judged by how
        // far these half-lengths are off
        let strongly = strongly_coupled(self.problem.kernel, &half_lengths).contains(&true);
        let (aim, enough) = if strongly {
            let fine = MINOR * COARSE;
            (Aim { negligible: fine, step: NEARBY, ends: fine }, 0.5 * linear(tolerance, counts))
        } else {
            (Aim { negligible: COARSE, step: ROUGHLY, ends: MINOR * COARSE }, COARSE)
        };
        let Point { mut support, pressures, linearised, layout } = self.iterate(half_lengths, counts, counts, aim)?;
        // on with the same derivatives
        let Pressures { mut modes, mut step, .. } = pressures;
        let strong = strongly_coupled(self.problem.kernel, &support.half_lengths);
        let mut secants = Secants::default();
        let mut before = 1.0;
        let mut start = modes.clone();
        loop {
            let last = support.longest(&step);
            // a step that is hardly shorter than the one before, or longer, leads nowhere
            if last > SLOW * before {
                return Ok((support.half_lengths, modes));
            }
            linearised.follow(&mut modes, &step);
            secants.improve(&start, &mut modes, &mut step);
            self.advance(&mut support, &step, 1.0);
            // what comes next is as much shorter again
            if last * last / before <= enough {
                return Ok((support.half_lengths, modes));
            }
            before = last;
            let bases = Basis::all(&layout, self.problem, &support.half_lengths, counts);
            let slopes = self.problem.slopes(&support.half_lengths, counts);
            let equations = Equations::new(&layout, &bases, counts, &strong, &support);
            self.work.step();
            start.clone_from(&modes);
            step = linearised.sweep(&equations, &slopes, &Drift::default(), &mut modes).step;
        }
    }

    /// Newton's method with `solved` of the `modes`, until the aim is met.
    pub(crate) fn iterate(
        &mut self,
        half_lengths: Vec<f64>,
        solved: &[usize],
        modes: &[usize],
        aim: Aim,
    ) -> Result<Point, ContactError> {
        let problem = self.problem;
        let start = half_lengths.clone();
        let mut support = problem.support(half_lengths);
        let mut kept: Option<LaidOut> = None;
        self.work.steps.push(0);
        self.decaying.begin(solved.len());
        let mut progress = Progress::default();
        while near(&support.half_lengths, &start, FARTHEST) {
            let serves = kept.take().filter(|kept| near(&support.half_lengths, &kept.about, LAYOUT_SERVES));
            let laid_out = serves.or_else(|| self.lay_out(&support.half_lengths, modes, aim.negligible));
            let Some(laid_out) = laid_out else { break };
            let Some((pressures, linearised)) = self.linearise(&laid_out.layout, &support, solved) else { break };
            if self.decaying.freeze(problem, &mut support, &pressures, &linearised, aim.ends) {
                kept = Some(laid_out);
                continue;
            }
            let left = longest(pressures.step.iter().copied());
            if left * left < aim.step || progress.is_rounding(left, NEARBY) {
                return Ok(Point { support, pressures, linearised, layout: laid_out.layout });
            }
            if !progress.goes_on(left) {
                break;
            }
            let shorten = (LONGEST_STEP / support.longest(&pressures.step)).min(1.0);
            self.advance(&mut support, &pressures.step, shorten);
            kept = Some(laid_out);
        }
        Err(problem.not_converged(&support.half_lengths))
    }

    /// The equations at a support, solved for the pressures and factorised; `None` also after too many operations.
    fn linearise(&mut self, layout: &Layout, support: &Support, solved: &[usize]) -> Option<(Pressures, Linearised)> {
        let half_lengths = &support.half_lengths;
        let bases = Basis::all(layout, self.problem, half_lengths, solved);
        let slopes = self.problem.slopes(half_lengths, solved);
        let strong = strongly_coupled(self.problem.kernel, half_lengths);
        self.work.step();
        self.work.factorisations += 1;
        let (unknowns, products) = solved.iter().fold((0, 0), |(n, p), count| (n + count, p + count * count));
        // integrals over products of modes, and the factorisation
        self.work.operations.spend(layout.nodes() as f64 * products as f64 + (unknowns as f64).powi(3) / 3.0)?;
        let free: Vec<usize> = support.free().collect();
        solve(&Equations::new(layout, &bases, solved, &strong, support), &slopes, &free)
    }

    /// Takes a part of a step; a contact covers more than the flat part of its punch, and less than all of it.
    fn advance(&self, support: &mut Support, step: &[f64], part: f64) {
        for (i, (side, step)) in self.problem.sides.iter().zip(step).enumerate() {
            let before = support.half_lengths[i];
            support.advance_one(i, part * step);
            if support.ends[i] == End::Free {
                support.half_lengths[i] = side.within(before, support.half_lengths[i]);
            }
        }
    }

    /// Wavenumbers for these numbers of modes and half-lengths nearby, unless there are too many.
    fn lay_out(&mut self, half_lengths: &[f64], modes: &[usize], negligible: f64) -> Option<LaidOut> {
        let layout = Layout::new(self.problem.kernel, half_lengths, &self.problem.orders(modes), negligible, 0.0);
        let Some(layout) = layout else {
            self.budget_exceeded = true;
            return None;
        };
        self.work.interpolated += layout.nodes();
        Some(LaidOut { layout, about: half_lengths.to_vec() })
    }
}

/// Whether half-lengths differ from others by no more than this in the logarithm.
fn near(half_lengths: &[f64], about: &[f64], by: f64) -> bool {
    half_lengths.iter().zip(about).all(|(a, b)| (a / b).ln().abs() <= by)
}

/// How far half-lengths may move, in the logarithm, before tables are made anew: high modes oscillate, and are linear over
/// a shorter way.
pub(crate) fn linear(tolerance: f64, solved: &[usize]) -> f64 {
    let highest = solved.iter().copied().fold(COARSEST, usize::max);
    (1e-3 * tolerance).sqrt().min(NEARBY) * COARSEST as f64 / highest as f64
}

/// Which laminates couple the pressures of their contacts strongly.
pub(crate) fn strongly_coupled(kernel: &Kernel, half_lengths: &[f64]) -> Vec<bool> {
    half_lengths
        .windows(2)
        .enumerate()
        .map(|(i, pair)| kernel.coupling_strength(i, 3.0 / pair[0].max(pair[1])) > STRONG)
        .collect()
}
