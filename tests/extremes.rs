//! Stresses by which layers and bonds break.
use recede::{
    Exponential, Extreme, Extremes, Field, FieldPoint, HalfPlane, Homogeneous, Model, Plane, Point, Punch, Scene,
    Solution, Stack,
};

fn strip(thickness: f64, modulus: f64) -> Homogeneous {
    Homogeneous::new(thickness, modulus, 0.25).expect("legal")
}

fn ground(modulus: f64) -> HalfPlane {
    HalfPlane::new(modulus, 0.25).expect("legal")
}

fn pressed(stack: Stack, punch: &Punch, force: f64) -> (Solution, Field) {
    let model = Model::new(stack).expect("resolved");
    let solution = model.press(punch, force).expect("solved");
    let field = model.field(&solution).expect("its own");
    (solution, field)
}

fn of_scene(path: &str) -> (Solution, Field) {
    solved(&Scene::read(path).expect("legal"))
}

fn solved(scene: &Scene) -> (Solution, Field) {
    let model = Model::new(scene.stack().expect("legal")).expect("resolved");
    let solution = model.press(&scene.top, scene.force).expect("solved");
    let field = model.field(&solution).expect("its own");
    (solution, field)
}

fn value(found: Option<Extreme>) -> f64 {
    found.map_or(0.0, |found| found.value)
}

/// Pressures that are steep next to their ends, loads that overlap, that lie on one side, and about an axis.
const UNLIKE: [(&str, &str); 4] = [
    (
        "nearly flat punch",
        "Scene(geometry: Axisymmetric, punch: Power(exponent: 5.4, radius: 0.07, height: 2e-4), force: 1e-4, stack: [
            Homogeneous(thickness: 2.9, shear_modulus: 0.23, poisson: 0.0), Receding,
            Homogeneous(thickness: 0.53, shear_modulus: 5, poisson: 0.3), Bonded, Rigid])",
    ),
    (
        "loads that overlap",
        "Scene(geometry: PlaneStrain, stack: [
            Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded, HalfPlane(shear_modulus: 0.1, poisson: 0.3)],
            loads: [(load: Parabolic(half_width: 0.6), at: 0.1, force: 0.002), (load: Uniform(half_width: 0.1), at: 0.3, force: 0.001)])",
    ),
    (
        "loads on one side",
        "Scene(geometry: PlaneStrain, stack: [
            Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded, HalfPlane(shear_modulus: 0.1, poisson: 0.3)],
            loads: [(load: Elliptic(half_width: 0.2), at: -3, force: 0.001), (load: Parabolic(half_width: 0.1), at: -2.5, force: 0.001)])",
    ),
    (
        "loaded ring",
        "Scene(geometry: Axisymmetric, load: Ring(radius: 1, half_width: 0.1), force: 0.001, stack: [
            Homogeneous(thickness: 0.5, shear_modulus: 10, poisson: 0.25), Bonded, HalfPlane(shear_modulus: 1, poisson: 0.3)])",
    ),
];

/// The points of a dense mesh: out to several contact lengths, denser about the ends of contacts, with both faces of every layer.
fn everywhere(solution: &Solution, field: &Field) -> Vec<FieldPoint> {
    let longest = solution.extent().expect("a length");
    let bottom = field.layers().fold(longest, |d, (_, [_, to])| if to.is_finite() { d.max(to) } else { d });
    let mut xs: Vec<f64> = (0..240).map(|k| 0.0125 * f64::from(k) * longest).collect();
    xs.extend((0..30).map(|k| (3.0 + 0.4 * f64::from(k)) * longest.max(bottom)));
    for end in solution.contacts().iter().map(recede::Contact::reach) {
        xs.extend([-1e-3, -1e-5, 0.0, 1e-5, 1e-3].map(|s| end * (1.0 + s)));
        xs.extend((0..40).map(|k| 0.05 * f64::from(k) * end));
    }
    let ends = solution.contacts().iter().flat_map(|contact| contact.intervals());
    xs.extend(ends.flat_map(|interval| {
        (-8..=28).map(|k| interval.left + 0.05 * f64::from(k) * (interval.right - interval.left))
    }));
    xs.extend(xs.clone().iter().map(|x| -x));
    xs.sort_by(f64::total_cmp);
    let shortest = solution.contacts()[0].reach();
    let mut depths: Vec<f64> = (0..=40).map(|k| f64::from(k) / 40.0 * 1.5 * bottom.max(longest)).collect();
    depths.extend((1..40).map(|k| 0.05 * f64::from(k) * shortest));
    depths.sort_by(f64::total_cmp);
    let bounded: Vec<f64> = match field.layers().last() {
        Some((_, [_, to])) if to.is_finite() => depths.into_iter().filter(|d| *d < to).chain([to]).collect(),
        _ => depths,
    };
    field.by_layer(&xs, &bounded).expect("inside").iter().flat_map(|grid| grid.points().to_vec()).collect()
}

#[test]
fn nowhere_are_stresses_larger_than_the_largest() {
    let (cylinder, stack) = (Punch::cylinder(500.0).expect("legal"), || Stack::builder(Plane::Strain));
    let graded = |h: f64, beta: f64| Exponential::new(h, 1.0, 0.25, beta).expect("legal");
    let built = |stack: recede::StackBuilder| stack.build().expect("legal");
    let coating = |modulus: f64| built(stack().layer(strip(0.3, modulus)).bonded().layer(ground(1.0)));
    let thin = built(stack().layer(strip(0.02, 50.0)).bonded().layer(strip(1.0, 1.0)).bonded().layer(ground(3.0)));
    let mut cases: Vec<(String, Solution, Field)> = vec![
        ("stiff coating", coating(20.0), 0.002),
        ("very stiff coating under a small contact", coating(2e4), 1e-5),
        ("soft coating", coating(0.05), 0.002),
        ("thin stiff film on a layer", thin, 1e-4),
        (
            "graded on rigid",
            built(stack().layer(graded(1.0, 2.0)).bonded().layer(strip(0.5, 3.0)).bonded().rigid()),
            0.01,
        ),
    ]
    .into_iter()
    .map(|(name, stack, force)| {
        let (solution, field) = pressed(stack, &cylinder, force);
        (name.to_owned(), solution, field)
    })
    .collect();
    for name in [
        "strip_fgm_half_plane",
        "bonded_coating",
        "plate_on_springs",
        "bonded_to_rigid",
        "glued_coating",
        "elastic_roller",
        "../gallery/rail_pad",
    ] {
        let (solution, field) = of_scene(&format!("examples/scenes/{name}.ron"));
        cases.push((name.to_owned(), solution, field));
    }
    for (name, text) in UNLIKE {
        let (solution, field) = solved(&Scene::from_ron(text).expect("legal"));
        cases.push((name.to_owned(), solution, field));
    }
    for (name, solution, field) in cases {
        let Extremes { tension, layers, bonds } = field.extremes().expect("found");
        let within = |found: f64, here: f64, point: &FieldPoint, what: &str| {
            let allowed = found * (1.0 + 2e-6) + 1e-9 * solution.contacts()[0].central_pressure;
            assert!(here <= allowed, "{name}: {what} {found:e}, but {here:e} at {point:?}");
        };
        let shear = field.max_shear().expect("found");
        let there =
            field.points(&[Point { x: shear.x, depth: shear.depth, layer: Some(shear.layer) }]).expect("there")[0];
        assert!((there.max_shear() / shear.value - 1.0).abs() < 1e-8, "{name}: {shear:?} {there:?}");
        for point in everywhere(&solution, &field) {
            within(value(tension), point.principal()[0], &point, "tension");
            within(shear.value, point.max_shear(), &point, "shear stress");
            let layer = layers.iter().find(|of| of.layer == point.layer).expect("one of each layer");
            within(layer.von_mises.expect("known").value, point.von_mises(), &point, "von Mises stress");
            let lower_face = field.layers().any(|(number, [_, to])| number == point.layer && to == point.depth);
            if let Some(bond) = bonds.iter().find(|bond| lower_face && bond.above == point.layer) {
                within(value(bond.shear), point.sigma_xy.abs(), &point, "shear stress at a bond");
                within(value(bond.tension), point.sigma_yy, &point, "tension at a bond");
            }
        }
    }
}

/// A line load has no length: stresses change over the distance from it, though layers are bonded to others that are much thicker.
#[test]
fn tensions_beside_a_line_load_are_found_in_a_thin_layer() {
    let scene = Scene::from_ron(
        "Scene(geometry: PlaneStrain, load: Line, force: 0.001, stack: [
            Exponential(thickness: 1.3, shear_modulus: 60, poisson: 0.4, beta: -4.4), Bonded,
            Homogeneous(thickness: 30, shear_modulus: 80, poisson: 0.1), Receding, HalfPlane(shear_modulus: 0.05, poisson: 0.3)])",
    );
    let (_, field) = solved(&scene.expect("legal"));
    let Extremes { tension, bonds, .. } = field.extremes().expect("found");
    let largest = |depth: f64, of: fn(&FieldPoint) -> f64| {
        let points = (1..160).map(|k| Point { x: 0.05 * f64::from(k), depth, layer: Some(1) }).collect::<Vec<_>>();
        field.points(&points).expect("there").iter().map(of).fold(0.0, f64::max)
    };
    let of_top = largest(0.0, |point| point.principal()[0]);
    let of_bond = largest(1.3, |point| point.sigma_yy);
    for (sampled, found) in [(of_top, value(tension)), (of_bond, value(bonds[0].tension))] {
        assert!(sampled <= found * (1.0 + 2e-6) && found <= 1.01 * sampled, "{sampled:e} {found:e}");
    }
}

/// Where a film far below a short contact lies in a long one, its tensions are small next to the largest pressure, and large next to its own.
#[test]
fn tensions_of_a_film_far_below_are_found() {
    let (solution, field) = of_scene("tests/data/hard/seed_1_number_64.ron");
    let Extremes { bonds, .. } = field.extremes().expect("found");
    let (end, layers) = (solution.contacts()[2].reach(), field.layers().collect::<Vec<_>>());
    for bond in bonds {
        let (layer, depth) = (Some(bond.above), layers[bond.above - 1].1[1]);
        let points: Vec<Point> =
            (0..100).map(|k| Point { x: end * (1.0 + 1e-3 * f64::from(k)), depth, layer }).collect();
        let sampled =
            field.points(&points).expect("there").iter().fold(0.0, |largest: f64, point| largest.max(point.sigma_yy));
        let found = bond.tension.expect("at the end of the contact");
        assert!(found.value > 0.0 && sampled <= found.value * (1.0 + 2e-6), "{sampled:e} {found:?}");
    }
}

#[test]
fn values_are_those_of_the_field_at_their_places() {
    let (_, field) = of_scene("examples/scenes/strip_fgm_half_plane.ron");
    let Extremes { tension, layers, bonds } = field.extremes().expect("found");
    let at = |found: Extreme| {
        assert!(found.error > 0.0 && found.error < 1e-4 * found.value);
        field.points(&[Point { x: found.x, depth: found.depth, layer: Some(found.layer) }]).expect("there")[0]
    };
    let found = tension.expect("the strip bends");
    let same = |here: f64, found: f64| assert!((here / found - 1.0).abs() < 1e-12, "{here} {found}");
    same(at(found).principal()[0], found.value);
    for found in layers.iter().map(|layer| layer.von_mises.expect("known")) {
        same(at(found).von_mises(), found.value);
    }
    assert_eq!((bonds.len(), bonds[0].above, bonds[0].below), (1, 1, 2));
    let [shear, tension] = [bonds[0].shear, bonds[0].tension].map(|found| found.expect("both"));
    same(at(shear).sigma_xy.abs(), shear.value);
    same(at(tension).sigma_yy, tension.value);
    assert!(shear.depth == 1.0 && tension.depth == 1.0);
}

#[test]
fn a_half_plane_is_nowhere_in_tension() {
    let stack = Stack::builder(Plane::Strain).layer(ground(1.0)).build().expect("legal");
    let (solution, field) = pressed(stack, &Punch::parabola(500.0).expect("legal"), 0.002);
    let extremes = field.extremes().expect("found");
    assert!(extremes.tension.is_none() && extremes.bonds.is_empty());
    // McEwen's stresses on the axis, σ_zz = ν (σ_xx + σ_yy): the largest of a function of the depth
    let contact = &solution.contacts()[0];
    let von_mises = |d: f64| {
        let [xx, yy, _] = crate::closed_forms::mcewen::stresses(contact.reach(), contact.central_pressure, 0.0, d);
        let zz = 0.25 * (xx + yy);
        (0.5 * ((xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2))).sqrt()
    };
    let expected = (0..40_000).map(|k| von_mises(f64::from(k) * 5e-5 * contact.reach())).fold(0.0, f64::max);
    let found = extremes.layers[0].von_mises.expect("known");
    assert!((found.value / expected - 1.0).abs() < 1e-7, "{} {expected}", found.value);
}

#[test]
fn under_a_line_load_and_at_corners_they_are_infinite() {
    for (path, x) in [("line_load", 0.0), ("sharp_flat", 0.6)] {
        let (_, field) = of_scene(&format!("examples/scenes/{path}.ron"));
        let extremes = field.extremes().expect("found");
        let [top, other] = [0, 1].map(|k| extremes.layers[k].von_mises.expect("known"));
        assert!(top.value.is_infinite() && (top.x - x).abs() < 1e-12 && top.depth == 0.0, "{path}: {top:?}");
        assert!(other.value.is_finite() && extremes.tension.expect("it bends").value.is_finite(), "{path}");
    }
}

#[test]
fn a_cut_that_is_bonded_changes_nothing() {
    let (punch, stack) = (Punch::cylinder(200.0).expect("legal"), || Stack::builder(Plane::Strain));
    let whole = stack().layer(strip(1.0, 2.0)).bonded().layer(ground(1.0)).build().expect("legal");
    let cut = stack().layer(strip(0.4, 2.0)).bonded().layer(strip(0.6, 2.0)).bonded().layer(ground(1.0));
    let [(_, whole), (_, cut)] = [whole, cut.build().expect("legal")].map(|stack| pressed(stack, &punch, 0.01));
    let (one, two) = (whole.extremes().expect("found"), cut.extremes().expect("found"));
    let close = |a: Option<Extreme>, b: Option<Extreme>, what: &str| {
        assert!((value(a) - value(b)).abs() <= 2e-6 * value(a), "{what}: {a:?} {b:?}");
    };
    close(one.tension, two.tension, "tension");
    close(one.bonds[0].shear, two.bonds[1].shear, "shear stress at the bond");
    close(one.bonds[0].tension, two.bonds[1].tension, "tension at the bond");
    let halves = two.layers[..2].iter().map(|layer| value(layer.von_mises)).fold(0.0, f64::max);
    assert!((halves / value(one.layers[0].von_mises) - 1.0).abs() < 2e-6);
}
