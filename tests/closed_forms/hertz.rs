//! A smooth rigid punch on a homogeneous half-plane.
//!
//! With the slope f'(x) of the punch and g = (κ+1)/(4μ), a pressure p on |x| < a obeys
//!
//! ```text
//! g/π ∫ p(t)/(x - t) dt = f'(x),   |x| < a.
//! ```
//!
//! Its solution that vanishes at both ends, and the force P that it carries (Johnson 1985, section 2.7), are
//!
//! ```text
//! p(x) = sqrt(a² - x²)/(π g) ∫ f'(t)/(sqrt(a² - t²) (t - x)) dt,     P = 1/g ∫ x f'(x)/sqrt(a² - x²) dx.
//! ```
//!
//! **Parabola**, f' = x/R (Hertz 1881; Johnson 1985, section 4.2(c)):
//!
//! ```text
//! a² = P R (κ+1)/(2πμ) = 4 P R/(π E*),     p(x) = p₀ sqrt(1 - x²/a²),     p₀ = 2P/(πa) = a/(gR).
//! ```
//!
//! **Cylinder**, f' = x/sqrt(R² - x²), with the complete elliptic integrals K and E of the modulus k = a/R, and
//! A(t) = sqrt(R² - t²), B = sqrt(R² - x²) (the singular part of the integral is zero by itself and has been taken
//! out):
//!
//! ```text
//! P = 2R/g (K - E),     p(0) = 2k K/(πg),
//! p(x) = 2 sqrt(a² - x²)/(πg) (K/R + x²/B ∫ dt/(sqrt(a² - t²) A (A + B))),   0 < t < a.
//! ```
//!
//! For a much smaller than R this is the parabola. No force is too large for a cylinder on a half-plane, but a
//! approaches R exponentially, so that from about 18 · 2R/g on it is R to rounding.

use super::Elastic;
use std::f64::consts::{FRAC_PI_2, LN_2, PI};

/// A punch in contact with a half-plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    profile: Profile,
    material: Elastic,
    radius: f64,
    half_length: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Profile {
    Parabola,
    /// The circle, with K and the complementary modulus sqrt(1 - a²/R²).
    Cylinder {
        first_kind: f64,
        complement: f64,
    },
}

/// The parabola y = x²/(2R), pressed on the half-plane by a force.
pub fn parabola(material: Elastic, radius: f64, force: f64) -> Contact {
    let half_length = (2.0 * material.flexibility() * radius * force / PI).sqrt();
    Contact { profile: Profile::Parabola, material, radius, half_length }
}

/// The circular cylinder of the given radius, pressed on the half-plane by a force.
///
/// `None` if an argument is not positive, or if the contact reaches the horizontal diameter to rounding.
pub fn cylinder(material: Elastic, radius: f64, force: f64) -> Option<Contact> {
    // K - E = q, solved for w in k = tanh w, where d(K - E)/dw = k E: between (π/4) w² and w + ln 2 - 1.
    let q = 0.5 * material.flexibility() * force / radius;
    if !(q > 0.0 && q < 18.0 && radius > 0.0) {
        return None;
    }
    let mut w = (4.0 * q / PI).sqrt().min(q + 1.0 - LN_2).max(0.5 * q);
    for _ in 0..20 {
        let elliptic = Elliptic::new(w.tanh(), 1.0 / w.cosh());
        let step = (elliptic.difference - q) / (w.tanh() * elliptic.second());
        w -= step.clamp(-1.0, 0.5 * w);
        if step.abs() < 1e-10 * w {
            break;
        }
    }
    let (modulus, complement) = (w.tanh(), 1.0 / w.cosh());
    let first_kind = Elliptic::new(modulus, complement).first;
    let half_length = radius * modulus;
    Some(Contact { profile: Profile::Cylinder { first_kind, complement }, material, radius, half_length })
}

/// The force that presses a circular cylinder down to a given half-length of contact; `None` unless 0 < a < R.
pub fn cylinder_force(material: Elastic, radius: f64, half_length: f64) -> Option<f64> {
    let k = half_length / radius;
    (k > 0.0 && k < 1.0)
        .then(|| 2.0 * radius / material.flexibility() * Elliptic::new(k, ((1.0 - k) * (1.0 + k)).sqrt()).difference)
}

impl Contact {
    /// a: the contact is |x| < a.
    pub fn half_length(&self) -> f64 {
        self.half_length
    }

    /// The pressure in the middle, p(0), the largest one of a parabola.
    pub fn central_pressure(&self) -> f64 {
        self.pressure(0.0)
    }

    /// The resultant of the pressure.
    pub fn force(&self) -> f64 {
        let a = self.half_length;
        match self.profile {
            Profile::Parabola => FRAC_PI_2 * a * a / (self.material.flexibility() * self.radius),
            Profile::Cylinder { complement, .. } => {
                2.0 * self.radius / self.material.flexibility() * Elliptic::new(a / self.radius, complement).difference
            }
        }
    }

    /// The pressure at `x`; zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        let (a, radius, g) = (self.half_length, self.radius, self.material.flexibility());
        if x.abs() >= a {
            return 0.0;
        }
        let arch = ((a - x) * (a + x)).sqrt();
        match self.profile {
            Profile::Parabola => arch / (g * radius),
            Profile::Cylinder { first_kind, complement } => {
                let s = x / radius;
                let rest = steepening(s, complement);
                2.0 * arch / (PI * g * radius) * (first_kind + rest)
            }
        }
    }
}

/// s²/B ∫ dt/(sqrt(k² - t²) A (A + B)), 0 < t < k, in units of the radius.
///
/// With t = k cos φ and tan φ = k' sinh u, k' = sqrt(1 - k²), the measure dt/(sqrt(k² - t²) A) becomes du/sqrt(1 +
/// k'² sinh² u), and A = k' cosh u/sqrt(1 + k'² sinh² u): analytic for |Im u| < π/2, whatever k is, so that the
/// trapezoidal rule with the step 1/4 is right to rounding.
fn steepening(s: f64, complement: f64) -> f64 {
    const STEP: f64 = 0.25;
    let b = ((1.0 - s) * (1.0 + s)).sqrt();
    if s == 0.0 {
        return 0.0;
    }
    let term = |u: f64| {
        let root = (complement * u.sinh()).hypot(1.0);
        1.0 / (root * (complement * u.cosh() / root + b))
    };
    let mut sum = 0.5 * term(0.0);
    for n in 1.. {
        let next = term(STEP * f64::from(n));
        sum += next;
        if next < 1e-18 * sum {
            break;
        }
    }
    s * s / b * STEP * sum
}

/// Complete elliptic integrals by the arithmetic-geometric mean (Abramowitz and Stegun, 17.6).
struct Elliptic {
    /// K
    first: f64,
    /// K - E, without cancellation
    difference: f64,
}

impl Elliptic {
    fn new(modulus: f64, complement: f64) -> Self {
        let (mut a, mut b, mut c) = (1.0, complement, modulus);
        let (mut weight, mut sum) = (0.5, 0.0);
        // c² halves its exponent in each step: ten steps are ample for any modulus below one.
        for _ in 0..12 {
            sum += weight * c * c;
            if c.abs() < 1e-17 * a {
                break;
            }
            let geometric = (a * b).sqrt();
            c = c * c / (2.0 * (a + b));
            a = 0.5 * (a + b);
            b = geometric;
            weight *= 2.0;
        }
        let first = FRAC_PI_2 / a;
        Self { first, difference: first * sum }
    }

    fn second(&self) -> f64 {
        self.first - self.difference
    }
}

mod tests {
    use super::*;

    const MATERIAL: Elastic = Elastic { shear_modulus: 0.7, kappa: 1.8 };

    fn close(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance * b.abs(), "{a:e} is not {b:e}: off by {:e} of it", a / b - 1.0);
    }

    #[test]
    fn parabola_carries_its_force() {
        let contact = parabola(MATERIAL, 12.0, 0.3);
        close(contact.force(), 0.3, 1e-15);
        close(contact.central_pressure(), 2.0 * 0.3 / (PI * contact.half_length()), 1e-15);
        close(contact.half_length().powi(2), 4.0 * 0.3 * 12.0 / (PI * MATERIAL.plane_modulus()), 1e-15);
    }

    /// k = a/R, K - E, and g p at x = 0, a/2, 15a/16, from a multiple-precision quadrature of the formulae above.
    #[rustfmt::skip]
    const CYLINDER: [(f64, f64, [f64; 3]); 4] = [
        (9.765_625e-4, 7.490_143_244_532_461e-7,
         [9.765_627_328_307_686e-4, 8.457_282_358_392_814e-4, 3.398_295_912_911_737e-4]),
        (0.5, 0.218_288_145_473_168_88, [0.536_591_003_574_682_1, 0.480_498_349_981_229_1, 0.212_332_195_094_197_04]),
        (0.96875, 1.737_343_306_721_916_6, [1.732_223_678_257_895, 1.789_883_967_348_624_6, 1.905_771_123_798_567_6]),
        (0.999_999_046_325_683_6, 6.971_189_013_897_673,
         [5.074_616_231_961_349, 5.657_761_706_078_643, 11.637_953_174_673_425]),
    ];

    #[test]
    fn cylinder_takes_its_known_values() {
        let (radius, g) = (3.0, MATERIAL.flexibility());
        for (k, difference, pressures) in CYLINDER {
            let force = cylinder_force(MATERIAL, radius, k * radius).unwrap();
            close(force, 2.0 * radius / g * difference, 1e-14);
            let contact = cylinder(MATERIAL, radius, force).unwrap();
            close(contact.half_length(), k * radius, 1e-14);
            close(contact.force(), force, 1e-14);
            for (s, pressure) in [0.0, 0.5, 0.9375].into_iter().zip(pressures) {
                // The pressure beside a contact that fills the circle depends on the difference of a and R.
                let tolerance = if k > 0.99 { 1e-9 } else { 1e-14 };
                close(g * contact.pressure(s * contact.half_length()), pressure, tolerance);
            }
        }
    }

    /// With p = sqrt(1 - s²) Σ c_j U_{j-1}(s) the slope is g Σ c_j T_j(s), and the force π a c_1/2: another way to
    /// the same.
    #[test]
    fn cylinder_pressure_gives_back_circle_and_force() {
        let contact = cylinder(MATERIAL, 2.0, 3.0).unwrap();
        let (a, g, n) = (contact.half_length(), MATERIAL.flexibility(), 400);
        assert!(a > 1.5);
        let angle = |i: usize| PI * i as f64 / n as f64;
        let pressures: Vec<f64> = (1..n).map(|i| contact.pressure(a * angle(i).cos())).collect();
        let c = |j: usize| 2.0 / n as f64 * (1..n).map(|i| pressures[i - 1] * (j as f64 * angle(i)).sin()).sum::<f64>();
        let coefficients: Vec<f64> = (0..120).map(c).collect();
        close(FRAC_PI_2 * a * coefficients[1], 3.0, 1e-13);
        for s in [0.1f64, 0.5, 0.8, 0.99, 1.0] {
            let slope: f64 = (1..120).map(|j| g * coefficients[j] * (j as f64 * s.acos()).cos()).sum();
            close(slope, a * s / (4.0 - (a * s).powi(2)).sqrt(), 1e-12);
        }
    }

    #[test]
    fn small_cylinder_contact_is_hertzian() {
        for force in [1e-300, 1e-12, 1e-6] {
            let (circle, parabola) = (cylinder(MATERIAL, 1.0, force).unwrap(), parabola(MATERIAL, 1.0, force));
            close(circle.half_length(), parabola.half_length(), force + 1e-15);
            close(
                circle.pressure(0.3 * circle.half_length()),
                parabola.pressure(0.3 * parabola.half_length()),
                force + 1e-15,
            );
        }
    }

    #[test]
    fn every_force_has_its_contact() {
        let mut last = 0.0;
        for exponent in -60..=100 {
            let force = 10f64.powf(0.1 * f64::from(exponent));
            let Some(contact) = cylinder(MATERIAL, 5.0, force) else {
                assert!(force > 100.0);
                continue;
            };
            assert!(contact.half_length() > last && contact.half_length() < 5.0);
            last = contact.half_length();
            close(contact.force(), force, 1e-14);
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(cylinder(MATERIAL, 1.0, bad).is_none() && cylinder(MATERIAL, bad, 1.0).is_none());
            assert!(cylinder_force(MATERIAL, 1.0, bad).is_none());
        }
    }

    #[test]
    fn a_parabola_has_the_half_length_of_hertz() {
        let material = Elastic { shear_modulus: 1.0, kappa: 2.0 };
        let contact = parabola(material, 500.0, 0.002);
        assert!((contact.half_length() - (0.002 * 500.0 * 3.0 / (2.0 * std::f64::consts::PI)).sqrt()).abs() < 1e-15);
        assert!((contact.force() - 0.002).abs() < 1e-17);
    }

    #[test]
    fn a_circle_makes_a_smaller_contact_than_its_parabola() {
        let material = Elastic::plane_strain(1.0, 0.25);
        let contact = cylinder(material, 10.0, 2.0).unwrap();
        // A circle is steeper than its parabola: the contact is smaller.
        assert!(contact.half_length() < parabola(material, 10.0, 2.0).half_length());
        assert!((contact.force() - 2.0).abs() < 1e-14);
        assert!(cylinder(material, 10.0, 1e6).is_none());
    }

    #[test]
    fn force_and_half_length_of_a_cylinder_are_inverses() {
        let material = Elastic::plane_strain(1.0, 0.25);
        let force = cylinder_force(material, 10.0, 6.0).unwrap();
        assert!((cylinder(material, 10.0, force).unwrap().half_length() - 6.0).abs() < 1e-13);
    }

    #[test]
    fn the_pressure_under_a_parabola_is_an_ellipse() {
        let material = Elastic::plane_strain(1.0, 0.25);
        let contact = parabola(material, 100.0, 0.01);
        let half = contact.pressure(0.6 * contact.half_length()) / contact.central_pressure();
        assert!((half - 0.8).abs() < 1e-15);
        assert_eq!(contact.pressure(contact.half_length()), 0.0);
    }
}
