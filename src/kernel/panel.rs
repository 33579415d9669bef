//! A stretch of the wavenumber axis on which all kernels are polynomials to rounding.
use std::sync::LazyLock;

use crate::Error;
use crate::numeric::{chebyshev, quadrature};

use super::{Chains, Work};

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
    work: &mut Work,
) -> Result<(), Error> {
    let panel = Panel::new(chains, from, to, wanted, work)?;
    if panel.is_resolved() || to < LOWEST || to - from < NARROWEST * to {
        panels.push(panel);
        return Ok(());
    }
    let middle = 0.5 * (from + to);
    resolve(chains, from, middle, wanted, panels, work)?;
    resolve(chains, middle, to, wanted, panels, work)
}

impl Panel {
    fn new(chains: &Chains, from: f64, to: f64, wanted: &[bool], work: &mut Work) -> Result<Self, Error> {
        let contacts = chains.contacts();
        let components = 3 * contacts - 1;
        let mut values = vec![[0.0; POINTS]; components];
        let mut sample = vec![0.0; components];
        for (k, x) in quadrature::rule(POINTS).nodes.iter().enumerate() {
            let zeta = 0.5 * (from + to) + 0.5 * (to - from) * x;
            chains.sample(zeta, wanted, &mut sample, work)?;
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

    /// Adds a flexibility that is the same for all wavenumbers to contact 0.
    pub(super) fn add_to_first(&mut self, flexibility: f64) {
        for component in [0, self.contacts] {
            let power = powers(self.contacts, component);
            for ((zeta, _), value) in quadrature::rule(POINTS).on(self.from, self.to).zip(&mut self.values[component]) {
                *value += flexibility * zeta.powi(power);
            }
        }
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

    /// The largest value of a component less `limit`, on the Gauss points.
    fn largest(&self, component: usize, limit: f64) -> f64 {
        let power = powers(self.contacts, component);
        let nodes = quadrature::rule(POINTS).on(self.from, self.to);
        let values = nodes.zip(&self.values[component]).map(|((zeta, _), value)| value / zeta.powi(power) - limit);
        values.fold(0.0, |largest, value| largest.max(value.abs()))
    }

    /// The largest wavenumber at which the kernel of contact `i` differs from `limit` by more than `little`.
    pub(super) fn last_above(&self, i: usize, limit: f64, little: f64) -> Option<f64> {
        let power = powers(self.contacts, i);
        let nodes: Vec<f64> = quadrature::rule(POINTS).on(self.from, self.to).map(|(zeta, _)| zeta).collect();
        let above = |(zeta, value): &(&f64, &f64)| (*value / zeta.powi(power) - limit).abs() > little;
        nodes.iter().zip(&self.values[i]).rev().find(above).map(|(zeta, _)| *zeta)
    }

    /// The largest excess of the kernel of contact `i` under equal neighbouring pressures over `limit`.
    pub(super) fn largest_excess(&self, i: usize, limit: f64) -> f64 {
        self.largest(self.contacts + i, limit)
    }

    /// The largest coupling of the contacts `i` and `i + 1`.
    pub(super) fn largest_coupling(&self, i: usize) -> f64 {
        if self.coupled[i] { self.largest(2 * self.contacts + i, 0.0) } else { 0.0 }
    }

    /// What the contact equations need at the wavenumbers `zeta`, the points of a Gauss rule on [from, to], which is
    /// the panel or a part of it.
    pub(crate) fn values(&self, zeta: &[f64], from: f64, to: f64) -> Values {
        static WEIGHTS: LazyLock<Vec<f64>> =
            LazyLock::new(|| chebyshev::barycentric_weights(&quadrature::rule(POINTS).nodes));
        let mut rows = Vec::new();
        let rows: &[f64] = if from == self.from && to == self.to {
            chebyshev::panel_matrix(zeta.len())
        } else {
            rows.resize(zeta.len() * POINTS, 0.0);
            for (zeta, row) in zeta.iter().zip(rows.chunks_exact_mut(POINTS)) {
                let x = (zeta - 0.5 * (self.from + self.to)) / (0.5 * (self.to - self.from));
                chebyshev::interpolation_row(&quadrature::rule(POINTS).nodes, &WEIGHTS, x, row);
            }
            &rows
        };
        let n = self.contacts;
        let mut values =
            Values { count: zeta.len(), contacts: n, values: Vec::with_capacity(zeta.len() * (2 * n - 1)) };
        for component in n..3 * n - 1 {
            if component >= 2 * n && !self.coupled[component - 2 * n] {
                values.values.resize(values.values.len() + zeta.len(), 0.0);
                continue;
            }
            let power = powers(n, component);
            let own = &self.values[component];
            values.values.extend(rows.chunks_exact(POINTS).zip(zeta).map(|(row, zeta)| {
                let value: f64 = row.iter().zip(own).map(|(r, v)| r * v).sum();
                value / zeta.powi(power)
            }));
        }
        values
    }
}

/// The components of a panel at several wavenumbers.
pub(crate) struct Values {
    count: usize,
    contacts: usize,
    values: Vec<f64>,
}

impl Values {
    /// The kernel of contact `i` under equal neighbouring pressures at wavenumber number `k`.
    pub(crate) fn unit(&self, i: usize, k: usize) -> f64 {
        self.values[i * self.count + k]
    }

    /// The coupling of the contacts `i` and `i + 1` at wavenumber number `k`.
    pub(crate) fn coupling(&self, i: usize, k: usize) -> f64 {
        self.values[(self.contacts + i) * self.count + k]
    }
}
