//! Plane and axisymmetric problems.
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
    /// The plane problem whose transformed equations hold. Axisymmetric problems have the equations of plane strain, with Bessel functions
    /// J₀ and J₁ in place of cosine and sine.
    pub fn plane(self) -> Plane {
        match self {
            Self::PlaneStrain | Self::Axisymmetric => Plane::Strain,
            Self::PlaneStress => Plane::Stress,
        }
    }

    /// The name by which a scene tells it.
    pub fn name(self) -> &'static str {
        match self {
            Self::PlaneStrain => "PlaneStrain",
            Self::PlaneStress => "PlaneStress",
            Self::Axisymmetric => "Axisymmetric",
        }
    }

    /// Whether the problem is axisymmetric.
    pub fn is_axisymmetric(self) -> bool {
        self == Self::Axisymmetric
    }

    /// The words for its quantities.
    ///
    /// ```
    /// use recede::Geometry;
    /// assert_eq!(Geometry::PlaneStrain.words().half_length, "half-length");
    /// assert_eq!(Geometry::Axisymmetric.words().half_length, "contact radius");
    /// ```
    pub fn words(self) -> &'static Words {
        match self {
            Self::PlaneStrain | Self::PlaneStress => &PLANE,
            Self::Axisymmetric => &AXISYMMETRIC,
        }
    }

    /// The length of an interval from `left` to `right`, on which a line load is spread; in axisymmetric problems the area of the disc about
    /// the axis, or of the half of a ring that lies on the side of the interval.
    pub(crate) fn size(self, left: f64, right: f64) -> f64 {
        match self {
            Self::PlaneStrain | Self::PlaneStress => right - left,
            Self::Axisymmetric => {
                let half_disc = |end: f64| std::f64::consts::FRAC_PI_2 * end * end.abs();
                half_disc(right) - half_disc(left)
            }
        }
    }
}

/// The coordinates by which stresses, strains and displacements have their names.
///
/// ```
/// use recede::{Coordinates, FieldQuantity, Geometry};
/// assert_eq!(Coordinates::from(Geometry::Axisymmetric), Coordinates::Cylindrical);
/// assert_eq!(FieldQuantity::SigmaYy.name_in(Coordinates::Cartesian), "sigma_zz");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Coordinates {
    /// x along the layers and y upwards, of plane problems.
    Plane,
    /// r from the axis and z downwards, of axisymmetric problems.
    Cylindrical,
    /// x and y along the layers and z downwards, under loads at several places (x, y).
    Cartesian,
}

impl Coordinates {
    /// The name of the coordinate along the layers.
    pub fn along(self) -> &'static str {
        if self == Self::Cylindrical { AXISYMMETRIC.along } else { PLANE.along }
    }
}

impl From<Geometry> for Coordinates {
    fn from(geometry: Geometry) -> Self {
        if geometry.is_axisymmetric() { Self::Cylindrical } else { Self::Plane }
    }
}

/// The words for quantities in tables, pictures and messages. Keys of JSON and columns of CSV are the same in all geometries, but for
/// [the names of fields](crate::FieldQuantity::name_in).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// The coordinate along the layers. About an axis it is counted along a diameter: at negative r, vectors have the same directions as at
    /// positive r.
    pub along: &'static str,
    /// The distance from the middle along the layers.
    pub distance: &'static str,
    /// Half of the length of a contact about the middle.
    pub half_length: &'static str,
    /// A force without extent.
    pub line_load: &'static str,
}

const PLANE: Words = Words { along: "x", distance: "|x|", half_length: "half-length", line_load: "line load" };

const AXISYMMETRIC: Words = Words { along: "r", distance: "r", half_length: "contact radius", line_load: "point load" };

impl From<Plane> for Geometry {
    fn from(plane: Plane) -> Self {
        match plane {
            Plane::Strain => Self::PlaneStrain,
            Plane::Stress => Self::PlaneStress,
        }
    }
}
