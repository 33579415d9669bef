//! Punches other than circles on a homogeneous half-plane.
//!
//! With g = (κ+1)/(4μ), the slope f'(x) of a symmetric punch and a pressure that vanishes at both ends of |x| < a (see
//! [`hertz`](super::hertz)),
//!
//! ```text
//! P = 1/g ∫ x f'(x)/sqrt(a² - x²) dx,     p(0) = 1/(πg) ∫ a f'(x)/(x sqrt(a² - x²)) dx     over |x| < a.
//! ```
//!
//! **Power** f = c |x|^n (Steuermann 1939; Johnson 1985, section 5.3, for even n), with
//! w(ν) = ∫ cos^ν θ dθ from 0 to π/2:
//!
//! ```text
//! P = 2 n c a^n w(n)/g,     p(0) = 2 n c a^(n-1) w(n-2)/(πg).
//! ```
//!
//! **Wedge** f = s |x|, n = 1 (Johnson 1985, section 5.2):
//!
//! ```text
//! P = 2 s a/g,     p(x) = 2s/(πg) arcosh(a/|x|).
//! ```
//!
//! **Flat punch with rounded corners**, f' = (|x| - c)/R from |x| = c on (Schubert 1942; Ciavarella,
//! Hills and Monno 1998), with sin φ₀ = c/a and x = a sin φ:
//!
//! ```text
//! P = a² [(π - 2φ₀) - sin 2φ₀]/(2 R g)
//! p(x) = a/(πRg) {(π - 2φ₀) cos φ + sin φ ln|sin(φ + φ₀)/sin(φ - φ₀)| + sin φ₀ ln|tan((φ + φ₀)/2) tan((φ - φ₀)/2)|}.
//! ```
//!
//! **Flat punch with sharp corners** (Sadowsky 1928): p(x) = P/(π sqrt(a² - x²)).

use std::f64::consts::{FRAC_PI_2, PI};

use super::Elastic;

/// Force that presses a punch of height coefficient · |x|^exponent, exponent ≥ 1, to the half-length `half_length`.
pub fn power_force(material: Elastic, exponent: f64, coefficient: f64, half_length: f64) -> f64 {
    2.0 * exponent * coefficient * half_length.powf(exponent) * wallis(exponent) / material.flexibility()
}

/// Pressure at x = 0 under a punch of height coefficient · |x|^exponent; infinite for an exponent of 1.
pub fn power_central_pressure(material: Elastic, exponent: f64, coefficient: f64, half_length: f64) -> f64 {
    // w(n − 2) = w(n) n/(n − 1)
    let w = wallis(exponent) * exponent / (exponent - 1.0);
    2.0 * exponent * coefficient * half_length.powf(exponent - 1.0) * w / (PI * material.flexibility())
}

/// Half-length of the contact of a wedge with faces of this slope under a force.
pub fn wedge_half_length(material: Elastic, slope: f64, force: f64) -> f64 {
    0.5 * material.flexibility() * force / slope
}

/// Pressure at x under a wedge, infinite at x = 0.
pub fn wedge_pressure(material: Elastic, slope: f64, half_length: f64, x: f64) -> f64 {
    let ratio = half_length / x.abs();
    if ratio > 1.0 { 2.0 * slope / (PI * material.flexibility()) * ratio.acosh() } else { 0.0 }
}

/// Force that presses a flat punch of half-width `flat` with corners of radius `radius` to the half-length
/// `half_length` > `flat`.
pub fn rounded_flat_force(material: Elastic, flat: f64, radius: f64, half_length: f64) -> f64 {
    let rest = 2.0 * round_angle(flat, half_length);
    half_length.powi(2) * (rest - rest.sin()) / (2.0 * radius * material.flexibility())
}

/// The angle φ from the end of a contact to where corners begin, cos φ = `flat` / `half_length`, also where it is small.
fn round_angle(flat: f64, half_length: f64) -> f64 {
    2.0 * ((half_length - flat) / (2.0 * half_length)).sqrt().asin()
}

/// Pressure at |x| < `half_length` under a flat punch with rounded corners.
pub fn rounded_flat_pressure(material: Elastic, flat: f64, radius: f64, half_length: f64, x: f64) -> f64 {
    let (rest, phi) = (round_angle(flat, half_length), (x.abs() / half_length).asin());
    let corner = 0.5 * PI - rest;
    let scale = half_length / (PI * radius * material.flexibility());
    if flat == 0.0 {
        return scale * PI * phi.cos();
    }
    let first = ((phi + corner).sin() / (phi - corner).sin()).abs().ln();
    // ln |tan ½(φ + corner) tan ½(φ − corner)|, with no digits lost where it is small
    let (short, long) = (rest.sin().min(phi.cos()), rest.sin().max(phi.cos()));
    let second = -2.0 * (short / long).atanh();
    scale * (2.0 * rest * phi.cos() + phi.sin() * first + rest.cos() * second)
}

/// Pressure at |x| < `half_length` under a flat punch with sharp corners.
pub fn flat_pressure(force: f64, half_length: f64, x: f64) -> f64 {
    force / (PI * ((half_length - x) * (half_length + x)).sqrt())
}

/// ∫ cos^ν θ dθ from 0 to π/2 for ν ≥ 1: a recursion leads to large ν, where the integral has a series.
fn wallis(power: f64) -> f64 {
    let (mut nu, mut factor) = (power, 1.0);
    while nu < 40.0 {
        factor *= (nu + 2.0) / (nu + 1.0);
        nu += 2.0;
    }
    // Γ(z + 1/2)/Γ(z + 1) with z = ν/2, about z + 1/4
    let u = 1.0 / (2.0 * nu + 1.0).powi(2);
    let series = 1.0 - u * (0.25 - u * (21.0 / 32.0 - u * (671.0 / 128.0 - u * 180_323.0 / 2048.0)));
    factor * FRAC_PI_2.sqrt() * (2.0 / (2.0 * nu + 1.0)).sqrt() * series
}

mod tests {
    use super::super::hertz;
    use super::*;

    const MATERIAL: Elastic = Elastic { shear_modulus: 1.3, kappa: 1.9 };

    #[test]
    fn wallis_integrals_are_those_of_the_books() {
        for (power, exact) in [(1.0, 1.0), (2.0, PI / 4.0), (3.0, 2.0 / 3.0), (4.0, 3.0 * PI / 16.0)] {
            assert!((wallis(power) / exact - 1.0).abs() < 1e-14, "{power}: {}", wallis(power));
        }
        // w(ν) w(ν + 1) = π/(2ν + 2)
        assert!((wallis(2.7) * wallis(3.7) * 7.4 / PI - 1.0).abs() < 1e-14);
    }

    /// ∫ p dx over the contact, by the midpoint rule in the angle.
    fn resultant(half_length: f64, pressure: impl Fn(f64) -> f64) -> f64 {
        const PLACES: usize = 200_000;
        let step = FRAC_PI_2 / PLACES as f64;
        let at = |i: usize| (step * (i as f64 + 0.5)).sin_cos();
        (0..PLACES).map(at).map(|(sin, cos)| 2.0 * step * half_length * cos * pressure(half_length * sin)).sum()
    }

    #[test]
    fn pressures_carry_their_forces() {
        let wedge = resultant(0.7, |x| wedge_pressure(MATERIAL, 0.2, 0.7, x));
        assert!((wedge_half_length(MATERIAL, 0.2, wedge) / 0.7 - 1.0).abs() < 1e-5);
        assert!((power_force(MATERIAL, 1.0, 0.2, 0.7) / wedge - 1.0).abs() < 1e-5);
        for flat in [0.0, 0.1, 0.5, 0.69] {
            let force = resultant(0.7, |x| rounded_flat_pressure(MATERIAL, flat, 3.0, 0.7, x));
            assert!((rounded_flat_force(MATERIAL, flat, 3.0, 0.7) / force - 1.0).abs() < 1e-5, "{flat}");
        }
        assert!((resultant(0.7, |x| flat_pressure(2.0, 0.7, x)) / 2.0 - 1.0).abs() < 1e-5);
    }

    #[test]
    fn a_flat_punch_whose_corners_are_hardly_round_is_one_with_sharp_corners() {
        let (flat, half_length, x) = (1.0, 1.0 + 1e-7, 0.3);
        let force = rounded_flat_force(MATERIAL, flat, 1e-3, half_length);
        let round = rounded_flat_pressure(MATERIAL, flat, 1e-3, half_length, x);
        assert!((round / flat_pressure(force, 1.0, x) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn fourth_powers_have_a_polynomial_pressure() {
        // f' = 4c x³: p = 4c/g sqrt(a² − x²) (x² + a²/2)
        let (c, a) = (0.3, 0.7);
        let central = 4.0 * c / MATERIAL.flexibility() * a * 0.5 * a * a;
        assert!((power_central_pressure(MATERIAL, 4.0, c, a) / central - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_second_power_is_a_parabola() {
        let material = Elastic::plane_strain(1.0, 0.25);
        let force = power_force(material, 2.0, 0.5 / 500.0, 0.7);
        assert!((hertz::parabola(material, 500.0, force).half_length() - 0.7).abs() < 1e-14);
    }

    #[test]
    fn without_a_flat_part_the_pressure_is_an_ellipse() {
        let material = Elastic::plane_strain(1.0, 0.25);
        let parabola = hertz::parabola(material, 500.0, 0.002);
        let (a, x) = (parabola.half_length(), 0.3);
        assert!((rounded_flat_pressure(material, 0.0, 500.0, a, x) / parabola.pressure(x) - 1.0).abs() < 1e-14);
    }
}
