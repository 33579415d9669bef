//! Rows of polynomials that begin inside an interval: of the slopes 1, y and y² at y = s − b > 0, and of none before.
use num_complex::Complex64;

use crate::contact::problem::modes::alternating;
use crate::solution::jacobi_weights;

/// In the plane with b = cos θ_b: ∫ (cos θ − b)^n cos kθ dθ from 0 to θ_b is a sum of sin(jθ_b)/j with j from k − n to k + n. From one row to the
/// next k grows by `step`, with 2 from k = 1 on.
pub(super) fn plane(b: f64, step: usize, count: usize) -> Vec<[f64; 3]> {
    let turn = Complex64::new(b, ((1.0 - b) * (1.0 + b)).max(0.0).sqrt());
    let mut wave = Complex64::ONE;
    let mut sines = vec![turn.arg()];
    for j in 1..step * count + 3 {
        wave *= turn;
        sines.push(wave.im / j as f64);
    }
    let row = |m: usize| {
        let (k, times) = if step == 2 { (2 * m + 1, 2.0 * alternating(m)) } else { (m, 1.0) };
        let (own, next) = (sines[k], sines[k.abs_diff(1)] + sines[k + 1]);
        let linear = 0.5 * next - b * own;
        let square = 0.5 * own + 0.25 * (sines[k.abs_diff(2)] + sines[k + 2]) - b * next + b * b * own;
        [own, linear, square].map(|value| times * value)
    };
    (0..count).map(row).collect()
}

/// About an axis, twice as in the plane: ∫ g(r) G_k(r) dr from b to 1, with g = (r f')' and G_k(r) = ∫ P_k(t)/√(t² − r²) dt from r to 1 of odd k = 2m + 1. It is
/// G_k(r) = (−1)^m w_m P_k(√(1 − r²)) with the weights of Jacobi polynomials, a half-order integral of P_k(t)/t. The moments of G_k follow from
/// it by integration by parts and the recurrences of Legendre polynomials.
pub(super) fn round(b: f64, count: usize) -> Vec<[f64; 3]> {
    let height = ((1.0 - b) * (1.0 + b)).sqrt();
    // P_k at the height, with k = 2m − 1 and 2m
    let (mut odd, mut even) = (0.0, 1.0);
    // b ∫ P_k(t)/(t √(t² − b²)) dt of even k
    let mut inverse = b.acos();
    // G_k and its moment with 1, of k = −1, and then of 1, 3, 5, ...
    let mut values = vec![[0.0; 2]];
    for (m, weight) in jacobi_weights().take(count + 1).enumerate() {
        let k = (2 * m) as f64;
        odd = ((2.0 * k + 1.0) * height * even - k * odd) / (k + 1.0);
        even = ((2.0 * k + 3.0) * height * odd - (k + 1.0) * even) / (k + 2.0);
        let value = alternating(m) * weight * odd;
        let next = ((2.0 * k + 3.0) * b * value - (k + 1.0) * inverse) / (k + 2.0);
        values.push([value, (inverse - next) / (2.0 * k + 3.0)]);
        inverse = next;
    }
    let row = |m: usize| {
        let k = (2 * m + 1) as f64;
        // t² P_k as a sum of P_(k+2), P_k and P_(k−2)
        let up = (k + 1.0) * (k + 2.0) / ((2.0 * k + 1.0) * (2.0 * k + 3.0));
        let down = k * (k - 1.0) / ((2.0 * k + 1.0) * (2.0 * k - 1.0));
        let stay =
            (k + 1.0).powi(2) / ((2.0 * k + 1.0) * (2.0 * k + 3.0)) + k * k / ((2.0 * k + 1.0) * (2.0 * k - 1.0));
        let squared = |n: usize| up * values[m + 2][n] + stay * values[m + 1][n] + down * values[m][n];
        // ∫ G, ∫ r G and ∫ r² G
        let [value, plain] = values[m + 1];
        let first = squared(0) - b * b * value;
        let second = 0.5 * (squared(1) + b * first);
        [b * value + plain, 2.0 * first - b * plain, 3.0 * second - 4.0 * b * first + b * b * plain]
            .map(|value| 2.0 * alternating(m) * value)
    };
    (0..count).map(row).collect()
}
