//! Nodes of the pressure and collocation points of the slope, on the half of the contact with x > 0, and the quadrature between.
//!
//! The pressure is p = φ √(1 − s²)/a. With s_k = cos kπ/(N + 1) and r_j = cos (2j − 1)π/(2N + 2), Gauss's rule
//!
//! ∫ φ √(1 − s²) F(s) ds = Σ_k w_k φ_k F(s_k),   w_k = π/(N + 1) (1 − s_k²)
//!
//! holds for smooth F and, at x = r_j, for F = 1/(r_j − s) as well (F. Erdogan, G. D. Gupta, 1972). For F times
//! sign(r_j − s) or ln|r_j − s| there are weights of their own, from the sine series of φ √(1 − s²).
use std::f64::consts::{LN_2, PI};

use faer::Mat;

/// Nodes for one number of nodes N, even.
pub(super) struct Nodes {
    /// s_k > 0, k = 1 ..= N/2.
    pub(super) s: Vec<f64>,
    /// w_k.
    pub(super) weights: Vec<f64>,
    /// r_j > 0, j = 1 ..= N/2.
    pub(super) r: Vec<f64>,
    /// Weights for sign and logarithm, row j, columns k = 1 ..= N.
    singular: Option<[Mat<f64>; 2]>,
    count: usize,
}

impl Nodes {
    /// `count` nodes, with weights for singular kernels if they are `singular`.
    pub(super) fn new(count: usize, singular: bool) -> Self {
        let half = count / 2;
        let step = PI / (count + 1) as f64;
        let s: Vec<f64> = (1..=half).map(|k| (step * k as f64).cos()).collect();
        let weights = (1..=half).map(|k| step * (step * k as f64).sin().powi(2)).collect();
        let r = (1..=half).map(|j| (step * (j as f64 - 0.5)).cos()).collect();
        let singular = singular.then(|| singular_weights(count));
        Self { s, weights, r, singular, count }
    }

    /// Number of nodes with s > 0, and of places with x > 0.
    pub(super) fn half(&self) -> usize {
        self.count / 2
    }

    /// Weights of sign(r_j − s) and ln|r_j − s| at ± s_k; zero if they were not requested.
    pub(super) fn singular(&self, j: usize, k: usize) -> [[f64; 2]; 2] {
        let Some(weights) = &self.singular else { return [[0.0; 2]; 2] };
        [0, 1].map(|kind| [weights[kind][(j, k)], weights[kind][(j, self.count - 1 - k)]])
    }
}

/// Weights of sign(r_j − s) and ln|r_j − s|.
fn singular_weights(count: usize) -> [Mat<f64>; 2] {
    let half = count / 2;
    let step = PI / (count + 1) as f64;
    let turns = 4 * (count + 1);
    let sines: Vec<f64> = (0..turns).map(|k| (0.5 * step * k as f64).sin()).collect();
    // φ √(1 − s²) = Σ_m c_m sin mθ, c_m = Σ_k analysis[m, k] φ_k
    let analysis = Mat::from_fn(count, count, |m, k| {
        let (m, k) = (m + 1, k + 1);
        2.0 / (count + 1) as f64 * sines[2 * m * k % turns] * sines[2 * k]
    });
    [sign_moment as fn(&[f64], usize, usize) -> f64, logarithm_moment].map(|moment| {
        let moments = Mat::from_fn(half, count, |j, m| moment(&sines, m + 1, 2 * j + 1));
        moments * &analysis
    })
}

/// ∫ sign(r − s) sin mθ ds, r = cos ψ, with ψ in half steps.
fn sign_moment(sines: &[f64], m: usize, psi: usize) -> f64 {
    let sine = |m: usize| sines[m * psi % sines.len()] / m as f64;
    if m == 1 {
        return 0.5 * PI - (PI * 2.0 * psi as f64 / sines.len() as f64 - sine(2));
    }
    sine(m + 1) - sine(m - 1)
}

/// ∫ ln|r − s| sin mθ ds likewise, from ∫ ln|cos ψ − cos θ| cos nθ dθ = −π cos nψ/n, −π ln 2 for n = 0.
fn logarithm_moment(sines: &[f64], m: usize, psi: usize) -> f64 {
    let quarter = sines.len() / 4;
    let part = |n: usize| match n {
        0 => -PI * LN_2,
        _ => -PI * sines[(n * psi + quarter) % sines.len()] / n as f64,
    };
    0.5 * (part(m - 1) - part(m + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ of a pressure with φ = 1 + s times sign or logarithm, for r = 0: known in closed form.
    #[test]
    fn weights_integrate_jumps_and_logarithms() {
        let nodes = Nodes::new(12, true);
        for (j, r) in nodes.r.iter().enumerate() {
            let (mut sign, mut log) = (0.0, 0.0);
            for (k, s) in nodes.s.iter().enumerate() {
                let [[sign_plus, sign_minus], [log_plus, log_minus]] = nodes.singular(j, k);
                sign += sign_plus * (1.0 + s) + sign_minus * (1.0 - s);
                log += log_plus * (1.0 + s) + log_minus * (1.0 - s);
            }
            let root = (1.0 - r * r).sqrt();
            // ∫ √(1 − s²) sign(r − s) ds = arcsin r + r root; ∫ s √(1 − s²) sign(r − s) ds = −⅔ root³
            let expected = r.asin() + r * root - 2.0 / 3.0 * root.powi(3);
            assert!((sign - expected).abs() < 1e-14, "{sign} is not {expected}");
            // U_0 and U_1: ½ [L_0 − L_2] and ¼ [L_1 − L_3]
            let psi = r.acos();
            let expected =
                -0.5 * PI * (LN_2 - (2.0 * psi).cos() / 2.0) - 0.25 * PI * (psi.cos() - (3.0 * psi).cos() / 3.0);
            assert!((log - expected).abs() < 1e-14, "{log} is not {expected}");
        }
    }
}
