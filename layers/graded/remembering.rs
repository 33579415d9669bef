//! A layer that remembers what the general body has computed of it.
use std::sync::Arc;

use super::{Tree, of_layer};
use crate::{FaceStates, Flexibility, Layer, LayerStates, Material, Notation, Plane, Wave};

/// A layer whose face states are those of [`face_states`](super::face_states), to the last digit, and which remembers
/// its slices from one wavenumber to the next. Made once per stack for every layer without
/// [closed forms](Layer::has_closed_form).
#[derive(Debug)]
pub struct Remembering {
    layer: Arc<dyn Layer>,
    strain: Tree,
    stress: Tree,
}

impl Remembering {
    /// The layer with nothing remembered yet; a layer that has closed forms is returned as it is.
    pub fn of(layer: Arc<dyn Layer>) -> Arc<dyn Layer> {
        if layer.has_closed_form() {
            return layer;
        }
        Arc::new(Self { layer, strain: Tree::default(), stress: Tree::default() })
    }
}

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

    fn has_material(&self) -> bool {
        self.layer.has_material()
    }

    fn has_closed_form(&self) -> bool {
        true
    }

    fn face_states(&self, wave: &Wave) -> FaceStates {
        let tree = match wave.plane {
            Plane::Strain => &self.strain,
            Plane::Stress => &self.stress,
        };
        of_layer(&*self.layer, wave, tree)
    }

    fn states(&self, wave: &Wave, depths: &[f64]) -> LayerStates {
        self.layer.states(wave, depths)
    }

    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        Flexibility::of_face_states(&self.face_states(wave))
    }
}
