//! A joint of two layers of a laminate: an interface that stays closed.
use std::fmt;

/// An interface that does not open, given by two stiffnesses: σ_yy is `normal` times the jump of v, σ_xy is `tangential` times the
/// jump of u. Bonded and sliding interfaces and springs differ in these numbers only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Stress per length; infinite where v is continuous.
    pub normal: f64,
    /// Stress per length; infinite where u is continuous, 0 where sliding is free.
    pub tangential: f64,
}

impl Joint {
    /// u and v are continuous.
    pub const BONDED: Self = Self { normal: f64::INFINITY, tangential: f64::INFINITY };
    /// v is continuous, and there is no friction.
    pub const SLIDING: Self = Self { normal: f64::INFINITY, tangential: 0.0 };

    /// Two joints in series, with no layer between them: compliances add up.
    pub(super) fn in_series(self, other: Self) -> Self {
        let together = |a: f64, b: f64| (a.recip() + b.recip()).recip();
        Self { normal: together(self.normal, other.normal), tangential: together(self.tangential, other.tangential) }
    }

    /// Whether v may jump.
    pub(super) fn gives_way(self) -> bool {
        self.normal.is_finite()
    }
}

impl fmt::Display for Joint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::BONDED => f.write_str("bonded"),
            Self::SLIDING => f.write_str("sliding"),
            Self { normal, tangential: 0.0 } => write!(f, "springs {normal:?}"),
            Self { normal, tangential } => write!(f, "springs {normal:?}, along {tangential:?}"),
        }
    }
}
