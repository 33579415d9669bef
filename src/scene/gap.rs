//! Gaps between layers before anything is loaded.
use super::punch::Punch;
use super::shape::Shape;

/// A gap at a receding interface: of the shape of a punch about x = 0, if there is one, and what free laminates bend apart.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Gap {
    pub(crate) punch: Option<Punch>,
    /// By how much the slope of the gap grows with x besides, in 1/length.
    pub(crate) curvature: f64,
}

impl Gap {
    /// Bodies that fit together.
    pub(crate) const NONE: Self = Self { punch: None, curvature: 0.0 };

    /// Both together.
    pub(crate) fn shape(&self) -> Shape<'_> {
        let punch = self.punch.as_ref().map(Punch::shape);
        punch.unwrap_or_else(|| Shape::powers(1.0, Vec::new())).bent(self.curvature)
    }

    /// Depth and half-width of a dent, if it is one.
    pub(crate) fn dent(&self) -> Option<[f64; 2]> {
        match self.punch.as_ref().map(Punch::shape) {
            Some(Shape::Dent { depth, half_width }) => Some([depth, half_width]),
            _ => None,
        }
    }

    /// Whether a circle, sharp corners or a dent are to be bent, which no shape is known for.
    pub(crate) fn is_unknown(&self) -> bool {
        let punch = self.punch.as_ref().map(Punch::shape);
        self.curvature != 0.0 && matches!(punch, Some(Shape::Circle(_) | Shape::Flat(_) | Shape::Dent { .. }))
    }
}
