//! Frictionless punches, as they are written.
//!
//! A punch is one variant here with its documentation, from which it is read, written and listed, and one line in
//! [`Punch::shape`], which says what its profile is made of.
use std::fmt;

use recede_layers::{Exponent, Finite, Isotropic, Positive, Thickness};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::covered::Covered;
use super::elastic_cylinder::ElasticCylinder;
use super::heights::{Heights, PolynomialHeights};
use super::shape::{Piece, Shape, even};
use super::text::written;
use super::value::ValueError;
use super::wedge::Wedge;
use crate::geometry::Geometry;

/// A frictionless punch with its tip at x = 0, rigid unless it says otherwise.
///
/// ```
/// use recede::Punch;
/// let cylinder = Punch::cylinder(500.0)?;
/// assert!((cylinder.slope(300.0) - 0.75).abs() < 1e-15);
/// assert!((cylinder.profile(300.0) - 100.0).abs() < 1e-12);
/// assert_eq!(cylinder.max_half_length(), Some(500.0));
/// assert_eq!(cylinder.to_string(), "Cylinder(radius: 500.0)");
/// assert!(Punch::parabola(f64::NAN).is_err());
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Punch {
    /// A circular cylinder, exactly: height R − √(R² − x²), slope x/√(R² − x²).
    Cylinder {
        /// Radius R, in length.
        radius: Positive,
    },
    /// A parabola: height x²/(2R), slope x/R.
    Parabola {
        /// Radius of curvature R at the tip, in length.
        radius: Positive,
    },
    /// A power of the distance from the tip: height (|x|/half_width)^exponent · height.
    Power {
        /// Exponent, 1 for a wedge, 2 for a parabola; dimensionless.
        exponent: Exponent,
        /// Where the height is given, in length.
        half_width: Positive,
        /// Height there above the tip, in length.
        height: Positive,
    },
    /// A polynomial in even powers: height h₁ s² + h₂ s⁴ + h₃ s⁶ + ..., s = x/half_width. If it falls in the end, the punch
    /// ends where that begins.
    Polynomial {
        /// Where s is 1, in length.
        half_width: Positive,
        /// h₁, h₂, h₃ and so on, in length.
        heights: PolynomialHeights,
    },
    /// A wedge: height s |x|, s its slope or the cotangent of its half-angle, with another slope on the left if there is one. The pressure is
    /// infinite at the tip, like a logarithm.
    Wedge(Wedge),
    /// A flat punch with rounded corners: height 0 up to half_width, from there on (|x| − half_width)²/(2R).
    RoundedFlat {
        /// Half-width of the flat part, in length.
        half_width: Thickness,
        /// Radius of curvature R of the corners, in length.
        radius: Positive,
    },
    /// A flat punch with sharp corners: the contact is as long as the punch, and the pressure is infinite at its corners, like
    /// an inverse root.
    Flat {
        /// Half-width of the punch, in length.
        half_width: Positive,
    },
    /// Heights at distances from the tip, as in `Table([(0, 0), (0.5, 0.01), (1, 0.05)])`, with a smooth curve through
    /// them. If the left is not the mirror image of the right, the distances on the left are negative.
    Table(Heights),
    /// A dent, of layers that lie on each other: a gap depth · exp(−(x/half_width)²), and no punch.
    Dent {
        /// The gap in the middle, in length.
        depth: Positive,
        /// Where the gap is less by a factor e, in length.
        half_width: Positive,
    },
    /// A circular cylinder of an elastic material: it is flattened like a half-plane.
    ElasticCylinder(ElasticCylinder),
    /// A circular cylinder with elastic layers on its core: a second stack, which is pressed on the first one.
    Covered(Covered),
}

impl Punch {
    /// A circular cylinder of radius R > 0, in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the radius is not positive and finite.
    pub fn cylinder(radius: f64) -> Result<Self, ValueError> {
        Ok(Self::Cylinder { radius: ValueError::checked("radius", radius)? })
    }

    /// A parabola of radius of curvature R > 0, in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the radius is not positive and finite.
    pub fn parabola(radius: f64) -> Result<Self, ValueError> {
        Ok(Self::Parabola { radius: ValueError::checked("radius", radius)? })
    }

    /// The height (|x|/half_width)^exponent · height, lengths > 0, exponent from 1 to 100.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal.
    pub fn power(exponent: f64, half_width: f64, height: f64) -> Result<Self, ValueError> {
        Ok(Self::Power {
            exponent: ValueError::checked("exponent", exponent)?,
            half_width: ValueError::checked("half_width", half_width)?,
            height: ValueError::checked("height", height)?,
        })
    }

    /// The height Σ h_k (x/half_width)^(2k), k = 1, 2, ..., all in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal, [`ValueError::Heights`] if all heights are zero or there are none.
    pub fn polynomial(half_width: f64, heights: &[f64]) -> Result<Self, ValueError> {
        let heights: Vec<Finite> =
            heights.iter().map(|h| ValueError::checked("heights", *h)).collect::<Result<_, _>>()?;
        Ok(Self::Polynomial {
            half_width: ValueError::checked("half_width", half_width)?,
            heights: heights.try_into()?,
        })
    }

    /// A wedge with faces of this slope > 0, dimensionless.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the slope is not positive and finite.
    pub fn wedge(slope: f64) -> Result<Self, ValueError> {
        Wedge::of_slope(slope, None).map(Self::Wedge)
    }

    /// A wedge with a face of slope `right` > 0 on x > 0 and one of slope `left` > 0, counted outwards, on x < 0; dimensionless.
    ///
    /// ```
    /// use recede::Punch;
    /// let wedge = Punch::uneven_wedge(0.2, 0.1)?;
    /// assert_eq!(wedge.to_string(), "Wedge(slope: 0.1, left: 0.2)");
    /// assert!(!wedge.is_even() && (wedge.profile(-3.0) - 0.6).abs() < 1e-15);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a slope is not positive and finite.
    pub fn uneven_wedge(left: f64, right: f64) -> Result<Self, ValueError> {
        Wedge::of_slope(right, Some(left)).map(Self::Wedge)
    }

    /// A wedge with faces at this angle to the axis, 0 < angle < π/2, in radians: half of the angle at its tip.
    ///
    /// ```
    /// use recede::Punch;
    /// let wedge = Punch::wedge_of_half_angle(70.3f64.to_radians())?;
    /// assert!((wedge.slope(2.0) - 19.7f64.to_radians().tan()).abs() < 1e-15);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the angle is not legal.
    pub fn wedge_of_half_angle(angle: f64) -> Result<Self, ValueError> {
        Wedge::of_half_angle(angle).map(Self::Wedge)
    }

    /// A flat punch of half-width ≥ 0 with corners of radius > 0, in length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal.
    pub fn rounded_flat(half_width: f64, radius: f64) -> Result<Self, ValueError> {
        Ok(Self::RoundedFlat {
            half_width: ValueError::checked("half_width", half_width)?,
            radius: ValueError::checked("radius", radius)?,
        })
    }

    /// A flat punch of half-width > 0, in length, with sharp corners.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the half-width is not positive and finite.
    pub fn flat(half_width: f64) -> Result<Self, ValueError> {
        Ok(Self::Flat { half_width: ValueError::checked("half_width", half_width)? })
    }

    /// A smooth curve through (x, height), in length, from x = 0 to the edge of the punch, with its mirror image on the left; or from one edge to
    /// the other, with x = 0, the tip, among them.
    ///
    /// ```
    /// use recede::Punch;
    /// let half = Punch::table(&[(0.0, 0.0), (1.0, 0.1), (2.0, 0.3)])?;
    /// let whole = Punch::table(&[(-2.0, 0.3), (-1.0, 0.1), (0.0, 0.0), (1.0, 0.1), (2.0, 0.3)])?;
    /// assert!(whole.is_even() && whole.profile(-1.3) == half.profile(1.3));
    /// assert!(!Punch::table(&[(-2.0, 0.2), (0.0, 0.0), (1.0, 0.1)])?.is_even());
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal, [`ValueError::Heights`] if x does not increase, or not from the tip or across it.
    pub fn table(rows: &[(f64, f64)]) -> Result<Self, ValueError> {
        let checked =
            |(x, height): &(f64, f64)| Ok((ValueError::checked("x", *x)?, ValueError::checked("height", *height)?));
        let rows: Vec<(Finite, Finite)> = rows.iter().map(checked).collect::<Result<_, ValueError>>()?;
        Ok(Self::Table(rows.try_into()?))
    }

    /// A circular cylinder of radius R > 0, in length, of an elastic material.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal.
    pub fn elastic_cylinder(radius: f64, shear_modulus: f64, poisson: f64) -> Result<Self, ValueError> {
        ElasticCylinder::new(radius, shear_modulus, poisson).map(Self::ElasticCylinder)
    }

    /// A dent of layers that lie on each other, depth · exp(−(x/half_width)²), both > 0, in length: a gap, and no punch.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal.
    pub fn dent(depth: f64, half_width: f64) -> Result<Self, ValueError> {
        Ok(Self::Dent {
            depth: ValueError::checked("depth", depth)?,
            half_width: ValueError::checked("half_width", half_width)?,
        })
    }

    /// What the profile is made of.
    pub(crate) fn shape(&self) -> Shape<'_> {
        match self {
            Self::Cylinder { radius } => Shape::Circle(radius.get()),
            Self::ElasticCylinder(cylinder) => Shape::Circle(cylinder.radius()),
            Self::Covered(covered) => Shape::Circle(covered.radius()),
            Self::Parabola { radius } => Shape::power(radius.get(), 2.0, 0.5 * radius.get()),
            Self::Power { exponent, half_width, height } => {
                Shape::power(half_width.get(), exponent.get(), height.get())
            }
            Self::Polynomial { half_width, heights } => {
                let end = heights.end().map(|end| half_width.get() * end);
                Shape::Powers { length: half_width.get(), terms: heights.terms(), tilt: 0.0, end }
            }
            Self::Wedge(wedge) => {
                let [mean, tilt] = [wedge.slope() + wedge.left(), wedge.slope() - wedge.left()].map(|both| 0.5 * both);
                Shape::Powers { length: 1.0, terms: vec![(1.0, mean)], tilt, end: None }
            }
            Self::RoundedFlat { half_width, radius } => {
                let corner = Piece::starting(half_width.get(), [0.0, 0.0, 0.5 / radius.get(), 0.0]);
                let pieces = even(&[Piece::starting(0.0, [0.0; 4]), corner], f64::INFINITY);
                Shape::Pieces { pieces: pieces.into(), end: f64::INFINITY }
            }
            Self::Flat { half_width } => Shape::Flat(half_width.get()),
            Self::Table(heights) => heights.shape(),
            Self::Dent { depth, half_width } => Shape::Dent { depth: depth.get(), half_width: half_width.get() },
        }
    }

    /// The material of an elastic punch; `None` if it is rigid.
    pub fn material(&self) -> Option<Isotropic> {
        if let Self::ElasticCylinder(cylinder) = self { Some(cylinder.material()) } else { None }
    }

    /// Whether the punch is its own mirror image about x = 0.
    pub fn is_even(&self) -> bool {
        self.shape().is_even()
    }

    /// Whether the pressure is infinite at the tip.
    pub fn is_sharp(&self) -> bool {
        matches!(self.shape(), Shape::Powers { terms, .. } if terms.iter().any(|(exponent, _)| *exponent == 1.0))
    }

    /// Whether the pressure is infinite somewhere, under its tip or at its corners.
    pub fn is_singular(&self) -> bool {
        self.is_sharp() || matches!(self, Self::Flat { .. })
    }

    /// Slope f'(x) of the punch at x, dimensionless; infinite at and beyond a cylinder's edge.
    pub fn slope(&self, x: f64) -> f64 {
        self.shape().slope(x)
    }

    /// Derivative f''(x) of the slope, in 1/length; infinite at and beyond a cylinder's edge.
    pub fn curvature(&self, x: f64) -> f64 {
        self.shape().curvature(x)
    }

    /// Height f(x) of the punch above its tip, in length; infinite beyond a cylinder's edge.
    pub fn profile(&self, x: f64) -> f64 {
        self.shape().height(x)
    }

    /// Half-length that no contact can exceed: a cylinder's radius, the end of a table, half of its length if it is uneven, where a polynomial
    /// begins to fall for good, the half-width of a flat punch with sharp corners; `None` if there is no such limit.
    pub fn max_half_length(&self) -> Option<f64> {
        self.shape().edge()
    }
}

impl fmt::Display for Punch {
    /// As it is written in a scene.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Covered(covered) => f.write_str(&covered.written(Geometry::PlaneStrain)),
            _ => f.write_str(&written(self)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<Punch> {
        vec![
            Punch::cylinder(2.0).unwrap(),
            Punch::parabola(2.0).unwrap(),
            Punch::power(2.5, 1.5, 0.2).unwrap(),
            Punch::polynomial(1.5, &[0.3, 0.0, 0.1]).unwrap(),
            Punch::wedge(0.1).unwrap(),
            Punch::wedge_of_half_angle(1.2).unwrap(),
            Punch::rounded_flat(0.7, 3.0).unwrap(),
            Punch::flat(1.5).unwrap(),
            Punch::table(&[(0.0, 0.0), (0.5, 0.1), (1.0, 0.5), (1.5, 1.0)]).unwrap(),
            Punch::elastic_cylinder(2.0, 3.0, 0.25).unwrap(),
            Punch::dent(0.1, 0.7).unwrap(),
            Punch::uneven_wedge(0.2, 0.1).unwrap(),
            Punch::table(&[(-1.6, 0.9), (-0.7, 0.3), (0.0, 0.1), (0.3, 0.2), (1.5, 1.9)]).unwrap(),
            Punch::table(&[(-1.5, 1.9), (-0.3, 0.2), (0.0, 0.1), (0.3, 0.2), (1.5, 1.9)]).unwrap(),
        ]
    }

    #[test]
    fn near_its_tip_a_cylinder_is_a_parabola() {
        let (cylinder, parabola) = (Punch::cylinder(1e8).unwrap(), Punch::parabola(1e8).unwrap());
        for x in [1e-150, 1e-3, 1.0] {
            assert!((cylinder.slope(x) / parabola.slope(x) - 1.0).abs() < 1e-15);
            assert!((cylinder.profile(x) / parabola.profile(x) - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn heights_are_even_and_slopes_odd_up_to_the_edge_and_beyond() {
        for punch in all() {
            let same = |x: f64| punch.profile(-x) == punch.profile(x) && punch.slope(-x) == -punch.slope(x);
            assert_eq!([0.0, 0.5, 2.0, 3.0].into_iter().all(same), punch.is_even(), "{punch}");
        }
        assert_eq!(all().iter().filter(|punch| !punch.is_even()).count(), 2);
        let cylinder = Punch::cylinder(2.0).unwrap();
        assert_eq!(cylinder.profile(2.0), 2.0);
        assert_eq!(cylinder.slope(2.0), f64::INFINITY);
        assert_eq!(cylinder.profile(2.1), f64::INFINITY);
    }

    #[test]
    fn slopes_and_curvatures_are_derivatives() {
        for (punch, x) in all().iter().flat_map(|punch| [(punch, 1.2), (punch, -1.2)]) {
            let step = 1e-5;
            let difference = (punch.profile(x + step) - punch.profile(x - step)) / (2.0 * step);
            assert!((difference - punch.slope(x)).abs() <= 1e-8 * punch.slope(x).abs(), "{punch}");
            let difference = (punch.slope(x + step) - punch.slope(x - step)) / (2.0 * step);
            assert!((difference - punch.curvature(x)).abs() < 1e-8, "{punch}");
        }
    }

    #[test]
    fn huge_radii_do_not_overflow() {
        assert!((Punch::cylinder(1e308).unwrap().slope(1e300) / 1e-8 - 1.0).abs() < 1e-15);
        assert!((Punch::parabola(1e308).unwrap().slope(1e300) / 1e-8 - 1.0).abs() < 1e-15);
    }
}
