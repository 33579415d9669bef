//! Gaps outside the contacts, by quadrature of their slopes.
use std::f64::consts::PI;

use crate::numeric::quadrature::rule;

use crate::collocation::equations::Pressures;
use crate::collocation::nodes::Nodes;
use crate::collocation::spatial::Spatial;
use crate::collocation::spatial::cauchy_outside;
use crate::contact::problem::Side;

/// Number of places per contact at which gaps are checked.
const PLACES: usize = 24;

/// Places x > a of contact i up to `extent` (in units of L), dense next to its end, and the gap there per unit of P'.
pub(super) fn gaps(
    spatial: &Spatial,
    nodes: &Nodes,
    side: &Side,
    half_lengths: &[f64],
    pressures: &Pressures,
    (i, extent): (usize, f64),
) -> Vec<(f64, f64)> {
    let a = half_lengths[i];
    let coefficients = nodes.coefficients(&pressures.phi[i]);
    let end = side.edge().map_or(extent, |edge| extent.min(edge));
    let farthest = (end / a).max(1.0).acosh();
    let tau = |k: usize| farthest * (k as f64 / PLACES as f64).powi(2);
    let mut deflection = 0.0;
    (1..=PLACES)
        .map(|k| {
            for (tau, weight) in rule(8).on(tau(k - 1), tau(k)) {
                let slope = spatial.diagonals[i].limit / a * cauchy_outside(&coefficients, tau)
                    + smooth_slope(spatial, nodes, half_lengths, pressures, i, a * tau.cosh());
                deflection += weight * a * tau.sinh() * slope / PI;
            }
            let x = a * tau(k).cosh();
            (x, side.height(x) - side.height(a) - deflection)
        })
        .collect()
}

/// π times the slope at x in contact i, without that due to the Cauchy kernel.
fn smooth_slope(
    spatial: &Spatial,
    nodes: &Nodes,
    half_lengths: &[f64],
    pressures: &Pressures,
    i: usize,
    x: f64,
) -> f64 {
    let mut slope = 0.0;
    for (k, (s, weight)) in nodes.s.iter().zip(&nodes.weights).enumerate() {
        let (t, share) = (half_lengths[i] * s, weight * pressures.phi[i][k]);
        slope += share * (spatial.diagonals[i].total(x - t) + spatial.diagonals[i].total(x + t));
        for l in spatial.neighbours(i) {
            let other = weight * pressures.phi[l][k];
            slope += 2.0 * other * spatial.difference(i, l, x, half_lengths[l] * s);
            slope -= 2.0 * share * spatial.difference(i, l, x, t);
        }
    }
    slope
}
