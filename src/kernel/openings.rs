//! Kernels of openings: laminates that are pressed together everywhere, by their weight or by a pressure on top, and come apart in places.
//!
//! Contact 0 is the one on top; opening i lies between laminate i − 1 and the bodies below. What is unknown there is the slope φ of the gap, as the pressure is in a contact, and what
//! is given is the pressure, which is zero. With the compliances g_ij of all contacts, where pressures make slopes, and k_i = g_0i, the components are
//!
//! * M = (g_ij)⁻¹ for i, j > 0: the pressure at i that a slope of the gap at j makes;
//! * t_i = −Σ M_ij k_j: the pressure at i that a unit pressure on top makes, and the slope on top that a slope of the gap at i makes;
//! * g_00 − Σ k_i M_ij k_j: the slope on top that a pressure on top makes, with all closed.
//!
//! All of these are bounded for long waves, t_i → 1 and M ~ ζ³. Written with the responses e_i of contacts under equal pressures of their neighbours and the bending compliances w_i of laminates, the equations
//! of the pressures are the ones of a chain of conductances, e_i p_i + w_(i−1) (p_i − p_(i−1)) + w_i (p_i − p_(i+1)) = s_i, and conductances in series and in parallel need no differences.
use super::components::Components;

/// The components, as they stand in a sample, from responses under equal pressures and from bending compliances.
pub(super) fn of_openings(order: Components, equal: &[f64], bending: &[f64], components: &mut [f64]) {
    let n = equal.len();
    // conductances from each contact downwards, and from each opening upwards to a top without pressure
    let (mut down, mut up) = (equal.to_vec(), equal.to_vec());
    for i in (0..n - 1).rev() {
        down[i] += in_series(bending[i], down[i + 1]);
    }
    for i in 1..n {
        up[i] += if i == 1 { bending[0] } else { in_series(bending[i - 1], up[i - 1]) };
    }
    let passed = |i: usize| part(bending[i], down[i + 1]);
    let mut own = down[0];
    for i in 0..n {
        if i > 0 {
            let below = if i + 1 < n { in_series(bending[i], down[i + 1]) } else { 0.0 };
            own = (up[i] + below).recip();
        }
        components[i] = own;
        components[order.equal(i)] = own;
        let mut through = if i == 0 { 1.0 } else { own };
        for j in i + 1..n {
            through *= passed(j - 1);
            let pair = order.neighbours(i).find(|(other, _)| *other == j).map_or(0, |(_, pair)| pair);
            components[order.coupling(pair)] = through;
        }
    }
}

/// Two conductances in series.
fn in_series(a: f64, b: f64) -> f64 {
    a * part(b, a)
}

/// a/(a + b), 0 where nothing conducts.
fn part(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / (a + b) }
}
