//! Pressures between layers that are pressed together and come apart in places, as loads on the bodies above and below: what the pressure on top and the slopes of gaps make together.
//!
//! For short waves a gap g with the slope φ makes the pressure iμ₀M φ̂ (1 + c/λ) with constants M and c, where c is 0 unless a layer is graded at its face: since iφ̂ = λĝ, this part has
//! the closed forms of φ as a pressure, a quarter of a wave aside, and of g as another one. What else there is decays with the wavenumber, see [`ClosedContacts`].
use std::sync::Arc;

use num_complex::Complex64;
use recede_layers::{Plane, Wave};

use super::strip::TabulatedStrip;
use super::transform::{Potentials, Transform};
use crate::solution::{ClosedInterface, Contact, Strip};
use crate::stack::{Dent, Gaps, Stack};
use crate::system::{BaseChain, BlockSystem, ClosedContacts, FreeChain};

/// A wave as short as this, over the thickness of the thinnest layer, sees no more of the stack than faces, and a wave like the next one no more than how they are graded.
const SHORT: f64 = 1e12;
const LONGER: f64 = 1e4;

/// The bodies of a stack below a contact, all in contact but for openings.
#[derive(Clone, Debug)]
pub(super) struct ClosedBodies {
    laminates: Vec<FreeChain>,
    base: BaseChain,
    plane: Plane,
    modulus: f64,
    /// The pressure of the contact above them.
    top: Vec<TabulatedStrip>,
    /// The slopes of the gaps of each interface, as pressures.
    slopes: Vec<Vec<TabulatedStrip>>,
    /// The dents of each interface, which are pressed flat but for openings.
    dents: Vec<Option<Dent>>,
}

/// The pressure of one interface.
#[derive(Clone, Debug)]
pub(super) struct Closed {
    bodies: Arc<ClosedBodies>,
    /// Its number, from 1.
    number: usize,
    /// μ₀M of short waves, in stress, and c times it.
    stiffness: f64,
    gradation: f64,
    /// The gaps.
    gaps: Vec<TabulatedStrip>,
}

impl ClosedBodies {
    pub(super) fn new(stack: &Stack, modulus: f64, top: &Contact, closed: &[ClosedInterface], gaps: &Gaps) -> Self {
        let top = top.strips.iter().map(TabulatedStrip::new).collect();
        let system = BlockSystem::new(stack);
        let slopes = closed.iter().map(|own| own.slopes.iter().map(TabulatedStrip::new).collect()).collect();
        let mut laminates = FreeChain::all(&system);
        laminates.drain(..laminates.len() - closed.len());
        let (base, plane) = (BaseChain::of(&system), stack.plane());
        let dents = closed.iter().map(|own| gaps.dent(own.interface)).collect();
        Self { laminates, base, plane, modulus, top, slopes, dents }
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
    /// Of an interface by its number, in a stack with a thinnest layer.
    pub(super) fn new(bodies: &Arc<ClosedBodies>, number: usize, thinnest: f64) -> Self {
        let stiffness =
            |wave: f64| bodies.at(wave).map_or(0.0, |closed| bodies.modulus * closed.pressure(number, number));
        let short = stiffness(SHORT / thinnest);
        let [once, twice] =
            [1.0, 2.0].map(|times| times * LONGER / thinnest).map(|wave| wave * (stiffness(wave) - short));
        let gaps =
            bodies.slopes[number - 1].iter().map(|slope| TabulatedStrip::new(&slope.strip.antiderivative())).collect();
        // two waves tell it without the next power of 1/λ
        Self { bodies: Arc::clone(bodies), number, stiffness: short, gradation: 2.0 * twice - once, gaps }
    }

    /// μ₀M (1 + c/λ) at a wavenumber.
    fn local(&self, wavenumber: f64) -> f64 {
        self.stiffness + self.gradation / wavenumber
    }

    /// The potentials of the part with closed forms at a place and a depth, from the potentials of the slopes.
    pub(super) fn potentials(&self, slopes: Potentials, (x, depth): (f64, f64), integral: bool) -> Potentials {
        // a quarter of a wave aside
        let mut sums = slopes.map(|slope| -Complex64::I * self.stiffness * slope);
        for gap in &self.gaps {
            let own = gap.potentials(x - gap.strip.at, depth, integral);
            sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += self.gradation * own);
        }
        sums
    }

    /// The distance of the farthest end of the pressure on top.
    pub(super) fn half_length(&self) -> f64 {
        let ends = self.bodies.top.iter().flat_map(|one| one.strip.ends());
        ends.fold(0.0, |most: f64, end| most.max(end.abs()))
    }

    /// The transform of long waves: the pressure on top has the same resultant and moment.
    pub(super) fn long_waves(&self, wavenumber: f64) -> Complex64 {
        let strips = || self.bodies.top.iter().map(|one| &one.strip);
        let moment = strips().map(|strip| strip.at * strip.long_waves() + strip.moment()).sum::<f64>();
        Complex64::new(strips().map(Strip::long_waves).sum(), wavenumber * moment)
    }

    /// An amplitude of p̂ at a wavenumber, and of what is not local in it; infinite where a layer's states are not finite.
    pub(super) fn envelopes(&self, wavenumber: f64) -> [f64; 2] {
        let ClosedBodies { top, slopes, dents, modulus, .. } = &*self.bodies;
        let Some(closed) = self.bodies.at(wavenumber) else { return [f64::INFINITY; 2] };
        let sum = |strips: &[TabulatedStrip]| strips.iter().map(|one| one.envelope(wavenumber)).sum::<f64>();
        let carried = closed.carried(self.number).abs() * sum(top);
        let mut envelopes = [carried; 2];
        for (number, (slopes, dent)) in (1..).zip(slopes.iter().zip(dents)) {
            let pressure = modulus * closed.pressure(self.number, number);
            let local = if number == self.number { self.local(wavenumber) } else { 0.0 };
            let flat = dent.map_or(0.0, |dent| (wavenumber * dent.transform(wavenumber)).abs());
            let own = sum(slopes);
            envelopes[0] += pressure.abs() * (own + flat);
            envelopes[1] += (pressure - local).abs() * own + pressure.abs() * flat;
        }
        envelopes
    }

    /// The transforms at some wavenumbers; no numbers where a layer's states are not finite.
    pub(super) fn transforms(&self, wavenumbers: &[f64]) -> Vec<Transform> {
        let top = sum_of(&self.bodies.top, wavenumbers);
        let slopes: Vec<Vec<Transform>> = self.bodies.slopes.iter().map(|strips| sum_of(strips, wavenumbers)).collect();
        let of = |(k, wavenumber): (usize, &f64)| {
            let Some(closed) = self.bodies.at(*wavenumber) else { return Transform::none() };
            let (carried, lost) = (closed.carried(self.number), closed.lost(self.number));
            let by_gaps = slopes.iter().zip(&self.bodies.dents).enumerate().map(|(other, (slopes, dent))| {
                // where layers touch, the slope of a dent is taken away
                let flat = dent.map_or(0.0, |dent| wavenumber * dent.transform(*wavenumber));
                let slope = slopes[k].value + Complex64::I * flat;
                Complex64::I * self.bodies.modulus * closed.pressure(self.number, other + 1) * slope
            });
            let by_gaps: Complex64 = by_gaps.sum();
            Transform {
                value: carried * top[k].value + by_gaps,
                variation: top[k].variation - lost * top[k].value + by_gaps,
                local: Complex64::I * self.local(*wavenumber) * slopes[self.number - 1][k].value,
            }
        };
        wavenumbers.iter().enumerate().map(of).collect()
    }
}

/// The transforms of strips together.
fn sum_of(strips: &[TabulatedStrip], wavenumbers: &[f64]) -> Vec<Transform> {
    let mut sums = vec![Transform::default(); wavenumbers.len()];
    for TabulatedStrip { strip, .. } in strips {
        let own = strip.transforms(wavenumbers).into_iter().zip(wavenumbers);
        let moved = own.map(|(own, wavenumber)| own.moved(*wavenumber, strip.at, strip.long_waves()));
        for (sum, Transform { value, variation, .. }) in sums.iter_mut().zip(moved) {
            sum.value += value;
            sum.variation += variation;
        }
    }
    sums
}
