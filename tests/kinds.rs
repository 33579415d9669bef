//! Scenes of all kinds: punches, loads, layers, interfaces and bases that are drawn at random.
//!
//! Goal: whatever a scene is made of, error estimates cover the errors, fields are in equilibrium with the pressures, and a
//! sweep gives what single scenes give.
use recede::selftest::{CheckedScene, Outcome, Ranges, compare, scene_of_any_kind, variant};
use recede::{Model, Options, Scene, Solution, Sweep};

/// The solved scenes among the first of this number.
fn solved(seed: u64, count: u64) -> impl Iterator<Item = (u64, Scene, Solution)> {
    (0..count).filter_map(move |number| {
        let scene = scene_of_any_kind(&Ranges::moderate(), seed, number).unwrap();
        match CheckedScene::run(&scene, &Options::default(), false).outcome {
            Outcome::Solved(solution) => Some((number, scene, *solution)),
            outcome => {
                assert!(!outcome.is_wrong(), "{number}: {}\n{}", outcome.reason(), scene.to_ron());
                None
            }
        }
    })
}

#[test]
fn estimates_cover_errors() {
    let (mut compared, mut bold) = (0, 0);
    for (number, scene, solution) in solved(11, 40) {
        let Ok(comparisons) = compare(&scene, &solution) else { continue };
        for one in comparisons {
            // the tolerance is met, or the estimate says that it is not
            let covered = one.error <= 1e-10 + 10.0 * one.estimate + one.blur;
            assert!(covered, "{number}: {one:?}\n{}", scene.to_ron());
            compared += 1;
            bold += usize::from(one.error > 1e-12 + 10.0 * one.estimate + one.blur);
        }
    }
    assert!(compared > 80 && bold <= compared / 50, "{compared} {bold}");
}

#[test]
fn fields_carry_the_pressures() {
    let mut seen = 0;
    for (number, scene, solution) in solved(12, 30) {
        let stack = scene.stack().unwrap();
        let model = Model::new(stack).unwrap();
        let field = model.field(&solution).unwrap();
        let top = &solution.contacts()[0];
        let first = &top.intervals()[0];
        let [middle, half] = [0.5 * (first.left + first.right), (0.5 * (first.right - first.left)).max(1e-2)];
        let size = solution.force() / half;
        for s in [0.31, 0.77, 1.4] {
            let x = middle + s * half;
            let point = field.at(x, 0.0).unwrap();
            // next to kinks pressures are series that end
            let error = 1e-5 * size;
            let (normal, shear) = (point.sigma_yy + top.pressure(x) + scene.pressure_on_top, point.sigma_xy);
            assert!(
                normal.abs() < error && shear.abs() < error,
                "{number} at {s}: {normal} {shear}\n{}",
                scene.to_ron()
            );
        }
        // what is pressed on top passes through any depth: a receding contact, or the next layer
        for contact in solution.contacts() {
            let error = (contact.resultant / solution.force() - 1.0).abs();
            assert!(error < 1e-9, "{number}: {error}");
        }
        seen += 1;
    }
    assert!(seen > 20, "{seen}");
}

#[test]
fn sweeps_give_what_single_scenes_give() {
    let mut seen = 0;
    for (number, scene, solution) in solved(13, 12) {
        let scene = Scene::from_ron(&scene.to_ron()).unwrap();
        let force = solution.force();
        let axis = recede::Axis::list("force", vec![0.5 * force, force]).unwrap();
        let rows: Vec<_> = Sweep::new(scene, vec![axis]).unwrap().rows().collect();
        assert_eq!(rows.len(), 2);
        let Ok(swept) = &rows[1].result else { panic!("{number}") };
        for (swept, single) in swept.contacts().iter().zip(solution.contacts()) {
            assert!((swept.reach() - single.reach()).abs() <= 1e-13 * single.reach(), "{number}");
        }
        seen += 1;
    }
    assert!(seen > 8, "{seen}");
}

#[test]
fn examples_changed_at_random_are_solved_and_reported() {
    let mut unsolved = 0;
    for number in 0..40 {
        let scene = variant(14, number).unwrap();
        let check = CheckedScene::run(&scene, &Options { tolerance: 1e-8 }, number % 8 == 0);
        assert!(!check.outcome.is_wrong(), "{number}: {}\n{}", check.outcome.reason(), scene.to_ron());
        unsolved += usize::from(check.outcome.solution().is_none());
    }
    assert!(unsolved < 8, "{unsolved}");
}
