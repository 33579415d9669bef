//! The force that makes a contact about as long as wanted, without solving anything.
//!
//! Receding interfaces are taken as sliding but closed. Then a pressure p(x) ∝ (1 − s²)^(m − 1/2), s = x/a, of resultant P
//! stores the energy P² E_m(a) and does the work P F_m(a) along the profile of the punch, and the half-length is where
//! their sum is least: P = −F_m'/E_m', with
//!
//! ```text
//! φ_m(z) = 2^m m! J_m(z)/z^m                 transform of the pressure per unit of P, z = λa
//! E_m'   = 1/(πa) ∫ λC φ_m φ_m' dz           λC: compliance of the stack
//! F_m'   = ∫ p s f'(as) ds / ∫ p ds          f: profile of the punch
//! ```
//!
//! m = 1 is the pressure on a half-plane, larger m are pressures on layers thin against the contact. Of all m that which
//! needs the largest force is closest to the exact one.
use std::f64::consts::PI;

use recede_layers::Wave;

use super::scenario::Scenario;
use crate::errors::Error;
use crate::numeric::{bessel, quadrature};
use crate::stack::Stack;
use crate::system::{BaseChain, BlockSystem, FreeChain};

/// The integral over z = λa is summed up in these panels: what lies beyond the last cancels.
const PANELS: [f64; 14] = [0.0, 1e-3, 1e-2, 0.1, 0.5, 1.0, 2.5, 5.0, 7.5, 10.0, 13.0, 16.0, 20.0, 25.0];
const NODES: usize = 8;
/// Number of orders m.
const ORDERS: usize = 3;
/// Number of places at which the slope of the punch is evaluated.
const PLACES: usize = 64;

/// The force; the force on the uppermost layer alone if the compliance of the stack cannot be computed.
pub(super) fn force(scenario: &Scenario, half_length: f64) -> f64 {
    match estimate(scenario, half_length) {
        Ok(Some(force)) if force > 0.0 && force.is_finite() => force,
        _ => 0.5 * PI * half_length.powi(2) * scenario.layers[0].modulus / scenario.radius,
    }
}

fn estimate(scenario: &Scenario, half_length: f64) -> Result<Option<f64>, Error> {
    let stack = Stack::from_items(scenario.plane, &scenario.items()?)?;
    let system = BlockSystem::new(&stack);
    let (laminates, base) = (FreeChain::all(&system), BaseChain::of(&system));
    let nodes: Vec<(f64, f64)> =
        PANELS.windows(2).flat_map(|ends| quadrature::rule(NODES).on(ends[0], ends[1])).collect();
    let z: Vec<f64> = nodes.iter().map(|(z, _)| *z).collect();
    let mut j = vec![0.0; (ORDERS + 2) * z.len()];
    bessel::table(ORDERS + 2, &z, &mut j);
    let mut energies = [0.0; ORDERS];
    for (i, (z, weight)) in nodes.iter().enumerate() {
        let Some(compliance) = compliance(scenario, &laminates, &base, z / half_length) else { return Ok(None) };
        for (m, energy) in (1..).zip(&mut energies) {
            // φ_m' = −2^m m! J_(m+1)/z^m
            let factor: f64 = (1..=m).map(|k| 2.0 * k as f64 / z).product();
            let slope = -factor * j[(m + 1) * nodes.len() + i];
            *energy += weight * compliance * factor * j[m * nodes.len() + i] * slope;
        }
    }
    let punch = scenario.punch()?;
    let forces = (1..).zip(energies).map(|(m, energy)| {
        let (mut work, mut resultant) = (0.0, 0.0);
        for k in 0..PLACES {
            let s = (PI * (k as f64 + 0.5) / (2 * PLACES) as f64).cos();
            let pressure = (1.0 - s * s).powi(m);
            work += pressure * s * punch.slope(s * half_length);
            resultant += pressure;
        }
        -PI * half_length * work / resultant / energy
    });
    Ok(forces.reduce(f64::max))
}

/// λC of a stack whose receding interfaces slide but do not open, in 1/stress.
fn compliance(scenario: &Scenario, laminates: &[FreeChain], base: &BaseChain, wavenumber: f64) -> Option<f64> {
    let modulus = scenario.layers[0].modulus;
    let wave = Wave { wavenumber, modulus, plane: scenario.plane };
    let mut compliance = base.flexibility(&wave)?;
    for laminate in laminates.iter().rev() {
        let c = laminate.flexibility(&wave)?;
        // S_bottom/S_top − 1, small for long waves: they pass through
        let lost = (c.equal_bottom - compliance) / (compliance - c.bottom);
        compliance = c.equal_top + c.coupling * lost;
    }
    Some(compliance / modulus)
}
