//! Loose layers on layers that weights press together and that come apart in places: contacts and openings in one stack.
//!
//! Goal: fields, which know nothing of the contact equations, say that layers touch where the solution says so and are apart elsewhere; a layer that weighs next to nothing is nearly a
//! loose one; scenes are moved and mirrored with their loads.
use recede::{Field, Model, Scene, Solution};

const GROUND: &str = "HalfPlane(shear_modulus: 0.75, poisson: 0.25)";

fn text_of(top: &str, layers: &str) -> String {
    format!("Scene(geometry: PlaneStrain, {top}, stack: [{layers}])")
}

fn solved(text: &str) -> (Model, Solution) {
    let scene = Scene::from_ron(text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap_or_else(|error| panic!("{error}: {text}"));
    (model, solution)
}

/// One layer with this weight on a heavy one.
fn on_a_heavy_one(weight: f64, base: &str) -> String {
    format!(
        "Homogeneous(thickness: 0.8, shear_modulus: 0.75, poisson: 0.25, specific_weight: {weight:?}), Receding,
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1e-3), Receding, {base}"
    )
}

/// The gap between two layers at a depth, and the pressures on both.
fn between(field: &Field, x: f64, depth: f64, above: usize) -> (f64, [f64; 2]) {
    let [one, other] = [above, above + 1].map(|layer| field.at_layer(x, depth, layer).unwrap());
    (one.v - other.v, [-one.sigma_yy, -other.sigma_yy])
}

#[test]
fn fields_say_where_layers_touch() {
    let two_and_two = format!(
        "Homogeneous(thickness: 0.5, shear_modulus: 1.5, poisson: 0.3), Receding,
        Exponential(thickness: 0.6, shear_modulus: 0.75, poisson: 0.25, beta: 0.8), Receding,
        Homogeneous(thickness: 0.7, shear_modulus: 0.5, poisson: 0.2, specific_weight: 2e-3), Receding,
        Homogeneous(thickness: 0.9, shear_modulus: 1.0, poisson: 0.25, specific_weight: 1e-3), Receding, {GROUND}"
    );
    let one_and_one = || (on_a_heavy_one(0.0, GROUND), &[0.8, 1.0][..]);
    let cases = [
        ("load: Line, force: 0.2", one_and_one()),
        (
            "loads: [(load: Uniform(half_width: 0.3), at: 0.4, force: 0.2), (load: Line, at: -1.5, force: 0.1)]",
            one_and_one(),
        ),
        ("punch: Parabola(radius: 2), force: 0.5", one_and_one()),
        (
            "punches: [(shape: Parabola(radius: 2), at: 0.3, force: 0.3), (shape: Flat(half_width: 0.2), at: 1.8, force: 0.3, tilt: Free(eccentricity: 0.0))]",
            one_and_one(),
        ),
        ("load: Line, force: 1.0", (two_and_two, &[0.5, 0.6, 0.7, 0.9][..])),
    ];
    for (top, (layers, thicknesses)) in cases {
        let text = text_of(top, &layers);
        let (model, solution) = solved(&text);
        assert!(solution.closed().iter().any(|own| !own.openings.is_empty()), "{text}: {:?}", solution.closed());
        let field = model.field(&solution).unwrap();
        let (loose, mut depth) = (solution.contacts().len() - 1, 0.0);
        for (number, thickness) in (1..).zip(thicknesses) {
            depth += thickness;
            if number <= loose {
                let contact = &solution.contacts()[number];
                let [own] = contact.intervals() else { panic!("{contact:?}") };
                let (middle, half) = (0.5 * (own.left + own.right), 0.5 * (own.right - own.left));
                let at = |s: f64| between(&field, middle + s * half, depth, number);
                let [left, right] = [-0.9, 0.9].map(|s| at(s).0);
                let closed = |s: f64| left + (right - left) * (s + 0.9) / 1.8;
                let size = contact.central_pressure;
                for k in -19..=19 {
                    let s = 0.1 * f64::from(k);
                    let (gap, [above, below]) = at(s);
                    assert!((above - below).abs() < 1e-8 * size, "{s}: {above} {below}: {text}");
                    if s.abs() < 1.0 {
                        assert!((gap - closed(s)).abs() < 1e-9 && above > 0.0, "{s}: {gap} {}: {text}", closed(s));
                    } else if s.abs() > 1.0 {
                        assert!(gap > closed(s) && above.abs() < 1e-8 * size, "{s}: {gap} {}: {text}", closed(s));
                    }
                }
                continue;
            }
            let own = &solution.closed()[number - loose - 1];
            for k in -60..=60 {
                let x = 0.17 * f64::from(k);
                let (gap, [above, below]) = between(&field, x, depth, number);
                assert!((gap - own.gap(x)).abs() < 1e-8, "{x}: {gap} {}: {text}", own.gap(x));
                assert!((above - below).abs() < 1e-8 * own.central_pressure, "{x}: {above} {below}: {text}");
                let near = own.openings.iter().any(|one| x > one.left - 1e-3 && x < one.right + 1e-3);
                assert!(if near { above.abs() < 1e-7 } else { above > 0.0 }, "{x}: {above}: {text}");
            }
        }
    }
}

/// Where a layer weighs less and less, its contact with the next one tends to the contact of a loose layer, and is longer by the cube root of the weight.
#[test]
fn a_light_layer_is_nearly_a_loose_one() {
    let of = |weight: f64| solved(&text_of("load: Line, force: 0.2", &on_a_heavy_one(weight, GROUND))).1;
    let loose = of(0.0).contacts()[1].half_length().unwrap();
    let [one, other] = [3e-5, 3.75e-6].map(|weight| of(weight).closed()[0].openings[1].left);
    let [far, near] = [one - loose, other - loose];
    assert!((far / near - 2.0).abs() < 0.3 && near.abs() < 0.1 * loose, "{one:?} {other:?} {loose:?}");
}

#[test]
fn scenes_are_moved_and_mirrored_with_their_loads() {
    let of = |at: [f64; 2]| {
        let top = format!(
            "loads: [(load: Line, at: {:?}, force: 0.2), (load: Uniform(half_width: 0.3), at: {:?}, force: 0.1)]",
            at[0], at[1]
        );
        solved(&text_of(&top, &on_a_heavy_one(0.0, GROUND))).1
    };
    let [own, moved, mirrored] = [[0.0, 1.5], [2.0, 3.5], [0.0, -1.5]].map(of);
    let ends = |solution: &Solution| {
        let contact = solution.contacts()[1].intervals().iter().map(|own| [own.left, own.right]);
        let openings = solution.closed()[0].openings.iter().map(|own| [own.left, own.right]);
        contact.chain(openings).flatten().collect::<Vec<f64>>()
    };
    let [own, moved, mut mirrored] = [&own, &moved, &mirrored].map(ends);
    mirrored.iter_mut().for_each(|x| *x = -*x);
    [&mut mirrored[..2]].into_iter().for_each(<[f64]>::reverse);
    mirrored[2..].reverse();
    assert!(own.len() == 6 && moved.len() == 6 && mirrored.len() == 6, "{own:?}");
    for k in 0..6 {
        assert!(
            (moved[k] - own[k] - 2.0).abs() < 1e-9 && (mirrored[k] - own[k]).abs() < 1e-9,
            "{own:?} {moved:?} {mirrored:?}"
        );
    }
}
