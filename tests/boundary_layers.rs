//! Layers much thinner than the contacts on them: pressures vary near their ends on the scale of the layer, and the
//! tolerance is met all the same.
use recede::{Model, Options, Point, Scene, Solution, Stack};

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
        "Scene(geometry: PlaneStrain, punch: Cylinder(radius: 500), force: 0.002, stack: [{top}, Bonded,
            Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Receding,
            HalfPlane(shear_modulus: 1.0, poisson: 0.25)])"
    );
    let scene = Scene::from_ron(&text).unwrap();
    let options = Options { tolerance };
    Model::new(scene.stack().unwrap()).unwrap().press_with(&scene.top, scene.force, &options).unwrap()
}

#[test]
fn the_tolerance_is_met() {
    for top in TOP_LAYERS {
        let (solution, rough) = (solve(top, 1e-10), solve(top, 1e-6));
        assert!(
            solution.warnings().iter().all(|warning| warning.code.is_about_theory()),
            "{top}: {:?}",
            solution.warnings()
        );
        for (best, rough) in solution.contacts().iter().zip(rough.contacts()) {
            assert!(best.half_length_error().unwrap() <= 1e-10 * best.half_length().unwrap(), "{top}");
            assert!(best.central_pressure_error <= 1e-10 * best.central_pressure, "{top}");
            let off = (rough.half_length().unwrap() - best.half_length().unwrap()).abs();
            let claimed = rough.half_length_error().unwrap() + best.half_length_error().unwrap();
            assert!(off <= 10.0 * claimed, "{top}: half-length off by {off:e}, claimed is {claimed:e}");
            let off = (rough.central_pressure - best.central_pressure).abs();
            let claimed = rough.central_pressure_error + best.central_pressure_error;
            assert!(off <= 10.0 * claimed, "{top}: pressure off by {off:e}, claimed is {claimed:e}");
        }
    }
}

/// A short contact on a thin graded coating of a slab that touches the ground over a length ten thousand times longer: what
/// the ground does is bending, the same at places so close to each other, and short waves are summed wherever they matter.
#[test]
fn a_long_contact_far_below_takes_no_waves_from_a_short_one() {
    let coating = "Exponential(thickness: 0.03, shear_modulus: 3, poisson: 0.3, beta: -100), Bonded";
    let solved = |base: &str| {
        let text = format!(
            "Scene(geometry: PlaneStrain, punch: Parabola(radius: 363), force: 7e-5, stack: [{coating}, \
             Homogeneous(thickness: 30, shear_modulus: 25, poisson: 0.3), {base}])"
        );
        let scene = Scene::from_ron(&text).unwrap();
        let model = Model::new(Stack::from_items(scene.geometry, &scene.stack).unwrap()).unwrap();
        let solution = model.press(&scene.top, 7e-5).unwrap();
        let points = [(0.0, 0.0), (0.03, 0.0), (0.07, 0.0), (0.2, 0.0), (0.05, 0.01), (0.0, 0.03)];
        let points = points.map(|(x, depth)| Point { x, depth, layer: Some(1) });
        let far = Point { x: 2000.0, depth: 0.0, layer: None };
        let field = model.field(&solution).unwrap();
        let alone = field.points(&points).unwrap();
        let together = field.points(&[&points[..], &[far]].concat()).unwrap();
        let peak = solution.contacts()[0].central_pressure;
        for (one, other) in alone.iter().zip(&together) {
            assert!((one.sigma_xx - other.sigma_xx).abs() < 1e-7 * peak, "{one:?} {other:?}");
        }
        (alone, peak)
    };
    let (long, peak) = solved("Receding, HalfPlane(shear_modulus: 0.001, poisson: 0.3)");
    let (none, _) = solved("Bonded, HalfPlane(shear_modulus: 25, poisson: 0.3)");
    for (one, other) in long.iter().zip(&none).skip(1) {
        let bent = [one.sigma_xx - long[0].sigma_xx, other.sigma_xx - none[0].sigma_xx];
        // stresses of bending go with the modulus
        let on_face = one.depth == 0.0;
        assert!(!on_face || (bent[0] - bent[1]).abs() < 2e-5 * peak, "{one:?} {other:?}: {bent:?}");
        assert!((one.sigma_yy - other.sigma_yy).abs() < 2e-5 * peak, "{one:?} {other:?}");
    }
}

/// The estimated errors of fields cover the differences from face conditions and from stricter solutions, and are small.
#[test]
fn the_errors_of_stresses_are_estimated() {
    let ground = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, HalfPlane(shear_modulus: 1, poisson: 0.25)";
    let coating = "Exponential(thickness: 0.02, shear_modulus: 1.0, poisson: 0.25, beta: 30.0), Bonded";
    for (load, largest) in [("punch: Flat(half_width: 0.5)", 1e-5), ("punch: Cylinder(radius: 500)", 1e-9)] {
        let text = format!("Scene(geometry: PlaneStrain, {load}, force: 0.002, stack: [{coating}, {ground}])");
        let scene = Scene::from_ron(&text).unwrap();
        let model = Model::new(Stack::from_items(scene.geometry, &scene.stack).unwrap()).unwrap();
        let solved = |tolerance: f64| {
            let options = Options { tolerance };
            model.press_with(&scene.top, scene.force, &options).unwrap()
        };
        let (best, rough) = (solved(1e-12), solved(1e-4));
        let mean = 0.5 * 0.002 / best.contacts()[0].half_length().unwrap();
        let fields = [&best, &rough].map(|solution| model.field(solution).unwrap());
        for (x, depth) in [(0.0, 0.0), (0.1, 0.0), (0.3, 0.0), (0.1, 0.01), (0.2, 0.5), (1.2, 0.3), (0.4, 1.3)] {
            let point = Point { x, depth, layer: None };
            let [found, other] = [&fields[0], &fields[1]].map(|field| field.at(x, depth).unwrap());
            let [error, coarse] = [&fields[0], &fields[1]].map(|field| field.stress_error(&point).unwrap());
            assert!(error > 0.0 && error <= largest * mean, "{load} at {x}, {depth}: {error:e}, mean {mean:e}");
            if depth == 0.0 {
                let missing = (found.sigma_yy + best.contacts()[0].pressure(x)).abs().max(found.sigma_xy.abs());
                assert!(missing <= error, "{load} at {x}: {missing:e}, estimated {error:e}");
            }
            let off = (found.sigma_yy - other.sigma_yy).abs().max((found.sigma_xy - other.sigma_xy).abs());
            assert!(off <= 3.0 * (error + coarse), "{load} at {x}, {depth}: {off:e}, estimated {coarse:e}");
        }
    }
}
