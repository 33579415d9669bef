//! Dents: gaps between layers that weights, or forces, press flat but for openings.
//!
//! Goal: numbers of another program; fields carry what the solution says; without weight a dent is any other gap; what cannot be is refused.
use recede::{Force, Model, Scene, Solution};

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

#[test]
fn what_cannot_be_is_refused() {
    let refused = |text: &str, message: &str| {
        let error = solved(text).map(|_| ()).expect_err(message).to_string();
        assert!(error.contains(message), "{error}");
    };
    let punch = "punch: Dent(depth: 1.0, half_width: 1.0), force: 1.0";
    refused(&over_a_dent(0.3, punch), "falls away from its tip without end");
    refused(&over_a_dent(0.3, "punch: Parabola(radius: 1.0), force: 1.0"), "a punch presses on layers with a dent");
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
