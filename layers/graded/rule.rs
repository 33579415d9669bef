//! Gauss points, and what is needed to integrate and to judge a function on them.
use std::sync::LazyLock;

use nalgebra::{RowSVector, SMatrix};

/// Gauss points per slice: collocation on them is exact to order 2·10 at the end of a slice.
pub(super) const NODES: usize = 10;
/// Next to the ends of [0, 1]: the ends proper may belong to the neighbours.
pub(super) const ENDS: [f64; 2] = [1e-13, 1.0 - 1e-13];

/// Gauss points t on [0, 1] with what is needed to integrate on them.
pub(super) struct Rule {
    pub nodes: [f64; NODES],
    pub weights: RowSVector<f64, NODES>,
    /// Row i: ∫ from 0 to t_i of the interpolating polynomial.
    pub integral: SMatrix<f64, NODES, NODES>,
    /// The two highest Legendre coefficients of the interpolating polynomial.
    pub highest: SMatrix<f64, 2, NODES>,
    /// Values of the interpolating polynomial at [`ENDS`].
    pub ends: SMatrix<f64, 2, NODES>,
}

pub(super) static RULE: LazyLock<Rule> = LazyLock::new(Rule::new);

impl Rule {
    fn new() -> Self {
        let mut nodes = [0.0; NODES];
        let mut weights = RowSVector::zeros();
        let mut tables = [[0.0; NODES + 1]; NODES];
        for i in 0..NODES {
            let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
            let slope = |x: f64, p: &[f64]| NODES as f64 * (p[NODES - 1] - x * p[NODES]) / (1.0 - x * x);
            for _ in 0..8 {
                let p = legendre(x);
                x -= p[NODES] / slope(x, &p);
            }
            tables[i] = legendre(x);
            nodes[i] = 0.5 * (1.0 + x);
            weights[i] = 1.0 / ((1.0 - x * x) * slope(x, &tables[i]).powi(2));
        }
        // coefficient k of the polynomial through f: (2k + 1) Σ w f P_k, with Σ w = 1
        let coefficient = |k: usize, j: usize| (2 * k + 1) as f64 * weights[j] * tables[j][k];
        let integral = SMatrix::from_fn(|i, j| {
            let constant = weights[j] * nodes[i];
            let p = &tables[i];
            // ∫ P_k dt from 0 = (P_(k+1) − P_(k−1))/(2 (2k + 1))
            (1..NODES).map(|k| coefficient(k, j) * (p[k + 1] - p[k - 1]) / (4 * k + 2) as f64).sum::<f64>() + constant
        });
        let highest = SMatrix::from_fn(|i, j| coefficient(NODES - 2 + i, j));
        let ends = SMatrix::from_fn(|i, j| {
            let p = legendre(2.0 * ENDS[i] - 1.0);
            (0..NODES).map(|k| coefficient(k, j) * p[k]).sum()
        });
        Self { nodes, weights, integral, highest, ends }
    }
}

/// P_0 … P_NODES at x.
fn legendre(x: f64) -> [f64; NODES + 1] {
    let mut p = [1.0; NODES + 1];
    p[1] = x;
    for k in 1..NODES {
        p[k + 1] = ((2 * k + 1) as f64 * x * p[k] - k as f64 * p[k - 1]) / (k + 1) as f64;
    }
    p
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::*;

    #[test]
    fn the_rule_integrates_polynomials_of_its_degree() {
        for k in 0..NODES as i32 {
            let powers = SVector::<f64, NODES>::from_fn(|i, _| RULE.nodes[i].powi(k));
            let integrals = RULE.integral * powers;
            for (t, integral) in RULE.nodes.iter().zip(integrals.iter()) {
                assert!((integral - t.powi(k + 1) / f64::from(k + 1)).abs() < 1e-15, "degree {k} to {t}");
            }
            assert!(((RULE.weights * powers)[0] - 1.0 / f64::from(k + 1)).abs() < 1e-15, "degree {k}");
        }
    }
}
