//! Half-lengths and depths prescribed in place of the force, on stacks of all kinds.
//!
//! Goal: a contact that a force brings about belongs to the same force where its half-length, or the depth of the punch, is prescribed instead; errors are as large as claimed at any
//! tolerance; it takes hardly more equations than a given force; and many of them are interpolated like many forces.
//!
//! Source of the numbers: the solver with a given force, and its approach.
use recede::selftest::{Ranges, about_axis, scene};
use recede::{Force, Model, Options, Scene, Solution};

/// Random scenes of the source paper's kinds in the plane and about an axis, with their solutions, if these are single intervals without warnings.
fn solved(seed: u64, count: u64) -> impl Iterator<Item = (String, Scene, Model, Solution)> {
    let drawn =
        (0..count).filter_map(move |number| Some((number, scene(&Ranges::default(), seed, number).scene().ok()?)));
    let all = drawn.flat_map(|(number, plane)| [(number, "plane", plane.clone()), (number, "axis", about_axis(plane))]);
    all.filter_map(|(number, kind, scene)| {
        let model = Model::new(scene.stack().ok()?).ok()?;
        let solution = model.press(&scene.top, scene.force).ok()?;
        let is_plain =
            solution.warnings().is_empty() && solution.contacts().iter().all(|own| own.half_length().is_some());
        is_plain.then(|| (format!("{kind} {number}"), scene, model, solution))
    })
}

/// What may be prescribed in place of the force of a solution, with the relative error of that.
fn prescribed(scene: &Scene, model: &Model, solution: &Solution) -> Vec<(Force, f64)> {
    let top = &solution.contacts()[0];
    let (half_length, error) = (top.half_length().unwrap(), top.half_length_error().unwrap());
    let mut all = vec![(Force::ForHalfLength(half_length), error / half_length)];
    if let Ok(approach) = model.approach(&scene.top, solution) {
        all.push((Force::ForDepth(approach.value), approach.error / approach.value));
    }
    all
}

#[test]
fn a_contact_belongs_to_the_same_force_whatever_is_prescribed() {
    let mut by_depth = 0;
    for (name, scene, model, expected) in solved(36, 16) {
        for (force, error) in prescribed(&scene, &model, &expected) {
            let found = model.press(&scene.top, force).unwrap();
            let off = (found.force() / expected.force() - 1.0).abs();
            // a force grows no faster than the square of a depth, and under a cone in the plane than any power of a half-length up to some tens
            let allowed = found.force_error() / found.force() + 10.0 * error;
            assert!(off <= allowed, "{name} {force}: {off:e} {allowed:e}");
            assert!(found.force_error() > 0.0 && found.warnings().is_empty(), "{name} {force}: {found:?}");
            let [steps, before] = [&found, &expected].map(Solution::newton_steps);
            assert!(2 * steps <= 3 * before + 8, "{name} {force}: {steps} steps, {before} by force");
            by_depth += usize::from(matches!(force, Force::ForDepth(_)));
        }
    }
    assert!(by_depth >= 8, "{by_depth}");
}

#[test]
fn errors_of_forces_are_as_claimed_at_any_tolerance() {
    for (name, scene, model, expected) in solved(7, 6) {
        for (force, error) in prescribed(&scene, &model, &expected) {
            for tolerance in [1e-3, 1e-6, 1e-8] {
                let found = model.press_with(&scene.top, force, &Options { tolerance }).unwrap();
                let off = (found.force() / expected.force() - 1.0).abs();
                let claimed = found.force_error() / found.force();
                assert!(off <= 10.0 * (claimed + error), "{name} {force} {tolerance:e}: {off:e} {claimed:e}");
                assert!(claimed <= tolerance, "{name} {force} {tolerance:e}: {claimed:e}");
            }
        }
    }
}

#[test]
fn many_of_them_are_interpolated() {
    let scene = Scene::read("examples/scenes/prescribed_depth.ron").unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let many = model.clone().for_many_loads();
    for force in [Force::ForDepth(0.03), Force::ForHalfLength(1.7), Force::Given(0.2)] {
        let [expected, found] = [&model, &many].map(|model| model.press(&scene.top, force).unwrap());
        assert_eq!(found.stats().factorisations, 0, "{force}");
        let off = (found.force() / expected.force() - 1.0).abs();
        let claimed = (found.force_error() + expected.force_error()) / expected.force();
        assert!(off <= claimed + 1e-15 && claimed < 1e-9, "{force}: {off:e} {claimed:e}");
        for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
            let off = (found.central_pressure / expected.central_pressure - 1.0).abs();
            assert!(off < 1e-10, "{force}: {off:e}");
        }
    }
}
