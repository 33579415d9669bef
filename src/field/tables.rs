//! What waves are at the places of a row.
use crate::geometry::Geometry;
use crate::numeric::bessel;

/// sin λx, cos λx and cos λx − 1, without cancellation, wavenumber by wavenumber; in an axisymmetric problem Bessel functions in their place.
pub(super) fn tables(geometry: Geometry, places: &[f64], wavenumbers: &[f64]) -> [Vec<f64>; 3] {
    if geometry.is_axisymmetric() {
        return round(places, wavenumbers);
    }
    let size = places.len() * wavenumbers.len();
    let mut tables = [vec![0.0; size], vec![0.0; size], vec![0.0; size]];
    for (q, wavenumber) in wavenumbers.iter().enumerate() {
        for (k, x) in places.iter().enumerate() {
            let (sin, cos) = (0.5 * wavenumber * x).sin_cos();
            let at = q * places.len() + k;
            tables[0][at] = 2.0 * sin * cos;
            tables[2][at] = -2.0 * sin * sin;
            tables[1][at] = 1.0 + tables[2][at];
        }
    }
    tables
}

/// J₁(λr), J₀(λr) and J₀(λr) − 1 in place of the sine, the cosine and the cosine minus 1.
fn round(places: &[f64], wavenumbers: &[f64]) -> [Vec<f64>; 3] {
    let product = |wavenumber: &f64| places.iter().map(move |x| wavenumber * x).collect::<Vec<_>>();
    let arguments: Vec<f64> = wavenumbers.iter().flat_map(product).collect();
    let count = arguments.len();
    let mut bessel = vec![0.0; 2 * count];
    bessel::table(2, &arguments, &mut bessel);
    let first = bessel.split_off(count);
    // J₀ − 1 = −z²/4 + z⁴/64 − ... cancels where z is small
    let minus_one = |(z, zeroth): (&f64, &f64)| {
        let q = 0.25 * z * z;
        if *z > 0.5 {
            zeroth - 1.0
        } else {
            -q * (1.0 - q / 4.0 * (1.0 - q / 9.0 * (1.0 - q / 16.0 * (1.0 - q / 25.0))))
        }
    };
    let minus_one = arguments.iter().zip(&bessel).map(minus_one).collect();
    [first, bessel, minus_one]
}
