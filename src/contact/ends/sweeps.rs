//! Rounds of iteration: more modes than are solved for, and the last digits of half-lengths and pressures.
use crate::contact::ends::converged::Converged;
use crate::contact::ends::newton::{NEARBY, Newton, Point, SLOW, advance, linear, longest, not_converged, ties};
use crate::contact::equations::assemble::Equations;
use crate::contact::equations::condensed::{Drift, Pressures};
use crate::contact::error::ContactError;
use crate::contact::integrals::layout::negligible;
use crate::contact::problem::modes::beyond;

/// More modes than these, all contacts together, are not solved for only because they did not settle otherwise.
const MOST_SOLVED: usize = 600;
/// Pressures are let go on settling from level to level with an error of so many tolerances.
const PRESSURES: f64 = 10.0;
/// Ends on which less than so many tolerances depends need not be found.
const ENDS: f64 = 0.01;
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
/// Changes below this are rounding.
const NOISE: f64 = 1e-13;
/// The last digits come from rounds of iteration; this many at most.
const ROUNDS: usize = 12;
/// What rounds leave may be this part of what is missing anyway; of half-lengths, this part of that.
const LITTLE: f64 = 0.01;

impl Newton<'_> {
    /// Goes on from half-lengths nearby, and lets pressures settle with more modes than are solved for, to `tolerance`;
    /// where they do not, all modes are solved for. The half-lengths to begin with were found with `fewer` modes.
    pub(crate) fn converge(
        &mut self,
        half_lengths: Vec<f64>,
        fewer: &[usize],
        solved: &[usize],
        modes: &[usize],
        tolerance: f64,
    ) -> Result<Converged, ContactError> {
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
    ) -> Result<(Converged, bool), ContactError> {
        let start = half_lengths.clone();
        let linear = linear(tolerance, solved);
        let Point { mut half_lengths, mut corners, pressures, linearised, layout } =
            self.iterate(half_lengths, solved, modes, negligible(tolerance), [NEARBY, ENDS * tolerance])?;
        let Pressures { modes: mut all, mut step, .. } = pressures;
        linearised.follow(&mut all, &step);
        advance(&mut half_lengths, &mut corners, &step, 1.0);
        let mut bases = self.bases(&layout, &half_lengths, modes);
        let mut slopes = self.punch.slopes(half_lengths[0], modes[0]);
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
        let plain = (all.clone(), half_lengths.clone(), corners);
        let short = tolerance.min(NEARBY);
        // corners are linear over any way
        let fixed = usize::from(corners.is_some());
        let mut drift = Drift { shift: vec![0.0; n], ..Drift::default() };
        let mut lost = false;
        let mut responses = None;
        let mut missing = [0.0; 2];
        // modes of smooth pressures fall until there are none, and what contacts that are tied together miss grows
        let falls =
            |i: usize| self.kernel.far(i).is_constant() && (i > 0 || self.punch.is_smooth()) && !linked.contains(&true);
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
            // rounds do not bring what modes are missing
            let beyond = (0..n).filter(|i| falls(*i)).map(|i| beyond(&all[i]).0).fold(0.0, f64::max);
            missing = [LITTLE * LITTLE * beyond, LITTLE * beyond];
            let done = |[length, pressure]: &[f64; 2]| {
                *length <= missing[0].max(0.01 * tolerance) && *pressure <= missing[1].max(0.1 * tolerance)
            };
            if slow || lost || round > 0 && longest(&step) <= short && unsettled.iter().all(done) {
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
        let enough = [missing[0].max(tolerance), missing[1].max(PRESSURES * tolerance)];
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
            (all, half_lengths, corners) = plain.clone();
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
}
