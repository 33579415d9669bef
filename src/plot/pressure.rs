//! The pressure of a contact as a curve.
use crate::scene::Scene;
use crate::solution::{Contact, Interface, Interval};

/// Pressures that are infinite somewhere are drawn up to so many times their mean.
const HIGHEST_DRAWN: f64 = 6.0;
/// Points of a curve.
const POINTS: usize = 200;

/// The pressure of a contact, denser towards its ends, where it falls like a root; where it rises without bound, under a
/// sharp tip and at sharp corners, as far as a multiple of the mean.
pub(super) fn pressure(scene: &Scene, contact: &Contact) -> Vec<(f64, f64)> {
    let rises = contact.interface == Interface::Punch && scene.punch.is_singular();
    let most = if rises { HIGHEST_DRAWN * 0.5 * contact.resultant / contact.reach() } else { f64::INFINITY };
    let at = |Interval { left, right, .. }: Interval, i: usize| {
        let x = 0.5 * (left + right) - 0.5 * (right - left) * (std::f64::consts::PI * i as f64 / POINTS as f64).cos();
        let pressure = contact.pressure(x);
        (x, if pressure > most { f64::INFINITY } else { pressure })
    };
    contact.intervals().into_iter().flat_map(|interval| (0..=POINTS).map(move |i| at(interval, i))).collect()
}

/// The highest point of a curve, where it is finite.
pub(super) fn highest(curve: &[(f64, f64)]) -> f64 {
    curve.iter().map(|(_, p)| *p).filter(|p| p.is_finite()).fold(0.0, f64::max)
}
