//! Half-lengths, depths and ends prescribed in place of forces, on stacks of all kinds, under one punch and several.
//!
//! Goal: a contact that a force brings about belongs to the same force where its half-length, or the depth of the punch, is prescribed instead; errors are as large as claimed at any
//! tolerance; it takes hardly more equations than a given force; and many of them are interpolated like many forces.
//!
//! Source of the numbers: the solver with a given force, and its approach.
use recede::selftest::{Ranges, about_axis, scene};
use recede::{Error, Force, Model, NoSolution, Options, Pressed, Punches, Scene, Solution};

/// Random scenes of the source paper's kinds in the plane and about an axis, with their solutions, if these are single intervals without warnings.
fn solved(seed: u64, count: u64) -> impl Iterator<Item = (String, Scene, Model, Solution)> {
    let drawn =
        (0..count).filter_map(move |number| Some((number, scene(&Ranges::default(), seed, number).scene().ok()?)));
    let all = drawn.flat_map(|(number, plane)| [(number, "plane", plane.clone()), (number, "axis", about_axis(plane))]);
    all.filter_map(|(number, kind, scene)| {
        let model = Model::new(scene.stack().ok()?).ok()?;
        let solution = model.press(&scene.top, scene.force).ok()?;
        let is_plain =
            solution.warnings().is_empty() && solution.contacts().iter().all(|own| own.half_length().is_some());
        is_plain.then(|| (format!("{kind} {number}"), scene, model, solution))
    })
}

/// What may be prescribed in place of the force of a solution, with the relative error of that.
fn prescribed(scene: &Scene, model: &Model, solution: &Solution) -> Vec<(Force, f64)> {
    let top = &solution.contacts()[0];
    let (half_length, error) = (top.half_length().unwrap(), top.half_length_error().unwrap());
    let mut all = vec![(Force::ForHalfLength(half_length), error / half_length)];
    if let Ok(approach) = model.approach(&scene.top, solution) {
        all.push((Force::ForDepth(approach.value), approach.error / approach.value));
    }
    all
}

#[test]
fn a_contact_belongs_to_the_same_force_whatever_is_prescribed() {
    let mut by_depth = 0;
    for (name, scene, model, expected) in solved(36, 16) {
        for (force, error) in prescribed(&scene, &model, &expected) {
            let found = model.press(&scene.top, force).unwrap();
            let off = (found.force() / expected.force() - 1.0).abs();
            // a force grows no faster than the square of a depth, and under a cone in the plane than any power of a half-length up to some tens
            let allowed = found.force_error() / found.force() + 10.0 * error;
            assert!(off <= allowed, "{name} {force}: {off:e} {allowed:e}");
            assert!(found.force_error() > 0.0 && found.warnings().is_empty(), "{name} {force}: {found:?}");
            let [steps, before] = [&found, &expected].map(Solution::newton_steps);
            assert!(2 * steps <= 3 * before + 8, "{name} {force}: {steps} steps, {before} by force");
            by_depth += usize::from(matches!(force, Force::ForDepth(_)));
        }
    }
    assert!(by_depth >= 8, "{by_depth}");
}

#[test]
fn errors_of_forces_are_as_claimed_at_any_tolerance() {
    for (name, scene, model, expected) in solved(7, 6) {
        for (force, error) in prescribed(&scene, &model, &expected) {
            for tolerance in [1e-3, 1e-6, 1e-8] {
                let found = model.press_with(&scene.top, force, &Options { tolerance }).unwrap();
                let off = (found.force() / expected.force() - 1.0).abs();
                let claimed = found.force_error() / found.force();
                assert!(off <= 10.0 * (claimed + error), "{name} {force} {tolerance:e}: {off:e} {claimed:e}");
                assert!(claimed <= tolerance, "{name} {force} {tolerance:e}: {claimed:e}");
            }
        }
    }
}

#[test]
fn many_of_them_are_interpolated() {
    let scene = Scene::read("examples/scenes/prescribed_depth.ron").unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let many = model.clone().for_many_loads();
    for force in [Force::ForDepth(0.03), Force::ForHalfLength(1.7), Force::Given(0.2)] {
        let [expected, found] = [&model, &many].map(|model| model.press(&scene.top, force).unwrap());
        assert_eq!(found.stats().factorisations, 0, "{force}");
        let off = (found.force() / expected.force() - 1.0).abs();
        let claimed = (found.force_error() + expected.force_error()) / expected.force();
        assert!(off <= claimed + 1e-15 && claimed < 1e-9, "{force}: {off:e} {claimed:e}");
        for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
            let off = (found.central_pressure / expected.central_pressure - 1.0).abs();
            assert!(off < 1e-10, "{force}: {off:e}");
        }
    }
}

/// Punches of which each has something else prescribed in place of the force, as a solution has it: a depth, the left end or the right end of its contact, by a number.
fn each_prescribed(scene: &Scene, model: &Model, solution: &Solution, kind: usize) -> Option<Punches> {
    let places: Vec<f64> = scene.top.punches()?.parts().map(|(pressed, _)| pressed.at()).collect();
    let owner = |own: &recede::Interval| {
        let from = |k: &usize| (places[*k] - 0.5 * (own.left + own.right)).abs();
        (0..places.len()).min_by(|a, b| from(a).total_cmp(&from(b))).unwrap()
    };
    let approaches = model.approaches(&scene.top, solution);
    let all = scene.top.punches()?.parts().enumerate();
    let pressed = |(k, (pressed, _)): (usize, (&Pressed, f64))| {
        let mut own = solution.contacts()[0].intervals().iter().filter(|interval| owner(interval) == k);
        let force = match (kind + k) % 4 {
            0 => Force::ForDepth(approaches.get(k)?.as_ref().ok()?.value),
            1 => Force::ForRight(own.next_back()?.right),
            2 => Force::ForLeft(own.next()?.left),
            _ => Force::Given(solution.punches()[k].force),
        };
        Pressed::new(pressed.shape().clone(), pressed.at(), force, pressed.tilt()).ok()
    };
    Punches::new(&all.map(pressed).collect::<Option<Vec<_>>>()?).ok()
}

/// Layers on a rigid base, over which approaches are defined.
const STACKS: [&str; 4] = [
    "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded, Rigid",
    "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid",
    "Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.25), Receding,
     Exponential(thickness: 1, shear_modulus: 2, poisson: 0.3, beta: -1), Bonded, Rigid",
    "Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.25), Receding,
     Homogeneous(thickness: 0.7, shear_modulus: 2, poisson: 0.3), Receding,
     Exponential(thickness: 1, shear_modulus: 2, poisson: 0.3, beta: -1), Sliding, Rigid",
];
const PUNCHES: [&str; 5] = [
    "(shape: Parabola(radius: 100), at: 0, force: 0.002), (shape: Cylinder(radius: 60), at: 1.5, force: 0.001)",
    "(shape: Parabola(radius: 100), at: -1, force: 0.002, tilt: Fixed(0.001)),
     (shape: Wedge(slope: 0.01), at: 0.3, force: 0.001, tilt: Free(eccentricity: 0.01)),
     (shape: RoundedFlat(half_width: 0.1, radius: 20), at: 1, force: 0.003)",
    "(shape: Flat(half_width: 0.4), at: 0, force: 0.002, tilt: Free(eccentricity: 0.1)),
     (shape: Table([(-1, 0.02), (-0.4, 0.003), (0, 0), (0.6, 0.005), (1, 0.03)]), at: 2, force: 0.003)",
    "(shape: Cylinder(radius: 50), at: 0.7, force: 0.003)",
    "(shape: Polynomial(half_width: 1, heights: [-0.004, 0.01]), at: 0.7, force: 0.003, tilt: Free(eccentricity: 0.02))",
];

#[test]
fn several_punches_have_the_same_forces_whatever_is_prescribed_of_each() {
    let [mut count, mut by_depth] = [0; 2];
    for (stack, punches) in STACKS.iter().flat_map(|stack| PUNCHES.iter().map(move |punches| (stack, punches))) {
        let scene = format!("Scene(geometry: PlaneStrain, punches: [{punches}], stack: [{stack}])");
        let scene = Scene::from_ron(&scene).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let expected = model.press(&scene.top, scene.force).unwrap();
        for kind in 0..4 {
            let prescribed = each_prescribed(&scene, &model, &expected, kind).unwrap();
            let found = match model.press(&prescribed, Force::OfEach) {
                // at a corner a contact ends whatever the force
                Err(Error::NoSolution(NoSolution::Unreachable { .. })) if punches.contains("Flat") => continue,
                found => found.unwrap_or_else(|error| panic!("{error} {prescribed} {}", scene.to_ron())),
            };
            for (found, expected) in found.punches().iter().zip(expected.punches()) {
                // lengths of ten digits, of which each force depends on several
                let off = (found.force / expected.force - 1.0).abs();
                assert!(off < 1e-8, "{off:e} {prescribed} on {stack}");
                count += 1;
            }
            // the last digits of the approaches are the ones that were prescribed
            for (approach, (pressed, _)) in model.approaches(&prescribed, &found).iter().zip(prescribed.parts()) {
                let Force::ForDepth(depth) = pressed.pressed_by() else { continue };
                let found = approach.as_ref().unwrap();
                assert!((found.value - depth).abs() < 10.0 * found.error + 1e-10 * depth, "{found:?} {depth}");
                by_depth += 1;
            }
            assert!(found.force_error() > 0.0 || prescribed.parts().all(|(own, _)| own.pressed_by().given().is_some()));
        }
    }
    assert!(count > 100 && by_depth > 30, "{count} {by_depth}");
}

#[test]
fn what_is_prescribed_of_one_punch_in_a_list_is_what_stands_beside_a_punch() {
    let scene = |what: &str| {
        let scene = format!("Scene(geometry: PlaneStrain, {what}, stack: [{}])", STACKS[1]);
        Scene::from_ron(&scene).unwrap_or_else(|error| panic!("{error}"))
    };
    let force = |what: &str| recede::solve(&scene(what)).unwrap_or_else(|error| panic!("{what}: {error}")).force();
    for (punch, one) in [
        ("depth: 0.001", "at: 0, depth: 0.001"),
        ("depth: 0.001", "at: 3, depth: 0.001"),
        ("half_length: 0.4", "at: 3, right: 3.4"),
        ("half_length: 0.4", "at: 3, left: 2.6"),
    ] {
        let [expected, found] = [
            format!("punch: Cylinder(radius: 60), {punch}"),
            format!("punches: [(shape: Cylinder(radius: 60), {one})]"),
        ]
        .map(|what| force(&what));
        assert!((found / expected - 1.0).abs() < 1e-12, "{one}: {found} {expected}");
        // written and read again
        let text = scene(&format!("punches: [(shape: Cylinder(radius: 60), {one})]")).to_ron();
        assert_eq!(Scene::from_ron(&text).unwrap().to_ron(), text);
        assert!(!text.contains("force"), "{text}");
    }
}

#[test]
fn what_no_force_brings_about_is_named() {
    let error = |one: &str, stack: &str| {
        let scene = format!(
            "Scene(geometry: PlaneStrain, punches: [(shape: Parabola(radius: 50), at: 0, force: 0.001), {one}], stack: [{stack}])"
        );
        let error = Scene::from_ron(&scene).map_err(Error::from).and_then(|scene| recede::solve(&scene)).unwrap_err();
        format!("{error} {}", error.hint().unwrap_or_default())
    };
    let ground = "HalfPlane(shear_modulus: 1, poisson: 0.25)";
    for (one, stack, parts) in [
        (
            "(shape: Cylinder(radius: 60), at: 2, left: 2.1)",
            STACKS[1],
            ["left end of the contact", "between -58.0 and 2.0"],
        ),
        (
            "(shape: Flat(half_width: 0.5), at: 2, right: 2.4)",
            STACKS[1],
            ["right end of the contact", "is 2.5 under any force"],
        ),
        (
            "(shape: Cylinder(radius: 1), at: 2, right: 3.5)",
            STACKS[1],
            ["right end of the contact", "between 2.0 and 3.0"],
        ),
        (
            "(shape: Cylinder(radius: 60), at: 2, depth: 0.01)",
            ground,
            ["over a half-plane the approach is not defined", "`left` or `right`"],
        ),
        (
            "(shape: Cylinder(radius: 60), at: 2)",
            ground,
            ["0 of `force`, `depth`, `left` and `right` are given", "exactly one of them"],
        ),
    ] {
        let error = error(one, stack);
        assert!(parts.iter().all(|part| error.contains(part)), "{error}");
    }
}
