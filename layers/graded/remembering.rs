//! A layer that remembers what the general body has computed of it.
use std::any::Any;
use std::sync::{Arc, Mutex, PoisonError};

use super::{Tree, flexibility_of_layer, of_layer, states_of_layer};
use crate::{ClosedForm, FaceStates, Flexibility, Key, Layer, LayerStates, Material, Notation, Plane, Wave};

/// A layer with the face states of another one, to the last digit, which remembers the slices of the general body from one wavenumber to the
/// next, wherever the layer offers no [closed form](Layer::closed_form). Made once per stack for every layer. Slices for fields inside end at the depths that were asked for last, or at more
/// than these if they were among those before.
#[derive(Debug)]
pub struct Remembering {
    layer: Arc<dyn Layer>,
    strain: Tree,
    stress: Tree,
    inside: Mutex<Option<Arc<Inside>>>,
}

/// Slices that end at some depths.
#[derive(Debug)]
struct Inside {
    plane: Plane,
    depths: Vec<f64>,
    tree: Tree,
}

impl Inside {
    fn serves(&self, plane: Plane, depths: &[f64]) -> bool {
        let known = |depth: &f64| self.depths.binary_search_by(|own| own.total_cmp(depth)).is_ok();
        self.plane == plane && depths.iter().all(known)
    }
}

impl Remembering {
    /// The layer with nothing remembered yet; a layer that remembers is returned as it is.
    pub fn of(layer: Arc<dyn Layer>) -> Arc<dyn Layer> {
        let any: &dyn Any = &*layer;
        if any.is::<Self>() {
            return layer;
        }
        Arc::new(Self { layer, strain: Tree::default(), stress: Tree::default(), inside: Mutex::default() })
    }

    fn tree(&self, plane: Plane) -> &Tree {
        match plane {
            Plane::Strain => &self.strain,
            Plane::Stress => &self.stress,
        }
    }

    /// The layer itself, without what is remembered of it: layer types compare themselves with others of their own type.
    fn without_memory(layer: &dyn Layer) -> &dyn Layer {
        let any: &dyn Any = layer;
        any.downcast_ref::<Self>().map_or(layer, |remembering| &*remembering.layer)
    }
}

// A provided method that is not passed on would answer for the wrapped layer with what is provided: clippy finds each one.
#[deny(clippy::missing_trait_methods)]
impl Layer for Remembering {
    fn thickness(&self) -> Option<f64> {
        self.layer.thickness()
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        self.layer.material(depth, plane)
    }

    fn notation(&self) -> Notation {
        self.layer.notation()
    }

    fn kinks(&self) -> Vec<f64> {
        self.layer.kinks()
    }

    /// What is remembered.
    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        Some(self)
    }

    fn key(&self) -> Option<Key> {
        self.layer.key()
    }

    fn continues(&self, below: &dyn Layer) -> Option<Arc<dyn Layer>> {
        self.layer.continues(Self::without_memory(below)).map(Self::of)
    }

    fn name(&self) -> Option<&str> {
        self.layer.name()
    }

    fn eigenstrain(&self) -> f64 {
        self.layer.eigenstrain()
    }

    fn specific_weight(&self) -> f64 {
        self.layer.specific_weight()
    }

    fn is_same_all_around(&self) -> bool {
        self.layer.is_same_all_around()
    }
}

impl ClosedForm for Remembering {
    fn face_states(&self, wave: &Wave) -> FaceStates {
        let general = || of_layer(&*self.layer, wave, self.tree(wave.plane));
        self.layer.closed_form().map_or_else(general, |closed| closed.face_states(wave))
    }

    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        let general = || flexibility_of_layer(&*self.layer, wave, self.tree(wave.plane));
        self.layer.closed_form().map_or_else(general, |closed| closed.flexibility(wave))
    }

    fn states(&self, wave: &Wave, depths: &[f64]) -> Option<LayerStates> {
        if let Some(closed) = self.layer.closed_form().and_then(|closed| closed.states(wave, depths)) {
            return Some(closed);
        }
        let inside = {
            // what is remembered is whole at any time
            let mut last = self.inside.lock().unwrap_or_else(PoisonError::into_inner);
            match &*last {
                Some(inside) if inside.serves(wave.plane, depths) => Arc::clone(inside),
                _ => {
                    let inside = Inside { plane: wave.plane, depths: depths.to_vec(), tree: Tree::default() };
                    Arc::clone(last.insert(Arc::new(inside)))
                }
            }
        };
        Some(states_of_layer(&*self.layer, wave, &inside.tree, &inside.depths, depths))
    }
}
