//! The collocated equations at given half-lengths.
//!
//! Unknown are φ_k of each contact, p = P' φ √(1 − s²)/a, and a slack variable σ, which adds σ r to the slopes there: equilibrium
//! holds for any half-lengths, and the slack variables vanish at the right ones.
use std::f64::consts::PI;

use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::collocation::nodes::Nodes;
use crate::collocation::spatial::Spatial;
use crate::contact::problem::Problem;

/// Pressures at given half-lengths.
pub(super) struct Pressures {
    /// φ at the nodes, per contact.
    pub(super) phi: Vec<Vec<f64>>,
    /// σ per contact.
    pub(super) slack: Vec<f64>,
}

/// Solves for the pressures, equilibrium built in.
pub(super) fn solve(spatial: &Spatial, nodes: &Nodes, problem: &Problem, half_lengths: &[f64]) -> Pressures {
    let (n, half) = (half_lengths.len(), nodes.half());
    let block = half + 1;
    let mut matrix = Mat::<f64>::zeros(n * block, n * block);
    let mut right = Mat::<f64>::zeros(n * block, 1);
    for (i, a) in half_lengths.iter().enumerate() {
        for (j, r) in nodes.r.iter().enumerate() {
            let row = i * block + j;
            for k in 0..half {
                matrix[(row, i * block + k)] += diagonal_entry(spatial, nodes, i, *a, j, k) / PI;
            }
            for l in spatial.neighbours(i) {
                for (contact, sign) in [(l, 1.0), (i, -1.0)] {
                    for (k, s) in nodes.s.iter().enumerate() {
                        let difference = spatial.difference(i, l, a * r, half_lengths[contact] * s);
                        matrix[(row, contact * block + k)] += sign * 2.0 * a * nodes.weights[k] * difference / PI;
                    }
                }
            }
            matrix[(row, i * block + half)] = *r;
            right[(row, 0)] = a * problem.sides[i].slope(a * r);
        }
        // equilibrium
        let row = i * block + half;
        for k in 0..half {
            matrix[(row, i * block + k)] = 2.0 * nodes.weights[k];
        }
        right[(row, 0)] = 1.0;
    }
    let solution = matrix.partial_piv_lu().solve(&right);
    let part = |i: usize| (0..half).map(|k| solution[(i * block + k, 0)]).collect();
    Pressures { phi: (0..n).map(part).collect(), slack: (0..n).map(|i| solution[(i * block + half, 0)]).collect() }
}

/// The slope at r_j of contact i, over π/a, due to φ_k at ± s_k of the same contact.
fn diagonal_entry(spatial: &Spatial, nodes: &Nodes, i: usize, a: f64, j: usize, k: usize) -> f64 {
    let diagonal = &spatial.diagonals[i];
    let [[sign_plus, sign_minus], [log_plus, log_minus]] = nodes.singular(j, k);
    let weight = nodes.weights[k];
    let side = |s: f64, sign: f64, log: f64| {
        let u = nodes.r[j] - s;
        let singular =
            diagonal.jump.map_or(0.0, |jump| sign * jump.even(a * u) + (log + weight * a.ln()) * jump.odd(a * u));
        weight * diagonal.limit / u + a * (weight * diagonal.regular(a * u) + singular)
    };
    side(nodes.s[k], sign_plus, log_plus) + side(-nodes.s[k], sign_minus, log_minus)
}
