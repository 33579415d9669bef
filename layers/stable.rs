//! Hyperbolic combinations that neither overflow nor cancel.
//!
//! Bare `sinh` and `cosh` are used nowhere else in this crate.

/// Below this argument the power series are used: they have positive terms only, so no digit is lost, and 15
/// terms reach rounding.
const SERIES_BELOW: f64 = 2.0;

/// Σ_k c_k z^(2k), c_0 = first, c_k = c_(k−1) · ratio(k), with positive terms, summed to rounding.
fn even_series(z: f64, first: f64, ratio: impl Fn(f64) -> f64) -> f64 {
    let square = z * z;
    let (mut term, mut sum) = (first, first);
    let mut k = 1.0;
    while term > 0.25 * f64::EPSILON * sum {
        term *= square * ratio(k);
        sum += term;
        k += 1.0;
    }
    sum
}

/// cosh z − 1 = 2 sinh²(z/2).
pub fn cosh_minus_one(z: f64) -> f64 {
    let half = (0.5 * z).sinh();
    2.0 * half * half
}

/// sinh z − z.
pub fn sinh_minus_argument(z: f64) -> f64 {
    if z < SERIES_BELOW {
        z * z * z * even_series(z, 1.0 / 6.0, |k| 1.0 / ((2.0 * k + 2.0) * (2.0 * k + 3.0)))
    } else {
        z.sinh() - z
    }
}

/// z cosh z − sinh z.
pub fn argument_cosh_minus_sinh(z: f64) -> f64 {
    if z < SERIES_BELOW {
        z * z * z * even_series(z, 1.0 / 3.0, |k| 1.0 / (2.0 * k * (2.0 * k + 3.0)))
    } else {
        z * z.cosh() - z.sinh()
    }
}

/// sinh z.
pub fn sinh(z: f64) -> f64 {
    z.sinh()
}

/// (cosh z − 1)/(sinh z + z) for any z > 0, without overflow.
pub fn equal_load_ratio(z: f64) -> f64 {
    if z < SERIES_BELOW {
        cosh_minus_one(z) / (z.sinh() + z)
    } else {
        let decay = (-z).exp();
        (1.0 - decay) * (1.0 - decay) / (1.0 - decay * decay + 2.0 * z * decay)
    }
}

/// (cosh z + 1)/(sinh z − z) for any z > 0, without overflow.
pub fn opposite_load_ratio(z: f64) -> f64 {
    if z < SERIES_BELOW {
        (z.cosh() + 1.0) / sinh_minus_argument(z)
    } else {
        let decay = (-z).exp();
        (1.0 + decay) * (1.0 + decay) / (1.0 - decay * decay - 2.0 * z * decay)
    }
}

/// ½ (opposite − equal) of the two ratios above, i.e. −λC_tb of a strip in units of (κ + 1)/(4μ): decays like
/// 2 (1 + z) e^(−z) and is therefore not formed as a difference.
pub fn coupling_ratio(z: f64) -> f64 {
    // ½ [(c+1)(s+z) − (c−1)(s−z)] / (s² − z²) = (s + z c)/(s² − z²)
    if z < SERIES_BELOW {
        let (s, c) = (z.sinh(), z.cosh());
        (s + z * c) / ((s + z) * sinh_minus_argument(z))
    } else {
        let decay = (-z).exp();
        let square = decay * decay;
        // z e^(−z) is formed first: z² alone may overflow
        let sinh2 = (1.0 - square) * (1.0 - square) - 4.0 * (z * decay) * (z * decay);
        2.0 * decay * ((1.0 - square) + z * (1.0 + square)) / sinh2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_branches_meet() {
        let (below, above) = (SERIES_BELOW * (1.0 - f64::EPSILON), SERIES_BELOW);
        for f in [sinh_minus_argument, argument_cosh_minus_sinh, equal_load_ratio, opposite_load_ratio, coupling_ratio]
        {
            let (a, b) = (f(below), f(above));
            assert!((a - b).abs() < 1e-14 * a.abs(), "{a} {b}");
        }
    }

    #[test]
    fn small_arguments_keep_all_digits() {
        for z in [1e-100, 1e-50, 1e-8, 1e-3] {
            assert!((sinh_minus_argument(z) / (z * z * z / 6.0) - 1.0).abs() < 0.06 * z * z + 1e-15);
            assert!((argument_cosh_minus_sinh(z) / (z * z * z / 3.0) - 1.0).abs() < 0.11 * z * z + 1e-15);
        }
    }

    #[test]
    fn large_arguments_do_not_overflow() {
        for z in [50.0, 800.0, 1e8, 1e300] {
            assert!((equal_load_ratio(z) - 1.0).abs() < 1e-14);
            assert!((opposite_load_ratio(z) - 1.0).abs() < 1e-14);
            assert!(coupling_ratio(z).abs() < 1e-15);
        }
    }
}
