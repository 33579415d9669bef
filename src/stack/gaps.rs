//! Gaps between layers before anything is loaded.
use crate::scene::Gap;
use crate::solution::Interface;

/// The gaps of a stack.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Gaps(pub(crate) Vec<(Interface, Gap)>);

impl Gaps {
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
