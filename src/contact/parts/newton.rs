//! Newton's method for the ends and the pressures of several intervals, with a given number of pressures.
use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::contact::integrals::layout::{Layout, negligible};
use crate::contact::parts::equations::Equations;
use crate::contact::parts::interval::Interval;
use crate::contact::parts::{Lengths, Level, Work, ends, in_equilibrium, left_out, spacings, with_ends};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::ROUNDING;
use crate::contact::problem::iteration::Progress;

/// An end moves by at most this part of the intervals next to it in one step.
const LONGEST_STEP: f64 = 0.4;
/// Derivatives are kept as long as steps, in units of those intervals, are shorter than this, and become shorter by this factor.
const KEPT: f64 = 0.1;
/// Steps shorter than this that no longer become shorter are rounding.
const SHORT: f64 = 1e-7;

/// How Newton's method goes on after a step.
#[derive(Clone, Copy)]
pub(super) struct Way {
    /// Long steps of the ends are shortened all together, or each alone.
    together: bool,
    /// Pressures take their part of the step, or are solved for anew at the new ends.
    ///
    /// Where a layer without weight spans the gap between two intervals, there are ends nearby for which no pressures are in
    /// equilibrium: residuals as functions of the ends alone have poles there, so that pressures have to move with the ends. Where
    /// an interval carries next to nothing, that may lead to other roots, and pressures are better solved for anew.
    joint: bool,
}

impl Way {
    /// In the order in which they are tried.
    pub(super) fn all() -> [Self; 4] {
        [(true, true), (true, false), (false, true), (false, false)].map(|(joint, together)| Self { joint, together })
    }
}

/// Newton's method for the ends and the pressures; `None` if it does not converge.
pub(super) fn converge(
    problem: &Problem,
    mut intervals: Vec<Interval>,
    count: usize,
    way: Way,
    work: &mut Work,
) -> Option<Level> {
    let negligible = negligible(problem.tolerance);
    let mut kept = Kept::default();
    let mut limits = Limits::new(way);
    let mut progress = Progress::default();
    work.steps.push(0);
    loop {
        let lengths = Lengths::of(problem, &intervals);
        let layout = match kept.layout.take().filter(|(_, about)| lengths.are_near(about)) {
            Some(kept) => kept,
            None => {
                let Lengths { ends, shortest } = &lengths;
                (Layout::without_tails(problem.kernel, ends, shortest, negligible, 0.0)?, ends.clone())
            }
        };
        let equations = Equations { kernel: problem.kernel, problem, layout: &layout.0, intervals: &intervals, count };
        let Step { mut pressures, derivatives, change, of_ends } =
            Step::new(&equations, kept.pressures.take(), kept.derivatives.take(), work)?;
        let longest = of_ends.iter().fold(0.0, |longest: f64, step| longest.max(step.abs()));
        let shorten = if way.together { (LONGEST_STEP / longest).min(1.0) } else { 1.0 };
        pressures.iter_mut().zip(&change).for_each(|(own, change)| *own += shorten * change);
        if longest < ROUNDING || progress.is_rounding(longest, SHORT) {
            let left_out = |i: usize| left_out(problem.kernel, &layout.0, i, lengths.shortest[i], negligible);
            let left_out = (0..problem.contacts()).map(left_out).collect();
            let coefficients = in_equilibrium(&intervals, pressures.chunks_exact(count).map(<[f64]>::to_vec).collect());
            return Some(Level { intervals, coefficients, last_step: longest, left_out });
        }
        let derivatives = (longest < KEPT * progress.last && longest < KEPT).then_some(derivatives);
        if !progress.goes_on(longest) {
            return None;
        }
        let moved_by = limits.limit(of_ends, shorten);
        let moved = ends(&intervals).into_iter().zip(moved_by).zip(spacings(&intervals));
        let moved: Vec<f64> = moved.map(|((end, step), spacing)| end + step * spacing).collect();
        intervals = with_ends(&intervals, &moved)?;
        kept = Kept { layout: Some(layout), pressures: way.joint.then_some(pressures), derivatives };
    }
}

/// What the next step takes over from the one before.
#[derive(Default)]
struct Kept {
    /// A layout, with the outermost ends that it was made for.
    layout: Option<(Layout, Vec<f64>)>,
    pressures: Option<Vec<f64>>,
    derivatives: Option<Mat<f64>>,
}

/// A Newton step.
struct Step {
    /// Where the step begins.
    pressures: Vec<f64>,
    derivatives: Mat<f64>,
    /// The step of the pressures.
    change: Vec<f64>,
    /// The step of the ends, in units of the intervals next to them.
    of_ends: Vec<f64>,
}

impl Step {
    /// From given pressures, or those that go with these ends, and with given derivatives, or new ones.
    fn new(
        equations: &Equations,
        pressures: Option<Vec<f64>>,
        derivatives: Option<Mat<f64>>,
        work: &mut Work,
    ) -> Option<Self> {
        let Equations { intervals, layout, count, .. } = *equations;
        let (fields, wavenumbers) = (intervals.len() * count, layout.zeta.len());
        work.spend(fields, fields, wavenumbers, 1)?;
        let here = equations.system();
        *work.steps.last_mut()? += 1;
        let pressures = match pressures {
            Some(pressures) => pressures,
            None => here.pressures()?,
        };
        let residuals = here.residuals(&pressures);
        let derivatives = match derivatives {
            Some(derivatives) => derivatives,
            None => {
                work.spend(2 * intervals.len(), fields, wavenumbers, 2)?;
                equations.by_ends(&here, &pressures, &spacings(intervals))?
            }
        };
        let (change, of_ends) = newton_step(&here.matrix, &derivatives, &residuals)?;
        Some(Self { pressures, derivatives, change, of_ends })
    }
}

/// How far ends may move.
struct Limits {
    way: Way,
    limit: f64,
    /// The last step.
    before: Vec<f64>,
}

impl Limits {
    fn new(way: Way) -> Self {
        Self { way, limit: LONGEST_STEP, before: Vec::new() }
    }

    /// How far ends move that take this part of a step. One where the pressure is next to nothing is known badly, and does not hold
    /// up the others; steps back and forth grow shorter.
    fn limit(&mut self, step: Vec<f64>, part: f64) -> Vec<f64> {
        let back = self.before.iter().zip(&step).map(|(before, step)| before * step).sum::<f64>() < 0.0;
        self.limit = if back && !self.way.together { 0.5 * self.limit } else { (1.5 * self.limit).min(LONGEST_STEP) };
        self.before = step.iter().map(|step| (part * step).clamp(-self.limit, self.limit)).collect();
        self.before.clone()
    }
}

/// Changes of the pressures, and steps of the ends in units of the intervals next to each of them; `None` if they are no numbers.
fn newton_step(matrix: &Mat<f64>, derivatives: &Mat<f64>, residuals: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
    let (size, ends) = (matrix.ncols(), derivatives.ncols());
    let all = Mat::from_fn(size + ends, size + ends, |row, column| match column.checked_sub(size) {
        None => matrix[(row, column)],
        Some(by) => derivatives[(row, by)],
    });
    let right = Mat::from_fn(residuals.len(), 1, |row, _| -residuals[row]);
    let found = all.partial_piv_lu().solve(&right);
    let (change, step) = found.col_as_slice(0).split_at(size);
    found.col_as_slice(0).iter().all(|value| value.is_finite()).then(|| (change.to_vec(), step.to_vec()))
}
