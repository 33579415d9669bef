//! Rigid, symmetric, frictionless punches.
use recede_layers::Positive;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;

/// A rigid, frictionless punch with its tip at x = 0.
///
/// ```
/// use recede::Punch;
/// let cylinder = Punch::cylinder(500.0)?;
/// assert!((cylinder.slope(300.0) - 0.75).abs() < 1e-15);
/// assert!((cylinder.profile(300.0) - 100.0).abs() < 1e-12);
/// assert_eq!(cylinder.max_half_length(), Some(500.0));
/// assert!(Punch::parabola(f64::NAN).is_err());
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
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
}

impl Punch {
    /// A circular cylinder of radius R > 0, in length.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the radius is not positive and finite.
    pub fn cylinder(radius: f64) -> Result<Self, Error> {
        Ok(Self::Cylinder { radius: Error::checked("radius", radius)? })
    }

    /// A parabola of radius of curvature R > 0, in length.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the radius is not positive and finite.
    pub fn parabola(radius: f64) -> Result<Self, Error> {
        Ok(Self::Parabola { radius: Error::checked("radius", radius)? })
    }

    /// The name by which the punch is written in a scene.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Cylinder { .. } => "Cylinder",
            Self::Parabola { .. } => "Parabola",
        }
    }

    /// Radius of curvature R at the tip, in length.
    pub fn radius(&self) -> f64 {
        match self {
            Self::Cylinder { radius } | Self::Parabola { radius } => radius.get(),
        }
    }

    /// Slope f'(x) of the punch at x, dimensionless; infinite at and beyond a cylinder's edge.
    pub fn slope(&self, x: f64) -> f64 {
        let s = x / self.radius();
        match self {
            Self::Cylinder { .. } if s.abs() >= 1.0 => f64::INFINITY.copysign(s),
            Self::Cylinder { .. } => s / cosine(s),
            Self::Parabola { .. } => s,
        }
    }

    /// Derivative f''(x) of the slope, in 1/length; infinite at and beyond a cylinder's edge.
    pub fn curvature(&self, x: f64) -> f64 {
        let s = x / self.radius();
        match self {
            Self::Cylinder { .. } if s.abs() >= 1.0 => f64::INFINITY,
            Self::Cylinder { .. } => self.radius().recip() / cosine(s).powi(3),
            Self::Parabola { .. } => self.radius().recip(),
        }
    }

    /// Height f(x) of the punch above its tip, in length; infinite beyond a cylinder's edge.
    pub fn profile(&self, x: f64) -> f64 {
        let s = x / self.radius();
        match self {
            Self::Cylinder { .. } if s.abs() > 1.0 => f64::INFINITY,
            // R − √(R² − x²) without the difference of two large numbers
            Self::Cylinder { .. } => x * s / (1.0 + cosine(s)),
            Self::Parabola { .. } => 0.5 * x * s,
        }
    }

    /// Half-length that no contact can exceed: a cylinder's radius; `None` if there is no such limit.
    pub fn max_half_length(&self) -> Option<f64> {
        match self {
            Self::Cylinder { radius } => Some(radius.get()),
            Self::Parabola { .. } => None,
        }
    }
}

/// √(1 − s²), accurate also near |s| = 1.
fn cosine(s: f64) -> f64 {
    ((1.0 - s) * (1.0 + s)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let cylinder = Punch::cylinder(2.0).unwrap();
        for x in [0.0, 0.5, 2.0, 3.0] {
            assert_eq!(cylinder.profile(-x), cylinder.profile(x));
            assert_eq!(cylinder.slope(-x), -cylinder.slope(x));
        }
        assert_eq!(cylinder.profile(2.0), 2.0);
        assert_eq!(cylinder.slope(2.0), f64::INFINITY);
        assert_eq!(cylinder.profile(2.1), f64::INFINITY);
    }

    #[test]
    fn curvature_is_the_derivative_of_the_slope() {
        for punch in [Punch::cylinder(2.0).unwrap(), Punch::parabola(2.0).unwrap()] {
            let (x, step) = (1.2, 1e-5);
            let difference = (punch.slope(x + step) - punch.slope(x - step)) / (2.0 * step);
            assert!((difference / punch.curvature(x) - 1.0).abs() < 1e-8);
        }
    }

    #[test]
    fn huge_radii_do_not_overflow() {
        assert!((Punch::cylinder(1e308).unwrap().slope(1e300) / 1e-8 - 1.0).abs() < 1e-15);
    }
}
