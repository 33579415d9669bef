//! A second, independent discretisation of the contact equations: pressures at nodes, slopes compared at collocation points between
//! them, kernels as functions of the distance. Slower than the Galerkin solver; its purpose is to check that.
//!
//! It shares with the Galerkin solver the flexibilities at single wavenumbers, the problem, the order of starting points, and the
//! assembly of an answer.
mod equations;
mod gaps;
mod nodes;
mod spatial;
mod spectrum;

use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::options::Options;
use crate::scene::Top;
use crate::solution::{Interface, Solution, Stats, Strip, Warning, WarningCode};

use crate::contact::answer::{Answer, Found};
use crate::contact::even::RightInterval;
use crate::contact::problem::estimate::Estimate;
use crate::contact::problem::modes::alternating;
use crate::contact::problem::{Problem, Side};
use crate::contact::quality::levels::Start;
use crate::contact::starts::order::solve_in_order;
use crate::contact::{ContactError, NoSolution, kernel_under};

use equations::Pressures;
use nodes::Nodes;
use spatial::Spatial;

/// Numbers of nodes: the first, doubled until the tolerance is met, and the last.
const COARSEST: usize = 16;
const FINEST: usize = 512;
/// Longest step in the logarithm of a half-length.
const LONGEST_STEP: f64 = 0.5;
/// Steps for one number of nodes.
const STEPS: usize = 30;
/// Newton's method has converged if a step is below this, or if steps below the second value no longer become shorter, which is rounding.
const CONVERGED: f64 = 1e-13;
const SHORT: f64 = 1e-8;
/// Step of the finite differences for derivatives by the logarithm of a half-length.
const DIFFERENCE: f64 = 1e-5;
/// Relative rounding error of a half-length.
const ROUNDING: f64 = 1e-12;
/// Pressures and gaps below zero by less than this part of the largest value are zero.
const ZERO: f64 = 1e-5;

/// Half-lengths and pressures for one number of nodes.
struct Discretised {
    half_lengths: Vec<f64>,
    pressures: Pressures,
    /// p(0) per unit of P'.
    peaks: Vec<f64>,
    /// Length of the last step.
    last_step: f64,
}

/// Presses a punch on a stack: the answer in the units of the scene.
pub(crate) fn press(
    kernel: &Kernel,
    interfaces: &[Interface],
    top: &Top,
    force: f64,
    options: &Options,
) -> Result<Solution, ContactError> {
    let kernel = &*kernel_under(kernel, top, force);
    let problem = Problem::new(kernel, interfaces, top, force, options.tolerance);
    if (0..problem.contacts()).any(|i| problem.is_known(i)) {
        return Err(ContactError::LoadByCollocation);
    }
    if !problem.is_even() {
        return Err(ContactError::UnevenByCollocation);
    }
    if problem.sides.iter().any(Side::is_flat) {
        return Err(ContactError::FlatByCollocation);
    }
    let mut collocation = Collocation { problem: &problem, spatial: Spatial::new(kernel)?, steps: Vec::new() };
    let solve = |start: Start| {
        let (Start::Guess { half_lengths } | Start::Cold { half_lengths } | Start::Warm { half_lengths, .. }) = start;
        collocation.refine(half_lengths).map(Into::into)
    };
    let solution = solve_in_order(&problem, solve, |_, _| None)?;
    Ok(Solution { force, ..solution })
}

struct Collocation<'a> {
    problem: &'a Problem<'a>,
    spatial: Spatial,
    /// Newton steps taken on each level.
    steps: Vec<usize>,
}

impl Collocation<'_> {
    /// Doubles the number of nodes until two answers agree.
    fn refine(&mut self, half_lengths: Vec<f64>) -> Result<Solution, ContactError> {
        let tolerance = self.problem.tolerance;
        let singular = self.spatial.diagonals.iter().any(|diagonal| diagonal.jump.is_some());
        let mut count = COARSEST;
        let mut jacobian = None;
        let mut nodes = Nodes::new(count, singular);
        let mut before = self.converge(&nodes, half_lengths, &mut jacobian)?;
        loop {
            count *= 2;
            nodes = Nodes::new(count, singular);
            let level = self.converge(&nodes, before.half_lengths.clone(), &mut jacobian)?;
            let error = |new: f64, old: f64| (new / old - 1.0).abs() + level.last_step + ROUNDING;
            let errors: Vec<Estimate> = (0..level.peaks.len())
                .map(|i| {
                    let length = error(level.half_lengths[i], before.half_lengths[i]);
                    Estimate::new(length, error(level.peaks[i], before.peaks[i]) + length)
                })
                .collect();
            let worst = largest(errors.iter().map(|error| error.worst()));
            if worst.is_nan() {
                return Err(self.problem.not_converged(&level.half_lengths));
            }
            if worst <= tolerance || count >= FINEST {
                let mut warnings = Vec::new();
                if worst > tolerance {
                    let message = format!(
                        "the tolerance {tolerance:e} is not met with {count} nodes; the error estimates tell what was reached"
                    );
                    warnings.push(Warning::new(WarningCode::ToleranceNotMet, message));
                }
                return self.solution(&nodes, &level, &errors, warnings);
            }
            before = level;
        }
    }

    /// Newton's method for the logarithms of the half-lengths. The derivatives are finite differences, and kept as long as
    /// steps with them become shorter, also from one number of nodes to the next.
    fn converge(
        &mut self,
        nodes: &Nodes,
        mut half_lengths: Vec<f64>,
        jacobian: &mut Option<Mat<f64>>,
    ) -> Result<Discretised, ContactError> {
        let mut last = f64::INFINITY;
        self.steps.push(0);
        for _ in 0..STEPS {
            let pressures = self.solve(nodes, &half_lengths);
            if let Some(steps) = self.steps.last_mut() {
                *steps += 1;
            }
            let derivatives = match jacobian.take() {
                Some(kept) => kept,
                None => self.derivatives(nodes, &half_lengths, &pressures.slack),
            };
            let right = Mat::from_fn(half_lengths.len(), 1, |i, _| -pressures.slack[i]);
            let step: Vec<f64> = derivatives.partial_piv_lu().solve(&right).col(0).iter().copied().collect();
            let longest = step.iter().fold(0.0, |longest: f64, step| longest.max(step.abs()));
            if step.iter().any(|step| !step.is_finite()) {
                break;
            }
            if longest < CONVERGED || last < SHORT && longest > 0.5 * last {
                *jacobian = Some(derivatives);
                let peaks = pressures.phi.iter().zip(&half_lengths).map(|(phi, a)| peak(nodes, phi) / a).collect();
                return Ok(Discretised { half_lengths, pressures, peaks, last_step: longest });
            }
            // derivatives with which steps no longer become shorter are computed anew
            *jacobian = (longest < 0.1 * last && longest < 0.1).then_some(derivatives);
            last = longest;
            let shorten = (LONGEST_STEP / longest).min(1.0);
            for (a, step) in half_lengths.iter_mut().zip(&step) {
                *a *= (shorten * step).exp();
            }
            for i in 0..half_lengths.len() {
                let Some(edge) = self.problem.sides[i].edge().filter(|edge| half_lengths[i] >= *edge) else { continue };
                half_lengths[i] = edge * (1.0 - 1e-4);
                if let Some(error) = self.problem.too_small(&half_lengths) {
                    return Err(error);
                }
            }
        }
        *jacobian = None;
        Err(self.problem.not_converged(&half_lengths))
    }

    fn solve(&mut self, nodes: &Nodes, half_lengths: &[f64]) -> Pressures {
        let longest = half_lengths.iter().fold(0.0, |longest: f64, a| longest.max(*a));
        self.spatial.cover(2.0 * longest);
        equations::solve(&self.spatial, nodes, self.problem, half_lengths)
    }

    /// dσ/d ln a, one column per half-length.
    fn derivatives(&mut self, nodes: &Nodes, half_lengths: &[f64], slack: &[f64]) -> Mat<f64> {
        let n = half_lengths.len();
        let mut derivatives = Mat::zeros(n, n);
        for by in 0..n {
            let mut moved = half_lengths.to_vec();
            moved[by] *= DIFFERENCE.exp();
            let changed = self.solve(nodes, &moved).slack;
            for i in 0..n {
                derivatives[(i, by)] = (changed[i] - slack[i]) / DIFFERENCE;
            }
        }
        derivatives
    }

    /// The solution, if it is admissible.
    fn solution(
        &mut self,
        nodes: &Nodes,
        level: &Discretised,
        errors: &[Estimate],
        warnings: Vec<Warning>,
    ) -> Result<Solution, ContactError> {
        let problem = self.problem;
        let longest = level.half_lengths.iter().fold(0.0, |longest: f64, a| longest.max(*a));
        let extent = problem.span(&level.half_lengths);
        self.spatial.cover(extent + longest);
        let (mut min_pressure, mut min_gap) = (0.0f64, 0.0f64);
        let mut contacts = Vec::new();
        for (i, error) in errors.iter().enumerate() {
            min_pressure = min_pressure.min(self.least_pressure(nodes, level, i)?);
            min_gap = min_gap.min(self.least_gap(nodes, level, i, extent)?);
            let (a, phi) = (level.half_lengths[i], &level.pressures.phi[i]);
            let coefficients: Vec<f64> = nodes.coefficients(phi).iter().map(|c| c / a).collect();
            let peak = if problem.sides[i].is_sharp() { f64::INFINITY } else { level.peaks[i] };
            let part = RightInterval { from: 0.0, from_error: 0.0, to: a, to_error: error.length * a };
            contacts.push(Found::even(vec![part], [peak, error.pressure * peak], vec![Strip::series(a, coefficients)]));
        }
        let stats = Stats {
            modes: vec![nodes.half(); problem.contacts()],
            newton_steps: self.steps.clone(),
            factorisations: self.steps.iter().sum(),
            wavenumbers: problem.kernel.stats().wavenumbers + self.spatial.samples(),
            ..problem.kernel.stats()
        };
        Ok(Answer { contacts, min_pressure, min_gap, tilts: Vec::new(), stats, warnings }.into_solution(problem))
    }

    /// The smallest pressure at the nodes of contact i; an error if it is negative.
    fn least_pressure(&self, nodes: &Nodes, level: &Discretised, i: usize) -> Result<f64, ContactError> {
        let (a, phi) = (level.half_lengths[i], &level.pressures.phi[i]);
        let mut least = 0.0f64;
        for (phi, s) in phi.iter().zip(&nodes.s) {
            let pressure = phi * (1.0 - s * s).sqrt() / a;
            if pressure < -ZERO * level.peaks[i].abs() {
                let length = self.problem.kernel.length();
                let half_lengths = level.half_lengths.iter().map(|a| a * length).collect();
                let (interface, x) = (self.problem.interfaces[i], s * a * length);
                return Err(NoSolution::Tension { interface, x, half_lengths }.into());
            }
            least = least.min(pressure);
        }
        Ok(least)
    }

    /// The smallest gap outside contact i; an error if it is negative.
    fn least_gap(&self, nodes: &Nodes, level: &Discretised, i: usize, extent: f64) -> Result<f64, ContactError> {
        let side = &self.problem.sides[i];
        let gaps = gaps::gaps(&self.spatial, nodes, side, &level.half_lengths, &level.pressures, (i, extent));
        let widest = gaps.iter().fold(0.0, |widest: f64, (_, gap)| widest.max(gap.abs()));
        let mut least = 0.0f64;
        for (x, gap) in gaps {
            if gap < -ZERO * widest {
                let x = x * self.problem.kernel.length();
                return Err(NoSolution::Penetration { interface: self.problem.interfaces[i], x }.into());
            }
            least = least.min(gap);
        }
        Ok(least)
    }
}

/// φ at s = 0.
fn peak(nodes: &Nodes, phi: &[f64]) -> f64 {
    nodes.coefficients(phi).iter().enumerate().map(|(m, c)| alternating(m) * c).sum()
}
