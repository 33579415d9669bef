//! Nothing jumps where formulae do: β → 0, ν → 1/2, and the wavenumbers at which one formula takes over from another.
use recede_layers::{Exponential, Flexibility, Homogeneous, Layer, Plane, Wave};

const WAVENUMBERS: [f64; 11] = [1e-8, 1e-4, 1e-2, 0.3, 0.9, 1.1, 1.9, 2.1, 7.0, 30.0, 1e6];

fn at(layer: &dyn Layer, wavenumber: f64) -> [f64; 3] {
    let wave = Wave { wavenumber, modulus: 1.0, plane: Plane::Strain };
    let Flexibility { top, coupling, bottom, .. } = layer.flexibility(&wave).expect("finite");
    [top, coupling, bottom]
}

/// The largest difference, relative to the faces' own flexibility.
fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    let mean = (a[0] * a[2]).abs().sqrt();
    (0..3).map(|k| (a[k] - b[k]).abs() / a[k].abs().max(1e-6 * mean)).fold(0.0, f64::max)
}

#[test]
fn a_vanishing_grading_is_none() {
    for poisson in [-0.5, 0.0, 0.25, 0.5] {
        let plain = Homogeneous::new(1.0, 1.0, poisson).expect("legal");
        for beta in [0.0, 1e-300, 1e-16, 1e-12, 1e-9, 1e-6, 1e-3] {
            for beta in [beta, -beta] {
                let graded = Exponential::new(1.0, 1.0, poisson, beta).expect("legal");
                for wavenumber in WAVENUMBERS {
                    let difference = difference(at(&plain, wavenumber), at(&graded, wavenumber));
                    // μ^(-1) varies by |β| h, and the flexibility with its moments up to the third
                    assert!(difference <= 4.0 * beta.abs() + 1e-13, "ν = {poisson}, β = {beta}: {difference:e}");
                }
            }
        }
    }
}

#[test]
fn a_nearly_incompressible_layer_is_nearly_the_incompressible_one() {
    for beta in [0.0, 1e-6, 1.0, -8.0] {
        let incompressible = Exponential::new(1.0, 1.0, 0.5, beta).expect("legal");
        for distance in [1e-15, 1e-12, 1e-9, 1e-6] {
            let nearly = Exponential::new(1.0, 1.0, 0.5 - distance, beta).expect("legal");
            for wavenumber in WAVENUMBERS {
                let difference = difference(at(&incompressible, wavenumber), at(&nearly, wavenumber));
                // a long layer resists compression like h⁻³ if it cannot escape sideways, hence the factor
                assert!(difference <= 1e3 * distance + 1e-12, "½ − ν = {distance}, β = {beta}: {difference:e}");
            }
        }
    }
}

#[test]
fn formulae_meet() {
    for steepness in [-30.0f64, -8.0, -1.0, -0.5, 0.0, 1e-9, 0.5, 1.0, 4.0, 30.0] {
        for (wavenumber, beta) in [(1.0, steepness), (2.0, steepness), (0.5, steepness.signum())] {
            let [before, after] = [1.0 - 1e-13, 1.0 + 1e-13].map(|factor| {
                let layer = Exponential::new(1.0, 1.0, 0.25, beta * factor).expect("legal");
                at(&layer, wavenumber * factor)
            });
            let difference = difference(before, after);
            assert!(difference < 1e-11, "β = {beta}, λ = {wavenumber}: {before:?} {after:?}");
        }
        let [before, after] = [1.0 - 1e-13, 1.0 + 1e-13]
            .map(|factor| at(&Homogeneous::new(1.0, 1.0, 0.25).expect("legal"), 2.0 * factor));
        assert!(difference(before, after) < 1e-11, "{before:?} {after:?}");
    }
}
