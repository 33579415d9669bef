//! Contacts about an axis far from where Hertz's formula expects them: discs, and discs with rings about them.
use recede::{Model, Scene};

/// Two numbers that differ by no more than a part of the second.
fn close(found: f64, expected: f64, relative: f64) {
    assert!((found / expected - 1.0).abs() < relative, "{found} {expected}");
}

/// Radii under one punch, all contacts about the axis, as forces grow in even steps of their logarithm.
fn radii(punch: &str, stack: &str, forces: std::ops::Range<f64>, count: usize) -> Vec<f64> {
    let text = format!("Scene(geometry: Axisymmetric, punch: {punch}, force: 1, stack: [{stack}])");
    let scene = Scene::from_ron(&text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let force = |k: usize| forces.start * (forces.end / forces.start).powf(k as f64 / (count - 1) as f64);
    let radius = |force: f64| {
        let solution = model.press(&scene.top, force);
        solution.unwrap_or_else(|error| panic!("{punch}, {stack}, {force}: {error}")).contacts()[0].reach()
    };
    (0..count).map(|k| radius(force(k))).collect()
}

/// A plate on a soft base bends round its punch: Hertz's formula expects contacts that are longer by far.
#[test]
fn no_force_between_two_that_are_solved_for_is_not() {
    let layer = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25)";
    let table = "Table([(0, 0), (0.2, 0.002), (0.4, 0.004), (0.8, 0.008), (1.6, 0.016), (2.4, 0.024), (3, 0.03)])";
    for (punch, joint, modulus, forces) in [
        ("Cone(slope: 0.01)", "Bonded", 0.1, 0.015..0.03),
        ("Cone(slope: 0.01)", "Bonded", 0.01, 0.005..0.0155),
        ("Cone(slope: 0.01)", "Receding", 0.05, 0.005..0.05),
        ("Power(exponent: 1.3, radius: 1, height: 0.01)", "Bonded", 0.01, 0.003..0.3),
        // its edge is far from where the contact ends
        (table, "Bonded", 0.02, 0.009..0.0155),
    ] {
        let stack = format!("{layer}, {joint}, HalfPlane(shear_modulus: {modulus}, poisson: 0.25)");
        let radii = radii(punch, &stack, forces, 15);
        assert!(radii.is_sorted(), "{punch}, {stack}: {radii:?}");
    }
}

/// A stiff plate on a soft base bends away from under a tip, and meets the sides of the punch again farther out.
#[test]
fn a_tip_on_a_plate_touches_in_a_disc_and_in_a_ring() {
    let layer = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25)";
    for (punch, slope, joint, modulus, forces) in [
        ("Cone(slope: 0.01)", 0.01, "Bonded", 0.01, [0.018, 0.1, 0.25]),
        ("Cone(slope: 0.01)", 0.01, "Receding", 0.001, [0.012, 0.02, 0.05]),
        // short gaps far inside
        ("Cone(slope: 0.01)", 0.01, "Bonded", 0.01, [0.2268, 0.2413, 0.2567]),
    ] {
        let text = format!(
            "Scene(geometry: Axisymmetric, punch: {punch}, force: 1, stack: [
                {layer}, {joint}, HalfPlane(shear_modulus: {modulus}, poisson: 0.25)])"
        );
        let scene = Scene::from_ron(&text).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let mut before = 0.0;
        for force in forces {
            let solution = model.press(&scene.top, force).unwrap_or_else(|error| panic!("{text}, {force}: {error}"));
            let contact = &solution.contacts()[0];
            let intervals = contact.intervals();
            let [_, disc, ring] = intervals else { panic!("{text}, {force}: {intervals:?}") };
            assert!(disc.right < ring.left && before < ring.right, "{text}, {force}: {intervals:?}");
            before = ring.right;
            close(contact.resultant, force, 1e-9);
            // the surface is where the punch is, and below it in between
            let surface = model.field(&solution).unwrap();
            let above = |r: f64| surface.at(r, 0.0).unwrap().v - slope * r;
            let places = [0.5 * disc.right, 0.5 * (disc.right + ring.left), 0.5 * (ring.left + ring.right)];
            let [inside, between, outside] = places.map(above);
            let depth = slope * ring.right;
            assert!((inside - outside).abs() < 2e-3 * depth, "{text}, {force}: {inside} {outside} of {depth}");
            assert!(between < outside + 2e-3 * depth, "{text}, {force}: {inside} {between} {outside} of {depth}");
            let largest = contact.peak().pressure * (1.0 + 1e-9);
            let seen = (0..400).map(|k| contact.pressure(ring.right * f64::from(k) / 400.0));
            assert!(seen.into_iter().all(|pressure| pressure <= largest), "{text}, {force}: {largest}");
            // discs of both signs leave a rounding
            assert!(contact.pressure(places[1]).abs() < 1e-9 * contact.pressure(places[2]), "{text}, {force}");
        }
    }
}
