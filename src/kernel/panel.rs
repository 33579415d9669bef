//! A stretch of the wavenumber axis on which all kernels are polynomials to rounding.
use std::sync::LazyLock;

use crate::Error;
use crate::numeric::{chebyshev, quadrature};

use super::Chains;

/// Gauss points per panel.
pub(crate) const POINTS: usize = chebyshev::PANEL;
/// A panel is resolved if the last Legendre coefficients are below this, relative to the kernel's size on the panel.
const RESOLVED: f64 = 1e-13;
/// Kernels vary on the scale of the wavenumber itself: what is not resolved on a panel as narrow as this part of it, or
/// below this wavenumber, is rounding.
const NARROWEST: f64 = 1.0 / 16.0;
const LOWEST: f64 = 1e-9;
/// A coupling below this part of the kernels it couples is nothing.
const NOTHING: f64 = 1e-17;

/// Kernel values at the Gauss points of one panel.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    /// Lower end.
    pub(crate) from: f64,
    /// Upper end.
    pub(crate) to: f64,
    /// Component by component, `POINTS` values each, multiplied by the power of ζ that makes them smooth at ζ = 0.
    values: Vec<[f64; POINTS]>,
    /// Which couplings are felt on this panel.
    pub(crate) coupled: Vec<bool>,
    contacts: usize,
}

/// Long waves bend free laminates, λC ~ λ⁻³, except under equal loads, λC ~ λ⁻¹: powers of ζ that make the
/// components finite at ζ = 0.
fn powers(contacts: usize, component: usize) -> i32 {
    match component / contacts {
        _ if contacts == 1 => 0,
        1 => 1,
        _ => 3,
    }
}

/// Adds panels for [from, to], halved until every component is resolved.
pub(super) fn resolve(
    chains: &Chains,
    from: f64,
    to: f64,
    wanted: &[bool],
    panels: &mut Vec<Panel>,
    samples: &mut usize,
) -> Result<(), Error> {
    let panel = Panel::new(chains, from, to, wanted)?;
    *samples += POINTS;
    if panel.is_resolved() || to < LOWEST || to - from < NARROWEST * to {
        panels.push(panel);
        return Ok(());
    }
    let middle = 0.5 * (from + to);
    resolve(chains, from, middle, wanted, panels, samples)?;
    resolve(chains, middle, to, wanted, panels, samples)
}

impl Panel {
    fn new(chains: &Chains, from: f64, to: f64, wanted: &[bool]) -> Result<Self, Error> {
        let contacts = chains.contacts();
        let components = 3 * contacts - 1;
        let mut values = vec![[0.0; POINTS]; components];
        let mut sample = vec![0.0; components];
        for (k, x) in quadrature::rule(POINTS).nodes.iter().enumerate() {
            let zeta = 0.5 * (from + to) + 0.5 * (to - from) * x;
            chains.sample(zeta, wanted, &mut sample)?;
            for (c, value) in sample.iter().enumerate() {
                values[c][k] = value * zeta.powi(powers(contacts, c));
            }
        }
        let mut panel = Self { from, to, values, coupled: Vec::new(), contacts };
        panel.coupled = (0..contacts - 1)
            .map(|i| {
                let own = panel.size(i).min(panel.size(i + 1));
                panel.size(2 * contacts + i) > NOTHING * own
            })
            .collect();
        Ok(panel)
    }

    fn size(&self, c: usize) -> f64 {
        self.values[c].iter().fold(0.0, |size, value| size.max(value.abs()))
    }

    fn is_resolved(&self) -> bool {
        let n = self.contacts;
        (0..3 * n - 1).all(|c| {
            let size = self.size(c);
            let scale = match c / n {
                0 => size,
                // equal loads on a long wave leave what bending, ζ² larger, loses to rounding
                1 => size.max(self.size(c - n) / (1.0 + self.to * self.to)),
                // a coupling need be known only as well as what it couples
                _ => self.size(c - 2 * n).max(self.size(c - 2 * n + 1)),
            };
            size == 0.0 || chebyshev::legendre_tail(&self.values[c]) * size <= RESOLVED * scale
        })
    }

    /// All components at a wavenumber within the panel.
    pub(crate) fn interpolate(&self, zeta: f64, components: &mut [f64]) {
        static WEIGHTS: LazyLock<Vec<f64>> =
            LazyLock::new(|| chebyshev::barycentric_weights(&quadrature::rule(POINTS).nodes));
        let x = (zeta - 0.5 * (self.from + self.to)) / (0.5 * (self.to - self.from));
        let mut row = [0.0; POINTS];
        chebyshev::interpolation_row(&quadrature::rule(POINTS).nodes, &WEIGHTS, x, &mut row);
        for (c, component) in components.iter_mut().enumerate() {
            let value: f64 = self.values[c].iter().zip(row.iter()).map(|(v, r)| v * r).sum();
            *component = value / zeta.powi(powers(self.contacts, c));
        }
    }
}
