//! The conditions at each kind of interface: the one place where they are written.
//!
//! A relation is written over both sides. Where there is no layer on one side the body there is rigid:
//! [`BlockSystem`](super::matrix::BlockSystem) sets its displacements to zero, and leaves out the relations that contain only
//! its stresses. So a rigid base needs no relations of its own.
use std::ops::Neg;

use super::names::{InterfaceSide, Quantity, RightHandSide};
use crate::stack::Joint;
use InterfaceSide::{Above, Below};
use Quantity::{S, T, U, V};

/// A quantity on one side of an interface, with its sign and factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    pub(super) side: InterfaceSide,
    pub(super) quantity: Quantity,
    pub(super) negative: bool,
    pub(super) stiffness: Option<f64>,
}

/// One scalar condition at an interface: up to four terms whose sum is zero, minus the pressure of a contact, or a gap.
///
/// ```
/// use recede::{Quantity, Relation, InterfaceSide};
/// // fibres at the interface, held by springs: u is continuous, and they take up the difference of the shear stresses
/// let continuous = Relation::zero([InterfaceSide::Above.of(Quantity::U), -InterfaceSide::Below.of(Quantity::U)]);
/// let held = InterfaceSide::Above.of(Quantity::U).times(2.0);
/// let taken_up = Relation::zero([InterfaceSide::Above.of(Quantity::T), -InterfaceSide::Below.of(Quantity::T), -held]);
/// assert_ne!(continuous, taken_up);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relation {
    pub(super) terms: [Option<Term>; 4],
    pub(super) right: Option<RightHandSide>,
}

impl InterfaceSide {
    /// The quantity on this side.
    pub fn of(self, quantity: Quantity) -> Term {
        Term { side: self, quantity, negative: false, stiffness: None }
    }
}

impl Term {
    /// The term, a displacement, times the stiffness of springs, in stress per length.
    pub fn times(self, stiffness: f64) -> Self {
        Self { stiffness: Some(stiffness), ..self }
    }
}

impl Neg for Term {
    type Output = Self;

    fn neg(self) -> Self {
        Self { negative: !self.negative, ..self }
    }
}

impl Relation {
    /// The sum of these terms is zero. More than four are no condition at an interface, and do not compile:
    ///
    /// ```compile_fail
    /// use recede::{Quantity, Relation, InterfaceSide};
    /// let _ = Relation::zero([InterfaceSide::Above.of(Quantity::U); 5]);
    /// ```
    pub fn zero<const N: usize>(terms: [Term; N]) -> Self {
        const { assert!(N <= 4, "a relation has four terms at most") };
        Self { terms: std::array::from_fn(|i| terms.get(i).copied()), right: None }
    }
}

/// A contact, of the punch or at a receding interface: no shear, and the same pressure on both sides.
pub(super) fn contact(contact: usize) -> [Relation; 4] {
    let right = Some(RightHandSide::Pressure(contact));
    let pressed = |side: InterfaceSide| Relation { right, ..Relation::zero([side.of(S)]) };
    let sheared = |side: InterfaceSide| Relation::zero([side.of(T)]);
    [pressed(Above), sheared(Above), pressed(Below), sheared(Below)]
}

/// A receding interface that weights press together: no shear, the same pressure on both sides, and a gap, which is zero but in openings.
pub(super) fn pressed(contact: usize) -> [Relation; 4] {
    let right = Some(RightHandSide::Gap(contact));
    // of a joint that slides
    let [above, across, transmitted, below] = joint(&Joint::SLIDING);
    [above, Relation { right, ..across }, transmitted, below]
}

/// An interface that stays closed: the jump of each displacement, then the stresses that are transmitted.
pub(super) fn joint(joint: &Joint) -> [Relation; 4] {
    // the relation of the jump, and of the stress that is transmitted: none without stiffness
    let relations = |displacement: Quantity, stress: Quantity, stiffness: f64| {
        let [above, below] = [Above.of(displacement), Below.of(displacement)];
        let [stress_above, stress_below] = [Above.of(stress), Below.of(stress)];
        let transmitted = Relation::zero([stress_above, -stress_below]);
        if stiffness == 0.0 {
            [Relation::zero([stress_above]), Relation::zero([stress_below])]
        } else if stiffness.is_finite() {
            [Relation::zero([above.times(stiffness), -stress_above, -below.times(stiffness)]), transmitted]
        } else {
            [Relation::zero([above, -below]), transmitted]
        }
    };
    let [along, shear] = relations(U, T, joint.tangential);
    let [across, normal] = relations(V, S, joint.normal);
    [along, across, normal, shear]
}
