//! Layers much thinner than the contacts on them: pressures vary near their ends on the scale of the layer, and the
//! tolerance is met all the same.
use recede::{Model, Options, Scene, Solution};

/// A coating of a thousandth of the strip's thickness, and layers of a fiftieth in which the modulus changes by factors
/// of 1.8 to e^30.
const TOP_LAYERS: [&str; 5] = [
    "Homogeneous(thickness: 0.001, shear_modulus: 1000.0, poisson: 0.25)",
    "Homogeneous(thickness: 0.001, shear_modulus: 0.001, poisson: 0.25)",
    "Exponential(thickness: 0.02, shear_modulus: 1.0, poisson: 0.25, beta: 30.0)",
    "Exponential(thickness: 0.02, shear_modulus: 1.0, poisson: 0.25, beta: -300.0)",
    "Exponential(thickness: 0.02, shear_modulus: 1.0, poisson: 0.25, beta: 1500.0)",
];

fn solve(top: &str, tolerance: f64) -> Solution {
    let text = format!(
        "Scene(plane: Strain, punch: Cylinder(radius: 500), force: 0.002, stack: [{top}, Bonded,
            Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Receding,
            HalfPlane(shear_modulus: 1.0, poisson: 0.25)])"
    );
    let scene = Scene::from_ron(&text).unwrap();
    let options = Options { tolerance, ..Options::default() };
    Model::new(scene.stack().unwrap()).unwrap().press_with(&scene.punch, scene.force, &options).unwrap()
}

#[test]
fn the_tolerance_is_met() {
    for top in TOP_LAYERS {
        let (solution, rough) = (solve(top, 1e-10), solve(top, 1e-6));
        assert!(solution.warnings().is_empty(), "{top}: {:?}", solution.warnings());
        for (best, rough) in solution.contacts().iter().zip(rough.contacts()) {
            assert!(best.half_length_error <= 1e-10 * best.half_length, "{top}");
            assert!(best.peak_pressure_error <= 1e-10 * best.peak_pressure, "{top}");
            let off = (rough.half_length - best.half_length).abs();
            let claimed = rough.half_length_error + best.half_length_error;
            assert!(off <= 10.0 * claimed, "{top}: half-length off by {off:e}, claimed is {claimed:e}");
            let off = (rough.peak_pressure - best.peak_pressure).abs();
            let claimed = rough.peak_pressure_error + best.peak_pressure_error;
            assert!(off <= 10.0 * claimed, "{top}: pressure off by {off:e}, claimed is {claimed:e}");
        }
    }
}
