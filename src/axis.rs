//! What varies in a sweep, and over which values.
use std::fmt;
use std::hash::Hasher;
use std::str::FromStr;

/// Most values of one axis.
const LONGEST: usize = 1_000_000;
/// Digits of the decimals that one writes.
const DIGITS: i32 = 12;
/// Bound of the rounding errors of a value, as a part of the larger end; where ratios are equal, of the value and of the logarithms of both ends.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A quantity of the scene by its path, and the values that it takes.
///
/// Values between two ends are the ones that one would write: where a decimal of up to 12 digits differs by rounding errors only,
/// the value is the number nearest to the decimal.
///
/// ```
/// use recede::Axis;
/// let force: Axis = "force=0.001:0.004:4".parse()?;
/// assert_eq!(force, Axis::linear("force", 0.001, 0.004, 4)?);
/// assert!("force=0:1:11".parse::<Axis>()?.values().any(|value| value == 0.3));
/// let radius: Axis = "punch.radius=1:1000:4:log".parse()?;
/// assert!(radius.values().eq([1.0, 10.0, 100.0, 1000.0]));
/// let beta: Axis = "layer[2].beta=[-1, 0.001, 1]".parse()?;
/// assert_eq!((beta.values().len(), beta.value(1)), (3, Some(0.001)));
/// let error = "force=0:1".parse::<Axis>().unwrap_err();
/// assert_eq!(error.to_string(), "`force=0:1`: START:STOP:COUNT is expected after `=`, found `0:1`");
/// # Ok::<(), recede::AxisError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "files", derive(serde::Deserialize), serde(try_from = "WrittenAxis"))]
pub struct Axis {
    path: String,
    /// As on a command line, behind the equals sign.
    written: String,
    values: Vec<f64>,
    /// Numbers of the values, the smallest value first.
    sorted: Vec<usize>,
}

impl Axis {
    /// These values, in this order.
    ///
    /// # Errors
    /// [`AxisError`] if there is no value, or one is not finite.
    pub fn list(path: &str, values: Vec<f64>) -> Result<Self, AxisError> {
        match values.iter().find(|value| !value.is_finite()) {
            Some(value) => Err(AxisError::new(path, format!("found the value {value:?}, allowed are finite numbers"))),
            None => Self::of(path, format!("{values:?}"), values.len(), |index| values[index]),
        }
    }

    /// `count` values from `start` to `stop`, both included, at equal distances.
    ///
    /// # Errors
    /// [`AxisError`] if a number is not finite, or `count` is 0, or is 1 and `start` is not `stop`.
    pub fn linear(path: &str, start: f64, stop: f64, count: usize) -> Result<Self, AxisError> {
        let size = start.abs().max(stop.abs());
        let value = |share: f64| start * (1.0 - share) + stop * share;
        Self::between(path, [start, stop], count, "", |share| decimal(value(share), size, ROUNDING * size))
    }

    /// `count` values from `start` to `stop`, both included, at equal ratios.
    ///
    /// # Errors
    /// As [`Axis::linear`], and if `start` and `stop` are not both positive.
    pub fn logarithmic(path: &str, start: f64, stop: f64, count: usize) -> Result<Self, AxisError> {
        if start.min(stop) <= 0.0 {
            let reason = format!("found {start:?} to {stop:?}, allowed are positive numbers where ratios are equal");
            return Err(AxisError::new(path, reason));
        }
        let value = |share: f64| 10f64.powf(start.log10() * (1.0 - share) + stop.log10() * share);
        let rounding = ROUNDING * (1.0 + start.ln().abs() + stop.ln().abs());
        Self::between(path, [start, stop], count, ":log", |share| {
            let value = value(share);
            decimal(value, value, rounding * value)
        })
    }

    /// Values between two ends, which are met exactly; `value` tells one from its part of the way from the first to the last.
    fn between(
        path: &str,
        [start, stop]: [f64; 2],
        count: usize,
        end: &str,
        value: impl Fn(f64) -> f64,
    ) -> Result<Self, AxisError> {
        if !start.is_finite() || !stop.is_finite() {
            return Err(AxisError::new(path, format!("found {start:?} to {stop:?}, allowed are finite numbers")));
        }
        if count == 1 && start != stop {
            return Err(AxisError::new(path, format!("found 1 value for {start:?} to {stop:?}")));
        }
        Self::of(path, format!("{start:?}:{stop:?}:{count}{end}"), count, |index| match index {
            0 => start,
            _ if index + 1 == count => stop,
            _ => value(index as f64 / (count - 1) as f64),
        })
    }

    fn of(path: &str, written: String, count: usize, value: impl Fn(usize) -> f64) -> Result<Self, AxisError> {
        if path.is_empty() {
            return Err(AxisError::new(path, "the path of a quantity is missing"));
        }
        if !(1..=LONGEST).contains(&count) {
            return Err(AxisError::new(path, format!("found {count} values, allowed are 1 to {LONGEST}")));
        }
        let values: Vec<f64> = (0..count).map(value).collect();
        let mut sorted: Vec<usize> = (0..count).collect();
        sorted.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
        Ok(Self { path: path.to_owned(), written, values, sorted })
    }

    /// The path of the quantity, e.g. `layer[2].beta`.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// The values, in order.
    pub fn values(&self) -> impl ExactSizeIterator<Item = f64> {
        self.values.iter().copied()
    }

    /// The value with this number, from 0; `None` beyond the last.
    pub fn value(&self, index: usize) -> Option<f64> {
        self.values.get(index).copied()
    }

    /// Number of values, 1 or more.
    pub(crate) fn count(&self) -> usize {
        self.values.len()
    }

    /// The value with a number below [`Self::count`].
    pub(super) fn at(&self, index: usize) -> f64 {
        self.values[index]
    }

    /// The number of the value that is this one bit by bit; `None` if there is none, or more than one.
    pub(super) fn index_of(&self, value: f64) -> Option<usize> {
        let first = self.sorted.partition_point(|index| self.at(*index).total_cmp(&value).is_lt());
        let mut found = self.sorted[first..].iter().take_while(|index| self.at(**index).to_bits() == value.to_bits());
        found.next().copied().filter(|_| found.next().is_none())
    }

    /// The smallest value, the one nearest to zero, and the largest, each once. What is legal is an interval for every
    /// quantity that ships, so that these tell of the others; and a thickness vanishes at the one nearest to zero or not at
    /// all.
    pub(super) fn extremes(&self) -> Vec<f64> {
        let smaller = |a: f64, b: f64| if b.abs() < a.abs() { b } else { a };
        let [least, most] = [0, self.count() - 1].map(|place| self.at(self.sorted[place]));
        let mut extremes = vec![least, self.values().fold(least, smaller), most];
        extremes.dedup();
        extremes
    }

    /// Adds this axis to a fingerprint.
    pub(super) fn write_to(&self, hasher: &mut impl Hasher) {
        hasher.write(format!("{}={}", self.path, self.count()).as_bytes());
        self.values().for_each(|value| hasher.write_u64(value.to_bits()));
    }
}

/// The decimal whose last digit is the twelfth of a number of this size, if it differs from the value by rounding errors at most, or else the
/// value.
fn decimal(value: f64, size: f64, rounding: f64) -> f64 {
    if value.abs() <= rounding {
        return 0.0;
    }
    let digits = DIGITS + (value.abs().log10().floor() - size.log10().floor()) as i32;
    let written: f64 = format!("{value:.*e}", (digits - 1).max(0) as usize).parse().unwrap_or(value);
    if (written - value).abs() <= rounding { written } else { value }
}

impl FromStr for Axis {
    type Err = AxisError;

    /// Reads `PATH=START:STOP:COUNT`, `PATH=START:STOP:COUNT:log` or `PATH=[v, v, ...]`.
    fn from_str(text: &str) -> Result<Self, AxisError> {
        Self::read(text, |_, number| number.parse().map_err(|_| format!("a number is expected, found `{number}`")))
    }
}

impl Axis {
    /// Reads an axis, the numbers of which are read by their path.
    pub(crate) fn read(text: &str, number: impl Fn(&str, &str) -> Result<f64, String>) -> Result<Self, AxisError> {
        let failed = |reason: String| AxisError::new(text, reason);
        let Some((path, range)) = text.split_once('=') else {
            return Err(failed("PATH=START:STOP:COUNT or PATH=[v,v,...] is expected".into()));
        };
        let (path, range) = (path.trim(), range.trim());
        let number = |text: &str| number(path, text.trim().trim_matches('"')).map_err(failed);
        let axis = if let Some(list) = range.strip_prefix('[') {
            let Some(list) = list.strip_suffix(']') else { return Err(failed("a closing `]` is missing".into())) };
            // a comma after the last is allowed, as in a scene
            let values: Result<_, _> = list.trim().trim_end_matches(',').split(',').map(number).collect();
            Self::list(path, values?)
        } else {
            let expected = |what: &str| failed(format!("{what} is expected after `=`, found `{range}`"));
            let (start, stop, count, make) = match range.split(':').collect::<Vec<_>>()[..] {
                [start, stop, count] => (start, stop, count, Self::linear as fn(&str, f64, f64, usize) -> _),
                [start, stop, count, "log"] => (start, stop, count, Self::logarithmic as _),
                [_, _, _, _] => return Err(expected("START:STOP:COUNT or START:STOP:COUNT:log")),
                _ => return Err(expected("START:STOP:COUNT")),
            };
            let (start, stop, count) = (number(start)?, number(stop)?, count.trim());
            let whole = count.parse().map_err(|_| failed(format!("COUNT is a whole number, found `{count}`")))?;
            make(path, start, stop, whole)
        };
        axis.map_err(|error| failed(error.reason))
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.path, self.written)
    }
}

/// Why something is no axis of a sweep.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{axis}`: {reason}")]
pub struct AxisError {
    /// The axis as written.
    pub axis: String,
    /// What was found, and what is expected.
    pub reason: String,
}

impl AxisError {
    pub(crate) fn new(axis: &str, reason: impl Into<String>) -> Self {
        Self { axis: axis.to_owned(), reason: reason.into() }
    }
}

/// An axis as it is written in a file.
#[cfg(feature = "files")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
enum WrittenAxis {
    Linear { path: String, start: f64, stop: f64, count: usize },
    Logarithmic { path: String, start: f64, stop: f64, count: usize },
    List { path: String, values: Vec<f64> },
}

#[cfg(feature = "files")]
impl TryFrom<WrittenAxis> for Axis {
    type Error = AxisError;

    fn try_from(axis: WrittenAxis) -> Result<Self, AxisError> {
        match axis {
            WrittenAxis::Linear { path, start, stop, count } => Self::linear(&path, start, stop, count),
            WrittenAxis::Logarithmic { path, start, stop, count } => Self::logarithmic(&path, start, stop, count),
            WrittenAxis::List { path, values } => Self::list(&path, values),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<f64> {
        text.parse::<Axis>().unwrap().values().collect()
    }

    fn refused(text: &str) -> String {
        text.parse::<Axis>().unwrap_err().reason
    }

    #[test]
    fn both_ends_are_met_exactly() {
        assert_eq!(values("force=0.1:0.7:7").last(), Some(&0.7));
        assert_eq!(values("force=-1:1:3"), [-1.0, 0.0, 1.0]);
        assert_eq!(values("force=3:1:3"), [3.0, 2.0, 1.0]);
        assert_eq!(values("force=0.3:30:3:log").first(), Some(&0.3));
        assert_eq!(values("force=2:2:1"), [2.0]);
        assert_eq!(values("force=-1.7e308:1.7e308:3"), [-1.7e308, 0.0, 1.7e308]);
        assert_eq!(values(" force = [ 1, 2e-3 , ]"), [1.0, 2e-3]);
        // ends of any size are no hindrance
        let between = |start: f64, stop: f64, last: usize| Axis::linear("force", start, stop, last + 1).unwrap().at(1);
        assert_eq!(between(-f64::MAX, f64::MAX, 2), 0.0);
        assert_eq!(between(f64::MAX, f64::MAX, 2), f64::MAX);
        assert_eq!(between(5e-324, 1.5e-323, 2), 1e-323);
        assert_eq!(between(1e-300, 1e300, 4), 2.5e299);
        assert_eq!(between(0.0, 0.0, 3), 0.0);
    }

    #[test]
    fn an_axis_is_written_as_it_is_read() {
        let axis: Axis = "force=1:2:1000000".parse().unwrap();
        assert_eq!((axis.values().len(), axis.value(999_999), axis.value(1_000_000)), (LONGEST, Some(2.0), None));
        assert_eq!(axis.to_string(), "force=1.0:2.0:1000000");
        assert_eq!("force=1:1000:7:log".parse::<Axis>().unwrap().to_string(), "force=1.0:1000.0:7:log");
        assert_eq!("force=[1, 0.1]".parse::<Axis>().unwrap().to_string(), "force=[1.0, 0.1]");
    }

    #[test]
    fn a_grid_of_decimals_has_their_values() {
        // start and step as decimals, so that each value is one too
        for places in 0..=9 {
            for start in [-250i64, -31, -3, 0, 1, 2, 7, 15, 99, 1_000_000] {
                for step in [1i64, 2, 3, 5, 7, 11, 25, 250, 999] {
                    for last in [1i64, 2, 3, 6, 7, 10, 40, 99] {
                        let decimal = |number: i64| format!("{number}e-{places}").parse::<f64>().unwrap();
                        let expected = (0..=last).map(|i| decimal(start + step * i));
                        let axis =
                            Axis::linear("force", decimal(start), decimal(start + step * last), last as usize + 1);
                        assert!(axis.unwrap().values().eq(expected), "{start} {step} {last} {places}");
                    }
                }
            }
        }
        assert_eq!(values("force=1e-300:1e300:7:log")[3..5], [1.0, 1e100]);
    }

    #[test]
    fn values_that_are_no_decimals_are_at_equal_distances() {
        for last in [3usize, 7, 9, 11, 97, 999_999] {
            let axis = Axis::linear("force", 0.0, 1.0, last + 1).unwrap();
            for (index, value) in axis.values().enumerate() {
                assert!((value - index as f64 / last as f64).abs() <= ROUNDING);
            }
        }
    }

    #[test]
    fn extremes_are_found_among_all_values() {
        let extremes = |text: &str| text.parse::<Axis>().unwrap().extremes();
        assert_eq!(extremes("force=[3, -1, 2, 0.5]"), [-1.0, 0.5, 3.0]);
        assert_eq!(extremes("force=-1:2:4"), [-1.0, 0.0, 2.0]);
        assert_eq!(extremes("force=2:-1:1001"), [-1.0, -0.001, 2.0]);
        assert_eq!(extremes("force=5:1:9"), [1.0, 5.0]);
        assert_eq!(extremes("force=0.1:10:1000000:log"), [0.1, 10.0]);
        assert_eq!(extremes("force=2:2:1"), [2.0]);
    }

    #[test]
    fn a_value_is_found_if_it_is_there_once() {
        for text in ["force=1:2:1000000", "force=2:-1:3001", "force=1000:0.003:99999:log", "force=[3, -0.0, 2]"] {
            let axis: Axis = text.parse().unwrap();
            let last = axis.count() - 1;
            for index in [0, 1, 2, last / 7, last / 3, last / 2, last - 1, last].map(|index| index.min(last)) {
                assert_eq!(axis.index_of(axis.at(index)), Some(index), "{text}");
            }
            assert_eq!([5e3, -7.0, f64::NAN].map(|value| axis.index_of(value)), [None; 3], "{text}");
        }
        let twice: Axis = "force=[1, 2, 1]".parse().unwrap();
        assert_eq!([1.0, 2.0].map(|value| twice.index_of(value)), [None, Some(1)]);
        // more values than there are numbers between the ends
        let dense: Axis = "force=1:1.0000000000000004:9".parse().unwrap();
        assert_eq!(dense.index_of(1.0), None);
        assert_eq!("force=2:2:5".parse::<Axis>().unwrap().index_of(2.0), None);
    }

    #[test]
    fn mistakes_are_told() {
        assert_eq!(refused("force"), "PATH=START:STOP:COUNT or PATH=[v,v,...] is expected");
        assert_eq!(refused("force=1:x:3"), "a number is expected, found `x`");
        assert_eq!(refused("force=1:2:3.5"), "COUNT is a whole number, found `3.5`");
        assert_eq!(refused("force=1:2:-1"), "COUNT is a whole number, found `-1`");
        assert_eq!(refused("force=1:2:0"), "found 0 values, allowed are 1 to 1000000");
        assert_eq!(refused("force=1:2:1"), "found 1 value for 1.0 to 2.0");
        assert_eq!(refused("force=0:2:3:log"), "found 0.0 to 2.0, allowed are positive numbers where ratios are equal");
        assert_eq!(refused("force=1:inf:3"), "found 1.0 to inf, allowed are finite numbers");
        assert_eq!(refused("force=[1,NaN]"), "found the value NaN, allowed are finite numbers");
        assert_eq!(refused("force=[]"), "a number is expected, found ``");
        assert_eq!(refused("force=[1"), "a closing `]` is missing");
        assert_eq!(refused("=[1]"), "the path of a quantity is missing");
        assert!(refused("force=1:2:3:ln").starts_with("START:STOP:COUNT or START:STOP:COUNT:log is expected"));
    }
}
