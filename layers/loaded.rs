//! A layer with an eigenstrain, a weight or a name.
use std::any::Any;
use std::sync::Arc;

use crate::{ClosedForm, Key, Layer, Material, Name, Notation, Plane};

/// A layer with an eigenstrain, a weight or a name; all else is the layer's own.
///
/// The eigenstrain is the strain that the layer would have if nothing held it, as from a temperature, from swelling, or from how it was deposited. It is the same in all
/// directions and throughout the layer. The weight presses on what lies below. The name is shown beside the number of the layer.
///
/// ```
/// use recede_layers::{Homogeneous, Layer, Loaded, Name};
/// let coating = Loaded::new(Homogeneous::new(0.1, 80e3, 0.25)?).with_eigenstrain(-2e-3);
/// assert_eq!((coating.thickness(), coating.eigenstrain()), (Some(0.1), -2e-3));
/// assert!(coating.notation().to_string().ends_with("poisson: 0.25, eigenstrain: -0.002)"));
/// let slab = Loaded::new(Homogeneous::new(0.2, 30e3, 0.2)?).with_specific_weight(24e-6);
/// assert_eq!(slab.specific_weight(), 24e-6);
/// let base = Loaded::new(Homogeneous::new(0.2, 30e3, 0.2)?).with_name(Name::new("base")?);
/// assert!(base.notation().to_string().starts_with("Homogeneous(name: \"base\", thickness: 0.2, "));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Loaded {
    layer: Arc<dyn Layer>,
    eigenstrain: f64,
    specific_weight: f64,
    name: Option<Name>,
}

impl Loaded {
    /// The layer alone.
    pub fn new(layer: impl Layer) -> Self {
        Self::of(Arc::new(layer))
    }

    /// The same of a layer that is shared.
    pub fn of(layer: Arc<dyn Layer>) -> Self {
        Self { layer, eigenstrain: 0.0, specific_weight: 0.0, name: None }
    }

    /// With an eigenstrain, dimensionless, positive where the free layer would be larger.
    #[must_use]
    pub fn with_eigenstrain(self, eigenstrain: f64) -> Self {
        Self { eigenstrain, ..self }
    }

    /// With a weight, force per volume, positive downwards.
    #[must_use]
    pub fn with_specific_weight(self, specific_weight: f64) -> Self {
        Self { specific_weight, ..self }
    }

    /// With a name.
    #[must_use]
    pub fn with_name(self, name: Name) -> Self {
        Self { name: Some(name), ..self }
    }

    /// A layer without its name: named layers of one material are one body, too.
    pub fn unnamed(layer: &dyn Layer) -> &dyn Layer {
        let any: &dyn Any = layer;
        let own = any.downcast_ref::<Self>().filter(|own| own.eigenstrain == 0.0 && own.specific_weight == 0.0);
        own.map_or(layer, |own| &*own.layer)
    }
}

// A provided method that is not passed on would answer for the wrapped layer with what is provided: clippy finds each one.
#[deny(clippy::missing_trait_methods)]
impl Layer for Loaded {
    fn thickness(&self) -> Option<f64> {
        self.layer.thickness()
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        self.layer.material(depth, plane)
    }

    fn notation(&self) -> Notation {
        let own = [("eigenstrain", self.eigenstrain), ("specific_weight", self.specific_weight)];
        let given = own.iter().filter(|(_, value)| *value != 0.0);
        let notation = given.fold(self.layer.notation(), |notation, (name, value)| notation.with(name, value));
        self.name.iter().fold(notation, Notation::named)
    }

    fn kinks(&self) -> Vec<f64> {
        self.layer.kinks()
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        self.layer.closed_form()
    }

    fn key(&self) -> Option<Key> {
        self.layer.key().map(|key| key.with([self.eigenstrain, self.specific_weight]))
    }

    /// A layer with another eigenstrain or weight is another body, and no type of layers knows of these.
    fn continues(&self, _below: &dyn Layer) -> Option<Arc<dyn Layer>> {
        None
    }

    fn name(&self) -> Option<&str> {
        self.name.as_ref().map(Name::as_str).or(self.layer.name())
    }

    fn is_same_all_around(&self) -> bool {
        self.layer.is_same_all_around()
    }

    fn eigenstrain(&self) -> f64 {
        self.eigenstrain
    }

    fn specific_weight(&self) -> f64 {
        self.specific_weight
    }
}
