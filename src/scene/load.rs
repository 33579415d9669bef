//! Given pressures on the top face, as they are written.
use std::fmt;

use recede_layers::Positive;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;

/// A pressure on the top face that is given, symmetric about x = 0, with the force as its resultant.
///
/// ```
/// use recede::Load;
/// let uniform = Load::uniform(0.5)?;
/// assert_eq!(uniform.peak_pressure(3.0), 3.0);
/// assert_eq!(Load::Line.half_width(), 0.0);
/// assert!(Load::parabolic(0.0).is_err());
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Load {
    /// The whole force on the line x = 0.
    Line,
    /// The same pressure everywhere on |x| < half_width.
    Uniform {
        /// Half-width of the loaded strip, in length.
        half_width: Positive,
    },
    /// A pressure like 1 − (x/half_width)².
    Parabolic {
        /// Half-width of the loaded strip, in length.
        half_width: Positive,
    },
    /// A pressure like √(1 − (x/half_width)²), that of Hertz.
    Elliptic {
        /// Half-width of the loaded strip, in length.
        half_width: Positive,
    },
}

impl Load {
    /// The same pressure everywhere on |x| < half_width, > 0, in length.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the half-width is not positive and finite.
    pub fn uniform(half_width: f64) -> Result<Self, Error> {
        Ok(Self::Uniform { half_width: Error::checked("half_width", half_width)? })
    }

    /// A pressure like 1 − (x/half_width)², half_width > 0, in length.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the half-width is not positive and finite.
    pub fn parabolic(half_width: f64) -> Result<Self, Error> {
        Ok(Self::Parabolic { half_width: Error::checked("half_width", half_width)? })
    }

    /// A pressure like √(1 − (x/half_width)²), half_width > 0, in length.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the half-width is not positive and finite.
    pub fn elliptic(half_width: f64) -> Result<Self, Error> {
        Ok(Self::Elliptic { half_width: Error::checked("half_width", half_width)? })
    }

    /// Half-width of the loaded strip, in length; 0 of a line.
    pub fn half_width(&self) -> f64 {
        match self {
            Self::Line => 0.0,
            Self::Uniform { half_width } | Self::Parabolic { half_width } | Self::Elliptic { half_width } => {
                half_width.get()
            }
        }
    }

    /// Pressure at x = 0 for a force; infinite on a line.
    pub fn peak_pressure(&self, force: f64) -> f64 {
        let mean = 0.5 * force / self.half_width();
        match self {
            Self::Line => f64::INFINITY,
            Self::Uniform { .. } => mean,
            Self::Parabolic { .. } => 1.5 * mean,
            Self::Elliptic { .. } => 4.0 / std::f64::consts::PI * mean,
        }
    }

    /// y_m of p̂(λ) = (2P/λa) Σ y_m J_(2m+1)(λa), y_0 = 1, a the half-width: the first `count` of them.
    pub(crate) fn modes(&self, count: usize) -> Vec<f64> {
        let sign = |m: usize| if m.is_multiple_of(2) { 1.0 } else { -1.0 };
        let mode = |m: usize| match self {
            Self::Line | Self::Elliptic { .. } => f64::from(u8::from(m == 0)),
            Self::Uniform { .. } => sign(m),
            Self::Parabolic { .. } => {
                let j = (2 * m + 1) as f64;
                -3.0 * sign(m) / (j * j - 4.0)
            }
        };
        (0..count).map(mode).collect()
    }
}

impl fmt::Display for Load {
    /// As it is written in a scene.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Self::Line => return f.write_str("Line"),
            Self::Uniform { .. } => "Uniform",
            Self::Parabolic { .. } => "Parabolic",
            Self::Elliptic { .. } => "Elliptic",
        };
        write!(f, "{name}(half_width: {:?})", self.half_width())
    }
}
