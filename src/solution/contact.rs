//! One contact of a solved scene.
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
    /// What the pressure is the sum of.
    pub(crate) strips: Vec<Strip>,
    /// Where the bodies touch for x ≥ 0, one part at least, outwards: the first begins at 0 unless the bodies are apart there.
    pub(crate) parts: Vec<Part>,
}

/// An interval of x ≥ 0, with the absolute errors of its ends; together with its mirror image, where the bodies of a contact touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) from: f64,
    pub(crate) from_error: f64,
    pub(crate) to: f64,
    pub(crate) to_error: f64,
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Where it begins.
    pub left: f64,
    /// The solver's estimate of the absolute error of `left`.
    pub left_error: f64,
    /// Where it ends.
    pub right: f64,
    /// The solver's estimate of the absolute error of `right`.
    pub right_error: f64,
    /// Resultant of the pressure on it, force per unit length out of plane; about an axis the force of a disc, or of each half of a ring.
    pub force: f64,
    /// Where that acts; the middle where nothing presses, and about an axis.
    pub centroid: f64,
}

impl Contact {
    /// All intervals in which the bodies touch, or on which a load presses, from left to right.
    pub fn intervals(&self) -> Vec<Interval> {
        let mirrored = self.parts.iter().rev().filter(|part| part.from > 0.0).map(|part| part.mirrored());
        let mut intervals: Vec<Interval> = mirrored.chain(self.parts.iter().map(Part::interval)).collect();
        self.share(&mut intervals);
        intervals
    }

    /// The half-length a of a contact that is one interval |x| < a; `None` if it is none, or several.
    pub fn half_length(&self) -> Option<f64> {
        self.whole().map(|part| part.to)
    }

    /// The solver's estimate of the absolute error of [`Self::half_length`]; as large as that where the pressure decays before an
    /// end is found, on which nothing else depends.
    pub fn half_length_error(&self) -> Option<f64> {
        self.whole().map(|part| part.to_error)
    }

    /// The contact, if it is one interval.
    fn whole(&self) -> Option<&Part> {
        self.parts.first().filter(|part| part.from == 0.0 && self.parts.len() == 1)
    }

    /// The innermost part for x ≥ 0.
    pub(crate) fn innermost(&self) -> Part {
        self.parts.first().copied().unwrap_or_default()
    }

    /// A place x ≥ 0 at which the bodies touch: 0 unless they are apart there.
    pub(crate) fn inside(&self) -> f64 {
        let innermost = self.innermost();
        if innermost.from == 0.0 { 0.0 } else { 0.5 * (innermost.from + innermost.to) }
    }

    /// As far as the bodies touch: the half-length, or the end of the last interval.
    pub fn reach(&self) -> f64 {
        self.parts.last().map_or(0.0, |part| part.to)
    }

    /// Contact pressure at `x` (compression positive); zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        if x == 0.0 && self.central_pressure.is_infinite() {
            return self.central_pressure;
        }
        self.strips.iter().map(|strip| strip.pressure(x)).sum()
    }

    /// Gives each strip of the pressure to the interval that it lies in; in low-accuracy answers one may lie next to it.
    fn share(&self, intervals: &mut [Interval]) {
        if self.strips.iter().any(|strip| strip.is_round) {
            // one disc or ring; its images are the halves of it
            let share = self.resultant / intervals.len() as f64;
            for interval in intervals {
                (interval.force, interval.centroid) = (share, 0.5 * (interval.left + interval.right));
            }
            return;
        }
        for (middle, resultant, moment) in self.strips.iter().flat_map(Strip::images) {
            let outside = |interval: &Interval| (interval.left - middle).max(middle - interval.right).max(0.0);
            if let Some(own) = intervals.iter_mut().min_by(|a, b| outside(a).total_cmp(&outside(b))) {
                own.force += resultant;
                own.centroid += resultant * middle + moment;
            }
        }
        for Interval { left, right, force, centroid, .. } in intervals {
            let is_in_the_middle = *left == -*right || *force == 0.0;
            *centroid =
                if is_in_the_middle { 0.5 * (*left + *right) } else { (*centroid / *force).clamp(*left, *right) };
        }
    }
}

impl Default for Part {
    fn default() -> Self {
        Self { from: 0.0, from_error: 0.0, to: 0.0, to_error: 0.0 }
    }
}

impl Part {
    /// The interval for x ≥ 0, or both images where it begins at 0.
    fn interval(&self) -> Interval {
        let (left, left_error) = if self.from > 0.0 { (self.from, self.from_error) } else { (-self.to, self.to_error) };
        Interval { left, left_error, right: self.to, right_error: self.to_error, force: 0.0, centroid: 0.0 }
    }

    fn mirrored(&self) -> Interval {
        let (left, left_error) = (-self.to, self.to_error);
        Interval { left, left_error, right: -self.from, right_error: self.from_error, force: 0.0, centroid: 0.0 }
    }
}
