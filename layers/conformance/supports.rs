//! The law of supports.
use super::trial::{EXTREME, USUAL};
use super::{ROUNDING, Violation};
use crate::{Plane, Support, Wave};

/// The states of a support are finite and not all of them zero, do no net work on each other, and give no work back.
///
/// # Errors
/// The first number that breaks it.
pub fn support(support: &dyn Support, plane: Plane) -> Result<(), Violation> {
    for wavenumber in USUAL.into_iter().chain(EXTREME) {
        let wave = Wave { wavenumber, modulus: 1.0, plane };
        let states = support.face_states(&wave);
        let holds = |quantity: &'static str, found: f64, expected: f64, tolerance: f64, holds: bool| {
            let law = "support";
            if holds { Ok(()) } else { Err(Violation { law, quantity, plane, wavenumber, found, expected, tolerance }) }
        };
        holds("a number of a state", states.sum(), 0.0, f64::MAX, states.iter().all(|x| x.is_finite()))?;
        let [a, b] = [states.column(0), states.column(1)];
        let least = a.amax().min(b.amax());
        holds("the largest number of a state (finite, more than)", least, 0.0, 0.0, least > 0.0)?;
        let scale = ROUNDING * a.amax() * b.amax();
        let net = a[0] * b[3] - a[3] * b[0] + a[1] * b[2] - a[2] * b[1];
        holds("U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂ of both states", net, 0.0, scale, net.abs() <= scale)?;
        let work = |i: usize, k: usize| {
            let (one, two) = (states.column(i), states.column(k));
            0.5 * (one[0] * two[3] + one[3] * two[0] + one[1] * two[2] + one[2] * two[1])
        };
        let most = work(0, 0).abs().max(work(1, 1).abs()).max(work(0, 1).abs());
        let least = work(0, 0).min(work(1, 1));
        let allowed = -ROUNDING * most - f64::MIN_POSITIVE;
        holds("U T + V S of one state (more than)", least, allowed, 0.0, least > allowed)?;
        let determinant = work(0, 0) * work(1, 1) - work(0, 1).powi(2);
        let allowed = -ROUNDING * most.powi(2) - f64::MIN_POSITIVE;
        holds("determinant of U T + V S (more than)", determinant, allowed, 0.0, determinant > allowed)?;
    }
    Ok(())
}
