//! What pressures carry, and what the moment of all that presses does.

/// A resultant or moment of the pressure of a contact.
pub(super) struct Constraint {
    pub(super) contact: usize,
    /// By which unit pressures on the elements are weighed.
    pub(super) weights: Vec<f64>,
    pub(super) kind: Carried,
}

/// What a pressure carries.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Carried {
    Resultant(f64),
    /// A moment about x = 0, by which the punch of this number turns.
    Moment(usize, f64),
    /// The moment of all that presses on the stack.
    WholeMoment,
}

impl Constraint {
    /// By what a unit pressure on an element of a contact counts.
    pub(super) fn weight(&self, contact: usize, e: usize) -> f64 {
        if contact == self.contact { self.weights[e] } else { 0.0 }
    }
}

/// What the moment of all that presses on the stack does, which pressures are compared with one of where nothing is even: a unit moment.
pub(super) struct Turning {
    /// The moment; `None` if it is to be found.
    pub(super) moment: Option<f64>,
    /// To the gap of each contact, but for a rotation.
    pub(super) linear: Vec<Vec<f64>>,
    /// Twice its energy in each contact.
    pub(super) square: Vec<f64>,
    /// The rotation per unit pressure on each element: by the coupling with the contact below, by the coupling with a given pressure, and by the given pressure itself.
    pub(super) coupling: Vec<Vec<f64>>,
    pub(super) beside: Vec<Vec<f64>>,
    pub(super) given: Vec<f64>,
}
