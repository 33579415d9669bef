//! The largest stresses where they are limits from one side, where they are infinite, and where short waves are too many to be summed.
use std::f64::consts::PI;
use std::path::Path;

use recede::selftest::{Ranges, about_axis, scene_of_any_kind};
use recede::{Extreme, Extremes, Field, Model, Point, Scene, Solution};

fn solved(scene: &Scene) -> (Solution, Field) {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    (solution, field)
}

fn extremes(text: &str) -> Extremes {
    solved(&Scene::from_ron(text).unwrap()).1.extremes().unwrap()
}

fn on_half_space(geometry: &str, load: &str, poisson: f64) -> String {
    format!(
        "Scene(geometry: {geometry}, {load}, force: 0.001, stack: [HalfPlane(shear_modulus: 1, poisson: {poisson})])"
    )
}

#[track_caller]
fn close(found: Extreme, expected: f64, tolerance: f64, what: &str) {
    let off = (found.value - expected).abs();
    assert!(off <= tolerance * expected, "{what}: {found:?} is not {expected:e}");
}

/// Outside any load about an axis the radial stress on the face is that of its resultant: (1 − 2ν) F/(2πr²).
#[test]
fn beside_a_load_the_tension_is_that_of_its_force() {
    let loads = [
        "load: Uniform(radius: 0.7)",
        "load: Elliptic(radius: 0.7)",
        "load: Parabolic(radius: 0.7)",
        "load: Ring(radius: 0.5, half_width: 0.2)",
        "punch: Flat(radius: 0.7)",
    ];
    for (load, poisson) in loads.into_iter().flat_map(|load| [0.0, 0.2, 0.45].map(|poisson| (load, poisson))) {
        let found = extremes(&on_half_space("Axisymmetric", load, poisson)).tension.unwrap();
        let expected = (1.0 - 2.0 * poisson) * 1e-3 / (2.0 * PI * 0.7 * 0.7);
        close(found, expected, 1e-9, &format!("{load}, {poisson}"));
        assert!((found.x - 0.7).abs() < 1e-9 && found.depth == 0.0, "{load}: {found:?}");
        assert!((found.value - expected).abs() <= found.error, "{load}: {found:?} {expected:e}");
    }
    // Hertz: (1 − 2ν) p₀/3 at the end of the contact
    let (solution, field) =
        solved(&Scene::from_ron(&on_half_space("Axisymmetric", "punch: Parabola(radius: 20)", 0.3)).unwrap());
    let expected = 0.4 / 3.0 * solution.contacts()[0].central_pressure;
    close(field.extremes().unwrap().tension.unwrap(), expected, 1e-9, "Hertz");
}

/// Under a uniform strip stresses depend on the angle under which it is seen alone, so also at its ends from any direction.
#[test]
fn at_the_ends_of_a_uniform_strip_stresses_depend_on_the_direction() {
    let pressure = 1e-3 / 1.4;
    for poisson in [0.0, 0.2, 0.45] {
        let text = on_half_space("PlaneStrain", "load: Uniform(half_width: 0.7)", poisson);
        let found = extremes(&text).layers[0].von_mises.unwrap();
        let at =
            |angle: f64| (3.0 * angle.sin().powi(2) + ((1.0 - 2.0 * poisson) * angle).powi(2)).sqrt() * pressure / PI;
        let expected = (0..=100_000).map(|k| at(PI * f64::from(k) / 1e5)).fold(0.0, f64::max);
        close(found, expected, 1e-6, &format!("von Mises, {poisson}"));
        let largest = solved(&Scene::from_ron(&text).unwrap()).1.max_shear().unwrap();
        assert!((largest.value * PI / pressure - 1.0).abs() < 1e-6, "{largest:?}");
    }
}

/// What is infinite is said to be, at its place, and only that.
#[test]
fn next_to_singular_points_stresses_are_infinite() {
    // load, Poisson's ratio, whether the tension is infinite, and von Mises' stress
    let cases = [
        ("Axisymmetric", "load: Point", 0.3, true, true),
        ("Axisymmetric", "load: Point", 0.5, false, true),
        ("PlaneStrain", "load: Line", 0.3, false, true),
        ("PlaneStress", "load: Line", 0.3, false, true),
        ("PlaneStrain", "punch: Flat(half_width: 0.7)", 0.3, false, true),
        ("Axisymmetric", "punch: Flat(radius: 0.7)", 0.3, false, true),
        ("PlaneStrain", "punch: Wedge(slope: 0.01)", 0.3, false, true),
        ("PlaneStrain", "punch: Wedge(slope: 0.01)", 0.5, false, false),
        ("PlaneStrain", "load: Uniform(half_width: 0.7)", 0.3, false, false),
        ("PlaneStrain", "load: Elliptic(half_width: 0.7)", 0.3, false, false),
    ];
    for (geometry, load, poisson, tension, von_mises) in cases {
        let found = extremes(&on_half_space(geometry, load, poisson));
        let is_infinite = |found: Option<Extreme>| found.is_some_and(|found| found.value.is_infinite());
        let at = found.layers[0].von_mises;
        assert_eq!(
            (is_infinite(found.tension), is_infinite(at)),
            (tension, von_mises),
            "{geometry}, {load}, {poisson}: {found:?}"
        );
        let corner = if load.contains("Flat") { 0.7 } else { 0.0 };
        assert!(!von_mises || at.is_some_and(|at| (at.x - corner).abs() < 1e-12 && at.depth == 0.0), "{found:?}");
    }
}

const LAYERS: &str = "stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.3), Bonded, \
    Homogeneous(thickness: 1, shear_modulus: 2, poisson: 0.3), Bonded, \
    Homogeneous(thickness: 1, shear_modulus: 0.5, poisson: 0.3), Bonded, Rigid]";

/// Layers below a force have finite stresses, those of a narrow load.
#[test]
fn layers_below_a_force_have_their_stresses() {
    for (geometry, force, narrow) in
        [("Axisymmetric", "Point", "Uniform(radius: 0.001)"), ("PlaneStrain", "Line", "Uniform(half_width: 0.001)")]
    {
        let [point, disc] = [force, narrow]
            .map(|load| extremes(&format!("Scene(geometry: {geometry}, load: {load}, force: 0.001, {LAYERS})")));
        let all = |found: &Extremes| {
            let layers = found.layers.iter().skip(1).map(|layer| layer.von_mises);
            layers.chain(found.bonds.iter().flat_map(|bond| [bond.shear, bond.tension])).collect::<Vec<_>>()
        };
        let pairs: Vec<_> = all(&point).into_iter().zip(all(&disc)).collect();
        assert_eq!(pairs.len(), 2 + 2 * 3);
        for (point, disc) in pairs {
            assert!(point.is_some() == disc.is_some() && point.is_none_or(|found| found.value.is_finite()));
            if let (Some(point), Some(disc)) = (point, disc) {
                close(point, disc.value, 1e-5, geometry);
            }
        }
        if force == "Point" {
            // of an independent program
            let found = all(&point).into_iter().map(|found| found.unwrap()).collect::<Vec<_>>();
            close(found[0], 5.52e-4, 1e-3, "layer 2");
            close(found[1], 1.005e-4, 1e-3, "layer 3");
        }
    }
}

/// Points of a mesh that has nothing to do with the loads, and of one next to their ends.
fn everywhere(solution: &Solution, field: &Field) -> Vec<recede::FieldPoint> {
    let longest = solution.extent().unwrap();
    let mut xs: Vec<f64> = (0..60).map(|k| 0.05 * f64::from(k) * longest).collect();
    for contact in solution.contacts() {
        let ends = contact.intervals().iter().flat_map(|interval| [interval.left, interval.right]);
        xs.extend(ends.flat_map(|end| [-0.1, -0.01, -1e-3, 0.0, 1e-3, 0.01, 0.1].map(|s| end.abs() * (1.0 + s))));
    }
    xs.sort_by(f64::total_cmp);
    let mut points = Vec::new();
    for (_, [from, to]) in field.layers() {
        let to = if to.is_finite() { to } else { from + 2.0 * longest };
        let depths: Vec<f64> = (0..=12).map(|k| from + f64::from(k) / 12.0 * (to - from)).collect();
        let grids = field.by_layer(&xs, &depths).unwrap();
        points.extend(grids.iter().flat_map(|grid| grid.points().to_vec()));
    }
    points
}

#[test]
fn nowhere_in_random_scenes_are_stresses_larger_than_the_largest() {
    let scene = |number| scene_of_any_kind(&Ranges::moderate(), 77, number).unwrap();
    let scenes = (0..4).flat_map(|number| [scene(number), about_axis(scene(number))]);
    let mut compared = 0;
    for scene in scenes {
        let Ok(model) = scene.stack().and_then(Model::new) else { continue };
        let Ok(solution) = model.press(&scene.top, scene.force) else { continue };
        let field = model.field(&solution).unwrap();
        let found = field.extremes().unwrap();
        let within = |found: Option<Extreme>, here: f64, point: &recede::FieldPoint, what: &str| {
            let (value, error) = found.map_or((0.0, 0.0), |found| (found.value, found.error));
            let own = field.stress_error(&Point { x: point.x, depth: point.depth, layer: Some(point.layer) }).unwrap();
            let peak = solution.contacts()[0].resultant / solution.contacts()[0].reach();
            let allowed = value * (1.0 + 2e-6) + error + own + 1e-8 * peak;
            // NaN where a material does not give von Mises' stress
            assert!(
                here.is_nan() || here <= allowed,
                "{what} {value:e} ± {error:e}, but {here:e} at {point:?}\n{}",
                scene.to_ron()
            );
        };
        for point in everywhere(&solution, &field).iter().filter(|point| point.sigma_yy.is_finite()) {
            within(found.tension, point.tension(), point, "tension");
            let layer = found.layers.iter().find(|of| of.layer == point.layer).unwrap();
            within(layer.von_mises, point.von_mises(), point, "von Mises' stress");
        }
        compared += 1;
    }
    assert!(compared >= 6, "{compared}");
}

/// Contacts hundreds of times longer than layers: something is found for each layer, with an error that holds.
#[test]
fn hard_scenes_have_extremes_of_each_layer() {
    for name in ["seed_9_number_32", "seed_2_number_55"] {
        let path = format!("{}/tests/data/hard/{name}.ron", env!("CARGO_MANIFEST_DIR"));
        let (_, field) = solved(&Scene::read(Path::new(&path)).unwrap());
        let found = field.extremes().unwrap();
        assert_eq!(found.layers.len(), field.layers().count(), "{name}");
        for layer in found.layers {
            let at = layer.von_mises.unwrap();
            assert!(at.value > 0.0 && at.value.is_finite() && at.error > 0.0 && at.error < at.value, "{name}: {at:?}");
            let [from, to] = field.layers().find(|(number, _)| *number == layer.layer).unwrap().1;
            assert!(from <= at.depth && at.depth <= to, "{name}: {at:?}");
        }
    }
}
