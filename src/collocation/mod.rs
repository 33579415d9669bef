//! A check of a solution by a second, independent discretisation of the contact equations: at the half-lengths that were found, pressures at nodes
//! make slopes at collocation points between them, with kernels as functions of the distance.
//!
//! It shares with the Galerkin solver the flexibilities at single wavenumbers, and the problem.
mod equations;
mod nodes;
mod spatial;
mod spectrum;

use std::f64::consts::PI;

use crate::contact::{Asked, ContactError};
use crate::solution::{Contact, Interface, Solution};

use equations::Pressures;
use nodes::Nodes;
use spatial::Spatial;

/// Numbers of nodes: the first, doubled until residuals change by less than the tolerance, and the last.
const COARSEST: usize = 16;
const FINEST: usize = 512;

/// What collocation says of one contact of a solution.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Collocated {
    /// The contact.
    pub interface: Interface,
    /// What is left in its equations where its pressure has the right resultant: a slope that grows from 0 in the middle to this at the end, over
    /// the slope there on a half-plane under an elliptic pressure of the same resultant. Dimensionless; 0 at the right half-lengths.
    pub residual: f64,
    /// The largest difference between the pressures at the nodes by both discretisations, over the largest pressure there; dimensionless.
    pub pressure_difference: f64,
    /// Number of nodes.
    pub nodes: usize,
}

/// Solves the collocated equations at the half-lengths of a solution.
///
/// # Errors
/// [`ContactError`] if collocation does not know contacts of this kind, or if the fields of a layer cannot be computed.
pub(crate) fn check(asked: &Asked, solution: &Solution) -> Result<Vec<Collocated>, ContactError> {
    let kernel = &*asked.kernel_under(solution.force());
    let problem = asked.problem(kernel, solution.force());
    let half_length = |contact: &Contact| contact.half_length().map(|a| a / kernel.length());
    let half_lengths: Option<Vec<f64>> = solution.contacts().iter().map(half_length).collect();
    let is_smooth = problem.sides.iter().all(|side| side.given().is_none() && !side.is_flat());
    let is_known = is_smooth && problem.is_even() && !kernel.geometry().is_axisymmetric();
    let half_lengths = half_lengths.filter(|_| is_known).ok_or(ContactError::NotCollocated)?;
    let mut spatial = Spatial::new(kernel)?;
    spatial.cover(2.0 * half_lengths.iter().copied().fold(0.0, f64::max));
    let singular = spatial.diagonals.iter().any(|diagonal| diagonal.jump.is_some());
    let unit = kernel.modulus() * problem.force;
    let mut count = COARSEST;
    let mut before: Vec<Collocated> = Vec::new();
    loop {
        let nodes = Nodes::new(count, singular);
        let Pressures { phi, slack } = equations::solve(&spatial, &nodes, &problem, &half_lengths);
        let of = |(i, contact): (usize, &Contact)| {
            let (mut largest, mut off) = (0.0f64, 0.0f64);
            for (phi, s) in phi[i].iter().zip(&nodes.s) {
                let (a, root) = (half_lengths[i], ((1.0 - s) * (1.0 + s)).sqrt());
                let expected = contact.pressure(s * a * kernel.length());
                (largest, off) = (largest.max(expected), off.max((phi * root / a * unit - expected).abs()));
            }
            Collocated {
                interface: contact.interface,
                residual: slack[i] * 0.5 * PI / spatial.diagonals[i].limit,
                pressure_difference: off / largest,
                nodes: count,
            }
        };
        let found: Vec<Collocated> = solution.contacts().iter().enumerate().map(of).collect();
        // of a difference one digit is enough
        let same = |(new, old): (&Collocated, &Collocated)| {
            let [off, before] = [new, old].map(|found| found.pressure_difference);
            (new.residual - old.residual).abs() <= asked.tolerance
                && (off - before).abs() <= asked.tolerance.max(0.5 * off)
        };
        if !before.is_empty() && found.iter().zip(&before).all(same) || count >= FINEST {
            return Ok(found);
        }
        (before, count) = (found, 2 * count);
    }
}
