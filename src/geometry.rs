//! Whether a problem is plane or round.
use recede_layers::Plane;
use schemars::JsonSchema;
use serde::Deserialize;

/// What the stack, the punch and all fields look like out of the plane of the drawing.
///
/// ```
/// use recede::{Geometry, Plane};
/// assert_eq!(Geometry::Axisymmetric.plane(), Plane::Strain);
/// assert_eq!(Geometry::from(Plane::Stress), Geometry::PlaneStress);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize, JsonSchema)]
pub enum Geometry {
    /// The same at all places out of the plane, and no strain there; forces are per unit length out of the plane.
    PlaneStrain,
    /// A thin plate, without stress out of the plane; forces are per unit thickness.
    PlaneStress,
    /// The same at all angles about the axis x = 0; forces are whole forces.
    Axisymmetric,
}

impl Geometry {
    /// Of which plane problem the transformed equations are. Those of an axisymmetric one are those of plane strain, with Bessel functions
    /// J₀ and J₁ in place of cosine and sine.
    pub fn plane(self) -> Plane {
        match self {
            Self::PlaneStrain | Self::Axisymmetric => Plane::Strain,
            Self::PlaneStress => Plane::Stress,
        }
    }

    /// Whether it is round.
    pub fn is_axisymmetric(self) -> bool {
        self == Self::Axisymmetric
    }
}

impl From<Plane> for Geometry {
    fn from(plane: Plane) -> Self {
        match plane {
            Plane::Strain => Self::PlaneStrain,
            Plane::Stress => Self::PlaneStress,
        }
    }
}
