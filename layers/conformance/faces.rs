//! The law of faces: next to them the material varies at least in proportion to the depth.
use super::Violation;
use super::trial::Trial;
use crate::{Layer, Material, Plane, Wave};

/// Depths are compared by this factor.
const STEP: f64 = 16.0;
/// A change of the material by less than this is not looked at: a sixteenth or a 256th of it is rounding.
const LEAST: f64 = 1e-11;
/// The law is silent where the whole change is less than this: of 100,000 times [`LEAST`] there is a range of depths, far
/// below the length over which the material varies, that tells how it begins, also if it goes on like a logarithm.
const WHOLE: f64 = 1e-6;
/// Distances from the bottom face are known to 1e-4 of themselves from this part of the thickness on.
const KNOWN: f64 = 1e-12;
/// So many steps towards a face in a row have to tell of the same: a coefficient that turns round close to a face, and has there
/// its value at the face, spoils two.
const STEPS: usize = 3;
/// Exponents up to this are less than 1: their rounding is 1e-3, since changes are known to as much of themselves.
const ALMOST: f64 = 0.99;

/// A face towards which the material varies faster than in proportion to the depth, see [`smooth_faces`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughFace {
    /// `top` or `bottom`.
    pub face: &'static str,
    /// The exponent p < 1 of |E(d)/E(0) − 1| ~ d^p at the distance d from the face; 0 at a jump.
    pub exponent: f64,
    /// Up to which distance from the face that was seen, in length.
    pub distance: f64,
}

/// Next to its faces the material varies at least in proportion to the distance: it has a slope there. The response to short
/// waves is then a series in 1/λ, which is how the solver knows it. A modulus like 1 + √d makes it one in powers that no wavenumber
/// is large enough for.
///
/// # Errors
/// The first face where it varies like a power less than 1, or jumps.
pub fn smooth_faces(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("smooth_faces", layer, plane) else { return Ok(()) };
    let quantities = [
        ("top", "the exponent of the depth with which the material varies at the top face"),
        ("bottom", "the exponent of the distance with which the material varies at the bottom face"),
    ];
    for (face, quantity) in quantities {
        if let Some(rough) = rough_face(layer, plane, face == "bottom", 1.0) {
            let wave = Wave { wavenumber: rough.distance.recip(), ..trial.wave(1.0) };
            return Err(trial.violation(quantity, &wave, [rough.exponent, 1.0, 1.0 - ALMOST]));
        }
    }
    Ok(())
}

/// The top or the bottom face of a layer, if it breaks the law of [`smooth_faces`]. In a layer without a thickness,
/// distances are looked at from the 1e-72th of `length` to the 1e9th multiple.
pub fn rough_face(layer: &dyn Layer, plane: Plane, bottom: bool, length: f64) -> Option<RoughFace> {
    let thickness = layer.thickness();
    let (largest, steps) = thickness.map_or((STEP.powi(8) * length, 68), |thickness| (thickness, 26));
    if bottom && thickness.is_none() {
        return None;
    }
    let depth = |distance: f64| if bottom { largest - distance } else { distance };
    let nearest = if bottom { KNOWN * largest } else { 0.0 };
    let at_face = layer.material(depth(0.0), plane);
    let changes = (0..=steps).filter_map(|step| {
        // the distance that is left of it by rounding
        let depth = depth(largest / STEP.powi(step));
        let distance = if bottom { largest - depth } else { depth };
        let change = change(&at_face, &layer.material(depth, plane));
        (distance > nearest && change.is_finite()).then_some((distance, change))
    });
    // from the face on, the largest change up to a distance
    let mut changes: Vec<(f64, f64)> = changes.collect();
    changes.reverse();
    let mut most = 0.0;
    for (_, change) in &mut changes {
        most = f64::max(most, *change);
        *change = most;
    }
    if most < WHOLE {
        return None;
    }
    let felt = changes.windows(2).filter(|pair| pair[1].1 >= LEAST).take(STEPS);
    let exponent = |pair: &[(f64, f64)]| (pair[1].1 / pair[0].1).ln() / (pair[1].0 / pair[0].0).ln();
    let felt: Vec<(f64, f64)> = felt.map(|pair| (exponent(pair), pair[1].0)).collect();
    let rough = felt.len() == STEPS && felt.iter().all(|(exponent, _)| *exponent < ALMOST);
    let face = if bottom { "bottom" } else { "top" };
    let nearest = felt.first().filter(|_| rough)?;
    Some(RoughFace { face, exponent: nearest.0, distance: felt[STEPS - 1].1 })
}

/// The largest difference of two materials' coefficients, relative.
fn change(face: &Material, inside: &Material) -> f64 {
    let relative = |inside: f64, face: f64| (inside / face - 1.0).abs();
    let normal = (inside.normal_compliance - face.normal_compliance).abs() / face.shear_compliance;
    let coupling = (inside.coupling - face.coupling).abs() / (1.0 + face.coupling.abs());
    relative(inside.shear_compliance, face.shear_compliance)
        .max(relative(inside.axial_stiffness, face.axial_stiffness))
        .max(normal)
        .max(coupling)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Exponential, Graded, GradedHalfPlane, HalfPlane, Homogeneous, Isotropic, PowerHalfPlane};

    fn layer(thickness: f64, modulus: fn(f64) -> f64) -> Graded {
        Graded::with(thickness, move |depth| Isotropic { shear_modulus: modulus(depth / thickness), poisson: 0.3 })
            .expect("legal")
    }

    fn exponents(layer: &dyn Layer) -> [Option<f64>; 2] {
        let of = |bottom| rough_face(layer, Plane::Strain, bottom, 1.0).map(|rough| rough.exponent);
        [of(false), of(true)]
    }

    #[test]
    fn powers_below_one_are_found_with_their_exponents() {
        for thickness in [1e-6, 1.0, 3e4] {
            let near = |found: Option<f64>, p: f64| (found.expect("rough") - p).abs() < 1e-3;
            let [top, bottom] = exponents(&layer(thickness, |d| 1.0 + d.sqrt()));
            assert!(near(top, 0.5) && bottom.is_none());
            let [top, bottom] = exponents(&layer(thickness, |d| 1.0 + 1e-5 * (1.0 - d).powf(0.3)));
            assert!(top.is_none() && near(bottom, 0.3));
            let [top, bottom] = exponents(&layer(thickness, |d| if d > 0.0 { 2.0 } else { 1.0 }));
            assert!(near(top, 0.0) && bottom.is_none());
            let [top, _] = exponents(&layer(thickness, |d| 1.0 + d * if d > 0.0 { d.ln() } else { 0.0 }));
            assert!(top.is_some(), "a slope that is infinite");
        }
    }

    #[test]
    fn whatever_has_a_slope_is_none() {
        let smooth: [fn(f64) -> f64; 9] = [
            |d| 1.0 + d,
            |d| 1.0 + d * d,
            |d| 1.0 + d.powf(1.5),
            |d| (9.0 * d).exp(),
            |d| 1.0 + (-1e9 * d).exp(),
            |d| 1.0 + 0.3 * (400.0 * d).sin(),
            |d| 2.0 + (1e-3 - d) * d,
            |d| 1.0 + (1e-6 - d).powi(2) * d,
            |d| if d < 0.4 { 1.0 } else { 5.0 },
        ];
        for modulus in smooth {
            assert_eq!(exponents(&layer(0.3, modulus)), [None, None]);
        }
        let shipped: [&dyn Layer; 5] = [
            &Homogeneous::new(1.0, 2.0, 0.5).expect("legal"),
            &Exponential::new(1e-3, 2.0, 0.5, -4e4).expect("legal"),
            &HalfPlane::new(1.0, 0.2).expect("legal"),
            &GradedHalfPlane::new(1.0, 0.3, 1e4).expect("legal"),
            &PowerHalfPlane::new(1.0, 0.3, 1e-7, 0.3).expect("legal"),
        ];
        for exponent in [1e-12, 1e-10, 1e-9, 1e-6, 1e-3] {
            let ground = PowerHalfPlane::new(1.0, 0.3, 1.0, exponent).expect("legal");
            assert_eq!(exponents(&ground), [None, None], "{exponent}");
        }
        assert!(shipped.iter().all(|layer| exponents(*layer) == [None, None]));
    }
}
