//! The force that presses, as it is written.
use std::fmt;

use super::value::ValueError;
use crate::geometry::Geometry;
use recede_layers::{Compressive, Finite, Positive};

/// The line load P that presses: force per unit length out of plane, or what it has to bring about.
///
/// ```
/// use recede::{Force, HalfPlane, Model, Plane, Punch, Stack};
/// let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
/// let solution = model.press(&Punch::parabola(500.0)?, Force::ForHalfLength(0.5))?;
/// let hertz = 2.0 * std::f64::consts::PI / 3.0 * 0.5f64.powi(2) / 500.0;
/// assert!((solution.force() / hertz - 1.0).abs() < 1e-10);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Force {
    /// A force > 0, or 0 under given loads where nothing presses but weights; in a scene `force: ...`.
    Given(f64),
    /// The force that makes the contact under the punch so long: its half-length > 0, in length; in a scene
    /// `half_length: ...`.
    ForHalfLength(f64),
    /// The force that makes the punch sink so far: its approach > 0, in length, see [`Model::approach`](crate::Model::approach); in a scene
    /// `depth: ...`.
    ForDepth(f64),
    /// Of one of several punches, the force for which its contact begins at this place on x, or ends there: `left: ...` and `right: ...`.
    ForLeft(f64),
    /// See [`Self::ForLeft`].
    ForRight(f64),
    /// What stands beside each of several punches, or loads: in a scene, where the force of a punch is to be found.
    OfEach,
}

impl From<f64> for Force {
    fn from(force: f64) -> Self {
        Self::Given(force)
    }
}

impl Force {
    /// The force, if it is given.
    pub fn given(self) -> Option<f64> {
        if let Self::Given(force) = self { Some(force) } else { None }
    }

    /// The name of the field of a scene that says it, and its number.
    fn parts(self) -> (&'static str, Option<f64>) {
        match self {
            Self::Given(number) => ("force", Some(number)),
            Self::ForHalfLength(number) => ("half_length", Some(number)),
            Self::ForDepth(number) => ("depth", Some(number)),
            Self::ForLeft(number) => ("left", Some(number)),
            Self::ForRight(number) => ("right", Some(number)),
            Self::OfEach => ("force", None),
        }
    }

    /// The name of the field of a scene that says it.
    pub(crate) fn field(self) -> &'static str {
        self.parts().0
    }

    /// The number that is written; none of what stands beside each of several punches.
    pub(crate) fn number(self) -> Option<f64> {
        self.parts().1
    }

    /// The force as it is shown beside a punch, with the word for a half-length in this geometry.
    ///
    /// ```
    /// use recede::{Force, Geometry};
    /// assert_eq!(Force::ForHalfLength(0.5).label(Geometry::Axisymmetric), "contact radius 0.5");
    /// ```
    pub fn label(self, geometry: Geometry) -> String {
        let name = if let Self::ForHalfLength(_) = self { geometry.words().half_length } else { self.field() };
        self.number().map_or_else(|| "forces to be found".to_owned(), |number| format!("{name} {number:?}"))
    }

    /// A force of the same kind with another number.
    pub(crate) fn with(self, number: f64) -> Self {
        match self {
            Self::Given(_) => Self::Given(number),
            Self::ForHalfLength(_) => Self::ForHalfLength(number),
            Self::ForDepth(_) => Self::ForDepth(number),
            Self::ForLeft(_) => Self::ForLeft(number),
            Self::ForRight(_) => Self::ForRight(number),
            Self::OfEach => Self::OfEach,
        }
    }

    /// The force, if its number is legal.
    pub(crate) fn checked(self) -> Result<Self, ValueError> {
        match (self, self.number()) {
            (Self::ForLeft(_) | Self::ForRight(_), Some(place)) => {
                ValueError::checked(self.field(), place).map(|place: Finite| self.with(place.get()))
            }
            (Self::Given(_), Some(number)) => {
                ValueError::checked(self.field(), number).map(|number: Compressive| self.with(number.get()))
            }
            (_, Some(number)) => {
                ValueError::checked(self.field(), number).map(|number: Positive| self.with(number.get()))
            }
            (_, None) => Ok(self),
        }
    }
}

impl fmt::Display for Force {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.label(Geometry::PlaneStrain))
    }
}
