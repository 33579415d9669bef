//! Peak memory: below 1 GB for any scene, whatever a command does with it.
//!
//! Goal: whatever grows a table has a bound that it cannot pass. Here are the scenes that come nearest to it: as many
//! contacts, layers and distinct materials as there may be, and those that once took all memory there was.
use std::fmt::Write;

use allocation_counter::measure;
use recede::selftest::CheckedScene;
use recede::{MAX_RECEDING, Options, Scene};

/// What is promised, in bytes.
const PROMISED: u64 = 1_000_000_000;

fn scene(layers: usize, interface: &str, layer: impl Fn(usize) -> String, rest: &str) -> Scene {
    let mut items = String::new();
    for k in 0..layers {
        let _ = write!(items, "{}, {interface}, ", layer(k));
    }
    let base = "HalfPlane(shear_modulus: 1, poisson: 0.25)";
    Scene::from_ron(&format!("(geometry: PlaneStrain, {rest}, stack: [{items}{base}])")).expect("legal")
}

/// The most memory that was taken at a time, by all that the commands do.
fn peak(scene: &Scene) -> u64 {
    // what is kept from one scene to the next counts for the first
    let mut outcome = None;
    let taken = measure(|| outcome = Some(CheckedScene::run(scene, &Options::default(), true).outcome));
    let outcome = outcome.expect("an outcome");
    assert!(!outcome.is_wrong(), "{}", outcome.reason());
    taken.bytes_max
}

#[test]
fn no_scene_takes_more_memory_than_promised() {
    let strip = |k: usize| {
        format!("Homogeneous(thickness: {}, shear_modulus: {}, poisson: 0.25)", 1.0 + 0.1 * (k % 7) as f64, 1 + k % 5)
    };
    let sigmoid = |k: usize| {
        let top = 1.0 + 1e-3 * k as f64;
        format!(
            "Graded(thickness: 0.1, shear_modulus: Sigmoid(top: {top}, bottom: 12, centre: 0.04, width: 0.02), \
             poisson: 0.3)"
        )
    };
    let cylinder = "punch: Cylinder(radius: 500), force: 0.002";
    let mut worst = 0;
    for scene in [
        scene(MAX_RECEDING, "Receding", strip, "load: Line, force: 0.002"),
        scene(400, "Bonded", sigmoid, cylinder),
        scene(1500, "Bonded", strip, cylinder),
        Scene::from_ron(
            "(geometry: PlaneStrain, punch: Parabola(radius: 40), force: 0.02, stack: [
                GradedHalfPlane(shear_modulus: 1, poisson: 0.3, beta: 0.5)])",
        )
        .expect("legal"),
        Scene::from_ron(
            "(geometry: PlaneStrain, punch: Cylinder(radius: 20), half_length: 0.5, stack: [
                Exponential(thickness: 1, shear_modulus: 1, poisson: 0.3, beta: 33), Receding,
                HalfPlane(shear_modulus: 2, poisson: 0.3)])",
        )
        .expect("legal"),
    ] {
        worst = worst.max(peak(&scene));
    }
    println!("at most {} MB", worst >> 20);
    assert!(worst < PROMISED, "{worst}");
}
