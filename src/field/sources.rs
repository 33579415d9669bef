//! Potentials of forces on the axis, and of what they are at complex depths.
use num_complex::Complex64;

use super::potentials::{Closed, Potentials};

/// Im ∫ λ^n e^(−λ(d − is)) J(λr) dλ for n = 0, 1, 2, −1: of J₀ as real parts, of J₁ as imaginary ones.
pub(super) fn sources(s: f64, r: f64, depth: f64) -> [Complex64; 4] {
    let w = Complex64::new(depth, -s);
    // (d − is)² + r² without cancellation; the root of positive real part
    let square = Complex64::new(depth * depth + (r - s) * (r + s), -2.0 * depth * s);
    let root = self::root(square);
    let over = root.inv();
    let (third, sum) = (over * over * over, (root + w).inv());
    let fifth = third * over * over;
    let pairs = [
        (over, r * over * sum),
        (w * third, r * third),
        ((2.0 * w * w - r * r) * fifth, 3.0 * r * w * fifth),
        (Complex64::new(0.0, sum.arg()), r * sum),
    ];
    pairs.map(|(zeroth, first)| Complex64::new(zeroth.im, first.im))
}

/// The square root with a positive real part; next to the negative axis its imaginary part has the sign of the imaginary part of the square.
fn root(square: Complex64) -> Complex64 {
    let larger = (0.5 * (square.norm() + square.re.abs())).sqrt();
    let smaller = if larger > 0.0 { 0.5 * square.im / larger } else { 0.0 };
    if square.re > 0.0 {
        Complex64::new(larger, smaller)
    } else {
        Complex64::new(smaller.abs(), larger.copysign(square.im))
    }
}

/// The potentials of a force P on the axis, p̂ = P/2π everywhere.
pub(super) fn point(transform: f64, r: f64, depth: f64) -> Closed {
    let distance = r.hypot(depth);
    let over = distance.recip();
    let (cos, sin) = (depth * over, r * over);
    let (square, third) = (over * over, over * over * over);
    let zeroth = Complex64::new(cos, sin) * square;
    let first = Complex64::new(2.0 * cos * cos - sin * sin, 3.0 * cos * sin) * third;
    let second = Complex64::new(6.0 * cos.powi(3) - 9.0 * cos * sin * sin, 3.0 * sin * (4.0 * cos * cos - sin * sin));
    let integral = Complex64::new(over, r / (distance * (distance + depth)));
    let potentials = Potentials([zeroth * transform, first * transform, second * (third * over * transform)]);
    Closed { potentials, integral: integral * transform }
}
