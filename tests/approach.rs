//! How far a punch sinks, and the stiffness.
use recede::{Approach, ApproachError, Force, Model, Options, Scene};

fn scene(punch: &str, force: f64, stack: &str) -> Scene {
    Scene::from_ron(&format!("Scene(geometry: PlaneStrain, {punch}, force: {force}, stack: [{stack}])")).unwrap()
}

/// To a relative tolerance.
fn approach_to(scene: &Scene, tolerance: f64) -> Approach {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let options = Options { tolerance };
    model.approach(&scene.top, &model.press_with(&scene.top, scene.force, &options).unwrap()).unwrap()
}

fn approach(scene: &Scene) -> Approach {
    approach_to(scene, 1e-10)
}

/// Stacks on a base that stays.
const STACKS: [&str; 6] = [
    "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded, Rigid",
    "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.5), Bonded, Rigid",
    "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid",
    "Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.25), Receding,
     Exponential(thickness: 1, shear_modulus: 2, poisson: 0.3, beta: -1), Bonded, Rigid",
    "Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.25), Receding,
     Homogeneous(thickness: 0.7, shear_modulus: 2, poisson: 0.3), Receding,
     Exponential(thickness: 1, shear_modulus: 2, poisson: 0.3, beta: -1), Sliding, Rigid",
    "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded, Winkler(stiffness: 0.3)",
];

const PUNCHES: [&str; 6] = [
    "punch: Cylinder(radius: 100)",
    "punch: Parabola(radius: 10)",
    "punch: Wedge(slope: 0.01)",
    "punch: RoundedFlat(half_width: 0.3, radius: 20)",
    "punch: Flat(half_width: 0.5)",
    "punch: Table([(0, 0.5), (0.4, 0.501), (2, 0.55)])",
];

#[test]
fn stiffness_is_the_derivative_of_the_force() {
    for stack in STACKS {
        for punch in PUNCHES {
            let at = |force: f64| approach_to(&scene(punch, force, stack), 1e-13);
            let (force, step) = (0.01, 2e-4);
            let middle = at(force);
            // central differences of sixth order
            let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
            let slope: f64 = weights
                .iter()
                .map(|(k, weight)| weight * (at(force + k * step).value - at(force - k * step).value))
                .sum::<f64>()
                / (60.0 * step);
            let (stiffness, error) = (middle.stiffness.value().unwrap(), middle.stiffness.error().unwrap());
            let missed = stiffness * slope - 1.0;
            assert!(missed.abs() < 1e-8, "{missed:e} {punch} {stack}");
            assert!(error < 1e-8 * stiffness, "{error:e} {punch} {stack}");
        }
    }
}

#[test]
fn an_error_is_positive_where_a_pressure_falls_as_the_force_grows() {
    // sheets over felt: between two peaks that move outwards the pressure in the middle falls
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/gallery/sheets_on_felt.ron");
    let scene = Scene::read(file).unwrap();
    let at = |force: f64| scene.with("force", force).unwrap();
    let central = |force: f64| recede::solve(&at(force)).unwrap().contacts()[0].central_pressure;
    assert!(central(0.202) < central(0.198));
    // and near 0.3 it is the same at any force: what a unit force adds is compared with a mean pressure
    for force in [0.2, 0.27, 0.3] {
        let slope = (approach(&at(force + 0.002)).value - approach(&at(force - 0.002)).value) / 0.004;
        let stiffness = approach(&at(force)).stiffness;
        let (value, error) = (stiffness.value().unwrap(), stiffness.error().unwrap());
        assert!(error > 0.0 && error < 1e-6 * value, "{value} {error:e}");
        assert!((value * slope - 1.0).abs() < 1e-4, "{value} {slope}");
    }
}

#[test]
fn estimates_cover_what_a_tighter_tolerance_changes() {
    for stack in STACKS {
        for punch in PUNCHES {
            let best = approach_to(&scene(punch, 0.01, stack), 1e-13);
            for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
                let found = approach_to(&scene(punch, 0.01, stack), tolerance);
                let missed = (found.value - best.value).abs();
                assert!(missed <= found.error + best.error, "{tolerance:e} {missed:e} {found:?} {punch} {stack}");
                let (value, error) = (found.stiffness.value().unwrap(), found.stiffness.error().unwrap());
                let missed = (value - best.stiffness.value().unwrap()).abs();
                assert!(
                    missed <= 2.0 * error + best.stiffness.error().unwrap(),
                    "{tolerance:e} {missed:e} {found:?} {punch} {stack}"
                );
            }
        }
    }
}

/// Long waves bend a laminate of unlike layers that is squeezed so much that its faces move a million million times as far as they come together.
#[test]
fn laminates_that_bend_as_they_are_squeezed_come_together_as_far_to_any_tolerance() {
    for name in ["seed_2_number_91", "seed_30_number_269"] {
        let path = format!("{}/tests/data/hard/{name}.ron", env!("CARGO_MANIFEST_DIR"));
        let scene = Scene::read(path).unwrap();
        let [rough, best] = [1e-8, 1e-10].map(|tolerance| approach_to(&scene, tolerance));
        let missed = (rough.value - best.value).abs();
        assert!(missed <= rough.error + best.error && best.error < 1e-8 * best.value, "{name}: {rough:?} {best:?}");
    }
}

/// How far the half-length, the approach and the stiffness of a parabola x²/2R on a bonded layer of unit thickness and modulus are from
/// those of the thin-layer limit, relative.
fn off_the_thin_limit(poisson: f64, force: f64, [a, depth, stiffness]: [f64; 3]) -> [f64; 3] {
    let layer = format!("Homogeneous(thickness: 1, shear_modulus: 1, poisson: {poisson}), Bonded, Rigid");
    let scene = scene("punch: Parabola(radius: 1e4)", force, &layer);
    let (found, solution) = (approach(&scene), recede::solve(&scene).unwrap());
    let half_length = solution.contacts()[0].half_length().unwrap();
    [half_length / a - 1.0, found.value / depth - 1.0, found.stiffness.value().unwrap() / stiffness - 1.0]
}

/// Johnson 1985, section 5.8.
#[test]
fn thin_layers_approach_their_limits_in_the_first_power_of_the_thickness() {
    let radius = 1e4;
    // compressible: like springs of the stiffness K = 2μ(1 − ν)/(1 − 2ν)/h each, P = 2Ka³/3R, δ = a²/2R
    let springs = |poisson: f64, a: f64| {
        let k = 2.0 * (1.0 - poisson) / (1.0 - 2.0 * poisson);
        off_the_thin_limit(poisson, 2.0 * k * a.powi(3) / (3.0 * radius), [a, a * a / (2.0 * radius), 2.0 * k * a])
    };
    // incompressible: it is squeezed out, p'' = −3μ(δ − x²/2R)/h³, so that P = 2μa⁵/(15Rh³), δ = a²/6R
    let squeezed = |a: f64| {
        let limits = [a, a * a / (6.0 * radius), 2.0 * a.powi(3)];
        off_the_thin_limit(0.5, 2.0 * a.powi(5) / (15.0 * radius), limits)
    };
    let limits: [&dyn Fn(f64) -> [f64; 3]; 3] = [&|a| springs(0.0, a), &|a| springs(0.25, a), &squeezed];
    for (k, limit) in limits.into_iter().enumerate() {
        for (rough, fine) in limit(40.0).into_iter().zip(limit(80.0)) {
            assert!(fine.abs() < 0.05, "{k}: {fine}");
            // some are off by higher powers
            assert!(rough / fine > 1.8, "{k}: {rough} {fine}");
        }
    }
}

#[test]
fn springs_give_way_in_closed_form() {
    // a layer that is far wider than thick is squeezed in series with the springs below it
    let (k, force, half_width) = (0.3, 0.01, 200.0);
    for (poisson, interface) in [(0.0, "Sliding"), (0.25, "Bonded")] {
        let stack = format!(
            "Homogeneous(thickness: 1, shear_modulus: 1, poisson: {poisson}), {interface}, Winkler(stiffness: {k})"
        );
        let scene = scene(&format!("punch: Flat(half_width: {half_width})"), force, &stack);
        let found = approach(&scene);
        let layer = (1.0 - poisson) / 2.0;
        let expected = force / (2.0 * half_width) * (1.0 / k + layer);
        assert!((found.value / expected - 1.0).abs() < 0.02, "{poisson}: {} {expected}", found.value);
    }
}

#[test]
fn an_approach_is_defined_where_the_base_stays() {
    let undefined = |scene: &Scene| {
        let model = Model::new(scene.stack().unwrap()).unwrap();
        model.approach(&scene.top, &model.press(&scene.top, scene.force).unwrap()).unwrap_err()
    };
    let layer = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded";
    let ground = format!("{layer}, HalfPlane(shear_modulus: 1, poisson: 0.25)");
    let rigid = format!("{layer}, Rigid");
    assert_eq!(undefined(&scene(PUNCHES[0], 0.01, &ground)), ApproachError::HalfPlane);
    let elastic = "punch: ElasticCylinder(radius: 100, shear_modulus: 1, poisson: 0.25)";
    assert_eq!(undefined(&scene(elastic, 0.01, &rigid)), ApproachError::ElasticPunch);
    assert_eq!(undefined(&scene("load: Uniform(half_width: 1)", 0.01, &rigid)), ApproachError::Load);
}

/// A punch that touches on two intervals, at the bottom of its profile: its approach is counted from there.
#[test]
fn the_approach_is_that_of_the_lowest_point() {
    let layer = "Homogeneous(thickness: 0.01, shear_modulus: 1, poisson: 0.25), Sliding, Rigid";
    // heights 0, −0.001 at x = 1, and up again
    let double = scene("punch: Polynomial(half_width: 1, heights: [-0.002, 0.001])", 1e-6, layer);
    let found = approach(&double);
    assert!(found.value > 0.0 && found.value < 1e-5, "{found:?}");
    let [more, less] = [1.0, -1.0].map(|sign| approach(&double.with("force", 1e-6 + sign * 1e-9).unwrap()).value);
    let slope = (more - less) / 2e-9;
    assert!((found.stiffness.value().unwrap() * slope - 1.0).abs() < 1e-6, "{found:?} {slope}");
    let model = Model::new(double.stack().unwrap()).unwrap();
    let solution = model.press(&double.top, double.force).unwrap();
    assert_eq!(solution.contacts()[0].intervals().len(), 2);
}

#[test]
fn a_prescribed_depth_is_met() {
    for stack in STACKS {
        for punch in PUNCHES {
            for force in [1e-4, 0.02] {
                let pressed = scene(punch, force, stack);
                let model = Model::new(pressed.stack().unwrap()).unwrap();
                let depth = approach(&pressed).value;
                let found = model.press(&pressed.top, Force::ForDepth(depth)).unwrap();
                let missed = found.force() / force - 1.0;
                assert!(missed.abs() < 1e-9, "{missed:e} {force} {punch} {stack}");
                assert!(found.force_error() > 0.0 && found.force_error() < 1e-9 * force, "{found:?}");
            }
        }
    }
}

#[test]
fn a_scene_has_a_depth_where_one_is_defined() {
    let text = |what: &str, base: &str| {
        let layer = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded";
        format!("Scene(geometry: PlaneStrain, punch: Parabola(radius: 10), {what}, stack: [{layer}, {base}])")
    };
    let scene = Scene::from_ron(&text("depth: 0.01", "Rigid")).unwrap();
    assert_eq!(scene.force, Force::ForDepth(0.01));
    assert_eq!(Scene::from_ron(&scene.to_ron()).unwrap().force, scene.force);
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = recede::solve(&scene).unwrap();
    assert!((model.approach(&scene.top, &solution).unwrap().value / 0.01 - 1.0).abs() < 1e-10);

    let both = Scene::from_ron(&text("force: 1, depth: 0.01", "Rigid")).unwrap_err().to_string();
    assert!(both.contains("the scene has `force` and `depth`"), "{both}");
    let ground = Scene::from_ron(&text("depth: 0.01", "HalfPlane(shear_modulus: 1, poisson: 0.25)")).unwrap();
    let refused = recede::solve(&ground).unwrap_err();
    assert!(refused.is_input() && refused.to_string().contains("over a half-plane"), "{refused}");
    let wide = Scene::from_ron(&text("depth: 1", "Rigid").replace("Parabola(radius: 10)", "Cylinder(radius: 0.001)"));
    let refused = recede::solve(&wide.unwrap()).unwrap_err();
    assert!(refused.is_input() && refused.to_string().contains("approach"), "{refused}");
}

#[test]
fn a_punch_that_may_turn_sinks_as_far_as_one_that_has_no_reason_to() {
    for stack in STACKS {
        for punch in PUNCHES {
            let even = scene(punch, 0.01, stack);
            let shape = punch.trim_start_matches("punch: ");
            let free = format!("(shape: {shape}, at: 0, force: 0.01, tilt: Free(eccentricity: 0))");
            let free = Scene::from_ron(&format!("Scene(geometry: PlaneStrain, punches: [{free}], stack: [{stack}])"));
            let free = free.unwrap();
            let expected = approach(&even);
            let model = Model::new(free.stack().unwrap()).unwrap();
            let found = model.approaches(&free.top, &model.press(&free.top, free.force).unwrap());
            let found = found[0].clone().unwrap();
            let off = (found.value - expected.value).abs();
            assert!(off <= found.error + expected.error, "{found:?} {expected:?} {punch} {stack}");
            assert!(off < 5e-11 * expected.value, "{found:?} {expected:?} {punch} {stack}");
        }
    }
}

/// Where weights let layers come apart, the approach goes on from the one below the critical force, and tends to the one of layers without weight.
#[test]
fn openings_do_not_stop_the_approach() {
    let scene = |weight: f64, force: f64| {
        let text = format!(
            "Scene(geometry: PlaneStrain, punch: Parabola(radius: 1000), force: {force:?}, stack: [
            Homogeneous(thickness: 1, shear_modulus: 0.75, poisson: 0.25, specific_weight: {weight:?}), Receding, Rigid])"
        );
        Scene::from_ron(&text).unwrap()
    };
    let sunk = |weight: f64, force: f64| {
        let scene = scene(weight, force);
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let found = model.approach(&scene.top, &solution).unwrap();
        assert_eq!(model.approaches(&scene.top, &solution), [Ok(found)]);
        let is_open = solution.closed().iter().any(|own| !own.openings.is_empty());
        assert!(found.error < 1e-8 * found.value, "{found:?}");
        let critical = model.separation(&scene.top, &solution).unwrap().map(|own| own.critical_force);
        (found.value, is_open, critical)
    };
    let force = 1e-3;
    let (alone, _, _) = sunk(0.0, force);
    // the more weight, the less the punch sinks
    let found = [1e-6, 1e-7, 1e-8, 1e-9].map(|weight| sunk(weight, force));
    assert!(found.iter().all(|(_, is_open, _)| *is_open));
    let less = found.map(|(value, ..)| alone - value);
    assert!(less.windows(2).all(|pair| pair[1] > 0.0 && pair[1] < 0.7 * pair[0]), "{less:?} {alone}");
    // just below and just above the critical force
    let critical = found[0].2.unwrap();
    let [(below, closed, _), (above, open, _)] = [1.0 - 1e-5, 1.0 + 1e-5].map(|part| sunk(1e-6, part * critical));
    assert!(!closed && open && above > below && above / below - 1.0 < 3e-5, "{below} {above}");
}

/// Punches beside each other, turned or not: over layers that recede, over layers that weights keep closed, and over such layers where these come apart.
const BESIDE: [&str; 3] = [
    "(shape: Parabola(radius: 100), at: -0.8, force: 0.004), (shape: Flat(half_width: 0.3), at: 0.7, force: 0.003, tilt: Free(eccentricity: 0.0))],
     stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding,
     Homogeneous(thickness: 0.7, shear_modulus: 2, poisson: 0.3), Bonded, Rigid])",
    "(shape: Cylinder(radius: 100), at: -1, force: 1e-5), (shape: Parabola(radius: 50), at: 1, force: 2e-5)],
     stack: [Homogeneous(thickness: 1, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1e-6), Receding, Rigid])",
    "(shape: Cylinder(radius: 100), at: -1, force: 1e-4), (shape: Parabola(radius: 50), at: 1, force: 2e-4, tilt: Fixed(1e-4))],
     stack: [Homogeneous(thickness: 1, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1e-6), Receding,
     Homogeneous(thickness: 0.5, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1e-6), Receding, Rigid])",
];

#[test]
fn each_punch_has_a_stiffness_and_sinks_as_far_as_the_top_face_says() {
    for (number, text) in BESIDE.iter().enumerate() {
        let scene = Scene::from_ron(&format!("Scene(geometry: PlaneStrain, punches: [{text}")).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solve = |scene: &Scene| model.press(&scene.top, scene.force).unwrap();
        let all = |scene: &Scene| -> Vec<Approach> {
            model.approaches(&scene.top, &solve(scene)).into_iter().map(Result::unwrap).collect()
        };
        let (solution, found) = (solve(&scene), all(&scene));
        let is_open = solution.closed().iter().any(|own| !own.openings.is_empty());
        assert_eq!(is_open, number == 2);
        let field = model.field(&solution).unwrap();
        let mut by_others = Vec::new();
        for (punch, (pressed, _)) in scene.top.punches().unwrap().parts().enumerate() {
            let own = found[punch];
            let force = pressed.pressed_by().given().unwrap();
            let step = 1e-4 * force;
            let with =
                |sign: f64| all(&scene.with(&format!("punches[{}].force", punch + 1), force + sign * step).unwrap());
            let (more, less) = (with(1.0), with(-1.0));
            let slope = |k: usize| (more[k].value - less[k].value) / (2.0 * step);
            assert!((own.stiffness.value().unwrap() * slope(punch) - 1.0).abs() < 1e-5, "{own:?} {punch} {text}");
            by_others.push(slope(1 - punch));
            let (contact, carried) = (&solution.contacts()[0], solution.punches()[punch]);
            let one = contact.intervals()[punch];
            for part in [0.2, 0.5, 0.7] {
                let x = one.left + part * (one.right - one.left);
                let from_tip = x - pressed.at();
                let height = pressed.shape().profile(from_tip) + carried.tilt * from_tip;
                let v = field.at(x, 0.0).unwrap().v;
                assert!((height - own.value - v).abs() < 1e-8 * own.value, "{x} {v} {own:?} {text}");
            }
        }
        // a force on the tip of one punch moves the other one as far as the same force there moves this one
        assert!((by_others[0] / by_others[1] - 1.0).abs() < 1e-4, "{by_others:?} {text}");
    }
}

/// Layers that come apart under a punch that sinks as far as prescribed.
#[test]
fn a_depth_leads_back_to_the_force_where_layers_come_apart() {
    for text in
        ["punch: Parabola(radius: 1000), force: 2e-4", "punch: RoundedFlat(half_width: 0.3, radius: 200), force: 3e-4"]
    {
        let stack =
            "Homogeneous(thickness: 1, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1e-6), Receding, Rigid";
        let scene = Scene::from_ron(&format!("Scene(geometry: PlaneStrain, {text}, stack: [{stack}])")).unwrap();
        let (model, expected) = (Model::new(scene.stack().unwrap()).unwrap(), recede::solve(&scene).unwrap());
        assert!(!expected.closed()[0].openings.is_empty());
        let depth = model.approach(&scene.top, &expected).unwrap().value;
        let found = model.press(&scene.top, Force::ForDepth(depth)).unwrap();
        assert!((found.force() / expected.force() - 1.0).abs() < 1e-9, "{} {text}", found.force());
        assert!(found.force_error() < 1e-8 * found.force());
        let [found, expected] = [&found, &expected].map(|solution| &solution.closed()[0].openings[0]);
        assert!((found.left / expected.left - 1.0).abs() < 1e-9);
    }
}
