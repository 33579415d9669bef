//! Gaps between layers before anything is loaded.
use std::f64::consts::PI;

use crate::scene::Gap;
use crate::solution::Interface;

/// The gaps of a stack.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Gaps(pub(crate) Vec<(Interface, Gap)>);

/// A dent, the gap depth · exp(−(x/half_width)²) about x = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dent {
    pub(crate) depth: f64,
    pub(crate) half_width: f64,
}

/// Waves shorter than this, over the half-width, are not in a dent.
const SHORTEST: f64 = 12.2;

impl Dent {
    /// ∫ g cos λx dx of the gap g.
    pub(crate) fn transform(&self, wavenumber: f64) -> f64 {
        self.depth * self.half_width * PI.sqrt() * (-0.25 * (wavenumber * self.half_width).powi(2)).exp()
    }

    /// The wavenumber beyond which there is nothing of it.
    pub(crate) fn shortest(&self) -> f64 {
        SHORTEST / self.half_width
    }
}

impl Gaps {
    /// The dent of a contact, if there is one.
    pub(crate) fn dent(&self, interface: Interface) -> Option<Dent> {
        let (_, gap) = self.0.iter().find(|(own, _)| *own == interface)?;
        gap.dent().map(|[depth, half_width]| Dent { depth, half_width })
    }

    /// The dents alone, of what is pressed together, and the curvature of the top face.
    pub(crate) fn dents(self) -> Self {
        Self(self.0.into_iter().filter(|(own, gap)| *own == Interface::Punch || gap.dent().is_some()).collect())
    }

    /// How far the bodies of a contact were apart at a place, in length, more than where they were nearest: 0 where there was no gap, infinite beyond its ends.
    pub(crate) fn height(&self, interface: Interface, x: f64) -> f64 {
        let own = self.0.iter().find(|(own, _)| *own == interface);
        let height = |gap: &Gap| {
            let shape = gap.shape();
            let [left, right] = shape.ends();
            if x < left || x > right { f64::INFINITY } else { shape.height(x) - shape.lowest() }
        };
        own.map_or(0.0, |(_, gap)| height(gap))
    }
}
