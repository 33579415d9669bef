//! The items of a stack as written: layers, and the interfaces between them.
use std::sync::Arc;

use recede_layers::description::{Form, Value};
use recede_layers::{Body, Layer, Registry, Support};

use super::Spring;

/// The one interface that has fields.
pub(super) const SPRING: &str = "Spring";

/// One line of the stack in a scene.
#[derive(Clone, Debug)]
pub enum Item {
    /// An elastic layer, or the half-plane at the bottom.
    Layer(Arc<dyn Layer>),
    /// A support at the bottom that is no elastic body.
    Support(Arc<dyn Support>),
    /// Interface that transmits everything: u, v, σ_yy and σ_xy are continuous.
    Bonded,
    /// Interface without friction that does not open: v and σ_yy are continuous, σ_xy = 0.
    Sliding,
    /// Interface of springs: σ_yy and σ_xy are continuous, and proportional to the jumps of v and u.
    Spring(Spring),
    /// Interface without friction or adhesion, free to open: where it is closed it transmits pressure only.
    Receding,
    /// Rigid base at the bottom.
    Rigid,
}

impl Item {
    /// The item that was read by a registered name.
    pub(super) fn of(body: Body) -> Self {
        match body {
            Body::Layer(layer) => Self::Layer(layer),
            Body::Support(support) => Self::Support(support),
        }
    }

    /// A layer as an item.
    pub fn layer(layer: impl Layer) -> Self {
        Self::Layer(Arc::new(layer))
    }

    /// A support as an item.
    pub fn support(support: impl Support + 'static) -> Self {
        Self::Support(Arc::new(support))
    }

    /// The name by which the item is written, e.g. `Homogeneous`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Layer(layer) => layer.notation().kind,
            Self::Support(support) => support.notation().kind,
            Self::Bonded => "Bonded",
            Self::Sliding => "Sliding",
            Self::Spring(_) => SPRING,
            Self::Receding => "Receding",
            Self::Rigid => "Rigid",
        }
    }

    /// The layer that it is, if it is one.
    pub(crate) fn elastic(&self) -> Option<&Arc<dyn Layer>> {
        if let Self::Layer(layer) = self { Some(layer) } else { None }
    }

    /// Whether the item is an interface, which joins or divides layers.
    pub fn is_interface(&self) -> bool {
        matches!(self, Self::Bonded | Self::Sliding | Self::Spring(_) | Self::Receding)
    }

    /// The parameters behind the name, without their parentheses; `None` if there are none.
    pub(super) fn parameters(&self) -> Option<String> {
        match self {
            Self::Layer(layer) => Some(layer.notation().parameters),
            Self::Support(support) => Some(support.notation().parameters),
            Self::Spring(spring) => Some(spring.parameters()),
            Self::Bonded | Self::Sliding | Self::Receding | Self::Rigid => None,
        }
    }

    /// The items written by a name alone, with what they mean.
    fn plain_items() -> [(Self, &'static str); 4] {
        [
            (Self::Bonded, "All displacements and stresses are continuous."),
            (Self::Sliding, "No friction, but no opening either: only v and σ_yy are continuous."),
            (Self::Receding, "No friction, no adhesion, free to open: where closed it transmits pressure only."),
            (Self::Rigid, "A rigid base, to which the layer above is joined or on which it lies loose."),
        ]
    }

    /// The item written by a name alone, if there is one of that name.
    pub(super) fn plain(name: &str) -> Option<Self> {
        Self::plain_items().into_iter().map(|(item, _)| item).find(|item| item.name() == name)
    }

    /// The items that are no layers: interfaces, with springs as the last of them, and the rigid base.
    pub(super) fn forms() -> Vec<Form> {
        let meaning = "Springs that neither open nor slide freely: σ_yy = normal · [v], σ_xy = tangential · [u].";
        let [bonded, sliding, receding, rigid] =
            Self::plain_items().map(|(item, meaning)| (item.name(), meaning, None));
        let all = [bonded, sliding, receding, (SPRING, meaning, Some(Value::of::<Spring>())), rigid];
        let form = |(name, meaning, value): (&str, &str, _)| Form {
            name: name.to_owned(),
            meaning: meaning.to_owned(),
            value,
        };
        all.map(form).to_vec()
    }

    /// All names that may stand in a stack.
    pub(super) fn names(registry: &Registry) -> Vec<&'static str> {
        let plain = Self::plain_items().map(|(item, _)| item.name());
        registry.iter().map(|entry| entry.name).chain(plain).chain([SPRING]).collect()
    }
}

/// `` `a`, `b`, `c` ``.
pub(crate) fn quoted_list(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
