//! The stresses and strains whose largest values are searched for.
use super::FieldPoint;

/// A quantity whose largest value is searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// The largest shear stress in the plane.
    MaxShear,
    /// Von Mises' equivalent stress.
    VonMises,
    /// The larger principal stress in the plane.
    Tension,
    /// The larger principal strain in the plane, times a modulus of the layer.
    TensileStrain,
    /// The size of the shear stress on the lower face of a layer.
    FaceShear,
    /// The normal stress on the lower face of a layer.
    FaceTension,
}

impl Measure {
    /// The value of the stress at a point. Where stresses are infinite under a sharp tip it is not defined; along the face shear stresses come to 0 there.
    pub(super) fn of(self, point: &FieldPoint) -> f64 {
        if point.sigma_yy.is_infinite() {
            return 0.0;
        }
        match self {
            Self::MaxShear => point.max_shear(),
            Self::VonMises => point.von_mises(),
            Self::Tension => point.tension(),
            Self::TensileStrain => point.stiffness * point.tensile_strain(),
            Self::FaceShear => point.sigma_xy.abs(),
            Self::FaceTension => point.sigma_yy,
        }
    }

    /// Whether the square of the stress is smooth where the stress is 0, and the stress itself is not.
    fn is_norm(self) -> bool {
        matches!(self, Self::MaxShear | Self::VonMises | Self::FaceShear)
    }

    /// A smooth function of the place that grows with it.
    pub(super) fn smooth(self, point: &FieldPoint) -> f64 {
        let value = self.of(point);
        if self.is_norm() { value * value } else { value }
    }

    /// The value of the stress from the value of the smooth function.
    pub(super) fn value(self, smooth: f64) -> f64 {
        if self.is_norm() { smooth.abs().sqrt().copysign(smooth) } else { smooth }
    }

    /// Whether the stress is one on the lower faces of layers.
    pub(super) fn is_on_face(self) -> bool {
        matches!(self, Self::FaceShear | Self::FaceTension)
    }
}

/// A stress whose largest value is searched for, and the index of the layer in which it is; `None` for all of them.
pub(super) type ExtremeSearch = (Measure, Option<usize>);
