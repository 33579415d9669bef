//! What a solved scene tells.
use std::f64::consts::PI;
use std::fmt;

/// Which contact: the punch on top, or a receding interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interface {
    /// Punch on the top face of the stack.
    Punch,
    /// Receding interface between two neighbours, numbered from the top as written in the scene, starting at 1;
    /// the base counts.
    Between {
        /// Number of the layer above.
        above: usize,
        /// Number of the layer (or base) below.
        below: usize,
    },
}

impl fmt::Display for Interface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Punch => write!(f, "punch"),
            Self::Between { above, below } => write!(f, "{above}|{below}"),
        }
    }
}

/// One contact of a solved scene. Lengths and stresses are in the units of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Which contact this is.
    pub interface: Interface,
    /// Half-length a: the contact covers |x| < a, but for what is `opening`. Of several loads, as far as the farthest of them
    /// reaches.
    pub half_length: f64,
    /// The solver's estimate of the absolute error of `half_length`; as large as that where the pressure decays before an end
    /// is found, on which nothing else depends.
    pub half_length_error: f64,
    /// Half-length of the part about x = 0 in which the bodies do not touch: 0 where they do at x = 0. A thin, stiff layer may
    /// lift off between the two edges of a strip that presses on it.
    pub opening: f64,
    /// The solver's estimate of the absolute error of `opening`.
    pub opening_error: f64,
    /// Pressure at x = 0 (compression positive); infinite under the tip of a wedge, and under a line load; 0 in an `opening`.
    pub peak_pressure: f64,
    /// The solver's estimate of the absolute error of `peak_pressure`.
    pub peak_pressure_error: f64,
    /// Resultant of the pressure, force per unit length out of plane.
    pub resultant: f64,
    /// What the pressure is the sum of: one strip, but where several loads press.
    pub(crate) strips: Vec<Strip>,
    /// Intervals of re-contact, from the middle outwards: empty where the contact is one interval.
    pub parts: Vec<Part>,
}

/// An interval from < |x| < to in which the bodies of a contact touch farther out than its half-length. Lengths are in the unit
/// of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Where it begins, > 0.
    pub from: f64,
    /// The solver's estimate of the absolute error of `from`.
    pub from_error: f64,
    /// Where it ends.
    pub to: f64,
    /// The solver's estimate of the absolute error of `to`.
    pub to_error: f64,
}

/// A pressure on |x − at| < extent, symmetric about x = at, and where `at` is not 0 its mirror image. In stress.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Strip {
    /// Where its middle is, ≥ 0, in length.
    pub(crate) at: f64,
    /// Half-length a of the strip, 0 of a line load.
    pub(crate) extent: f64,
    /// Of a line load its resultant alone; else p = Σ_m coefficients[m] sin((2m + 1) φ) + corners/sin φ + tip arcosh(1/|cos φ|) with x − at = a cos φ.
    pub(crate) coefficients: Vec<f64>,
    /// Coefficients of sin((2m + 2) φ), which the mirror image has with the other sign.
    pub(crate) skew: Vec<f64>,
    /// How strong it is next to the sharp corners of a punch; 0 if there are none.
    pub(crate) corners: f64,
    /// How strong its logarithm is under a sharp tip; 0 if there is none.
    pub(crate) tip: f64,
    /// What else is known of it.
    pub(crate) form: Form,
}

/// Pressures that are known in closed form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// What the series says.
    Series,
    /// All on a line.
    Line,
    /// The same everywhere.
    Uniform,
    /// Like 1 − s², s = (x − at)/a.
    Parabolic,
}

impl Strip {
    /// A pressure about x = 0 of which nothing is known but its series.
    pub(crate) fn series(extent: f64, coefficients: Vec<f64>) -> Self {
        Self { at: 0.0, extent, coefficients, skew: Vec::new(), corners: 0.0, tip: 0.0, form: Form::Series }
    }

    /// The same in other units of length and pressure.
    pub(crate) fn scaled(mut self, length: f64, pressure: f64) -> Self {
        // on a line the only coefficient is a force
        let unit = if self.form == Form::Line { length * pressure } else { pressure };
        self.coefficients.iter_mut().chain(&mut self.skew).for_each(|c| *c *= unit);
        (self.at, self.extent) = (self.at * length, self.extent * length);
        (self.corners, self.tip) = (self.corners * pressure, self.tip * pressure);
        self
    }

    /// The resultant of one image.
    pub(crate) fn resultant(&self) -> f64 {
        if self.form == Form::Line {
            return self.coefficients.iter().sum();
        }
        0.5 * PI * self.extent * (self.coefficients.first().copied().unwrap_or(0.0) + 2.0 * (self.corners + self.tip))
    }

    /// Pressure of one image at a distance from its middle; `mirror` is its sign in what is odd about that.
    fn image(&self, x: f64, mirror: f64) -> f64 {
        if self.form == Form::Line {
            return if x == 0.0 { f64::INFINITY } else { 0.0 };
        }
        let s = x / self.extent;
        // NaN is outside, too
        if s.is_nan() || s.abs() > 1.0 {
            return 0.0;
        }
        let mean = 0.5 * self.resultant() / self.extent;
        match self.form {
            // where it ends, the mean of both sides
            Form::Uniform if s.abs() == 1.0 => 0.5 * mean,
            Form::Uniform => mean,
            Form::Parabolic => 1.5 * mean * (1.0 - s * s),
            Form::Series | Form::Line => {
                let phi = s.acos();
                let sum = |coefficients: &[f64], first: usize| -> f64 {
                    coefficients.iter().enumerate().map(|(m, c)| c * ((2 * m + first) as f64 * phi).sin()).sum()
                };
                let corners = match self.corners {
                    0.0 => 0.0,
                    corners if s.abs() == 1.0 => corners * f64::INFINITY,
                    corners => corners / phi.sin(),
                };
                let tip = if self.tip == 0.0 { 0.0 } else { self.tip * s.abs().recip().acosh() };
                sum(&self.coefficients, 1) + mirror * sum(&self.skew, 2) + corners + tip
            }
        }
    }

    fn pressure(&self, x: f64) -> f64 {
        if self.at == 0.0 {
            return self.image(x, 1.0);
        }
        self.image(x - self.at, 1.0) + self.image(x + self.at, -1.0)
    }
}

impl Contact {
    /// As far as the bodies touch: the half-length, or the end of the last part.
    pub fn reach(&self) -> f64 {
        self.parts.last().map_or(self.half_length, |part| part.to)
    }

    /// All intervals in which the bodies touch, from left to right.
    pub fn intervals(&self) -> impl Iterator<Item = [f64; 2]> {
        let left = self.parts.iter().rev().map(|part| [-part.to, -part.from]);
        let right = self.parts.iter().map(|part| [part.from, part.to]);
        let (from, to) = (self.opening, self.half_length);
        let first = if from > 0.0 { vec![[-to, -from], [from, to]] } else { vec![[-to, to]] };
        left.chain(first).chain(right)
    }

    /// Contact pressure at `x` (compression positive); zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        if x == 0.0 && self.peak_pressure.is_infinite() {
            return self.peak_pressure;
        }
        self.strips.iter().map(|strip| strip.pressure(x)).sum()
    }
}

/// Counts of what was computed for a solution, and of what was not needed.
///
/// What is counted for the stack was done once for its [`Model`](crate::Model), however many punches and loads follow.
///
/// ```
/// use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
/// let slice = || Homogeneous::new(0.25, 1.0, 0.25);
/// let stack = Stack::builder(Plane::Strain).layer(slice()?).bonded().layer(slice()?).receding();
/// let model = Model::new(stack.layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
/// let stats = model.press(&Punch::cylinder(500.0)?, 0.002)?.stats().clone();
/// assert_eq!((stats.dropped, stats.merged), (0, 1));
/// assert_eq!(stats.layers + stats.below_decay_depth, stats.wavenumbers);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Layers of thickness zero, which are not there.
    pub dropped: usize,
    /// Layers that are one body with the layer or half-plane to which they are bonded, and were solved for with it.
    pub merged: usize,
    /// Wavenumbers at which the stack was evaluated.
    pub wavenumbers: usize,
    /// Layers evaluated, all wavenumbers together; a half-plane does not count.
    pub layers: usize,
    /// Layers that would have been evaluated, were they not in sequences that repeat others.
    pub repeated: usize,
    /// Layers that would have been evaluated, had they not been too deep for the wave to be felt.
    pub below_decay_depth: usize,
    /// Values of couplings between neighbouring contacts that vanish and were left out, all wavenumbers together.
    pub uncoupled: usize,
    /// Wavenumbers of the integrals of the contact equations, at which kernels were taken from values known before rather
    /// than evaluated; all layouts of integrals together.
    pub interpolated: usize,
    /// Terms in the series of each pressure, contacts from the top down.
    pub modes: Vec<usize>,
    /// Newton steps, and rounds of iteration, on each level of refinement, the coarsest first; for each force that was tried, if
    /// it was found.
    pub newton_steps: Vec<usize>,
    /// Systems of equations that were factorised.
    pub factorisations: usize,
    /// Why each level of refinement ended, the coarsest first; for each force that was tried, if it was found. Empty for an
    /// answer of low accuracy, and for contacts in several intervals.
    pub stopped: Vec<Stopped>,
}

/// Why a level of refinement ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// What is left is below the tolerance.
    Converged,
    /// What is left is below the truncation error: more modes are needed to make it smaller.
    Truncated,
    /// The iteration hardly grows shorter.
    Slow,
    /// The iteration goes nowhere: the modes that were solved for are all there is.
    Diverged,
    /// More wavenumbers would be needed than memory and time allow.
    Budget,
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Converged => "converged",
            Self::Truncated => "truncated",
            Self::Slow => "slow",
            Self::Diverged => "diverged",
            Self::Budget => "budget",
        })
    }
}

/// A solved scene: contacts from the top down, and what it took to find them.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Hash of the stack that it belongs to, which [`crate::Model`] sets and compares.
    pub(crate) stack: Option<u64>,
    pub(crate) contacts: Vec<Contact>,
    pub(crate) force: f64,
    pub(crate) force_error: f64,
    pub(crate) min_pressure: f64,
    pub(crate) min_gap: f64,
    pub(crate) stats: Stats,
    pub(crate) warnings: Vec<String>,
}

impl Solution {
    /// The contacts from the top down: the punch first.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// As far as the bodies touch, or a load presses, on the interface where that is farthest; `None` where a line load on
    /// x = 0 is all that presses.
    pub fn extent(&self) -> Option<f64> {
        let extent = self.contacts.iter().map(Contact::reach).fold(0.0, f64::max);
        (extent > 0.0).then_some(extent)
    }

    /// The line load P that presses, force per unit length out of plane: as given, or found for a half-length.
    pub fn force(&self) -> f64 {
        self.force
    }

    /// The solver's estimate of the absolute error of the force; 0 if it was given.
    pub fn force_error(&self) -> f64 {
        self.force_error
    }

    /// Smallest pressure found inside the contacts by the admissibility check, in stress.
    pub fn min_pressure(&self) -> f64 {
        self.min_pressure
    }

    /// Smallest gap found outside the contacts by the admissibility check, in length.
    pub fn min_gap(&self) -> f64 {
        self.min_gap
    }

    /// Largest number of modes by which a pressure was represented.
    pub fn modes(&self) -> usize {
        self.stats.modes.iter().copied().max().unwrap_or(0)
    }

    /// Number of wavenumbers at which the stack was evaluated.
    pub fn wavenumbers(&self) -> usize {
        self.stats.wavenumbers
    }

    /// Newton steps taken, all levels together.
    pub fn newton_steps(&self) -> usize {
        self.stats.newton_steps.iter().sum()
    }

    /// What was computed, and what was not needed.
    pub fn stats(&self) -> &Stats {
        &self.stats
    }

    /// What the user should know about this result, in full sentences; empty if there is nothing.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }
}
