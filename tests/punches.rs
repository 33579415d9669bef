//! Punches of any profile.
//!
//! Goal: on a homogeneous half-plane, whatever it is made of, each punch makes the contact of its closed form; on layers
//! punches that are the same by another name make the same contact; and where nothing is known in closed form, both methods
//! agree.
//!
//! Source: `crate::closed_forms::punches` and `crate::closed_forms::hertz`.
use std::f64::consts::PI;

use crate::closed_forms::{Elastic, hertz, punches};
use recede::{Exponential, HalfPlane, Homogeneous, Interval, Model, Options, Plane, Punch, Scene, Solution, Stack};

use crate::support::outwards;

const MATERIAL: Elastic = Elastic { shear_modulus: 2.0, kappa: 1.8 };

fn ground() -> HalfPlane {
    HalfPlane::new(2.0, 0.3).unwrap()
}

/// A half-plane by three names: alone, below a layer of its own material, below slices.
fn half_planes() -> Vec<Model> {
    let layer = |h: f64| Homogeneous::new(h, 2.0, 0.3).unwrap();
    let stack = || Stack::builder(Plane::Strain);
    [
        stack().layer(ground()),
        stack().layer(layer(0.2)).bonded().layer(ground()),
        stack().layer(layer(0.5)).bonded().layer(layer(1.5)).bonded().layer(ground()),
    ]
    .map(|stack| Model::new(stack.build().unwrap()).unwrap())
    .into()
}

/// Layers that recede, also a graded one.
fn layered() -> Vec<Model> {
    let stack = || Stack::builder(Plane::Strain);
    let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    [
        stack().layer(strip()).receding().layer(HalfPlane::new(0.5, 0.3).unwrap()),
        stack().layer(Exponential::new(1.0, 1.0, 0.3, 1.2).unwrap()).receding().layer(strip()).receding().rigid(),
        stack().layer(Exponential::new(0.8, 2.0, 0.25, -1.5).unwrap()).bonded().layer(ground()),
    ]
    .map(|stack| Model::new(stack.build().unwrap()).unwrap())
    .into()
}

fn close(found: f64, expected: f64, error: f64, what: &str) {
    assert!(
        (found / expected - 1.0).abs() <= error,
        "{what}: {found:e}, expected {expected:e}, error allowed {error:e}"
    );
}

/// Half-length and pressure at x = 0 with their estimated errors cover what is expected, and the estimates are small.
fn assert_contact(solution: &Solution, half_length: f64, peak: f64, what: &str) {
    let contact = &solution.contacts()[0];
    let allowed = contact.half_length_error().unwrap() / contact.half_length().unwrap() + 1e-12;
    assert!(allowed < 1e-10, "{what}: {contact:?}");
    close(contact.half_length().unwrap(), half_length, allowed, what);
    if peak.is_finite() {
        let allowed = contact.central_pressure_error / contact.central_pressure + 1e-12;
        assert!(allowed < 1e-9, "{what}: {allowed}");
        close(contact.central_pressure, peak, allowed, what);
    } else {
        assert_eq!((contact.central_pressure, contact.central_pressure_error), (f64::INFINITY, 0.0), "{what}");
    }
    assert_eq!(solution.warnings(), [], "{what}");
}

#[test]
fn powers_make_the_contacts_of_steuermann() {
    for model in half_planes() {
        for (exponent, half_length) in
            [(1.25, 0.3), (1.5, 2.0), (2.0, 0.7), (3.0, 0.05), (4.0, 1.3), (7.3, 0.8), (20.0, 1.0)]
        {
            let (half_width, height) = (1.7f64, 0.01);
            let coefficient = height / half_width.powf(exponent);
            let force = punches::power_force(MATERIAL, exponent, coefficient, half_length);
            let punch = Punch::power(exponent, half_width, height).unwrap();
            let peak = punches::power_central_pressure(MATERIAL, exponent, coefficient, half_length);
            assert_contact(&model.press(&punch, force).unwrap(), half_length, peak, &punch.to_string());
        }
    }
}

#[test]
fn polynomials_are_sums_of_powers() {
    let (a, half_width, heights) = (0.9, 1.2, [0.01, 0.0, 0.004, 0.002]);
    let terms = || heights.iter().zip([2i32, 4, 6, 8]).map(|(h, n)| (f64::from(n), h / f64::powi(half_width, n)));
    let force: f64 = terms().map(|(n, c)| punches::power_force(MATERIAL, n, c, a)).sum();
    let peak: f64 = terms().map(|(n, c)| punches::power_central_pressure(MATERIAL, n, c, a)).sum();
    let punch = Punch::polynomial(half_width, &heights).unwrap();
    for model in half_planes() {
        assert_contact(&model.press(&punch, force).unwrap(), a, peak, "polynomial");
    }
}

#[test]
fn under_a_wedge_the_pressure_is_a_logarithm() {
    let punch = Punch::wedge(0.02).unwrap();
    for model in half_planes() {
        for force in [0.003, 0.1] {
            let a = punches::wedge_half_length(MATERIAL, 0.02, force);
            let solution = model.press(&punch, force).unwrap();
            assert_contact(&solution, a, f64::INFINITY, "wedge");
            for s in [1e-9, 1e-4, 0.02, 0.1, 0.5, 0.9, 0.999] {
                let known = punches::wedge_pressure(MATERIAL, 0.02, a, s * a);
                close(solution.contacts()[0].pressure(s * a), known, 1e-10, &format!("pressure of a wedge at {s}"));
                let stress = -model.field(&solution).unwrap().at(s * a, 0.0).unwrap().sigma_yy;
                close(stress, known, 1e-8, &format!("stress under a wedge at {s}"));
            }
            assert_eq!(solution.contacts()[0].pressure(0.0), f64::INFINITY);
        }
    }
}

/// The faces of a wedge, and the surface of a cone, rise by the cotangent of their angle with the axis.
#[test]
fn a_half_angle_is_the_slope_that_is_its_cotangent() {
    let scene = |geometry: &str, punch: &str| {
        let text = format!(
            "Scene(geometry: {geometry}, punch: {punch}, force: 0.01, stack: [
            Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, HalfPlane(shear_modulus: 2, poisson: 0.3)])"
        );
        Scene::from_ron(&text).unwrap()
    };
    for (geometry, name) in [("PlaneStrain", "Wedge"), ("Axisymmetric", "Cone")] {
        for degrees in [45.0f64, 60.0, 70.3, 80.0, 89.9] {
            let radians = degrees.to_radians();
            let slope = radians.cos() / radians.sin();
            let by_slope = scene(geometry, &format!("{name}(slope: {slope:?})"));
            for angle in [
                format!("{radians:?}"),
                format!("\"{degrees} deg\""),
                format!("\"{degrees}°\""),
                format!("\"{radians:?} rad\""),
            ] {
                let by_angle = scene(geometry, &format!("{name}(half_angle: {angle})"));
                for x in [0.1, 1.0, 30.0] {
                    let (found, expected) =
                        (by_angle.top.punch().unwrap().profile(x), by_slope.top.punch().unwrap().profile(x));
                    assert!((found / expected - 1.0).abs() < 1e-13, "{angle}: {found} {expected}");
                }
                // as it was written, and so again
                assert!(by_angle.to_ron().contains("(half_angle: "), "{}", by_angle.to_ron());
                for again in
                    [Scene::from_ron(&by_angle.to_ron()).unwrap(), Scene::from_json(&by_angle.to_json()).unwrap()]
                {
                    assert_eq!((&again.top, again.to_ron()), (&by_angle.top, by_angle.to_ron()));
                }
                assert!(by_angle.paths().contains(&"punch.half_angle".to_owned()));
                assert_eq!(by_angle.with("punch.half_angle", 1.0).unwrap().number("punch.half_angle").unwrap(), 1.0);
            }
            if degrees > 75.0 {
                let by_angle = scene(geometry, &format!("{name}(half_angle: {radians:?})"));
                let [found, expected] = [&by_angle, &by_slope].map(|scene| recede::solve(scene).unwrap());
                for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
                    close(found.reach(), expected.reach(), 1e-9, geometry);
                }
            }
        }
    }
    let vary = ["sweep", "-", "--vary", "punch.half_angle=[1.4,1.5]"];
    let text = "(geometry: Axisymmetric, punch: Cone(half_angle: \"70.3 deg\"), force: 1e-3, stack: [HalfPlane(shear_modulus: 1, poisson: 0.3)])";
    let rows = crate::support::recede(&vary, text.as_bytes());
    assert!(
        rows.stdout.starts_with("punch_half_angle,") && rows.stdout.matches(",solved,").count() == 2,
        "{}",
        rows.stderr
    );
}

#[test]
fn flat_punches_with_round_corners_are_those_of_schubert() {
    for model in half_planes() {
        for (flat, a) in [(0.0, 0.4), (0.1, 0.4), (0.5, 0.8), (1.0, 1.05), (2.0, 2.001), (1e-4, 0.7)] {
            let force = punches::rounded_flat_force(MATERIAL, flat, 50.0, a);
            let solution = model.press(Punch::rounded_flat(flat, 50.0).unwrap(), force).unwrap();
            let at = |x: f64| punches::rounded_flat_pressure(MATERIAL, flat, 50.0, a, x);
            assert_contact(&solution, a, at(0.0), &format!("flat to {flat} of {a}"));
            for s in [0.2, 0.77, 0.97] {
                close(
                    solution.contacts()[0].pressure(s * a),
                    at(s * a),
                    1e-4,
                    &format!("flat to {flat} of {a} at {s}"),
                );
            }
        }
    }
}

#[test]
fn elastic_cylinders_share_the_flattening() {
    // compliances add up: as if the half-plane were softer
    let material = Elastic::plane_strain(3.0, 0.2);
    let together = 1.0 / (1.0 / MATERIAL.plane_modulus() + 1.0 / material.plane_modulus());
    let equivalent = Elastic { shear_modulus: 0.25 * together, kappa: 1.0 };
    for model in half_planes() {
        let exact = hertz::cylinder(equivalent, 20.0, 0.05).unwrap();
        let punch = Punch::elastic_cylinder(20.0, 3.0, 0.2).unwrap();
        let solution = model.press(&punch, 0.05).unwrap();
        close(solution.contacts()[0].half_length().unwrap(), exact.half_length(), 1e-10, "elastic cylinder");
        close(solution.contacts()[0].central_pressure, exact.central_pressure(), 1e-9, "elastic cylinder");
        let checked = model.collocate(&punch, &solution).unwrap();
        assert!(checked[0].residual.abs() < 1e-9 && checked[0].pressure_difference < 1e-8, "{checked:?}");
    }
    for model in layered() {
        let rigid = model.press(Punch::cylinder(100.0).unwrap(), 0.01).unwrap();
        let stiff = model.press(Punch::elastic_cylinder(100.0, 1e14, 0.3).unwrap(), 0.01).unwrap();
        assert_same(&stiff, &rigid, 1e-11, "stiff cylinder");
    }
}

fn assert_same(found: &Solution, expected: &Solution, error: f64, what: &str) {
    for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
        close(found.half_length().unwrap(), expected.half_length().unwrap(), error, what);
        close(found.central_pressure, expected.central_pressure, 10.0 * error, what);
    }
}

#[test]
fn on_layers_a_punch_is_the_same_by_any_name() {
    let parabola = Punch::parabola(50.0).unwrap();
    let rows: Vec<(f64, f64)> = (0..40).map(|i| 0.1 * f64::from(i)).map(|x| (x, 3.0 + 0.01 * x * x)).collect();
    let names = [
        Punch::power(2.0, 3.0, 0.09).unwrap(),
        Punch::polynomial(3.0, &[0.09]).unwrap(),
        Punch::polynomial(1.0, &[0.01, 0.0]).unwrap(),
        Punch::rounded_flat(0.0, 50.0).unwrap(),
        Punch::table(&rows).unwrap(),
    ];
    for model in layered() {
        let expected = model.press(&parabola, 0.02).unwrap();
        for punch in &names {
            assert_same(&model.press(punch, 0.02).unwrap(), &expected, 1e-10, &punch.to_string());
        }
        let (power, polynomial) = (Punch::power(4.0, 2.0, 0.3).unwrap(), Punch::polynomial(2.0, &[0.0, 0.3]).unwrap());
        assert_same(&model.press(&power, 0.1).unwrap(), &model.press(&polynomial, 0.1).unwrap(), 1e-10, "fourth power");
        let (wedge, power) = (Punch::wedge(0.05).unwrap(), Punch::power(1.0, 2.0, 0.1).unwrap());
        let found = [wedge, power].map(|punch| model.press(&punch, 0.02).unwrap());
        assert_eq!(found[0].contacts()[0].half_length().unwrap(), found[1].contacts()[0].half_length().unwrap());
    }
}

#[test]
fn a_table_of_both_sides_is_that_of_one_if_they_are_the_same() {
    let right = [(0.0, 0.0), (0.5, 0.01), (1.0, 0.05), (2.0, 0.3)];
    let both: Vec<(f64, f64)> = right[1..].iter().rev().map(|(x, height)| (-x, *height)).chain(right).collect();
    let [half, whole] = [&right[..], &both].map(|rows| Punch::table(rows).unwrap());
    for model in layered() {
        let [half, whole] = [&half, &whole].map(|punch| model.press(punch, 0.02).unwrap());
        assert_eq!(half.contacts(), whole.contacts());
    }
}

#[test]
fn uneven_punches_are_read_written_swept_and_pressed_by_forces() {
    let table = "Table([(-2, 0.2), (-1, 0.06), (0, 0), (1, 0.05), (2, 0.3)])";
    let (force, depth) = ("force: 0.02", "depth: 0.001");
    for punch in ["Wedge(slope: 0.1, left: 0.2)", table] {
        for given in [force, "half_length: 0.5", depth] {
            let text = format!(
                "Scene(geometry: PlaneStrain, punch: {punch}, {given},
                 stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])"
            );
            let scene = Scene::from_ron(&text).unwrap();
            let own = scene.top.punch().unwrap();
            assert!(!own.is_even());
            for again in [Scene::from_ron(&scene.to_ron()).unwrap(), Scene::from_json(&scene.to_json()).unwrap()] {
                assert_eq!(again.top.punch(), Some(own));
            }
            let model = Model::new(scene.stack().unwrap()).unwrap();
            let found = model.press(&scene.top, scene.force);
            if given == force {
                let solution = found.unwrap();
                let contact = &solution.contacts()[0];
                assert!(contact.half_length().is_none() && (contact.resultant / 0.02 - 1.0).abs() < 1e-12);
                let checked = model.collocate(&scene.top, &solution).unwrap();
                assert!(checked.iter().all(|contact| contact.residual < 1e-9), "{checked:?}");
                continue;
            }
            let error = scene.locate(found.unwrap_err());
            assert!(error.is_input() && error.hint().is_some(), "{error}");
        }
    }
    let text = "Scene(geometry: PlaneStrain, punch: Wedge(slope: 0.1, left: 0.2), force: 0.02,
         stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])";
    let uneven = Scene::from_ron(text).unwrap();
    assert_eq!(uneven.paths()[1..3], ["punch.slope", "punch.left"]);
    let even = uneven.with("punch.left", 0.1).unwrap();
    let wedge = Punch::wedge(0.1).unwrap();
    let model = Model::new(even.stack().unwrap()).unwrap();
    let [found, expected] = [even.top.clone(), wedge.into()].map(|top| model.press(top, 0.02).unwrap());
    assert_eq!(found.contacts(), expected.contacts());
}

/// In u = x² the two intervals b < |x| < a of a half-plane are one, with the middle m and half its length w, and
/// f'(x)/x = 2h₁ + 4h₂u + 6h₃u² is what a punch of one interval has as its slope: it must have no mean over the interval, with
/// the weight of Chebyshev, and its first moment is the force.
#[test]
fn a_profile_that_falls_from_its_tip_touches_in_the_two_intervals_of_its_closed_form() {
    let mut solved = 0;
    let stiffness = 2.0 * MATERIAL.shear_modulus * 4.0 / (MATERIAL.kappa + 1.0);
    for [b, a] in [[1.0, 2.0], [1.9, 2.0], [1.9999, 2.0], [0.3, 2.0], [0.1, 2.0], [30.0, 50.0]] {
        for [h2, h3] in [[-0.002, 0.0005], [0.001, 0.0], [0.002, -1e-7]] {
            let (m, w) = (0.5 * (a * a + b * b), 0.5 * (a * a - b * b));
            let h1 = -2.0 * h2 * m - 3.0 * h3 * (m * m + 0.5 * w * w);
            let force = 0.5 * stiffness * 0.5 * PI * w * w * (4.0 * h2 + 12.0 * h3 * m);
            let punch = Punch::polynomial(1.0, &[h1, h2, h3]).unwrap();
            // the pressure is that of one interval times a linear function of u
            let pressures = [-w, w].map(|off| 4.0 * h2 + 12.0 * h3 * m + 6.0 * h3 * off);
            if pressures.iter().any(|p| *p <= 0.0) || punch.max_half_length().is_some_and(|edge| edge < 1.1 * a) {
                continue;
            }
            solved += 1;
            for model in half_planes() {
                let solution = model.press(&punch, force).unwrap();
                let contact = &solution.contacts()[0];
                let what = format!("{punch} from {b} to {a}: {contact:?}");
                let Interval { left, left_error, right, right_error, .. } = outwards(contact)[0];
                close(left, b, left_error / b + 1e-11, &what);
                close(right, a, right_error / a + 1e-12, &what);
                assert!(right_error < 1e-9 * a && left_error < 1e-9 * a, "{what}");
            }
        }
    }
    assert!(solved >= 10, "{solved}");
}

#[test]
fn a_profile_that_falls_farther_out_touches_there_as_well_or_is_refused_at_its_edge() {
    // as low as the tip at x = 2, and lower
    let rows = |low: f64| [(0.0, 0.0), (1.0, 0.1), (2.0, low), (3.0, 0.5), (4.0, 1.6)];
    for model in layered() {
        let twice = Punch::table(&rows(0.02)).unwrap();
        let both = model.press(&twice, 0.5).unwrap();
        assert_eq!(outwards(&both.contacts()[0]).len(), 2, "{both:?}");
        // next to no force: at the lowest place only, wherever that is
        let outside = model.press(Punch::table(&rows(-0.05)).unwrap(), 1e-4).unwrap();
        let [Interval { left, .. }] = outwards(&outside.contacts()[0])[..] else { panic!("{outside:?}") };
        assert!((1.5..2.5).contains(&left), "{outside:?}");
        let falling = Punch::table(&[(0.0, 0.0), (1.0, 0.5), (2.0, -1.0)]).unwrap();
        for punch in [falling, Punch::table(&[(0.0, 1.0), (1.0, 0.0)]).unwrap()] {
            let refused = model.press(&punch, 1e-3).unwrap_err().to_string();
            assert!(refused.contains("the contact would reach its edge"), "{refused}");
        }
    }
}

#[test]
fn punches_depend_continuously_on_their_form() {
    for model in layered() {
        let parabola = model.press(Punch::parabola(50.0).unwrap(), 0.02).unwrap();
        for (error, punch) in [
            (1e-5, Punch::power(2.000_001, 1.0, 0.01).unwrap()),
            (1e-5, Punch::rounded_flat(1e-6, 50.0).unwrap()),
            (1e-5, Punch::polynomial(1.0, &[0.01, 1e-9]).unwrap()),
        ] {
            assert_same(&model.press(&punch, 0.02).unwrap(), &parabola, error, &punch.to_string());
        }
    }
}

#[test]
fn both_methods_agree_on_layers() {
    for (i, model) in layered().iter().enumerate() {
        for punch in [
            Punch::power(4.0, 2.0, 0.3).unwrap(),
            Punch::power(1.5, 2.0, 0.1).unwrap(),
            Punch::wedge(0.03).unwrap(),
            Punch::rounded_flat(0.4, 20.0).unwrap(),
        ] {
            let found = model.press_with(&punch, 0.02, &Options { tolerance: 1e-11 }).unwrap();
            let contacts = found.contacts();
            assert!(
                contacts.iter().all(|c| c.half_length_error().unwrap() < 1e-9 * c.half_length().unwrap()),
                "stack {i}, {punch}: {found:?}"
            );
            let checked = model.collocate(&punch, &found).unwrap();
            assert!(checked.iter().all(|contact| contact.residual < 1e-8), "stack {i}, {punch}: {checked:?}");
        }
    }
}
