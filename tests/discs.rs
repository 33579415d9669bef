//! Loads about axes of their own at several places (x, y): what each of them does alone is added up.
//!
//! Goal: numbers of a published program; one load has the field about its axis; moved, turned and mirrored scenes have moved, turned and mirrored fields; strains follow
//! from stresses by Hooke's law; what cannot be added up is refused.
use recede::{Coordinates, FieldError, FieldPoint, FieldQuantity, Model, Scene, SpacePoint};

const PAVEMENT: &str = "Homogeneous(thickness: 150, young: 3000, poisson: 0.30), Bonded,
    Homogeneous(thickness: 600, young: 200, poisson: 0.35), Bonded, HalfPlane(young: 40, poisson: 0.40)";
/// The force of 1.1 MPa on a disc of the radius 150.
const FORCE: f64 = 1.1 * std::f64::consts::PI * 150.0 * 150.0;

/// To a part of itself.
fn close(found: f64, expected: f64, error: f64) {
    assert!((found / expected - 1.0).abs() <= error, "{found:e} is not {expected:e}");
}

fn scene(top: &str, stack: &str) -> Scene {
    let text = format!("Scene(geometry: Axisymmetric, {top}, stack: [{stack}])");
    Scene::from_ron(&text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn loads(all: &[(&str, [f64; 2], f64)]) -> String {
    let one =
        |(load, [x, y], force): &(&str, [f64; 2], f64)| format!("(load: {load}, at: ({x:?}, {y:?}), force: {force:?})");
    format!("loads: [{}]", all.iter().map(one).collect::<Vec<_>>().join(", "))
}

fn points(scene: &Scene, places: &[[f64; 3]]) -> Vec<FieldPoint> {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let field = model.field(&model.press(&scene.top, scene.force).unwrap()).unwrap();
    let place = |[x, y, depth]: &[f64; 3]| SpacePoint { x: *x, y: *y, depth: *depth, layer: None };
    field.points_in_space(&places.iter().map(place).collect::<Vec<_>>()).unwrap()
}

fn value(name: &str, point: &FieldPoint) -> f64 {
    FieldQuantity::named(name, Coordinates::Cartesian).unwrap().of_in(point, Coordinates::Cartesian)
}

/// Stress and displacement as a matrix and a vector of (x, y, z).
fn components(point: &FieldPoint) -> ([[f64; 3]; 3], [f64; 3]) {
    let of = |name: &str| value(name, point);
    let [xy, xz, yz] = ["tau_xy", "tau_xz", "tau_yz"].map(of);
    let [xx, yy, zz] = ["sigma_xx", "sigma_yy", "sigma_zz"].map(of);
    ([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], ["u_x", "u_y", "u_z"].map(of))
}

#[test]
fn the_surface_sinks_under_two_wheels_as_published() {
    // ELLEA1: one wheel at the distances from it, and two of them 300 apart
    let one = scene(&loads(&[("Uniform(radius: 150)", [0.0, 0.0], FORCE)]), PAVEMENT);
    let expected = [1.05086273723, 1.02909506223, 0.95872128292, 0.80952586301, 0.61376775844, 0.35108462015];
    let places = [0.0, 75.0, 150.0, 300.0, 600.0, 1500.0].map(|x| [x, 0.0, 0.0]);
    for (point, expected) in points(&one, &places).iter().zip(expected) {
        close(value("u_z", point), expected, 1e-10);
    }
    let wheel = |y: f64| ("Uniform(radius: 150)", [0.0, y], FORCE);
    let two = scene(&loads(&[wheel(150.0), wheel(-150.0)]), PAVEMENT);
    let found = points(&two, &[[0.0; 3], [0.0, 150.0, 0.0], [0.0, -150.0, 0.0]]);
    for (point, expected) in found.iter().zip([1.91744256584, 1.86038860024, 1.86038860024]) {
        close(value("u_z", point), expected, 1e-10);
    }
}

#[test]
fn one_load_is_what_it_is_about_its_axis() {
    for (load, force) in [("Uniform(radius: 0.5)", 0.01), ("Point", 0.02), ("Ring(radius: 1, half_width: 0.2)", 0.01)] {
        let stack = "Homogeneous(thickness: 1, shear_modulus: 3, poisson: 0.2, eigenstrain: 1e-4), Bonded, HalfPlane(shear_modulus: 1, poisson: 0.3)";
        let round = scene(&format!("load: {load}, force: {force}"), stack);
        let spatial = scene(&loads(&[(load, [2.0, -1.0], force)]), stack);
        assert_eq!((round.coordinates(), spatial.coordinates()), (Coordinates::Cylindrical, Coordinates::Cartesian));
        // at the distance 1.3 from the axis in a direction with the cosine 0.6
        for depth in [0.2, 0.9, 1.4] {
            let along = &points(&round, &[[1.3, 0.0, depth]])[0];
            let found = &points(&spatial, &[[2.0 + 1.3 * 0.6, -1.0 + 1.3 * 0.8, depth]])[0];
            let of = |name: &str| {
                FieldQuantity::named(name, Coordinates::Cylindrical).unwrap().of_in(along, Coordinates::Cylindrical)
            };
            let (size, sunk) = (of("von_mises"), of("u_z"));
            let (stress, displacement) = components(found);
            let (radial, hoop) = (of("sigma_rr"), of("sigma_tt"));
            for (found, expected) in [
                (stress[0][0], 0.36 * radial + 0.64 * hoop),
                (stress[1][1], 0.64 * radial + 0.36 * hoop),
                (stress[0][1], 0.48 * (radial - hoop)),
                (stress[2][2], of("sigma_zz")),
                (stress[0][2], 0.6 * of("tau_rz")),
                (stress[1][2], 0.8 * of("tau_rz")),
                (found.von_mises(), size),
            ] {
                assert!((found - expected).abs() < 1e-9 * size, "{load} {depth}: {found} {expected}");
            }
            for (found, expected) in displacement.into_iter().zip([0.6 * of("u_r"), 0.8 * of("u_r"), sunk]) {
                assert!((found - expected).abs() < 1e-9 * sunk.abs(), "{load} {depth}: {found} {expected}");
            }
            // the largest of all three principal values, not of the two in the vertical plane alone
            let principal = [along.principal()[0], along.principal()[1], hoop];
            let [largest, smallest] = [f64::max, f64::min].map(|pick| principal.into_iter().reduce(pick).unwrap());
            close(found.principal()[0], largest, 1e-8);
            close(found.principal()[1], smallest, 1e-8);
            close(found.max_shear(), 0.5 * (largest - smallest), 1e-8);
        }
    }
}

type Map<'a> = &'a dyn Fn([f64; 2]) -> [f64; 2];

#[test]
fn moved_turned_and_mirrored_scenes_have_such_fields() {
    let stack = "Exponential(thickness: 0.7, shear_modulus: 2, poisson: 0.1, beta: 1.5), Bonded, Homogeneous(thickness: 1, shear_modulus: 5, poisson: 0.3), Sliding,
        HalfPlane(shear_modulus: 1, poisson: 0.3)";
    let all = [
        ("Uniform(radius: 0.4)", [0.3, 0.9], 0.01),
        ("Elliptic(radius: 0.8)", [-1.0, 0.2], 0.02),
        ("Uniform(radius: 0.4)", [1.2, -0.5], 0.01),
    ];
    let places = [[0.1, 0.2, 0.3], [0.3, 0.9, 0.0], [2.0, -3.0, 1.2], [-1.0, 0.2, 2.5]];
    let given = points(&scene(&loads(&all), stack), &places);
    // by an angle of 3-4-5, and aside; mirrored in the plane y = 0
    let turned = |[x, y]: [f64; 2]| [0.6 * x - 0.8 * y + 3.0, 0.8 * x + 0.6 * y - 7.0];
    let mirrored = |[x, y]: [f64; 2]| [x, -y];
    let maps: [(Map, [[f64; 3]; 3]); 2] = [
        (&turned, [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]),
        (&mirrored, [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]),
    ];
    for (map, matrix) in maps {
        let moved = all.map(|(load, at, force)| (load, map(at), force));
        let there = places.map(|[x, y, depth]| [map([x, y])[0], map([x, y])[1], depth]);
        for (found, given) in points(&scene(&loads(&moved), stack), &there).iter().zip(&given) {
            let ((found, u), (stress, v)) = (components(found), components(given));
            let (size, sunk) = (given.von_mises(), v[2].abs());
            for i in 0..3 {
                let expected: f64 = (0..3).map(|k| matrix[i][k] * v[k]).sum();
                assert!((u[i] - expected).abs() < 1e-9 * sunk, "{u:?} {expected}");
                for j in 0..3 {
                    let of = |k: usize| (0..3).map(|l| matrix[i][k] * stress[k][l] * matrix[j][l]).sum::<f64>();
                    let expected: f64 = (0..3).map(of).sum();
                    assert!((found[i][j] - expected).abs() < 1e-8 * size, "{i} {j}: {found:?} {expected}");
                }
            }
        }
    }
}

#[test]
fn strains_follow_from_stresses_by_hookes_law() {
    let all = [
        ("Uniform(radius: 100)", [0.0, 160.0], 1e4),
        ("Parabolic(radius: 150)", [250.0, 0.0], 2e4),
        ("Point", [-400.0, -50.0], 5e3),
    ];
    for (point, (young, poisson)) in
        points(&scene(&loads(&all), PAVEMENT), &[[10.0, 40.0, 120.0], [-90.0, 5.0, 400.0], [0.0, 1.0, 900.0]])
            .iter()
            .zip([(3000.0, 0.30), (200.0, 0.35), (40.0, 0.40)])
    {
        let of = |name: &str| value(name, point);
        let [xx, yy, zz] = ["sigma_xx", "sigma_yy", "sigma_zz"].map(of);
        let size = of("von_mises") / young;
        for (name, [own, other, third]) in
            [("eps_xx", [xx, yy, zz]), ("eps_yy", [yy, xx, zz]), ("eps_zz", [zz, xx, yy])]
        {
            let expected = (own - poisson * (other + third)) / young;
            assert!((of(name) - expected).abs() < 1e-9 * size, "{name}: {} {expected}", of(name));
        }
        for (angle, shear) in [("gamma_xy", "tau_xy"), ("gamma_xz", "tau_xz"), ("gamma_yz", "tau_yz")] {
            let expected = 2.0 * (1.0 + poisson) * of(shear) / young;
            assert!((of(angle) - expected).abs() < 1e-9 * size, "{angle}: {} {expected}", of(angle));
        }
        // the sum of the strains is the sum of their principal values
        let [first, last] = point.principal_strains();
        let second = of("eps_xx") + of("eps_yy") + of("eps_zz") - first - last;
        assert!(first >= second && second >= last && point.tensile_strain() == first, "{first} {second} {last}");
    }
}

#[test]
fn grids_lie_in_a_vertical_plane() {
    let scene =
        scene(&loads(&[("Uniform(radius: 1)", [0.0, 2.0], 1.0), ("Uniform(radius: 1)", [0.5, -2.0], 1.0)]), PAVEMENT);
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let field = model.field(&model.press(&scene.top, scene.force).unwrap()).unwrap();
    assert_eq!(field.window()[0], [-2.25, 2.75]);
    let (xs, depths) = ([-1.0, 0.3, 4.0], [0.0, 0.5, 3.0]);
    for y in [0.0, 2.0, -3.5] {
        let grid = field.clone().at_y(y).unwrap().grid(&xs, &depths).unwrap();
        let of = |depth: f64| xs.map(|x| SpacePoint { x, y, depth, layer: None });
        let expected = field.points_in_space(&depths.map(of).concat()).unwrap();
        for (found, expected) in grid.points().iter().zip(&expected) {
            assert_eq!([found.x, found.z, found.depth], [expected.x, expected.z, expected.depth]);
            let size = expected.von_mises();
            assert!((found.sigma_xz - expected.sigma_xz).abs() < 1e-9 * size, "{found:?} {expected:?}");
            assert!((found.sigma_yy - expected.sigma_yy).abs() < 1e-9 * size, "{found:?} {expected:?}");
        }
    }
}

#[test]
fn what_cannot_be_added_up_is_refused() {
    let one = loads(&[("Uniform(radius: 1)", [0.0, 0.0], 1.0)]);
    let loose = scene(
        &one,
        "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.3), Receding, HalfPlane(shear_modulus: 1, poisson: 0.3)",
    );
    let error = recede::solve(&loose).unwrap_err();
    assert!(error.to_string().contains("does not hold where layers come apart, as at 1|2"), "{error}");
    let bonded = scene(&one, PAVEMENT);
    let (model, solution) = (Model::new(bonded.stack().unwrap()).unwrap(), recede::solve(&bonded).unwrap());
    let field = model.field(&solution).unwrap();
    assert_eq!(field.max_shear().unwrap_err(), FieldError::Superposed);
    assert_eq!(field.extremes().unwrap_err(), FieldError::Superposed);
    let profile = model.profile(&bonded.top, &solution, &[0.0, 0.9, 1.1]).unwrap();
    let mean = 1.0 / std::f64::consts::PI;
    assert!(
        profile.contacts[0].pressure.iter().zip([mean, mean, 0.0]).all(|(p, expected)| (p - expected).abs() < 1e-12)
    );
    assert_eq!(profile.faces.len(), 5);
    assert!(model.collocate(&bonded.top, &solution).unwrap().is_empty());
    assert!(model.ledger(&bonded.top, &solution).unwrap().rows.is_empty());
    assert_eq!(field.at_y(f64::NAN).unwrap_err().to_string().split(' ').nth(2), Some("NaN"));
    // about one axis all directions are alike, and there is no y
    let round = scene("load: Uniform(radius: 1), force: 1", PAVEMENT);
    let field = model.field(&model.press(&round.top, round.force).unwrap()).unwrap();
    let point = SpacePoint { x: 0.0, y: 1.0, depth: 0.0, layer: None };
    assert_eq!(field.points_in_space(&[point]).unwrap_err(), FieldError::NoSpace(1.0));
}

#[test]
fn scenes_are_written_and_read_again_and_places_vary() {
    let scene = scene(&loads(&[("Uniform(radius: 1)", [0.0, 2.0], 1.0), ("Point", [0.5, -2.0], 3.0)]), PAVEMENT);
    for again in [Scene::from_ron(&scene.to_ron()).unwrap(), Scene::from_json(&scene.to_json()).unwrap()] {
        assert_eq!((&again.top, again.to_ron()), (&scene.top, scene.to_ron()));
    }
    let moved = scene.with("loads[2].at[1]", 7.0).unwrap();
    assert_eq!(moved.top.loads().unwrap().axes().unwrap(), [[0.0, 2.0], [7.0, -2.0]]);
}
