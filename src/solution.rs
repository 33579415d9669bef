//! What a solved scene tells.
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
    /// Half-length a: the contact covers |x| < a.
    pub half_length: f64,
    /// The solver's estimate of the absolute error of `half_length`.
    pub half_length_error: f64,
    /// Pressure at x = 0 (compression positive); infinite under the tip of a wedge.
    pub peak_pressure: f64,
    /// The solver's estimate of the absolute error of `peak_pressure`.
    pub peak_pressure_error: f64,
    /// Resultant of the pressure, force per unit length out of plane.
    pub resultant: f64,
    /// p(x) = Σ_m coefficients[m] sin((2m + 1) φ) with x = a cos φ, in stress.
    pub(crate) coefficients: Vec<f64>,
    /// How many coefficients waves that reach into the layers feel; the others are those of a half-plane, next to
    /// where the punch is not smooth.
    pub(crate) found: usize,
    /// The length a of the series: half_length, but of a line load, which is a very narrow strip.
    pub(crate) extent: f64,
}

impl Contact {
    /// Contact pressure at `x` (compression positive); zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        let s = x / self.extent;
        // NaN is outside, too
        if s.is_nan() || s.abs() >= 1.0 {
            return 0.0;
        }
        if s == 0.0 && self.peak_pressure.is_infinite() {
            return self.peak_pressure;
        }
        let phi = s.acos();
        self.coefficients.iter().enumerate().map(|(m, c)| c * ((2 * m + 1) as f64 * phi).sin()).sum()
    }
}

/// A solved scene: contacts from the top down, and what it took to find them.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    pub(crate) contacts: Vec<Contact>,
    pub(crate) min_pressure: f64,
    pub(crate) min_gap: f64,
    pub(crate) modes: usize,
    pub(crate) wavenumbers: usize,
    pub(crate) newton_steps: usize,
    pub(crate) warnings: Vec<String>,
}

impl Solution {
    /// The contacts from the top down: the punch first.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
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
        self.modes
    }

    /// Number of wavenumbers at which the stack was evaluated.
    pub fn wavenumbers(&self) -> usize {
        self.wavenumbers
    }

    /// Newton steps taken, all levels together.
    pub fn newton_steps(&self) -> usize {
        self.newton_steps
    }

    /// What the user should know about this result, in full sentences; empty if there is nothing.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }
}
