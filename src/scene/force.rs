//! The force that presses, as it is written.
use std::fmt;

use super::value::ValueError;
use crate::geometry::Geometry;
use recede_layers::Positive;

/// The line load P that presses: force per unit length out of plane, or the contact that it has to bring about.
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
    /// A force > 0; in a scene `force: ...`.
    Given(f64),
    /// The force that makes the contact under the punch so long: its half-length > 0, in length; in a scene
    /// `half_length: ...`.
    ForHalfLength(f64),
    /// The force that makes the punch sink so far: its approach > 0, in length, see [`Model::approach`](crate::Model::approach); in a scene
    /// `depth: ...`.
    ForDepth(f64),
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
    fn parts(self) -> (&'static str, f64) {
        match self {
            Self::Given(number) => ("force", number),
            Self::ForHalfLength(number) => ("half_length", number),
            Self::ForDepth(number) => ("depth", number),
        }
    }

    /// The name of the field of a scene that says it.
    pub(crate) fn field(self) -> &'static str {
        self.parts().0
    }

    /// The number that is written.
    pub(crate) fn number(self) -> f64 {
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
        format!("{name} {:?}", self.number())
    }

    /// A force of the same kind with another number.
    pub(crate) fn with(self, number: f64) -> Self {
        match self {
            Self::Given(_) => Self::Given(number),
            Self::ForHalfLength(_) => Self::ForHalfLength(number),
            Self::ForDepth(_) => Self::ForDepth(number),
        }
    }

    /// The force, if its number is legal.
    pub(crate) fn checked(self) -> Result<Self, ValueError> {
        ValueError::checked(self.field(), self.number()).map(|number: Positive| self.with(number.get()))
    }
}

impl fmt::Display for Force {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.label(Geometry::PlaneStrain))
    }
}
