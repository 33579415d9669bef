//! Layers that would be strained if they were free: residual stresses, and laminates that are bent before they are loaded.
//!
//! Goal: laminates are bent as Timoshenko and Stoney say, which is a gap of that curvature to the contact below; residual stresses are in equilibrium and part of all fields and extremes; a laminate
//! that is strained uniformly is not stressed in the plane.
use recede::layers::{Isotropic, Layer, Loaded, Material, Plane};
use recede::numeric::quadrature::rule;
use recede::{FieldPoint, HalfPlane, Homogeneous, Model, Point, Scene, Solution, Stack};

const GROUND: &str = "HalfPlane(shear_modulus: 0.8, poisson: 0.2)";

fn scene_of(geometry: &str, top: &str, layers: &str) -> Scene {
    let text = format!("Scene(geometry: {geometry}, {top}, stack: [{layers}])");
    Scene::from_ron(&text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn scene(layers: &str) -> Scene {
    scene_of("PlaneStrain", "punch: Parabola(radius: 100), force: 0.002", layers)
}

fn solve(scene: &Scene) -> Solution {
    recede::solve(scene).unwrap_or_else(|error| panic!("{error} {}", scene.to_ron()))
}

/// Points far from all contacts, at depths of a layer.
fn far(scene: &Scene, layer: usize, depths: &[f64]) -> Vec<FieldPoint> {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let field = model.field(&model.press(&scene.top, scene.force).unwrap()).unwrap();
    let points: Vec<Point> = depths.iter().map(|depth| Point { x: 60.0, depth: *depth, layer: Some(layer) }).collect();
    field.points(&points).unwrap()
}

/// The curvature of two bonded layers, the lower one of which would be longer by `free`: thicknesses and moduli of stretched plates, from the top (Timoshenko 1925).
fn bimetal([h1, h2]: [f64; 2], [e1, e2]: [f64; 2], free: f64) -> f64 {
    let (m, n) = (h1 / h2, e1 / e2);
    6.0 * free * (1.0 + m).powi(2) / ((h1 + h2) * (3.0 * (1.0 + m).powi(2) + (1.0 + m * n) * (m * m + 1.0 / (m * n))))
}

#[test]
fn two_layers_are_bent_like_a_bimetal_strip() {
    let poisson = 0.3;
    for (geometry, free, factor) in [
        ("PlaneStrain", 1.0 + poisson, 1.0 / (1.0 - poisson)),
        ("PlaneStress", 1.0, 1.0 + poisson),
        ("Axisymmetric", 1.0, 1.0 / (1.0 - poisson)),
    ] {
        let top = if geometry == "Axisymmetric" { "load: Point, force: 0.001" } else { "load: Line, force: 0.001" };
        for ([h1, h2], [m1, m2], strain) in [([0.5, 0.5], [1.0, 2.0], 1e-3), ([0.2, 1.1], [7.0, 0.5], 2e-4)] {
            // E/(1 − ν²), or E about all directions alike: the ratio of both moduli is the same
            let curvature = bimetal([h1, h2], [2.0 * factor * m1, 2.0 * factor * m2], free * strain);
            let layers = |eigenstrain: &str, interface: &str| {
                format!(
                    "Homogeneous(thickness: {h1}, shear_modulus: {m1}, poisson: {poisson}), Bonded,
                     Homogeneous(thickness: {h2}, shear_modulus: {m2}, poisson: {poisson}{eigenstrain}), {interface}, {GROUND}"
                )
            };
            let bent = scene_of(geometry, top, &layers(&format!(", eigenstrain: {strain}"), "Receding"));
            let gap = format!("Receding(gap: Parabola(radius: {:?}))", 1.0 / curvature);
            let gap = scene_of(geometry, top, &layers("", &gap));
            for (bent, gap) in solve(&bent).contacts().iter().zip(solve(&gap).contacts()) {
                let (found, expected) = (bent.half_length().unwrap(), gap.half_length().unwrap());
                assert!((found - expected).abs() <= 1e-11 * expected, "{geometry}: {found} {expected}");
            }
        }
    }
}

#[test]
fn a_thin_film_bends_what_it_lies_on_as_stoney_says() {
    // film on top, shorter by 1e-3 if it were free: the edges of the strip bend up
    let curvature = |film: f64| {
        let layers = format!(
            "Homogeneous(thickness: {film}, shear_modulus: 3, poisson: 0.25, eigenstrain: -1e-3), Bonded,
             Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, {GROUND}"
        );
        // the residual strain grows with the depth as the curvature says
        let [top, bottom] = [0.1, 0.9].map(|part| far(&scene(&layers), 2, &[film + part])[0].sigma_xx);
        (bottom - top) / 0.8 / (2.0 / 0.75)
    };
    let stoney = |film: f64| 6.0 * 3.0 * 1.25e-3 * film;
    let errors = [1e-2, 1e-3].map(|film| (curvature(film) / stoney(film) - 1.0).abs());
    assert!(errors[1] < 0.02 && (5.0..20.0).contains(&(errors[0] / errors[1])), "{errors:?}");
}

#[test]
fn residual_stresses_have_neither_a_force_nor_a_moment() {
    for (joint, parts) in
        [("Bonded", &[[0, 3]][..]), ("Spring(normal: 3, tangential: 2)", &[[0, 3]]), ("Sliding", &[[0, 2], [2, 3]])]
    {
        let layers = format!(
            "Exponential(thickness: 0.7, shear_modulus: 2, poisson: 0.3, beta: -2, eigenstrain: -1e-3), Bonded,
             Homogeneous(thickness: 0.4, shear_modulus: 3, poisson: 0.1, eigenstrain: 9e-4), {joint},
             Orthotropic(thickness: 0.3, young: (x: 3, y: 1, z: 2), poisson: (xy: 0.3, xz: 0.2, yz: 0.1), shear_modulus: 0.5),
             Receding, {GROUND}"
        );
        let scene = scene(&layers);
        let sums = [(1, 0.0, 0.7), (2, 0.7, 1.1), (3, 1.1, 1.4)].map(|(layer, from, to)| {
            let (depths, weights): (Vec<f64>, Vec<f64>) = rule(32).on(from, to).unzip();
            let points = far(&scene, layer, &depths);
            let weighed = || points.iter().zip(&weights).map(|(point, weight)| (weight * point.sigma_xx, point.depth));
            [
                weighed().map(|(own, _)| own).sum::<f64>(),
                weighed().map(|(own, depth)| own * depth).sum(),
                weighed().map(|(own, _)| own.abs()).sum(),
            ]
        });
        // what slides on the others is bent with them
        let size: f64 = sums.iter().map(|[.., size]| size).sum();
        assert!(sums.iter().all(|[.., size]| *size > 1e-5), "{joint}: {sums:?}");
        for [from, to] in parts {
            let force: f64 = sums[*from..*to].iter().map(|[force, ..]| force).sum();
            assert!(force.abs() < 1e-10 * size, "{joint}: {force:e} {size:e}");
        }
        let moment: f64 = sums.iter().map(|[_, moment, _]| moment).sum();
        assert!(moment.abs() < 1e-10 * size, "{joint}: {moment:e}");
    }
}

#[test]
fn a_laminate_that_is_strained_uniformly_is_stressed_out_of_the_plane_only() {
    let layers = |eigenstrain: &str| {
        format!(
            "Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.3{eigenstrain}), Bonded,
             Exponential(thickness: 0.5, shear_modulus: 1, poisson: 0.3, beta: 1{eigenstrain}), Receding, {GROUND}"
        )
    };
    let [strained, free] = [", eigenstrain: 1e-3", ""].map(|own| scene(&layers(own)));
    assert_eq!(solve(&strained).contacts(), solve(&free).contacts());
    for layer in [1, 2] {
        for (found, expected) in far(&strained, layer, &[0.5]).iter().zip(far(&free, layer, &[0.5])) {
            assert!((found.sigma_xx - expected.sigma_xx).abs() < 1e-16 && found.sigma_xy == expected.sigma_xy);
            // E = 2 (1 + ν) μ
            assert!((found.sigma_zz - expected.sigma_zz + 2.6e-3).abs() < 1e-15, "{found:?} {expected:?}");
        }
    }
}

#[test]
fn what_is_bonded_to_the_base_is_stressed_and_touches_as_before() {
    let layers = |eigenstrain: &str| {
        format!("Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.3{eigenstrain}), Bonded, {GROUND}")
    };
    let [strained, free] = [", eigenstrain: -2e-3", ""].map(|own| scene(&layers(own)));
    assert_eq!(solve(&strained).contacts(), solve(&free).contacts());
    let at = |scene: &Scene| {
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let field = model.field(&solution).unwrap();
        let extremes = field.extremes().unwrap();
        (
            field
                .points(&[Point { x: 0.1, depth: 0.2, layer: None }, Point { x: 0.1, depth: 0.6, layer: None }])
                .unwrap(),
            extremes,
        )
    };
    let ((found, found_extremes), (expected, extremes)) = (at(&strained), at(&free));
    // E/(1 − ν²) (1 + ν) e
    let stress = 2.0 / 0.7 * 1.3 * 2e-3;
    assert!((found[0].sigma_xx - expected[0].sigma_xx - stress).abs() < 1e-15);
    assert_eq!((found[0].sigma_yy, found[1]), (expected[0].sigma_yy, expected[1]));
    let tension = |extremes: &recede::Extremes| extremes.tension.unwrap().value;
    assert!(tension(&found_extremes) >= 0.999 * stress && tension(&extremes) < 0.5 * stress);
}

#[test]
fn the_stress_out_of_the_plane_is_told_of_isotropic_materials_only() {
    let ply = |own: &str| {
        format!(
            "Orthotropic(thickness: 0.3, young: (x: 3, y: 1, z: 2), poisson: (xy: 0.3, xz: 0.2, yz: 0.1), shear_modulus: 0.5{own}), Bonded,
             {GROUND}"
        )
    };
    let [strained, free] = [", eigenstrain: 1e-3", ""].map(|own| far(&scene(&ply(own)), 1, &[0.1])[0]);
    assert!(strained.sigma_zz.is_nan() && free.sigma_zz.abs() < 1e-6, "{strained:?} {free:?}");
    // ν_zx = ν_xz E_z/E_x, and E_x/(1 − ν_xz ν_zx) (1 + ν_zx) e
    let poisson = 0.2 * 2.0 / 3.0;
    let expected = -3.0 / (1.0 - 0.2 * poisson) * (1.0 + poisson) * 1e-3;
    assert!(((strained.sigma_xx - free.sigma_xx) / expected - 1.0).abs() < 1e-12, "{strained:?} {expected}");
}

/// A layer of one's own that swells.
#[derive(Debug)]
struct Swelling;

impl Layer for Swelling {
    fn thickness(&self) -> Option<f64> {
        Some(0.5)
    }

    fn material(&self, _depth: f64, plane: Plane) -> Material {
        Isotropic { shear_modulus: 2.0, poisson: 0.3 }.material(plane)
    }

    fn eigenstrain(&self) -> f64 {
        1e-3
    }
}

#[test]
fn eigenstrains_are_read_written_and_varied_and_layers_of_ones_own_may_have_one() {
    let layers = format!(
        "Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.3), Bonded,
         Homogeneous(thickness: 0.5, shear_modulus: 2, poisson: 0.3, eigenstrain: 0.001), Receding, {GROUND}"
    );
    let scene = scene(&layers);
    let text = scene.to_ron();
    assert!(text.contains("poisson: 0.3, eigenstrain: 0.001),\n"), "{text}");
    assert_eq!(Scene::from_ron(&text).unwrap().to_ron(), text);
    assert_eq!(Scene::from_json(&scene.to_json()).unwrap().to_ron(), text);
    assert_eq!(scene.number("layer[2].eigenstrain").unwrap(), 0.001);
    let more = scene.with("layer[2].eigenstrain", 0.002).unwrap();
    assert!(solve(&more).contacts()[1].half_length() < solve(&scene).contacts()[1].half_length());
    let strip = || Homogeneous::new(0.5, 1.0, 0.3).unwrap();
    let ground = || HalfPlane::new(0.8, 0.2).unwrap();
    let below = Loaded::new(Homogeneous::new(0.5, 2.0, 0.3).unwrap()).with_eigenstrain(1e-3);
    let built = |stack: recede::StackBuilder| {
        let model = Model::new(stack.receding().layer(ground()).build().unwrap()).unwrap();
        model.press(&scene.top, scene.force).unwrap().contacts().to_vec()
    };
    assert_eq!(built(Stack::builder(Plane::Strain).layer(strip()).bonded().layer(below)), solve(&scene).contacts());
    for (found, expected) in built(Stack::builder(Plane::Strain).layer(strip()).bonded().layer(Swelling))
        .iter()
        .zip(solve(&scene).contacts())
    {
        assert!((found.half_length().unwrap() / expected.half_length().unwrap() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn what_cannot_be_strained_is_named() {
    let error = |layers: &str| {
        let text =
            format!("Scene(geometry: PlaneStrain, punch: Parabola(radius: 100), force: 0.002, stack: [{layers}])");
        Scene::from_ron(&text)
            .map_err(recede::Error::from)
            .and_then(|scene| recede::solve(&scene))
            .unwrap_err()
            .to_string()
    };
    let strip = |own: &str, interface: &str| {
        format!(
            "Homogeneous(thickness: 0.5, shear_modulus: 1, poisson: 0.3), Bonded,
             Homogeneous(thickness: 0.5, shear_modulus: 2, poisson: 0.3, eigenstrain: {own}), {interface}, {GROUND}"
        )
    };
    for (layers, part) in [
        (strip("-0.001", "Receding"), "their edges fall away without end"),
        (strip("0.001", "Receding(gap: Cylinder(radius: 9))"), "the gap there is a circle"),
        (strip("inf", "Receding"), "found inf"),
        (strip("\"warm\"", "Receding"), "eigenstrain"),
        ("HalfPlane(shear_modulus: 1, poisson: 0.3, eigenstrain: 0.1)".to_owned(), "is a base, and has no eigenstrain"),
        (
            format!(
                "{}, Bonded, Winkler(stiffness: 1, eigenstrain: 0.1)",
                "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.3)"
            ),
            "is a base, and has no eigenstrain",
        ),
    ] {
        let error = error(&layers);
        assert!(error.contains(part), "{layers}: {error}");
    }
}

#[test]
fn a_residual_stress_above_all_stresses_of_the_load_is_the_largest() {
    // the load bends the strip, and stretches the film below it: a compressed film is stressed less there than far away
    let layers = |strain: f64| {
        format!(
            "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded,
             Homogeneous(thickness: 0.02, shear_modulus: 1, poisson: 0.25, eigenstrain: {strain}), Bonded,
             HalfPlane(shear_modulus: 0.05, poisson: 0.2)"
        )
    };
    for (strain, is_far) in [(0.1, true), (-0.1, false)] {
        let scene = scene_of("PlaneStrain", "load: Uniform(half_width: 1), force: 0.02", &layers(strain));
        let solution = solve(&scene);
        let field = Model::new(scene.stack().unwrap()).unwrap().field(&solution).unwrap();
        let (largest, residual) = (field.max_shear().unwrap(), field.at_layer(1e6, 1.01, 2).unwrap().max_shear());
        let below = field.at_layer(0.0, 1.02, 2).unwrap().max_shear();
        assert!(largest.value >= residual * (1.0 - 1e-8) && largest.value >= below, "{largest:?} {residual} {below}");
        assert_eq!(largest.x.abs() > 2.0, is_far, "{largest:?} {residual} {below}");
    }
}

/// A laminate that is bent before it is loaded is pressed by a punch like a flat one by a punch that is curved as much less.
#[test]
fn a_punch_sees_the_face_of_a_laminate_that_is_bent() {
    for (geometry, force) in [("PlaneStrain", 1e-4), ("Axisymmetric", 3e-5)] {
        let solved = |punch: &str, strain: f64, gap: &str| {
            let layer = "Homogeneous(thickness: 0.5, shear_modulus: 0.75, poisson: 0.25";
            solve(&scene_of(
                geometry,
                &format!("punch: {punch}, force: {force:?}"),
                &format!("{layer}), Bonded, {layer}, eigenstrain: {strain:?}), Receding{gap}, {GROUND}"),
            ))
        };
        let stretched = if geometry == "PlaneStrain" { 1.25 } else { 1.0 };
        let curvature = bimetal([0.5, 0.5], [1.0, 1.0], stretched * 5e-4);
        for (of_punch, of_same) in [(1e-3, 1e-3 - curvature), (2e-3, 2e-3 - curvature)] {
            let round = |curvature: f64| format!("Parabola(radius: {:?})", 1.0 / curvature);
            let bent = solved(&round(of_punch), 5e-4, "");
            let flat = solved(&round(of_same), 0.0, &format!("(gap: {})", round(curvature)));
            for (bent, flat) in bent.contacts().iter().zip(flat.contacts()) {
                let [one, other] = [bent, flat].map(|contact| contact.half_length().unwrap());
                assert!((one / other - 1.0).abs() < 1e-10, "{geometry} {one} {other}");
                let [one, other] = [bent, flat].map(|contact| contact.central_pressure);
                assert!((one / other - 1.0).abs() < 1e-9, "{geometry} {one} {other}");
            }
        }
        // a circle is not a parabola, and the face under a punch that ends rises to its end
        let circle = if geometry == "PlaneStrain" { "Cylinder(radius: 900)" } else { "Sphere(radius: 900)" };
        let near = solved(circle, 5e-4, "").contacts()[0].half_length().unwrap();
        let parabola = solved("Parabola(radius: 900)", 5e-4, "").contacts()[0].half_length().unwrap();
        assert!((near / parabola - 1.0).abs() < 1e-4, "{near} {parabola}");
    }
    let flat = scene_of(
        "PlaneStrain",
        "punch: Parabola(radius: 2000), force: 1e-4",
        "Homogeneous(thickness: 0.5, shear_modulus: 0.75, poisson: 0.25), Bonded,
        Homogeneous(thickness: 0.5, shear_modulus: 0.75, poisson: 0.25, eigenstrain: 5e-4), Receding, Rigid",
    );
    let error = recede::solve(&flat).unwrap_err().to_string();
    assert!(error.contains("rises to the punch far away"), "{error}");
}

/// Where weights press a parabolic gap flat all layers above are bent: they are stressed, and a punch sees the bent face.
#[test]
fn layers_are_bent_over_parabolic_gaps_that_are_pressed_flat() {
    let layers = |gaps: [&str; 2], first: &str| {
        format!(
            "Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25{first}), Receding{},
            Homogeneous(thickness: 0.5, shear_modulus: 1.5, poisson: 0.25, specific_weight: 0.1), Receding{}, {GROUND}",
            gaps[0], gaps[1]
        )
    };
    let of = |radius: f64, layers: &str| {
        let top = format!("punch: Parabola(radius: {radius:?}), force: 1e-4");
        solve(&scene_of("PlaneStrain", &top, layers))
    };
    let heavy = ", specific_weight: 0.1";
    let bent = of(200.0, &layers(["", "(gap: Parabola(radius: 1000))"], heavy));
    let flat = of(1.0 / (1.0 / 200.0 + 1e-3), &layers(["", ""], heavy));
    let [one, other] = [&bent, &flat].map(|own| own.contacts()[0].half_length().unwrap());
    assert!((one / other - 1.0).abs() < 1e-10, "{one} {other}");
    // a loose layer above lies on a base that is bent
    let bent = of(200.0, &layers(["", "(gap: Parabola(radius: 1000))"], ""));
    let gap = of(200.0, &layers(["(gap: Parabola(radius: 1000))", ""], ""));
    for (bent, gap) in bent.contacts().iter().zip(gap.contacts()) {
        let [one, other] = [bent, gap].map(|own| own.half_length().unwrap());
        assert!((one / other - 1.0).abs() < 1e-10, "{one} {other}");
    }
    // far away σ_xx = w κ (d − h/2) besides what weights make
    let stress = |gaps: [&str; 2], layer: usize, depth: f64| {
        let scene = scene_of("PlaneStrain", "load: Line, force: 1e-4", &layers(gaps, heavy));
        far(&scene, layer, &[depth])[0].sigma_xx
    };
    let gaps = ["(gap: Parabola(radius: 500))", "(gap: Parabola(radius: 1000))"];
    for (layer, depth, from_middle, stiffness, curvature) in
        [(1, 0.1, -0.4, 2.0, 3e-3), (1, 0.9, 0.4, 2.0, 3e-3), (2, 1.1, -0.15, 4.0, 1e-3)]
    {
        let (bent, flat) = (stress(gaps, layer, depth), stress(["", ""], layer, depth));
        let expected = -stiffness * curvature * from_middle;
        assert!((bent - flat - expected).abs() < 1e-7 * expected.abs(), "{layer} {depth} {bent} {flat} {expected}");
    }
}
