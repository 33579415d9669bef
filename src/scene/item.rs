//! The items of a stack as written: layers, and the interfaces between them.
use std::sync::Arc;

use recede_layers::{Layer, Registry};

/// One line of the stack in a scene.
#[derive(Clone, Debug)]
pub enum Item {
    /// An elastic layer, or the half-plane at the bottom.
    Layer(Arc<dyn Layer>),
    /// Interface that transmits everything: u, v, σ_yy and σ_xy are continuous.
    Bonded,
    /// Interface without friction or adhesion, free to open: where it is closed it transmits pressure only.
    Receding,
    /// Rigid base at the bottom.
    Rigid,
}

impl Item {
    /// A layer as an item.
    pub fn layer(layer: impl Layer) -> Self {
        Self::Layer(Arc::new(layer))
    }

    /// The name by which the item is written, e.g. `Homogeneous`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Layer(layer) => layer.notation().kind,
            Self::Bonded => "Bonded",
            Self::Receding => "Receding",
            Self::Rigid => "Rigid",
        }
    }

    /// The items written by a name alone, with what they mean.
    pub(super) fn plain_items() -> [(Self, &'static str); 3] {
        [
            (Self::Bonded, "All displacements and stresses are continuous."),
            (Self::Receding, "No friction, no adhesion, free to open: where closed it transmits pressure only."),
            (Self::Rigid, "A rigid base, to which the layer above is bonded or on which it lies loose."),
        ]
    }

    /// The item written by a name alone, if there is one of that name.
    pub(super) fn plain(name: &str) -> Option<Self> {
        Self::plain_items().into_iter().map(|(item, _)| item).find(|item| item.name() == name)
    }

    /// All names that may stand in a stack.
    pub(super) fn names(registry: &Registry) -> Vec<&'static str> {
        let plain = Self::plain_items().map(|(item, _)| item.name());
        registry.iter().map(|entry| entry.name).chain(plain).collect()
    }
}

/// `` `a`, `b`, `c` ``.
pub(crate) fn quoted_list(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
