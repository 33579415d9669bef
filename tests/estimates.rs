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
            let model = Model::new(scene.stack().unwrap()).unwrap();
            for tolerance in [1e-3, 1e-6, Options::default().tolerance] {
                let options = Options { tolerance, ..Options::default() };
                let solution = model.press_with(&scene.punch, scene.force, &options).unwrap();
                for one in compare(&scene, &solution).unwrap() {
                    let name = format!("seed {seed}, number {number}, {geometry:?}, tolerance {tolerance:e}");
                    assert!(one.excess() < MOST, "{name}: {one:?}\n{}", scene.to_ron());
                    cautions.extend((tolerance == Options::default().tolerance).then(|| one.caution()));
                }
            }
        }
    }
    cautions.sort_by(f64::total_cmp);
    assert!(cautions[cautions.len() / 2] < CAUTIOUS, "{}", cautions[cautions.len() / 2]);
}
