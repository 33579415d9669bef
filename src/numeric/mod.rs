//! Numerical analysis without mechanics: Bessel functions, quadrature, interpolation.

pub mod bessel;
pub mod chebyshev;
pub(crate) mod means;
pub mod quadrature;
pub(crate) mod search;
pub(crate) mod trigonometry;
pub(crate) mod vector;
pub(crate) mod waves;
pub(crate) mod workspace;

/// Σ a_i b_i.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The largest of non-negative numbers, 0 if there are none; NaN if any of them is: an error that is not known is no small
/// one, as it would be with [`f64::max`], which passes over NaN.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values
        .into_iter()
        .fold(0.0, |most: f64, value| if value.is_nan() || most.is_nan() { f64::NAN } else { most.max(value) })
}

/// The largest absolute value; what is no number counts as larger than any: a step of that kind leads nowhere.
pub fn longest(values: impl IntoIterator<Item = f64>) -> f64 {
    values
        .into_iter()
        .fold(0.0, |longest: f64, value| if value.is_nan() { f64::INFINITY } else { longest.max(value.abs()) })
}

#[cfg(test)]
mod tests {
    use super::largest;

    #[test]
    fn what_is_no_number_is_not_passed_over() {
        assert_eq!(largest([]), 0.0);
        assert_eq!(largest([0.5, f64::INFINITY]), f64::INFINITY);
        for values in [[f64::NAN, 1.0], [1.0, f64::NAN], [f64::NAN, f64::INFINITY]] {
            assert!(largest(values).is_nan());
        }
    }
}
