//! Pressures between layers that are pressed together and come apart in places, as loads on the bodies above and below: what the pressure on top and the slopes of gaps make together.
//!
//! For short waves a slope φ of the gap makes the pressure iμ₀M φ̂, a quarter of a wave aside, with a constant M: this part has the closed forms of φ as a pressure, times a factor. What
//! else there is decays with the wavenumber, see [`ClosedContacts`].
use std::sync::Arc;

use num_complex::Complex64;
use recede_layers::{Plane, Wave};

use super::pressure::ContactPressure;
use super::strip::TabulatedStrip;
use super::transform::Transform;
use crate::solution::ClosedInterface;
use crate::stack::Stack;
use crate::system::{BaseChain, BlockSystem, ClosedContacts, FreeChain};

/// A wave as short as this, over the thickness of the stack, sees no more of it than faces.
const SHORT: f64 = 1e12;

/// The bodies of a stack whose contacts below the first one are closed but for openings.
#[derive(Clone, Debug)]
pub(super) struct ClosedBodies {
    laminates: Vec<FreeChain>,
    base: BaseChain,
    plane: Plane,
    modulus: f64,
    /// The pressure on top.
    top: ContactPressure,
    /// The slopes of the gaps of each interface, as pressures.
    slopes: Vec<Vec<TabulatedStrip>>,
}

/// The pressure of one interface.
#[derive(Clone, Debug)]
pub(super) struct Closed {
    bodies: Arc<ClosedBodies>,
    /// Its number, from 1.
    number: usize,
    /// μ₀M of short waves, in stress.
    pub(super) stiffness: f64,
}

impl ClosedBodies {
    pub(super) fn new(stack: &Stack, modulus: f64, top: ContactPressure, closed: &[ClosedInterface]) -> Self {
        let system = BlockSystem::new(stack);
        let slopes = closed.iter().map(|own| own.slopes.iter().map(TabulatedStrip::new).collect()).collect();
        let (laminates, base, plane) = (FreeChain::all(&system), BaseChain::of(&system), stack.plane());
        Self { laminates, base, plane, modulus, top, slopes }
    }

    /// All of its contacts at one wavenumber; `None` if a layer's states are not finite.
    fn at(&self, wavenumber: f64) -> Option<ClosedContacts> {
        let wave = Wave { wavenumber, modulus: self.modulus, plane: self.plane };
        let mut equal = vec![0.0; self.laminates.len() + 1];
        let mut bending = Vec::with_capacity(self.laminates.len());
        for (i, laminate) in self.laminates.iter().enumerate() {
            let c = laminate.flexibility(&wave)?;
            equal[i] += c.equal_top;
            equal[i + 1] -= c.equal_bottom;
            bending.push(-c.coupling);
        }
        equal[self.laminates.len()] += self.base.flexibility(&wave)?;
        Some(ClosedContacts::new(&equal, &bending))
    }
}

impl Closed {
    pub(super) fn new(bodies: &Arc<ClosedBodies>, number: usize, thickness: f64) -> Self {
        let stiffness = bodies.at(SHORT / thickness).map_or(0.0, |closed| closed.pressure(number, number));
        Self { bodies: Arc::clone(bodies), number, stiffness: bodies.modulus * stiffness }
    }

    /// The pressure on top, which has the same resultant and moment.
    pub(super) fn top(&self) -> &ContactPressure {
        &self.bodies.top
    }

    /// The transforms at some wavenumbers; no numbers where a layer's states are not finite.
    pub(super) fn transforms(&self, wavenumbers: &[f64]) -> Vec<Transform> {
        let top = self.bodies.top.transforms(wavenumbers);
        let slopes: Vec<Vec<Complex64>> =
            self.bodies.slopes.iter().map(|strips| super::pressure::sum_of(strips, wavenumbers)).collect();
        let of = |(k, wavenumber): (usize, &f64)| {
            let Some(closed) = self.bodies.at(*wavenumber) else { return Transform::none() };
            let (carried, lost) = (closed.carried(self.number), closed.lost(self.number));
            let by_gaps = slopes.iter().enumerate().map(|(other, slopes)| {
                Complex64::I * self.bodies.modulus * closed.pressure(self.number, other + 1) * slopes[k]
            });
            let by_gaps: Complex64 = by_gaps.sum();
            Transform {
                value: carried * top[k].value + by_gaps,
                variation: top[k].variation - lost * top[k].value + by_gaps,
                local: Complex64::I * self.stiffness * slopes[self.number - 1][k],
            }
        };
        wavenumbers.iter().enumerate().map(of).collect()
    }
}
