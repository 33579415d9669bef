//! Numbers with as many digits as their errors justify.

/// Number of digits that identify a double.
const ALL: i32 = 17;
/// Number of digits that rounding leaves alone.
const ROUNDED: usize = 12;

/// How many significant digits are shown at most; `None` for as many as are justified.
#[derive(Clone, Copy)]
pub(super) struct Digits(pub(super) Option<usize>);

impl Digits {
    /// A value and its absolute error, e.g. `0.7370 ± 2e-4`; all digits and no error if the error is not positive. Where fewer
    /// digits are wanted than it justifies, the error is left out.
    pub(super) fn with_error(self, value: f64, error: f64) -> String {
        if !(error > 0.0 && error.is_finite() && value.is_finite()) {
            return self.exact(value);
        }
        // the last digit shown stands where the first digit of the error does
        let last = exponent(error);
        let first = exponent(value);
        let digits = (first - last).clamp(0, ALL - 1) as usize;
        match self.0.map(|most| most.saturating_sub(1)).filter(|most| *most < digits) {
            Some(most) => fixed_or_scientific(value, first, most),
            None => format!("{} ± {error:.0e}", fixed_or_scientific(value, first, digits)),
        }
    }

    /// A value that may be infinite, and its absolute error.
    pub(super) fn or_infinite(self, value: f64, error: f64) -> String {
        if value.is_finite() { self.with_error(value, error) } else { "infinite".to_owned() }
    }

    /// A value without error.
    pub(super) fn exact(self, value: f64) -> String {
        self.0.map_or_else(|| plain(value), |most| to_digits(value, most))
    }

    /// A value to twelve digits: a number that differs from a round one by rounding only is printed as that one.
    pub(super) fn rounded(self, value: f64) -> String {
        to_digits(value, self.0.map_or(ROUNDED, |most| most.min(ROUNDED)))
    }
}

/// A value to so many significant digits, without zeros at its end.
pub(super) fn to_digits(value: f64, digits: usize) -> String {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().map_or_else(|_| plain(value), plain)
}

/// A value with all its digits.
pub(super) fn plain(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// `digits` after the first one.
fn fixed_or_scientific(value: f64, first: i32, digits: usize) -> String {
    let decimals = digits as i32 - first;
    if (-3..6).contains(&first) && decimals >= 0 {
        format!("{value:.0$}", decimals as usize)
    } else {
        format!("{value:.digits$e}")
    }
}

/// Power of ten of the first digit as it is printed with one digit.
fn exponent(value: f64) -> i32 {
    // rounding may carry: 9.7e-5 has one digit 1e-4
    let printed = format!("{value:.0e}");
    printed.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_says_how_many_digits_are_shown() {
        let with_error = |value, error| Digits(None).with_error(value, error);
        assert_eq!(with_error(0.737_012_345_6, 2.3e-4), "0.7370 ± 2e-4");
        assert_eq!(with_error(2.448_123_456_789_012, 1e-11), "2.44812345679 ± 1e-11");
        assert_eq!(with_error(0.1, 9.7e-5), "0.1000 ± 1e-4");
        assert_eq!(with_error(1.71e-9, 2e-12), "1.710e-9 ± 2e-12");
        assert_eq!(with_error(123_456.7, 20.0), "1.2346e5 ± 2e1");
        assert_eq!(with_error(1.5, 1e-30), "1.5000000000000000 ± 1e-30");
        assert_eq!(with_error(1e-3, 5.0), "0.001 ± 5e0");
        assert_eq!(with_error(0.5, 0.0), "0.5");
        assert_eq!(with_error(f64::NAN, 1.0), "NaN");
        assert_eq!(with_error(1.0, f64::INFINITY), "1");
    }

    #[test]
    fn numbers_far_from_one_are_written_with_exponent() {
        assert_eq!(plain(0.002), "0.002");
        assert_eq!(plain(1e-9), "1e-9");
        assert_eq!(plain(-2.5e300), "-2.5e300");
        assert_eq!(plain(0.0), "0");
        let rounded = |value| Digits(None).rounded(value);
        assert_eq!(rounded(0.0019999999999999996), "0.002");
        assert_eq!(rounded(f64::INFINITY), "inf");
    }

    #[test]
    fn no_more_digits_are_shown_than_are_wanted() {
        let four = Digits(Some(4));
        assert_eq!(four.with_error(0.737_012_345_6, 2.3e-9), "0.7370");
        assert_eq!(four.with_error(0.737_012_345_6, 2.3e-2), "0.74 ± 2e-2");
        assert_eq!(four.with_error(1.71e-9, 2e-17), "1.710e-9");
        assert_eq!((four.exact(500.0), four.rounded(2.0 / 3.0)), ("500".into(), "0.6667".into()));
    }
}
