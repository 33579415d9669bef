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

mod deficit;

use num_complex::Complex64;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_PI, LN_2};
use std::ops::{Mul, Sub};

pub use deficit::{jinc_deficit, jinc_deficit_from, sinc_deficit, spherical_jinc_deficit};

use super::vector::vectorised;

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
    assert_eq!(out.len(), orders * arguments.len(), "a Bessel table holds one value per order and argument");
    scaled_table(orders, arguments, 1.0, arguments.len(), out);
}

/// As [`table`], into the first rows of a matrix with more rows: `factor` J_n(z_i) goes to `out[n * stride + i]`.
///
/// # Panics
/// If `stride` is less than the number of arguments, or `out` too short.
pub fn scaled_table(orders: usize, arguments: &[f64], factor: f64, stride: usize, out: &mut [f64]) {
    scaled_orders(orders, Wanted::ALL, arguments, factor, stride, out);
}

/// As [`scaled_table`], with the same values, but of the orders below `orders` only those that are `wanted`, one after
/// the other.
///
/// # Panics
/// If `stride` is less than the number of arguments, or `out` too short.
pub fn scaled_orders(orders: usize, wanted: Wanted, arguments: &[f64], factor: f64, stride: usize, out: &mut [f64]) {
    let columns = wanted.below(orders);
    if columns == 0 || arguments.is_empty() {
        return;
    }
    assert!(arguments.len() <= stride && (columns - 1) * stride + arguments.len() <= out.len(), "the table fits");
    vectorised(
        #[inline(always)]
        || fill(orders, wanted, arguments, factor, stride, out),
    );
}

/// Which orders of a table are wanted: the first of them, and every so many from there on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    first: usize,
    step: usize,
}

impl Wanted {
    /// 0, 1, 2, ...
    pub const ALL: Self = Self { first: 0, step: 1 };
    /// 0, 2, 4, ...
    pub const EVEN: Self = Self { first: 0, step: 2 };
    /// 1, 3, 5, ...
    pub const ODD: Self = Self { first: 1, step: 2 };

    /// How many of them are below `orders`.
    pub fn below(self, orders: usize) -> usize {
        orders.saturating_sub(self.first).div_ceil(self.step)
    }

    /// These of all `rows`.
    pub fn of<T>(self, rows: &[T]) -> impl Iterator<Item = &T> {
        rows.iter().skip(self.first).step_by(self.step)
    }
}

#[inline(always)]
fn fill(orders: usize, wanted: Wanted, arguments: &[f64], factor: f64, stride: usize, out: &mut [f64]) {
    let upward_from = ASYMPTOTIC_FROM.max(orders as f64);
    let mut rows: Vec<Lanes> = Vec::new();
    for first in (0..arguments.len()).step_by(LANES) {
        let block = &arguments[first..arguments.len().min(first + LANES)];
        let mut z = [0.0; LANES];
        z[..block.len()].copy_from_slice(block);
        let mut window = Window { first, width: block.len(), stride, wanted, out };
        let far = z.map(|z| z >= upward_from);
        match far[..block.len()].iter().filter(|&&far| far).count() {
            0 => {
                let scale = downward(orders, &z, &mut rows).map(|scale| factor * scale);
                window.store(&rows[..orders], &scale, |_| true);
            }
            all if all == block.len() => {
                upward(orders, &z, &mut rows);
                window.store(&rows[..orders], &[factor; LANES], |_| true);
            }
            _ => {
                let near = std::array::from_fn(|lane| if far[lane] { 0.0 } else { z[lane] });
                let scale = downward(orders, &near, &mut rows).map(|scale| factor * scale);
                window.store(&rows[..orders], &scale, |lane| !far[lane]);
                upward(orders, &z, &mut rows);
                window.store(&rows[..orders], &[factor; LANES], |lane| far[lane]);
            }
        }
    }
}

/// The part of a table that belongs to one block of arguments.
struct Window<'a> {
    first: usize,
    width: usize,
    stride: usize,
    wanted: Wanted,
    out: &'a mut [f64],
}

impl Window<'_> {
    /// Writes `rows * scale` of the orders wanted for some lanes.
    #[inline(always)]
    fn store(&mut self, rows: &[Lanes], scale: &Lanes, lanes: impl Fn(usize) -> bool) {
        let whole = self.width == LANES && (0..LANES).all(&lanes);
        for (row, column) in self.wanted.of(rows).zip(self.out.chunks_mut(self.stride)) {
            let column = &mut column[self.first..self.first + self.width];
            match <&mut Lanes>::try_from(&mut *column) {
                Ok(column) if whole => *column = std::array::from_fn(|lane| row[lane] * scale[lane]),
                _ => {
                    for (lane, value) in column.iter_mut().enumerate().filter(|(lane, _)| lanes(*lane)) {
                        *value = row[lane] * scale[lane];
                    }
                }
            }
        }
    }
}

/// Miller's recurrence: fills `rows[n]` (n = 0..orders at least) up to a factor per lane, and returns that factor.
#[inline(always)]
fn downward(orders: usize, z: &Lanes, rows: &mut Vec<Lanes>) -> Lanes {
    let starts = start_orders(z, orders);
    let two_over_z = z.map(|z| if z < TINY { 0.0 } else { 2.0 / z });
    let highest = starts.iter().copied().max().unwrap_or(0);
    if rows.len() < orders.max(highest + 1) {
        rows.resize(orders.max(highest + 1), [0.0; LANES]);
    }
    rows[orders.min(highest + 1)..orders].fill([0.0; LANES]);

    let (mut above, mut here, mut sum) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
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
        (above, here, sum) = descend(&mut rows[next + 1..=n], n, &two_over_z, (above, here, sum));
        if n == 0 {
            break;
        }
        n = next;
    }
    rows[0] = here;
    std::array::from_fn(|lane| 1.0 / (2.0 * sum[lane] + here[lane]))
}

/// Goes down from order `n` through as many rows: values of the order above, of this one, and the sum of even orders.
#[inline(always)]
fn descend(rows: &mut [Lanes], n: usize, two_over_z: &Lanes, start: (Lanes, Lanes, Lanes)) -> (Lanes, Lanes, Lanes) {
    let (mut above, mut here, mut sum) = start;
    let mut order = n as f64;
    let single = rows.len() % 2;
    let (lower, top) = rows.split_at_mut(rows.len() - single);
    for row in top {
        let mut below = [0.0; LANES];
        for lane in 0..LANES {
            row[lane] = here[lane];
            below[lane] = order * two_over_z[lane] * here[lane] - above[lane];
        }
        for lane in 0..LANES {
            sum[lane] += if n.is_multiple_of(2) { here[lane] } else { 0.0 };
        }
        (above, here) = (here, below);
        order -= 1.0;
    }
    let even = (n - single).is_multiple_of(2);
    for pair in lower.rchunks_exact_mut(2) {
        let [mut below, mut next] = [[0.0; LANES]; 2];
        for lane in 0..LANES {
            below[lane] = order * two_over_z[lane] * here[lane] - above[lane];
            next[lane] = (order - 1.0) * two_over_z[lane] * below[lane] - here[lane];
            sum[lane] += if even { here[lane] } else { below[lane] };
            pair[1][lane] = here[lane];
            pair[0][lane] = below[lane];
        }
        (above, here) = (below, next);
        order -= 2.0;
    }
    (above, here, sum)
}

/// Forward recurrence from Hankel's expansion: fills `rows[n]`, n = 0..orders.
#[inline(always)]
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

/// Where each lane may start: all with the largest argument, unless the smallest would overflow from there.
fn start_orders(z: &Lanes, orders: usize) -> [usize; LANES] {
    let (least, most) = z.iter().fold((f64::INFINITY, 0.0), |(least, most), &z| (z.min(least), z.max(most)));
    let together = start_order(most, orders);
    let m = together as f64;
    if least >= TINY && together > 1 && depth(m, least, (m / least).acosh()) < DEEPEST {
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
        let cbrt = z.cbrt();
        guard = guard.min(7.6 * cbrt + 3.0);
        enough = z + 11.5 * cbrt + 3.0;
    }
    let mut m = (n + guard).max(enough) + 1.0;

    // J_m, about exp(-m (A - tanh A)) with cosh A = m/z, must not be too small. The exponent is convex in m and has the
    // derivative A: Newton's method from above stays above.
    let depth = |m: f64, angle: f64| depth(m, z, angle);
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
        Self { j0: p0 * c - q0 * s, j1: p1 * s + q1 * c, y0: p0 * s + q0 * c, y1: q1 * s - p1 * c }
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
    assert_eq!((j.len(), y.len()), (orders * length, orders * length), "one value per order and argument");
    let two_over_z: Vec<f64> = arguments.iter().map(|z| 2.0 / z).collect();
    for (i, &z) in arguments.iter().enumerate() {
        let s = StartReal::at(z);
        for (table, start) in [(&mut *j, [s.j0, s.j1]), (&mut *y, [s.y0, s.y1])] {
            for (n, start) in start.into_iter().enumerate().take(orders) {
                table[n * length + i] = start;
            }
        }
    }
    vectorised(
        #[inline(always)]
        || {
            recur_upward(&two_over_z, j);
            recur_upward(&two_over_z, y);
        },
    );
}

/// exp(-iz) H_n(z), H the Hankel function of the first kind, for n = 0..`orders`, laid out as in [`table`].
///
/// For arguments with Re z >= 25, `orders` <= Re z and Im z >= 0. The factor takes out the decay exp(-Im z). On the
/// real axis the result times exp(iz) is J + iY. Relative error about 1e-14 for n <= 0.8 Re z.
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
    vectorised(
        #[inline(always)]
        || recur_upward(&two_over_z, out),
    );
}

/// Completes a table whose orders 0 and 1 are given.
#[inline(always)]
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

#[cfg(test)]
mod tests;
