//! Kernels cut off beyond a wavenumber, for contacts whose modes do not resolve their shortest waves.
//!
//! Next to a face layer much thinner than the contact is long, the kernel belongs to the bodies behind the layer up to
//! waves about as short as the layer is thick, and to the layer beyond.
use crate::numeric::quadrature::rule;

use super::{Asymptote, Kernel};

/// Gauss points in an octave of wavenumbers, and on all wavenumbers beyond the panels: enough for an estimate.
const POINTS: usize = 8;

impl Kernel {
    /// The equal-pressure response of contact i at one wavenumber.
    fn equal_pressure(&self, contact: usize, zeta: f64) -> f64 {
        self.asymptotes[contact].limit + self.remainder(contact, zeta)
    }

    /// ∫ |g/g(Z) − 1| dζ/ζ² beyond a wavenumber Z, of the kernel g of contact i: times 2/(πa) it is the relative change of the
    /// diagonal of the equations if the kernel is held constant beyond Z.
    pub(crate) fn left_out(&self, contact: usize, from: f64) -> f64 {
        let kept = self.equal_pressure(contact, from);
        let change = |zeta: f64| (self.equal_pressure(contact, zeta) / kept - 1.0).abs() / (zeta * zeta);
        let end = self.asymptotes[contact].from;
        let octaves = std::iter::successors(Some(from), |edge| Some(2.0 * edge)).take_while(|edge| *edge < end);
        let inside = octaves.flat_map(|edge| rule(POINTS).on(edge, (2.0 * edge).min(end)));
        let inside: f64 = inside.map(|(zeta, weight)| weight * change(zeta)).sum();
        // ζ = last/u
        let last = from.max(end);
        let beyond = rule(POINTS).on(0.0, 1.0).map(|(u, weight)| weight * last / (u * u) * change(last / u));
        inside + beyond.sum::<f64>()
    }

    /// The kernel of contact i held constant beyond a wavenumber.
    pub(crate) fn cut_off(&self, contact: usize, from: f64) -> Self {
        let mut kernel = self.clone();
        kernel.asymptotes[contact] = Asymptote::constant(from, self.equal_pressure(contact, from));
        let cut = kernel.panels.partition_point(|panel| panel.to <= from);
        if let Some(panel) = kernel.panels.get(cut).filter(|panel| panel.from < from) {
            let parts = [panel.part(panel.from, from), panel.part(from, panel.to)];
            kernel.panels.splice(cut..=cut, parts);
        }
        let asymptotes = &kernel.asymptotes;
        kernel.panels.iter_mut().for_each(|panel| panel.measure(asymptotes));
        kernel
    }
}
