//! The largest of some numbers, where what is no number must not be passed over.

/// The largest of non-negative numbers, 0 if there are none; NaN if any of them is: an error that is not known is no small
/// one, as it would be with [`f64::max`], which passes over NaN.
///
/// ```
/// use recede::numeric::largest;
/// assert_eq!(largest([1.0, 3.0, 2.0]), 3.0);
/// assert!(largest([1.0, f64::NAN, 2.0]).is_nan());
/// ```
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values
        .into_iter()
        .fold(0.0, |most: f64, value| if value.is_nan() || most.is_nan() { f64::NAN } else { most.max(value) })
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
