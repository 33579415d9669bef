//! Weights of layers and a pressure on top: what presses layers together besides the punch.
use recede::{Error, Model, NoSolution, Scene, Separation, Solution};

/// A layer with c = (κ + 1)/(4μ) = 1 and unit thickness and weight on a base with c = k, rigid for k = 0.
fn on(base: f64, top: &str, more: &str) -> String {
    let base = match base {
        0.0 => "Rigid".to_owned(),
        k => format!("HalfPlane(shear_modulus: {:?}, poisson: 0.25)", 0.75 / k),
    };
    let layer = "Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0)";
    format!("Scene({top}, {more} stack: [{layer}, Receding, {base}])")
}

fn solved(text: &str) -> Result<(Solution, Separation), Error> {
    let scene = Scene::from_ron(text)?;
    let model = Model::new(scene.stack()?)?;
    let solution = model.press(&scene.top, scene.force)?;
    let separation = model.separation(&scene.top, &solution)?.expect("layers that come apart");
    Ok((solution, separation))
}

/// The critical force in units of the weight, and where the first interface opens: numbers of two independent programs, which tell the place of a least value to half of its digits.
#[test]
fn layers_begin_to_come_apart_under_the_forces_of_other_programs() {
    let line = "geometry: PlaneStrain, load: Line, force: 20.0";
    let point = "geometry: Axisymmetric, load: Point, force: 20.0";
    let uniform = "geometry: PlaneStrain, load: Uniform(half_width: 0.5), force: 20.0";
    let cases = [
        (line, 0.0, 1.770537706, 44.139105985),
        (line, 1.0, 2.902761213, 139.034668328),
        (line, 4.0, 4.456128456, 203.497361690),
        (line, 10.0, 5.959530080, 249.948985990),
        (uniform, 1.0, 3.015412032, 151.755952331),
        (point, 0.0, 1.958786, 165.742949),
        (point, 0.25, 2.295516, 327.469005),
        (point, 1.0, 3.200254, 872.635924),
    ];
    for (top, base, x, force) in cases {
        let (_, found) = solved(&on(base, top, "")).unwrap();
        let digits = if top == point { 5e-7 } else { 1e-7 };
        assert!((found.x - x).abs() < digits, "{top}, {base}: {found:?}");
        assert!((found.critical_force / force - 1.0).abs() < 2e-9, "{top}, {base}: {found:?}");
    }
}

/// On a rigid base the transmission of a layer of thickness 1 is known, t = 2 (sinh z + z cosh z)/(sinh 2z + 2z): numbers of its integrals with 25 digits.
#[test]
fn a_layer_on_a_rigid_base_begins_to_come_apart_where_its_closed_form_says() {
    let (_, found) = solved(&on(0.0, "geometry: PlaneStrain, load: Line, force: 20.0", "")).unwrap();
    assert!((found.x - 1.770_537_703_711_694).abs() < 1e-12, "{found:?}");
    assert!((found.critical_force - 44.139_105_984_621_63).abs() < found.critical_force_error, "{found:?}");
}

#[test]
fn the_interface_that_is_pressed_less_opens_first() {
    let two = |first: f64, second: f64| {
        solved(&format!(
            "Scene(geometry: PlaneStrain, load: Line, force: 20.0, stack: [
            Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: {first:?}), Receding,
            Homogeneous(thickness: 0.8, shear_modulus: 1.5, poisson: 0.25, specific_weight: {second:?}), Receding,
            HalfPlane(shear_modulus: 0.75, poisson: 0.25)])"
        ))
        .unwrap()
    };
    let (solution, upper) = two(1.0, 1.875);
    let weights: Vec<f64> = solution.closed().iter().map(|own| own.weight).collect();
    assert_eq!(weights, [1.0, 2.5]);
    assert_eq!(upper.interface.to_string(), "1|2");
    assert!((upper.x - 3.423742285).abs() < 1e-7 && (upper.critical_force / 235.546432077 - 1.0).abs() < 1e-10);
    // the lower interface alone: the upper one is pressed more than it
    let (_, lower) = two(2.5, 0.0);
    assert_eq!(lower.interface.to_string(), "2|3");
    assert!((lower.x - 3.524470246).abs() < 1e-7 && (lower.critical_force / 320.340475509 - 1.0).abs() < 1e-10);
}

/// Whether a pressure is a weight or stands on top does not matter to one interface, and all pressures grow with weight and force together.
#[test]
fn only_the_force_over_the_weight_matters() {
    let parabola = |force: f64, radius: f64| {
        format!("geometry: PlaneStrain, punch: Parabola(radius: {radius:?}), force: {force:?}")
    };
    let (_, own) = solved(&on(1.0, &parabola(60.0, 1e-3), "")).unwrap();
    let twice = on(1.0, &parabola(120.0, 0.5e-3), "pressure_on_top: 1.0,");
    let (solution, twice) = solved(&twice).unwrap();
    assert_eq!(solution.closed()[0].weight, 2.0);
    assert!((twice.critical_force / own.critical_force - 2.0).abs() < 1e-9, "{twice:?} {own:?}");
    assert!((twice.x - own.x).abs() < 1e-7);
    // solved at the critical force the smallest pressure is zero
    let (critical, _) = solved(&on(1.0, &parabola(own.critical_force * (1.0 - 1e-9), 1e-3), "")).unwrap();
    assert!(critical.closed()[0].smallest_pressure.abs() < 1e-8, "{critical:?}");
}

/// What presses on a closed interface is the weight and all of the force.
#[test]
fn the_field_carries_the_weight_and_the_force() {
    let scene = Scene::from_ron(&on(1.0, "geometry: PlaneStrain, load: Line, force: 50.0", "")).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let own = &solution.closed()[0];
    let field = model.field(&solution).unwrap();
    let at = |x: f64, layer: usize| field.at_layer(x, 1.0, layer).unwrap();
    for (x, pressure) in [(0.0, own.central_pressure), (own.smallest_at, own.smallest_pressure), (200.0, 1.0)] {
        for layer in [1, 2] {
            let found = -at(x, layer).sigma_yy;
            assert!((found - pressure).abs() < 1e-5 * own.central_pressure, "{x} {layer}: {found} {pressure}");
        }
        assert!(at(x, 1).sigma_xy.abs() < 1e-8 * own.central_pressure);
    }
    // far away the layer has no resultant along it, and the half-plane is not strained
    let along = |depth: f64| field.at_layer(1e4, depth, 1).unwrap().sigma_xx;
    assert!(along(0.5).abs() < 1e-6 && along(1.0).abs() < 0.5 && (along(0.0) + along(1.0)).abs() < 1e-6);
    assert!((at(1e4, 2).sigma_xx + 1.0 / 3.0).abs() < 1e-6);
}

/// In an opening nothing presses, and the faces are apart by the gap that is told; beside it they press on each other, and lie on each other.
#[test]
fn fields_of_layers_that_come_apart_carry_their_pressures() {
    let uniform = "geometry: PlaneStrain, load: Uniform(half_width: 0.5), force: 200.0";
    let parabola = "geometry: PlaneStrain, punch: Parabola(radius: 1e-3), force: 200.0";
    let two = "Scene(geometry: PlaneStrain, load: Line, force: 300, stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0), Receding,
        Homogeneous(thickness: 0.8, shear_modulus: 1.5, poisson: 0.25, specific_weight: 1.875), Receding,
        HalfPlane(shear_modulus: 0.75, poisson: 0.25)])"
        .to_owned();
    for text in [on(1.0, uniform, ""), on(0.0, uniform, ""), on(1.0, parabola, ""), two] {
        let scene = Scene::from_ron(&text).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let field = model.field(&solution).unwrap();
        for (number, own) in (1..).zip(solution.closed()) {
            let depth = if number == 1 { 1.0 } else { 1.8 };
            let opening = solution.closed()[0].openings[1];
            let is_last = text.contains("Rigid");
            let v = |x: f64, layer: usize| {
                if layer > 1 && is_last { 0.0 } else { field.at_layer(x, depth, layer).unwrap().v }
            };
            let places = [
                0.0,
                0.5 * opening.left,
                opening.largest_gap_at,
                0.7 * opening.left + 0.3 * opening.right,
                -opening.largest_gap_at,
                1.3 * opening.right,
                -2.0 * opening.right,
            ];
            for x in places {
                let above = field.at_layer(x, depth, number).unwrap();
                let size = own.central_pressure;
                assert!(above.sigma_xy.abs() < 1e-6 * size, "{text} {x}: {above:?}");
                let gap = own.gap(x);
                if gap > 0.0 {
                    assert!(above.sigma_yy.abs() < 1e-6 * size, "{text} {x}: {above:?}");
                } else {
                    assert!(above.sigma_yy < 0.0, "{text} {x}: {above:?}");
                }
                if !is_last {
                    let below = field.at_layer(x, depth, number + 1).unwrap();
                    assert!((above.sigma_yy - below.sigma_yy).abs() < 1e-6 * size, "{text} {x}: {above:?} {below:?}");
                }
                let apart = v(x, number) - v(x, number + 1);
                assert!((apart - gap).abs() < 1e-6 * opening.largest_gap + 1e-9 * size, "{text} {x}: {apart} {gap}");
            }
            let central = field.at_layer(0.0, depth, number).unwrap().sigma_yy;
            assert!((own.central_pressure / central + 1.0).abs() < 1e-7, "{text}: {own:?} {central}");
        }
        assert!(model.profile(&scene.top, &solution, &[0.3, 2.0]).unwrap().contacts.len() > 1);
        assert!(field.max_shear().unwrap().value > 0.0);
    }
}

/// The smallest pressure, and where it is, as fields have it: under loads on both sides of x = 0, and under a contact two hundred times as long as the layer is thick.
#[test]
fn smallest_pressures_are_the_ones_of_fields() {
    let two = "geometry: PlaneStrain, loads: [
        (load: Uniform(half_width: 0.2), at: -0.3, force: 60), (load: Uniform(half_width: 0.2), at: 0.3, force: 60)]";
    let long = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 1.42), force: 0.832, stack: [
        Homogeneous(thickness: 0.0316, shear_modulus: 0.0112, poisson: 0.0, specific_weight: 0.0126), Receding,
        HalfPlane(shear_modulus: 0.0344, poisson: -0.4386)])";
    for text in
        [on(1.0, two, ""), on(1.0, &two.replace("at: -0.3, force: 60", "at: -0.9, force: 20"), ""), long.to_owned()]
    {
        let scene = Scene::from_ron(&text).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let own = &solution.closed()[0];
        let thickness = scene.stack().unwrap().total_thickness();
        let field = model.field(&solution).unwrap();
        let pressure = |x: f64| -field.at_layer(x, thickness, 1).unwrap().sigma_yy;
        let least = pressure(own.smallest_at);
        assert!((least / own.smallest_pressure - 1.0).abs() < 1e-5, "{text}: {least} {own:?}");
        for k in 1..60 {
            let by = 0.05 * f64::from(k * k) * thickness;
            assert!(pressure(own.smallest_at + by) > least && pressure(own.smallest_at - by) > least, "{text}: {by}");
        }
    }
}

/// What is even is solved for on one side: the answer is the one on both sides, also where an opening is about the middle, where a face is graded, and where two interfaces open.
#[test]
fn even_openings_are_the_ones_on_both_sides() {
    let layer = "Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0)";
    let graded = "Exponential(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, beta: 0.5, specific_weight: 1.0)";
    let light = "Homogeneous(thickness: 0.7, shear_modulus: 0.75, poisson: 0.25, specific_weight: 0.01)";
    let stacks =
        [(layer.to_owned(), 3.0, 3), (graded.to_owned(), 0.3, 2), (format!("{layer}, Receding, {light}"), 0.3, 4)];
    for (layers, at, count) in stacks {
        let openings = |other: f64| {
            let text = format!(
                "Scene(geometry: PlaneStrain, loads: [(load: Uniform(half_width: 0.2), at: -{at}, force: 200),
                (load: Uniform(half_width: 0.2), at: {at}, force: {other:?})],
                stack: [{layers}, Receding, HalfPlane(shear_modulus: 0.75, poisson: 0.25)])"
            );
            let (solution, _) = solved(&text).unwrap();
            solution.closed().iter().flat_map(|own| own.openings.clone()).collect::<Vec<_>>()
        };
        let (even, other) = (openings(200.0), openings(200.0 * (1.0 + 1e-11)));
        assert_eq!((even.len(), other.len()), (count, count));
        for (even, other) in even.iter().zip(other) {
            assert!(
                (even.left - other.left).abs() < 1e-8 && (even.right - other.right).abs() < 1e-8,
                "{even:?} {other:?}"
            );
            assert!((even.largest_gap / other.largest_gap - 1.0).abs() < 1e-8, "{even:?} {other:?}");
        }
    }
}

/// What presses on top is carried by every interface below: the integral of the pressure less the weight is the force, whether layers are graded, stiffer along than across, or come apart at
/// several interfaces.
#[test]
fn every_interface_carries_the_force() {
    let graded = "Exponential(thickness: 0.6, shear_modulus: 0.75, beta: 0.5, poisson: 0.25, specific_weight: 1.2)";
    let fibres = "Orthotropic(thickness: 0.4, young: (x: 6.0, y: 1.0, z: 1.0), shear_modulus: 0.5, poisson: (xy: 0.2, xz: 0.2, yz: 0.2), specific_weight: 0.5)";
    let soft = "Homogeneous(thickness: 1.5, shear_modulus: 0.2, poisson: 0.4, specific_weight: 0.3)";
    let base = "HalfPlane(shear_modulus: 0.5, poisson: 0.3)";
    let stacks = [
        format!("{fibres}, Bonded, {graded}, Receding, {base}"),
        format!("{graded}, Receding, {fibres}, Receding, {base}"),
        format!("{fibres}, Receding, {graded}, Receding, {soft}, Receding, {base}"),
    ];
    let tops = [
        "load: Line, force: 300.0",
        "punch: Parabola(radius: 0.002), force: 120.0",
        "loads: [(load: Uniform(half_width: 0.3), at: 0.0, force: 200), (load: Line, at: 2.5, force: 100)]",
    ];
    for (stack, top) in stacks.iter().zip(tops) {
        let text = format!("Scene(geometry: PlaneStrain, {top}, stack: [{stack}])");
        let scene = Scene::from_ron(&text).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        assert!(solution.closed().iter().any(|own| !own.openings.is_empty()), "{text}");
        // places that are dense about the middle, x = 100 sinh s/sinh 6
        let half = 250;
        let steps = (-half..=half).map(|k| 6.0 * f64::from(k) / f64::from(half));
        let (places, lengths): (Vec<f64>, Vec<f64>) = steps
            .map(|s| (100.0 * s.sinh() / 6f64.sinh(), 100.0 * s.cosh() / 6f64.sinh() * 6.0 / f64::from(half)))
            .unzip();
        let profile = model.profile(&scene.top, &solution, &places).unwrap();
        for own in solution.closed() {
            let pressures = &profile.contacts.iter().find(|one| one.interface == own.interface).unwrap().pressure;
            let carried: f64 =
                pressures.iter().zip(&lengths).map(|(pressure, length)| (pressure - own.weight) * length).sum();
            assert!((carried / solution.force() - 1.0).abs() < 2e-3, "{text} {}: {carried}", own.interface);
        }
    }
}

#[test]
fn even_curvature_is_pressed_flat() {
    let line = "geometry: PlaneStrain, load: Line, force: 20.0";
    let flat = on(1.0, line, "");
    let (_, own) = solved(&flat).unwrap();
    for gap in ["Receding(gap: Parabola(radius: 100))", "Receding(gap: Parabola(radius: 1))"] {
        let (_, found) = solved(&flat.replace("Receding", gap)).unwrap();
        assert_eq!(found, own);
    }
    let layer = |eigenstrain: &str| {
        format!("Homogeneous(thickness: 0.5, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0{eigenstrain})")
    };
    // warm above, so that the edges would fall away
    let curled = format!(
        "Scene({line}, stack: [{}, Bonded, {}, Receding, HalfPlane(shear_modulus: 0.75, poisson: 0.25)])",
        layer(", eigenstrain: 1e-3"),
        layer("")
    );
    let (_, found) = solved(&curled).unwrap();
    assert!((found.critical_force / own.critical_force - 1.0).abs() < 1e-11, "{found:?}");
}

#[test]
fn what_cannot_be_is_refused_with_the_reason() {
    let line = "geometry: PlaneStrain, load: Line, force: 20.0";
    let scene = on(1.0, line, "");
    let refused = |text: String, message: &str| {
        let error = solved(&text).expect_err(message).to_string();
        assert!(error.contains(message), "{error}");
    };
    refused(scene.replace("specific_weight: 1.0", "specific_weight: -1.0"), "allowed is a finite number >= 0");
    refused(on(1.0, line, "pressure_on_top: -0.5,"), "allowed is a finite number >= 0");
    refused(
        scene.replace("HalfPlane(", "HalfPlane(specific_weight: 1.0, "),
        "layer 2 (HalfPlane) is a base, and has no weight",
    );
    refused(
        scene.replace("Receding", "Receding(gap: Wedge(slope: 0.1))"),
        "the gap there is neither a parabola nor, in the plane, a dent",
    );
    let error = solved(&on(0.0, "geometry: Axisymmetric, load: Point, force: 200.0", "")).unwrap_err();
    let Error::NoSolution(NoSolution::LiftsOff { critical_force, .. }) = error else { panic!("{error}") };
    assert!((critical_force - 165.742949).abs() < 1e-5);
}

#[test]
fn scenes_with_weights_are_read_again_from_what_is_written() {
    let text = on(1.0, "geometry: PlaneStrain, load: Line, force: 20.0", "pressure_on_top: 0.25,");
    let scene = Scene::from_ron(&text).unwrap();
    let written = scene.to_ron();
    assert!(written.contains("    pressure_on_top: 0.25,\n") && written.contains("specific_weight: 1.0)"), "{written}");
    assert_eq!(Scene::from_ron(&written).unwrap().to_ron(), written);
    assert_eq!(Scene::from_json(&scene.to_json()).unwrap().to_ron(), written);
}

/// Openings on the right of a line load: where they begin and end, the largest gap, and the pressure at x = 0, of two independent programs.
#[test]
fn openings_are_the_ones_of_other_programs() {
    let cases = [
        (0.0, 50.0, [1.51519361381, 2.12291346677], 0.02771697459, 46.9761391257),
        (0.0, 100.0, [1.22846271344, 3.13987706780], 0.9870283479, 93.0780076423),
        (0.0, 300.0, [1.06418742831, 5.11488281598], 12.31864751, 278.706321646),
        (1.0, 150.0, [2.56884140430, 3.33808866078], 0.04229603955, 104.660856680),
        (1.0, 400.0, [1.90833126184, 6.01521709185], 9.568520139, 277.771259432),
        (4.0, 400.0, [3.16972300469, 7.51719100821], 11.90924758, 192.692716937),
        (10.0, 600.0, [4.07232596172, 11.0519583057], 70.90691927, 213.036276392),
    ];
    for (base, force, ends, gap, pressure) in cases {
        let (solution, _) =
            solved(&on(base, &format!("geometry: PlaneStrain, load: Line, force: {force:?}"), "")).unwrap();
        let [own] = solution.closed() else { panic!("one interface") };
        let [left, right] = own.openings[..] else { panic!("{own:?}") };
        assert_eq!((left.left, left.right), (-right.right, -right.left));
        for (found, expected) in [(right.left, ends[0]), (right.right, ends[1])] {
            assert!((found / expected - 1.0).abs() < 1e-10, "{base} {force}: {found} {expected}");
        }
        assert!((right.largest_gap / gap - 1.0).abs() < 1e-9, "{base} {force}: {right:?} {gap}");
        assert!((own.central_pressure / pressure - 1.0).abs() < 1e-10, "{base} {force}: {own:?} {pressure}");
        assert!(own.smallest_pressure >= -1e-6 && right.largest_gap_at > right.left);
    }
}

#[test]
fn punches_and_several_interfaces_open_as_in_other_programs() {
    let parabola = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 1000), force: 200e-6, stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1e-6), Receding,
        HalfPlane(shear_modulus: 0.75, poisson: 0.25)])";
    let two = "Scene(geometry: PlaneStrain, load: Line, force: 300, stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0), Receding,
        Homogeneous(thickness: 0.8, shear_modulus: 1.5, poisson: 0.25, specific_weight: 1.875), Receding,
        HalfPlane(shear_modulus: 0.75, poisson: 0.25)])";
    let uniform = on(1.0, "geometry: PlaneStrain, load: Uniform(half_width: 0.5), force: 200.0", "");
    for (scene, ends) in [
        (parabola, [2.31410918313, 4.09027191350]),
        (two, [2.65959087181, 4.63184508984]),
        (&uniform, [2.42428419355, 4.02429623522]),
    ] {
        let (solution, _) = solved(scene).unwrap();
        let opening = solution.closed()[0].openings[1];
        assert!(
            (opening.left / ends[0] - 1.0).abs() < 1e-10 && (opening.right / ends[1] - 1.0).abs() < 1e-10,
            "{opening:?}"
        );
        assert!(solution.closed().iter().skip(1).all(|own| own.openings.is_empty()));
        if scene == parabola {
            assert!((solution.contacts()[0].half_length().unwrap() / 0.36523568713 - 1.0).abs() < 1e-10);
        }
    }
}

/// Just above the critical force an opening is as short as the square root of what is beyond, and about where it begins.
#[test]
fn openings_begin_with_no_length() {
    let (_, separation) = solved(&on(1.0, "geometry: PlaneStrain, load: Line, force: 20.0", "")).unwrap();
    let half = |beyond: f64| {
        let force = separation.critical_force * (1.0 + beyond);
        let top = format!("geometry: PlaneStrain, load: Line, force: {force:?}");
        let (solution, _) = solved(&on(1.0, &top, "")).unwrap();
        let opening = solution.closed()[0].openings[1];
        assert!((0.5 * (opening.left + opening.right) - separation.x).abs() < 5.0 * beyond, "{opening:?}");
        0.5 * (opening.right - opening.left)
    };
    let [small, smaller] = [1e-4, 1e-6].map(half);
    assert!((small / smaller / 10.0 - 1.0).abs() < 1e-3, "{small} {smaller}");
}

/// A scene moved along x gives moved openings, a mirrored one mirrored openings, and a punch that is not even one opening on each side of another length.
#[test]
fn openings_move_and_turn_with_the_scene() {
    let stack = "stack: [Orthotropic(thickness: 0.4, young: (x: 3.0, y: 1.0, z: 1.0), shear_modulus: 0.5, poisson: (xy: 0.2, xz: 0.2, yz: 0.2), specific_weight: 0.5),
        Bonded, Exponential(thickness: 0.6, shear_modulus: 0.75, beta: 0.5, poisson: 0.25, specific_weight: 1.2), Receding,
        HalfPlane(shear_modulus: 0.5, poisson: 0.3)]";
    let of = |loads: [(f64, f64); 2]| {
        let loads = loads.map(|(at, force)| format!("(load: Uniform(half_width: 0.3), at: {at:?}, force: {force:?})"));
        let scene = format!("Scene(geometry: PlaneStrain, loads: [{}], {stack})", loads.join(", "));
        solved(&scene).unwrap().0.closed()[0].openings.clone()
    };
    let own = of([(0.0, 200.0), (1.5, 100.0)]);
    assert_eq!(own.len(), 2);
    assert!(
        own[0].right - own[0].left < own[1].right - own[1].left - 0.01
            || own[0].right - own[0].left > own[1].right - own[1].left + 0.01
    );
    for (own, moved) in own.iter().zip(of([(7.0, 200.0), (8.5, 100.0)])) {
        assert!((own.left + 7.0 - moved.left).abs() < 1e-9 && (own.right + 7.0 - moved.right).abs() < 1e-9);
        assert!((own.largest_gap / moved.largest_gap - 1.0).abs() < 1e-9);
    }
    for (own, mirrored) in own.iter().zip(of([(-1.5, 100.0), (0.0, 200.0)]).iter().rev()) {
        assert!((own.left + mirrored.right).abs() < 1e-9 && (own.right + mirrored.left).abs() < 1e-9);
    }
}

/// Weight and force times s leave lengths as they are, and make gaps s times as wide.
#[test]
fn gaps_grow_with_weight_and_force() {
    let of = |scale: f64| {
        let scene = on(1.0, &format!("geometry: PlaneStrain, load: Line, force: {:?}", 300.0 * scale), "");
        let scene = scene.replace("specific_weight: 1.0", &format!("specific_weight: {scale:?}"));
        solved(&scene).unwrap().0.closed()[0].openings[1]
    };
    let (one, many) = (of(1.0), of(1e-5));
    assert!((one.left - many.left).abs() < 1e-10 && (one.right - many.right).abs() < 1e-10);
    assert!((many.largest_gap / one.largest_gap / 1e-5 - 1.0).abs() < 1e-10);
    // far above the critical force the gap begins where a layer without weight lifts off
    let loose = on(1.0, "geometry: PlaneStrain, load: Line, force: 1.0", "").replace(", specific_weight: 1.0", "");
    let loose = recede::solve(&Scene::from_ron(&loose).unwrap()).unwrap().contacts()[1].reach();
    let ends: Vec<[f64; 2]> = [1e5, 8e5]
        .map(|force| {
            let (solution, _) =
                solved(&on(1.0, &format!("geometry: PlaneStrain, load: Line, force: {force:?}"), "")).unwrap();
            let opening = solution.closed()[0].openings[1];
            [opening.left, opening.right]
        })
        .to_vec();
    assert!((ends[1][1] / ends[0][1] / 2.0 - 1.0).abs() < 0.05, "{ends:?}");
    assert!(((ends[0][0] - loose) / (ends[1][0] - loose) / 2.0 - 1.0).abs() < 0.05, "{ends:?} {loose}");
}
