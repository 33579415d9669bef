//! A given pressure on the top face, as it is written.
use std::fmt;

use recede_layers::Positive;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::text::written;
use super::value::ValueError;

/// A pressure on the top face that is given, symmetric about its middle, with the force as its resultant; [`Loads`](super::Loads) say where.
///
/// ```
/// use recede::Load;
/// assert_eq!(Load::uniform(0.5)?.half_width(), 0.5);
/// assert_eq!(Load::Line.half_width(), 0.0);
/// assert!(Load::parabolic(0.0).is_err());
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Load {
    /// The whole force on a line.
    Line,
    /// The same pressure everywhere on |x| < half_width, x from the middle of the load.
    Uniform {
        /// Half-width of the loaded strip, in length.
        half_width: Positive,
    },
    /// A pressure like 1 − (x/half_width)².
    Parabolic {
        /// Half-width of the loaded strip, in length.
        half_width: Positive,
    },
    /// A pressure like √(1 − (x/half_width)²), as under Hertz's cylinder.
    Elliptic {
        /// Half-width of the loaded strip, in length.
        half_width: Positive,
    },
    /// The same pressure everywhere on a ring |r − radius| < half_width about the axis, in axisymmetric problems only.
    #[serde(skip_deserializing)]
    Ring {
        /// Radius of the middle of the ring, in length.
        radius: Positive,
        /// Half of its width, in length; at least a ten-thousandth of the radius.
        half_width: Positive,
    },
}

impl Load {
    /// The same pressure everywhere on |x| < half_width, > 0, in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the half-width is not positive and finite.
    pub fn uniform(half_width: f64) -> Result<Self, ValueError> {
        Ok(Self::Uniform { half_width: ValueError::checked("half_width", half_width)? })
    }

    /// A pressure like 1 − (x/half_width)², half_width > 0, in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the half-width is not positive and finite.
    pub fn parabolic(half_width: f64) -> Result<Self, ValueError> {
        Ok(Self::Parabolic { half_width: ValueError::checked("half_width", half_width)? })
    }

    /// A pressure like √(1 − (x/half_width)²), half_width > 0, in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the half-width is not positive and finite.
    pub fn elliptic(half_width: f64) -> Result<Self, ValueError> {
        Ok(Self::Elliptic { half_width: ValueError::checked("half_width", half_width)? })
    }

    /// The same pressure everywhere on a ring |r − radius| < half_width about the axis, both > 0, in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not positive and finite.
    pub fn ring(radius: f64, half_width: f64) -> Result<Self, ValueError> {
        Ok(Self::Ring {
            radius: ValueError::checked("radius", radius)?,
            half_width: ValueError::checked("half_width", half_width)?,
        })
    }

    /// Half-width of the loaded part of the face, in length: 0 of a line load, the outer radius of a ring.
    pub fn half_width(&self) -> f64 {
        match self {
            Self::Line => 0.0,
            Self::Uniform { half_width } | Self::Parabolic { half_width } | Self::Elliptic { half_width } => {
                half_width.get()
            }
            Self::Ring { radius, half_width } => radius.get() + half_width.get(),
        }
    }

    /// Radius of the hole in a ring, in length; 0 of all other loads.
    pub(crate) fn hole(&self) -> f64 {
        let Self::Ring { radius, half_width } = self else { return 0.0 };
        (radius.get() - half_width.get()).max(0.0)
    }
}

impl fmt::Display for Load {
    /// As it is written in a scene.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&written(self))
    }
}
