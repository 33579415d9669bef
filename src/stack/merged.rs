//! Neighbours that are one body: bonded layers of one material, separate in the scene only.
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
        (Self { laminates, base, dropped: self.dropped.clone(), ..*self }, count)
    }
}

/// Makes one layer of neighbours that are one body; returns the number of layers that were merged.
fn merge(Laminate { layers, joints }: &mut Laminate) -> usize {
    let before = layers.len();
    let mut given = std::mem::take(joints).into_iter();
    layers.dedup_by(|below, above| {
        let Some(joint) = given.next() else { return false };
        let one = if joint == Joint::BONDED { above.layer.continues(&*below.layer) } else { None };
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

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, HalfPlane, Homogeneous, Layer, Plane};

    use super::*;
    use crate::scene::{Item, Spring};
    use crate::stack::Placed;

    fn strip(thickness: f64, modulus: f64) -> Item {
        Item::layer(Homogeneous::new(thickness, modulus, 0.25).unwrap())
    }

    /// Thicknesses of the layers of every laminate and of the base, number of joints of the base, layers less.
    fn merged(items: &[Item]) -> (Vec<Vec<f64>>, Vec<f64>, usize, usize) {
        let (stack, count) = Stack::from_items(Plane::Strain, items).unwrap().merged();
        let thicknesses = |layers: &[Placed]| layers.iter().map(Placed::thickness).collect::<Vec<_>>();
        let laminates = stack.laminates().iter().map(|laminate| {
            assert_eq!(laminate.joints.len() + 1, laminate.layers.len());
            thicknesses(&laminate.layers)
        });
        (laminates.collect(), thicknesses(stack.base.layers()), stack.base.joints().len(), count)
    }

    #[test]
    fn one_material_is_one_layer() {
        use Item::{Bonded, Receding, Rigid, Sliding};
        let ground = || Item::layer(HalfPlane::new(1.0, 0.25).unwrap());
        let one = || strip(1.0, 1.0);
        assert_eq!(merged(&[ground()]), (vec![], vec![], 0, 0));
        assert_eq!(merged(&[one(), Bonded, one(), Bonded, ground()]), (vec![], vec![], 0, 2));
        assert_eq!(merged(&[strip(1.0, 2.0), Bonded, one(), Bonded, ground()]), (vec![], vec![1.0], 1, 1));
        assert_eq!(merged(&[one(), Bonded, one(), Receding, ground()]), (vec![vec![2.0]], vec![], 0, 1));
        assert_eq!(merged(&[one(), Bonded, one(), Bonded, Rigid]), (vec![], vec![2.0], 1, 1));
        assert_eq!(merged(&[one(), Receding, one(), Bonded, ground()]), (vec![vec![1.0]], vec![], 0, 1));
        // interfaces that slide or have springs separate two bodies
        assert_eq!(merged(&[one(), Sliding, one(), Sliding, ground()]), (vec![], vec![1.0, 1.0], 2, 0));
        let spring = Item::Spring(Spring::new(2.0, None).unwrap());
        assert_eq!(merged(&[one(), spring, one(), Bonded, one(), Receding, Rigid]), {
            (vec![vec![1.0, 2.0]], vec![], 0, 1)
        });
    }

    #[test]
    fn grading_that_does_not_go_on_is_not_merged() {
        let part = |thickness, modulus: f64, beta| Exponential::new(thickness, modulus, 0.25, beta).unwrap();
        for beta in [-30.0, -1.0, 0.0, 1e-9, 0.7, 12.0] {
            let above = part(1.0, 3.0, beta);
            assert!(above.continues(&part(2.0, 3.0 * f64::exp(beta) * (1.0 + 1e-12), beta)).is_none());
            assert!(above.continues(&part(2.0, 3.0 * f64::exp(beta), beta + 0.1)).is_none());
        }
        assert!(part(3.0, 1.0, 30.0).continues(&part(1.0, f64::exp(90.0), 30.0)).is_none(), "too steep for one layer");
    }
}
