//! Iterated Galerkin sweeps (Sloan 1976): more modes than are solved for, and the last digits of half-lengths and pressures.
use crate::contact::ends::Converged;
use crate::contact::ends::newton::{Aim, NEARBY, Newton, Point, Work, linear, strongly_coupled};
use crate::contact::equations::assemble::Equations;
use crate::contact::equations::condensed::{Drift, Linearised, Sweep};
use crate::contact::error::ContactError;
use crate::contact::integrals::basis::Basis;
use crate::contact::integrals::layout::{Layout, negligible};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, MINOR, PATIENCE, ROUNDING, SLOW};
use crate::contact::problem::estimate::Estimate;
use crate::contact::problem::modes::{Modes, beyond};
use crate::contact::problem::rows::Slopes;
use crate::contact::problem::support::{Support, longest};
use crate::kernel::DECAYED;
use crate::solution::Stopped;

impl Newton<'_> {
    /// A fine solution: goes on from half-lengths nearby, found with `fewer` modes, and sweeps with more modes than are solved
    /// for, to `tolerance`; where sweeps do not converge, all modes are solved for.
    pub(crate) fn converge(
        &mut self,
        half_lengths: Vec<f64>,
        fewer: &[usize],
        solved: &[usize],
        modes: &[usize],
        tolerance: f64,
    ) -> Result<Converged, ContactError> {
        let (solved, modes) = self.coupled_counts(&half_lengths, solved, modes);
        let (mut found, converged) = self.sweep(half_lengths.clone(), &solved, &modes, tolerance)?;
        if !converged
            && solved != modes
            && let Ok((all, true)) = self.sweep(half_lengths.clone(), &modes, &modes, tolerance)
        {
            found = all;
        }
        // where all modes were solved for, what those beyond fewer ones changed is the change since then
        for (i, fewer) in fewer.iter().enumerate() {
            if found.solved[i] == found.modes[i].len() {
                found.corrections[i] = (found.support.half_lengths[i] / half_lengths[i]).ln();
                found.solved[i] = found.solved[i].min(*fewer);
                found.fully_solved[i] = true;
            }
        }
        Ok(found)
    }

    /// Modes to be solved for, and all. Strongly coupled contacts have the same, all of them solved for: the dominant part
    /// of a row is the difference of two pressures, not its own diagonal.
    fn coupled_counts(&self, half_lengths: &[f64], solved: &[usize], modes: &[usize]) -> (Vec<usize>, Vec<usize>) {
        let (mut solved, mut modes) = (solved.to_vec(), modes.to_vec());
        let strong = strongly_coupled(self.problem.kernel, half_lengths);
        let mut unknown = self.problem.unknown().peekable();
        while let Some(first) = unknown.next() {
            let mut group = first..first + 1;
            while unknown.next_if(|next| strong[*next - 1]).is_some() {
                group.end += 1;
            }
            if group.len() > 1 {
                let most = modes[group.clone()].iter().copied().fold(0, usize::max);
                modes[group.clone()].fill(most);
                solved[group].fill(most);
            }
        }
        (solved, modes)
    }

    /// Newton's method with the modes that are solved for, then sweeps with all; whether these converged.
    fn sweep(
        &mut self,
        half_lengths: Vec<f64>,
        solved: &[usize],
        modes: &[usize],
        tolerance: f64,
    ) -> Result<(Converged, bool), ContactError> {
        let aim = Aim { negligible: negligible(tolerance), step: NEARBY, ends: MINOR * tolerance };
        let point = self.iterate(half_lengths.clone(), solved, modes, aim)?;
        let mut sweeps = Sweeps::new(self.problem, &point, solved, modes, tolerance);
        let stopped = sweeps.run(&mut self.work);
        let converged = sweeps.finish(stopped);
        if !converged
            && solved == modes
            && let Ok(end) = self.iterate(half_lengths, solved, modes, Aim { step: ROUNDING * ROUNDING, ..aim })
        {
            return Ok((Converged::without_sweeps(end, solved), true));
        }
        sweeps.give_up_lost(stopped);
        let Sweeps { support, modes: all, corrections, residuals, .. } = sweeps;
        if !support.half_lengths.iter().chain(all.iter().flatten()).all(|value| value.is_finite()) {
            return Err(self.problem.not_converged(&support.half_lengths));
        }
        let linearised = point.linearised;
        let found = Converged {
            support,
            modes: all,
            solved: solved.to_vec(),
            corrections,
            fully_solved: vec![false; solved.len()],
            residuals,
            influences: linearised.influences,
            stopped,
        };
        Ok((found, converged))
    }
}

impl Converged {
    /// The solution of Newton's method alone.
    fn without_sweeps(end: Point, solved: &[usize]) -> Self {
        let n = solved.len();
        Self {
            support: end.support,
            modes: end.pressures.modes,
            solved: solved.to_vec(),
            corrections: vec![0.0; n],
            fully_solved: vec![false; n],
            residuals: end.pressures.step.iter().map(|step| Estimate::both(step.abs())).collect(),
            influences: end.linearised.influences,
            stopped: Stopped::Converged,
        }
    }
}

/// Sweeps about a point of Newton's method.
struct Sweeps<'a> {
    problem: &'a Problem<'a>,
    layout: &'a Layout,
    linearised: &'a Linearised,
    solved: &'a [usize],
    counts: &'a [usize],
    strong: Vec<bool>,
    tolerance: f64,
    support: Support,
    modes: Modes,
    /// Support and modes where sweeps began.
    begin: (Support, Modes),
    /// What the modes beyond those solved for changed the logarithms of the half-lengths by.
    corrections: Vec<f64>,
    /// What the last sweep changed, and the one before.
    changes: [Vec<Estimate>; 2],
    residuals: Vec<Estimate>,
    /// How far half-lengths have moved since the tables were made.
    drift: Drift,
    /// The last step, if it is still to be taken.
    step: Vec<f64>,
    /// What sweeps may leave, since the truncation error is larger.
    truncation: Estimate,
}

impl<'a> Sweeps<'a> {
    fn new(
        problem: &'a Problem<'a>,
        point: &'a Point,
        solved: &'a [usize],
        counts: &'a [usize],
        tolerance: f64,
    ) -> Self {
        let (mut support, mut modes) = (point.support.clone(), point.pressures.modes.clone());
        point.linearised.follow(&mut modes, &point.pressures.step);
        support.advance(&point.pressures.step);
        modes.iter_mut().zip(counts).for_each(|(own, count)| own.resize(*count, 0.0));
        let n = solved.len();
        let infinite = vec![Estimate::both(f64::INFINITY); n];
        Self {
            problem,
            layout: &point.layout,
            linearised: &point.linearised,
            solved,
            counts,
            strong: strongly_coupled(problem.kernel, &support.half_lengths),
            tolerance,
            begin: (support.clone(), modes.clone()),
            support,
            modes,
            corrections: vec![0.0; n],
            changes: [infinite.clone(), infinite.clone()],
            residuals: infinite,
            drift: Drift { shift: vec![0.0; n], ..Drift::default() },
            step: Vec::new(),
            truncation: Estimate::default(),
        }
    }

    /// Sweeps until there is a reason to stop.
    fn run(&mut self, work: &mut Work) -> Stopped {
        let linear = linear(self.tolerance, self.solved);
        let strong = self.strong.clone();
        let (mut bases, mut slopes) = (self.bases(), self.slopes());
        for sweep in 0..PATIENCE {
            work.step();
            let equations = Equations::new(self.layout, &bases, self.solved, &strong, &self.support);
            let found = self.linearised.sweep(&equations, &slopes, &self.drift, &mut self.modes);
            let is_slow = self.compare(sweep, &found);
            self.step = found.step;
            if let Some(stopped) = self.stopped(sweep, is_slow) {
                return stopped;
            }
            self.linearised.follow(&mut self.modes, &self.step);
            self.drift.shift.iter_mut().zip(&self.step).for_each(|(shift, step)| *shift += step);
            self.step.fill(0.0);
            let is_far = self.support.longest(&self.drift.shift) > linear;
            if !is_far && self.drift.derivatives.is_empty() {
                self.drift.derivatives = equations.derivatives(&self.modes, &slopes);
            }
            drop(equations);
            if is_far {
                let drift = Drift { shift: vec![0.0; self.solved.len()], ..Drift::default() };
                self.support.advance(&std::mem::replace(&mut self.drift, drift).shift);
                // not both at once
                bases.clear();
                (bases, slopes) = (self.bases(), self.slopes());
            }
        }
        Stopped::Slow
    }

    fn bases(&self) -> Vec<Basis> {
        Basis::all(self.layout, self.problem, &self.support.half_lengths, self.counts)
    }

    fn slopes(&self) -> Vec<Option<Slopes>> {
        self.problem.slopes(&self.support.half_lengths, self.counts)
    }

    /// Estimates from the changes of the last sweeps what is left; whether they hardly grow shorter.
    fn compare(&mut self, sweep: usize, found: &Sweep) -> bool {
        let mut is_slow = false;
        self.changes.swap(0, 1);
        for i in 0..self.solved.len() {
            let now = Estimate::new(found.step[i].abs(), found.changes[i]);
            let (before, earlier) = (self.changes[1][i], self.changes[0][i]);
            if sweep > 0 {
                self.corrections[i] += found.step[i];
            }
            let mut left = |now: f64, before: f64, earlier: f64| {
                let ratio = ratio(now, before);
                let twice = SLOW * SLOW * earlier;
                is_slow |= sweep > 1 && ratio > SLOW && now > twice.max(ROUNDING);
                now * rest(ratio)
            };
            self.residuals[i] = Estimate {
                length: left(now.length, before.length, earlier.length),
                pressure: left(now.pressure, before.pressure, earlier.pressure),
            };
            self.changes[0][i] = now;
        }
        is_slow
    }

    /// Why there is to be no further sweep, if so.
    fn stopped(&mut self, sweep: usize, is_slow: bool) -> Option<Stopped> {
        let longest = longest(self.step.iter().copied());
        let has_diverged = sweep > 0 && (longest >= MINOR || longest.is_nan());
        // sweeps cannot recover modes beyond the last one: stop at the truncation estimate
        let beyond = (0..self.solved.len()).filter(|i| self.falls(*i)).map(|i| beyond(&self.modes[i]).0);
        let beyond = beyond.fold(0.0, f64::max);
        self.truncation = Estimate::new(MINOR * MINOR * beyond, MINOR * beyond);
        if has_diverged {
            return Some(Stopped::Diverged);
        }
        if is_slow {
            return Some(Stopped::Slow);
        }
        let wanted = Estimate::new(MINOR * self.tolerance, 0.1 * self.tolerance);
        let enough = Estimate {
            length: self.truncation.length.max(wanted.length),
            pressure: self.truncation.pressure.max(wanted.pressure),
        };
        let is_short = sweep > 0 && longest <= self.tolerance.min(NEARBY);
        let is_done = |enough: Estimate| is_short && self.residuals.iter().all(|left| left.is_within(enough));
        is_done(enough).then(|| if is_done(wanted) { Stopped::Converged } else { Stopped::Truncated })
    }

    /// Whether the modes of contact i fall until there are none: modes of smooth pressures do, but what strongly coupled contacts
    /// miss grows.
    fn falls(&self, i: usize) -> bool {
        let is_smooth = self.problem.sides[i].is_smooth();
        self.problem.kernel.asymptote(i).is_constant() && is_smooth && !self.strong.contains(&true)
    }

    /// Takes what is left of the steps; whether sweeps have converged.
    fn finish(&mut self, stopped: Stopped) -> bool {
        self.linearised.follow(&mut self.modes, &self.step);
        let beyond: Vec<f64> = (0..self.residuals.len()).map(|i| self.beyond_drift(i)).collect();
        for (i, left) in self.residuals.iter_mut().enumerate() {
            left.length += MINOR * self.step[i].abs() + beyond[i];
        }
        self.support.advance(&self.drift.shift);
        self.support.advance(&self.step);
        let enough = Estimate {
            length: self.truncation.length.max(self.tolerance),
            pressure: self.truncation.pressure.max(self.tolerance),
        };
        let converged = stopped != Stopped::Diverged && self.residuals.iter().all(|left| left.is_within(enough));
        for i in 0..self.residuals.len() {
            let left = Estimate::new(self.led(i, |change| change.length), self.led(i, |change| change.pressure));
            let own = &mut self.residuals[i];
            *own = Estimate::new(own.length.max(left.length), own.pressure.max(left.pressure));
        }
        converged
    }

    /// What rows linear in the way of the end of contact i leave out: the square of the way over the length along which pressures and
    /// displacements vary there, the contact itself or the thickness of the layers at its faces.
    fn beyond_drift(&self, i: usize) -> f64 {
        let thin = self.problem.kernel.asymptote(i).from * self.support.half_lengths[i] / DECAYED;
        (self.drift.shift[i] * thin.max(1.0)).powi(2)
    }

    /// What sweeps have left of contact i if it goes on as slowly as a neighbour that still changes more.
    fn led(&self, i: usize, of: impl Fn(&Estimate) -> f64) -> f64 {
        let [now, before] = self.changes.each_ref().map(|changes| changes.iter().map(&of).collect::<Vec<f64>>());
        let leading = (i.saturating_sub(1)..(i + 2).min(now.len())).filter(|k| now[*k] > now[i]);
        leading.map(|k| now[i] * rest(ratio(now[k], before[k]))).fold(0.0, f64::max)
    }

    /// Goes back to the modes that were solved for where sweeps have diverged.
    fn give_up_lost(&mut self, stopped: Stopped) {
        if stopped == Stopped::Diverged || self.residuals.iter().any(|left| left.length > MINOR) {
            (self.support, self.modes) = self.begin.clone();
            for (own, solved) in self.modes.iter_mut().zip(self.solved) {
                own.truncate(*solved);
            }
            for (left, step) in self.residuals.iter_mut().zip(&self.step) {
                *left = Estimate::new(COARSE.max(step * step), COARSE);
            }
        }
        // half-lengths may converge where high modes do not, for which the dominant part of a row is not its diagonal
        for (i, left) in self.residuals.iter_mut().enumerate().filter(|(_, left)| left.pressure > MINOR) {
            self.modes[i] = self.begin.1[i][..self.solved[i]].to_vec();
            left.pressure = COARSE;
        }
    }
}

/// The ratio of the last two terms of a series.
fn ratio(now: f64, before: f64) -> f64 {
    if now == 0.0 { 0.0 } else { now / before }
}

/// The sum of the terms of a geometric series behind one of them, over that; a tenth at least.
fn rest(ratio: f64) -> f64 {
    (ratio / (1.0 - ratio.min(0.9))).max(0.1)
}
