//! Bessel functions of integer order for many orders and arguments at once.
//!
//! Tables are laid out one order after the other: the value of order `n` at the argument `i` is
//! `out[n * arguments.len() + i]`, which is a column-major matrix of arguments by orders.
//!
//! Every table is a three-term recurrence F(n+1) = (2n/z) F(n) - F(n-1), run in its stable direction:
//!
//! * downwards from an order where J is negligible, and normalised by J0 + 2 (J2 + J4 + ...) = 1 (Miller), for
//!   arguments below the highest order;
//! * upwards from orders 0 and 1, given by Hankel's expansion, for arguments above it.
//!
//! Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 9.1.27, 9.1.46, 9.2.5-9.2.10, 9.3.2, 9.12.

use num_complex::Complex64;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_PI, LN_2};
use std::ops::{Mul, Sub};

/// Arguments from here on may use Hankel's expansion: its smallest term is far below rounding.
pub const ASYMPTOTIC_FROM: f64 = 25.0;

/// Arguments advanced together, so that the inner loops compile to vector instructions.
const LANES: usize = 8;
type Lanes = [f64; LANES];

/// Arguments below this are told from zero by J1 alone, which is then negligible as well.
const TINY: f64 = 1e-290;
/// Where the downward recurrence starts; J may grow by `exp(DEEPEST)` from there without overflow.
const SEED: f64 = 1e-280;
const DEEPEST: f64 = 690.0;

/// J_n(z) for n = 0..`orders` at every argument z >= 0 (finite), into `out[n * arguments.len() + i]`.
///
/// The absolute error is a few units of 1e-16; for orders above the argument the error is relative, down to values of
/// about 1e-299, below which the result is zero.
///
/// # Panics
/// If `out` is not `orders` times as long as `arguments`.
///
/// ```
/// let mut j = [0.0; 4];
/// recede::numeric::bessel::table(2, &[0.0, 1.0], &mut j);
/// assert_eq!((j[0], j[2]), (1.0, 0.0));
/// assert!((j[1] - 0.765_197_686_557_966_6).abs() < 1e-15); // J0(1)
/// assert!((j[3] - 0.440_050_585_744_933_5).abs() < 1e-15); // J1(1)
/// ```
pub fn table(orders: usize, arguments: &[f64], out: &mut [f64]) {
    assert_eq!(
        out.len(),
        orders * arguments.len(),
        "a Bessel table holds one value per order and argument"
    );
    if out.is_empty() {
        return;
    }
    let upward_from = ASYMPTOTIC_FROM.max(orders as f64);
    let mut rows: Vec<Lanes> = Vec::new();
    for first in (0..arguments.len()).step_by(LANES) {
        let block = &arguments[first..arguments.len().min(first + LANES)];
        let mut z = [0.0; LANES];
        z[..block.len()].copy_from_slice(block);
        let mut window = Window {
            first,
            width: block.len(),
            columns: arguments.len(),
            out,
        };
        let far = z.map(|z| z >= upward_from);
        match far[..block.len()].iter().filter(|&&far| far).count() {
            0 => {
                let scale = downward(orders, &z, &mut rows);
                window.store(&rows[..orders], &scale, |_| true);
            }
            all if all == block.len() => {
                upward(orders, &z, &mut rows);
                window.store(&rows[..orders], &[1.0; LANES], |_| true);
            }
            _ => {
                let near = std::array::from_fn(|lane| if far[lane] { 0.0 } else { z[lane] });
                let scale = downward(orders, &near, &mut rows);
                window.store(&rows[..orders], &scale, |lane| !far[lane]);
                upward(orders, &z, &mut rows);
                window.store(&rows[..orders], &[1.0; LANES], |lane| far[lane]);
            }
        }
    }
}

/// The part of a table that belongs to one block of arguments.
struct Window<'a> {
    first: usize,
    width: usize,
    columns: usize,
    out: &'a mut [f64],
}

impl Window<'_> {
    /// Writes `rows * scale` for the lanes wanted.
    fn store(&mut self, rows: &[Lanes], scale: &Lanes, wanted: impl Fn(usize) -> bool) {
        let whole = self.width == LANES && (0..LANES).all(&wanted);
        for (row, column) in rows.iter().zip(self.out.chunks_exact_mut(self.columns)) {
            let column = &mut column[self.first..self.first + self.width];
            match <&mut Lanes>::try_from(&mut *column) {
                Ok(column) if whole => *column = std::array::from_fn(|lane| row[lane] * scale[lane]),
                _ => {
                    for (lane, value) in column.iter_mut().enumerate().filter(|(lane, _)| wanted(*lane)) {
                        *value = row[lane] * scale[lane];
                    }
                }
            }
        }
    }
}

/// Miller's recurrence: fills `rows[n]` (n = 0..orders at least) up to a factor per lane, and returns that factor.
fn downward(orders: usize, z: &Lanes, rows: &mut Vec<Lanes>) -> Lanes {
    let starts = z.map(|z| start_order(z, orders));
    let two_over_z = z.map(|z| if z < TINY { 0.0 } else { 2.0 / z });
    let highest = starts.iter().copied().max().unwrap_or(0);
    if rows.len() < orders.max(highest + 1) {
        rows.resize(orders.max(highest + 1), [0.0; LANES]);
    }
    rows[orders.min(highest + 1)..orders].fill([0.0; LANES]);

    let (mut above, mut here) = ([0.0; LANES], [0.0; LANES]);
    let mut n = highest;
    loop {
        // A lane is zero until its own start: an earlier one would overflow before it reaches order zero.
        let mut next = 0;
        for lane in 0..LANES {
            if starts[lane] == n {
                here[lane] = SEED;
            } else if starts[lane] < n {
                next = next.max(starts[lane]);
            }
        }
        let mut order = n as f64;
        for row in rows[next + 1..=n].iter_mut().rev() {
            *row = here;
            let below: Lanes = std::array::from_fn(|lane| order * two_over_z[lane] * here[lane] - above[lane]);
            above = here;
            here = below;
            order -= 1.0;
        }
        if n == 0 {
            break;
        }
        n = next;
    }
    rows[0] = here;

    let mut sum = [0.0; LANES];
    for row in rows[..=highest].iter().skip(2).step_by(2).rev() {
        for lane in 0..LANES {
            sum[lane] += row[lane];
        }
    }
    std::array::from_fn(|lane| 1.0 / (2.0 * sum[lane] + here[lane]))
}

/// Forward recurrence from Hankel's expansion: fills `rows[n]`, n = 0..orders.
fn upward(orders: usize, z: &Lanes, rows: &mut Vec<Lanes>) {
    if rows.len() < orders {
        rows.resize(orders, [0.0; LANES]);
    }
    let start = z.map(|z| {
        let s = StartReal::at(z.max(ASYMPTOTIC_FROM));
        (s.j0, s.j1)
    });
    let two_over_z = z.map(|z| 2.0 / z.max(ASYMPTOTIC_FROM));
    let mut below = start.map(|s| s.0);
    let mut here = start.map(|s| s.1);
    let mut order = 1.0;
    for row in &mut rows[..orders] {
        *row = below;
        let above: Lanes = std::array::from_fn(|lane| order * two_over_z[lane] * here[lane] - below[lane]);
        below = here;
        here = above;
        order += 1.0;
    }
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
        let cbrt = z.cbrt();
        guard = guard.min(7.6 * cbrt + 3.0);
        enough = z + 11.5 * cbrt + 3.0;
    }
    let mut m = (n + guard).max(enough) + 1.0;

    // J_m, about exp(-m (A - tanh A)) with cosh A = m/z, must not be too small. The exponent is convex in m and has the
    // derivative A: Newton's method from above stays above.
    let depth = |m: f64, angle: f64| m * (angle - (1.0 - (z / m).powi(2)).sqrt());
    if depth(m, LN_2 * (log2_below(cosh_to_exp(m / z)) + LOG2_GAP)) > DEEPEST {
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

/// How far [`log2_below`] may fall short.
const LOG2_GAP: f64 = 0.0861;

/// A lower bound of log2(y) for y >= 1: the mantissa read as a straight line.
fn log2_below(y: f64) -> f64 {
    (y.to_bits() as i64 - 1f64.to_bits() as i64) as f64 * f64::EPSILON
}

/// Hankel's coefficients of P (even) or Q (odd) in powers of 1/z^2, signs included, for the order `nu`.
const fn hankel_coefficients(nu: f64, odd: bool) -> [f64; TERMS] {
    let mut out = [0.0; TERMS];
    let (mut a, mut k) = (1.0, 0);
    while k < 2 * TERMS {
        if (k % 2 == 1) == odd {
            out[k / 2] = if (k / 2) % 2 == 0 { a } else { -a };
        }
        k += 1;
        let m = (2 * k - 1) as f64;
        a *= (4.0 * nu * nu - m * m) / (8.0 * k as f64);
    }
    out
}

const TERMS: usize = 9;
const P0: [f64; TERMS] = hankel_coefficients(0.0, false);
const Q0: [f64; TERMS] = hankel_coefficients(0.0, true);
const P1: [f64; TERMS] = hankel_coefficients(1.0, false);
const Q1: [f64; TERMS] = hankel_coefficients(1.0, true);

/// J and Y of orders 0 and 1 at a real argument of at least `ASYMPTOTIC_FROM`.
struct StartReal {
    j0: f64,
    j1: f64,
    y0: f64,
    y1: f64,
}

impl StartReal {
    fn at(z: f64) -> Self {
        let w = 1.0 / z;
        let sum = |c: &[f64; TERMS]| c.iter().rev().fold(0.0, |s, c| s * (w * w) + c);
        let (p0, q0, p1, q1) = (sum(&P0), w * sum(&Q0), sum(&P1), w * sum(&Q1));
        // sqrt(2/(pi z)) times cosine and sine of z - pi/4
        let (sin, cos) = z.sin_cos();
        let amplitude = (FRAC_2_PI * w).sqrt() * FRAC_1_SQRT_2;
        let (c, s) = (amplitude * (sin + cos), amplitude * (sin - cos));
        Self {
            j0: p0 * c - q0 * s,
            j1: p1 * s + q1 * c,
            y0: p0 * s + q0 * c,
            y1: q1 * s - p1 * c,
        }
    }
}

/// J_n(z) and Y_n(z) for n = 0..`orders` at real arguments z >= 25 with `orders` <= z, laid out as in [`table`].
///
/// The modulus |J + iY| is right to about 1e-14 of itself for n <= 0.8 z.
///
/// # Panics
/// If `j` or `y` is not `orders` times as long as `arguments`.
pub fn jy_table(orders: usize, arguments: &[f64], j: &mut [f64], y: &mut [f64]) {
    let length = arguments.len();
    assert_eq!(
        (j.len(), y.len()),
        (orders * length, orders * length),
        "one value per order and argument"
    );
    let two_over_z: Vec<f64> = arguments.iter().map(|z| 2.0 / z).collect();
    for (i, &z) in arguments.iter().enumerate() {
        let s = StartReal::at(z);
        for (table, start) in [(&mut *j, [s.j0, s.j1]), (&mut *y, [s.y0, s.y1])] {
            for (n, start) in start.into_iter().enumerate().take(orders) {
                table[n * length + i] = start;
            }
        }
    }
    recur_upward(&two_over_z, j);
    recur_upward(&two_over_z, y);
}

/// exp(-iz) H_n(z), H the Hankel function of the first kind, for n = 0..`orders`, laid out as in [`table`].
///
/// For arguments with Re z >= 25, `orders` <= Re z and Im z >= 0. The factor takes out the decay exp(-Im z). On the real
/// axis the result times exp(iz) is J + iY. Relative error about 1e-14 for n <= 0.8 Re z.
///
/// # Panics
/// If `out` is not `orders` times as long as `arguments`.
pub fn hankel_table(orders: usize, arguments: &[Complex64], out: &mut [Complex64]) {
    let length = arguments.len();
    assert_eq!(out.len(), orders * length, "one value per order and argument");
    let mut two_over_z = Vec::with_capacity(length);
    for (i, &z) in arguments.iter().enumerate() {
        let w = z.inv();
        let square = w * w;
        let sum = |c: &[f64; TERMS]| c.iter().rev().fold(Complex64::ZERO, |s, c| s * square + c);
        let amplitude = (FRAC_2_PI * w).sqrt() * FRAC_1_SQRT_2;
        // exp(-i pi/4) = (1 - i)/sqrt(2), exp(-3i pi/4) = (-1 - i)/sqrt(2)
        let start = [
            amplitude * Complex64::new(1.0, -1.0) * (sum(&P0) + Complex64::I * w * sum(&Q0)),
            amplitude * Complex64::new(-1.0, -1.0) * (sum(&P1) + Complex64::I * w * sum(&Q1)),
        ];
        for (n, start) in start.into_iter().enumerate().take(orders) {
            out[n * length + i] = start;
        }
        two_over_z.push(2.0 * w);
    }
    recur_upward(&two_over_z, out);
}

/// Completes a table whose orders 0 and 1 are given.
fn recur_upward<T>(two_over_z: &[T], table: &mut [T])
where
    T: Copy + Mul<f64, Output = T> + Mul<T, Output = T> + Sub<T, Output = T>,
{
    let length = two_over_z.len();
    if length == 0 {
        return;
    }
    for n in 1..(table.len() / length).saturating_sub(1) {
        let (known, new) = table.split_at_mut((n + 1) * length);
        let (below, here) = known[(n - 1) * length..].split_at(length);
        for (((new, &here), &below), &factor) in new.iter_mut().zip(here).zip(below).zip(two_over_z) {
            *new = factor * (n as f64) * here - below;
        }
    }
}

/// 2 J_1(z)/z - 1, to a relative error of a few 1e-16 also where it is small.
///
/// ```
/// use recede::numeric::bessel::jinc_deficit;
/// assert!((jinc_deficit(1e-6) / -1.25e-13 - 1.0).abs() < 1e-12); // -z^2/8
/// assert_eq!(jinc_deficit(0.0), 0.0);
/// ```
pub fn jinc_deficit(z: f64) -> f64 {
    let mut j = [0.0; 2];
    if z.abs() >= DEFICIT_SERIES_BELOW {
        table(2, &[z.abs()], &mut j);
    }
    jinc_deficit_from(z.abs(), j[1])
}

/// 2 J_1(z)/z - 1 where `j1` = J_1(z) is known already (it is not used for small z). See [`jinc_deficit`].
pub fn jinc_deficit_from(z: f64, j1: f64) -> f64 {
    if z.abs() >= DEFICIT_SERIES_BELOW {
        return 2.0 * j1 / z - 1.0;
    }
    // sum over k >= 1 of (-z^2/4)^k / (k! (k+1)!), as nested products from the innermost
    let q = -0.25 * z * z;
    q * 0.5 * (2..=12).rev().fold(1.0, |s, k| 1.0 + s * q / (k * (k + 1)) as f64)
}

const DEFICIT_SERIES_BELOW: f64 = 2.0;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// n, z, J_n(z) from a multiple-precision evaluation.
    #[rustfmt::skip]
    const J: [(usize, f64, f64); 36] = [
    (0, 0.001, 0.999_999_750_000_015_6),
    (1, 0.001, 0.000_499_999_937_500_002_6),
    (7, 0.001, 1.550_099_157_908_607_1e-27),
    (31, 0.5, 2.631_905_208_612_420_6e-53),
    (60, 0.5, 9.031_932_711_389_307e-119),
    (120, 0.5, 8.456_348_395_462_305e-272),
    (0, 2.5, -0.048_383_776_468_198),
    (3, 2.5, 0.216_600_391_039_113_52),
    (40, 2.5, 8.875_586_840_581_55e-45),
    (0, 12.25, 0.100_930_610_510_515_1),
    (11, 12.25, 0.281_967_114_141_266),
    (47, 12.25, 1.734_281_956_892_744_6e-23),
    (1, 24.875, -0.137_031_042_579_213_03),
    (24, 24.875, 0.194_794_658_663_943_13),
    (47, 24.875, 3.887_226_239_263_199_7e-10),
    (0, 30.0, -0.086_367_983_581_040_21),
    (25, 30.0, 0.084_292_740_643_031_73),
    (47, 30.0, 5.195_857_554_916_298e-7),
    (47, 47.5, 0.139_250_523_755_316_05),
    (0, 48.0, -0.114_714_878_324_197_26),
    (47, 48.0, 0.153_665_967_345_945_54),
    (0, 100.0, 0.019_985_850_304_223_122),
    (20, 100.0, 0.062_217_458_498_338_755),
    (99, 100.0, 0.115_243_925_323_037_8),
    (120, 100.0, 1.147_622_179_566_493_7e-5),
    (150, 100.0, 2.722_902_171_882_048e-16),
    (0, 1234.5, -0.013_550_379_618_035_721),
    (47, 1234.5, -0.000_831_491_723_359_967_6),
    (500, 1234.5, -0.007_467_455_321_614_187),
    (999, 900.0, 8.123_229_921_728_249e-16),
    (999, 1000.0, 0.048_830_228_770_221_78),
    (0, 1000.0, 0.024_786_686_152_420_176),
    (999, 300.0, 0.0),
    (700, 300.0, 3.983_131_750_031_831_7e-181),
    (0, 1000000.0, 0.000_331_043_013_739_873_76),
    (999, 1000000.0, 0.000_479_024_940_638_236_6),
    ];

    #[test]
    fn known_values() {
        // Each argument in a table of its own, and all of them in one table of mixed blocks.
        let arguments: Vec<f64> = J.iter().map(|row| row.1).collect();
        let mut all = vec![f64::NAN; 1000 * arguments.len()];
        table(1000, &arguments, &mut all);
        for (i, &(n, z, exact)) in J.iter().enumerate() {
            let mut own = vec![f64::NAN; n + 1];
            table(n + 1, &[z], &mut own);
            for value in [own[n], all[n * arguments.len() + i]] {
                let tolerance = if n as f64 > z { 1e-13 * exact.abs() } else { 2e-15 };
                assert!(
                    (value - exact).abs() <= tolerance,
                    "J_{n}({z}) = {value:e}, not {exact:e}"
                );
            }
        }
    }

    #[test]
    fn zero_and_almost_zero() {
        let arguments = [0.0, 5e-324, 1e-300, 1e-291, 1e-289, 1e-200, 1e-100, 1e-9];
        let length = arguments.len();
        let mut j = vec![f64::NAN; 50 * length];
        table(50, &arguments, &mut j);
        for (i, z) in arguments.iter().enumerate() {
            assert_eq!(j[i], 1.0);
            assert!((j[length + i] - 0.5 * z).abs() <= 1e-15 * z + 1e-290);
            assert!((j[2 * length + i] - 0.125 * z * z).abs() <= 1e-15 * z * z + 1e-290);
            assert!((3..50).all(|n| (0.0..1e-28).contains(&j[n * length + i])));
        }
    }

    #[test]
    fn shapes() {
        table(0, &[1.0, 2.0], &mut []);
        table(3, &[], &mut []);
        jy_table(2, &[], &mut [], &mut []);
        hankel_table(0, &[Complex64::new(30.0, 0.0)], &mut []);
        let mut one = [f64::NAN];
        for z in [0.0, 3.0, 80.0] {
            table(1, &[z], &mut one);
            assert!(one[0].is_finite());
        }
    }

    proptest! {
        /// J_0 + 2 (J_2 + J_4 + ...) = 1 normalises one branch only; J_0^2 + 2 (J_1^2 + J_2^2 + ...) = 1 examines both.
        #[test]
        fn squares_sum_to_one(arguments in prop::collection::vec((-5.0f64..2.7).prop_map(|e| 10f64.powf(e)), 1..20)) {
            let length = arguments.len();
            for orders in [600, 700] {
                let mut j = vec![f64::NAN; orders * length];
                table(orders, &arguments, &mut j);
                for i in 0..length {
                    let squares: f64 = (1..orders).map(|n| j[n * length + i].powi(2)).sum();
                    prop_assert!((j[i].powi(2) + 2.0 * squares - 1.0).abs() < 1e-14);
                    let even: f64 = (2..orders).step_by(2).map(|n| j[n * length + i]).sum();
                    prop_assert!((j[i] + 2.0 * even - 1.0).abs() < 1e-14);
                }
            }
        }

        /// The number of orders asked for decides on the branch, but not on the value; nor do the neighbours.
        #[test]
        fn values_do_not_depend_on_the_company(z in 0.0f64..200.0, others in prop::collection::vec(0.0f64..1e6, 7)) {
            let mut lone = vec![f64::NAN; 300];
            table(300, &[z], &mut lone);
            let mut arguments = others.clone();
            arguments.insert(3, z);
            for orders in [1, 20, 150] {
                let mut j = vec![f64::NAN; orders * 8];
                table(orders, &arguments, &mut j);
                for n in 0..orders {
                    prop_assert!((j[n * 8 + 3] - lone[n]).abs() < 2e-15);
                }
            }
        }

        /// J_{n+1} Y_n - J_n Y_{n+1} = 2/(pi z)
        #[test]
        fn wronskian(z in (25f64.ln()..1e6f64.ln()).prop_map(f64::exp)) {
            let orders = (z as usize).min(300);
            let (mut j, mut y) = (vec![f64::NAN; orders], vec![f64::NAN; orders]);
            jy_table(orders, &[z], &mut j, &mut y);
            let mut same = vec![f64::NAN; orders];
            table(orders, &[z], &mut same);
            for n in 0..orders - 1 {
                prop_assert!((0.5 * std::f64::consts::PI * z * (j[n + 1] * y[n] - j[n] * y[n + 1]) - 1.0).abs() < 2e-13);
                prop_assert!((j[n] - same[n]).abs() < 2e-15);
            }
        }

        /// The Hankel functions on the real axis are J + iY.
        #[test]
        fn hankel_functions_join_the_real_axis(z in 25.0f64..1e4) {
            let orders = (0.8 * z.min(100.0)) as usize;
            let (mut j, mut y) = (vec![f64::NAN; orders], vec![f64::NAN; orders]);
            jy_table(orders, &[z], &mut j, &mut y);
            let mut h = vec![Complex64::ZERO; orders];
            hankel_table(orders, &[Complex64::from(z)], &mut h);
            for n in 0..orders {
                let joined = h[n] * Complex64::cis(z);
                prop_assert!((joined - Complex64::new(j[n], y[n])).norm() < 1e-14 * joined.norm());
            }
        }
    }

    /// n, z, J_n(z), Y_n(z)
    #[rustfmt::skip]
    const JY: [(usize, f64, f64, f64); 8] = [
    (0, 25.0, 0.096_266_783_275_958_11, -0.127_249_432_268_006_14),
    (1, 25.0, -0.125_350_249_580_289_9, -0.098_829_964_783_237_41),
    (20, 25.0, 0.051_994_049_228_303_23, 0.198_040_747_762_892_43),
    (24, 25.0, 0.199_778_510_669_943_26, -0.179_658_076_056_343_82),
    (0, 60.5, -0.102_552_724_780_990_84, -0.002_284_801_030_573_988),
    (48, 60.5, -0.012_646_891_560_578_298, -0.130_720_312_809_094_05),
    (0, 10000.0, -0.007_096_160_353_388_801_5, 0.003_647_805_558_986_605_8),
    (59, 10000.0, -0.002_363_849_091_777_548, -0.007_620_715_366_296_334),
    ];

    /// n, Re z, Im z, and the parts of exp(-iz) H_n(z)
    #[rustfmt::skip]
    const H: [(usize, f64, f64, f64, f64); 7] = [
    (0, 25.0, 0.0, 0.112_261_591_331_799_94, -0.113_388_917_829_222_22),
    (1, 25.0, 0.5, -0.112_331_356_220_166_7, -0.113_454_185_747_189_99),
    (20, 25.0, 10.0, 3.484_907_499_933_714, -1.464_456_938_773_119),
    (0, 48.0, 48.0, 0.036_896_279_037_921_19, -0.089_401_182_030_414_49),
    (38, 48.0, 0.25, 0.143_951_322_163_687_9, -0.074_341_892_012_056_57),
    (30, 100.0, 700.0, -0.009_011_651_758_044_166, 0.055_573_282_117_524_41),
    (47, 1000.0, 1.0, -0.007_918_363_314_753_717, 0.024_000_692_230_027_123),
    ];

    #[test]
    fn known_values_of_the_second_kind() {
        for (n, z, exact_j, exact_y) in JY {
            let (mut j, mut y) = (vec![f64::NAN; n + 1], vec![f64::NAN; n + 1]);
            jy_table(n + 1, &[z], &mut j, &mut y);
            assert!(
                (j[n] - exact_j).hypot(y[n] - exact_y) < 1e-14 * exact_j.hypot(exact_y),
                "order {n} at {z}"
            );
        }
        for (n, x, y, re, im) in H {
            let mut h = vec![Complex64::ZERO; n + 1];
            hankel_table(n + 1, &[Complex64::new(x, y)], &mut h);
            let exact = Complex64::new(re, im);
            assert!((h[n] - exact).norm() < 1e-14 * exact.norm(), "order {n} at {x} + {y}i");
        }
    }

    #[test]
    fn deficit_keeps_its_digits() {
        let known = [
            (1.0e-8, -1.25e-17),
            (0.001, -1.249_999_947_916_667_7e-7),
            (0.1, -0.001_249_479_275_160_049),
            (1.0, -0.119_898_828_510_132_96),
            (1.999_9, -0.423_239_909_077_660_46),
            (2.0, -0.423_275_192_243_126_6),
            (3.5, -0.921_498_555_792_955_9),
            (24.0, -1.012_836_505_431_926_8),
            (26.0, -0.998_842_636_108_698_8),
            (1000.0, -0.999_990_543_376_185_9),
        ];
        for (z, exact) in known {
            assert!((jinc_deficit(z) / exact - 1.0).abs() < 1e-15, "at {z}");
            assert_eq!(jinc_deficit(-z), jinc_deficit(z));
        }
    }
}
