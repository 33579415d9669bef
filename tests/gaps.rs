//! Gaps between layers before anything is loaded.
//!
//! Goal: a receding contact has a profile, like the contact of a punch. Half-lengths and pressures equal the numbers of an independent program, and tend to Hertz's contact and to the contact of layers
//! without gaps; contacts are found with and without symmetry, by force and by depth; fields, profiles, checks and reports see the gap.
use recede::{Error, Force, HalfPlane, Homogeneous, Model, NoSolution, Plane, Punch, Scene, Solution, Stack};

/// A strip of thickness 1 on a base, with a gap below it.
fn scene(top: &str, gap: &str, base: &str) -> Scene {
    let gap = if gap.is_empty() { "Receding".to_owned() } else { format!("Receding(gap: {gap})") };
    let text = format!(
        "Scene(geometry: PlaneStrain, {top}, stack: [Homogeneous(thickness: 1, shear_modulus: 0.7, poisson: 0.3), {gap}, {base}])"
    );
    Scene::from_ron(&text).unwrap_or_else(|error| panic!("{error}"))
}

const GROUND: &str = "HalfPlane(shear_modulus: 0.8, poisson: 0.2)";

fn solve(scene: &Scene) -> Solution {
    recede::solve(scene).unwrap_or_else(|error| panic!("{error} {}", scene.to_ron()))
}

fn half_lengths(top: &str, gap: &str) -> Vec<f64> {
    solve(&scene(top, gap, GROUND)).contacts().iter().map(|contact| contact.half_length().unwrap()).collect()
}

#[test]
fn contacts_are_those_of_an_independent_program() {
    let close = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 2e-10, "{found} {expected}");
    let pressed = |top: &str, gap: &str| solve(&scene(top, gap, GROUND)).contacts().to_vec();
    let line = pressed("load: Line, force: 0.002", "Parabola(radius: 100)");
    close(line[1].half_length().unwrap(), 0.45547232440);
    close(line[1].central_pressure, 0.0028469518);
    let line = pressed("load: Line, force: 0.02", "Parabola(radius: 1000)");
    close(line[1].half_length().unwrap(), 1.26394873539);
    let punch = pressed("punch: Parabola(radius: 100), force: 0.002", "Parabola(radius: 100)");
    close(punch[0].half_length().unwrap(), 0.33100230621);
    close(punch[1].half_length().unwrap(), 0.46235337006);
    close(punch[0].central_pressure, 0.003867165389);
    close(punch[1].central_pressure, 0.002791701904);
}

#[test]
fn wide_gaps_are_closed_as_hertz_says_and_narrow_ones_not_at_all() {
    // c = (1 − ν)/μ of both faces
    let compliance = 0.7 / 0.7 + 0.8 / 0.8;
    let relative = |force: f64| {
        let half = half_lengths(&format!("load: Line, force: {force}"), "Parabola(radius: 10)")[1];
        half / (2.0 * force * 10.0 * compliance / std::f64::consts::PI).sqrt() - 1.0
    };
    let errors = [1e-4, 1e-5, 1e-6].map(|force| relative(force).abs());
    // the pressure that the strip hands down from a line at a distance h is not a wave as long as the contact: errors fall with its square
    assert!(errors[2] < 1e-4 && errors.windows(2).all(|pair| (8.0..12.0).contains(&(pair[0] / pair[1]))), "{errors:?}");
    let receding = half_lengths("load: Line, force: 1", "")[1];
    let errors = [1e6, 1e7, 1e8].map(|radius| {
        (half_lengths("load: Line, force: 1", &format!("Parabola(radius: {radius})"))[1] / receding - 1.0).abs()
    });
    assert!(errors[2] < 1e-6 && errors.windows(2).all(|pair| (8.0..12.0).contains(&(pair[0] / pair[1]))), "{errors:?}");
}

#[test]
fn only_the_product_of_force_and_radius_matters_under_a_line_load() {
    let half = |force: f64, radius: f64| {
        half_lengths(&format!("load: Line, force: {force}"), &format!("Parabola(radius: {radius})"))[1]
    };
    for (force, radius) in [(0.02, 30.0), (1e-3, 600.0), (6.0, 0.1)] {
        assert!((half(force, radius) / half(0.006, 100.0) - 1.0).abs() < 1e-11);
    }
}

#[test]
fn a_parabola_below_a_loose_strip_is_the_same_anywhere() {
    // moved by e, x²/2R is x²/2R, a rotation and a translation
    let ends = |at: f64| {
        let load = format!("loads: [(load: Uniform(half_width: 0.1), at: {at}, force: 0.002)]");
        let found = solve(&scene(&load, "Parabola(radius: 100)", GROUND)).contacts()[1].intervals()[0];
        [found.left - at, found.right - at]
    };
    let expected = ends(0.0);
    for at in [1e-9, -0.3, 2.0] {
        let found = ends(at);
        assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 1e-11), "{at}: {found:?} {expected:?}");
    }
}

#[test]
fn gaps_of_all_shapes_are_closed_with_and_without_symmetry() {
    let shapes = [
        "Parabola(radius: 100)",
        "Cylinder(radius: 3)",
        "Wedge(slope: 0.002)",
        "Power(exponent: 3, half_width: 1, height: 0.01)",
        "Polynomial(half_width: 1, heights: [-1e-4, 1e-3])",
        // touched on two intervals
        "Polynomial(half_width: 1, heights: [-0.1, 0.1])",
        "RoundedFlat(half_width: 0.2, radius: 50)",
        "Flat(half_width: 0.4)",
        "Table([(0, 0), (0.5, 0.002), (1.5, 0.02)])",
    ];
    for gap in shapes {
        let even = scene("punch: Parabola(radius: 100), force: 0.002", gap, GROUND);
        let free = "punches: [(shape: Parabola(radius: 100), at: 0, force: 0.002, tilt: Free(eccentricity: 0))]";
        let [even, free] = [even, scene(free, gap, GROUND)].map(|scene| {
            let solution = solve(&scene);
            let model = Model::new(scene.stack().unwrap()).unwrap();
            for own in model.collocate(&scene.top, &solution).unwrap() {
                // pressures under kinks are not polynomials
                assert!(own.residual < 1e-7, "{gap}: {own:?}");
            }
            solution
        });
        for (even, free) in even.contacts().iter().zip(free.contacts()) {
            let [right, other] = [even, free].map(|contact| contact.intervals().last().unwrap().right);
            assert!((right / other - 1.0).abs() < 1e-9, "{gap}: {right} {other}");
        }
    }
    let uneven = "Table([(-1, 0.002), (0, 0), (0.5, 0.001), (1, 0.005)])";
    let mirrored = "Table([(-1, 0.005), (-0.5, 0.001), (0, 0), (1, 0.002)])";
    let [one, other] = [uneven, mirrored]
        .map(|gap| solve(&scene("punch: Parabola(radius: 100), force: 0.002", gap, GROUND)).contacts().to_vec());
    for (one, other) in one.iter().zip(&other) {
        let [one, other] = [one, other].map(|contact| contact.intervals()[0]);
        assert!((one.left + other.right).abs() < 1e-10 && (one.right + other.left).abs() < 1e-10);
        assert!((one.left + one.right).abs() > 1e-3);
    }
}

#[test]
fn fields_profiles_and_approaches_see_the_gap() {
    for (top, gap) in [
        ("punch: Parabola(radius: 100), force: 0.002", "Parabola(radius: 100)"),
        ("punch: Parabola(radius: 100), force: 0.002", "Table([(-1, 0.002), (0, 0), (0.5, 0.001), (1, 0.005)])"),
    ] {
        let scene = scene(top, gap, "Homogeneous(thickness: 2, shear_modulus: 0.8, poisson: 0.2), Bonded, Rigid");
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let [left, right] = [solution.contacts()[1].intervals()[0]].map(|own| [own.left, own.right])[0];
        let x: Vec<f64> = (0..=20).map(|k| -0.95 + 0.095 * f64::from(k)).collect();
        let profile = model.profile(&scene.top, &solution, &x).unwrap();
        let field = model.field(&solution).unwrap();
        let shape = scene.stack().unwrap().laminates()[0].gap().unwrap().clone();
        for (x, gap) in x.iter().zip(profile.contacts[1].gap.as_ref().unwrap()) {
            let [above, below] = [1, 2].map(|layer| field.at_layer(*x, 1.0, layer).unwrap().v);
            let apart = shape.profile(*x) + above - below;
            assert!((apart - gap).abs() < 1e-12, "{x}: {apart:e} {gap:e}");
            let is_closed = left <= *x && *x <= right;
            assert!(if is_closed { *gap == 0.0 } else { *gap > 0.0 }, "{x}: {gap}");
        }
        // a depth leads back to the force
        let approach = model.approaches(&scene.top, &solution)[0].clone().unwrap();
        let found = model.press(&scene.top, Force::ForDepth(approach.value)).unwrap();
        assert!((found.force() / solution.force() - 1.0).abs() < 1e-9, "{} {}", found.force(), solution.force());
        // and its derivative to the stiffness
        let at =
            |force: f64| model.approaches(&scene.top, &model.press(&scene.top, force).unwrap())[0].clone().unwrap();
        let slope = 2e-6 / (at(0.002 + 1e-6).value - at(0.002 - 1e-6).value);
        let stiffness = approach.stiffness.value().unwrap_or(slope);
        assert!((stiffness / slope - 1.0).abs() < 1e-6, "{stiffness} {slope}");
    }
}

#[test]
fn about_an_axis_a_gap_is_closed_as_by_hertz_and_by_punches_of_the_same_shape() {
    let radius = |force: f64| {
        let text = format!(
            "Scene(geometry: Axisymmetric, load: Point, force: {force}, stack: [Homogeneous(thickness: 1, shear_modulus: 0.7, poisson: 0.3),
             Receding(gap: Sphere(radius: 1)), {GROUND}])"
        );
        let modulus = (0.7f64 / 1.4 + 0.8 / 1.6).recip();
        solve(&Scene::from_ron(&text).unwrap()).contacts()[1].half_length().unwrap() / (0.75 * force / modulus).cbrt()
            - 1.0
    };
    let errors = [1e-6, 1e-9].map(|force| radius(force).abs());
    assert!(errors[0] < 1e-3 && errors[1] < 2e-2 * errors[0], "{errors:?}");
}

#[test]
fn a_gap_is_written_read_varied_and_told_from_no_gap() {
    let scene = scene("punch: Parabola(radius: 100), force: 0.002", "Parabola(radius: 100)", GROUND);
    let text = scene.to_ron();
    assert!(text.contains("        Receding(gap: Parabola(radius: 100.0)),\n"), "{text}");
    assert_eq!(Scene::from_ron(&text).unwrap().to_ron(), text);
    assert_eq!(Scene::from_json(&scene.to_json()).unwrap().to_ron(), text);
    let wider = scene.with("interface[1].gap.radius", 50.0).unwrap();
    assert!(solve(&wider).contacts()[1].half_length() < solve(&scene).contacts()[1].half_length());
    assert!(scene.stack().unwrap().to_string().contains("receding 1|2, gap Parabola(radius: 100.0)"));
    let built = Stack::builder(Plane::Strain)
        .layer(Homogeneous::new(1.0, 0.7, 0.3).unwrap())
        .receding_from(Punch::parabola(100.0).unwrap())
        .layer(HalfPlane::new(0.8, 0.2).unwrap())
        .build()
        .unwrap();
    let model = Model::new(built).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    assert_eq!(solution.contacts(), solve(&scene).contacts());
    // a solution belongs to a stack with the same gap
    let other = Model::new(wider.stack().unwrap()).unwrap();
    assert!(other.field(&solution).is_err() && model.field(&solution).is_ok());
}

#[test]
fn what_is_no_gap_is_named() {
    let error = |gap: &str| {
        let text = format!(
            "Scene(geometry: PlaneStrain, punch: Parabola(radius: 100), force: 0.02, stack: [
             Homogeneous(thickness: 1, shear_modulus: 0.7, poisson: 0.3), {gap}, {GROUND}])"
        );
        Scene::from_ron(&text).map_err(Error::from).and_then(|scene| recede::solve(&scene)).unwrap_err()
    };
    for (gap, part) in [
        ("Receding(gap: ElasticCylinder(radius: 1, young: 1, poisson: 0.3))", "the gap below layer 1 is elastic"),
        ("Receding(gap: Sphere(radius: 1))", "Sphere"),
        ("Receding(gap: Parabola(radius: -1))", "`radius` of the gap below layer 1"),
        ("Receding(clearance: Parabola(radius: 1))", "the interface below layer 1 has no field `clearance`"),
        ("Bonded(gap: Parabola(radius: 1))", "`Bonded` has no fields"),
        (
            "Receding(gap: Parabola(radius: 9)), Homogeneous(thickness: 0, shear_modulus: 1, poisson: 0.3), Receding(gap: Parabola(radius: 9))",
            "two gaps",
        ),
    ] {
        let error = error(gap).to_string();
        assert!(error.contains(part), "{gap}: {error}");
    }
    let ends = error("Receding(gap: Table([(0, 0), (0.3, 0.001)]))");
    assert!(matches!(ends, Error::NoSolution(NoSolution::GapEnds { edge: 0.3, .. })), "{ends}");
}
