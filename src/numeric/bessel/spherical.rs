//! Spherical Bessel functions of many orders, for axisymmetric problems: j_n(z) = √(π/2z) J_(n+1/2)(z).
//!
//! The recurrences are those of [`super`] with orders larger by 1/2, and the first two functions have closed forms. Source: Abramowitz and
//! Stegun 1964, 10.1.
use num_complex::Complex64;

use super::{Lanes, TINY, Wanted, fill};
use crate::numeric::trigonometry::sin_cos;
use crate::numeric::vector::{LANES, vectorised};

/// As [`super::scaled_orders`]: `factor` j_n(z_i) for the orders that are `wanted`, one after the other.
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
        || fill::<true>(orders, wanted, arguments, factor, stride, out),
    );
}

/// j_0 and, where it is the larger one, j_1, to a few units of rounding.
#[inline(always)]
pub(super) fn firsts(z: &Lanes) -> [Lanes; 2] {
    let (sin, cos) = sin_cos(z);
    let mut firsts = [[0.0; LANES]; 2];
    for lane in 0..LANES {
        let over = 1.0 / z[lane];
        firsts[0][lane] = sin[lane] * over;
        firsts[1][lane] = (firsts[0][lane] - cos[lane]) * over;
    }
    firsts
}

/// What the values of a downward recurrence are to be multiplied by, from those of the orders 0 and 1: the larger one of both is compared, which is that of order 0 next to z = 0.
#[inline(always)]
pub(super) fn factors(z: &Lanes, zeroth: &Lanes, first: &Lanes) -> Lanes {
    let firsts = firsts(z);
    std::array::from_fn(|lane| {
        if z[lane] < TINY {
            // j_0 is 1, and the only value that is not 0
            1.0 / zeroth[lane]
        } else if z[lane] < 1.0 || firsts[0][lane].abs() >= firsts[1][lane].abs() {
            firsts[0][lane] / zeroth[lane]
        } else {
            firsts[1][lane] / first[lane]
        }
    })
}

fn upwards(over: f64, first: [f64; 2], values: &mut [f64]) {
    let [mut before, mut here] = first;
    for (n, value) in values.iter_mut().enumerate() {
        *value = before;
        (before, here) = (here, (2 * n + 3) as f64 * over * here - before);
    }
}

/// j_n and y_n at arguments above all orders, as [`super::jy_table`].
pub fn jy_table(orders: usize, arguments: &[f64], j: &mut [f64], y: &mut [f64]) {
    let (count, mut values) = (arguments.len(), vec![0.0; orders]);
    for (i, z) in arguments.iter().enumerate() {
        let (sin, cos) = z.sin_cos();
        let over = z.recip();
        let firsts = [[sin * over, (sin * over - cos) * over], [-cos * over, -(cos * over + sin) * over]];
        for (first, out) in firsts.into_iter().zip([&mut *j, &mut *y]) {
            upwards(over, first, &mut values);
            values.iter().enumerate().for_each(|(n, value)| out[n * count + i] = *value);
        }
    }
}

/// exp(−iz) h_n(z), h = j + i y, at arguments above all orders, as [`super::hankel_table`].
pub fn hankel_table(orders: usize, arguments: &[Complex64], out: &mut [Complex64]) {
    let count = arguments.len();
    for (i, z) in arguments.iter().enumerate() {
        let over = z.inv();
        let (mut before, mut here) = (-Complex64::I * over, -(over + Complex64::I * over * over));
        for n in 0..orders {
            out[n * count + i] = before;
            (before, here) = (here, (2 * n + 3) as f64 * over * here - before);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// j_3 in closed form.
    fn third(z: f64) -> f64 {
        (15.0 / z.powi(3) - 6.0 / z) * z.sin() / z - (15.0 / z.powi(2) - 1.0) * z.cos() / z
    }

    fn all(orders: usize, z: f64) -> Vec<f64> {
        let mut values = vec![0.0; orders];
        scaled_orders(orders, Wanted::ALL, &[z], 1.0, 1, &mut values);
        values
    }

    #[test]
    fn functions_next_to_zero_are_powers() {
        let powers = |z: f64| [1.0, z / 3.0, z * z / 15.0, z * z * z / 105.0];
        for z in [0.0, 1e-295, 1e-200, 1e-80].into_iter().chain((8..60).map(|k| 10f64.powi(-k))) {
            for (found, expected) in all(60, z).into_iter().zip(powers(z)) {
                assert!((found - expected).abs() <= 1e-15 * expected + TINY, "{z:e}: {found:e} {expected:e}");
            }
        }
        // one table for arguments that differ by hundreds of orders of magnitude
        let (arguments, mut table) = ([0.0, 1e-150, 1e-30, 0.1, 3.0, 40.0, 900.0], [0.0; 7 * 50]);
        scaled_orders(50, Wanted::ALL, &arguments, 1.0, 7, &mut table);
        for (i, z) in arguments.into_iter().enumerate() {
            for (n, expected) in all(50, z).into_iter().enumerate() {
                let found = table[7 * n + i];
                assert!(
                    (found - expected).abs() <= 1e-13 * expected.abs() + 1e-16,
                    "{z:e} {n}: {found:e} {expected:e}"
                );
            }
        }
    }

    #[test]
    fn functions_are_those_of_closed_forms_and_of_series() {
        for z in [0.5, 1.0, 2.7, 6.0, 30.0, 200.0] {
            for orders in [5, 40, 300] {
                let values = all(orders, z);
                assert!((values[3] - third(z)).abs() < 1e-13 / z.min(1.0), "{z} {orders}: {} {}", values[3], third(z));
                // Σ (2n + 1) j_n² = 1, as far as the orders reach
                let sum: f64 = values.iter().enumerate().map(|(n, j)| (2 * n + 1) as f64 * j * j).sum();
                assert!(orders as f64 <= z + 20.0 || (sum - 1.0).abs() < 1e-13, "{z} {orders}: {sum}");
            }
        }
        let values = all(4, 1e-3);
        assert!((values[2] / (1e-6 / 15.0) - 1.0).abs() < 1e-6 && (values[3] / (1e-9 / 105.0) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn functions_of_the_third_kind_are_those_of_the_first_two() {
        let (z, orders) = (60.0, 40);
        let (mut j, mut y, mut h) = (vec![0.0; orders], vec![0.0; orders], vec![Complex64::ZERO; orders]);
        jy_table(orders, &[z], &mut j, &mut y);
        hankel_table(orders, &[Complex64::new(z, 0.0)], &mut h);
        for n in 0..orders {
            let whole = h[n] * Complex64::cis(z);
            assert!((whole - Complex64::new(j[n], y[n])).norm() < 1e-14 * whole.norm().max(1.0), "{n}");
        }
    }
}
