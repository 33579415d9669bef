//! The contact equations are square whatever presses, and are what was solved.
//!
//! Goal: for every kind of scene there are as many rows as unknowns on all contacts together, with as many terms as the solution has, and an intensity and a place
//! for every end that moves.
//!
//! Source of the numbers: none, counts are compared with counts of the solution.
use std::fs;

use recede::{Ledger, LedgerEntry, Model, Scene};

use crate::support;

/// Layers that lie loose on each other and on a half-plane.
const LOOSE: &str = "stack: [Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Receding,
    Homogeneous(thickness: 0.6, shear_modulus: 2.0, poisson: 0.3), Receding, HalfPlane(shear_modulus: 1.0, poisson: 0.25)]";

/// Punches and loads anywhere.
const ANYWHERE: [&str; 5] = [
    "punches: [(shape: Parabola(radius: 50.0), at: 0.3, force: 0.002)]",
    "punches: [(shape: Parabola(radius: 50.0), at: 0.0, force: 0.002), (shape: Flat(half_width: 0.3), at: 3.0, force: 0.001, tilt: Free(eccentricity: 0.1))]",
    "punches: [(shape: Flat(half_width: 0.3), at: 3.0, force: 0.001, tilt: Fixed(1e-3))]",
    "punch: Wedge(left: 0.01, slope: 0.02), force: 0.001",
    "loads: [(load: Line, at: -0.5, force: 0.001), (load: Uniform(half_width: 0.2), at: 1.0, force: 0.002)]",
];

fn ledger(scene: &Scene) -> Ledger {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let ledger = model.ledger(&scene.top, &solution).unwrap();
    let count = |entries: &[LedgerEntry], kind: &str| -> usize {
        entries.iter().filter(|entry| entry.kind.contains(kind)).map(|entry| entry.count).sum()
    };
    assert_eq!(count(&ledger.unknowns, ""), count(&ledger.rows, ""), "{ledger}");
    assert_eq!(count(&ledger.unknowns, "terms"), solution.stats().terms.iter().flatten().sum::<usize>(), "{ledger}");
    assert_eq!(count(&ledger.unknowns, "places"), count(&ledger.rows, "vanish"), "{ledger}");
    ledger
}

#[test]
fn as_many_rows_as_unknowns_in_every_scene_that_ships() {
    for folder in ["examples/scenes", "examples/axisymmetric"] {
        for file in fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()) {
            if file.extension().is_some_and(|ending| ending == "ron") {
                ledger(&Scene::read(file).unwrap());
            }
        }
    }
}

#[test]
fn as_many_rows_as_unknowns_wherever_punches_and_loads_are() {
    for top in ANYWHERE {
        ledger(&Scene::from_ron(&format!("Scene(geometry: PlaneStrain, {top}, {LOOSE})")).unwrap());
    }
}

#[test]
fn a_force_that_is_to_be_found_is_an_unknown() {
    for (what, moving) in [("force: 1e-3", 3), ("half_length: 0.1", 2), ("depth: 1e-3", 3)] {
        let base = LOOSE.replace("HalfPlane(shear_modulus: 1.0, poisson: 0.25)", "Rigid");
        let text = format!("Scene(geometry: PlaneStrain, punch: Parabola(radius: 50.0), {what}, {base})");
        let ledger = ledger(&Scene::from_ron(&text).unwrap());
        let count =
            |kind: &str| ledger.unknowns.iter().filter(|own| own.kind.contains(kind)).map(|own| own.count).sum();
        let (forces, places): (usize, usize) = (count("force of the punch"), count("places"));
        assert_eq!((forces, places), (usize::from(!what.starts_with("force")), moving), "{what}: {ledger}");
    }
}

#[test]
fn ends_at_the_corners_of_a_flat_punch_do_not_move() {
    let scene = "Scene(geometry: PlaneStrain, punch: Flat(half_width: 0.3), force: 0.001, ";
    let ledger = ledger(&Scene::from_ron(&format!("{scene}{LOOSE})")).unwrap());
    let on_top = |kind: &str| {
        ledger.unknowns.iter().filter(|one| one.interface.to_string() == "punch" && one.kind.contains(kind)).count()
    };
    assert_eq!((on_top("places"), on_top("intensities")), (0, 1), "{ledger}");
}

#[test]
fn the_command_prints_them() {
    let shown = support::recede(&["show", "examples/scenes/two_strips.ron", "--contacts"], b"");
    assert_eq!(shown.status, Some(0), "{}", shown.stderr);
    let scene = Scene::read("examples/scenes/two_strips.ron").unwrap();
    assert_eq!(shown.stdout, ledger(&scene).to_string());
}
