//! Stacks described in code, from the top down.
use recede_layers::{Layer, Support};

use crate::geometry::Geometry;

use super::{Stack, StackError};
use crate::scene::{Item, Punch, Spring};

/// A stack being described from the top down; see [`Stack::builder`]. Nothing is checked before
/// [`build`](StackBuilder::build).
#[derive(Clone, Debug)]
#[must_use = "a builder does nothing until `build`"]
pub struct StackBuilder {
    geometry: Geometry,
    pressure_on_top: f64,
    items: Vec<Item>,
}

impl Stack {
    /// Begins a stack, to be described from the top down.
    pub fn builder(geometry: impl Into<Geometry>) -> StackBuilder {
        StackBuilder { geometry: geometry.into(), pressure_on_top: 0.0, items: Vec::new() }
    }
}

impl StackBuilder {
    /// Adds an item as it would be written in a scene.
    pub fn item(mut self, item: Item) -> Self {
        self.items.push(item);
        self
    }

    /// Presses everywhere on the top face, also under a punch, with a pressure ≥ 0, in stress.
    pub fn pressure_on_top(self, pressure_on_top: f64) -> Self {
        Self { pressure_on_top, ..self }
    }

    /// Adds a layer, or the half-plane at the bottom.
    pub fn layer(self, layer: impl Layer) -> Self {
        self.item(Item::layer(layer))
    }

    /// Adds a support at the bottom, such as springs.
    pub fn support(self, support: impl Support + 'static) -> Self {
        self.item(Item::support(support))
    }

    /// Adds an interface that transmits everything.
    pub fn bonded(self) -> Self {
        self.item(Item::Bonded)
    }

    /// Adds an interface without friction that does not open.
    pub fn sliding(self) -> Self {
        self.item(Item::Sliding)
    }

    /// Adds an interface of springs.
    pub fn spring(self, spring: Spring) -> Self {
        self.item(Item::Spring(spring))
    }

    /// Adds an interface without friction or adhesion, free to open.
    pub fn receding(self) -> Self {
        self.item(Item::Receding)
    }

    /// Adds the same interface between layers that are apart by a gap of this shape about x = 0 before they are loaded.
    pub fn receding_from(self, gap: Punch) -> Self {
        self.item(Item::RecedingGap(gap))
    }

    /// Adds the rigid base at the bottom.
    pub fn rigid(self) -> Self {
        self.item(Item::Rigid)
    }

    /// Checks the stack.
    ///
    /// # Errors
    /// As [`Stack::from_items`].
    ///
    /// ```
    /// use recede::{Homogeneous, Plane, Stack};
    /// let strip = || Homogeneous::new(1.0, 1.0, 0.25);
    /// assert!(Stack::builder(Plane::Strain).layer(strip()?).receding().rigid().build().is_ok());
    /// let error = Stack::builder(Plane::Strain).layer(strip()?).rigid().build().unwrap_err();
    /// assert_eq!(error.to_string(), "no interface between layer 1 (Homogeneous) and the rigid base");
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn build(self) -> Result<Stack, StackError> {
        Stack::from_items_under(self.geometry, self.pressure_on_top, &self.items)
    }
}
