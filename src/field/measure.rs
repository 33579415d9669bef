//! What is searched for its largest value, and places where it may be.
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
    /// The size of the shear stress on the lower face of a layer.
    FaceShear,
    /// The normal stress on the lower face of a layer.
    FaceTension,
}

impl Measure {
    /// Its value at a point. Where stresses are infinite under a sharp tip none is defined; along the face shear stresses come to 0 there.
    pub(super) fn of(self, point: &FieldPoint) -> f64 {
        if point.sigma_yy.is_infinite() {
            return 0.0;
        }
        match self {
            Self::MaxShear => point.max_shear(),
            Self::VonMises => point.von_mises(),
            Self::Tension => point.tension(),
            Self::FaceShear => point.sigma_xy.abs(),
            Self::FaceTension => point.sigma_yy,
        }
    }

    /// Whether its square is smooth where it is 0, rather than itself.
    pub(super) fn is_norm(self) -> bool {
        matches!(self, Self::MaxShear | Self::VonMises | Self::FaceShear)
    }

    /// Whether it is one of the lower faces of layers.
    pub(super) fn is_on_face(self) -> bool {
        matches!(self, Self::FaceShear | Self::FaceTension)
    }
}

/// A value that is higher by less than this part than what is expected at a peak is no higher.
const ROUNDED: f64 = 1e-7;

/// What is searched for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search {
    pub(super) measure: Measure,
    /// Index of the layer; `None` for all of them.
    pub(super) layer: Option<usize>,
}

/// A place in a layer, and its value there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) x: f64,
    /// Below the top face of the layer.
    pub(super) depth: f64,
    pub(super) value: f64,
}

/// A place in a layer, and the value of a quantity that is expected there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Peak {
    pub(super) measure: Measure,
    pub(super) layer: usize,
    pub(super) x: f64,
    /// Below the top face of the layer.
    pub(super) depth: f64,
    pub(super) value: f64,
    /// The length that steps are parts of; 0 at the end of a contact, where stresses along the face have an infinite slope, so that it is
    /// not left.
    pub(super) scale: f64,
    /// The highest value that was computed.
    pub(super) seen: Seen,
}

impl Peak {
    /// One whose value was computed.
    pub(super) fn new(measure: Measure, layer: usize, seen: Seen, scale: f64) -> Self {
        let Seen { x, depth, value } = seen;
        Self { measure, layer, x, depth, value, scale, seen }
    }

    /// Goes to the highest value that was computed, if that is higher than what is expected here.
    pub(super) fn take_seen(&mut self) {
        let Seen { x, depth, value } = self.seen;
        if value > self.value + ROUNDED * self.value.abs() {
            (self.x, self.depth, self.value) = (x, depth, value);
        }
    }
}
