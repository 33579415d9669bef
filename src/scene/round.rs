//! Punches and loads about an axis, as they are written: in an axisymmetric scene a cylinder is a sphere, and half-widths are radii. The
//! profiles are the profiles of plane punches, so that each is read into one of these.
use recede_layers::{Exponent, Positive, Thickness};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::covered::Covered;
use super::elastic_cylinder::ElasticCylinder;
use super::heights::{PolynomialHeights, RoundHeights};
use super::load::Load;
use super::punch::Punch;
use super::text::written;
use super::wedge::Cone;
use crate::geometry::Geometry;

/// A frictionless punch about the axis, rigid unless it says otherwise; r is the distance from the axis.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) enum RoundPunch {
    /// A sphere, exactly: height R − √(R² − r²), slope r/√(R² − r²).
    Sphere {
        /// Radius R, in length.
        radius: Positive,
    },
    /// A paraboloid: height r²/(2R), slope r/R.
    Parabola {
        /// Radius of curvature R at the tip, in length.
        radius: Positive,
    },
    /// A power of the distance from the axis: height (r/radius)^exponent · height.
    Power {
        /// Exponent, 1 for a cone, 2 for a paraboloid; dimensionless.
        exponent: Exponent,
        /// Where the height is given, in length.
        radius: Positive,
        /// Height there above the tip, in length.
        height: Positive,
    },
    /// A polynomial in even powers: height h₁ s² + h₂ s⁴ + h₃ s⁶ + ..., s = r/radius. If it falls in the end, the punch
    /// ends where that begins.
    Polynomial {
        /// Where s is 1, in length.
        radius: Positive,
        /// h₁, h₂, h₃ and so on, in length.
        heights: PolynomialHeights,
    },
    /// A cone: height s r, s its slope or the cotangent of its half-angle. The pressure is infinite at the tip, like a logarithm.
    Cone(Cone),
    /// A flat punch with a rounded edge: height 0 up to flat_radius, from there on (r − flat_radius)²/(2R).
    RoundedFlat {
        /// Radius of the flat part, in length.
        flat_radius: Thickness,
        /// Radius of curvature R of the edge, in length.
        radius: Positive,
    },
    /// A flat punch with a sharp edge: the contact is as wide as the punch, and the pressure is infinite at its edge, like an inverse root.
    Flat {
        /// Radius of the punch, in length.
        radius: Positive,
    },
    /// Heights at distances from the axis, as in `Table([(0, 0), (0.5, 0.01), (1, 0.05)])`, with a smooth curve through
    /// them.
    Table(RoundHeights),
    /// A dent, of layers that lie on each other: a gap depth · exp(−(r/radius)²), and no punch.
    Dent {
        /// The gap in the middle, in length.
        depth: Positive,
        /// Where the gap is less by a factor e, in length.
        radius: Positive,
    },
    /// A sphere of an elastic material: it is flattened like a half-space.
    ElasticSphere(ElasticCylinder),
    /// A sphere with elastic layers on its core: a second stack, which is pressed on the first one.
    Covered(Covered),
}

/// A pressure about the axis that is given, with the force as its resultant.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) enum RoundLoad {
    /// The whole force at the point r = 0.
    Point,
    /// The same pressure everywhere on a disc.
    Uniform {
        /// Radius of the loaded disc, in length.
        radius: Positive,
    },
    /// A pressure like 1 − (r/radius)².
    Parabolic {
        /// Radius of the loaded disc, in length.
        radius: Positive,
    },
    /// A pressure like √(1 − (r/radius)²), as under Hertz's sphere.
    Elliptic {
        /// Radius of the loaded disc, in length.
        radius: Positive,
    },
    /// The same pressure everywhere on a ring, |r − radius| < half_width.
    Ring {
        /// Radius of the middle of the ring, in length.
        radius: Positive,
        /// Half of its width, in length; at least a ten-thousandth of the radius.
        half_width: Positive,
    },
}

/// Names in the plane and about the axis for the same forms: each is made into the other.
macro_rules! same {
    ($plane:ident and $round:ident: $($own:ident $fields:tt is $other:ident $others:tt),+ $(,)?) => {
        impl From<$round> for $plane {
            fn from(round: $round) -> Self {
                match round {
                    $($round::$other $others => Self::$own $fields,)+
                }
            }
        }

        impl From<$plane> for $round {
            fn from(plane: $plane) -> Self {
                match plane {
                    $($plane::$own $fields => Self::$other $others,)+
                }
            }
        }
    };
}

same!(Punch and RoundPunch:
    Cylinder { radius } is Sphere { radius },
    Parabola { radius } is Parabola { radius },
    Power { exponent, half_width: radius, height } is Power { exponent, radius, height },
    Polynomial { half_width: radius, heights } is Polynomial { radius, heights },
    Wedge(wedge) is Cone(Cone(wedge)),
    RoundedFlat { half_width: flat_radius, radius } is RoundedFlat { flat_radius, radius },
    Flat { half_width: radius } is Flat { radius },
    Table(heights) is Table(RoundHeights(heights)),
    Dent { depth, half_width: radius } is Dent { depth, radius },
    ElasticCylinder(sphere) is ElasticSphere(sphere),
    Covered(covered) is Covered(covered),
);

same!(Load and RoundLoad:
    Line {} is Point {},
    Uniform { half_width: radius } is Uniform { radius },
    Parabolic { half_width: radius } is Parabolic { radius },
    Elliptic { half_width: radius } is Elliptic { radius },
    Ring { radius, half_width } is Ring { radius, half_width },
);

impl Punch {
    /// As it is written in a scene of this geometry: in an axisymmetric one a cylinder is a sphere, and half-widths are radii.
    ///
    /// ```
    /// use recede::{Geometry, Punch};
    /// let flat = Punch::flat(0.5)?;
    /// assert_eq!(flat.written_in(Geometry::PlaneStrain), "Flat(half_width: 0.5)");
    /// assert_eq!(flat.written_in(Geometry::Axisymmetric), "Flat(radius: 0.5)");
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn written_in(&self, geometry: Geometry) -> String {
        match self {
            Self::Covered(covered) => covered.written(geometry),
            _ if geometry.is_axisymmetric() => written(&RoundPunch::from(self.clone())),
            _ => self.to_string(),
        }
    }
}

impl Load {
    /// As it is written in a scene of this geometry.
    pub(crate) fn written_in(&self, geometry: Geometry) -> String {
        if geometry.is_axisymmetric() { written(&RoundLoad::from(self.clone())) } else { self.to_string() }
    }
}
