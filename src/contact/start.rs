//! Where Newton's method starts: half-lengths from formulas of contact mechanics, right to some ten per cent.
use crate::Error;
use crate::kernel::Kernel;

use super::punch::Indentation;

/// Half-length of the contact of a strip of thickness 1 that a line load presses on a rigid base.
const ON_RIGID_BASE: f64 = 0.857;
/// Half-length of the contact of a plate that a line load presses on a soft half-plane, in units of (D/E*)^(1/3),
/// about.
const ON_SOFT_BASE: f64 = 1.4;
/// The wavenumber that stands for a pressure of half-length a is this over a.
const TYPICAL: f64 = 1.2;

/// The force P' at which the contact under the punch is expected to have a half-length (in units of L), for an
/// indentation by P' = 1.
pub(super) fn force(kernel: &Kernel, punch: &Indentation, half_length: f64) -> Result<f64, Error> {
    Ok(punch.first_row(half_length) * half_length / compliances(kernel, TYPICAL / half_length)?[0])
}

/// Half-lengths in units of L, from the top down.
pub(super) fn half_lengths(kernel: &Kernel, punch: &Indentation) -> Result<Vec<f64>, Error> {
    let first = if let Some(given) = punch.given() {
        given.half_length
    } else if let Some(flat) = punch.flat() {
        flat
    } else {
        // punch: Hertz, on the compliance that the whole stack has for waves as long as the contact
        let (mut low, mut high): (f64, f64) = (1e-100, 1e6);
        if let Some(limit) = punch.max_half_length() {
            high = limit;
            low = low.min(0.5 * high);
        }
        while high / low > 1.0 + 1e-4 {
            let a = low.sqrt() * high.sqrt();
            let compliance = compliances(kernel, TYPICAL / a)?[0];
            if punch.first_row(a) < compliance / a { low = a } else { high = a }
        }
        if let Some(error) = punch.too_small(low) {
            return Err(error);
        }
        low.sqrt() * high.sqrt()
    };
    let mut half_lengths = vec![first];
    for (laminate, (thickness, rigidity)) in kernel.laminates()?.into_iter().enumerate() {
        let mut local = ON_RIGID_BASE * thickness;
        for _ in 0..4 {
            let below = compliances(kernel, TYPICAL / local)?[laminate + 1];
            local = ON_RIGID_BASE * thickness + ON_SOFT_BASE * (0.5 * rigidity * below).cbrt();
        }
        half_lengths.push(half_lengths[laminate].hypot(local));
    }
    Ok(half_lengths)
}

/// For each contact the compliance λμ₀C of all that lies below it, as if the interfaces further down slid without
/// opening.
fn compliances(kernel: &Kernel, zeta: f64) -> Result<Vec<f64>, Error> {
    let (laminates, base) = kernel.flexibilities(zeta)?;
    let mut below = base;
    let mut compliances = vec![base];
    for laminate in laminates.iter().rev() {
        // top − coupling²/(below − bottom), arranged so that a long wave loses less
        let sum = below - laminate.bottom;
        let own = (-laminate.top * laminate.bottom - laminate.coupling * laminate.coupling).max(0.0);
        below = (own + laminate.top * below) / sum;
        compliances.push(below);
    }
    compliances.reverse();
    compliances[0] += kernel.punch();
    Ok(compliances)
}
