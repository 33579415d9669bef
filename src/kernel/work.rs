//! Counts of what was evaluated for a stack, and of what could be skipped.
use crate::system::Taken;

/// How much was evaluated for a stack.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Evaluations {
    /// Number of wavenumbers.
    pub(crate) wavenumbers: usize,
    /// Layers evaluated, summed over the wavenumbers.
    pub(crate) layers: usize,
    /// Layers skipped because their sequence repeats another, summed likewise.
    pub(crate) repeated: usize,
    /// Layers skipped because the wave has decayed above them, summed likewise.
    pub(crate) below_decay_depth: usize,
}

impl Evaluations {
    /// Counts the layers of one chain at one wavenumber, of `layers` in all.
    pub(super) fn add(&mut self, taken: Taken, layers: usize) {
        self.layers += taken.evaluated;
        self.repeated += taken.cut_off - taken.evaluated;
        self.below_decay_depth += layers - taken.cut_off;
    }

    /// The counts of two evaluations together.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            wavenumbers: self.wavenumbers + other.wavenumbers,
            layers: self.layers + other.layers,
            repeated: self.repeated + other.repeated,
            below_decay_depth: self.below_decay_depth + other.below_decay_depth,
        }
    }
}
