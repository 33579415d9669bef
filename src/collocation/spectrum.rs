//! One kernel as a function of the wavenumber, sampled afresh: panels, and a polynomial in 1/ζ for large wavenumbers.
//!
//! It shares only the flexibilities at single wavenumbers with [`crate::kernel`].
use std::f64::consts::PI;

use num_complex::Complex64;

use crate::kernel::Kernel;
use crate::numeric::chebyshev::Series;
use crate::numeric::quadrature::{laguerre_rule, rule};
use crate::system::Unresolved;

/// Points of a panel, and of the polynomial for large wavenumbers.
const POINTS: usize = 17;
/// A panel is resolved if its last coefficients are below this part of its largest.
const RESOLVED: f64 = 1e-13;
/// The polynomial for large wavenumbers likewise.
const ASYMPTOTE_RESOLVED: f64 = 1e-14;
/// A coupling below this counts as zero.
const NEGLIGIBLE: f64 = 1e-18;
/// Most panels, each twice as wide as the one before; none is cut narrower than this part of its end.
const DOUBLINGS: u32 = 60;
const NARROWEST: f64 = 1.0 / 16.0;
/// Below this wavenumber kernels are powers.
const LOWEST: f64 = 1e-9;
/// A path into the complex plane starts at this phase, at a distance from the pole at the origin.
const TURNED: f64 = 24.0;

/// A component of the kernel times a power of ζ, on panels from zero to the wavenumber from which on its asymptote holds.
pub(super) struct Spectrum {
    panels: Vec<Series>,
}

impl Spectrum {
    /// The coupling of contacts i and i + 1, times ζ³.
    pub(super) fn coupling(kernel: &Kernel, i: usize) -> Result<Self, Unresolved> {
        let coupling = |zeta: f64| kernel.flexibilities(zeta).map_or(f64::NAN, |(c, _)| c[i].coupling);
        let mut spectrum = Self { panels: Vec::new() };
        let mut edge = 0.0;
        for doubling in 0..DOUBLINGS {
            let next = f64::from(2u32).powi(doubling as i32);
            spectrum.resolve(kernel, edge, next, &|zeta| coupling(zeta) * zeta.powi(3))?;
            edge = next;
            if coupling(edge).abs() < NEGLIGIBLE {
                return Ok(spectrum);
            }
        }
        Err(unresolved(kernel, edge))
    }

    /// The equal-pressure response of contact i, times ζ, and its asymptote beyond the panels.
    pub(super) fn equal_pressure(kernel: &Kernel, i: usize) -> Result<(Self, Asymptote), Unresolved> {
        let response = |zeta: f64| {
            kernel.flexibilities(zeta).map_or(f64::NAN, |(laminates, base)| {
                let below = laminates.get(i).map_or(base, |laminate| laminate.equal_top);
                below - i.checked_sub(1).map_or(-kernel.punch, |above| laminates[above].equal_bottom)
            })
        };
        let mut spectrum = Self { panels: Vec::new() };
        let mut edge = 0.0;
        for doubling in 0..DOUBLINGS {
            let next = f64::from(2u32).powi(doubling as i32);
            spectrum.resolve(kernel, edge, next, &|zeta| response(zeta) * zeta)?;
            edge = next;
            if let Some(asymptote) = Asymptote::fit(edge, response) {
                return Ok((spectrum, asymptote));
            }
        }
        Err(unresolved(kernel, edge))
    }

    fn resolve(
        &mut self,
        kernel: &Kernel,
        from: f64,
        to: f64,
        function: &dyn Fn(f64) -> f64,
    ) -> Result<(), Unresolved> {
        let panel = Series::of(from, to, POINTS, |zeta| function(zeta.max(LOWEST)));
        if panel.coefficients().iter().any(|c| !c.is_finite()) {
            return Err(unresolved(kernel, to));
        }
        if panel.tail() <= RESOLVED || to < LOWEST || to - from < NARROWEST * to {
            self.panels.push(panel);
            return Ok(());
        }
        let middle = 0.5 * (from + to);
        self.resolve(kernel, from, middle, function)?;
        self.resolve(kernel, middle, to, function)
    }

    /// Nodes, weights and values for integrals over all panels against waves of a frequency up to `frequency`.
    pub(super) fn nodes(&self, frequency: f64) -> Vec<(f64, f64, f64)> {
        let mut nodes = Vec::new();
        for panel in &self.panels {
            let (from, to) = panel.interval();
            nodes.extend(wave_nodes(from, to, frequency).map(|(zeta, weight)| (zeta, weight, panel.eval(zeta))));
        }
        nodes
    }
}

/// Gauss nodes on [from, to] that resolve a wave: more than two points per wavelength.
fn wave_nodes(from: f64, to: f64, frequency: f64) -> impl Iterator<Item = (f64, f64)> {
    const MOST: usize = 512;
    let phase = frequency * (to - from);
    let needed = (POINTS as f64 + 0.25 * phase + 3.0 * (0.5 * phase).cbrt()).ceil() as usize;
    let parts = needed.div_ceil(MOST);
    let at = move |k: usize| from + (to - from) * k as f64 / parts as f64;
    (0..parts).flat_map(move |part| rule(needed.div_ceil(parts)).on(at(part), at(part + 1)))
}

fn unresolved(kernel: &Kernel, zeta: f64) -> Unresolved {
    Unresolved { wavenumber: zeta / kernel.length() }
}

/// The short-wave asymptote of a kernel, ζ ≥ `from`: a limit, which makes the Cauchy kernel, and next to a graded face
/// the remainder Σ c_k/ζ^k.
pub(super) struct Asymptote {
    from: f64,
    /// g∞.
    pub(super) limit: f64,
    remainder: Option<Series>,
}

impl Asymptote {
    /// The polynomial in v = from/ζ, if there is one.
    fn fit(from: f64, function: impl Fn(f64) -> f64) -> Option<Self> {
        // v = 0 stands for a wavenumber so large that the kernel depends on the material at the faces only
        let mut series = Series::of(0.0, 1.0, POINTS, |v| function(from / v.max(1e-25)));
        let limit = series.eval(0.0);
        // NaN is not resolved
        let resolved = series.tail() <= ASYMPTOTE_RESOLVED;
        if !resolved {
            return None;
        }
        let coefficients = series.coefficients();
        let varies = coefficients[1..].iter().map(|c| c.abs()).sum::<f64>();
        if varies <= 10.0 * ASYMPTOTE_RESOLVED * limit.abs() {
            return Some(Self { from, limit, remainder: None });
        }
        series.truncate(ASYMPTOTE_RESOLVED * 1e-2);
        Some(Self { from, limit, remainder: Some(series) })
    }

    /// c_1, ..., c_4 of the remainder Σ c_k/ζ^k; all zero next to homogeneous material.
    pub(super) fn powers(&self) -> [f64; 4] {
        let Some(series) = &self.remainder else { return [0.0; 4] };
        // T_n(2v − 1) up to v⁴
        let (mut before, mut here) = ([0.0; 5], [1.0, 0.0, 0.0, 0.0, 0.0]);
        let mut sum = [0.0; 5];
        for (n, c) in series.coefficients().iter().enumerate() {
            for (sum, power) in sum.iter_mut().zip(here) {
                *sum += c * power;
            }
            let factor = if n == 0 { 1.0 } else { 2.0 };
            let mut next = [0.0; 5];
            for k in 0..5 {
                let shifted = if k > 0 { here[k - 1] } else { 0.0 };
                next[k] = factor * (2.0 * shifted - here[k]) - before[k];
            }
            (before, here) = (here, next);
        }
        std::array::from_fn(|k| sum[k + 1] * self.from.powi(k as i32 + 1))
    }

    /// ∫ (g − g∞) sin ζu dζ over ζ > `from`: along the real axis until the phase is large, then straight into the upper
    /// half of the complex plane.
    pub(super) fn integral(&self, u: f64) -> f64 {
        let Some(series) = &self.remainder else { return 0.0 };
        let remainder = |zeta: f64| series.eval(self.from / zeta) - self.limit;
        let turn = (TURNED / u).max(4.0 * self.from);
        let mut sum = 0.0;
        let mut edge = self.from;
        while edge < turn {
            let next = (2.0 * edge).min(turn);
            sum += wave_nodes(edge, next, u).map(|(zeta, w)| w * remainder(zeta) * (zeta * u).sin()).sum::<f64>();
            edge = next;
        }
        let laguerre = laguerre_rule(32);
        let path = laguerre.nodes.iter().zip(&laguerre.weights);
        let beyond: Complex64 =
            path.map(|(s, w)| w * (series.eval_complex(self.from / Complex64::new(turn, s / u)) - self.limit)).sum();
        // the phase is folded before it is multiplied
        sum + (Complex64::cis((turn * u) % (2.0 * PI)) * beyond).re / u
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_and_integral_of_a_known_remainder() {
        // 2 + ζ/(ζ² + 1): the integral over all ζ > 0 of ζ/(ζ² + 1) sin ζu is (π/2) e^(−u)
        let asymptote = Asymptote::fit(16.0, |zeta| 2.0 + zeta / (zeta * zeta + 1.0)).unwrap();
        assert!((asymptote.limit - 2.0).abs() < 1e-15);
        for (found, expected) in asymptote.powers().into_iter().zip([1.0, 0.0, -1.0, 0.0]) {
            assert!((found - expected).abs() < 1e-4, "{found} is not {expected}");
        }
        for u in [1e-6, 1e-3, 0.1, 1.0, 3.0, 20.0] {
            let near: f64 = wave_nodes(0.0, 2.0, u)
                .chain(wave_nodes(2.0, 16.0, u))
                .map(|(zeta, w)| w * zeta / (zeta * zeta + 1.0) * (zeta * u).sin())
                .sum();
            let error = near + asymptote.integral(u) - 0.5 * PI * f64::exp(-u);
            // it is added to the Cauchy kernel 2/u
            assert!(error.abs() < 1e-13 + 1e-15 / u, "{u}: {error:e}");
        }
    }
}
