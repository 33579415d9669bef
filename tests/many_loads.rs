//! A model for many loads: solutions at fixed forces are kept, and the others interpolated between these.
//!
//! Goal: the same answers as without, within both error estimates, and without solving any equations once enough forces are known.
//!
//! ```text
//!   ln a ┤              ,o      o  kept, at fixed ln P
//!        │          ,x''        x  between them: told by a polynomial
//!        │     ,o'''
//!        └──────┴────┴───┴──    ln P
//! ```
use std::fs;

use recede::{Contact, Model, Punch, Scene, Solution};

const PARTS: [f64; 4] = [1.0, 0.04, 0.3, 5.0];
/// Relative rounding.
const ROUNDING: f64 = 1e-13;
const TOLERANCE: f64 = 1e-10;

fn scenes() -> Vec<Scene> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/scenes");
    fs::read_dir(folder).unwrap().map(|file| Scene::read(file.unwrap().path()).unwrap()).collect()
}

/// Half-length and central pressure of a contact, with their errors.
fn known(contact: &Contact) -> [[f64; 2]; 2] {
    let length = [contact.half_length().unwrap(), contact.half_length_error().unwrap()];
    [length, [contact.central_pressure, contact.central_pressure_error]]
}

/// Fails unless an interpolated solution is as told, within both error estimates, to the tolerance, and in balance.
fn assert_same(found: &Solution, expected: &Solution, what: &str) {
    assert_eq!(found.warnings(), expected.warnings(), "{what}");
    for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
        for ([found, error], [expected, before]) in known(found).into_iter().zip(known(expected)) {
            let allowed = error + before + ROUNDING * expected;
            let is_same = found == expected || (found - expected).abs() <= allowed;
            assert!(is_same, "{what}: {found} {expected} {allowed:e}");
            assert!(found.is_infinite() || error <= TOLERANCE * expected, "{what}: {error:e}");
        }
        assert!((found.resultant / expected.resultant - 1.0).abs() < TOLERANCE, "{what}: {}", found.resultant);
        for part in [0.2, 0.7] {
            let x = part * expected.reach();
            let [found, own] = [found, expected].map(|contact| contact.pressure(x));
            let mean = expected.resultant / expected.reach();
            // next to graded faces the series of both know no more away from the middle
            assert!((found - own).abs() < 1e-7 * mean, "{what} at {part}: {found} {own}");
        }
    }
}

#[test]
fn answers_are_those_of_any_model_without_equations() {
    let (mut interpolated, mut all) = (0, 0);
    for scene in scenes() {
        let name = scene.name.clone().unwrap_or_default();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let for_many = model.clone().for_many_loads();
        for part in PARTS {
            let force = part * scene.force.given().unwrap();
            let [expected, found] = [&model, &for_many].map(|model| model.press(&scene.top, force).unwrap());
            interpolated += usize::from(found.stats().factorisations == 0);
            all += 1;
            assert_same(&found, &expected, &format!("{name}, {force}"));
        }
    }
    println!("{interpolated} of {all} interpolated");
    assert!(10 * interpolated >= 9 * all, "{interpolated} of {all}");
}

#[test]
fn punches_of_all_kinds_are_interpolated() {
    let scene = scenes().into_iter().find(|scene| scene.name.as_deref() == Some("table1_R500_load1000")).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let for_many = model.clone().for_many_loads();
    for (punch, force) in [
        (Punch::wedge(0.01).unwrap(), 0.01),
        (Punch::flat(0.7).unwrap(), 0.01),
        (Punch::power(3.0, 1.0, 0.01).unwrap(), 0.01),
        // half of it within the contact
        (Punch::cylinder(2.0).unwrap(), 0.6),
        // far away from all other forces
        (Punch::parabola(500.0).unwrap(), 1e-20),
    ] {
        let [expected, found] = [&model, &for_many].map(|model| model.press(&punch, force).unwrap());
        assert_same(&found, &expected, &punch.to_string());
    }
}
