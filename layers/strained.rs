//! A layer that would be strained if it were free.
use std::sync::Arc;

use crate::{ClosedForm, Key, Layer, Material, Notation, Plane};

/// A layer with an eigenstrain: the strain that it would have if nothing held it, as from a temperature, from swelling, or from how it was deposited. It is the same in all
/// directions and throughout the layer; all else is the layer's own.
///
/// ```
/// use recede_layers::{Homogeneous, Layer, Strained};
/// let coating = Strained::new(Homogeneous::new(0.1, 80e3, 0.25)?, -2e-3);
/// assert_eq!((coating.thickness(), coating.eigenstrain()), (Some(0.1), -2e-3));
/// assert!(coating.notation().to_string().ends_with("poisson: 0.25, eigenstrain: -0.002)"));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Strained {
    layer: Arc<dyn Layer>,
    eigenstrain: f64,
}

impl Strained {
    /// A layer with an eigenstrain, dimensionless, positive where the free layer would be larger.
    pub fn new(layer: impl Layer, eigenstrain: f64) -> Self {
        Self::of(Arc::new(layer), eigenstrain)
    }

    /// The same of a layer that is shared.
    pub fn of(layer: Arc<dyn Layer>, eigenstrain: f64) -> Self {
        Self { layer, eigenstrain }
    }
}

// A provided method that is not passed on would answer for the wrapped layer with what is provided: clippy finds each one.
#[deny(clippy::missing_trait_methods)]
impl Layer for Strained {
    fn thickness(&self) -> Option<f64> {
        self.layer.thickness()
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        self.layer.material(depth, plane)
    }

    fn notation(&self) -> Notation {
        self.layer.notation().with("eigenstrain", &self.eigenstrain)
    }

    fn kinks(&self) -> Vec<f64> {
        self.layer.kinks()
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        self.layer.closed_form()
    }

    fn key(&self) -> Option<Key> {
        self.layer.key().map(|key| key.with([self.eigenstrain]))
    }

    /// A layer with another eigenstrain is another body, and no type of layers knows of eigenstrains.
    fn continues(&self, _below: &dyn Layer) -> Option<Arc<dyn Layer>> {
        None
    }

    fn is_same_all_around(&self) -> bool {
        self.layer.is_same_all_around()
    }

    fn eigenstrain(&self) -> f64 {
        self.eigenstrain
    }
}
