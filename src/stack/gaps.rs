//! Gaps between layers before anything is loaded.
use crate::scene::Punch;
use crate::solution::Interface;

/// The gaps of a stack, each of the shape of a punch about x = 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Gaps(pub(crate) Vec<(Interface, Punch)>);

impl Gaps {
    /// How far the bodies of a contact were apart at a place, in length, more than where they were nearest: 0 where there was no gap, infinite beyond its ends.
    pub(crate) fn height(&self, interface: Interface, x: f64) -> f64 {
        let own = self.0.iter().find(|(own, _)| *own == interface);
        let height = |gap: &Punch| {
            let [left, right] = gap.shape().ends();
            if x < left || x > right { f64::INFINITY } else { gap.profile(x) - gap.shape().lowest() }
        };
        own.map_or(0.0, |(_, gap)| height(gap))
    }
}
