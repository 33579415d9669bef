//! Counts of what was computed, one line for each.
use std::fmt;

use crate::solution::Stats;

/// Lines with a count and what it counts.
impl fmt::Display for Stats {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:>8} layers dropped, of no thickness", self.dropped)?;
        writeln!(f, "{:>8} layers merged with an equal neighbour", self.merged)?;
        writeln!(f, "{:>8} wavenumbers evaluated", self.wavenumbers)?;
        writeln!(f, "{:>8} layers evaluated, all wavenumbers together", self.layers)?;
        writeln!(f, "{:>8} layers skipped, in sequences that repeat others", self.repeated)?;
        writeln!(f, "{:>8} layers skipped below their decay depth", self.below_decay_depth)?;
        writeln!(f, "{:>8} values of couplings that vanish", self.uncoupled)?;
        writeln!(f, "{:>8} wavenumbers interpolated, all integrals together", self.interpolated)?;
        writeln!(f, "{:>8} modes of each contact", list(&self.modes))?;
        writeln!(f, "{:>8} Newton steps on each refinement level", list(&self.newton_steps))?;
        writeln!(f, "{:>8} why each refinement level ended", list(&self.stopped))?;
        writeln!(f, "{:>8} factorisations", self.factorisations)
    }
}

/// Counts separated by spaces.
fn list(counts: &[impl fmt::Display]) -> String {
    counts.iter().map(|count| count.to_string()).collect::<Vec<_>>().join(" ")
}
