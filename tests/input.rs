//! Input as engineers have it: Young's modulus in place of the shear modulus, and numbers with units.
use recede::layers::{Isotropic, Plane};
use recede::report::{Format, Report};
use recede::{Item, Model, Scene};

/// Materials of the layers, at some depths.
fn coefficients(scene: &Scene) -> Vec<[f64; 4]> {
    let layers = scene.stack.iter().filter_map(|item| match item {
        Item::Layer(layer) => Some(layer),
        _ => None,
    });
    layers
        .flat_map(|layer| [0.0, 0.3, 0.7, 1.0].map(|depth| layer.material(depth, Plane::Strain)))
        .map(|m| [m.shear_compliance, m.normal_compliance, m.coupling, m.axial_stiffness])
        .collect()
}

fn scene(punch: &str, force: &str, layers: &str) -> Scene {
    let text = format!(
        "Scene(units: (length: \"mm\", force: \"N\"), geometry: PlaneStrain, punch: {punch}, force: {force}, stack: [{layers}])"
    );
    Scene::from_ron(&text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn youngs_modulus_stands_for_the_shear_modulus_wherever_that_is_read() {
    // E = 2 μ (1 + ν): with ν = 1/4, 5/2 μ
    let punch = |modulus: &str| format!("ElasticCylinder(radius: 100, {modulus}, poisson: 0.25)");
    let layers = |modulus: &dyn Fn(f64) -> String, profile: &dyn Fn(f64, f64) -> String| {
        format!(
            "Homogeneous(thickness: 1, {}, poisson: 0.25), Bonded,
             Exponential(thickness: 1, {}, poisson: 0.25, beta: -0.5), Bonded,
             Graded(thickness: 1, {}, poisson: 0.25), Bonded,
             Graded(thickness: 1, {}, poisson_profile: Linear(top: 0.25, bottom: 0.25)), Receding,
             {{base}}",
            modulus(2.0),
            modulus(3.0),
            profile(1.0, 4.0),
            profile(4.0, 2.0),
        )
    };
    let shear =
        layers(&|m| format!("shear_modulus: {m}"), &|a, b| format!("shear_modulus: Linear(top: {a}, bottom: {b})"));
    let young = layers(&|m| format!("young: {}", 2.5 * m), &|a, b| {
        format!("young: Linear(top: {}, bottom: {})", 2.5 * a, 2.5 * b)
    });
    for base in [
        "HalfPlane(MODULUS, poisson: 0.25)",
        "GradedHalfPlane(MODULUS, poisson: 0.25, beta: 0.2)",
        "PowerHalfPlane(MODULUS, poisson: 0.25, length: 2, exponent: 0.5)",
    ] {
        let of = |layers: &str, name: &str, value: f64| {
            let layers = layers.replace("{base}", &base.replace("MODULUS", &format!("{name}: {value}")));
            scene(&punch(&format!("{name}: {value}")), "0.01", &layers)
        };
        let (shear, young) = (of(&shear, "shear_modulus", 4.0), of(&young, "young", 10.0));
        assert_eq!(shear.top.material(), young.top.material());
        for (a, b) in coefficients(&shear).iter().zip(coefficients(&young)) {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 4.0 * f64::EPSILON * a.abs()), "{a:?} {b:?}");
        }
        let [a, b] = [&shear, &young].map(|scene| recede::solve(scene).unwrap());
        for (a, b) in a.contacts().iter().zip(b.contacts()) {
            let (a, b) = (a.half_length().unwrap(), b.half_length().unwrap());
            assert!((a / b - 1.0).abs() < 1e-11, "{a} {b}");
        }
        // it is written as it was read
        assert!(young.to_ron().contains("young: 10.0") && !young.to_ron().contains("shear_modulus"));
        assert_eq!(Scene::from_ron(&young.to_ron()).unwrap().to_ron(), young.to_ron());
        assert!(young.with("layer[1].young", 7.0).is_ok() && young.with("layer[1].shear_modulus", 7.0).is_err());
    }
    assert_eq!(Isotropic::from_young(10.0, 0.25).unwrap(), Isotropic::new(4.0, 0.25).unwrap());
}

#[test]
fn numbers_with_units_are_those_of_the_scene() {
    let layers = |h: &str, e: &str, beta: &str, k: &str, t: &str| {
        format!(
            "Homogeneous(thickness: {h}, young: {e}, poisson: 0.3), Spring(normal: {k}),
             Exponential(thickness: {h}, shear_modulus: {e}, poisson: 0.3, beta: {beta}), Bonded,
             Graded(thickness: {h}, young: Table([(0, {e}), ({t}, {e}), (1, 3e4)]), poisson: 0.3), Receding,
             Orthotropic(thickness: {h}, young: (x: {e}, y: 1e4, z: {e}), poisson: (xy: 0.1, xz: 0.1, yz: 0.1), shear_modulus: 1e4),
             Bonded, HalfPlane(young: {e}, poisson: 0.3)"
        )
    };
    let plain = scene("Table([(0, 0), (0.5, 0.001), (3, 0.2)])", "13", &layers("0.25", "26000", "0.3", "4e3", "0.1"));
    let with = scene(
        "Table([(0, 0), (\"500 um\", \"1e-6 m\"), (3, \"0.02 cm\")])",
        "\"13 kN/m\"",
        &layers("\"250 µm\"", "\"26 GPa\"", "\"300 1/m\"", "\"4 TPa/m\"", "\"100um\""),
    );
    assert_eq!(plain.to_ron(), with.to_ron());
    assert_eq!(plain.paths(), with.paths());
    let [a, b] = [plain, with].map(|scene| recede::solve(&scene).unwrap());
    assert_eq!(a.contacts()[0].half_length(), b.contacts()[0].half_length());
}

#[test]
fn scenes_in_any_units_have_the_same_answer() {
    let text = |length: &str, force: &str| {
        format!(
            "Scene(units: (length: \"{length}\", force: \"{force}\"), geometry: PlaneStrain,
                punch: Cylinder(radius: \"50 mm\"), force: \"100 N/mm\",
                stack: [Homogeneous(thickness: \"2 mm\", young: \"7 GPa\", poisson: 0.3), Receding,
                        HalfPlane(young: \"70 GPa\", poisson: 0.3)])"
        )
    };
    let in_metres = |length: &str, force: &str, metres: f64| {
        let solution = recede::solve(&Scene::from_ron(&text(length, force)).unwrap()).unwrap();
        solution.contacts().iter().map(|contact| contact.half_length().unwrap() * metres).collect::<Vec<_>>()
    };
    let expected = in_metres("m", "N", 1.0);
    for (length, force, metres) in [("mm", "N", 1e-3), ("um", "mN", 1e-6), ("cm", "kN", 1e-2), ("in", "lbf", 0.0254)] {
        for (a, b) in in_metres(length, force, metres).iter().zip(&expected) {
            assert!((a / b - 1.0).abs() < 1e-10, "{length}: {a} {b}");
        }
    }
}

/// Tables tell depths in lengths, or in parts of a thickness that varies.
#[test]
fn a_relative_table_fits_any_thickness() {
    let of = |h: f64, table: &str| {
        let layers = format!("Graded(thickness: {h}, young: {table}, poisson: 0.3), Receding, Rigid");
        scene("Cylinder(radius: 100)", "0.5", &layers)
    };
    let relative = of(1.0, "RelativeTable([(0, 1e3), (0.25, \"3 GPa\"), (1, 2e3)])");
    for h in [0.5, 2.0, 0.3] {
        let table = of(h, &format!("Table([(0, 1e3), ({}, 3e3), ({h}, 2e3)])", 0.25 * h));
        let found =
            [relative.with("layer[1].thickness", h).unwrap(), table].map(|scene| recede::solve(&scene).unwrap());
        for (a, b) in found[0].contacts().iter().zip(found[1].contacts()) {
            let [a, b] = [a, b].map(|contact| [contact.half_length().unwrap(), contact.central_pressure]);
            assert!(a.iter().zip(b).all(|(a, b)| (a / b - 1.0).abs() < 1e-12), "{h}: {a:?} {b:?}");
        }
    }
}

#[test]
fn a_name_is_shown_wherever_a_layer_is_and_changes_no_answer() {
    let layers = |names: [&str; 3]| {
        let [coating, strip, base] = names;
        format!(
            "Homogeneous({coating}thickness: 1, young: 10, poisson: 0.3), Bonded,
             Homogeneous({strip}thickness: 0.5, young: 10, poisson: 0.3), Bonded, Winkler({base}stiffness: 3)"
        )
    };
    let plain = scene("Cylinder(radius: 100)", "0.01", &layers([""; 3]));
    let quoted = r#"name: "3 mm of \"felt\"", "#;
    let named = scene("Cylinder(radius: 100)", "0.01", &layers(["name: \"skin\", ", "", quoted]));
    assert_eq!(
        [1, 2, 3, 4].map(|number| named.layer_name(number)),
        [Some("skin"), None, Some("3 mm of \"felt\""), None]
    );
    for again in [Scene::from_ron(&named.to_ron()).unwrap(), Scene::from_json(&named.to_json()).unwrap()] {
        assert_eq!(again.to_ron(), named.to_ron());
        assert_eq!(again.with("layer[1].thickness", 2.0).unwrap().layer_name(1), Some("skin"));
    }
    let [(_, told), (found, said)] = [&plain, &named].map(|scene| {
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let field = model.field(&solution).unwrap();
        let (max_shear, extremes) = (field.max_shear().ok(), field.extremes().unwrap());
        let (approaches, extremes) = (&[][..], Some(&extremes));
        let report = Report {
            scene,
            solution: &solution,
            separation: None,
            approaches,
            max_shear,
            extremes,
            collocated: None,
            digits: None,
            seconds: 0.0,
        };
        let written = |format: Format| {
            let mut text = Vec::new();
            report.write(format, &mut text).unwrap();
            String::from_utf8(text).unwrap()
        };
        (scene.stack().unwrap().to_string() + &written(Format::Table), written(Format::Json))
    });
    for part in
        [" 1 Homogeneous(name: \"skin\", thickness: 1.0", "layer 1 \"skin\": von Mises stress", "in layer 1 \"skin\""]
    {
        assert!(found.contains(part), "{part}: {found}");
    }
    let [mut told, mut said] = [told, said].map(|text| serde_json::from_str::<serde_json::Value>(&text).unwrap());
    let layer = said["extremes"]["layers"][0].as_object_mut().unwrap();
    assert_eq!(layer.remove("name").unwrap(), "skin");
    for key in ["scene", "seconds"] {
        (told[key], said[key]) = Default::default();
    }
    assert_eq!(told, said);
}
