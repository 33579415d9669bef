//! Decimal numbers: the one that a reader of a number sees, and exact values between two of them.

/// Integers up to this can be multiplied by numbers of values up to 1e8, and added, within 128 bits: 8.5e29.
const LARGEST: i128 = i128::MAX / 200_000_000;
/// Digits after the point that are handed to the reader of decimals, which rounds correctly; whatever lies beyond is one
/// digit more. With 22 or more before the point there are three times as many as a double has.
const AFTER: u32 = 30;

/// digits · 10^exponent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Decimal {
    pub(super) digits: i128,
    pub(super) exponent: i32,
}

impl Decimal {
    /// The shortest decimal that is read as this finite number: what was written, if it has at most 15 digits.
    pub(super) fn of(value: f64) -> Self {
        let text = format!("{value:e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let after = digits.split_once('.').map_or(0, |(_, after)| after.len() as i32);
        let digits = digits.replace('.', "").parse().unwrap_or(0);
        Self { digits, exponent: exponent.parse().unwrap_or(0) - after }
    }

    /// The number nearest to it.
    pub(super) fn nearest(self) -> f64 {
        format!("{}e{}", self.digits, self.exponent).parse().unwrap_or(f64::NAN)
    }

    /// The digits in units of 10^exponent, smaller ones cut off.
    fn in_units(self, exponent: i32) -> i128 {
        let power = |shift: i32| 10i128.checked_pow(shift.unsigned_abs());
        match self.exponent - exponent {
            shift if shift < 0 => power(shift).map_or(0, |power| self.digits / power),
            shift => power(shift).map_or(0, |power| self.digits * power),
        }
    }

    /// The lowest exponent with which its digits are at most [`LARGEST`].
    fn lowest_exponent(self) -> i32 {
        let Some(room) = LARGEST.checked_div(self.digits.abs()) else { return i32::MIN };
        self.exponent - room.ilog10() as i32
    }
}

/// The number nearest to (start (last − index) + stop index)/last, where `start` and `stop` are the decimals that one reads.
pub(super) fn linear(start: f64, stop: f64, index: usize, last: usize) -> f64 {
    let (start, stop) = (Decimal::of(start), Decimal::of(stop));
    // a number 1e29 times smaller than the other end is below its last digit
    let exponent = start.lowest_exponent().max(stop.lowest_exponent());
    if exponent == i32::MIN {
        return 0.0;
    }
    let (last, index) = (last as i128, index as i128);
    let sum = start.in_units(exponent) * (last - index) + stop.in_units(exponent) * index;
    let sign = if sum < 0 { "-" } else { "" };
    let (whole, rest) = ((sum / last).abs(), (sum % last).abs());
    let more = rest * 10i128.pow(AFTER);
    let beyond = u8::from(more % last > 0);
    let after = more / last;
    format!("{sign}{whole}.{after:0width$}{beyond}e{exponent}", width = AFTER as usize).parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_of_decimals_is_that_of_its_decimals() {
        // start and step as decimals, so that each value is one too
        for places in 0..=9 {
            for start in [-250i64, -31, -3, 0, 1, 2, 7, 15, 99, 1_000_000] {
                for step in [1i64, 2, 3, 5, 7, 11, 25, 250, 999] {
                    for last in [1i64, 2, 3, 6, 7, 10, 40, 99] {
                        let decimal = |number: i64| format!("{number}e-{places}").parse::<f64>().unwrap();
                        let (from, to) = (decimal(start), decimal(start + step * last));
                        for i in 1..last {
                            let found = linear(from, to, i as usize, last as usize);
                            assert_eq!(found, decimal(start + step * i), "{from}:{to}:{last} {i}");
                            assert_eq!(linear(to, from, (last - i) as usize, last as usize), found);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn values_that_are_no_decimals_are_rounded_once() {
        // one division of integers is rounded correctly
        for last in [3usize, 7, 9, 11, 97, 99_999_999] {
            for index in [1, 2, last / 2, last - 1] {
                assert_eq!(linear(0.0, 1.0, index, last), index as f64 / last as f64);
                assert_eq!(linear(0.0, -1e200, index, last), -linear(0.0, 1e200, index, last));
            }
        }
    }

    #[test]
    fn ends_of_any_size_are_no_hindrance() {
        assert_eq!(linear(-f64::MAX, f64::MAX, 1, 2), 0.0);
        assert_eq!(linear(f64::MAX, f64::MAX, 1, 2), f64::MAX);
        assert_eq!(linear(5e-324, 1.5e-323, 1, 2), 1e-323);
        assert_eq!(linear(1e-300, 1e300, 1, 4), 2.5e299);
        assert_eq!(linear(1e-300, 1e300, 1, 99_999_999), 1e300 / 99_999_999.0);
        assert_eq!(linear(0.0, 5e-324, 1, 3), 0.0);
        assert_eq!(linear(0.0, 0.0, 1, 3), 0.0);
        assert_eq!(Decimal::of(-0.00125), Decimal { digits: -125, exponent: -5 });
        assert_eq!(Decimal::of(5e-324).nearest(), 5e-324);
    }
}
