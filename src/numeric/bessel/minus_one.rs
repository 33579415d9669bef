//! Transforms of unit pressures less their resultant, with all digits also for long waves.
use super::table;

/// Gamma(n/2 + 1) (2/z)^(n/2) J_(n/2)(z) - 1 for n = 1, 2, 3 and 4, z >= 0: of the pressure (1 - s^2)^(m/2) the transform on a strip (n = m + 1) or
/// a disc (n = m + 2) of half-width or radius 1, less its resultant, over it.
///
/// ```
/// use recede::numeric::bessel::of_order_minus_one;
/// let z = 1e-6;
/// for n in 1..=4 {
///     assert!((of_order_minus_one(n, z) / (-z * z / f64::from(2 * n + 4)) - 1.0).abs() < 1e-12);
/// }
/// ```
pub fn of_order_minus_one(n: i32, z: f64) -> f64 {
    match n {
        1 => sinc_minus_one(z),
        2 => jinc_minus_one(z),
        3 => spherical_jinc_minus_one(z),
        _ => {
            // 8 J_2/z^2 = 2 (J_1 + J_3)/z
            let mut bessel = [0.0; 4];
            table(4, &[z], &mut bessel);
            jinc_minus_one(z) + if z > 0.0 { 2.0 * bessel[3] / z } else { 0.0 }
        }
    }
}

/// 2 J_1(z)/z - 1, to a relative error of a few 1e-16 also where it is small.
pub fn jinc_minus_one(z: f64) -> f64 {
    let mut j = [0.0; 2];
    if z.abs() >= SERIES_BELOW {
        table(2, &[z.abs()], &mut j);
    }
    jinc_minus_one_from(z.abs(), j[1])
}

/// 2 J_1(z)/z - 1 where `j1` = J_1(z) is known already (it is not used for small z). See [`jinc_minus_one`].
#[inline(always)]
pub fn jinc_minus_one_from(z: f64, j1: f64) -> f64 {
    // sum over k >= 1 of (-z^2/4)^k / (k! (k+1)!), as nested products from the innermost
    let q = -0.25 * z * z;
    let mut series = 1.0;
    for ratio in RATIOS.iter().rev() {
        series = 1.0 + series * q * ratio;
    }
    // both, so that loops compile to vector instructions
    if z.abs() >= SERIES_BELOW { 2.0 * j1 / z - 1.0 } else { 0.5 * q * series }
}

/// 1/(k (k + 1)) for k = 2, 3, ...
const RATIOS: [f64; 11] = {
    let (mut ratios, mut k) = ([0.0; 11], 0);
    while k < ratios.len() {
        ratios[k] = 1.0 / ((k + 2) * (k + 3)) as f64;
        k += 1;
    }
    ratios
};

const SERIES_BELOW: f64 = 2.0;

/// sin z/z - 1, to a relative error of a few 1e-16 also where it is small.
///
/// ```
/// use recede::numeric::bessel::sinc_minus_one;
/// assert!((sinc_minus_one(1e-6) / (-1e-12 / 6.0) - 1.0).abs() < 1e-12);
/// assert_eq!(sinc_minus_one(0.0), 0.0);
/// ```
pub fn sinc_minus_one(z: f64) -> f64 {
    if z.abs() >= SERIES_BELOW { z.sin() / z - 1.0 } else { spherical_minus_one(z, 1.0) }
}

/// 3 (sin z - z cos z)/z^3 - 1, to a relative error of a few 1e-16 also where it is small.
///
/// ```
/// use recede::numeric::bessel::spherical_jinc_minus_one;
/// assert!((spherical_jinc_minus_one(1e-6) / -1e-13 - 1.0).abs() < 1e-12); // -z^2/10
/// ```
pub fn spherical_jinc_minus_one(z: f64) -> f64 {
    if z.abs() >= SERIES_BELOW {
        3.0 * (z.sin() - z * z.cos()) / (z * z * z) - 1.0
    } else {
        spherical_minus_one(z, 3.0)
    }
}

/// Sum over k >= 1 of (-z^2/2)^k / (k! (n + 2) (n + 4) ... (n + 2k)): Gamma(n/2 + 1) (2/z)^(n/2) J_(n/2)(z) - 1.
fn spherical_minus_one(z: f64, n: f64) -> f64 {
    let q = -0.5 * z * z;
    let term = |k: i32| q / (f64::from(k) * (n + 2.0 * f64::from(k)));
    term(1) * (2..=14).rev().fold(1.0, |s, k| 1.0 + s * term(k))
}

/// From here on the asymptotic series of [`integral`] is below rounding where it is cut off.
pub const INTEGRAL_FROM: f64 = 40.0;
/// Terms of that series.
const INTEGRAL_TERMS: i32 = 24;

/// The integral of J_0 from 0 to z, for z >= [`INTEGRAL_FROM`]: 1 less that from z on,
/// sqrt(2/(pi z)) times the real part of e^(i (z - pi/4)) sum over k of i (-i)^k a_k/z^k, with a_k = (1/2)_k times the sum over
/// s <= k of (1/2)_s/(2^s s!), (1/2)_k = 1/2 3/2 ... (k - 1/2).
///
/// ```
/// use recede::numeric::bessel::integral;
/// // 2 (J_1 + J_3 + ...)
/// let mut j = [0.0; 120];
/// recede::numeric::bessel::table(120, &[40.5], &mut j);
/// let expected = 2.0 * j.iter().skip(1).step_by(2).sum::<f64>();
/// assert!((integral(40.5) - expected).abs() < 1e-15);
/// ```
pub fn integral(z: f64) -> f64 {
    let (mut power, mut term, mut partial) = (1.0, 1.0, 1.0);
    // of i (-i)^k: the real parts and the imaginary ones
    let mut sums = [0.0; 2];
    for k in 0..INTEGRAL_TERMS {
        let sign = [1.0, 1.0, -1.0, -1.0][k as usize % 4];
        sums[(k as usize + 1) % 2] += sign * power * partial;
        let next = f64::from(k) + 1.0;
        term *= (next - 0.5) / (2.0 * next);
        partial += term;
        power *= (next - 0.5) / z;
    }
    let (sin, cos) = (z - std::f64::consts::FRAC_PI_4).sin_cos();
    1.0 - (2.0 / (std::f64::consts::PI * z)).sqrt() * (cos * sums[0] - sin * sums[1])
}
