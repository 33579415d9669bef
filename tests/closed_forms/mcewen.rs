//! Stresses in a half-plane under the pressure of Hertz's contact.
//!
//! Source: McEwen 1949; here as in Johnson 1985, section 4.2.

/// σ_xx, σ_yy and σ_xy (tension positive, y upwards) at x and a depth z below the face of a homogeneous half-plane
/// under the pressure p₀ √(1 − (x/a)²) on |x| < a.
pub fn stresses(half_length: f64, peak_pressure: f64, x: f64, depth: f64) -> [f64; 3] {
    let (x, z) = (x / half_length, depth / half_length);
    let difference = 1.0 - x * x + z * z;
    let root = difference.hypot(2.0 * x * z);
    // m² and n², the smaller one from their product x² z²
    let larger = 0.5 * (root + difference.abs());
    let smaller = if larger > 0.0 { (x * z) * (x * z) / larger } else { 0.0 };
    let (m, n) = if difference >= 0.0 { (larger, smaller) } else { (smaller, larger) };
    let sum = m + n;
    // at the ends of the contact, m = n = z = 0
    let share = if sum > 0.0 { (z * z + n) / sum } else { 0.0 };
    let shear = if sum > 0.0 { n.sqrt() * (m - z * z) / sum } else { 0.0 };
    let m = m.sqrt();
    [-(m * (1.0 + share) - 2.0 * z), -(m * (1.0 - share)), shear * x.signum()].map(|stress| peak_pressure * stress)
}

#[test]
fn the_largest_shear_stress_is_below_the_face() {
    let [along, across, shear] = stresses(0.7, 2.0, 0.0, 0.0);
    assert_eq!([along, across, shear], [-2.0, -2.0, 0.0]);
    // the largest shear stress, 0.300 p₀, is 0.786 a below the face
    let [along, across, _] = stresses(1.0, 1.0, 0.0, 0.786);
    assert!((0.5 * (along - across) - 0.3003).abs() < 1e-4);
}
