//! The two discretisations of the contact equations agree within what each says of its own errors.
//!
//! Goal: one, two and three contacts, homogeneous and graded faces, from a cold start by collocation, against the
//! Galerkin solver and the independent values of tests/data/contact.json.
use recede::{Method, Model, Options, Scene, Solution};

use crate::contact::{known, scene_file};

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

fn solve(name: &str, method: Method) -> Solution {
    let scene = Scene::read(scene_file(name)).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let options = Options { tolerance: 1e-9, method };
    model.press_with(&scene.top, scene.force, &options).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Values and absolute errors: half-lengths and pressures at x = 0, contact by contact.
fn values(solution: &Solution) -> Vec<[f64; 2]> {
    let contacts = solution.contacts().iter();
    let values = contacts.flat_map(|contact| {
        [
            [contact.half_length().unwrap(), contact.half_length_error().unwrap()],
            [contact.central_pressure, contact.central_pressure_error],
        ]
    });
    values.collect()
}

#[test]
fn both_methods_agree() {
    let known = known();
    let mut wrong = Vec::new();
    for name in SCENES {
        let (galerkin, collocation) = (solve(name, Method::Galerkin), solve(name, Method::Collocation));
        assert!(collocation.warnings().is_empty(), "{name}: {:?}", collocation.warnings());
        let known = &known[name];
        let listed = (0..known.half_length.len()).flat_map(|i| {
            let (a, p) = (known.half_length[i], known.peak_pressure[i]);
            [[a, a * known.half_length_err[i]], [p, p * known.peak_pressure_err[i]]]
        });
        let compared = values(&galerkin).into_iter().zip(values(&collocation)).zip(listed);
        for (at, (([galerkin, estimate], [collocation, claimed]), [listed, uncertain])) in compared.enumerate() {
            let (off, off_listed) = ((collocation - galerkin).abs(), (collocation - listed).abs());
            println!(
                "{name} {at}: {:.0e} and {:.0e}, claimed {:.0e}",
                off / listed,
                off_listed / listed,
                claimed / listed
            );
            if off > claimed + estimate || off_listed > claimed + 2.0 * uncertain {
                wrong.push(format!("{name}, value {at}: off by {off:e} and {off_listed:e}, claimed is {claimed:e}"));
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn a_force_beyond_the_punch_is_refused() {
    let scene = Scene::read(scene_file("strip_on_rigid")).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let options = Options { method: Method::Collocation, ..Options::default() };
    let error = model.press_with(recede::Punch::cylinder(0.1).unwrap(), 10.0, &options).unwrap_err();
    assert!(error.is_input(), "{error}");
}
