//! A model for many loads: started from answers that it keeps, rather than from formulas.
//!
//! Goal: the same answers as without, in fewer steps; and where nothing kept is of use, the very same.
//!
//! ```text
//!   ln a ┤              ,o      o  kept, at fixed ln RP
//!        │          ,x''        x  between them: where a press starts
//!        │     ,o'''
//!        └──────┴────┴───┴──    ln RP
//! ```
use std::fs;

use recede::{Model, Punch, Scene, Solution};

const PARTS: [f64; 4] = [1.0, 0.04, 0.3, 5.0];
/// Half-lengths differ by at most this many error estimates, relative, or by rounding.
const CLAIMED: f64 = 2.0;
const ROUNDING: f64 = 1e-13;
const TOLERANCE: f64 = 1e-10;
/// Claims below this, relative, are mostly about what the iteration left.
const FEW: f64 = 1e-11;

fn scenes() -> Vec<Scene> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/scenes");
    fs::read_dir(folder).unwrap().map(|file| Scene::read(file.unwrap().path()).unwrap()).collect()
}

fn factorisations(solution: &Solution) -> usize {
    solution.stats().factorisations
}

#[test]
fn answers_are_those_of_any_model_in_fewer_steps() {
    let (mut few, mut many) = (0, 0);
    for scene in scenes() {
        let name = scene.name.clone().unwrap_or_default();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let for_many = model.clone().for_many_loads();
        for part in PARTS {
            let force = part * scene.force.given().unwrap();
            let [expected, found] = [&model, &for_many].map(|model| model.press(&scene.top, force).unwrap());
            many += factorisations(&expected);
            few += factorisations(&found);
            assert_eq!(found.warnings(), expected.warnings(), "{name}, {force}");
            for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
                let claimed = [
                    (
                        found.half_length().unwrap(),
                        found.half_length_error().unwrap(),
                        expected.half_length().unwrap(),
                        expected.half_length_error().unwrap(),
                    ),
                    (
                        found.central_pressure,
                        found.central_pressure_error,
                        expected.central_pressure,
                        expected.central_pressure_error,
                    ),
                ];
                for (found, error, expected, before) in claimed {
                    let allowed = CLAIMED * error.max(before) + ROUNDING * expected;
                    assert!((found - expected).abs() <= allowed, "{name}, {force}: {found} {expected} {allowed:e}");
                    // modes may be fewer, within the tolerance; and what the iteration leaves is less, by a little
                    let (least, most) = (0.3 * before - FEW * expected, (3.0 * before).max(TOLERANCE * expected));
                    assert!(least <= error && error <= most, "{name}, {force}: {error:e} {before:e}");
                }
            }
        }
    }
    println!("{few} factorisations in place of {many}");
    assert!(2 * few < many);
}

#[test]
fn punches_like_no_parabola_are_pressed_as_ever() {
    let scene = scenes().into_iter().find(|scene| scene.name.as_deref() == Some("table1_R500_load1000")).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let for_many = model.clone().for_many_loads();
    for (punch, force) in [
        (Punch::wedge(0.01).unwrap(), 0.01),
        (Punch::flat(0.7).unwrap(), 0.01),
        // half of it within the contact
        (Punch::cylinder(2.0).unwrap(), 0.6),
        // farther away than anything is kept
        (Punch::parabola(1e-30).unwrap(), 1e-3),
    ] {
        let [expected, found] = [&model, &for_many].map(|model| format!("{:?}", model.press(&punch, force)));
        assert_eq!(found, expected, "{punch}");
    }
}
