//! What varies in a sweep, and over which values.
mod decimal;
mod range;

use std::fmt;
use std::hash::Hasher;
use std::str::FromStr;

use range::{Range, Spacing};

/// Most values of one axis.
const LONGEST: usize = 100_000_000;

/// A quantity of the scene by its path, and the values that it takes.
///
/// Values at equal distances are those that one would write in decimals: each is the number nearest to the exact value
/// between the decimals `start` and `stop`.
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
    values: Values,
}

/// A range is kept as its ends, so that it takes no more memory with more values.
#[derive(Clone, Debug, PartialEq)]
enum Values {
    List(Vec<f64>),
    Range(Range),
}

impl Axis {
    /// These values, in this order.
    ///
    /// # Errors
    /// [`AxisError`] if there is no value, or one is not finite.
    pub fn list(path: &str, values: Vec<f64>) -> Result<Self, AxisError> {
        match values.iter().find(|value| !value.is_finite()) {
            Some(value) => Err(AxisError::new(path, format!("found the value {value:?}, allowed are finite numbers"))),
            None => Self::of(path, Values::List(values)),
        }
    }

    /// `count` values from `start` to `stop`, both included, at equal distances.
    ///
    /// # Errors
    /// [`AxisError`] if a number is not finite, or `count` is 0, or is 1 and `start` is not `stop`.
    pub fn linear(path: &str, start: f64, stop: f64, count: usize) -> Result<Self, AxisError> {
        Self::between(path, [start, stop], count, Spacing::Linear)
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
        Self::between(path, [start, stop], count, Spacing::Logarithmic)
    }

    fn between(path: &str, [start, stop]: [f64; 2], count: usize, spacing: Spacing) -> Result<Self, AxisError> {
        if !start.is_finite() || !stop.is_finite() {
            return Err(AxisError::new(path, format!("found {start:?} to {stop:?}, allowed are finite numbers")));
        }
        if count == 1 && start != stop {
            return Err(AxisError::new(path, format!("found 1 value for {start:?} to {stop:?}")));
        }
        Self::of(path, Values::Range(Range { ends: [start, stop], count, spacing }))
    }

    fn of(path: &str, values: Values) -> Result<Self, AxisError> {
        let axis = Self { path: path.to_owned(), values };
        match axis.count() {
            _ if path.is_empty() => Err(AxisError::new(path, "the path of a quantity is missing")),
            1..=LONGEST => Ok(axis),
            count => Err(AxisError::new(path, format!("found {count} values, allowed are 1 to {LONGEST}"))),
        }
    }

    /// The path of the quantity, e.g. `layer[2].beta`.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// The values, in order, each computed on demand.
    pub fn values(&self) -> impl ExactSizeIterator<Item = f64> {
        (0..self.count()).map(|index| self.at(index))
    }

    /// The value with this number, from 0; `None` beyond the last.
    pub fn value(&self, index: usize) -> Option<f64> {
        (index < self.count()).then(|| self.at(index))
    }

    /// Number of values, 1 or more.
    pub(crate) fn count(&self) -> usize {
        match &self.values {
            Values::List(values) => values.len(),
            Values::Range(range) => range.count,
        }
    }

    /// The value with a number below [`Self::count`].
    pub(super) fn at(&self, index: usize) -> f64 {
        match &self.values {
            Values::List(values) => values[index],
            Values::Range(range) => range.at(index),
        }
    }

    /// The number of the value that is this one bit by bit; `None` if there is none, or more than one.
    pub(super) fn index_of(&self, value: f64) -> Option<usize> {
        let candidates = match &self.values {
            Values::List(values) => 0..values.len(),
            Values::Range(range) => range.near(value),
        };
        let mut found = candidates.filter(|index| self.at(*index).to_bits() == value.to_bits());
        found.next().filter(|_| found.next().is_none())
    }

    /// The smallest value, the one nearest to zero, and the largest, each once. What is legal is an interval for every
    /// quantity that ships, so that these tell of the others; and a thickness vanishes at the one nearest to zero or not at
    /// all.
    pub(super) fn extremes(&self) -> Vec<f64> {
        let candidates: Box<dyn Iterator<Item = usize>> = match &self.values {
            Values::List(values) => Box::new(0..values.len()),
            Values::Range(range) => Box::new(range.near_extremes()),
        };
        let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY];
        let extremes = candidates.map(|index| self.at(index)).fold(start, |[least, nearest, most], value| {
            let nearest = if value.abs() < f64::abs(nearest) { value } else { nearest };
            [least.min(value), nearest, most.max(value)]
        });
        let mut extremes = extremes.to_vec();
        extremes.dedup();
        extremes
    }

    /// Adds this axis to a fingerprint.
    pub(super) fn write_to(&self, hasher: &mut impl Hasher) {
        hasher.write(format!("{}={}", self.path, self.count()).as_bytes());
        match &self.values {
            Values::List(values) => values.iter().for_each(|value| hasher.write_u64(value.to_bits())),
            Values::Range(range) => hasher.write(range.to_string().as_bytes()),
        }
    }
}

impl FromStr for Axis {
    type Err = AxisError;

    /// Reads `PATH=START:STOP:COUNT`, `PATH=START:STOP:COUNT:log` or `PATH=[v, v, ...]`.
    fn from_str(text: &str) -> Result<Self, AxisError> {
        let failed = |reason: String| AxisError::new(text, reason);
        let Some((path, range)) = text.split_once('=') else {
            return Err(failed("PATH=START:STOP:COUNT or PATH=[v,v,...] is expected".into()));
        };
        let (path, range) = (path.trim(), range.trim());
        let number = |text: &str| {
            let found = text.trim().parse::<f64>();
            found.map_err(|_| failed(format!("a number is expected, found `{}`", text.trim())))
        };
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
        match &self.values {
            Values::List(values) => write!(f, "{}={values:?}", self.path),
            Values::Range(range) => write!(f, "{}={range}", self.path),
        }
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
    }

    #[test]
    fn what_an_axis_takes_does_not_grow_with_its_values() {
        let axis: Axis = "force=1:2:100000000".parse().unwrap();
        assert_eq!((axis.values().len(), axis.value(99_999_999), axis.value(100_000_000)), (LONGEST, Some(2.0), None));
        assert_eq!(axis.to_string(), "force=1.0:2.0:100000000");
        assert_eq!("force=1:1000:7:log".parse::<Axis>().unwrap().to_string(), "force=1.0:1000.0:7:log");
    }

    #[test]
    fn extremes_are_those_of_all_values() {
        let extremes = |text: &str| text.parse::<Axis>().unwrap().extremes();
        assert_eq!(extremes("force=[3, -1, 2, 0.5]"), [-1.0, 0.5, 3.0]);
        assert_eq!(extremes("force=-1:2:4"), [-1.0, 0.0, 2.0]);
        assert_eq!(extremes("force=2:-1:1001"), [-1.0, -0.001, 2.0]);
        assert_eq!(extremes("force=5:1:9"), [1.0, 5.0]);
        assert_eq!(extremes("force=0.1:10:100000000:log"), [0.1, 10.0]);
        assert_eq!(extremes("force=2:2:1"), [2.0]);
    }

    #[test]
    fn a_value_is_found_if_it_is_there_once() {
        for text in ["force=1:2:100000000", "force=2:-1:3001", "force=1000:0.003:99999:log", "force=[3, -0.0, 2]"] {
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
        assert_eq!(refused("force=1:2:0"), "found 0 values, allowed are 1 to 100000000");
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
