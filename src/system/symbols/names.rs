//! The words by which rows and blocks are named: quantities, faces, sides, places and pressures.

/// Where a condition holds.
pub use crate::solution::Interface as Place;

/// Amplitude of a transformed field; see [`recede_layers`] for the conventions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// The amplitude of the displacement u along the layers.
    #[default]
    U,
    /// The amplitude of the displacement v upwards.
    V,
    /// The amplitude of the stress σ_yy, tension positive.
    S,
    /// The amplitude of the stress σ_xy.
    T,
}

impl Quantity {
    /// The place of the quantity in a [`State`](recede_layers::State).
    pub fn index(self) -> usize {
        self as usize
    }

    /// Whether the quantity is a stress.
    pub fn is_stress(self) -> bool {
        matches!(self, Self::S | Self::T)
    }
}

/// Face of a layer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Face {
    /// The upper face.
    #[default]
    Top,
    /// The lower face.
    Bottom,
}

/// Side of an interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum InterfaceSide {
    /// The layer above the interface.
    Above,
    /// The layer below the interface.
    Below,
}

/// Right-hand side of a row that is loaded, with the index of the contact, from 0 for the punch; see [`crate::Stack::contacts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RightHandSide {
    /// Minus the transformed pressure of a contact.
    Pressure(usize),
    /// The transformed gap at an interface that weights press together.
    Gap(usize),
}
