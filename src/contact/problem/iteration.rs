//! When iterations end, and what they may cost: the same for all of them.
use crate::contact::problem::accuracy::{PATIENCE, SLOW};

/// A start may take this part of the operations that are left, so that some are left for those after it. All of them: four of 2,001
/// random scenes whose first start leads astray are not found.
const SHARE: f64 = 2.0 / 3.0;

/// The steps that an iteration has taken.
pub(crate) struct Progress {
    /// Length of the last step, infinite before the first.
    pub(crate) last: f64,
    /// Length of the shortest one.
    shortest: f64,
    /// How many more steps there may be without a shorter one.
    patience: usize,
}

impl Default for Progress {
    fn default() -> Self {
        Self { last: f64::INFINITY, shortest: f64::INFINITY, patience: PATIENCE }
    }
}

impl Progress {
    /// Whether a step is rounding: hardly shorter than the shortest one before, which was shorter than `short` already.
    pub(crate) fn is_rounding(&self, step: f64, short: f64) -> bool {
        self.shortest < short && step > SLOW * self.shortest
    }

    /// Counts a step; whether there may be another.
    pub(crate) fn goes_on(&mut self, step: f64) -> bool {
        self.patience = if step < self.shortest { PATIENCE } else { self.patience - 1 };
        self.shortest = self.shortest.min(step);
        self.last = step;
        self.patience > 0
    }
}

/// What has been done, all starts together, and what may be.
pub(crate) struct Work {
    /// Steps on each level.
    pub(crate) steps: Vec<usize>,
    /// Wavenumbers of all layouts.
    pub(crate) interpolated: usize,
    /// Systems factorised.
    pub(crate) factorisations: usize,
    /// Multiplications, about, that were made and may be made, and where the start that is tried ends.
    spent: f64,
    most: f64,
    until: f64,
}

impl Work {
    /// No more than this many multiplications, all starts together.
    pub(crate) fn at_most(most: f64) -> Self {
        Self { steps: Vec::new(), interpolated: 0, factorisations: 0, spent: 0.0, most, until: most }
    }

    pub(crate) fn step(&mut self) {
        if let Some(steps) = self.steps.last_mut() {
            *steps += 1;
        }
    }

    /// Another start: it may take a part of what is left.
    pub(crate) fn start(&mut self) {
        self.until = self.spent + SHARE * (self.most - self.spent).max(0.0);
    }

    /// The last start: it may take all that is left.
    pub(crate) fn finish(&mut self) {
        self.until = self.most;
    }

    /// Counts some more multiplications; `None` if these are too many.
    pub(crate) fn spend(&mut self, operations: f64) -> Option<()> {
        self.spent += operations;
        (self.spent <= self.until).then_some(())
    }
}
