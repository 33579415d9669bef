//! The surface of a half-plane, and the coefficients of the state equations.
use nalgebra::{Matrix2, Matrix4x2};

use crate::Material;

/// The flexibility of a homogeneous half-plane: (λμ₀U, λμ₀V) at its top face from (S, T) on it.
///
/// With the roots s₁, s₂ of s⁴ − (em − 2c) s² + c² + ed = 0 (coefficients in units of μ₀) only s₁s₂ and s₁ + s₂ enter,
/// so that coalescing or complex roots need no care.
pub(crate) fn surface_flexibility(material: &Material, modulus: f64) -> Matrix2<f64> {
    let Coefficients { m, c, d, e } = Coefficients::new(material, modulus);
    let product = (c * c + e * d).sqrt();
    let sum = (e * m - 2.0 * c + 2.0 * product).sqrt();
    let cross = if c > 0.0 { d / (product + c) } else { (product - c) / e };
    Matrix2::new(cross, sum / e, product * sum / e, cross)
}

/// The states at t = λd inside a homogeneous half-plane for S = 1 and for T = 1 on its face.
///
/// Stresses there are e^(−tM) times those on the face, where M has the roots s₁, s₂ as eigenvalues.
pub(crate) fn surface_states(material: &Material, modulus: f64, t: f64) -> Matrix4x2<f64> {
    let Coefficients { m, c, d, e } = Coefficients::new(material, modulus);
    let product = (c * c + e * d).sqrt();
    let half = 0.5 * (e * m - 2.0 * c + 2.0 * product).sqrt();
    let square = half * half - product;
    let difference = square.abs().sqrt();
    // S due to S, T due to T and, but for the sign of one of them, both the others: from e^(−t·half) times cosh and sinh of
    // t·difference, the latter over the difference; cos and sin if roots are complex
    let (normal, shear, odd) = if square > 0.0 {
        // the slower root without a difference
        let fast = half + difference;
        let slow = product / fast;
        let [slow_decay, fast_decay] = [slow, fast].map(|root| (-t * root).exp());
        let ratio = -0.5 * (-2.0 * t * difference).exp_m1() / difference;
        let odd = if slow_decay > 0.0 { slow_decay * ratio } else { 0.0 };
        (slow_decay + odd * slow, fast_decay - odd * slow, odd)
    } else {
        let decay = (-t * half).exp();
        let (sin, cos) = (t * difference).sin_cos();
        let ratio = if difference > 0.0 { sin / difference } else { t };
        let (even, odd) = (decay * cos, if decay > 0.0 { decay * ratio } else { 0.0 });
        (even + odd * half, even - odd * half, odd)
    };
    let stresses = Matrix2::new(normal, odd, -odd * product, shear);
    let displacements = surface_flexibility(material, modulus) * stresses;
    Matrix4x2::from_fn(|i, j| if i < 2 { displacements[(i, j)] } else { stresses[(i - 2, j)] })
}

/// The coefficients of the state equations for (λμ₀U, λμ₀V, S, T).
#[derive(Clone, Copy)]
pub(super) struct Coefficients {
    pub m: f64,
    pub c: f64,
    pub d: f64,
    pub e: f64,
}

impl Coefficients {
    pub fn new(material: &Material, modulus: f64) -> Self {
        Self {
            m: material.shear_compliance * modulus,
            c: material.coupling,
            d: material.normal_compliance * modulus,
            e: material.axial_stiffness / modulus,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClosedForm, FaceStates, HalfPlane, Isotropic, Plane, Wave};

    #[test]
    fn the_surface_of_a_half_plane_is_a_closed_form() {
        for poisson in [-0.9, 0.0, 0.25, 0.5] {
            for plane in [Plane::Strain, Plane::Stress] {
                let material = Isotropic { shear_modulus: 3.0, poisson };
                let wave = Wave { wavenumber: 2.0, modulus: 5.0, plane };
                let ground = HalfPlane::new(3.0, poisson).expect("legal");
                let FaceStates::HalfPlane { top } = ground.face_states(&wave) else { panic!("one face") };
                let predicted = surface_flexibility(&material.material(plane), wave.modulus) * top.fixed_rows::<2>(2);
                assert!((predicted - top.fixed_rows::<2>(0)).amax() < 1e-14, "{poisson} {plane:?}");
            }
        }
    }
}
