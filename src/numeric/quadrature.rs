//! Gauss rules, computed once per process.

use std::f64::consts::PI;
use std::sync::OnceLock;

/// Nodes (ascending) and positive weights of a quadrature rule.
#[derive(Debug, Clone, PartialEq)]
pub struct Rule {
    /// Where the integrand is evaluated.
    pub nodes: Vec<f64>,
    /// What each value counts.
    pub weights: Vec<f64>,
}

impl Rule {
    /// The rule for the interval [-1, 1] moved to [lo, hi]: pairs of node and weight.
    ///
    /// ```
    /// let area: f64 = recede::numeric::quadrature::rule(8).on(0.0, 3.0).map(|(x, w)| w * x * x).sum();
    /// assert!((area - 9.0).abs() < 1e-14);
    /// ```
    pub fn on(&self, lo: f64, hi: f64) -> impl Iterator<Item = (f64, f64)> {
        let (centre, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        self.nodes.iter().zip(&self.weights).map(move |(x, w)| (centre + half * x, half * w))
    }
}

/// The sizes of the Gauss-Legendre rules that are kept.
pub const SIZES: [usize; 18] = [8, 12, 16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 192, 256, 384, 512, 768, 1024];

/// Points of the largest rule that integrals over long intervals are asked for, before these are cut in two. Twice as many: rules
/// take longer to be made than they save.
pub(crate) const LARGEST: usize = 512;

/// Gauss points for a wave of this phase times a kernel of which `digits` decimal digits matter.
pub(crate) fn points(phase: f64, digits: f64) -> usize {
    // two points per wavelength, points for the turning points, and what kernel and wave take besides
    let turning = (0.5 * phase).cbrt();
    let spare = (9.5 + 1.5 * turning).max(4.0 + 3.0 * turning);
    (0.25 * phase + digits / 14.0 * spare).ceil() as usize
}

/// The position in [`SIZES`] of the smallest rule with at least `n` nodes; the largest if there is none.
pub(super) fn position(n: usize) -> usize {
    SIZES.partition_point(|&size| size < n).min(SIZES.len() - 1)
}

/// The smallest kept Gauss-Legendre rule on [-1, 1] with at least `n` nodes (the largest, 1024, beyond that).
pub fn rule(n: usize) -> &'static Rule {
    static RULES: [OnceLock<Rule>; SIZES.len()] = [const { OnceLock::new() }; SIZES.len()];
    let i = position(n);
    RULES[i].get_or_init(|| gauss_legendre(SIZES[i]))
}

/// The Gauss-Laguerre rule with 24 nodes (`n` <= 24) or 32, for integrals of exp(-s) f(s) over s > 0.
pub fn laguerre_rule(n: usize) -> &'static Rule {
    // Evaluated by the compiler: bisection for 24 nodes takes a million instructions, a seventh of a first solution.
    const FEW: [[f64; 24]; 2] = gauss_laguerre();
    const MANY: [[f64; 32]; 2] = gauss_laguerre();
    static RULES: [OnceLock<Rule>; 2] = [const { OnceLock::new() }; 2];
    let (i, [nodes, weights]): (_, [&[f64]; 2]) =
        if n <= 24 { (0, [&FEW[0], &FEW[1]]) } else { (1, [&MANY[0], &MANY[1]]) };
    RULES[i].get_or_init(|| Rule { nodes: nodes.to_vec(), weights: weights.to_vec() })
}

/// Gauss-Legendre rule with `n` nodes on [-1, 1]: exact for polynomials of degree 2n - 1.
///
/// Works with the angle t = arccos x, in which neither the nodes nor the weights lose digits at the ends.
///
/// Source: Tricomi 1950 for the start; Szegő 1939, (4.2.1) and (15.3.1).
pub fn gauss_legendre(n: usize) -> Rule {
    let half = n.div_ceil(2);
    let order = n as f64 + 0.5;
    let mut angles: Vec<f64> = (0..half)
        .map(|k| {
            let t = PI * (k as f64 + 0.75) / order;
            t + 1.0 / (8.0 * order * order * t.tan())
        })
        .collect();
    let degree = (n * (n + 1)) as f64;
    let mut slopes = vec![0.0; half];
    for _ in 0..3 {
        let (values, descents) = legendre(n, &angles);
        for (i, t) in angles.iter_mut().enumerate() {
            // Halley's step for P(cos t) = 0, P'' = -cot t P' - n (n + 1) P. The weight wants the slope at the
            // corrected angle: d(ln |P'|)/dt = P''/P'.
            let (p, dp) = (values[i], -descents[i] / t.sin());
            let newton = p / dp;
            let bend = -1.0 / t.tan() - degree * newton;
            let step = -newton / (1.0 - 0.5 * newton * bend);
            slopes[i] = dp * (1.0 + step * bend);
            *t += step;
        }
    }
    let mut rule = Rule { nodes: vec![0.0; n], weights: vec![0.0; n] };
    for (i, (&t, slope)) in angles.iter().zip(slopes).enumerate() {
        let mirrored = n - 1 - i;
        let x = if i == mirrored { 0.0 } else { t.cos() };
        (rule.nodes[i], rule.nodes[mirrored]) = (-x, x);
        let weight = 2.0 / (slope * slope);
        (rule.weights[i], rule.weights[mirrored]) = (weight, weight);
    }
    rule
}

/// P_n(x) and (1 - x^2) dP_n/dx = n (P_{n-1} - x P_n) at x = cos t, for angles t in (0, pi/2].
///
/// The recurrence runs over differences, d_{k+1} = (k d_k - (2k + 1)(1 - cos t) P_k)/(k + 1), P_{k+1} = P_k + d_{k+1}:
/// 1 - cos t = 2 sin^2(t/2) keeps its digits where cos t is close to 1.
fn legendre(n: usize, angles: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let sag: Vec<f64> = angles.iter().map(|t| 2.0 * (0.5 * t).sin().powi(2)).collect();
    let mut value = vec![1.0; angles.len()];
    let mut difference = vec![0.0; angles.len()];
    for k in 0..n {
        let (keep, turn) = (k as f64 / (k + 1) as f64, (2 * k + 1) as f64 / (k + 1) as f64);
        for ((p, d), s) in value.iter_mut().zip(&mut difference).zip(&sag) {
            *d = keep * *d - turn * s * *p;
            *p += *d;
        }
    }
    // P_{n-1} - cos t P_n = (1 - cos t) P_n - d_n
    let descent = value.iter().zip(&difference).zip(&sag).map(|((p, d), s)| n as f64 * (s * p - d)).collect();
    (value, descent)
}

/// Gauss-Laguerre rule for integrals of exp(-s) f(s) over s > 0: nodes and weights. Meant for up to 40 nodes. Loops are written so that the
/// compiler can run them.
///
/// The nodes are separated by the sign changes of L_0, L_1, ... (a Sturm sequence) and refined by Newton's method.
/// Source: Szegő 1939, (5.1.10), (5.1.14), (15.3.5).
const fn gauss_laguerre<const N: usize>() -> [[f64; N]; 2] {
    let [mut nodes, mut weights] = [[0.0; N]; 2];
    let mut k = 0;
    while k < N {
        let (mut lo, mut hi) = (0.0, 4.0 * N as f64 + 2.0);
        let mut halved = 0;
        while halved < 40 {
            let middle = 0.5 * (lo + hi);
            let (.., zeros_below) = laguerre(N, middle);
            if zeros_below > k {
                hi = middle;
            } else {
                lo = middle;
            }
            halved += 1;
        }
        let (mut x, mut slope) = (0.5 * (lo + hi), 0.0);
        let mut steps = 0;
        while steps < 3 {
            // x L'' = (x - 1) L' - n L gives the slope at the corrected node.
            let (value, difference, _) = laguerre(N, x);
            let descent = N as f64 * difference / x;
            let step = -value / descent;
            slope = descent * (1.0 + step * (x - 1.0) / x);
            x += step;
            steps += 1;
        }
        nodes[k] = x;
        weights[k] = 1.0 / (x * slope * slope);
        k += 1;
    }
    [nodes, weights]
}

/// The recurrence of the Laguerre polynomials at one point: L_n, L_n - L_(n-1) = (x/n) dL_n/dx, and the number of zeros of L_n below x.
const fn laguerre(n: usize, x: f64) -> (f64, f64, usize) {
    let (mut value, mut difference, mut zeros_below) = (1.0f64, 0.0, 0);
    let mut k = 0;
    while k < n {
        let before = value;
        difference = (k as f64 * difference - x * value) / (k + 1) as f64;
        value += difference;
        if value.is_sign_negative() != before.is_sign_negative() {
            zeros_below += 1;
        }
        k += 1;
    }
    (value, difference, zeros_below)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kept_rule_integrates_polynomials_exactly() {
        for n in SIZES {
            let rule = rule(n);
            assert_eq!((rule.nodes.len(), rule.weights.len()), (n, n));
            assert!(rule.nodes.windows(2).all(|w| w[0] < w[1]) && rule.nodes[0] > -1.0);
            assert!(rule.weights.iter().all(|&w| w > 0.0));
            assert!((0..n).all(|i| rule.nodes[i] == -rule.nodes[n - 1 - i]));
            for degree in [0, 2, 8, 14, n as i32 & !1, 2 * n as i32 - 2] {
                let sum: f64 = rule.nodes.iter().zip(&rule.weights).map(|(x, w)| w * x.powi(degree)).sum();
                let exact = 2.0 / f64::from(degree + 1);
                assert!((sum / exact - 1.0).abs() < 5e-14, "{n} nodes, degree {degree}: {:e}", sum / exact - 1.0);
            }
        }
    }

    #[test]
    fn known_nodes_and_weights() {
        // first node and weight, from a multiple-precision evaluation
        let known = [
            (2, -0.577_350_269_189_625_7, 1.0),
            (7, -0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
            (16, -0.989_400_934_991_649_9, 0.027_152_459_411_754_096),
            (100, -0.999_713_726_773_441_3, 0.000_734_634_490_505_671_7),
            (1024, -0.999_997_245_054_558_4, 7.070_076_410_182_59e-6),
            (2000, -0.999_999_277_463_170_3, 1.854_262_610_213_272_8e-6),
        ];
        for (n, node, weight) in known {
            let rule = gauss_legendre(n);
            assert!((rule.nodes[0] - node).abs() < 2.3e-16, "{n}");
            assert!((rule.weights[0] / weight - 1.0).abs() < 2e-14, "{n}: {:e}", rule.weights[0] / weight - 1.0);
        }
        let odd = gauss_legendre(3);
        assert_eq!(odd.nodes[1], 0.0);
        assert!((odd.weights[1] - 8.0 / 9.0).abs() < 1e-15);
        assert!(gauss_legendre(0).nodes.is_empty());
    }

    #[test]
    fn rules_are_kept_and_clamped() {
        assert_eq!([0, 8, 9, 17, 1000, 100_000].map(|n| rule(n).nodes.len()), [8, 8, 12, 20, 1024, 1024]);
        assert!(std::ptr::eq(rule(33), rule(40)));
        assert!(std::ptr::eq(laguerre_rule(25), laguerre_rule(100)));
    }

    #[test]
    fn laguerre_moments_are_factorials() {
        for n in [24, 32] {
            let rule = laguerre_rule(n);
            let mut factorial = 1.0;
            for degree in 0..2 * n {
                let sum: f64 = rule.nodes.iter().zip(&rule.weights).map(|(s, w)| w * s.powi(degree as i32)).sum();
                assert!(
                    (sum / factorial - 1.0).abs() < 2e-14,
                    "{n} nodes, degree {degree}: {:e}",
                    sum / factorial - 1.0
                );
                factorial *= (degree + 1) as f64;
            }
        }
        // first and last node and weight of 24, from a multiple-precision evaluation
        let rule = laguerre_rule(24);
        for (i, node, weight) in [
            (0, 0.059_019_852_181_507_98, 0.142_811_973_334_781_85),
            (23, 81.498_279_233_948_89, 5.575_345_788_328_357e-35),
        ] {
            assert!(
                (rule.nodes[i] / node - 1.0).abs() < 1e-15 && (rule.weights[i] / weight - 1.0).abs() < 1e-14,
                "{i}"
            );
        }
    }
}
