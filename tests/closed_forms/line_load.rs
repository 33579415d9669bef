//! A strip that lies on its base without adhesion, friction or weight, pressed down by a line load.
//!
//! Away from the load the strip lifts off. The half-length b of the contact that remains does not depend on the load:
//! the contact recedes to it at the first touch. It is the limit of any punch for a vanishing force, and depends only
//! on the thickness h and on the ratio of the plane moduli of strip and base,
//!
//! ```text
//! k = E*₁/E*₂ = [μ₁/(1 - ν₁)]/[μ₂/(1 - ν₂)]   (plane strain).
//! ```
//!
//! Keer, Dundurs and Tsai 1972 and Gladwell 1976 treat the problem. The constants come from a
//! multiple-precision evaluation, and are solved for again by this module's tests.

use super::Elastic;

/// b/h on a rigid base, k = 0.
pub const RIGID_BASE: f64 = 0.856_993_923_276;

/// b/h for strip and half-plane of the same plane modulus, k = 1.
pub const EQUAL_MODULI: f64 = 1.324_165_371_868;

/// b/h for a strip four times as stiff as the half-plane, k = 4.
pub const STRIP_FOUR_TIMES_STIFFER: f64 = 2.008_327_043_062;

/// The limit of b/(h k^(1/3)) for large k: a bending beam on an elastic half-plane.
pub const BEAM: f64 = 1.224_515_27;

/// k = E*₁/E*₂ of a strip and its base; zero for a rigid base (`None`).
pub fn stiffness_ratio(strip: Elastic, base: Option<Elastic>) -> f64 {
    base.map_or(0.0, |base| strip.plane_modulus() / base.plane_modulus())
}

/// b of a strip of the given thickness for the stiffness ratio k >= 0, to 0.04 %: a start for an iteration.
///
/// The formula is exact for k = 0 and k -> ∞ and fitted in between:
///
/// ```text
/// (b/h)³ = 0.857³ + 1.2245³ k + k (0.2351 k - 0.571)/(1 + 0.4911 k + 0.862 k^(5/3))
/// ```
pub fn approximate_half_length(thickness: f64, stiffness_ratio: f64) -> f64 {
    let k = stiffness_ratio;
    let bend = (0.2351 * k - 0.571) / (1.0 + 0.4911 * k + 0.862 * k.powf(5.0 / 3.0));
    thickness * (RIGID_BASE.powi(3) + k * (BEAM.powi(3) + bend)).cbrt()
}

mod tests {
    use super::super::strip;
    use super::*;
    use recede::numeric::{bessel, quadrature::rule};
    use std::f64::consts::{FRAC_PI_2, PI};

    /// What is left over of the first row of Galerkin's equations for a trial half-length b; h = 1, and 2/E* = 1.
    ///
    /// With the flexibilities e (equal loads) and w = 1 + d (own face) of the strip, the gap's slope vanishes if
    /// ∫ [(1 + k) q + d (q - 1) + (e - 1)] sin λx dλ = 0 on |x| < b for the transform q of the contact pressure,
    /// q = 2 J_1(z)/z + π Σ σ_j j c_j J_j(z)/z with z = λb, σ_j = (-1)^((j-1)/2), j = 3, 5, ... The rows are the scalar
    /// products with T_m, m = 1, 3, ...; they turn the sine into J_m(z).
    fn left_over(k: f64, b: f64, modes: usize) -> f64 {
        let free = Elastic { shear_modulus: 1.0, kappa: 3.0 };
        let (mut wavenumbers, mut weights) = (Vec::new(), Vec::new());
        let (mut lo, mut hi) = (0.0, 1.0 / b.max(1.0));
        while lo < 60.0 {
            for (node, weight) in rule(24 + ((hi - lo) * b) as usize).on(lo, hi) {
                wavenumbers.push(node);
                weights.push(weight);
            }
            (lo, hi) = (hi, 1.6 * hi);
        }
        let z: Vec<f64> = wavenumbers.iter().map(|l| l * b).collect();
        let mut table = vec![0.0; 2 * modes * z.len()];
        bessel::table(2 * modes, &z, &mut table);
        let bessel_of = |order: usize| &table[order * z.len()..][..z.len()];
        let integral = |f: &dyn Fn(usize) -> f64| -> f64 { (0..z.len()).map(|i| weights[i] * f(i)).sum() };
        let own: Vec<f64> = wavenumbers.iter().map(|&l| strip::own_face(free, 1.0, l) - 1.0).collect();
        let load: Vec<f64> = (0..z.len())
            .map(|i| own[i] * bessel::jinc_minus_one(z[i]) + strip::equal_loads(free, 1.0, wavenumbers[i]) - 1.0)
            .collect();

        // Rows for m = 1, 3, ...; columns for c_3, c_5, ..., then the known part. The first row is reduced, never a
        // pivot.
        let mut rows: Vec<Vec<f64>> = (0..modes)
            .map(|r| {
                let m = bessel_of(2 * r + 1);
                let coupling = |c: usize| {
                    let (j, sign) = (bessel_of(2 * c + 1), if c.is_multiple_of(2) { 1.0 } else { -1.0 });
                    let own = sign * PI * (2 * c + 1) as f64 * integral(&|i| own[i] * m[i] * j[i] / wavenumbers[i]);
                    own + if r == c { sign * FRAC_PI_2 * (1.0 + k) } else { 0.0 }
                };
                let known = integral(&|i| load[i] * m[i]) + if r == 0 { (1.0 + k) / b } else { 0.0 };
                (1..modes).map(coupling).chain([known]).collect()
            })
            .collect();
        for pivot in 1..modes {
            let pivot_row = rows[pivot].clone();
            for (_, row) in rows.iter_mut().enumerate().filter(|(r, _)| *r != pivot) {
                let factor = row[pivot - 1] / pivot_row[pivot - 1];
                row.iter_mut().zip(&pivot_row).for_each(|(x, p)| *x -= factor * p);
            }
        }
        rows[0][modes - 1]
    }

    fn solved(k: f64, modes: usize) -> f64 {
        let (mut old, mut new) = (0.99, 1.01);
        (old, new) = (old * approximate_half_length(1.0, k), new * approximate_half_length(1.0, k));
        let mut old_rest = left_over(k, old, modes);
        for _ in 0..20 {
            let rest = left_over(k, new, modes);
            let next = new - rest * (new - old) / (rest - old_rest);
            if (next - new).abs() < 1e-13 * new {
                return next;
            }
            (old, old_rest, new) = (new, rest, next);
        }
        panic!("no half-length for k = {k}");
    }

    #[test]
    fn constants_solve_the_contact_equation() {
        for (k, known) in [(0.0, RIGID_BASE), (1.0, EQUAL_MODULI), (4.0, STRIP_FOUR_TIMES_STIFFER)] {
            for modes in [10, 16] {
                let b = solved(k, modes);
                assert!((b - known).abs() < 1e-11, "k = {k}: {b} is not {known}");
            }
        }
        let k = 1e12f64;
        assert!((solved(k, 16) / k.cbrt() - BEAM).abs() < 1e-8);
    }

    #[test]
    fn approximation_keeps_its_promise() {
        for exponent in -6..=18 {
            let k = 10f64.powf(0.5 * f64::from(exponent));
            let (b, exact) = (approximate_half_length(1.0, k), solved(k, 16));
            assert!((b / exact - 1.0).abs() < 4e-4, "k = {k}: {b} is not near {exact}");
        }
        assert!((approximate_half_length(3.0, 0.0) - 3.0 * RIGID_BASE).abs() < 1e-15);
    }

    #[test]
    fn the_fit_meets_the_constant_of_a_stiff_strip() {
        let [soft, stiff] = [1.0, 4.0].map(|shear_modulus| Elastic::plane_strain(shear_modulus, 0.25));
        let k = stiffness_ratio(stiff, Some(soft));
        let b = approximate_half_length(0.1, k);
        assert!((b / (0.1 * STRIP_FOUR_TIMES_STIFFER) - 1.0).abs() < 4e-4);
    }
}
