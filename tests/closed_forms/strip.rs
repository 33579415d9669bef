//! A free homogeneous strip, shear-free on both faces, under loads that vary like cos(λx).
//!
//! Loads on the two faces are either equal (both press: the strip is compressed, the faces move towards each other) or
//! opposite (one presses, the other is in tension: the strip is bent, the faces move together). With z = λh,
//!
//! ```text
//! equal:     λC = (κ+1)/(4μ) (cosh z - 1)/(sinh z + z)    -> (κ+1)/(4μ) z/4,    compression, for z -> 0
//! opposite:  λC = (κ+1)/(4μ) (cosh z + 1)/(sinh z - z)    -> (κ+1)/(4μ) 12/z³,  Euler-Bernoulli bending, for z -> 0
//! ```
//!
//! and both tend to the half-plane's (κ+1)/(4μ) for z -> ∞. C is the deflection of a face, positive in the direction in
//! which its own load pushes the strip's material, per unit of load.
//!
//! Source: Filon 1903; Timoshenko and Goodier 1951, article on Fourier series solutions of the strip.

use super::Elastic;

/// λC of a strip loaded equally on both faces, for the wavenumber λ > 0; an inverse stress.
pub fn equal_loads(material: Elastic, thickness: f64, wavenumber: f64) -> f64 {
    material.flexibility() * equal_ratio(wavenumber * thickness)
}

/// λC of a strip under opposite loads on its faces, for the wavenumber λ > 0; an inverse stress.
pub fn opposite_loads(material: Elastic, thickness: f64, wavenumber: f64) -> f64 {
    material.flexibility() * opposite_ratio(wavenumber * thickness)
}

/// λC of the loaded face of a strip that is loaded on one face only: the mean of the two cases.
pub fn own_face(material: Elastic, thickness: f64, wavenumber: f64) -> f64 {
    let z = wavenumber * thickness;
    0.5 * material.flexibility() * (equal_ratio(z) + opposite_ratio(z))
}

/// λ times the deflection of the free face of a strip, along the load, where only the other face is loaded: half the
/// difference of the two cases, (sinh z + z cosh z)/(sinh² z - z²), which decays like 2 (1 + z) exp(-z).
pub fn other_face(material: Elastic, thickness: f64, wavenumber: f64) -> f64 {
    material.flexibility() * coupling_ratio(wavenumber * thickness)
}

/// From here on all ratios have reached their limits; keeps 0 · ∞ out.
const SATURATED: f64 = 800.0;

/// (cosh z - 1)/(sinh z + z), in decaying exponentials.
fn equal_ratio(z: f64) -> f64 {
    let z = z.min(SATURATED);
    (-z).exp_m1().powi(2) / (2.0 * z * (-z).exp() - (-2.0 * z).exp_m1())
}

/// (cosh z + 1)/(sinh z - z)
fn opposite_ratio(z: f64) -> f64 {
    let z = z.min(SATURATED);
    (1.0 + (-z).exp()).powi(2) / decaying_denominator(z)
}

/// (sinh z + z cosh z)/(sinh² z - z²)
fn coupling_ratio(z: f64) -> f64 {
    let z = z.min(SATURATED);
    let e = (-z).exp();
    let numerator = z * (1.0 + e * e) - (-2.0 * z).exp_m1();
    2.0 * e * numerator / (decaying_denominator(z) * (2.0 * z * e - (-2.0 * z).exp_m1()))
}

/// 2 exp(-z) (sinh z - z)
fn decaying_denominator(z: f64) -> f64 {
    if z > 2.0 {
        return 1.0 - (-2.0 * z).exp() - 2.0 * z * (-z).exp();
    }
    // sinh z - z = z³/6 (1 + z²/(4·5) (1 + z²/(6·7) (...)))
    let series = (2..=13).rev().fold(1.0, |s, k| 1.0 + s * z * z / f64::from(2 * k * (2 * k + 1)));
    (-z).exp() * z.powi(3) / 3.0 * series
}

mod tests {
    use super::*;

    /// z, equal, opposite and coupling ratio, from a multiple-precision evaluation.
    #[rustfmt::skip]
    const RATIOS: [(f64, f64, f64, f64); 7] = [
        (1e-6, 2.5e-7, 1.200_000_000_000_240_2e19, 6.000_000_000_001_201e18),
        (1e-3, 0.000_249_999_999_999_999_7, 12_000_002_400.000_114, 6_000_001_199.999_932),
        (0.5, 0.124_989_278_199_323_08, 100.857_793_495_192_95, 50.366_402_108_496_814),
        (1.999_023_437_5, 0.490_670_904_437_417_2, 2.929_909_563_566_597_3, 1.219_619_329_564_59),
        (2.000_976_562_5, 0.491_118_368_933_296_86, 2.924_556_645_434_898, 1.216_719_138_250_800_5),
        (7.5, 0.990_675_532_914_823_2, 1.009_481_711_796_586, 0.009_403_089_440_881_317),
        (40.0, 0.999_999_999_999_999_7, 1.000_000_000_000_000_4, 3.483_650_489_339_103e-16),
    ];

    #[test]
    fn ratios_are_accurate_for_long_and_short_waves() {
        for (z, equal, opposite, coupling) in RATIOS {
            for (value, known) in
                [(equal_ratio(z), equal), (opposite_ratio(z), opposite), (coupling_ratio(z), coupling)]
            {
                assert!((value / known - 1.0).abs() < 2e-15, "at {z}: {value:e}, not {known:e}");
            }
        }
    }

    #[test]
    fn ratios_neither_overflow_nor_lose_their_limits() {
        for z in [800.0, 1e8, f64::MAX] {
            assert_eq!((equal_ratio(z), opposite_ratio(z), coupling_ratio(z)), (1.0, 1.0, 0.0));
        }
        let z = 1e-90;
        assert!((equal_ratio(z) / z * 4.0 - 1.0).abs() < 1e-15);
        assert!((opposite_ratio(z) * z * z * z / 12.0 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn one_loaded_face_is_the_mean_of_both_cases() {
        let material = Elastic::plane_stress(3.0, 0.2);
        let (equal, opposite) = (equal_loads(material, 2.0, 0.7), opposite_loads(material, 2.0, 0.7));
        assert!((own_face(material, 2.0, 0.7) / (0.5 * (equal + opposite)) - 1.0).abs() < 1e-15);
        assert!((other_face(material, 2.0, 0.7) / (0.5 * (opposite - equal)) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn a_long_wave_only_compresses() {
        let material = Elastic::plane_strain(2.0, 0.25);
        // A long wave only compresses: half the thickness times the load over E*.
        let (wavenumber, thickness) = (1e-5, 3.0);
        let compression = 0.5 * thickness / material.plane_modulus();
        assert!((equal_loads(material, thickness, wavenumber) / wavenumber / compression - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_short_wave_does_not_reach_the_other_face() {
        let material = Elastic::plane_strain(2.0, 0.25);
        // A short wave does not reach the other face.
        assert_eq!(opposite_loads(material, 1.0, 100.0), material.flexibility());
    }
}
