//! Error estimates at loose tolerances as at tight ones: what a stricter answer differs by is covered, and not much less than is
//! claimed.
use recede::selftest::{Ranges, about_axis, compare, scene};
use recede::{Geometry, Model, Options, Scene};

/// No answer is off by more than this many times its estimate.
const MOST: f64 = 10.0;
/// Half of all estimates at the default tolerance are at most this many times the error, rounding included.
const CAUTIOUS: f64 = 100.0;

/// A random stack with all its layers loose.
fn loose(seed: u64, number: u64, geometry: Geometry) -> Scene {
    let mut scenario = scene(&Ranges::moderate(), seed, number);
    for layer in &mut scenario.layers {
        layer.receding = true;
        layer.steepness = layer.steepness.filter(|_| number.is_multiple_of(4));
    }
    let scene = scenario.scene().unwrap();
    if geometry.is_axisymmetric() { about_axis(scene) } else { scene }
}

/// How cautious the estimates of a scene are at the last of some tolerances; none of them is too bold at any.
fn cautions_of(scene: &Scene, tolerances: &[f64]) -> Vec<f64> {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let mut cautions = Vec::new();
    for tolerance in tolerances {
        let options = Options { tolerance: *tolerance };
        let solution = model.press_with(&scene.top, scene.force, &options).unwrap();
        let all = compare(scene, &solution).unwrap();
        for one in &all {
            assert!(one.excess() < MOST, "tolerance {tolerance:e}: {one:?}\n{}", scene.to_ron());
        }
        cautions = all.iter().map(|one| one.caution()).collect();
    }
    cautions
}

#[test]
fn no_answer_is_off_by_more_than_ten_times_its_estimate_at_any_tolerance() {
    let all = [
        (Geometry::PlaneStrain, 5, 56..60),
        (Geometry::PlaneStrain, 5, 68..70),
        (Geometry::PlaneStrain, 5, 91..96),
        (Geometry::PlaneStrain, 21, 49..50),
        (Geometry::PlaneStrain, 21, 423..424),
        (Geometry::Axisymmetric, 5, 44..52),
    ];
    let mut cautions = Vec::new();
    for (geometry, seed, numbers) in all {
        for number in numbers {
            let scene = loose(seed, number, geometry);
            cautions.extend(cautions_of(&scene, &[1e-3, 1e-6, Options::default().tolerance]));
        }
    }
    cautions.sort_by(f64::total_cmp);
    assert!(cautions[cautions.len() / 2] < CAUTIOUS, "{}", cautions[cautions.len() / 2]);
}

/// The equations are linearised in the last step of the ends, which is short against a contact, but not against layers as thin as these.
#[test]
fn the_last_part_of_the_way_of_an_end_is_short_against_thin_layers() {
    let sheets = "Homogeneous(thickness: 0.1073, shear_modulus: 0.4567, poisson: 0.231), Receding,
        Homogeneous(thickness: 0.1756, shear_modulus: 0.06703, poisson: 0.437), Receding,";
    for (radius, force, stack) in [
        (
            893.5,
            0.001972,
            format!(
                "Homogeneous(thickness: 0.39, shear_modulus: 0.2924, poisson: 0.254), Receding, {sheets} HalfPlane(shear_modulus: 0.1341, poisson: 0.3)"
            ),
        ),
        (
            784.2,
            0.000433,
            "Homogeneous(thickness: 0.119, shear_modulus: 9.675, poisson: 0.186), Receding,
                Homogeneous(thickness: 1.138, shear_modulus: 23.44, poisson: 0.321), Receding,
                Homogeneous(thickness: 0.1362, shear_modulus: 11.53, poisson: 0.322), Receding,
                Homogeneous(thickness: 0.2088, shear_modulus: 0.1329, poisson: 0.268), Receding,
                HalfPlane(shear_modulus: 16.52, poisson: 0.3)"
                .to_owned(),
        ),
    ] {
        let punch = format!("Parabola(radius: {radius:?})");
        let text = format!("Scene(geometry: PlaneStrain, punch: {punch}, force: {force:?}, stack: [{stack}])");
        let scene = Scene::from_ron(&text).unwrap();
        for tolerance in [1e-7, 3e-8, 1e-8, 3e-9, 1e-9, 1e-10] {
            cautions_of(&scene, &[tolerance]);
        }
    }
}

/// Far out, where the pressure of a loose layer on a rigid base is less than rounding leaves of it, there are ends anywhere.
#[test]
fn an_end_that_lies_in_the_noise_of_the_pressure_is_not_known() {
    for (thickness, modulus) in [(1.84, 0.91), (1.6, 1.1), (2.1, 0.8)] {
        let text = format!(
            "Scene(geometry: Axisymmetric, load: Parabolic(radius: 2.96), force: 0.0082, stack: [
                Homogeneous(thickness: 5, shear_modulus: 0.231, poisson: 0), Receding,
                Homogeneous(thickness: 3.6, shear_modulus: 0.648, poisson: 0.177), Receding,
                Exponential(thickness: {thickness}, shear_modulus: {modulus}, poisson: 0.5, beta: 1.02), Receding, Rigid])"
        );
        let scene = Scene::from_ron(&text).unwrap();
        let options = Options { tolerance: 1e-3 };
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press_with(&scene.top, scene.force, &options).unwrap();
        for contact in &solution.contacts()[1..] {
            let end = contact.intervals()[0];
            let places: Vec<f64> = (0..1000).map(|k| end.right * f64::from(k) / 1000.0).collect();
            let noise = -places.iter().map(|x| contact.pressure(*x)).fold(0.0, f64::min);
            let seen = places.iter().rfind(|x| contact.pressure(**x) > 10.0 * noise).unwrap();
            assert!(end.right_error > 0.8 * (end.right - seen) - 2e-3 * end.right, "{text}: {end:?} {seen}");
        }
    }
}
