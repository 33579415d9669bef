//! A flat punch with sharp corners.
//!
//! Goal: on a half-plane its pressure is that of Sadowsky; on layers its face stays flat, whatever else is loose; a punch with
//! ever sharper round corners comes to it; and inconsistent scenes are rejected.
//!
//! Source of the closed form: Sadowsky 1928.
use crate::support;

use std::f64::consts::PI;

use crate::support::outwards;
use recede::{Exponential, HalfPlane, Homogeneous, Load, Model, Plane, Punch, Scene, Solution, Stack};

fn model(stack: recede::StackBuilder) -> Model {
    Model::new(stack.build().unwrap()).unwrap()
}

fn stack() -> recede::StackBuilder {
    Stack::builder(Plane::Strain)
}

fn strip(thickness: f64) -> Homogeneous {
    Homogeneous::new(thickness, 1.0, 0.25).unwrap()
}

fn ground(modulus: f64) -> HalfPlane {
    HalfPlane::new(modulus, 0.25).unwrap()
}

/// Homogeneous faces, and one that is graded: bonded, loose, loose twice.
fn layered() -> Vec<(f64, Model)> {
    let graded = |beta: f64| Exponential::new(1.0, 1.0, 0.3, beta).unwrap();
    vec![
        (1e-10, model(stack().layer(strip(1.0)).bonded().rigid())),
        (1e-10, model(stack().layer(strip(1.0)).receding().layer(ground(0.5)))),
        (1e-10, model(stack().layer(strip(0.7)).receding().layer(strip(1.4)).receding().rigid())),
        (1e-10, model(stack().layer(strip(0.3)).bonded().layer(graded(-1.2)).receding().layer(ground(2.0)))),
        (1e-6, model(stack().layer(graded(1.2)).bonded().layer(ground(0.2)))),
        (1e-6, model(stack().layer(graded(-1.5)).receding().layer(ground(0.7)))),
    ]
}

fn press(model: &Model, half_width: f64) -> Solution {
    model.press(Punch::flat(half_width).unwrap(), 0.01).unwrap()
}

fn close(found: f64, expected: f64, error: f64, what: &str) {
    assert!((found / expected - 1.0).abs() <= error, "{what}: {found:e}, expected {expected:e}");
}

#[test]
fn on_a_half_plane_the_pressure_is_that_of_sadowsky() {
    let (a, force) = (0.8, 0.01);
    for model in [
        model(stack().layer(ground(1.0))),
        model(stack().layer(strip(0.2)).bonded().layer(ground(1.0))),
        model(stack().layer(strip(0.5)).bonded().layer(strip(1.5)).bonded().layer(ground(1.0))),
    ] {
        let solution = press(&model, a);
        let [contact] = solution.contacts() else { panic!("one contact") };
        assert_eq!((contact.half_length().unwrap(), contact.half_length_error().unwrap()), (a, 0.0));
        assert_eq!(solution.warnings(), []);
        close(contact.central_pressure, force / (PI * a), 1e-12, "p(0)");
        assert!(contact.central_pressure_error < 1e-10 * contact.central_pressure);
        close(contact.resultant, force, 1e-12, "resultant");
        let field = model.field(&solution).unwrap();
        for x in [0.0, 0.3, 0.7, 0.799] {
            let expected = force / (PI * f64::sqrt(a * a - x * x));
            close(contact.pressure(x), expected, 1e-11, "pressure");
            close(-field.at(x, 0.0).unwrap().sigma_yy, expected, 1e-9, "stress on the face");
        }
        // outside the face is free, and inside stresses are those of the complex potential
        assert!(field.at(1.1, 0.0).unwrap().sigma_yy.abs() < 1e-10);
        let (x, d) = (0.5, 0.4);
        let z = num_complex::Complex64::new(d, -x) / a;
        let root = (z * z + 1.0).sqrt();
        let expected = -force / (PI * a) * (root.inv() + d / a * z / (root * root * root)).re;
        close(field.at(x, d).unwrap().sigma_yy, expected, 1e-10, "stress inside");
        assert_eq!(field.at(a, 0.0).unwrap().sigma_yy, f64::NEG_INFINITY);
    }
}

#[test]
fn the_face_under_the_punch_stays_flat() {
    for (i, (error, model)) in layered().into_iter().enumerate() {
        for half_width in [0.05, 0.6, 1.7] {
            let solution = press(&model, half_width);
            let field = model.field(&solution).unwrap();
            let v = |s: f64| field.at(s * half_width, 0.0).unwrap().v;
            // compared with how deep the face lies a little outside
            let dip = (v(1.5) - v(0.0)).abs();
            for s in [0.2, 0.5, 0.8, 0.95] {
                let tilt = (v(s) - v(0.0)).abs() / dip;
                assert!(tilt < f64::max(10.0 * error, 1e-7), "stack {i}, {half_width}: {tilt:e} at {s}");
            }
            for contact in solution.contacts() {
                close(contact.resultant, 0.01, 1e-12, "resultant");
                let estimate = contact.half_length_error().unwrap() / contact.half_length().unwrap();
                assert!(estimate < 1e-9, "stack {i}, {half_width}: {contact:?}");
            }
        }
    }
}

#[test]
fn ever_sharper_corners_come_to_those() {
    for (i, (_, model)) in layered().into_iter().enumerate() {
        let expected = press(&model, 0.6);
        let with_radius = |radius: f64| model.press(Punch::rounded_flat(0.6, radius).unwrap(), 0.01).unwrap();
        let errors = |radius: f64| {
            let found = with_radius(radius);
            let pairs = found.contacts().iter().zip(expected.contacts());
            let of = |(found, expected): (&recede::Contact, &recede::Contact)| {
                [
                    found.half_length().unwrap() / expected.half_length().unwrap() - 1.0,
                    found.central_pressure / expected.central_pressure - 1.0,
                ]
            };
            pairs.flat_map(of).collect::<Vec<f64>>()
        };
        // the contact reaches round the corners by a length like R^(2/3)
        let (blunt, sharp) = (errors(0.08), errors(0.01));
        for (k, (blunt, sharp)) in blunt.iter().zip(&sharp).enumerate() {
            assert!(sharp.abs() < 0.01, "stack {i}, number {k}: {sharp}");
            assert!((blunt / sharp - 4.0).abs() < 0.4, "stack {i}, number {k}: {blunt} {sharp}");
        }
    }
}

#[test]
fn loose_layers_do_not_care_how_hard_the_punch_is_pressed() {
    let (_, model) = layered().remove(1);
    let [light, heavy] = [1e-9, 3.0].map(|force| model.press(Punch::flat(0.5).unwrap(), force).unwrap());
    for (light, heavy) in light.contacts().iter().zip(heavy.contacts()) {
        close(heavy.half_length().unwrap(), light.half_length().unwrap(), 1e-12, "half-length");
        close(heavy.central_pressure, 3e9 * light.central_pressure, 1e-12, "pressure");
    }
    // a narrow punch is a line load
    let line = crate::closed_forms::line_load::EQUAL_MODULI;
    let narrow = self::model(stack().layer(strip(1.0)).receding().layer(ground(1.0)));
    close(press(&narrow, 1e-4).contacts()[1].half_length().unwrap(), line, 1e-7, "half-length under a narrow punch");
}

#[test]
fn a_thin_strip_is_bent_away_from_the_middle_of_a_wide_punch() {
    let thin = model(stack().layer(strip(1.0)).receding().layer(ground(1e-3)));
    let wide = thin.press(Punch::flat(3.0).unwrap(), 0.01).unwrap();
    let [punch, ground] = wide.contacts() else { panic!("two contacts") };
    let [edge] = outwards(punch)[..] else { panic!("{punch:?}") };
    assert_eq!((edge.right, edge.right_error), (3.0, 0.0));
    assert!(0.95 < edge.left / 3.0 && edge.left < 3.0 && edge.left_error < 1e-9, "{edge:?}");
    // far down it does not matter how narrow the strips are, to the square of their width
    let lines = crate::support::mirrored(&[(edge.centroid, 1.0, Load::Line)]).unwrap();
    let lines = thin.press(recede::Top::from(lines), 0.01).unwrap();
    let off = ground.half_length().unwrap() / lines.contacts()[1].half_length().unwrap() - 1.0;
    assert!(ground.half_length_error().unwrap() < 1e-9 && off.abs() < (3.0 - edge.left).powi(2), "{off}");
}

#[test]
fn the_command_solves_and_draws_it() {
    let text = "Scene(geometry: PlaneStrain, punch: Flat(half_width: 0.5), force: 0.002, stack: [
        Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])";
    let scene = Scene::from_ron(text).unwrap();
    assert_eq!(Scene::from_ron(&scene.to_ron()).unwrap().top, scene.top);
    let run = support::recede(&["solve", "-", "--format", "json"], text.as_bytes());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    assert!(
        run.stdout.contains("\"half_length\": 0.5,") && run.stdout.contains("\"half_length_error\": 0.0,"),
        "{}",
        run.stdout
    );
}
