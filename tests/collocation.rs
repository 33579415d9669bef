//! A second discretisation of the contact equations agrees with the answers of the first at the half-lengths that were found.
//!
//! Goal: one, two and three contacts, homogeneous and graded faces: what is left in the collocated equations, and the difference of the pressures,
//! are as small as the answers are said to be right; where half-lengths are wrong, collocation tells.
use recede::{Collocated, ContactError, Error, Interface, Model, Options, Punch, Scene};

use crate::contact::scene_file;
use crate::support::recede;

/// Scenes with one contact, two and three, next to homogeneous and to graded faces.
const SCENES: [&str; 9] = [
    "coating_bonded",
    "strip_on_rigid",
    "table1_R10_load1000",
    "table1_R500_load500",
    "full_beta-1_R500",
    "full_beta1_mu3_0.25",
    "full_beta-3_R500",
    "table2_beta-1_R500_load100",
    "two_strips_loose",
];
/// Relative error of the answers that are checked, and to which collocation is to tell.
const TOLERANCE: f64 = 1e-9;

fn checked(scene: &Scene, force: f64) -> (Vec<Collocated>, Vec<[f64; 2]>) {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let options = Options { tolerance: TOLERANCE };
    let solution = model.press_with(&scene.top, force, &options).unwrap();
    let half = |c: &recede::Contact| [c.half_length().unwrap(), c.half_length_error().unwrap()];
    let half_lengths = solution.contacts().iter().map(half).collect();
    (model.collocate(&scene.top, &solution, &options).unwrap(), half_lengths)
}

#[test]
fn both_discretisations_agree() {
    for name in SCENES {
        let scene = Scene::read(scene_file(name)).unwrap();
        let (found, _) = checked(&scene, scene.force.given().unwrap());
        for Collocated { interface, residual, pressure_difference, nodes } in found {
            println!("{name}, {interface}: {residual:.0e} and {pressure_difference:.0e} with {nodes} nodes");
            assert!(residual.abs() < 2.0 * TOLERANCE, "{name}, {interface}: {residual:e}");
            // single pressures near the ends of contacts next to graded faces converge slower than resultants and the pressure in the middle
            assert!(pressure_difference < 1e-5, "{name}, {interface}: {pressure_difference:e}");
        }
    }
}

#[test]
fn collocation_tells_half_lengths_that_belong_to_another_force() {
    // the half-lengths of a force, checked as if they were the half-lengths of one that is larger by a millionth
    let scene = Scene::read(scene_file("table1_R500_load500")).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let (force, options) = (scene.force.given().unwrap(), Options { tolerance: TOLERANCE });
    let solution = model.press(&scene.top, force).unwrap();
    let blunter = Punch::cylinder(500.0 * (1.0 + 1e-6)).unwrap();
    let found = model.collocate(&blunter, &solution, &options).unwrap();
    let of_punch = found.iter().find(|contact| contact.interface == Interface::Punch).unwrap();
    assert!((1e-7..1e-5).contains(&of_punch.residual.abs()), "{found:?}");
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
    assert!(contacts[1]["residual"].as_f64().unwrap().abs() < 1e-9);
}

#[test]
fn contacts_that_collocation_does_not_know_are_refused() {
    let text = |top: &str| {
        format!(
            "Scene(geometry: PlaneStrain, {top}, stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])"
        )
    };
    for top in [
        "load: Line, force: 0.01",
        "punch: Flat(half_width: 0.5), force: 0.01",
        "punches: [(shape: Cylinder(radius: 10), at: 0.5, force: 0.01)]",
    ] {
        let scene = Scene::from_ron(&text(top)).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let refused = model.collocate(&scene.top, &solution, &Options::default()).unwrap_err();
        assert!(matches!(&refused, Error::Contact(ContactError::NotCollocated)), "{top}: {refused}");
        assert!(refused.is_input());
    }
}
