//! What waves are at the places of a row.
use num_complex::Complex64;

use super::waves::Panel;
use crate::geometry::Geometry;
use crate::numeric::bessel::{self, Kind};

/// sin λx, cos λx and cos λx − 1, without cancellation, wavenumber by wavenumber; in an axisymmetric problem Bessel functions in their place.
/// Where they oscillate between the wavenumbers of the panel, the factors of [`Panel::wave`] in place of e^(iλx).
pub(super) fn tables(geometry: Geometry, places: &[f64], panel: &Panel, wavenumbers: &[f64]) -> [Vec<f64>; 3] {
    let is_round = geometry.is_axisymmetric();
    let mut tables = if is_round { round(places, wavenumbers) } else { plane(places, wavenumbers) };
    for (k, x) in places.iter().enumerate() {
        let Some(waves) = panel.wave(*x) else { continue };
        for (q, (wave, wavenumber)) in waves.into_iter().zip(wavenumbers).enumerate() {
            let [zeroth, first] = if is_round { round_waves(wave, wavenumber * x) } else { [wave.re, wave.im] };
            let at = q * places.len() + k;
            [tables[0][at], tables[1][at], tables[2][at]] = [first, zeroth, zeroth - 1.0];
        }
    }
    tables
}

/// J₀(z) and J₁(z) with this in place of e^(iz): what they are multiplied with varies slowly.
fn round_waves(wave: Complex64, z: f64) -> [f64; 2] {
    let mut amplitudes = [Complex64::ZERO; 2];
    bessel::hankel_table(Kind::Integer, 2, &[z.into()], &mut amplitudes);
    amplitudes.map(|amplitude| (amplitude * wave).re)
}

fn plane(places: &[f64], wavenumbers: &[f64]) -> [Vec<f64>; 3] {
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
