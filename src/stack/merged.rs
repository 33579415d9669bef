//! Neighbours that are one body: bonded layers of one material, separate in the scene only.
use recede_layers::Loaded;

use super::{Base, Foundation, Joint, Laminate, Stack};

impl Stack {
    /// An equivalent stack of fewer layers, and the number of layers that were merged: those that are
    /// [one body](recede_layers::Layer::continues) with the layer, or the half-plane, to which they are bonded.
    pub(crate) fn merged(&self) -> (Self, usize) {
        let (mut laminates, mut base) = (self.laminates.clone(), self.base.clone());
        let mut count: usize = laminates.iter_mut().map(merge).sum();
        let Base { joined, foundation } = &mut base;
        if let Foundation::HalfPlane(placed) = foundation {
            joined.layers.push(placed.clone());
        }
        count += merge(joined);
        if let Foundation::HalfPlane(placed) = foundation
            && let Some(last) = joined.layers.pop()
        {
            placed.layer = last.layer;
        }
        let second = self.second.as_deref().map(|second| {
            let (second, merged) = second.merged();
            count += merged;
            second.into()
        });
        (Self { laminates, base, dropped: self.dropped.clone(), second, ..*self }, count)
    }
}

/// Makes one layer of neighbours that are one body; returns the number of layers that were merged.
fn merge(Laminate { layers, joints, .. }: &mut Laminate) -> usize {
    let before = layers.len();
    let mut given = std::mem::take(joints).into_iter();
    layers.dedup_by(|below, above| {
        let Some(joint) = given.next() else { return false };
        let one = if joint == Joint::BONDED {
            Loaded::unnamed(&*above.layer).continues(Loaded::unnamed(&*below.layer))
        } else {
            None
        };
        let is_one = one.is_some();
        match one {
            Some(one) => above.layer = one,
            None => joints.push(joint),
        }
        is_one
    });
    // a layer on a rigid base has a joint below it, too
    joints.extend(given);
    before - layers.len()
}
