//! Axes: round numbers along a range, and where they stand.

/// A range of numbers along an axis, and what they are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scale {
    name: String,
    unit: Option<String>,
    low: f64,
    high: f64,
    logarithmic: bool,
    reversed: bool,
}

/// A mark of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The value that is marked.
    pub value: f64,
    /// The number written at the mark.
    pub label: String,
}

impl Scale {
    /// From the smallest to the largest of these values; wider if they are all the same.
    pub fn around(values: impl IntoIterator<Item = f64>) -> Self {
        let bounds = values.into_iter().filter(|value| value.is_finite());
        let (low, high) = bounds.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (v.min(l), v.max(h)));
        let scale = |low, high| Self { low, high, ..Self::default() };
        match (low, high) {
            _ if low > high => scale(0.0, 1.0),
            (0.0, 0.0) => scale(-1.0, 1.0),
            _ if high - low <= 1e-9 * low.abs().max(high.abs()) => {
                scale(low - 0.1 * low.abs(), high + 0.1 * high.abs())
            }
            _ => scale(low, high),
        }
    }

    /// The same range of a quantity with this name and unit.
    pub fn of(mut self, name: &str, unit: Option<String>) -> Self {
        (self.name, self.unit) = (name.to_owned(), unit);
        self
    }

    /// The same range with this value in it.
    pub fn with(mut self, value: f64) -> Self {
        self.low = self.low.min(value);
        self.high = self.high.max(value);
        self
    }

    /// The range widened to round numbers at both ends.
    pub fn rounded(mut self) -> Self {
        if !self.logarithmic {
            // a wider range may have longer steps
            for _ in 0..2 {
                let step = step(self.high - self.low);
                self.low = (self.low / step + 1e-9).floor() * step;
                self.high = (self.high / step - 1e-9).ceil() * step;
            }
        }
        self
    }

    /// The same range with equal distances for equal ratios, if all of it is positive.
    pub fn logarithmic(mut self) -> Self {
        self.logarithmic = self.low > 0.0;
        self
    }

    /// The same range the other way round, as for depths, which are counted downwards.
    pub fn reversed(mut self) -> Self {
        self.reversed = !self.reversed;
        self
    }

    /// The ends of the range.
    pub fn ends(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    /// Where a value stands, from 0 to 1 within the range.
    pub fn share(&self, value: f64) -> f64 {
        let share = match self.logarithmic {
            true => (value / self.low).ln() / (self.high / self.low).ln(),
            false => (value - self.low) / (self.high - self.low),
        };
        if self.reversed { 1.0 - share } else { share }
    }

    /// The value at a part of a range that is not reversed.
    pub(super) fn value(&self, share: f64) -> f64 {
        match self.logarithmic {
            true => self.low * (self.high / self.low).powf(share),
            false => self.low + (self.high - self.low) * share,
        }
    }

    /// Power of ten that the labels leave out, 0 if none.
    pub fn power(&self) -> i32 {
        let largest = self.low.abs().max(self.high.abs());
        let power = largest.log10().floor() as i32;
        if self.logarithmic || (-2..4).contains(&power) { 0 } else { power }
    }

    /// The name with a power of ten and the unit behind it, e.g. `pressure, 10⁻³ N/mm²`.
    pub fn title(&self) -> String {
        let factor = Some(self.power()).filter(|power| *power != 0).map(ten_to);
        let parts: Vec<&str> = factor.as_deref().into_iter().chain(self.unit.as_deref()).collect();
        if parts.is_empty() { self.name.clone() } else { format!("{}, {}", self.name, parts.join(" ")) }
    }

    /// The marks; values divided by ten to the power left out.
    pub fn ticks(&self) -> Vec<Tick> {
        if self.logarithmic {
            return self.logarithmic_ticks();
        }
        let unit = 10f64.powi(self.power());
        let step = step(self.high - self.low);
        let whole = |decimals: &usize| {
            let scaled = step / unit * 10f64.powi(*decimals as i32);
            (scaled - scaled.round()).abs() < 1e-6 * scaled
        };
        let decimals = (0..12).find(whole).unwrap_or(12);
        let (first, last) = ((self.low / step - 1e-9).ceil() as i64, (self.high / step + 1e-9).floor() as i64);
        let tick = |i: i64| {
            let value = i as f64 * step;
            Tick { value, label: minus(format!("{:.decimals$}", value / unit)) }
        };
        (first..=last).map(tick).collect()
    }

    /// Powers of ten, or 1, 2, 5 times them over short ranges, and between them marks without a label.
    fn logarithmic_ticks(&self) -> Vec<Tick> {
        let decades = (self.high / self.low).log10();
        let labelled: &[u32] = match decades {
            _ if decades > 2.2 => &[1],
            _ if decades > 0.9 => &[1, 2, 5],
            _ => &[1, 2, 3, 4, 5, 7],
        };
        let stride = (decades / 6.0).ceil().max(1.0) as usize;
        let between = if stride > 1 { 1..=1 } else { 1..=9 };
        let (first, last) = (self.low.log10().floor() as i32, self.high.log10().ceil() as i32);
        let inside = |tick: &Tick| (self.low * (1.0 - 1e-9)..=self.high * (1.0 + 1e-9)).contains(&tick.value);
        let powers = (first..=last).step_by(stride);
        let ticks = powers.flat_map(|power| {
            between.clone().map(move |multiple| {
                let value = f64::from(multiple) * 10f64.powi(power);
                let text = if decades > 2.2 && !(-2..4).contains(&power) { ten_to(power) } else { label(value) };
                Tick { value, label: if labelled.contains(&multiple) { text } else { String::new() } }
            })
        });
        ticks.filter(inside).collect()
    }
}

/// Significant digits that are shown.
const SHOWN: usize = 4;
/// Digits that rounding leaves alone: what differs from a round number by rounding only is that number.
const ROUNDED: usize = 9;
/// Digits that identify a double.
const ALL: usize = 17;

/// A number as short as can be, powers of ten with small figures.
pub fn label(value: f64) -> String {
    digits(value, if is_plain(value) { ROUNDED } else { SHOWN })
}

/// Four digits.
pub(super) fn short(value: f64) -> String {
    digits(value, SHOWN)
}

/// Labels of values, with four digits or as many as tell different values apart.
pub(super) fn distinct(values: &[f64]) -> Vec<String> {
    let mut ascending = values.to_vec();
    ascending.sort_by(f64::total_cmp);
    ascending.dedup();
    let apart = |count: &usize| {
        let labels = ascending.iter().map(|value| digits(*value, *count));
        labels.collect::<std::collections::BTreeSet<_>>().len() == ascending.len()
    };
    let count = (SHOWN..ALL).find(apart).unwrap_or(ALL);
    values.iter().map(|value| digits(*value, count)).collect()
}

/// Whether a number is written without a power of ten.
fn is_plain(value: f64) -> bool {
    value == 0.0 || (1e-3..1e5).contains(&value.abs())
}

/// A number with at most so many significant digits.
fn digits(value: f64, count: usize) -> String {
    let rounded = format!("{value:.0$e}", count - 1).parse().unwrap_or(value);
    if is_plain(rounded) {
        return minus(rounded.to_string());
    }
    let text = format!("{rounded:e}");
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    let power = ten_to(power.parse().unwrap_or(0));
    minus(if mantissa == "1" { power } else { format!("{mantissa}·{power}") })
}

/// E.g. 10⁻³.
pub fn ten_to(power: i32) -> String {
    const SMALL: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digit = |c: char| if c == '-' { Some('⁻') } else { SMALL.get(c.to_digit(10)? as usize).copied() };
    format!("10{}", power.to_string().chars().filter_map(digit).collect::<String>())
}

/// A number with a minus sign that is as wide as a plus.
fn minus(text: String) -> String {
    text.replace('-', "−")
}

/// A round number that divides a range into four to eight parts.
fn step(range: f64) -> f64 {
    let rough = range / 8.0;
    let power = 10f64.powf(rough.log10().floor());
    let steps = [1.0, 2.0, 2.5, 5.0, 10.0].map(|multiple| multiple * power);
    steps.into_iter().find(|step| *step >= rough * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale) -> Vec<String> {
        scale.ticks().into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn marks_are_round() {
        assert_eq!(labels(&Scale::around([0.0, 1.0])), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(
            labels(&Scale::around([-1.0, 1.0])),
            ["−1.00", "−0.75", "−0.50", "−0.25", "0.00", "0.25", "0.50", "0.75", "1.00"]
        );
        let small = Scale::around([0.0, 0.0017]).rounded();
        assert_eq!((small.power(), small.ends()), (-3, (0.0, 0.00175)));
        assert_eq!(labels(&small).last().unwrap(), "1.75");
        assert_eq!(labels(&Scale::around([-3.0, 3.0])), ["−3", "−2", "−1", "0", "1", "2", "3"]);
    }

    #[test]
    fn ratios_are_marked_too() {
        let labels = |scale: &Scale| labels(scale).into_iter().filter(|label| !label.is_empty()).collect::<Vec<_>>();
        let scale = Scale::around([0.001, 1000.0]).logarithmic();
        assert_eq!(labels(&scale), ["10⁻³", "0.01", "0.1", "1", "10", "100", "1000"]);
        assert_eq!(scale.ticks().len(), 55);
        assert_eq!(scale.share(1.0), 0.5);
        assert_eq!(labels(&Scale::around([0.2, 0.9]).logarithmic()), ["0.2", "0.3", "0.4", "0.5", "0.7"]);
        assert_eq!(labels(&Scale::around([0.1, 10.0]).logarithmic()), ["0.1", "0.2", "0.5", "1", "2", "5", "10"]);
        assert!(Scale::around([1e-30, 1e30]).logarithmic().ticks().len() < 9);
    }

    #[test]
    fn nothing_is_too_small_to_be_shown() {
        for values in [[0.0, 0.0], [3.0, 3.0], [f64::NAN, 2.0], [f64::NAN; 2], [1e300, -1e300], [1e-300, 2e-300]] {
            let scale = Scale::around(values).rounded();
            let (low, high) = scale.ends();
            assert!(low < high && (2..12).contains(&scale.ticks().len()), "{values:?}: {scale:?}");
        }
    }

    #[test]
    fn labels_are_short_and_tell_values_apart() {
        assert_eq!(label(0.1 + 0.2), "0.3");
        assert_eq!(label(-2.5e-7), "−2.5·10⁻⁷");
        assert_eq!(label(1e6), "10⁶");
        assert_eq!(short(95.0 / 7.0), "13.57");
        assert_eq!(distinct(&[95.0 / 7.0, 1.0, 95.0 / 7.0]), ["13.57", "1", "13.57"]);
        assert_eq!(distinct(&[1.0, 1.00001, 1.00002]), ["1", "1.00001", "1.00002"]);
        assert_eq!(distinct(&[-1.23456e-7, -1.23457e-7]), ["−1.23456·10⁻⁷", "−1.23457·10⁻⁷"]);
        let next = f64::from_bits(1f64.to_bits() + 1);
        let labels = distinct(&[1.0, next, 1e9]);
        assert_ne!(labels[0], labels[1]);
    }
}
