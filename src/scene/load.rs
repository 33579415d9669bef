//! Given pressures on the top face, as they are written.
use std::borrow::Cow;
use std::fmt;

use recede_layers::description::Value;
use recede_layers::{Positive, Thickness};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::value::{LoadsError, MOST_LOADS, ValueError};
use super::write::written;

/// Narrowest half-width of a ring in terms of its radius: as the difference of two discs it has so many digits less.
const NARROWEST: f64 = 1e-4;

/// A pressure on the top face that is given, symmetric about x = 0, with the force as its resultant.
///
/// ```
/// use recede::Load;
/// let uniform = Load::uniform(0.5)?;
/// assert_eq!(uniform.central_pressure(3.0), 3.0);
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
    /// Several of these at once, each at a distance from x = 0 and, beyond 0, with its mirror image.
    ///
    /// The force is divided among them in the ratio of their shares, a share being that of both images together. They may
    /// overlap.
    Several(Loads),
}

impl Load {
    /// Several loads at once: for each the distance ≥ 0 of its middle from x = 0, in length, beyond which it has a mirror
    /// image; its share > 0 of the force, in relation to the others; and what it is.
    ///
    /// ```
    /// use recede::Load;
    /// let wheels = Load::several(&[(0.7, 1.0, Load::uniform(0.1)?)])?; // one on each side, half of the force each
    /// assert_eq!(wheels.to_string(), "Several([(at: 0.7, share: 1.0, load: Uniform(half_width: 0.1))])");
    /// assert!((wheels.half_width() - 0.8).abs() < 1e-15);
    /// assert_eq!(wheels.central_pressure(1.0), 0.0);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal, [`ValueError::Loads`] if there are none or too many, or if one of them is
    /// itself several.
    pub fn several(loads: &[(f64, f64, Self)]) -> Result<Self, ValueError> {
        let part = |(at, share, load): &(f64, f64, Self)| {
            Ok(Part {
                at: ValueError::checked("at", *at)?,
                share: ValueError::checked("share", *share)?,
                load: load.clone(),
            })
        };
        let parts: Vec<Part> = loads.iter().map(part).collect::<Result<_, ValueError>>()?;
        Ok(Self::Several(parts.try_into()?))
    }

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

    /// One uniform pressure at a distance from x = 0, and its mirror image: about an axis it is a ring.
    pub(super) fn pair(at: Positive, half_width: Positive) -> Self {
        let (at, load) = (at.into(), Self::Uniform { half_width });
        Self::Several(Loads(vec![Part { at, share: Positive::ONE, load }]))
    }

    /// The distance and the half-width, if it is [`Self::pair`].
    pub(super) fn as_pair(&self) -> Option<(Positive, Positive)> {
        match self {
            Self::Several(Loads(parts)) => match &parts[..] {
                [Part { at, load: Self::Uniform { half_width }, .. }] => {
                    Some((Positive::try_from(at.get()).ok()?, *half_width))
                }
                _ => None,
            },
            _ => None,
        }
    }

    /// Whether it is known about an axis: several have to be one ring, and that not too narrow.
    pub(crate) fn is_known_about_axis(&self) -> bool {
        let is_wide = |(at, half_width): (Positive, Positive)| half_width.get() >= NARROWEST * at.get();
        !matches!(self, Self::Several(_)) || self.as_pair().is_some_and(is_wide)
    }

    /// Half-width of the loaded part of the face, in length; 0 of a line load. Of several loads, the outer end of the farthest.
    pub fn half_width(&self) -> f64 {
        match self {
            Self::Line => 0.0,
            Self::Uniform { half_width } | Self::Parabolic { half_width } | Self::Elliptic { half_width } => {
                half_width.get()
            }
            Self::Several(loads) => {
                loads.parts().into_iter().fold(0.0, |reach, (at, _, load)| reach.max(at + load.half_width()))
            }
        }
    }

    /// Whether some of the force presses on lines, where the pressure is infinite.
    pub fn has_lines(&self) -> bool {
        self.parts().into_iter().any(|(_, _, load)| *load == Self::Line)
    }

    /// Pressure at x = 0 for a force; infinite on a line.
    pub fn central_pressure(&self, force: f64) -> f64 {
        let mean = 0.5 * force / self.half_width();
        match self {
            Self::Line => f64::INFINITY,
            Self::Uniform { .. } => mean,
            Self::Parabolic { .. } => 1.5 * mean,
            Self::Elliptic { .. } => 4.0 / std::f64::consts::PI * mean,
            Self::Several(loads) => {
                let part = |(at, share, load): (f64, f64, &Self)| match load.half_width() {
                    0.0 if at == 0.0 => f64::INFINITY,
                    a if at <= a => share * load.central_pressure(force) * load.relative(at / a),
                    _ => 0.0,
                };
                loads.parts().into_iter().map(part).sum()
            }
        }
    }

    /// Pressure at a distance from the middle of the loaded strip, in half-widths, over that in the middle: where it
    /// jumps, the mean of both sides.
    fn relative(&self, s: f64) -> f64 {
        match self {
            Self::Uniform { .. } if s == 1.0 => 0.5,
            Self::Parabolic { .. } => 1.0 - s * s,
            Self::Elliptic { .. } => (1.0 - s * s).sqrt(),
            _ => 1.0,
        }
    }

    /// What it consists of: distances from x = 0, parts of the force with mirror images included, and loads that are no
    /// longer several.
    pub(crate) fn parts(&self) -> Vec<(f64, f64, &Self)> {
        match self {
            Self::Several(loads) => loads.parts(),
            one => vec![(0.0, 1.0, one)],
        }
    }
}

impl fmt::Display for Load {
    /// As it is written in a scene.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        written(self, f)
    }
}

/// One of several loads, and its mirror image if it is not in the middle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Distance of its middle from x = 0, in length.
    at: Thickness,
    /// Its part of the force, mirror image included, in relation to the other parts.
    share: Positive,
    /// What presses there.
    load: Load,
}

/// Loads that press at once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Part>", into = "Vec<Part>")]
pub struct Loads(Vec<Part>);

impl Loads {
    /// Distance of each from x = 0, its part of the force, of which all are 1 together, and what it is.
    fn parts(&self) -> Vec<(f64, f64, &Load)> {
        // shares may be so large that their sum is not finite
        let largest = self.0.iter().fold(0.0, |largest: f64, part| largest.max(part.share.get()));
        let sum: f64 = self.0.iter().map(|part| part.share.get() / largest).sum();
        self.0.iter().map(|part| (part.at.get(), part.share.get() / largest / sum, &part.load)).collect()
    }
}

impl From<Loads> for Vec<Part> {
    fn from(loads: Loads) -> Self {
        loads.0
    }
}

impl TryFrom<Vec<Part>> for Loads {
    type Error = LoadsError;

    fn try_from(parts: Vec<Part>) -> Result<Self, LoadsError> {
        if parts.is_empty() || parts.len() > MOST_LOADS {
            return Err(LoadsError::Count(parts.len()));
        }
        if parts.iter().any(|part| matches!(part.load, Load::Several(_))) {
            return Err(LoadsError::Nested);
        }
        Ok(Self(parts))
    }
}

impl JsonSchema for Loads {
    fn schema_name() -> Cow<'static, str> {
        "Loads".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Value::plain_schema(
            "[(at: x, share: s, load: ...), ...], one or more loads with their distances x >= 0 and shares s > 0",
        )
    }
}
