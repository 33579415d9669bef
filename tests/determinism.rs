//! The same scene gives the same bits: on any number of threads, in any order, whatever was solved before.
//!
//! Goal: a model may be shared by threads, and a sweep may be cut up among them, without a trace in the answers.
//!
//! ```text
//!   model ──┬── thread 1: forces 1 2 3 4      answers of 1: ≡ those of a fresh model, alone
//!           ├── thread 2: forces 3 4 1 2
//!           └── thread 3: forces 4 3 2 1
//! ```
use std::thread;

use recede::selftest::{Ranges, scene};
use recede::{Error, Model, Punch, Scene, Solution};

/// Multiples of the force of a scene.
const FORCES: [f64; 4] = [1.0, 0.3, 1.1, 1.7];
const SEED: u64 = 20_211;

fn scenes() -> Vec<Scene> {
    (0..4).map(|number| scene(&Ranges::moderate(), SEED, number).scene().unwrap()).collect()
}

fn model(scene: &Scene) -> Model {
    Model::new(scene.stack().unwrap()).unwrap()
}

/// All digits of an answer, or the message of the error.
fn bits(answer: &Result<Solution, Error>) -> Vec<u64> {
    let Ok(solution) = answer else {
        return answer.as_ref().unwrap_err().to_string().bytes().map(u64::from).collect();
    };
    let mut bits = vec![solution.min_pressure().to_bits(), solution.min_gap().to_bits()];
    bits.extend([solution.modes(), solution.wavenumbers(), solution.newton_steps()].map(|count| count as u64));
    for contact in solution.contacts() {
        let pressures = [0.0, 0.31, 0.77, 0.999].map(|s| contact.pressure(s * contact.half_length().unwrap()));
        let values = [
            contact.half_length().unwrap(),
            contact.half_length_error().unwrap(),
            contact.central_pressure,
            contact.central_pressure_error,
        ];
        bits.extend(values.into_iter().chain(pressures).map(f64::to_bits));
    }
    bits
}

fn press(model: &Model, scene: &Scene, force: f64) -> Vec<u64> {
    bits(&model.press(&scene.top, force * scene.force.given().unwrap()))
}

#[test]
fn threads_may_share_a_model() {
    for scene in scenes() {
        let alone: Vec<Vec<u64>> = FORCES.iter().map(|force| press(&model(&scene), &scene, *force)).collect();
        let shared = model(&scene);
        thread::scope(|scope| {
            for thread in 0..3 {
                let (shared, scene, alone) = (&shared, &scene, &alone);
                scope.spawn(move || {
                    for i in 0..FORCES.len() {
                        // every thread in an order of its own
                        let i = if thread % 2 == 0 { (i + thread) % FORCES.len() } else { FORCES.len() - 1 - i };
                        assert_eq!(press(shared, scene, FORCES[i]), alone[i], "force {i}, thread {thread}");
                    }
                });
            }
        });
    }
}

#[test]
fn models_made_at_the_same_time_are_the_same() {
    let scenes = scenes();
    let one_after_the_other: Vec<_> = scenes.iter().map(|scene| press(&model(scene), scene, 1.0)).collect();
    let at_once: Vec<_> = thread::scope(|scope| {
        let threads: Vec<_> =
            scenes.iter().map(|scene| scope.spawn(move || press(&model(scene), scene, 1.0))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert_eq!(at_once, one_after_the_other);
}

#[test]
fn what_was_solved_before_leaves_no_trace() {
    let scenes = scenes();
    let answers: Vec<_> = scenes.iter().map(|scene| bits(&recede::solve(scene))).collect();
    let other = Punch::cylinder(1e3).unwrap();
    for (scene, answer) in scenes.iter().zip(&answers).rev() {
        let used = model(scene);
        // an answer or not, it must not matter
        let _ = used.press(&other, 1e-3 * scene.force.given().unwrap());
        assert_eq!(&press(&used, scene, 1.0), answer);
        assert_eq!(&press(&used.clone(), scene, 1.0), answer);
    }
}

#[test]
fn what_is_kept_for_many_loads_leaves_no_trace() {
    for scene in scenes() {
        let force = scene.force.given().unwrap();
        for punch in [&scene.top, &Punch::parabola(30.0).unwrap().into()] {
            let press = |model: &Model, part: f64| bits(&model.press(punch, part * force));
            let many = || model(&scene).for_many_loads();
            let alone: Vec<Vec<u64>> = FORCES.iter().map(|part| press(&many(), *part)).collect();
            let shared = many();
            thread::scope(|scope| {
                for thread in 0..3 {
                    let (shared, alone) = (&shared, &alone);
                    scope.spawn(move || {
                        for i in (0..FORCES.len()).rev() {
                            let i = (i + thread) % FORCES.len();
                            assert_eq!(press(shared, FORCES[i]), alone[i], "force {i}, thread {thread}");
                        }
                    });
                }
            });
        }
    }
}

#[test]
fn random_scenes_are_known_by_seed_and_number() {
    for number in [0, 7, 1999] {
        let one = scene(&Ranges::default(), 1, number);
        assert_eq!(scene(&Ranges::default(), 1, number), one);
        assert_ne!(scene(&Ranges::default(), 1, number + 1), one);
        assert_ne!(scene(&Ranges::default(), 2, number), one);
        // and by what is written of them
        let text = one.scene().unwrap().to_ron();
        assert_eq!(Scene::from_ron(&text).unwrap().to_ron(), text);
    }
}
