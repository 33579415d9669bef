//! What the recurrences of spherical functions begin with, and what they are compared with. Source: Abramowitz and Stegun 1964, 10.1.
use super::{Lanes, TINY};
use crate::numeric::trigonometry::sin_cos;
use crate::numeric::vector::LANES;

/// j_0, j_1, y_0 and y_1; of j_0 and j_1 the larger one to a few units of rounding.
#[inline(always)]
pub(super) fn starts(z: &Lanes) -> [Lanes; 4] {
    let (sin, cos) = sin_cos(z);
    let mut starts = [[0.0; LANES]; 4];
    for lane in 0..LANES {
        let over = 1.0 / z[lane];
        starts[0][lane] = sin[lane] * over;
        starts[1][lane] = (starts[0][lane] - cos[lane]) * over;
        starts[2][lane] = -cos[lane] * over;
        starts[3][lane] = (starts[2][lane] - sin[lane]) * over;
    }
    starts
}

/// The factors that scale the values of a downward recurrence, from the known values of the orders 0 and 1: the larger of the two is
/// compared, which is the value of order 0 next to z = 0.
#[inline(always)]
pub(super) fn factors(z: &Lanes, zeroth: &Lanes, first: &Lanes) -> Lanes {
    let [j0, j1, ..] = starts(z);
    std::array::from_fn(|lane| {
        if z[lane] < TINY {
            // j_0 is 1, and the only value that is not 0
            1.0 / zeroth[lane]
        } else if z[lane] < 1.0 || j0[lane].abs() >= j1[lane].abs() {
            j0[lane] / zeroth[lane]
        } else {
            j1[lane] / first[lane]
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::bessel::{Kind, Wanted, scaled_orders};

    /// j_3 in closed form.
    fn third(z: f64) -> f64 {
        (15.0 / z.powi(3) - 6.0 / z) * z.sin() / z - (15.0 / z.powi(2) - 1.0) * z.cos() / z
    }

    fn all(orders: usize, z: f64) -> Vec<f64> {
        let mut values = vec![0.0; orders];
        scaled_orders(orders, Wanted::ALL.of_kind(Kind::Spherical), &[z], 1.0, 1, &mut values);
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
        scaled_orders(50, Wanted::ALL.of_kind(Kind::Spherical), &arguments, 1.0, 7, &mut table);
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
}
