//! Newton's method for the logarithms of the half-lengths, with given numbers of modes.
use crate::contact::ends::broyden::Secants;
use crate::contact::ends::frozen::Fading;
use crate::contact::equations::assemble::Equations;
use crate::contact::equations::condensed::{Drift, Linearised, Pressures, solve};
use crate::contact::error::{ContactError, NoSolution};
use crate::contact::integrals::basis::Basis;
use crate::contact::integrals::layout::{CAREFUL, COARSE, Layout};
use crate::contact::problem::modes::Modes;
use crate::contact::problem::profile::Indentation;
use crate::kernel::Kernel;

/// Longest step in the logarithm of a half-length.
const LONGEST_STEP: f64 = 0.5;
/// A layout serves half-lengths that differ by this much, in the logarithm.
const LAYOUT_SERVES: f64 = 0.1;
/// Steps at most: Newton's method doubles its digits with each.
const STEPS: usize = 40;
/// Farther from the start, in the logarithm of a half-length, Newton's method is lost.
const FARTHEST: f64 = 4.0;
/// Rounds of iteration begin when what is left of a Newton step is below this.
pub(crate) const NEARBY: f64 = 1e-5;
/// Ends on which less than this depends need not be found in the first steps.
const ROUGH_ENDS: f64 = 1e-6;
/// What a Newton step with few modes leaves when derivatives are kept from there on, and what is to be left in the end.
const ROUGHLY: f64 = 2.5e-3;
const ROUGH: f64 = 1e-4;
/// Half-lengths may move by the root of a thousandth of the tolerance before tables are made anew, with so many modes.
const FEW: usize = 8;
/// A laminate that bends this much more easily than its contacts are squeezed ties their pressures together.
const TIES: f64 = 1e4;

/// Rounds that change this much of what the round before changed do not end.
pub(crate) const SLOW: f64 = 0.5;

/// What Newton's method has done, all attempts together.
#[derive(Clone, Default)]
pub(crate) struct Work {
    /// Steps and rounds on each level.
    pub(crate) steps: Vec<usize>,
    /// Wavenumbers of all layouts, those of tails included.
    pub(crate) interpolated: usize,
    /// Systems factorised.
    pub(crate) factorisations: usize,
}

impl Work {
    pub(crate) fn step(&mut self) {
        if let Some(steps) = self.steps.last_mut() {
            *steps += 1;
        }
    }
}

/// Newton's method on one stack under one punch.
pub(crate) struct Newton<'a> {
    pub(crate) kernel: &'a Kernel,
    pub(crate) punch: &'a Indentation<'a>,
    pub(crate) work: Work,
    /// Whether there were too many wavenumbers for what was to be negligible.
    pub(crate) crowded: bool,
    pub(crate) fading: Fading,
}

impl<'a> Newton<'a> {
    pub(crate) fn new(kernel: &'a Kernel, punch: &'a Indentation, work: Work) -> Self {
        Self { kernel, punch, work, crowded: false, fading: Fading::default() }
    }

    /// Goes on with given numbers of modes until the half-lengths are right to what [`Self::converge`] needs for this
    /// tolerance: these, and the modes.
    pub(crate) fn approach(
        &mut self,
        half_lengths: Vec<f64>,
        counts: &[usize],
        tolerance: f64,
    ) -> Result<(Vec<f64>, Modes), ContactError> {
        // contacts that are tied together feel small changes of derivatives, and what their modes miss is judged by how far
        // these half-lengths are off
        let tied = ties(self.kernel, &half_lengths).contains(&true);
        let (near, enough, negligible) =
            if tied { (NEARBY, 0.5 * linear(tolerance, counts), CAREFUL) } else { (ROUGHLY, ROUGH, COARSE) };
        let Point { mut half_lengths, mut corners, pressures, linearised, layout } =
            self.iterate(half_lengths, counts, counts, negligible, [near, ROUGH_ENDS])?;
        // on with the same derivatives
        let Pressures { mut modes, mut step, .. } = pressures;
        let linked = ties(self.kernel, &half_lengths);
        let fixed = usize::from(corners.is_some());
        let mut secants = Secants::default();
        let mut before = 1.0;
        let mut start = modes.clone();
        loop {
            let last = longest(&step[fixed..]);
            linearised.follow(&mut modes, &step);
            secants.improve(&start, &mut modes, &mut step);
            let first = half_lengths[0];
            advance(&mut half_lengths, &mut corners, &step, 1.0);
            if corners.is_none() {
                half_lengths[0] = self.punch.within(first, half_lengths[0]);
            }
            // what comes next is as much shorter again
            if last > SLOW * before || last * last / before <= enough {
                return Ok((half_lengths, modes));
            }
            before = last;
            let bases = self.bases(&layout, &half_lengths, counts);
            let slopes = self.punch.slopes(half_lengths[0], counts[0]);
            let equations = Equations::new(&layout, &bases, counts, &linked).with_corners(corners);
            self.work.step();
            start.clone_from(&modes);
            step = linearised.settle(&equations, &slopes, &Drift::default(), &mut modes).step;
        }
    }

    /// Newton's method until what would be left of the next step is below `enough`. Ends on which less than `little` depends
    /// are left where they are.
    pub(crate) fn iterate(
        &mut self,
        mut half_lengths: Vec<f64>,
        solved: &[usize],
        modes: &[usize],
        negligible: f64,
        [enough, little]: [f64; 2],
    ) -> Result<Point, ContactError> {
        let (kernel, punch) = (self.kernel, self.punch);
        let start = half_lengths.clone();
        let mut corners = punch.flat().map(|_| 1.0);
        let mut kept: Option<LaidOut> = None;
        self.work.steps.push(0);
        self.fading.begin(solved.len(), punch.given().is_some());
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let near = |about: &[f64], by: f64| half_lengths.iter().zip(about).all(|(a, b)| (a / b).ln().abs() <= by);
            if !near(&start, FARTHEST) {
                break;
            }
            let serves = kept.take().filter(|kept| near(&kept.about, LAYOUT_SERVES));
            let Some(laid_out) = serves.or_else(|| self.lay_out(&half_lengths, modes, negligible)) else { break };
            let layout = &laid_out.layout;
            let bases = self.bases(layout, &half_lengths, solved);
            let slopes = punch.slopes(half_lengths[0], solved[0]);
            let linked = ties(kernel, &half_lengths);
            self.work.step();
            self.work.factorisations += 1;
            let equations = Equations::new(layout, &bases, solved, &linked).with_corners(corners);
            let found = solve(&equations, &slopes, &self.fading.left());
            let Some((pressures, linearised)) = found else { break };
            if self.fading.look(&mut half_lengths, &pressures, &linearised, little) {
                kept = Some(laid_out);
                continue;
            }
            let left = longest(&pressures.step);
            // short steps that no longer shorten are rounding
            let stuck = last < NEARBY && left > 0.5 * last;
            if left * left < enough || stuck {
                return Ok(Point { half_lengths, corners, pressures, linearised, layout: laid_out.layout });
            }
            last = left;
            // the amplitude of corners, in which all is linear, may take any step
            let longest = longest(&pressures.step[usize::from(corners.is_some())..]);
            let shorten = (LONGEST_STEP / longest).min(1.0);
            let before = half_lengths[0];
            advance(&mut half_lengths, &mut corners, &pressures.step, shorten);
            if corners.is_none() {
                half_lengths[0] = punch.within(before, half_lengths[0]);
            }
            kept = Some(laid_out);
        }
        Err(not_converged(kernel, punch, &half_lengths))
    }
}

impl Newton<'_> {
    /// Wavenumbers for so many modes and half-lengths nearby, unless there are too many.
    fn lay_out(&mut self, half_lengths: &[f64], modes: &[usize], negligible: f64) -> Option<LaidOut> {
        let mut orders: Vec<usize> = modes.iter().map(|modes| 2 * modes).collect();
        if self.punch.given().is_some() {
            orders[0] = 0;
        }
        let Some(layout) = Layout::new(self.kernel, half_lengths, &orders, negligible, 0.0) else {
            self.crowded = true;
            return None;
        };
        self.work.interpolated += layout.nodes();
        Some(LaidOut { layout, about: half_lengths.to_vec() })
    }

    pub(crate) fn bases(&self, layout: &Layout, half_lengths: &[f64], modes: &[usize]) -> Vec<Basis> {
        let given = self.punch.given();
        let contacts = half_lengths.iter().zip(modes).enumerate();
        contacts
            .map(|(i, (a, modes))| match given.filter(|_| i == 0) {
                Some(given) => Basis::given(layout, given),
                None => Basis::new(layout, i, *a, *modes),
            })
            .collect()
    }
}

/// How far half-lengths may move, in the logarithm, before tables are made anew: high modes oscillate, and are linear over
/// a shorter way.
pub(crate) fn linear(tolerance: f64, solved: &[usize]) -> f64 {
    let highest = solved.iter().copied().fold(FEW, usize::max);
    (1e-3 * tolerance).sqrt().min(NEARBY) * FEW as f64 / highest as f64
}

/// Takes a part of a step: in the logarithms of the half-lengths, and in the amplitude of corners in place of the first.
pub(crate) fn advance(half_lengths: &mut [f64], corners: &mut Option<f64>, step: &[f64], part: f64) {
    let first = usize::from(corners.is_some());
    if let Some(corners) = corners {
        *corners += part * step[0];
    }
    for (a, step) in half_lengths.iter_mut().zip(step).skip(first) {
        *a *= (part * step).exp();
    }
}

pub(crate) fn longest(step: &[f64]) -> f64 {
    // a step that is no number leads nowhere, and is longer than any
    step.iter().fold(0.0, |longest: f64, step| if step.is_nan() { f64::INFINITY } else { longest.max(step.abs()) })
}

/// A layout, and the half-lengths it was made for.
struct LaidOut {
    layout: Layout,
    about: Vec<f64>,
}

/// Half-lengths with the solution of the equations there.
pub(crate) struct Point {
    pub(crate) half_lengths: Vec<f64>,
    pub(crate) corners: Option<f64>,
    pub(crate) pressures: Pressures,
    pub(crate) linearised: Linearised,
    pub(crate) layout: Layout,
}

/// Which laminates tie the pressures of their contacts together.
pub(crate) fn ties(kernel: &Kernel, half_lengths: &[f64]) -> Vec<bool> {
    half_lengths.windows(2).enumerate().map(|(i, pair)| kernel.ties(i, 3.0 / pair[0].max(pair[1])) > TIES).collect()
}

/// The error of a lost Newton iteration: at the edge of the punch, the punch is to blame.
pub(crate) fn not_converged(kernel: &Kernel, punch: &Indentation, half_lengths: &[f64]) -> ContactError {
    if let Some(error) = punch.too_small(half_lengths[0]) {
        return error;
    }
    NoSolution::NotConverged { half_lengths: half_lengths.iter().map(|a| a * kernel.length()).collect() }.into()
}
