//! Bessel functions of integer order, and spherical ones, for many orders and arguments at once.
//!
//! Spherical functions j_n(z) = √(π/2z) J_(n+1/2)(z) belong to axisymmetric problems: their recurrences are the same with orders larger by
//! 1/2, and the first two have closed forms.
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
//! Source: Abramowitz and Stegun 1964, 9.1.27, 9.1.46, 9.2.5-9.2.10, 9.3.2, 9.12, 10.1.

mod minus_one;
mod spherical;
mod start;

use num_complex::Complex64;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_PI};
use std::ops::{Mul, Sub};

pub use minus_one::{
    INTEGRAL_FROM, integral, jinc_minus_one, jinc_minus_one_from, of_order_minus_one, sinc_minus_one,
    spherical_jinc_minus_one,
};
use start::start_orders;

use super::trigonometry::sin_cos;
use super::vector::{LANES, Lanes, vectorised};

/// Arguments from here on may use Hankel's expansion: its smallest term is far below rounding.
pub const ASYMPTOTIC_FROM: f64 = 25.0;

/// Which functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// J_n and Y_n.
    Integer,
    /// j_n and y_n.
    Spherical,
}

impl Kind {
    /// By how much orders in the recurrence are larger.
    const fn shift(self) -> f64 {
        match self {
            Self::Integer => 0.0,
            Self::Spherical => 0.5,
        }
    }
}

/// Functions whose order is above z + BEYOND z^(1/3) + BEYOND are below 1e-24, by Airy's function at 19: far below what rounding does to the others.
const BEYOND: f64 = 15.0;

/// Arguments below this differ from zero in J1 alone, which is then negligible as well.
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
pub fn table(orders: usize, arguments: &[f64], out: &mut [f64]) {
    assert_eq!(out.len(), orders * arguments.len(), "a Bessel table holds one value per order and argument");
    scaled_orders(orders, Wanted::ALL, arguments, 1.0, arguments.len(), out);
}

/// The number of orders that count at all arguments up to z.
pub fn orders_up_to(z: f64) -> usize {
    (z + BEYOND * (z.cbrt() + 1.0)) as usize + 1
}

/// As [`table`], of the orders below `orders` only those that are `wanted`, one after the other, into the first rows of a matrix with more rows:
/// `factor` J_n(z_i) of the order in the place k among these goes to `out[k * stride + i]`.
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
        || {
            let upward_from = ASYMPTOTIC_FROM.max(orders as f64);
            let mut rows: Vec<Lanes> = Vec::new();
            for block in (0..arguments.len()).step_by(LANES) {
                // the last block is a whole one as well, if there are as many arguments
                let first = block.min(arguments.len().saturating_sub(LANES));
                let block = &arguments[first..arguments.len().min(first + LANES)];
                let mut z = [0.0; LANES];
                z[..block.len()].copy_from_slice(block);
                let mut window = Window { first, width: block.len(), stride, wanted, out };
                let far = z.map(|z| z >= upward_from);
                let count = far.iter().filter(|far| **far).count();
                if count < block.len() {
                    let near = std::array::from_fn(|lane| if far[lane] { 0.0 } else { z[lane] });
                    let scale = downward(wanted.kind, orders, &near, &mut rows).map(|scale| factor * scale);
                    window.store(&rows[..orders], &scale, far.map(|far| !far));
                }
                if count > 0 {
                    upward(wanted.kind, orders, &z, &mut rows);
                    window.store(&rows[..orders], &[factor; LANES], far);
                }
            }
        },
    );
}

/// Which functions of a table are wanted: of integer order, unless [`Self::of_kind`] says otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    kind: Kind,
    step: usize,
}

impl Wanted {
    /// 0, 1, 2, ...
    pub const ALL: Self = Self { kind: Kind::Integer, step: 1 };
    /// 0, 1, 3, 5, ...: all others are sums of two of these, by J_(n−1) + J_(n+1) = (2n/z) J_n.
    pub const ZERO_AND_ODD: Self = Self { kind: Kind::Integer, step: 2 };

    /// The same orders of other functions.
    pub const fn of_kind(self, kind: Kind) -> Self {
        Self { kind, ..self }
    }

    /// Of which kind they are.
    pub fn kind(self) -> Kind {
        self.kind
    }

    /// How many of them are below `orders`.
    pub fn below(self, orders: usize) -> usize {
        orders.min(1) + orders.saturating_sub(1).div_ceil(self.step)
    }

    /// These of all `rows`.
    pub fn of<T>(self, rows: &[T]) -> impl Iterator<Item = &T> {
        rows.iter().take(1).chain(rows.iter().skip(1).step_by(self.step))
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
    fn store(&mut self, rows: &[Lanes], scale: &Lanes, lanes: [bool; LANES]) {
        let whole = self.width == LANES && lanes == [true; LANES];
        let (mut n, mut place) = (0, self.first);
        while n < rows.len() {
            let (row, column) = (&rows[n], &mut self.out[place..place + self.width]);
            if let (true, Ok(column)) = (whole, <&mut Lanes>::try_from(&mut *column)) {
                *column = std::array::from_fn(|lane| row[lane] * scale[lane]);
            } else {
                for (lane, value) in column.iter_mut().enumerate().filter(|(lane, _)| lanes[*lane]) {
                    *value = row[lane] * scale[lane];
                }
            }
            n += if n == 0 { 1 } else { self.wanted.step };
            place += self.stride;
        }
    }
}

/// Miller's recurrence: fills `rows[n]` (n = 0..orders at least) up to a factor per lane, and returns that factor.
#[inline(always)]
fn downward(kind: Kind, orders: usize, z: &Lanes, rows: &mut Vec<Lanes>) -> Lanes {
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
        (above, here, sum) = descend(&mut rows[next + 1..=n], n, kind.shift(), &two_over_z, (above, here, sum));
        if n == 0 {
            break;
        }
        n = next;
    }
    rows[0] = here;
    if kind == Kind::Spherical {
        return spherical::factors(z, &here, &above);
    }
    std::array::from_fn(|lane| 1.0 / (2.0 * sum[lane] + here[lane]))
}

/// Goes down from order `n` (+ `shift`) through as many rows: values of the order above, of this one, and the sum of even orders.
#[inline(always)]
fn descend(
    rows: &mut [Lanes],
    n: usize,
    shift: f64,
    two_over_z: &Lanes,
    start: (Lanes, Lanes, Lanes),
) -> (Lanes, Lanes, Lanes) {
    let (mut above, mut here, mut sum) = start;
    let mut order = n as f64 + shift;
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

/// Forward recurrence from Hankel's expansion or, of spherical functions, from closed forms: fills `rows[n]`, n = 0..orders.
#[inline(always)]
fn upward(kind: Kind, orders: usize, z: &Lanes, rows: &mut Vec<Lanes>) {
    if rows.len() < orders {
        rows.resize(orders, [0.0; LANES]);
    }
    let z = z.map(|z| z.max(ASYMPTOTIC_FROM));
    let [mut below, mut here, ..] = starts(kind, &z);
    let mut order = 1.0 + kind.shift();
    let two_over_z = z.map(|z| 2.0 / z);
    for row in &mut rows[..orders] {
        *row = below;
        let above: Lanes = std::array::from_fn(|lane| order * two_over_z[lane] * here[lane] - below[lane]);
        below = here;
        here = above;
        order += 1.0;
    }
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

/// J0, J1, Y0 and Y1, or their spherical twins, at real arguments of at least `ASYMPTOTIC_FROM`.
#[inline(always)]
fn starts(kind: Kind, z: &Lanes) -> [Lanes; 4] {
    if kind == Kind::Spherical {
        return spherical::starts(z);
    }
    let (sin, cos) = sin_cos(z);
    let mut starts = [[0.0; LANES]; 4];
    for lane in 0..LANES {
        let w = 1.0 / z[lane];
        let square = w * w;
        let [mut p0, mut q0, mut p1, mut q1] = [0.0; 4];
        for k in (0..TERMS).rev() {
            p0 = p0 * square + P0[k];
            q0 = q0 * square + Q0[k];
            p1 = p1 * square + P1[k];
            q1 = q1 * square + Q1[k];
        }
        // sqrt(2/(pi z)) times cosine and sine of z - pi/4
        let amplitude = (FRAC_2_PI * w).sqrt() * FRAC_1_SQRT_2;
        let (c, s) = (amplitude * (sin[lane] + cos[lane]), amplitude * (sin[lane] - cos[lane]));
        starts[0][lane] = p0 * c - w * q0 * s;
        starts[1][lane] = p1 * s + w * q1 * c;
        starts[2][lane] = p0 * s + w * q0 * c;
        starts[3][lane] = w * q1 * s - p1 * c;
    }
    starts
}

/// Functions of both kinds, J_n(z) and Y_n(z), for n = 0..`orders` at real arguments z >= 25 with `orders` <= z, laid out as in [`table`].
///
/// The modulus |J + iY| is right to about 1e-14 of itself for n <= 0.8 z.
///
/// # Panics
/// If `j` or `y` is not `orders` times as long as `arguments`.
pub fn jy_table(kind: Kind, orders: usize, arguments: &[f64], j: &mut [f64], y: &mut [f64]) {
    let length = arguments.len();
    assert_eq!((j.len(), y.len()), (orders * length, orders * length), "one value per order and argument");
    let two_over_z: Vec<f64> = arguments.iter().map(|z| 2.0 / z).collect();
    vectorised(
        #[inline(always)]
        || {
            for (block, some) in arguments.chunks(LANES).enumerate() {
                let mut z = [ASYMPTOTIC_FROM; LANES];
                z[..some.len()].copy_from_slice(some);
                let [j0, j1, y0, y1] = starts(kind, &z);
                for (table, starts) in [(&mut *j, [j0, j1]), (&mut *y, [y0, y1])] {
                    for (column, start) in table.chunks_exact_mut(length).zip(starts) {
                        column[block * LANES..][..some.len()].copy_from_slice(&start[..some.len()]);
                    }
                }
            }
            recur_upward(kind.shift(), &two_over_z, j);
            recur_upward(kind.shift(), &two_over_z, y);
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
pub fn hankel_table(kind: Kind, orders: usize, arguments: &[Complex64], out: &mut [Complex64]) {
    let length = arguments.len();
    assert_eq!(out.len(), orders * length, "one value per order and argument");
    let mut two_over_z = Vec::with_capacity(length);
    for (i, &z) in arguments.iter().enumerate() {
        let w = z.inv();
        let start = match kind {
            Kind::Integer => start_hankel(w),
            Kind::Spherical => [-Complex64::I * w, -(w + Complex64::I * w * w)],
        };
        for (n, start) in start.into_iter().enumerate().take(orders) {
            out[n * length + i] = start;
        }
        two_over_z.push(2.0 * w);
    }
    vectorised(
        #[inline(always)]
        || recur_upward(kind.shift(), &two_over_z, out),
    );
}

/// exp(-iz) H_0(z) and exp(-iz) H_1(z), w = 1/z.
fn start_hankel(w: Complex64) -> [Complex64; 2] {
    let square = w * w;
    let sum = |c: &[f64; TERMS]| c.iter().rev().fold(Complex64::ZERO, |s, c| s * square + c);
    let amplitude = (FRAC_2_PI * w).sqrt() * FRAC_1_SQRT_2;
    // exp(-i pi/4) = (1 - i)/sqrt(2), exp(-3i pi/4) = (-1 - i)/sqrt(2)
    [
        amplitude * Complex64::new(1.0, -1.0) * (sum(&P0) + Complex64::I * w * sum(&Q0)),
        amplitude * Complex64::new(-1.0, -1.0) * (sum(&P1) + Complex64::I * w * sum(&Q1)),
    ]
}

/// Completes a table whose orders 0 and 1 are given.
#[inline(always)]
fn recur_upward<T>(shift: f64, two_over_z: &[T], table: &mut [T])
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
            *new = factor * (n as f64 + shift) * here - below;
        }
    }
}

#[cfg(test)]
mod tests;
