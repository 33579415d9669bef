//! Where the downward recurrence starts: high enough for all digits, and not so high that it overflows.
use std::f64::consts::LN_2;

use super::{DEEPEST, Lanes, TINY};
use crate::numeric::vector::LANES;

/// Where each lane may start: all with the largest argument, unless the smallest would overflow from there.
pub(super) fn start_orders(z: &Lanes, orders: usize) -> [usize; LANES] {
    let (least, most) = z.iter().fold((f64::INFINITY, 0.0), |(least, most), &z| (z.min(least), z.max(most)));
    let together = start_order(most, orders);
    let m = together as f64;
    if least >= TINY && together > 1 && depth(m, least, acosh_above(m / least)) < DEEPEST {
        [together; LANES]
    } else {
        z.map(|z| start_order(z, orders))
    }
}

/// The exponent of J_m(z), about exp(−m (A − tanh A)) with cosh A = m/z, for the `angle` A.
fn depth(m: f64, z: f64, angle: f64) -> f64 {
    m * (angle - (1.0 - (z / m).powi(2)).sqrt())
}

/// The order m at which the downward recurrence may start so that the orders below `orders` are correct to rounding.
fn start_order(z: f64, orders: usize) -> usize {
    if z.is_nan() || z < TINY {
        return 0;
    }
    let n = z.max(orders as f64);
    // The order n must have forgotten the start: (J_m Y_n)/(Y_m J_n) is about exp(-2 (m - n) acosh(n/z)) above the
    // turning point n = z, and exp(-(4/3) x^(3/2)), x = (m - z) (2/z)^(1/3), at it.
    let mut guard = 26.0 / log2_below(cosh_to_exp(n / z));
    let mut enough = 0.0;
    if n < 2.0 * z + 19.0 {
        // The sum that normalises must have converged as well: J_m, about exp(-(2/3) x^(3/2)), below 1e-17.
        let cbrt = cbrt_above(z);
        guard = guard.min(7.6 * cbrt + 3.0);
        enough = z + 11.5 * cbrt + 3.0;
    }
    let mut m = (n + guard).max(enough) + 1.0;

    // J_m, about exp(-m (A - tanh A)) with cosh A = m/z, must not be too small. The exponent is convex in m and has the
    // derivative A: Newton's method from above stays above.
    let depth = |m: f64, angle: f64| depth(m, z, angle);
    if depth(m, acosh_above(m / z)) > DEEPEST {
        loop {
            let angle = (m / z).acosh();
            let excess = depth(m, angle) - DEEPEST;
            if excess <= 0.0 || m <= 1.0 {
                break;
            }
            m = (m - (excess / angle).max(0.5)).max(1.0);
        }
    }
    m as usize
}

/// exp(A) of cosh(A) >= 1.
fn cosh_to_exp(cosh: f64) -> f64 {
    cosh + (cosh * cosh - 1.0).sqrt()
}

/// An upper bound of A of cosh(A) >= 1, 0.06 more at most.
fn acosh_above(cosh: f64) -> f64 {
    LN_2 * (log2_below(cosh_to_exp(cosh)) + LOG2_GAP)
}

/// How far [`log2_below`] may fall short.
const LOG2_GAP: f64 = 0.0861;

/// A lower bound of log2(y) for y >= 1: the mantissa read as a straight line.
fn log2_below(y: f64) -> f64 {
    (y.to_bits() as i64 - 1f64.to_bits() as i64) as f64 * f64::EPSILON
}

/// An upper bound of the cube root of z > 0, by less than a hundredth: a third of the exponent, and one step of Newton's
/// method, which is never too short.
fn cbrt_above(z: f64) -> f64 {
    let guess = f64::from_bits(z.to_bits() / 3 + (1f64.to_bits() - 1f64.to_bits() / 3));
    (2.0 * guess + z / (guess * guess)) / 3.0
}
