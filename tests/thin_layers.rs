//! Layers that are much thinner than the contact is long.
//!
//! Goal: the thinner a layer, the less it matters, without an end: the answer tends to that without the layer like the
//! ratio of thickness to half-length, it is admissible, its error estimates cover what was left out, and a warning says so.
//!
//! ```text
//!      P (_) R
//!   ══════════════  h → 0, stiff or soft, homogeneous, graded or orthotropic
//!   ██████████████
//! ```
use recede::{Scene, Solution, WarningCode};

const GROUND: &str = "HalfPlane(shear_modulus: 1, poisson: 0.25)";

fn solve(stack: &str) -> Solution {
    let text = format!("Scene(geometry: PlaneStrain, punch: Parabola(radius: 10), force: 1, stack: [{stack}])");
    recede::solve(&Scene::from_ron(&text).unwrap()).unwrap_or_else(|error| panic!("{stack}: {error}"))
}

/// Fails unless all contacts of an answer are those expected within both error estimates and `more`, relative.
fn near(found: &Solution, expected: &Solution, more: f64, what: &str) {
    assert_eq!(found.contacts().len(), expected.contacts().len());
    for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
        let pairs = [
            (
                found.half_length().unwrap(),
                expected.half_length().unwrap(),
                found.half_length_error().unwrap() + expected.half_length_error().unwrap(),
            ),
            (
                found.central_pressure,
                expected.central_pressure,
                found.central_pressure_error + expected.central_pressure_error,
            ),
        ];
        for (found, expected, error) in pairs {
            let difference = (found - expected).abs();
            assert!(difference <= error + more * expected, "{what}: {found} ± {error:e} is not {expected}");
        }
    }
}

#[test]
fn coatings_matter_the_less_the_thinner_they_are() {
    let half_plane = solve(GROUND);
    let coatings = [
        "Homogeneous(thickness: [h], shear_modulus: 10, poisson: 0.3)",
        "Homogeneous(thickness: [h], shear_modulus: 0.1, poisson: 0.3)",
        "Homogeneous(thickness: [h], shear_modulus: 1.2, poisson: 0.3)",
        "Exponential(thickness: [h], shear_modulus: 5, poisson: 0.3, beta: -1[1/h])",
        "Orthotropic(thickness: [h], young: (x: 30, y: 3, z: 3), poisson: (xy: 0.3, xz: 0.3, yz: 0.3), shear_modulus: 1)",
    ];
    for coating in coatings {
        for power in [6, 9, 12, 15] {
            let thickness = 10f64.powi(-power);
            let coating = coating.replace("[h]", &format!("1e-{power}")).replace("[1/h]", &format!("e{power}"));
            let coated = solve(&format!("{coating}, Bonded, {GROUND}"));
            // a stiff layer matters like one some times thicker
            near(&coated, &half_plane, 30.0 * thickness, &coating);
            let contact = &coated.contacts()[0];
            let claimed = contact.half_length_error().unwrap() / contact.half_length().unwrap();
            assert!(claimed < 1e-11 + 100.0 * thickness, "{coating}: {claimed:e}");
            assert!(coated.warnings().iter().any(|warning| warning.code == WarningCode::ThinLayerLeftOut), "{coating}");
        }
    }
}

#[test]
fn what_is_left_out_is_no_more_than_is_said() {
    // answers that are resolved, and the same stack without what the modes would not resolve in a longer contact
    for modulus in [0.1, 10.0] {
        let coated = |power: i32| {
            solve(&format!(
                "Homogeneous(thickness: 1e-{power}, shear_modulus: {modulus:?}, poisson: 0.3), Bonded, {GROUND}"
            ))
        };
        let (half_plane, resolved) = (solve(GROUND), coated(3));
        let change = |solution: &Solution| {
            solution.contacts()[0].half_length().unwrap() / half_plane.contacts()[0].half_length().unwrap() - 1.0
        };
        // proportional to the thickness but for a logarithm
        let thinner = coated(7);
        let ratio = thinner.contacts()[0].half_length_error().unwrap() / thinner.contacts()[0].half_length().unwrap();
        assert!(ratio > 1e-4 * change(&resolved).abs(), "{modulus}: {ratio:e} {:e}", change(&resolved));
    }
}

#[test]
fn a_thin_layer_below_a_loose_strip_is_as_good_as_none() {
    let strip = "Homogeneous(thickness: 1, shear_modulus: 2, poisson: 0.3), Receding";
    let bare = solve(&format!("{strip}, {GROUND}"));
    for power in [6, 9, 12, 15] {
        let layer = format!("Homogeneous(thickness: 1e-{power}, shear_modulus: 0.1, poisson: 0.3)");
        let found = solve(&format!("{strip}, {layer}, Bonded, {GROUND}"));
        near(&found, &bare, 30.0 * 10f64.powi(-power), &layer);
    }
}

#[test]
fn loose_sheets_matter_the_less_the_thinner_they_are() {
    let half_plane = solve(GROUND);
    for modulus in [0.1, 1.0, 10.0] {
        for power in [4, 6, 9, 12] {
            let thickness = 10f64.powi(-power);
            let sheet = format!("Homogeneous(thickness: 1e-{power}, shear_modulus: {modulus:?}, poisson: 0.3)");
            let found = solve(&format!("{sheet}, Receding, {GROUND}"));
            assert_eq!(found.contacts().len(), 2);
            for contact in found.contacts() {
                let expected = &half_plane.contacts()[0];
                let errors = [contact.half_length_error().unwrap(), contact.central_pressure_error];
                let claimed = errors[0] / contact.half_length().unwrap();
                assert!(power == 4 || claimed < 1e-11 + 100.0 * thickness, "{sheet}: {claimed:e}");
                let off = (contact.half_length().unwrap() - expected.half_length().unwrap()).abs();
                assert!(off <= errors[0] + 30.0 * thickness * expected.half_length().unwrap(), "{sheet}: {contact:?}");
                let off = (contact.central_pressure - expected.central_pressure).abs();
                assert!(off <= errors[1] + 30.0 * thickness * expected.central_pressure, "{sheet}: {contact:?}");
                assert!((contact.resultant - 1.0).abs() < 1e-9, "{sheet}: {contact:?}");
            }
        }
    }
}

#[test]
fn a_loose_sheet_is_one_with_the_contact_below_as_far_as_is_said() {
    // answers that modes resolve are proportional to the thickness: extrapolated to thinner layers they agree with these
    let half_plane = solve(GROUND).contacts()[0].half_length().unwrap();
    for modulus in [0.1, 1.0, 10.0, 100.0] {
        let sheet = |power: i32| {
            solve(&format!(
                "Homogeneous(thickness: 1e-{power}, shear_modulus: {modulus:?}, poisson: 0.3), Receding, {GROUND}"
            ))
        };
        let (resolved, thinner) = (sheet(3), sheet(6));
        for (resolved, thinner) in resolved.contacts().iter().zip(thinner.contacts()) {
            assert!(
                resolved.half_length_error().unwrap() < 1e-8 * resolved.half_length().unwrap(),
                "{modulus}: {resolved:?}"
            );
            let change = 1e-3 * (resolved.half_length().unwrap() - half_plane);
            let off = (thinner.half_length().unwrap() - half_plane - change).abs();
            assert!(off <= thinner.half_length_error().unwrap(), "{modulus}: {off:e} {thinner:?}");
        }
    }
}

#[test]
fn several_loose_sheets_are_none() {
    let strip = "Homogeneous(thickness: 1, shear_modulus: 2, poisson: 0.3), Receding";
    let bare = solve(&format!("{strip}, {GROUND}"));
    let sheet = "Homogeneous(thickness: 1e-9, shear_modulus: 1, poisson: 0.3), Receding";
    let found = solve(&format!("{sheet}, {sheet}, {strip}, {sheet}, {GROUND}"));
    assert_eq!(found.contacts().len(), 5);
    for (i, contact) in found.contacts().iter().enumerate() {
        let expected = &bare.contacts()[if i < 3 { 0 } else { 1 }];
        let off = (contact.half_length().unwrap() / expected.half_length().unwrap() - 1.0).abs();
        assert!(off < 1e-7, "{contact:?} {off:e}");
        assert!((contact.central_pressure / expected.central_pressure - 1.0).abs() < 1e-7, "{contact:?}");
    }
}

/// Under equal loads on both faces a laminate of many unlike plies is known to rounding of how it bends only.
#[test]
fn a_laminate_of_many_thin_plies_is_solved() {
    let plies = |count: usize| {
        let ply = |i: usize| {
            format!("Homogeneous(thickness: {:e}, shear_modulus: {}, poisson: 0.25)", 1.0 / count as f64, 1 + i % 2)
        };
        let all: Vec<String> = (0..count).map(ply).collect();
        solve(&format!("{}, Receding, {GROUND}", all.join(", Bonded, ")))
    };
    let (few, many) = (plies(100), plies(500));
    for (few, many) in few.contacts().iter().zip(many.contacts()) {
        assert!(many.half_length_error().unwrap() < 1e-9 * many.half_length().unwrap(), "{many:?}");
        // both are nearly the same material, the faces apart
        assert!((few.half_length().unwrap() / many.half_length().unwrap() - 1.0).abs() < 1e-2, "{few:?} {many:?}");
    }
}
