//! Tolerances are kept, error estimates are honest, and models forget nothing and remember nothing.
//!
//! Goal: whatever the tolerance, the estimated error is below it and the true error below ten times the
//! estimate; more digits take more modes.
//!
//! ```text
//!   modes   8 ────── 16 ────── 32 ────── 64      true error: against an answer to thirteen digits
//!   error  1e-3 ··· 1e-6 ··· 1e-9 ··· 1e-12
//! ```
use std::path::Path;

use recede::{Model, Options, Punch, Scene, Solution};

/// Scenes of one to three contacts, with and without graded layers.
const SCENES: [&str; 8] = [
    "table1_R10_load1000",
    "table1_R500_load500",
    "table2_beta-1_R250_load500",
    "table2_beta1_R500_load100",
    "full_beta-1_R500",
    "full_beta1_h2_0.5",
    "two_strips_loose",
    "coating_bonded",
];
/// An error below this is rounding.
const ROUNDING: f64 = 1e-13;

fn read(name: &str) -> Scene {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/scenes").join(format!("{name}.ron"));
    Scene::read(file).unwrap()
}

fn press(scene: &Scene, model: &Model, tolerance: f64) -> Solution {
    model.press_with(&scene.top, scene.force, &Options { tolerance }).unwrap()
}

#[test]
fn tolerances_are_kept_and_errors_are_not_larger_than_estimated() {
    let mut wrong = Vec::new();
    for name in SCENES {
        let scene = read(name);
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let exact = press(&scene, &model, 1e-13);
        let mut modes = 0;
        for exponent in 3..=12 {
            let tolerance = 10f64.powi(-exponent);
            let found = press(&scene, &model, tolerance);
            if found.modes() < modes {
                wrong.push(format!("{name}: {} modes for {tolerance:e}, fewer than for less", found.modes()));
            }
            modes = found.modes();
            for (found, exact) in found.contacts().iter().zip(exact.contacts()) {
                let quantities = [
                    (
                        "half-length",
                        found.half_length().unwrap(),
                        found.half_length_error().unwrap(),
                        exact.half_length().unwrap(),
                    ),
                    ("peak pressure", found.central_pressure, found.central_pressure_error, exact.central_pressure),
                ];
                for (quantity, found_value, estimate, exact) in quantities {
                    let true_error = (found_value - exact).abs();
                    let place = format!("{name}, {} at {}, tolerance {tolerance:e}", quantity, found.interface);
                    if estimate.is_nan() || estimate <= 0.0 || estimate > tolerance * exact {
                        wrong.push(format!("{place}: relative error estimated as {:.1e}", estimate / exact));
                    }
                    if true_error > 10.0 * estimate + ROUNDING * exact {
                        let [true_error, estimate] = [true_error, estimate].map(|error| error / exact);
                        wrong.push(format!("{place}: relative error {true_error:.1e}, estimated {estimate:.1e}"));
                    }
                }
            }
        }
        println!("{name}: {} modes for 1e-12", modes);
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn few_digits_take_few_modes() {
    let scene = read("full_beta-1_R500");
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let modes = [1e-3, 1e-6, 1e-12].map(|tolerance| press(&scene, &model, tolerance).modes());
    assert!(modes[0] < modes[2], "{modes:?}");
    assert!(modes[0] <= 16 && modes[2] <= 256, "{modes:?}");
}

#[test]
fn homogeneous_layers_need_few_modes() {
    for name in ["table1_R10_load1000", "table1_R500_load500", "two_strips_loose", "strip_on_rigid"] {
        let solution = recede::solve(&read(name)).unwrap();
        assert!(solution.modes() <= 32, "{name}: {} modes", solution.modes());
    }
}

#[test]
fn a_used_model_answers_like_a_fresh_one() {
    for name in SCENES {
        let scene = read(name);
        let fresh = || Model::new(scene.stack().unwrap()).unwrap();
        let used = fresh();
        for (radius, force) in [(10.0, 0.001), (1000.0, 0.01), (250.0, 0.0001)] {
            used.press(Punch::parabola(radius).unwrap(), force).unwrap();
        }
        assert_eq!(press(&scene, &used, 1e-10), press(&scene, &fresh(), 1e-10), "{name}");
        // asking for less in between changes nothing either
        press(&scene, &used, 1e-3);
        assert_eq!(press(&scene, &used, 1e-10), press(&scene, &used.clone(), 1e-10), "{name}");
    }
}
