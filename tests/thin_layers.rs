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
use recede::{Model, Options, Scene, Solution, WarningCode};

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
            // infinite pressures are the same
            let difference = if found == expected { 0.0 } else { (found - expected).abs() };
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

/// Bases that are graded from the surface on have no length of their own, and are stiffer or softer than any layer to waves that are long enough:
/// a slab on them is thin next to no contact that there is.
#[test]
fn no_layer_is_thin_next_to_a_contact_that_is_only_expected() {
    let scene = |shape: &str, force: f64, thickness: f64, exponent: f64| {
        format!(
            "Scene(geometry: PlaneStrain, punch: {shape}, force: {force:e}, stack: [
                Homogeneous(thickness: {thickness:?}, shear_modulus: 0.1, poisson: 0.3), Receding,
                PowerHalfPlane(shear_modulus: 0.64, poisson: 0.3, length: 1.9, exponent: {exponent})])"
        )
    };
    let flat = |half_width: f64| format!("RoundedFlat(half_width: {half_width}, radius: 506)");
    for (half_width, force, exponent) in [(5.64, 4e-4, 0.2), (50.0, 4e-3, 0.1), (9.0, 1e-6, 0.6)] {
        let text = scene(&flat(half_width), force, 1.76, exponent);
        let solution =
            recede::solve(&Scene::from_ron(&text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"));
        let is_left_out = |warning: &recede::Warning| warning.code == WarningCode::ThinLayerLeftOut;
        assert!(!solution.warnings().iter().any(is_left_out), "{text}: {:?}", solution.warnings());
        let [top, below] = [0, 1].map(|i| solution.contacts()[i].reach());
        assert!(half_width < top && top + 0.3 * 1.76 < below, "{text}: {top} {below}");
    }
}

/// With a loose tolerance more is left out than with a strict one: both answers agree as far as they say.
#[test]
fn what_is_left_out_is_within_the_estimates_of_random_scenes() {
    let mut pairs = 0;
    for number in 0..24u32 {
        // numbers from 0 to 1 that fill a square evenly
        let [one, two] = [0.754_877_666_2, 0.569_840_290_9].map(|step: f64| (0.5 + step * f64::from(number)).fract());
        let thickness = 10f64.powf(-1.0 - 4.0 * one);
        let modulus = 10f64.powf(-2.0 + 4.0 * two);
        let punch = ["Parabola(radius: 40)", "RoundedFlat(half_width: 0.8, radius: 200)", "Wedge(slope: 0.02)"];
        let joint = ["Bonded", "Receding"][number as usize / 3 % 2];
        let base = [GROUND, "PowerHalfPlane(shear_modulus: 2, poisson: 0.3, length: 1.3, exponent: 0.3)"];
        let text = format!(
            "Scene(geometry: PlaneStrain, punch: {}, force: 0.03, stack: [
                Homogeneous(thickness: {thickness:e}, shear_modulus: {modulus:e}, poisson: 0.3), {joint}, {}])",
            punch[number as usize % 3],
            base[number as usize / 6 % 2],
        );
        let scene = Scene::from_ron(&text).unwrap();
        let model = recede::Model::new(scene.stack().unwrap()).unwrap();
        let solve = |tolerance: f64| {
            let options = recede::Options { tolerance };
            model.press_with(&scene.top, scene.force, &options)
        };
        let (Ok(loose), Ok(strict)) = (solve(1e-3), solve(1e-8)) else { continue };
        let is_left_out = |solution: &Solution| {
            solution.warnings().iter().any(|warning| warning.code == WarningCode::ThinLayerLeftOut)
        };
        if is_left_out(&loose) != is_left_out(&strict) {
            pairs += 1;
        }
        near(&loose, &strict, 1e-12, &text);
    }
    assert!(pairs > 3, "{pairs}");
}

#[test]
fn a_soft_sheet_on_a_stiff_plate_matters_more_than_it_is_thick() {
    // a plate that follows the shape of a punch presses next to the ends of the contact most: there the sheet gives way, over a length that grows like a power of its
    // thickness less than 1
    let plate = "Homogeneous(thickness: 1, shear_modulus: 1000, poisson: 0.3), Bonded, HalfPlane(shear_modulus: 1, poisson: 0.3)";
    let half_length = |sheet: &str| {
        let stack = format!("{sheet}{plate}");
        let text = format!("Scene(geometry: PlaneStrain, punch: Parabola(radius: 1000), force: 10, stack: [{stack}])");
        let scene = Scene::from_ron(&text).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press_with(&scene.top, scene.force, &Options { tolerance: 1e-2 }).unwrap();
        let contact = &solution.contacts()[0];
        [contact.half_length().unwrap(), contact.half_length_error().unwrap()]
    };
    let sheet = |thickness: f64| {
        half_length(&format!("Homogeneous(thickness: {thickness:?}, shear_modulus: 0.01, poisson: 0.3), Receding, "))
    };
    let all = [half_length(""), sheet(1e-3), sheet(1e-2)];
    for pair in all.windows(2) {
        assert!(pair[0][0] + pair[0][1] < pair[1][0] - pair[1][1], "{all:?}");
    }
    let [bare, thin, thick] = all.map(|[half_length, _]| half_length);
    assert!(thin - bare > 0.2 * (thick - bare), "{all:?}");
}
