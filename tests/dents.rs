//! Dents: gaps between layers that weights, or forces, press flat but for openings.
//!
//! Goal: numbers of another program; fields carry what the solution says; without weight a dent is any other gap; what cannot be is refused.
use recede::{Force, Model, Options, Pressed, Scene, Solution};

fn solved(text: &str) -> Result<(Model, Solution), recede::Error> {
    let scene = Scene::from_ron(text)?;
    let model = Model::new(scene.stack()?)?;
    let solution = model.press(&scene.top, scene.force)?;
    Ok((model, solution))
}

/// A layer with the compliance 1 of a face over a dent of a rigid base, of depth and half-width 1.
fn over_a_dent(weight: f64, top: &str) -> String {
    format!(
        "Scene(geometry: PlaneStrain, {top}, stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: {weight:?}),
        Receding(gap: Dent(depth: 1.0, half_width: 1.0)), Rigid])"
    )
}

/// Under its weight alone the layer spans the middle of the dent, by an independent program.
#[test]
fn a_layer_spans_a_dent_as_in_another_program() {
    let (_, solution) = solved(&over_a_dent(0.3, "force: 0")).unwrap();
    assert_eq!(solution.force(), 0.0);
    let [opening] = solution.closed()[0].openings[..] else { panic!("{:?}", solution.closed()) };
    assert!((opening.right - 0.59801841470).abs() < 1e-10 && opening.left == -opening.right, "{opening:?}");
    assert!((opening.largest_gap - 0.09414354231).abs() < 1e-10 && opening.largest_gap_at == 0.0, "{opening:?}");
    // twice the weight closes it
    let (_, solution) = solved(&over_a_dent(0.6, "load: Line, force: 0")).unwrap();
    assert!(solution.closed()[0].openings.is_empty());
}

#[test]
fn fields_over_dents_carry_the_pressure_and_close_the_gap() {
    let uneven = "loads: [(load: Uniform(half_width: 0.3), at: 0.5, force: 0.2), (load: Line, at: 3.0, force: 30)]";
    for top in ["load: Line, force: 0.1", "load: Line, force: 20.0", "load: Line, force: 2.0", uneven] {
        let text = over_a_dent(0.3, top);
        let (model, solution) = solved(&text).unwrap();
        let own = &solution.closed()[0];
        assert_eq!(own.openings.is_empty(), top.contains("2.0"), "{top}: {own:?}");
        let field = model.field(&solution).unwrap();
        let at = |x: f64| field.at_layer(x, 1.0, 1).unwrap();
        for k in -12..=12 {
            let x = 0.31 * f64::from(k);
            let (point, gap) = (at(x), own.gap(x));
            assert!(point.sigma_xy.abs() < 1e-8, "{top} {x}: {point:?}");
            if gap > 0.0 {
                assert!(point.sigma_yy.abs() < 1e-8, "{top} {x}: {point:?}");
            } else {
                assert!(point.sigma_yy < 0.0, "{top} {x}: {point:?}");
            }
            // the base does not move: the layer has come down by the dent less the gap that is left
            assert!((point.v + (-x * x).exp() - gap).abs() < 1e-7, "{top} {x}: {} {gap}", point.v);
        }
        assert!((at(0.0).sigma_yy + own.central_pressure).abs() < 1e-8 * (1.0 + own.central_pressure), "{top}");
        assert!((at(60.0).sigma_yy + own.weight).abs() < 1e-6, "{top}");
    }
}

/// The fields of an opening about the middle of what is even are the ones that are computed on both sides.
#[test]
fn openings_about_the_middle_have_no_pressure() {
    let scene = |other: f64| {
        format!(
            "Scene(geometry: PlaneStrain, loads: [(load: Uniform(half_width: 0.2), at: -3.0, force: 200),
            (load: Uniform(half_width: 0.2), at: 3.0, force: {other:?})], stack: [
            Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0), Receding,
            HalfPlane(shear_modulus: 0.75, poisson: 0.25)])"
        )
    };
    let [even, other] = [200.0, 200.0 * (1.0 + 1e-11)].map(|force| {
        let (model, solution) = solved(&scene(force)).unwrap();
        model.field(&solution).unwrap()
    });
    for (x, depth, layer) in
        [(0.0, 1.0, 1), (0.5, 1.0, 1), (-0.5, 1.0, 2), (2.0, 0.4, 1), (-6.0, 1.0, 1), (1.0, 2.0, 2)]
    {
        let [even, other] = [&even, &other].map(|field| field.at_layer(x, depth, layer).unwrap());
        assert!((even.sigma_yy - other.sigma_yy).abs() < 1e-6 && (even.sigma_xx - other.sigma_xx).abs() < 1e-6, "{x}");
        assert!((even.sigma_xy - other.sigma_xy).abs() < 1e-6 && (even.v - other.v).abs() < 1e-5, "{even:?} {other:?}");
        if depth == 1.0 && x.abs() < 1.0 {
            assert!(even.sigma_yy.abs() < 1e-7, "{even:?}");
        }
    }
}

/// Without weight a dent is a gap as any other: the same contact as over a table of its heights, and the answer for a flat base if the dent is shallow.
#[test]
fn without_weight_a_dent_is_a_gap() {
    let scene = |gap: &str, weight: &str| {
        format!(
            "Scene(geometry: PlaneStrain, load: Line, force: 20.0, stack: [
            Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25{weight}), Receding{gap}, Rigid])"
        )
    };
    let reach = |gap: &str| solved(&scene(gap, "")).unwrap().1.contacts()[1].reach();
    let heights: Vec<String> =
        (-60..=60).map(|k| f64::from(k) / 20.0).map(|x: f64| format!("({x:?}, {:?})", 0.1 * (-x * x).exp())).collect();
    let (dent, table) =
        (reach("(gap: Dent(depth: 0.1, half_width: 1.0))"), format!("(gap: Table([{}]))", heights.join(", ")));
    assert!((dent / reach(&table) - 1.0).abs() < 1e-5, "{dent} {}", reach(&table));
    // the layer lies on the shoulders of the dent
    assert!(dent > reach("") && (reach("(gap: Dent(depth: 1e-9, half_width: 1.0))") / reach("") - 1.0).abs() < 1e-8);
}

/// Next to graded faces the kernel of two intervals is taken for a sum of exponentials, which has as many digits as double precision: the strictest tolerance asks for no more.
#[test]
fn layers_touch_beside_a_dent_of_a_graded_face_to_the_strictest_tolerance() {
    let scene = Scene::from_ron(
        "(geometry: PlaneStress, load: Uniform(half_width: 5.5e-5), force: 3e-7, stack: [
            Exponential(thickness: 0.0326, shear_modulus: 26.2, poisson: -0.48, beta: 228),
            Receding(gap: Dent(depth: 0.0315, half_width: 0.105)),
            Exponential(thickness: 0.0316, shear_modulus: 33.6, poisson: 0.33, beta: -235), Bonded, Rigid])",
    )
    .unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let [usual, strictest] = [1e-10, 1e-13].map(|tolerance| {
        let solution = model.press_with(&scene.top, scene.force, &Options { tolerance }).unwrap();
        let intervals = solution.contacts()[1].intervals();
        assert!(intervals.len() == 2 && intervals.iter().all(|own| own.right_error < 1e-10), "{intervals:?}");
        intervals[1].right
    });
    assert!((usual - strictest).abs() < 1e-10, "{usual} {strictest}");
}

#[test]
fn what_cannot_be_is_refused() {
    let refused = |text: &str, message: &str| {
        let error = solved(text).map(|_| ()).expect_err(message).to_string();
        assert!(error.contains(message), "{error}");
    };
    let punch = "punch: Dent(depth: 1.0, half_width: 1.0), force: 1.0";
    refused(&over_a_dent(0.3, punch), "falls away from its tip without end");
    let round = over_a_dent(0.3, "load: Point, force: 1.0")
        .replace("PlaneStrain", "Axisymmetric")
        .replace("half_width", "radius");
    refused(&round, "is neither a parabola nor, in the plane, a dent");
    refused(&over_a_dent(0.3, "load: Line, force: 1.0").replace("depth: 1.0", "depth: -1.0"), "found -1.0, allowed is");
}

/// Without a load there is none in the report either; a force that is next to nothing changes nothing; and where nothing presses there is no problem.
#[test]
fn nothing_but_weights_may_press() {
    let [alone, small] = ["force: 0", "load: Uniform(half_width: 1), force: 1e-9"].map(|top| {
        let scene = Scene::from_ron(&over_a_dent(0.3, top)).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let [_, depth] = model.field(&solution).unwrap().window()[1];
        assert!(depth == 1.0 && model.ledger(&scene.top, &solution).unwrap().rows.len() > 1);
        (
            scene.to_ron(),
            model.separation(&scene.top, &solution).unwrap(),
            model.field(&solution).unwrap().max_shear().unwrap().value,
            solution,
        )
    });
    assert!((alone.2 / small.2 - 1.0).abs() < 1e-6, "{} {}", alone.2, small.2);
    assert!(
        alone.1.is_none() && (alone.3.contacts()[0].resultant, alone.3.contacts()[0].central_pressure) == (0.0, 0.0)
    );
    let [one, other] = [&alone.3, &small.3].map(|solution| solution.closed()[0].openings[0].right);
    assert!((one - other).abs() < 1e-7, "{one} {other}");
    // it is written, and read again
    assert_eq!(Scene::from_ron(&alone.0).unwrap().force, Force::Given(0.0));
    let refused = |text: &str| Scene::from_ron(text).unwrap_err().to_string();
    assert!(refused(&over_a_dent(0.0, "force: 0")).contains("`punch` is missing"));
    assert!(refused(&over_a_dent(0.0, "load: Line, force: 0")).contains("allowed is a finite number > 0"));
    assert!(
        refused(&over_a_dent(0.3, "punch: Parabola(radius: 1), force: 0")).contains("allowed is a finite number > 0")
    );
    let loose = Scene::from_ron(&over_a_dent(0.0, "load: Line, force: 1")).unwrap();
    let error = Model::new(loose.stack().unwrap()).unwrap().press(&loose.top, 0.0).unwrap_err();
    assert!(error.to_string().starts_with("the force is 0"), "{error}");
}

/// Depth and width of a dent, and what presses above it.
fn pressed_over(weight: f64, dent: &str, top: &str) -> String {
    format!(
        "Scene(geometry: PlaneStrain, {top}, stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: {weight:?}), Bonded,
        Exponential(thickness: 0.5, shear_modulus: 0.75, poisson: 0.25, beta: 0.5, specific_weight: {weight:?}),
        Receding(gap: Dent({dent})), Rigid])"
    )
}

/// Where a punch touches, the top face, which dents have lowered, follows it; beside its contact there is a gap.
#[test]
fn a_punch_touches_the_face_that_a_dent_lowers() {
    let cases = [
        ("depth: 2e-3, half_width: 1.5", "punch: Parabola(radius: 50), force: 0.02"),
        ("depth: 2e-2, half_width: 1.0", "punch: Flat(half_width: 0.7), force: 0.05"),
        (
            "depth: 2e-3, half_width: 1.5",
            "punches: [(shape: Cylinder(radius: 20), at: 0.8, force: 0.01), (shape: Wedge(slope: 0.1), at: -2, force: 0.02)]",
        ),
        ("depth: 2e-3, half_width: 1.5", "punch: Parabola(radius: 5), force: 0.3"),
        ("depth: 2e-3, half_width: 1.5", "punches: [(shape: Parabola(radius: 5), at: 1.2, force: 0.3)]"),
    ];
    for (number, (dent, top)) in cases.into_iter().enumerate() {
        let text = pressed_over(if number < 3 { 0.1 } else { 1e-3 }, dent, top);
        let scene = Scene::from_ron(&text).unwrap();
        let (model, solution) = solved(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
        assert_eq!(solution.closed()[0].openings.is_empty(), number < 3, "{text}");
        let (field, depths) = (model.field(&solution).unwrap(), model.approaches(&scene.top, &solution));
        for own in solution.contacts()[0].intervals() {
            let (middle, half) = (0.5 * (own.left + own.right), 0.5 * (own.right - own.left));
            let parts = scene.top.punches().unwrap().parts().zip(&depths);
            let distance = |pressed: &Pressed| (pressed.at() - middle).abs();
            let nearest = parts.min_by(|((one, _), _), ((other, _), _)| distance(one).total_cmp(&distance(other)));
            let ((pressed, _), depth) = nearest.unwrap();
            for x in (-9..=9).map(|k| middle + 0.1 * half * f64::from(k)) {
                let height = pressed.shape().profile(x - pressed.at()) - depth.as_ref().unwrap().value;
                let v = field.at_layer(x, 0.0, 1).unwrap().v;
                assert!((height - v).abs() < 1e-9, "{x}: {height} {v}: {text}");
            }
        }
    }
}

/// A dent much wider than the layers are thick is a hollow of the radius c²/(2d) in the top face, and one that is much narrower lets it be.
#[test]
fn wide_dents_are_hollows_of_the_face() {
    let half_length = |dent: &str, radius: f64| {
        let punch = format!("punch: Parabola(radius: {radius:?}), force: 0.02");
        solved(&pressed_over(0.1, dent, &punch)).unwrap().1.contacts()[0].half_length().unwrap()
    };
    let flat = half_length("depth: 1e-12, half_width: 1.0", 50.0);
    let wide = half_length("depth: 20.0, half_width: 100.0", 50.0 / 1.2);
    assert!((wide / flat - 1.0).abs() < 1e-4, "{wide} {flat}");
    let narrow = half_length("depth: 1e-4, half_width: 0.01", 50.0);
    assert!((narrow / flat - 1.0).abs() < 1e-4, "{narrow} {flat}");
}

/// A punch that has sunk by the depth that a force makes is pressed with that force.
#[test]
fn depths_over_dents_lead_back_to_forces() {
    for (weight, force) in [(0.1, 0.02), (1e-3, 0.3)] {
        let punch = format!("punch: Parabola(radius: 5), force: {force:?}");
        let text = pressed_over(weight, "depth: 2e-3, half_width: 1.5", &punch);
        let (scene, (model, solution)) = (Scene::from_ron(&text).unwrap(), solved(&text).unwrap());
        let depth = model.approach(&scene.top, &solution).unwrap().value;
        let found = model.press(&scene.top, Force::ForDepth(depth)).unwrap();
        assert!((found.force() / force - 1.0).abs() < 1e-9, "{} {force}", found.force());
    }
}

/// A loose layer without weight lies on the face that a dent below lowers: where it touches, both faces are one.
#[test]
fn loose_layers_lie_on_what_dents_lower() {
    for top in ["load: Line, force: 1e-4", "loads: [(load: Line, at: 0.3, force: 1e-4)]"] {
        let text = format!(
            "Scene(geometry: PlaneStrain, {top}, stack: [
            Homogeneous(thickness: 1, shear_modulus: 0.75, poisson: 0.25), Receding,
            Homogeneous(thickness: 1, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1e-3),
            Receding(gap: Dent(depth: 1e-4, half_width: 0.8)), Rigid])"
        );
        let (model, solution) = solved(&text).unwrap();
        let [own] = solution.contacts()[1].intervals() else { panic!("{:?}", solution.contacts()[1]) };
        let places = [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0].map(|part| own.left + part * (own.right - own.left));
        let field = model.field(&solution).unwrap();
        let v = |layer: usize, k: usize| field.at_layer(places[k], 1.0, layer).unwrap().v;
        let gap = |k: usize| v(1, k) - v(2, k);
        // the loose layer may have turned about x = 0, and moved
        let slope = (gap(5) - gap(1)) / (places[5] - places[1]);
        for k in 0..places.len() {
            let expected = gap(1) + slope * (places[k] - places[1]);
            assert!((gap(k) - expected).abs() < 1e-11, "{k}: {} {expected}: {text}", gap(k));
        }
    }
}
