//! Kernels of openings: laminates that are pressed together everywhere, by their weight or by a pressure on top, and come apart in places.
//!
//! The lowest contact is the one above all of them, and counts as 0 here; opening i lies between laminate i − 1 below that and the bodies below. What is unknown there is the slope φ of the gap, as the
//! pressure is in a contact, and what is given is the pressure, which is zero. With the compliances g_ij of all of these, where pressures make slopes, and k_i = g_0i, the components are
//!
//! * M = (g_ij)⁻¹ for i, j > 0: the pressure at i that a slope of the gap at j makes;
//! * t_i = −Σ M_ij k_j: the pressure at i that a unit pressure on top makes, and the slope on top that a slope of the gap at i makes;
//! * g_00 − Σ k_i M_ij k_j: the slope on top that a pressure on top makes, with all closed.
//!
//! All of these are bounded for long waves, t_i → 1 and M ~ ζ³.
use super::Kernel;
use super::components::Components;
use crate::system::ClosedContacts;

/// Pressures are looked at up to this distance beyond all that presses, over the wavenumber up to which a half of the pressure on top is carried, or over which kernels are one polynomial: no pressure that
/// decays like an exponential function reaches so far. Twice as far: no other place is found.
const FARTHEST: f64 = 40.0;
/// The part of a pressure on top that is carried by long waves.
const HALF: f64 = 0.5;

impl Kernel {
    /// How far from what presses pressures between layers are looked at, in units of L.
    pub(crate) fn farthest(&self) -> f64 {
        let carried = |pair: usize| {
            let panels = self.panels.iter().rev();
            panels.filter(|panel| panel.coupled[pair]).find_map(|panel| panel.last_coupled_above(pair, HALF))
        };
        let below = self.neighbours(self.lowest()).filter(|(other, _)| *other > self.lowest());
        let longest = below.filter_map(|(_, pair)| carried(pair)).fold(f64::INFINITY, f64::min);
        let first = self.panels.first().map_or(1.0, |panel| panel.to);
        FARTHEST / Some(longest).filter(|longest| longest.is_finite()).unwrap_or(first).max(first)
    }
}

/// The components of openings, as they stand in a sample.
pub(super) fn set_openings(order: Components, closed: &ClosedContacts, components: &mut [f64]) {
    let Components { lowest, contacts } = order;
    for i in lowest + 1..contacts {
        let own = closed.pressure(i - lowest, i - lowest);
        (components[i], components[order.equal(i)]) = (own, own);
    }
    for pair in lowest..order.pairs() {
        let [above, below] = order.pair(pair).map(|own| own - lowest);
        components[order.coupling(pair)] =
            if above == 0 { closed.carried(below) } else { closed.pressure(above, below) };
    }
}
