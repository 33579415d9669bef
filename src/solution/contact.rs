//! One contact of a solved scene.
use serde::Serialize;

use super::{Interface, Strip};

/// One contact of a solved scene. Lengths and stresses are in the units of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Which contact this is.
    pub interface: Interface,
    /// Pressure at x = 0 (compression positive); infinite under the tip of a wedge, and under a line load; 0 where the bodies are
    /// apart. The largest pressure may be elsewhere, see [`Self::peak`].
    pub central_pressure: f64,
    /// The solver's estimate of the absolute error of `central_pressure`.
    pub central_pressure_error: f64,
    /// Resultant of the pressure, force per unit length out of plane.
    pub resultant: f64,
    /// The pressures whose sum is the pressure of the contact, from left to right.
    pub(crate) strips: Vec<Strip>,
    /// Where the bodies touch, from left to right; one interval at least.
    pub(crate) intervals: Vec<Interval>,
    /// Under several punches the number of the punch, from the left, of each interval and strip; else none.
    pub(crate) punches: Vec<usize>,
    /// The place on x about which the contact is its own mirror image, if there is one.
    pub(crate) about: Option<f64>,
    /// The pressure there, elsewhere in the middle of the interval with the largest force, and its absolute error.
    pub(crate) middle_pressure: [f64; 2],
}

/// An interval in which the bodies of a contact touch. Lengths are in the unit of the scene.
///
/// ```
/// use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
/// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
/// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
/// let solution = Model::new(stack)?.press(&Punch::cylinder(500.0)?, 0.002)?;
/// let receding = solution.contacts()[1].intervals();
/// assert_eq!(receding.len(), 1);
/// assert!((receding[0].force - 0.002).abs() < 1e-12 && receding[0].left == -receding[0].right);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Interval {
    /// Where it begins.
    pub left: f64,
    /// Where it ends.
    pub right: f64,
    /// The solver's estimate of the absolute error of `left`.
    pub left_error: f64,
    /// The solver's estimate of the absolute error of `right`.
    pub right_error: f64,
    /// Resultant of the pressure on it, force per unit length out of plane; about an axis the force of a disc, or of each half of a ring.
    pub force: f64,
    /// Where that acts; the middle where nothing presses, and about an axis.
    pub centroid: f64,
}

impl Interval {
    /// An interval whose force is not known yet.
    pub(crate) fn new([left, left_error]: [f64; 2], [right, right_error]: [f64; 2]) -> Self {
        Self { left, left_error, right, right_error, force: 0.0, centroid: 0.0 }
    }

    /// Its mirror image about x = 0, without a force.
    pub(crate) fn mirrored(&self) -> Self {
        Self::new([-self.right, self.right_error], [-self.left, self.left_error])
    }
}

impl Contact {
    /// A contact with intervals and pressures from left to right, under several punches with the number of the punch of each. Of what is even `about` a place the
    /// middle pressure is the pressure there, elsewhere in the middle of the interval with the largest force, with its absolute error.
    pub(crate) fn new(
        interface: Interface,
        intervals: Vec<Interval>,
        strips: Vec<Strip>,
        about: Option<f64>,
        [middle, error]: [f64; 2],
        punches: Vec<usize>,
    ) -> Self {
        // what is infinite is known, and so is what is none
        let known = |pressure: f64| [pressure, if pressure == 0.0 || pressure.is_infinite() { 0.0 } else { error }];
        let middle_pressure = known(middle);
        // the series of a sharp tip is summed in closed form in the middle
        let [central_pressure, central_pressure_error] = match about {
            Some(0.0) => middle_pressure,
            _ => known(strips.iter().map(|strip| strip.pressure(0.0)).sum()),
        };
        let resultant = strips.iter().map(Strip::resultant).sum();
        let contact = Self {
            interface,
            central_pressure,
            central_pressure_error,
            resultant,
            strips,
            intervals,
            punches,
            about,
            middle_pressure,
        };
        contact.with_forces()
    }

    /// What is even about x = 0, from intervals and pressures of x ≥ 0, from the middle outwards: an interval that begins at 0 is one with its
    /// mirror image.
    pub(crate) fn even(interface: Interface, right: &[Interval], strips: &[Strip], middle_pressure: [f64; 2]) -> Self {
        let mut intervals: Vec<Interval> = right.iter().rev().map(Interval::mirrored).collect();
        let left = intervals.pop_if(|_| right[0].left == 0.0);
        intervals.extend(right);
        if let Some(Interval { left, left_error, .. }) = left {
            let middle = &mut intervals[right.len() - 1];
            (middle.left, middle.left_error) = (left, left_error);
        }
        let images = strips.iter().rev().filter(|strip| strip.at > 0.0).map(|strip| strip.mirrored(0.0));
        let strips = images.chain(strips.iter().cloned()).collect();
        Self::new(interface, intervals, strips, Some(0.0), middle_pressure, Vec::new())
    }

    /// All intervals in which the bodies touch, or on which a load presses, from left to right.
    pub fn intervals(&self) -> &[Interval] {
        &self.intervals
    }

    /// The half-length of a contact that is one interval, symmetric about the middle of the punch or load; `None` if it is none, or several.
    pub fn half_length(&self) -> Option<f64> {
        self.whole().map(|interval| 0.5 * (interval.right - interval.left))
    }

    /// The solver's estimate of the absolute error of [`Self::half_length`]; as large as that where the pressure decays before an
    /// end is found, on which nothing else depends.
    pub fn half_length_error(&self) -> Option<f64> {
        self.whole().map(|interval| interval.right_error)
    }

    /// The contact, if it is one interval that is its own mirror image.
    fn whole(&self) -> Option<&Interval> {
        self.intervals.first().filter(|_| self.about.is_some() && self.intervals.len() == 1)
    }

    /// Its outermost ends.
    pub(crate) fn ends(&self) -> [f64; 2] {
        self.intervals.first().zip(self.intervals.last()).map_or([0.0; 2], |(first, last)| [first.left, last.right])
    }

    /// Half of their distance.
    pub(crate) fn half_span(&self) -> f64 {
        let [left, right] = self.ends();
        0.5 * (right - left)
    }

    /// The largest error of an end, relative to the distance of its interval from the place about which all is even, else to the half-length of the interval;
    /// nothing depends on an end that is not known at all.
    pub(crate) fn end_error(&self) -> f64 {
        let of = |&Interval { left, right, left_error, right_error, .. }: &Interval| {
            let half = 0.5 * (right - left);
            let [left, right] = self.about.map_or([half; 2], |about| [left - about, right - about].map(f64::abs));
            let known = |(end, error): (f64, f64)| if error < end { error / left.max(right) } else { 0.0 };
            known((left, left_error)).max(known((right, right_error)))
        };
        self.intervals.iter().map(of).fold(0.0, f64::max)
    }

    /// The same in other units of length and pressure.
    pub(crate) fn scaled(self, length: f64, pressure: f64) -> Self {
        self.on(length, 0.0, pressure)
    }

    /// The same so much farther to the right.
    pub(crate) fn moved(self, by: f64) -> Self {
        self.on(1.0, by, 1.0)
    }

    /// With all places times a length and so much farther to the right, and pressures times another one.
    fn on(self, length: f64, by: f64, pressure: f64) -> Self {
        let end = |x: f64, error: f64| [x * length + by, error * length];
        let interval = |own: &Interval| Interval::new(end(own.left, own.left_error), end(own.right, own.right_error));
        let strip = |strip: Strip| {
            let mut strip = Strip { at: strip.at * length + by, ..strip.scaled(length, pressure) };
            // of a tip at x = 0 the place from which x was counted leaves its rounding
            if strip.tip != 0.0 && strip.tip_place().abs() <= 4.0 * f64::EPSILON * by.abs() {
                strip.tip_at = -strip.at / strip.extent;
            }
            strip
        };
        let (intervals, about) = (self.intervals.iter().map(interval).collect(), self.about.map(|x| x * length + by));
        let strips = self.strips.into_iter().map(strip).collect();
        let middle_pressure = self.middle_pressure.map(|own| own * pressure);
        Self::new(self.interface, intervals, strips, about, middle_pressure, self.punches)
    }

    /// The contact under each of several punches, from left to right; itself if there is one punch.
    pub(crate) fn of_each_punch(&self) -> Vec<Self> {
        let mut numbers = self.punches.clone();
        numbers.dedup();
        if numbers.len() < 2 {
            return vec![self.clone()];
        }
        let of = |number: &usize| {
            let own = |k: &usize| self.punches[*k] == *number;
            let is_under = |strip: &&Strip| nearest(&self.intervals, strip.at).is_some_and(|k| own(&k));
            let strips: Vec<Strip> = self.strips.iter().filter(is_under).cloned().collect();
            let is_here = strips.iter().any(|strip| strip.at - strip.extent <= 0.0 && strip.at + strip.extent >= 0.0);
            Self {
                central_pressure: if is_here { self.central_pressure } else { 0.0 },
                resultant: strips.iter().map(Strip::resultant).sum(),
                intervals: (0..self.intervals.len()).filter(own).map(|k| self.intervals[k]).collect(),
                punches: Vec::new(),
                about: None,
                strips,
                ..*self
            }
        };
        numbers.iter().map(of).collect()
    }

    /// The interval about the middle of what is even, else about x = 0; where the bodies are apart there, the next one to the right, or the last one of all.
    pub(crate) fn innermost(&self) -> Interval {
        let about = self.about.unwrap_or(0.0);
        let next = self.intervals.iter().find(|interval| interval.right >= about);
        next.or(self.intervals.last()).copied().unwrap_or_default()
    }

    /// Two places at which the bodies touch; the same twice if the contact is its own mirror image: the middle unless they are apart there.
    pub(crate) fn touching(&self) -> [f64; 2] {
        let Some(about) = self.about else { return self.ends() };
        let Interval { left, right, .. } = self.innermost();
        [if left <= about && right >= about { about } else { 0.5 * (left + right) }; 2]
    }

    /// As far as the bodies touch on either side of x = 0: the half-length, or the distance of the farthest end.
    pub fn reach(&self) -> f64 {
        let [left, right] = self.ends();
        right.max(-left)
    }

    /// Whether the contact is its own mirror image about x = 0.
    pub(crate) fn is_even(&self) -> bool {
        self.about == Some(0.0)
    }

    /// What tables list of each contact, by name.
    pub(crate) const COLUMNS: [&str; 12] = [
        "half_length",
        "half_length_error",
        "central_pressure",
        "central_pressure_error",
        "peak_pressure",
        "peak_pressure_error",
        "peak_at",
        "intervals",
        "left",
        "left_error",
        "right",
        "right_error",
    ];

    /// The numbers of these columns, NaN where there is none: of several intervals, how many there are, and where the first one
    /// begins and the last one ends.
    pub(crate) fn numbers(&self) -> [f64; Self::COLUMNS.len()] {
        let (peak, intervals) = (self.peak(), &self.intervals);
        let [first, last] = [intervals.first(), intervals.last()].map(|end| end.copied().unwrap_or_default());
        [
            self.half_length().unwrap_or(f64::NAN),
            self.half_length_error().unwrap_or(f64::NAN),
            self.central_pressure,
            self.central_pressure_error,
            peak.pressure,
            peak.error,
            peak.x,
            intervals.len() as f64,
            first.left,
            first.left_error,
            last.right,
            last.right_error,
        ]
    }

    /// Contact pressure at `x` (compression positive); zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        if self.about == Some(x) && self.middle_pressure[0].is_infinite() {
            return self.middle_pressure[0];
        }
        self.strips.iter().map(|strip| strip.pressure(x)).sum()
    }

    /// With the force and the centroid of each interval: a pressure belongs to the interval that it lies in; in low-accuracy
    /// answers it may lie next to it.
    fn with_forces(mut self) -> Self {
        let about = self.about;
        let intervals = &mut self.intervals;
        if self.strips.iter().any(|strip| strip.is_round) {
            // one disc, or a ring whose halves are the intervals
            let share = self.resultant / intervals.len() as f64;
            for interval in intervals {
                (interval.force, interval.centroid) = (share, 0.5 * (interval.left + interval.right));
            }
            return self;
        }
        for strip in &self.strips {
            let (middle, resultant) = (strip.at, strip.resultant());
            if let Some(own) = nearest(intervals, middle).map(|k| &mut intervals[k]) {
                own.force += resultant;
                own.centroid += resultant * middle + strip.moment();
            }
        }
        for Interval { left, right, force, centroid, .. } in intervals {
            let is_in_the_middle = about.is_some_and(|about| *left < about && about < *right) || *force == 0.0;
            *centroid =
                if is_in_the_middle { 0.5 * (*left + *right) } else { (*centroid / *force).clamp(*left, *right) };
        }
        self
    }
}

/// The number of the interval that a place lies in, or is nearest to.
fn nearest(intervals: &[Interval], x: f64) -> Option<usize> {
    let outside = |interval: &Interval| (interval.left - x).max(x - interval.right).max(0.0);
    (0..intervals.len()).min_by(|a, b| outside(&intervals[*a]).total_cmp(&outside(&intervals[*b])))
}
