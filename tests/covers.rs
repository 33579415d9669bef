//! Two covered rollers: the layers of the second body are part of the stack that it presses.
use recede::{
    Exponential, Field, HalfPlane, Homogeneous, Interface, Model, Plane, Point, Punch, Scene, Stack, profile_places,
    solve,
};

/// Layers as they are written, with their bases.
const BODIES: [(&str, &str); 4] = [
    ("Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.45)", "Rigid"),
    (
        "Exponential(thickness: 0.7, shear_modulus: 2.0, poisson: 0.3, beta: 1.2), Sliding, Homogeneous(thickness: 0.4, young: 1.5, poisson: 0.2)",
        "Rigid",
    ),
    ("Homogeneous(thickness: 0.3, shear_modulus: 0.4, poisson: 0.49)", "HalfPlane(shear_modulus: 3.0, poisson: 0.3)"),
    ("", "HalfPlane(shear_modulus: 0.8, poisson: 0.1)"),
];

/// A scene in which one of the bodies presses another.
fn scene(geometry: &str, upper: usize, lower: usize, radius: f64, drive: &str) -> Scene {
    let [(layers, core), (below, base)] = [BODIES[upper], BODIES[lower]];
    let below = if below.is_empty() { base.to_owned() } else { format!("{below}, Bonded, {base}") };
    let text = format!(
        "Scene(geometry: {geometry}, punch: Covered(radius: {radius}, layers: [{layers}], core: {core}), {drive}, stack: [{below}])"
    );
    Scene::from_ron(&text).unwrap_or_else(|error| panic!("{error}"))
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
}

fn field(scene: &Scene) -> Field {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    model.field(&model.press(&scene.top, scene.force).unwrap()).unwrap()
}

#[test]
fn bodies_may_change_places() {
    for geometry in ["PlaneStrain", "PlaneStress", "Axisymmetric"] {
        for (one, other) in [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3)] {
            let [found, expected] = [(one, other), (other, one)]
                .map(|(upper, lower)| solve(&scene(geometry, upper, lower, 80.0, "force: 0.01")).unwrap());
            near(found.contacts()[0].reach(), expected.contacts()[0].reach(), 1e-10);
            near(found.contacts()[0].central_pressure, expected.contacts()[0].central_pressure, 1e-9);
        }
    }
}

#[test]
fn equal_covers_are_one_cover_on_a_rigid_plane_with_half_the_approach() {
    for (geometry, body) in [("PlaneStrain", 0), ("PlaneStrain", 1), ("Axisymmetric", 1), ("Axisymmetric", 2)] {
        let both = scene(geometry, body, body, 5000.0, "force: 0.01");
        let (layers, base) = BODIES[body];
        let punch = if geometry == "Axisymmetric" { "Sphere" } else { "Cylinder" };
        let one = format!(
            "Scene(geometry: {geometry}, punch: {punch}(radius: 10000), force: 0.01, stack: [{layers}, Bonded, {base}])"
        );
        let one = Scene::from_ron(&one).unwrap();
        let answers = [&both, &one].map(|scene| {
            let model = Model::new(scene.stack().unwrap()).unwrap();
            let solution = model.press(&scene.top, scene.force).unwrap();
            let approach = model.approach(&scene.top, &solution).unwrap().value;
            let places = profile_places(&solution, Some(3.0), 20);
            let gaps = model.profile(&scene.top, &solution, &places).unwrap().contacts[0].gap.clone().unwrap();
            (solution.contacts()[0].reach(), approach, gaps)
        });
        let [(reach, approach, gaps), (expected, half, one_gap)] = &answers;
        // a circle is a parabola but for the square of the contact over its radius
        near(*reach, *expected, 1e-6);
        near(*approach, 2.0 * half, 1e-6);
        for (gap, half) in gaps.iter().zip(one_gap).filter(|(gap, _)| **gap > 1e-6) {
            near(*gap, 2.0 * half, 1e-4);
        }
    }
}

#[test]
fn without_layers_it_is_an_elastic_cylinder() {
    for (geometry, punch) in [("PlaneStrain", "ElasticCylinder"), ("Axisymmetric", "ElasticSphere")] {
        for lower in [0, 1, 2] {
            let covered = scene(geometry, 3, lower, 60.0, "force: 0.02");
            let (below, base) = BODIES[lower];
            let elastic = format!(
                "Scene(geometry: {geometry}, punch: {punch}(radius: 60, shear_modulus: 0.8, poisson: 0.1), force: 0.02, stack: [{below}, Bonded, {base}])"
            );
            let layer = "layers: [Homogeneous(thickness: 0, shear_modulus: 7, poisson: 0.2)]";
            let thin = Scene::from_ron(&covered.to_ron().replace("layers: []", layer)).unwrap();
            let elastic = solve(&Scene::from_ron(&elastic).unwrap()).unwrap();
            for covered in [&covered, &thin] {
                let covered = solve(covered).unwrap();
                near(covered.contacts()[0].reach(), elastic.contacts()[0].reach(), 1e-10);
            }
        }
    }
}

#[test]
fn both_bodies_carry_the_same_pressure() {
    let one = field(&scene("PlaneStrain", 1, 1, 100.0, "force: 0.01"));
    let second = one.second().unwrap();
    for (x, depth) in [(0.0, 0.0), (0.2, 0.1), (0.4, 0.5), (1.3, 0.9)] {
        let [below, above] = [&one, second].map(|field| field.at(x, depth).unwrap());
        assert!((below.sigma_xx - above.sigma_xx).abs() < 1e-13 && (below.sigma_yy - above.sigma_yy).abs() < 1e-13);
    }
    let other = field(&scene("Axisymmetric", 0, 2, 100.0, "force: 0.01"));
    let faces = [Some(&other), other.second()]
        .map(|field| field.unwrap().points(&[Point { x: 0.1, depth: 0.0, layer: None }]).unwrap()[0]);
    near(faces[0].sigma_yy, faces[1].sigma_yy, 1e-10);
}

#[test]
fn a_depth_is_found_again_and_a_stiff_cover_is_rigid() {
    let by_force = scene("PlaneStrain", 0, 1, 100.0, "force: 0.01");
    let model = Model::new(by_force.stack().unwrap()).unwrap();
    let depth = model.approach(&by_force.top, &model.press(&by_force.top, 0.01).unwrap()).unwrap().value;
    let by_depth = solve(&scene("PlaneStrain", 0, 1, 100.0, &format!("depth: {depth:e}"))).unwrap();
    near(by_depth.force(), 0.01, 1e-10);

    let strip = || Homogeneous::new(1.0, 1.0, 0.3).unwrap();
    let lower = || {
        Stack::builder(Plane::Strain)
            .layer(strip())
            .receding()
            .layer(HalfPlane::new(2.0, 0.3).unwrap())
            .build()
            .unwrap()
    };
    let cover = Stack::builder(Plane::Strain)
        .layer(Exponential::new(1.0, 1e9, 0.3, 0.5).unwrap())
        .bonded()
        .rigid()
        .build()
        .unwrap();
    let [stiff, rigid] = [lower().under(cover).unwrap(), lower()]
        .map(|stack| Model::new(stack).unwrap().press(Punch::parabola(100.0).unwrap(), 0.01).unwrap());
    assert_eq!(stiff.contacts()[1].interface, Interface::Between { above: 1, below: 2 });
    for (stiff, rigid) in stiff.contacts().iter().zip(rigid.contacts()) {
        near(stiff.reach(), rigid.reach(), 1e-8);
    }
}

#[test]
fn scenes_are_written_and_varied() {
    let scene = scene("PlaneStrain", 1, 2, 100.0, "force: 0.01");
    let again = Scene::from_ron(&scene.to_ron()).unwrap();
    assert_eq!(again.to_ron(), scene.to_ron());
    assert_eq!(Scene::from_json(&scene.to_json()).unwrap().to_ron(), scene.to_ron());
    assert!(scene.paths().contains(&"punch.layers[3].young".to_owned()), "{:?}", scene.paths());
    let softer = scene.with("punch.layers[1].shear_modulus", 1.0).unwrap();
    assert!(solve(&softer).unwrap().contacts()[0].reach() > solve(&scene).unwrap().contacts()[0].reach());
    // the layers are part of the stack
    let bare = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.3).unwrap()).build().unwrap());
    let error = bare.unwrap().press(&scene.top, 0.01).unwrap_err();
    assert_eq!(error.to_string(), "the punch is covered, and the stack below was made without its layers");
}
