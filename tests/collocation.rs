//! A second discretisation of the contact equations agrees with the answers of the first at the ends that were found.
//!
//! Goal: contacts of all kinds, next to homogeneous and to graded faces: the gaps that are left where bodies touch, and the changes of the pressures that close them,
//! are as small as the answers are said to be right; where ends are wrong, collocation tells.
use std::path::Path;

use recede::{Collocated, ContactError, Error, Interface, Model, Options, Punch, Scene};

use crate::contact::scene_file;
use crate::support::recede;

/// Relative error of the answers that are checked.
const TOLERANCE: f64 = 1e-10;
/// Pressures next to graded faces that are right to this tolerance leave gaps of this part of the indentation.
const GAP: f64 = 1e-8;
/// Single pressures near the ends of contacts next to graded faces converge slower than resultants and the pressure in the middle.
const PRESSURE: f64 = 1e-6;

/// Nothing where layers with weights come apart, of which collocation knows nothing.
fn checked(scene: &Scene) -> Vec<Collocated> {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press_with(&scene.top, scene.force, &Options { tolerance: TOLERANCE }).unwrap();
    let is_open = solution.closed().iter().any(|own| !own.openings.is_empty());
    if is_open { Vec::new() } else { model.collocate(&scene.top, &solution).unwrap() }
}

fn assert_agrees(name: &str, scene: &Scene) {
    for Collocated { interface, residual, pressure_difference, nodes } in checked(scene) {
        println!("{name}, {interface}: {residual:.0e} and {pressure_difference:.0e} with {nodes} nodes");
        assert!(
            residual < GAP && pressure_difference < PRESSURE,
            "{name}, {interface}: {residual:e} {pressure_difference:e}"
        );
    }
}

/// Bonded and loose layers, homogeneous and graded faces, punches of all shapes, loads, and all of that about an axis.
#[test]
fn both_discretisations_agree() {
    for folder in ["examples/scenes", "examples/axisymmetric"] {
        let files = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
        for file in
            files.map(|file| file.unwrap().path()).filter(|file| file.extension().is_some_and(|end| end == "ron"))
        {
            assert_agrees(&file.display().to_string(), &Scene::read(&file).unwrap());
        }
    }
    for name in ["full_beta1_mu3_0.25", "full_beta-3_R500", "table2_beta-1_R500_load100", "two_strips_loose"] {
        assert_agrees(name, &Scene::read(scene_file(name)).unwrap());
    }
}

/// Gaps close as fast as answers become more exact: a digit of both for a digit of the tolerance.
#[test]
fn gaps_close_as_answers_become_more_exact() {
    let scene = Scene::read(scene_file("table2_beta-1_R500_load100")).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let worst = |tolerance: f64| {
        let solution = model.press_with(&scene.top, scene.force, &Options { tolerance }).unwrap();
        let found = model.collocate(&scene.top, &solution).unwrap();
        found.iter().fold(0.0, |worst: f64, contact| worst.max(contact.residual))
    };
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-11] {
        let gap = worst(tolerance);
        assert!(gap < 100.0 * tolerance, "{tolerance:e}: {gap:e}");
    }
}

/// Contacts of several intervals, and contacts where nothing is even.
#[test]
fn lists_of_intervals_are_checked() {
    let strip = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25)";
    let stack = format!("[{strip}, Receding, {strip}, Receding, HalfPlane(shear_modulus: 0.5, poisson: 0.25)]");
    for (top, intervals) in [
        ("loads: [(load: Line, at: -6, force: 1e-3), (load: Uniform(half_width: 0.5), at: 6, force: 1e-3)]", [2, 2]),
        (
            "punches: [(shape: Cylinder(radius: 100), at: -0.5, force: 1e-3), (shape: Flat(half_width: 0.3), at: 2, force: 2e-3, tilt: Free(eccentricity: 0.05))]",
            [2, 1],
        ),
        ("punches: [(shape: Cylinder(radius: 100), at: 0.7, force: 1e-3, tilt: Fixed(1e-4))]", [1, 1]),
        ("punch: Polynomial(half_width: 1.0, heights: [-0.01, 0.02]), force: 1e-3", [2, 1]),
    ] {
        let scene = Scene::from_ron(&format!("Scene(geometry: PlaneStrain, {top}, stack: {stack})")).unwrap();
        let solution = recede::solve(&scene).unwrap();
        let found = solution.contacts().iter().map(|contact| contact.intervals().len());
        assert_eq!(found.take(2).collect::<Vec<_>>(), intervals, "{top}");
        assert_agrees(top, &scene);
    }
}

#[test]
fn collocation_tells_half_lengths_that_belong_to_another_force() {
    // the half-lengths of a force, checked as if they were the half-lengths of one that is larger by a millionth
    let scene = Scene::read(scene_file("table1_R500_load500")).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let blunter = Punch::cylinder(500.0 * (1.0 + 1e-6)).unwrap();
    let found = model.collocate(&blunter, &solution).unwrap();
    let of_punch = found.iter().find(|contact| contact.interface == Interface::Punch).unwrap();
    assert!(
        (1e-7..1e-5).contains(&of_punch.residual) && (1e-7..1e-5).contains(&of_punch.pressure_difference),
        "{found:?}"
    );
}

#[test]
fn the_command_prints_the_check() {
    let file = scene_file("table1_R500_load500");
    let table = recede(&["solve", file.to_str().unwrap(), "--method", "collocation"], b"");
    assert!(table.stdout.contains("punch by collocation with"), "{}", table.stdout);
    let json = recede(&["solve", file.to_str().unwrap(), "--method", "collocation", "--format", "json"], b"");
    let document: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let contacts = document["collocation"].as_array().unwrap();
    assert_eq!(contacts.len(), 2);
    assert_eq!(contacts[1]["interface"], "1|2");
    assert!(contacts[1]["residual"].as_f64().unwrap() < 1e-9);
}

#[test]
fn rings_are_refused() {
    let text = "Scene(geometry: Axisymmetric, punch: Cone(slope: 0.01), force: 0.018, stack: [
        Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded, HalfPlane(shear_modulus: 0.01, poisson: 0.25)])";
    let scene = Scene::from_ron(text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let refused = model.collocate(&scene.top, &solution).unwrap_err();
    assert!(matches!(&refused, Error::Contact(ContactError::NotCollocated)) && refused.is_input(), "{refused}");
}
