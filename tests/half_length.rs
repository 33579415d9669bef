//! Half-lengths prescribed in place of the force.
//!
//! Goal: the force found is that of closed forms on a half-plane, for every punch the one under which the contact is as long as
//! wanted, within its error; what no force can bring about, and scenes that say too much or too little, are refused where
//! they are wrong.
//!
//! Source of the numbers: Hertz's formula, and the solver pressed with the force that was found.
use crate::support::{self, innermost_end};

use recede::{
    ContactError, Controlled, Error, Exponential, Force, HalfPlane, Load, Model, NoSolution, Plane, Punch, Scene,
    Solution, Stack, Sweep, report::SweepCsv,
};

fn half_plane() -> Model {
    Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.3, 0.3).unwrap()).build().unwrap()).unwrap()
}

fn strip() -> Model {
    let strip = Exponential::new(1.0, 1.0, 0.25, -0.7).unwrap();
    let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(0.5, 0.3).unwrap());
    Model::new(stack.build().unwrap()).unwrap()
}

#[test]
fn on_a_half_plane_the_force_is_that_of_hertz() {
    // P = πE*a²/(4R), E* = 2μ/(1 − ν)
    let modulus = 2.0 * 1.3 / 0.7;
    for (radius, half_length) in [(1.0, 1e-6), (50.0, 0.3), (1e4, 200.0)] {
        let punch = Punch::parabola(radius).unwrap();
        let solution = half_plane().press(&punch, Force::ForHalfLength(half_length)).unwrap();
        let expected = std::f64::consts::PI * modulus * half_length * half_length / (4.0 * radius);
        let error = (solution.force() - expected).abs();
        assert!(error < 1e-10 * expected, "{} {expected}", solution.force());
        assert!(error <= solution.force_error() && solution.force_error() < 1e-9 * expected, "{solution:?}");
        assert!((solution.contacts()[0].half_length().unwrap() / half_length - 1.0).abs() < 1e-11);
    }
}

/// Two solutions have the same contacts, ends and pressures within the errors that both claim, and the error of the force.
fn assert_alike(one: &Solution, other: &Solution) {
    let force = 1e-12 + one.force_error().max(other.force_error()) / one.force();
    for (one, other) in one.contacts().iter().zip(other.contacts()) {
        assert_eq!(one.intervals().len(), other.intervals().len());
        for (a, b) in one.intervals().iter().zip(other.intervals()) {
            let half = 0.5 * (a.right - a.left);
            let (off, claimed) = ((a.right - b.right).abs(), a.right_error + b.right_error);
            assert!(off <= claimed + force * half, "{off:e} {claimed:e} of {half}");
        }
        let off = (one.central_pressure - other.central_pressure).abs();
        let claimed = one.central_pressure_error + other.central_pressure_error;
        assert!(
            off <= claimed + force * one.central_pressure || one.central_pressure.is_infinite(),
            "{off:e} {claimed:e}"
        );
    }
}

#[test]
fn the_force_found_makes_the_contact_as_long_as_wanted() {
    let model = strip();
    for (punch, half_lengths) in [
        (Punch::cylinder(20.0).unwrap(), &[0.5, 4.0][..]),
        (Punch::cylinder(1.0).unwrap(), &[0.01, 0.97]),
        (Punch::wedge(0.05).unwrap(), &[0.01]),
        (Punch::power(4.0, 1.0, 0.1).unwrap(), &[0.05, 1.5]),
        (Punch::rounded_flat(0.4, 3.0).unwrap(), &[0.401]),
        (Punch::elastic_cylinder(20.0, 0.8, 0.3).unwrap(), &[0.01, 2.0]),
    ] {
        for &half_length in half_lengths {
            let solution = model.press(&punch, Force::ForHalfLength(half_length)).unwrap();
            let top = &solution.contacts()[0];
            assert!((top.half_length().unwrap() / half_length - 1.0).abs() < 1.1e-11, "{punch} {half_length} {top:?}");
            let again = model.press(&punch, solution.force()).unwrap();
            assert_alike(&again, &solution);
            assert_eq!((again.force(), again.force_error()), (solution.force(), 0.0));
            // a force that differs by its error changes the half-length by hardly more
            let more = model.press(&punch, solution.force() + 1e6 * solution.force_error()).unwrap();
            let changed = more.contacts()[0].half_length().unwrap() / half_length - 1.0;
            let relative = top.half_length_error().unwrap() / top.half_length().unwrap();
            assert!(
                changed > 0.2e6 * relative && changed < 4e6 * (relative + 1e-11),
                "{punch} {half_length} {changed}"
            );
        }
    }
}

#[test]
fn half_lengths_beyond_all_measure_are_met_or_refused() {
    let punch = Punch::parabola(50.0).unwrap();
    for half_length in [f64::MIN_POSITIVE, 1e-12, f64::MAX] {
        match strip().press(&punch, Force::ForHalfLength(half_length)) {
            Ok(solution) => {
                let found = solution.contacts()[0].half_length().unwrap();
                assert!((found / half_length - 1.0).abs() < 1e-10, "{found} is not {half_length}");
                assert!(solution.force().is_normal() && solution.force_error().is_finite(), "{solution:?}");
            }
            Err(error) => assert!(matches!(error, Error::NoSolution(_) | Error::Unresolved { .. }), "{error}"),
        }
    }
}

#[test]
fn what_no_force_brings_about_is_refused() {
    let model = half_plane();
    let refused = |punch: Punch, half_length: f64| model.press(&punch, Force::ForHalfLength(half_length)).unwrap_err();
    for (punch, half_length) in [(Punch::cylinder(1.0), 1.0), (Punch::rounded_flat(0.5, 1.0), 0.5)] {
        let error = refused(punch.unwrap(), half_length);
        assert!(matches!(error, Error::NoSolution(NoSolution::Unreachable { .. })) && error.is_input(), "{error}");
    }
    let load = model.press(Load::Line, Force::ForHalfLength(1.0)).unwrap_err();
    assert!(matches!(load, Error::Contact(ContactError::LoadControlled(_))) && load.is_input());
    assert!(refused(Punch::parabola(1.0).unwrap(), -1.0).to_string().starts_with("half_length: found -1.0"));
}

#[test]
fn a_force_that_is_not_solved_for_does_not_end_the_search() {
    // two coatings that stiffen fast, on soft ground: the contact opens about the middle, and the expected slope is no number
    let text = std::fs::read_to_string("tests/data/hard/seed_2_number_70.ron").unwrap();
    let scene = Scene::from_ron(&text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    for half_length in [0.3, 0.79, 0.8] {
        let solution = model.press(&scene.top, Force::ForHalfLength(half_length)).unwrap();
        let top = &solution.contacts()[0];
        let (found, error) = innermost_end(top);
        let allowed = 1.1e-11 + error / half_length;
        assert!((found / half_length - 1.0).abs() < allowed, "{half_length} {top:?}");
        let again = model.press(&scene.top, solution.force()).unwrap();
        assert_alike(&again, &solution);
    }
}

#[test]
fn a_solver_that_fails_is_no_bad_input() {
    let (controlled, punch) = (Controlled::HalfLength, "Parabola(radius: 1.0)".to_owned());
    let cause = Box::new(NoSolution::NotConverged);
    let error = Error::from(NoSolution::ForceNotFound { controlled, punch, wanted: 0.5, cause });
    assert!(!error.is_input());
    let said = error.to_string();
    assert!(said.contains("0.5") && said.contains("did not converge"), "{said}");
}

const SCENE: &str = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 50), half_length: 0.5, stack: [
    Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])";

#[test]
fn scenes_say_one_or_the_other() {
    let scene = Scene::from_ron(SCENE).unwrap();
    assert_eq!(scene.force, Force::ForHalfLength(0.5));
    assert_eq!(scene.paths()[..2], ["half_length", "punch.radius"]);
    assert_eq!(scene.with("half_length", 0.75).unwrap().force, Force::ForHalfLength(0.75));
    assert_eq!(Scene::from_ron(&scene.to_ron()).unwrap().force, scene.force);
}

#[test]
fn sweeps_vary_it_and_tell_the_force() {
    let scene = Scene::from_ron(SCENE).unwrap();
    let sweep = Sweep::new(scene.clone(), vec!["half_length=[0.2, 0.4]".parse().unwrap()]).unwrap();
    let csv = SweepCsv::new(&sweep);
    assert!(csv.header().unwrap().contains("contact_1_2_right_error,force,force_error,status"));
    for row in sweep.rows() {
        let alone = recede::solve(&scene.with("half_length", row.values[0]).unwrap()).unwrap();
        let numbers = csv.numbers(&row);
        assert_eq!(numbers[numbers.len() - 2], alone.force());
        assert_eq!(csv.point_of(&csv.line(&row).unwrap()).numbers, numbers);
    }
    assert!(Sweep::new(scene, vec!["half_length=[0.2, -0.4]".parse().unwrap()]).is_err());
}

#[test]
fn the_command_tells_the_force() {
    let json = support::recede(&["solve", "-", "--format", "json"], SCENE.as_bytes());
    assert_eq!(json.status, Some(0), "{}", json.stderr);
    let expected = recede::solve(&Scene::from_ron(SCENE).unwrap()).unwrap().force();
    assert!(json.stdout.contains(&format!("\"force\": {expected:?},")), "{}", json.stdout);
    let check = support::recede(&["check", "-"], SCENE.as_bytes());
    assert!(check.stdout.contains("Parabola(radius: 50.0), half-length 0.5"), "{}", check.stdout);
}
