//! Newton's method for the logarithms of the half-lengths, with given numbers of modes.
use crate::error::{Error, NoSolution};
use crate::kernel::Kernel;

use super::basis::Basis;
use super::converged::Converged;
use super::fading::Fading;
use super::galerkin::{Equations, Modes, Slopes};
use super::layout::{Layout, negligible};
use super::pressures::{Drift, Linearised, Pressures, solve};
use super::punch::Indentation;

/// Longest step in the logarithm of a half-length.
const LONGEST_STEP: f64 = 0.5;
/// A layout serves half-lengths that differ by this much, in the logarithm.
const LAYOUT_SERVES: f64 = 0.1;
/// Steps at most: Newton's method doubles its digits with each.
const STEPS: usize = 40;
/// Farther from the start, in the logarithm of a half-length, Newton's method is lost.
const FARTHEST: f64 = 4.0;
/// Rounds of iteration begin when what is left of a Newton step is below this.
const NEARBY: f64 = 1e-5;
/// More modes than these, all contacts together, are not solved for only because they did not settle otherwise.
const MOST_SOLVED: usize = 600;
/// Pressures are let go on settling from level to level with an error of so many tolerances.
const PRESSURES: f64 = 10.0;
/// Ends on which less than so many tolerances depends need not be found.
const ENDS: f64 = 0.01;
/// The same for the first steps.
const ROUGH_ENDS: f64 = 1e-6;
/// Where there are no rounds, Newton's method goes on to this.
const FULLY: f64 = 1e-20;
/// Derivatives from few modes are right to about this part.
const DERIVATIVES: f64 = 1e-2;
/// Rounds that change more than this are not going anywhere.
const DIVERGED: f64 = 1e-2;
/// What is taken for the error of modes that did not settle, on top of how they fall.
const UNKNOWN: f64 = 1e-4;
/// A round is taken to leave at least this part of what it changed.
const LEAST_LEFT: f64 = 0.1;
/// What Newton's method may leave in the logarithms of the half-lengths before the rounds.
const QUADRATIC: f64 = 1e-7;
/// Half-lengths may move by the root of a thousandth of the tolerance before tables are made anew, with so many modes.
const FEW: usize = 8;
/// Changes below this are rounding.
const NOISE: f64 = 1e-13;
/// A laminate that bends this much more easily than its contacts are squeezed ties their pressures together.
const TIES: f64 = 1e4;

/// The last digits come from rounds of iteration; this many at most.
const ROUNDS: usize = 12;
/// Rounds that change this much of what the round before changed do not end.
const SLOW: f64 = 0.5;

/// What Newton's method has done, all attempts together.
#[derive(Clone, Default)]
pub(super) struct Work {
    /// Steps and rounds on each level.
    pub(super) steps: Vec<usize>,
    /// Wavenumbers of all layouts.
    pub(super) interpolated: usize,
    /// Systems factorised.
    pub(super) factorisations: usize,
}

impl Work {
    fn step(&mut self) {
        if let Some(steps) = self.steps.last_mut() {
            *steps += 1;
        }
    }
}

/// Newton's method on one stack under one punch.
pub(super) struct Newton<'a> {
    pub(super) kernel: &'a Kernel,
    pub(super) punch: &'a Indentation<'a>,
    pub(super) work: Work,
    /// Whether there were too many wavenumbers for what was to be negligible.
    pub(super) crowded: bool,
    fading: Fading,
}

impl<'a> Newton<'a> {
    pub(super) fn new(kernel: &'a Kernel, punch: &'a Indentation, work: Work) -> Self {
        Self { kernel, punch, work, crowded: false, fading: Fading::default() }
    }

    /// Goes on with given numbers of modes until the half-lengths are right to about `enough`: these, and the modes.
    pub(super) fn approach(
        &mut self,
        half_lengths: Vec<f64>,
        modes: &[usize],
        negligible: f64,
        enough: f64,
    ) -> Result<(Vec<f64>, Modes), Error> {
        let Point { mut half_lengths, mut corners, pressures, linearised, layout, .. } =
            self.iterate(half_lengths, modes, modes, negligible, [enough, ROUGH_ENDS])?;
        let Pressures { modes: mut all, mut step, .. } = pressures;
        let linked = ties(self.kernel, &half_lengths);
        let fixed = usize::from(corners.is_some());
        let first = longest(&step[fixed..]);
        loop {
            let last = longest(&step[fixed..]);
            linearised.follow(&mut all, &step);
            let before = half_lengths[0];
            advance(&mut half_lengths, &mut corners, &step, 1.0);
            if corners.is_none() {
                half_lengths[0] = self.punch.within(before, half_lengths[0]);
            }
            // on with the same derivatives, as far as these shorten the steps
            if first * last <= QUADRATIC {
                break;
            }
            let bases = self.bases(&layout, &half_lengths, modes);
            let slopes = self.punch.slopes(half_lengths[0], modes[0]);
            let equations = Equations::new(&layout, &bases, modes, &linked).with_corners(corners);
            self.work.step();
            step = linearised.settle(&equations, &slopes, &Drift::default(), &mut all).step;
            if longest(&step[fixed..]) > 0.5 * last {
                break;
            }
        }
        Ok((half_lengths, all))
    }

    /// The same, and then lets pressures settle with more modes than are solved for, to `tolerance`; where they do not,
    /// all modes are solved for. The half-lengths to begin with were found with `fewer` modes.
    pub(super) fn converge(
        &mut self,
        half_lengths: Vec<f64>,
        fewer: &[usize],
        solved: &[usize],
        modes: &[usize],
        tolerance: f64,
    ) -> Result<Converged, Error> {
        let tied = self.tied(&half_lengths, solved, modes);
        let (mut found, settled) = self.settle(half_lengths.clone(), &tied.0, &tied.1, tolerance)?;
        if !settled
            && tied.0 != tied.1
            && tied.1.iter().sum::<usize>() <= MOST_SOLVED
            && let Ok((all, true)) = self.settle(half_lengths.clone(), &tied.1, &tied.1, tolerance)
        {
            found = all;
        }
        // where all modes were solved for, what those beyond fewer ones changed is the change since then
        for (i, fewer) in fewer.iter().enumerate() {
            if found.solved[i] == found.modes[i].len() {
                found.shift[i] = (found.half_lengths[i] / half_lengths[i]).ln();
                found.solved[i] = found.solved[i].min(*fewer);
                found.whole[i] = true;
            }
        }
        Ok(found)
    }

    /// Modes to be solved for, and all. Contacts that are tied together have the same, all of them solved for: the
    /// dominant part of a row is the difference of two pressures, not its own diagonal.
    fn tied(&self, half_lengths: &[f64], solved: &[usize], modes: &[usize]) -> (Vec<usize>, Vec<usize>) {
        let (mut solved, mut modes) = (solved.to_vec(), modes.to_vec());
        let linked = ties(self.kernel, half_lengths);
        let mut first = usize::from(self.punch.given().is_some());
        while first < modes.len() {
            let group = first..first + 1 + linked[first..].iter().take_while(|linked| **linked).count();
            if group.len() > 1 {
                let most = modes[group.clone()].iter().copied().fold(0, usize::max);
                modes[group.clone()].fill(most);
                solved[group.clone()].fill(most);
            }
            first = group.end;
        }
        (solved, modes)
    }

    /// Lets pressures settle with given numbers of modes, and says whether they did.
    fn settle(
        &mut self,
        half_lengths: Vec<f64>,
        solved: &[usize],
        modes: &[usize],
        tolerance: f64,
    ) -> Result<(Converged, bool), Error> {
        let start = half_lengths.clone();
        let Point { mut half_lengths, mut corners, pressures, linearised, layout, mut bases, mut slopes } =
            self.iterate(half_lengths, solved, modes, negligible(tolerance), [NEARBY, ENDS * tolerance])?;
        let Pressures { modes: mut all, mut step, .. } = pressures;
        let faded = self.fading.faded(&half_lengths);
        for (own, modes) in all.iter_mut().zip(modes) {
            own.resize(*modes, 0.0);
        }
        let n = solved.len();
        let linked = ties(self.kernel, &half_lengths);
        let mut shift = vec![0.0; n];
        // of the last round and of that before
        let mut last = [vec![[f64::INFINITY; 2]; n], vec![[f64::INFINITY; 2]; n]];
        let mut unsettled = last[0].clone();
        let plain = (all.clone(), half_lengths.clone(), corners, step.clone());
        let short = tolerance.min(NEARBY);
        // high modes oscillate, and are linear over a shorter way
        let highest = solved.iter().copied().fold(FEW, usize::max);
        let linear = (1e-3 * tolerance).sqrt().min(NEARBY) * FEW as f64 / highest as f64;
        // corners are linear over any way
        let fixed = usize::from(corners.is_some());
        let mut drift = Drift { shift: vec![0.0; n], ..Drift::default() };
        let mut lost = false;
        let mut responses = None;
        for round in 0..ROUNDS {
            self.work.step();
            let equations = Equations::new(&layout, &bases, solved, &linked).with_corners(corners);
            let found = linearised.settle(&equations, &slopes, &drift, &mut all);
            let mut slow = false;
            last.swap(0, 1);
            for i in 0..n {
                let (now, before, earlier) = ([found.step[i].abs(), found.changes[i]], last[1][i], last[0][i]);
                if round > 0 {
                    shift[i] += found.step[i];
                }
                for k in 0..2 {
                    // a geometric series goes on with the ratio of its last terms
                    let ratio = if now[k] == 0.0 { 0.0 } else { now[k] / before[k] };
                    unsettled[i][k] = now[k] * (ratio / (1.0 - ratio.min(0.9))).max(LEAST_LEFT);
                    let twice = SLOW * SLOW * earlier[k];
                    slow |= round > 1 && ratio > SLOW && now[k] > twice.max(NOISE);
                }
                last[0][i] = now;
            }
            step = found.step;
            responses = Some(found.responses);
            lost = round > 0 && (longest(&step) >= DIVERGED || longest(&step).is_nan());
            let settled = |[length, pressure]: &[f64; 2]| *length <= 0.01 * tolerance && *pressure <= 0.1 * tolerance;
            if slow || lost || round > 0 && longest(&step) <= short && unsettled.iter().all(settled) {
                break;
            }
            linearised.follow(&mut all, &step);
            drift.shift.iter_mut().zip(&step).for_each(|(shift, step)| *shift += step);
            step.fill(0.0);
            if longest(&drift.shift[fixed..]) > linear {
                advance(&mut half_lengths, &mut corners, &drift.shift, 1.0);
                drift = Drift { shift: vec![0.0; n], ..Drift::default() };
                // not both at once
                bases.clear();
                bases = self.bases(&layout, &half_lengths, modes);
                slopes = self.punch.slopes(half_lengths[0], modes[0]);
            } else if drift.derivatives.is_empty() {
                drift.derivatives = equations.derivatives(&all, &slopes);
            }
        }
        linearised.follow(&mut all, &step);
        for (i, unsettled) in unsettled.iter_mut().enumerate() {
            unsettled[0] += DERIVATIVES * step[i].abs() + drift.shift[i] * drift.shift[i];
        }
        advance(&mut half_lengths, &mut corners, &drift.shift, 1.0);
        advance(&mut half_lengths, &mut corners, &step, 1.0);
        let enough = [tolerance, PRESSURES * tolerance];
        let settled =
            !lost && unsettled.iter().all(|both| both.iter().zip(&enough).all(|(left, enough)| left <= enough));
        // not those of two attempts at once
        drop(bases);
        if !settled
            && solved == modes
            && let Ok(end) = self.iterate(start, solved, modes, negligible(tolerance), [FULLY, ENDS * tolerance])
        {
            let influences = end.linearised.influences;
            let unsettled = end.pressures.step.iter().map(|step| [step.abs(); 2]).collect();
            let Point { half_lengths, corners, pressures, .. } = end;
            let (modes, solved, whole) = (pressures.modes, solved.to_vec(), vec![false; n]);
            let (waves, faded) = (None, self.fading.faded(&half_lengths));
            let found =
                Converged { half_lengths, modes, corners, solved, shift, whole, unsettled, influences, faded, waves };
            return Ok((found, true));
        }
        if lost || unsettled.iter().any(|[length, _]| *length > DIVERGED) {
            // the modes that were solved for are all there is
            responses = None;
            (all, half_lengths, corners, step) = plain.clone();
            advance(&mut half_lengths, &mut corners, &step, 1.0);
            linearised.follow(&mut all, &step);
            for (own, solved) in all.iter_mut().zip(solved) {
                own.truncate(*solved);
            }
            for (unsettled, step) in unsettled.iter_mut().zip(&step) {
                *unsettled = [UNKNOWN.max(step * step), UNKNOWN];
            }
        }
        // half-lengths may settle where high modes do not, for which the dominant part of a row is not its diagonal
        for (i, [_, unsettled]) in unsettled.iter_mut().enumerate().filter(|(_, [_, pressure])| *pressure > DIVERGED) {
            all[i] = plain.0[i][..solved[i]].to_vec();
            *unsettled = UNKNOWN;
            responses = None;
        }
        let influences = linearised.influences;
        if !half_lengths.iter().chain(all.iter().flatten()).all(|value| value.is_finite()) {
            return Err(not_converged(self.kernel, self.punch, &half_lengths));
        }
        // gaps of contacts that are tied together feel the smallest difference of their pressures
        let waves = responses.filter(|_| !linked.contains(&true)).map(|responses| (layout, responses));
        let (solved, whole) = (solved.to_vec(), vec![false; n]);
        let modes = all;
        let found =
            Converged { half_lengths, modes, corners, solved, shift, whole, unsettled, influences, faded, waves };
        Ok((found, settled))
    }

    /// Newton's method until what would be left of the next step is below `enough`. Ends on which less than `little` depends
    /// are left where they are.
    fn iterate(
        &mut self,
        mut half_lengths: Vec<f64>,
        solved: &[usize],
        modes: &[usize],
        negligible: f64,
        [enough, little]: [f64; 2],
    ) -> Result<Point, Error> {
        let (kernel, punch) = (self.kernel, self.punch);
        let mut orders: Vec<usize> = modes.iter().map(|modes| 2 * modes).collect();
        if punch.given().is_some() {
            orders[0] = 0;
        }
        let start = half_lengths.clone();
        let mut corners = punch.flat().map(|_| 1.0);
        let mut layout: Option<(Layout, Vec<f64>)> = None;
        self.work.steps.push(0);
        self.fading.begin(solved.len(), punch.given().is_some());
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let near = |about: &[f64], by: f64| half_lengths.iter().zip(about).all(|(a, b)| (a / b).ln().abs() <= by);
            if !near(&start, FARTHEST) {
                break;
            }
            let at = match layout.take().filter(|(_, about)| near(about, LAYOUT_SERVES)) {
                Some(serves) => serves,
                None => match Layout::new(kernel, &half_lengths, &orders, negligible, 0.0) {
                    Some(new) => {
                        self.work.interpolated += new.zeta.len();
                        (new, half_lengths.clone())
                    }
                    None => {
                        self.crowded = true;
                        break;
                    }
                },
            };
            let bases = self.bases(&at.0, &half_lengths, modes);
            let slopes = punch.slopes(half_lengths[0], modes[0]);
            let linked = ties(kernel, &half_lengths);
            self.work.step();
            self.work.factorisations += 1;
            let equations = Equations::new(&at.0, &bases, solved, &linked).with_corners(corners);
            let found = solve(&equations, &slopes, &self.fading.left());
            let Some((pressures, linearised)) = found else { break };
            if self.fading.look(&mut half_lengths, &pressures, &linearised, little) {
                layout = Some(at);
                continue;
            }
            let left = longest(&pressures.step);
            // short steps that no longer shorten are rounding
            let stuck = last < NEARBY && left > 0.5 * last;
            if left * left < enough || stuck {
                return Ok(Point { half_lengths, corners, pressures, linearised, layout: at.0, bases, slopes });
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
            layout = Some(at);
        }
        Err(not_converged(kernel, punch, &half_lengths))
    }
}

impl Newton<'_> {
    fn bases(&self, layout: &Layout, half_lengths: &[f64], modes: &[usize]) -> Vec<Basis> {
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

/// Takes a part of a step: in the logarithms of the half-lengths, and in the amplitude of corners in place of the first.
fn advance(half_lengths: &mut [f64], corners: &mut Option<f64>, step: &[f64], part: f64) {
    let first = usize::from(corners.is_some());
    if let Some(corners) = corners {
        *corners += part * step[0];
    }
    for (a, step) in half_lengths.iter_mut().zip(step).skip(first) {
        *a *= (part * step).exp();
    }
}

fn longest(step: &[f64]) -> f64 {
    // a step that is no number leads nowhere, and is longer than any
    step.iter().fold(0.0, |longest: f64, step| if step.is_nan() { f64::INFINITY } else { longest.max(step.abs()) })
}

/// Half-lengths with the solution of the equations there.
struct Point {
    half_lengths: Vec<f64>,
    corners: Option<f64>,
    pressures: Pressures,
    linearised: Linearised,
    layout: Layout,
    /// All modes, more than are solved for.
    bases: Vec<Basis>,
    slopes: Slopes,
}

/// Which laminates tie the pressures of their contacts together.
pub(super) fn ties(kernel: &Kernel, half_lengths: &[f64]) -> Vec<bool> {
    half_lengths.windows(2).enumerate().map(|(i, pair)| kernel.ties(i, 3.0 / pair[0].max(pair[1])) > TIES).collect()
}

/// The error of a lost Newton iteration: at the edge of the punch, the punch is to blame.
pub(super) fn not_converged(kernel: &Kernel, punch: &Indentation, half_lengths: &[f64]) -> Error {
    if let Some(error) = punch.too_small(half_lengths[0]) {
        return error;
    }
    NoSolution::NotConverged { half_lengths: half_lengths.iter().map(|a| a * kernel.length()).collect() }.into()
}
