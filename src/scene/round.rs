//! Punches and loads about an axis, as they are written: in an axisymmetric scene a cylinder is a sphere, and half-widths are radii. The
//! profiles are those of the plane punches, so that each is read into one of these.
use recede_layers::{Exponent, Positive, Thickness};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::elastic_cylinder::ElasticCylinder;
use super::heights::{PolynomialHeights, RoundHeights};
use super::load::Load;
use super::punch::Punch;
use super::text::Written;
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
    /// A sphere of an elastic material: it is flattened like a half-space.
    ElasticSphere(ElasticCylinder),
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
    /// A pressure like √(1 − (r/radius)²), that of Hertz.
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

impl From<RoundPunch> for Punch {
    fn from(punch: RoundPunch) -> Self {
        match punch {
            RoundPunch::Sphere { radius } => Self::Cylinder { radius },
            RoundPunch::Parabola { radius } => Self::Parabola { radius },
            RoundPunch::Power { exponent, radius, height } => Self::Power { exponent, half_width: radius, height },
            RoundPunch::Polynomial { radius, heights } => Self::Polynomial { half_width: radius, heights },
            RoundPunch::Cone(Cone(wedge)) => Self::Wedge(wedge),
            RoundPunch::RoundedFlat { flat_radius, radius } => Self::RoundedFlat { half_width: flat_radius, radius },
            RoundPunch::Flat { radius } => Self::Flat { half_width: radius },
            RoundPunch::Table(RoundHeights(heights)) => Self::Table(heights),
            RoundPunch::ElasticSphere(sphere) => Self::ElasticCylinder(sphere),
        }
    }
}

impl From<RoundLoad> for Load {
    fn from(load: RoundLoad) -> Self {
        match load {
            RoundLoad::Point => Self::Line,
            RoundLoad::Uniform { radius } => Self::Uniform { half_width: radius },
            RoundLoad::Parabolic { radius } => Self::Parabolic { half_width: radius },
            RoundLoad::Elliptic { radius } => Self::Elliptic { half_width: radius },
            RoundLoad::Ring { radius, half_width } => Self::Ring { radius, half_width },
        }
    }
}

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
        match geometry {
            Geometry::Axisymmetric => Written(RoundPunch::of(self)).to_string(),
            _ => self.to_string(),
        }
    }
}

impl RoundPunch {
    /// The punch about the axis.
    pub(super) fn of(punch: &Punch) -> Self {
        match punch.clone() {
            Punch::Cylinder { radius } => Self::Sphere { radius },
            Punch::Parabola { radius } => Self::Parabola { radius },
            Punch::Power { exponent, half_width, height } => Self::Power { exponent, radius: half_width, height },
            Punch::Polynomial { half_width, heights } => Self::Polynomial { radius: half_width, heights },
            Punch::Wedge(wedge) => Self::Cone(Cone(wedge)),
            Punch::RoundedFlat { half_width, radius } => Self::RoundedFlat { flat_radius: half_width, radius },
            Punch::Flat { half_width } => Self::Flat { radius: half_width },
            Punch::Table(heights) => Self::Table(RoundHeights(heights)),
            Punch::ElasticCylinder(sphere) => Self::ElasticSphere(sphere),
        }
    }
}

impl RoundLoad {
    /// The load about the axis.
    pub(super) fn of(load: &Load) -> Self {
        match *load {
            Load::Line => Self::Point,
            Load::Uniform { half_width } => Self::Uniform { radius: half_width },
            Load::Parabolic { half_width } => Self::Parabolic { radius: half_width },
            Load::Elliptic { half_width } => Self::Elliptic { radius: half_width },
            Load::Ring { radius, half_width } => Self::Ring { radius, half_width },
        }
    }
}
