//! Spherical Bessel functions of many orders, for axisymmetric problems: j_n(z) = √(π/2z) J_(n+1/2)(z).
//!
//! The recurrence f_(n+1) = (2n + 1)/z f_n − f_(n−1) is run upwards from closed forms where the argument is above the orders, and
//! downwards and normalised by one of these (Miller) where it is not. Source: Abramowitz and Stegun 1964, 10.1.
use num_complex::Complex64;

use super::Wanted;

/// Arguments below this differ from zero in j_1 alone, which is then negligible as well.
const TINY: f64 = 1e-150;
/// Where the downward recurrence starts, and by what it is divided where it has grown beyond that.
const SEED: f64 = 1e-250;
const LARGE: f64 = 1e200;
/// Functions of orders above z + ABOVE z^(1/3) + SPARE are below rounding.
const ABOVE: f64 = 10.0;
const SPARE: usize = 20;

/// As [`super::scaled_orders`]: `factor` j_n(z_i) for the orders that are `wanted`, one after the other.
pub fn scaled_orders(orders: usize, wanted: Wanted, arguments: &[f64], factor: f64, stride: usize, out: &mut [f64]) {
    let mut values = vec![0.0; orders];
    for (i, z) in arguments.iter().enumerate() {
        fill(*z, &mut values);
        for (column, value) in wanted.of(&values).enumerate() {
            out[column * stride + i] = factor * value;
        }
    }
}

/// j_n(z) for all orders of `values`.
fn fill(z: f64, values: &mut [f64]) {
    let orders = values.len();
    if z < TINY {
        values.fill(0.0);
        values.iter_mut().take(1).for_each(|first| *first = 1.0);
        return;
    }
    let (sin, cos) = z.sin_cos();
    let first = [sin / z, (sin / z - cos) / z];
    if z > orders as f64 {
        upwards(z.recip(), first, values);
        return;
    }
    let most = z.max(orders as f64);
    let start = most as usize + (ABOVE * most.cbrt()) as usize + SPARE;
    let (mut above, mut here) = (0.0, SEED);
    let over = z.recip();
    for n in (0..start).rev() {
        let below = (2 * n + 3) as f64 * over * here - above;
        (above, here) = (here, below);
        if n < orders {
            values[n] = here;
        }
        if here.abs() > LARGE {
            (above, here) = (above / LARGE, here / LARGE);
            values.iter_mut().skip(n).for_each(|value| *value /= LARGE);
        }
    }
    // the loop ends with the orders 0, here, and 1, above; the larger one of both is compared
    let factor = if first[0].abs() >= first[1].abs() { first[0] / here } else { first[1] / above };
    values.iter_mut().for_each(|value| *value *= factor);
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

    #[test]
    fn functions_are_those_of_closed_forms_and_of_series() {
        for z in [0.5, 1.0, 2.7, 6.0, 30.0, 200.0] {
            for orders in [5, 40, 300] {
                let mut values = vec![0.0; orders];
                fill(z, &mut values);
                assert!((values[3] - third(z)).abs() < 1e-13 / z.min(1.0), "{z} {orders}: {} {}", values[3], third(z));
                // Σ (2n + 1) j_n² = 1, as far as the orders reach
                let sum: f64 = values.iter().enumerate().map(|(n, j)| (2 * n + 1) as f64 * j * j).sum();
                assert!(orders as f64 <= z + 20.0 || (sum - 1.0).abs() < 1e-13, "{z} {orders}: {sum}");
            }
        }
        let mut values = vec![0.0; 4];
        fill(1e-3, &mut values);
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
