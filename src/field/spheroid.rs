//! Potentials of a series of pressures on a disc, in oblate spheroidal coordinates: r = a √((1 + ξ²)(1 − η²)), d = aξη.
//!
//! The transform of √(1 − ρ²) Σ c_m P_m(1 − 2ρ²) is a Σ C_n j_n(λa)/λ with odd n = 2m + 1, and with q_n(ξ) = i^(n+1) Q_n(iξ)
//!
//! ∫ j_n(λa) J₀(λr) e^(−λd) dλ = P_n(η) q_n(ξ)/a,  ∫ j_n(λa) J₁(λr) e^(−λd) dλ = −r P_n'(η) q_n'(ξ)/(n(n + 1)a²).
//!
//! Powers of λ are derivatives with respect to the depth and to r; j_n(z)/z = (j_(n−1) + j_(n+1))/(2n + 1) is one power less. It takes
//! as long as a recurrence over the orders. Source: Hobson 1931, chapters V and X.
use num_complex::Complex64;

use super::transform::Potentials;

/// Orders whose functions q_n are smaller than e^(−SMALL) are left out, but for the lowest two.
const SMALL: f64 = 42.0;
/// The recurrence for q_n loses e^LOST in upward order at most; where it would lose more it is run downwards.
const LOST: f64 = 6.0;
/// The downward recurrence starts at an order so high that the growing solution has fallen to e^(−2·START) of q_n where values are kept.
const START: f64 = 19.0;

/// A place, in the coordinates of a disc.
pub(super) struct Spheroidal {
    pub(super) xi: f64,
    pub(super) eta: f64,
    /// 1 − η².
    pub(super) beyond: f64,
    /// r/a.
    rho: f64,
}

impl Spheroidal {
    pub(super) fn new(rho: f64, depth: f64) -> Self {
        // ξ² − η² and ξ² + η²
        let difference = (rho - 1.0) * (rho + 1.0) + depth * depth;
        let sum = difference.hypot(2.0 * depth);
        let larger = (0.5 * (sum + difference.abs())).sqrt();
        let smaller = if larger > 0.0 { depth / larger } else { 0.0 };
        let (xi, eta) = if difference > 0.0 { (larger, smaller) } else { (smaller, larger) };
        Self { xi, eta: eta.min(1.0), beyond: rho * rho / (1.0 + xi * xi), rho }
    }
}

/// q_0 to q_n of `orders` n or fewer: the others are negligible.
fn second_kind(xi: f64, orders: usize) -> Vec<f64> {
    let falls = xi.asinh();
    let orders = orders.min((SMALL / falls) as usize).max(2);
    let zeroth = f64::atan2(1.0, xi);
    let mut values = vec![0.0; orders + 1];
    if 2.0 * orders as f64 * falls < LOST {
        [values[0], values[1]] = [zeroth, 1.0 - xi * zeroth];
        for n in 1..orders {
            let k = n as f64;
            let over = (k + 1.0).recip();
            values[n + 1] = k * over * values[n - 1] - (2.0 * k + 1.0) * over * xi * values[n];
        }
        return values;
    }
    let (mut above, mut value) = (0.0, 1.0);
    for n in (0..=orders + (START / falls) as usize + 1).rev() {
        if let Some(kept) = values.get_mut(n) {
            *kept = value;
        }
        let k = n as f64;
        let over = k.recip();
        (above, value) = (value, (k + 1.0) * over * above + (2.0 * k + 1.0) * over * xi * value);
    }
    let scale = zeroth / values[0];
    values.iter_mut().for_each(|value| *value *= scale);
    values
}

/// The factors of the products of all orders n: odd ones by C_n, even ones by C_(n−1)/(2n − 1) + C_(n+1)/(2n + 3).
pub(super) fn by_order(coefficients: &[f64]) -> Vec<f64> {
    let of = |n: usize| {
        let c = |m: Option<usize>| m.and_then(|m| coefficients.get(m)).copied().unwrap_or(0.0);
        let (m, k) = (n / 2, n as f64);
        if n % 2 == 1 { c(Some(m)) } else { c(m.checked_sub(1)) / (2.0 * k - 1.0) + c(Some(m)) / (2.0 * k + 3.0) }
    };
    (0..=2 * coefficients.len()).map(of).collect()
}

/// Sums over the orders of products of P_n(η), q_n(ξ) and their derivatives: over the odd orders P q, P q', P' q, P' q', n(n + 1) P q and
/// P' q'/(n(n + 1)), over the even ones P q and, but for n = 0, P' q'/(n(n + 1)).
fn products(place: &Spheroidal, by_order: &[f64]) -> ([f64; 6], [f64; 2]) {
    let Spheroidal { xi, eta, .. } = *place;
    let q = second_kind(xi, by_order.len());
    let over = (1.0 + xi * xi).recip();
    let (mut odd, mut even) = ([0.0; 6], [0.0; 2]);
    let (mut before, mut p) = (0.0, 1.0);
    let (mut slope_before, mut slope) = (0.0, 0.0);
    // 1/n; 0 for n = 0, whose P' is 0
    let mut inverse = 0.0;
    for (n, (c, pair)) in by_order.iter().zip(q.windows(2)).enumerate() {
        let (k, [here, next]) = (n as f64, [pair[0], pair[1]]);
        let following = (k + 1.0).recip();
        let falls = -(k + 1.0) * (xi * here + next) * over;
        let (value, both, shared) = (c * p * here, c * slope * falls, inverse * following);
        if n % 2 == 1 {
            let terms = [value, c * p * falls, c * slope * here, both, k * (k + 1.0) * value, shared * both];
            odd.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        } else {
            even[0] += value;
            even[1] += shared * both;
        }
        (slope_before, slope) = (slope, slope_before + (2.0 * k + 1.0) * p);
        (before, p) = (p, (2.0 * k + 1.0) * following * eta * p - k * following * before);
        inverse = following;
    }
    (odd, even)
}

/// The potentials of a disc of radius a at a distance r from the axis and a depth, with coefficients [`by_order`]; those with
/// further powers of λ are 0 on the face.
pub(super) fn potentials(by_order: &[f64], a: f64, r: f64, depth: f64) -> Potentials {
    let place = Spheroidal::new(r / a, depth / a);
    let ([zeroth, by_xi, by_eta, by_both, product, radial], even) = products(&place, by_order);
    let Spheroidal { xi, eta, beyond, rho } = place;
    // a ∫ j_0(λa) J₁(λr) e^(−λd) dλ
    let lowest = by_order[0] / ((1.0 + eta) * (1.0 + xi * xi));
    let integral = a * Complex64::new(even[0], rho * (lowest - even[1]));
    let mut potentials = [integral, Complex64::new(zeroth, -rho * radial), Complex64::ZERO, Complex64::ZERO];
    if depth > 0.0 {
        // ∂/∂d = (α ∂/∂ξ + β ∂/∂η)/H, ∂/∂r = ρ (ξ ∂/∂ξ − η ∂/∂η)/H
        let (alpha, beta, over) = (eta * (1.0 + xi * xi), xi * beyond, 1.0 / (a * (xi * xi + eta * eta)));
        let falls = alpha * by_xi + beta * by_eta;
        let (of_xi, of_eta) = (
            eta * product + beyond * by_eta + beta * by_both,
            (1.0 + xi * xi) * by_xi + alpha * by_both - xi * product,
        );
        let (deeper, farther) = (alpha * xi + beta * eta, xi * xi - eta * eta);
        let double = 2.0 * a * falls * over;
        potentials[2] = over * Complex64::new(-falls, rho * (eta * by_eta - xi * by_xi));
        potentials[3] = over
            * over
            * Complex64::new(
                alpha * of_xi + beta * of_eta - double * deeper,
                rho * (xi * of_xi - eta * of_eta - double * farther),
            );
    }
    potentials
}
