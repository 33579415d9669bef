//! The key of a stack, by which equal stacks are recognised: geometry, bodies and joints.
use std::sync::Arc;

use recede_layers::{Body, Key};

use super::{Gaps, Group, Joint, Stack};
use crate::geometry::Geometry;

/// All that a solution depends on in a stack. Stacks with equal keys are the same, however often they are built.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StackKey {
    geometry: Geometry,
    pressure_on_top: f64,
    /// The bodies and the joints of each group.
    groups: Vec<(Vec<Numbered>, Vec<Joint>)>,
    gaps: Gaps,
    /// The body that presses on top.
    second: Option<Box<StackKey>>,
}

/// A layer or a support with its number in the scene, `None` if it is rigid. Without a key of its own it is the same as nothing but itself:
/// that it is held here keeps its address from being used again.
#[derive(Clone, Debug)]
struct Numbered(usize, Option<Body>);

impl PartialEq for Numbered {
    fn eq(&self, other: &Self) -> bool {
        let have_one_key = |one: Option<Key>, other| one.is_some() && one == other;
        self.0 == other.0
            && match (&self.1, &other.1) {
                (Some(Body::Layer(one)), Some(Body::Layer(other))) => {
                    Arc::ptr_eq(one, other) || have_one_key(one.key(), other.key())
                }
                (Some(Body::Support(one)), Some(Body::Support(other))) => {
                    Arc::ptr_eq(one, other) || have_one_key(one.key(), other.key())
                }
                (one, other) => one.is_none() && other.is_none(),
            }
    }
}

impl Stack {
    /// The key of the stack.
    pub(crate) fn key(&self) -> StackKey {
        let bodies = |group: &Group| group.bodies().map(|(number, body)| Numbered(number, body)).collect();
        let groups = self.groups().map(|group| (bodies(&group), group.joints().to_vec())).collect();
        let second = self.second.as_ref().map(|second| Box::new(second.key()));
        StackKey { geometry: self.geometry, pressure_on_top: self.pressure_on_top, groups, gaps: self.gaps(), second }
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{Graded, HalfPlane, Homogeneous, Isotropic, Layer, Material, Plane, Winkler};

    use super::*;
    use crate::scene::{Item, Spring};

    /// A layer of one's own that tells no key, and always prints the same.
    #[derive(Debug)]
    struct Plain;

    impl Layer for Plain {
        fn thickness(&self) -> Option<f64> {
            Some(1.0)
        }

        fn material(&self, _depth: f64, plane: Plane) -> Material {
            Isotropic { shear_modulus: 1.0, poisson: 0.3 }.material(plane)
        }
    }

    fn on_ground(items: impl IntoIterator<Item = Item>, ground: Item) -> Stack {
        let mut all: Vec<Item> = items.into_iter().flat_map(|layer| [layer, Item::Receding]).collect();
        if let Item::Support(_) = ground {
            all.extend([Item::layer(Homogeneous::new(1.0, 1.0, 0.3).unwrap()), Item::Bonded]);
        }
        all.push(ground);
        Stack::from_items(Geometry::PlaneStrain, &all).unwrap()
    }

    #[test]
    fn functions_and_layers_without_a_key_are_the_same_as_themselves_only() {
        let ground = || Item::layer(HalfPlane::new(1.0, 0.25).unwrap());
        let function = |exponent: f64| {
            let modulus = move |depth: f64| Isotropic { shear_modulus: (exponent * depth).exp(), poisson: 0.3 };
            Item::layer(Graded::with(1.0, modulus).unwrap())
        };
        for layer in [&function as &dyn Fn(f64) -> Item, &|_| Item::layer(Plain)] {
            let item = layer(1.0);
            let [one, again, other] = [item.clone(), item, layer(-1.0)].map(|item| on_ground([item], ground()));
            assert_eq!(one.key(), again.key());
            assert_eq!(one.key(), one.clone().key());
            assert_ne!(one.key(), other.key());
            // nor does a later one take the place of one that is gone
            let key = on_ground([layer(2.0)], ground()).key();
            assert!((0..100).all(|_| on_ground([layer(2.0)], ground()).key() != key));
        }
    }

    /// Stacks with other joints, supports and geometries, each of them another one, with a length that may be changed by rounding.
    fn stacks(length: f64) -> Vec<Stack> {
        let half_plane = || Item::layer(HalfPlane::new(length, 0.25).unwrap());
        let strip = |modulus: f64| Item::layer(Homogeneous::new(length, modulus, 0.25).unwrap());
        let joints = [Item::Bonded, Item::Sliding, Item::Spring(Spring::new(length, None).unwrap()), Item::Receding];
        let joined = joints.map(|joint| {
            let items = [strip(1.0), joint, strip(2.0), Item::Receding, half_plane()];
            Stack::from_items(Geometry::PlaneStrain, &items).unwrap()
        });
        let geometries = [Geometry::PlaneStrain, Geometry::PlaneStress, Geometry::Axisymmetric];
        let loose = geometries.map(|of| Stack::from_items(of, &[strip(1.0), Item::Receding, half_plane()]).unwrap());
        let supports = [Winkler::new(length).unwrap(), Winkler::new(length).unwrap().sticking(1.0).unwrap()];
        let supported = supports.map(|support| on_ground([], Item::support(support)));
        let on_rigid = on_ground([strip(1.0), strip(2.0)], Item::Rigid);
        joined.into_iter().chain(loose).chain(supported).chain([on_rigid]).collect()
    }

    #[test]
    fn equal_stacks_have_equal_keys_and_others_have_not() {
        let [one, again, next] = [1.5, 1.5, f64::from_bits(1.5f64.to_bits() + 1)].map(stacks);
        for (i, stack) in one.iter().enumerate() {
            assert_eq!(stack.key(), again[i].key(), "{stack}");
            assert_ne!(stack.key(), next[i].key(), "{stack}");
            assert!(one.iter().skip(i + 1).all(|other| other.key() != stack.key()), "{stack}");
        }
    }
}
