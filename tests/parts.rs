//! Contacts in several intervals: what is solved for is what the fields inside the bodies say.
use std::path::Path;

use recede::{Contact, Interface, Model, Options, Part, Scene, Solution};

fn solved(name: &str, tolerance: f64) -> (Model, Solution) {
    let path = format!("{}/tests/data/hard/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let scene = Scene::read(Path::new(&path)).unwrap();
    let options = Options { tolerance, ..Options::default() };
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press_with(&scene.punch, scene.force, &options).unwrap();
    (model, solution)
}

/// The contact that has another part, and that part.
fn in_parts(solution: &Solution) -> (&Contact, Part) {
    let contact = solution.contacts().iter().find(|contact| !contact.parts.is_empty()).unwrap();
    (contact, contact.parts[0])
}

/// Places in both parts, in the gap between them, and beyond.
fn places(contact: &Contact, part: Part) -> [Vec<f64>; 2] {
    let between = |from: f64, to: f64| [0.1, 0.3, 0.5, 0.7, 0.9].map(|t| from + t * (to - from));
    let touching = between(0.0, contact.half_length).into_iter().chain(between(part.from, part.to));
    let open = between(contact.half_length, part.from).into_iter().chain([1.2 * part.to, 1.5 * part.to]);
    [touching.collect(), open.collect()]
}

#[test]
fn bodies_meet_where_they_touch_and_only_there() {
    for name in ["seed_1_number_79", "seed_2_number_92"] {
        let (model, solution) = solved(name, 1e-6);
        let (contact, part) = in_parts(&solution);
        let Interface::Between { above, below } = contact.interface else { panic!("{name}: {contact:?}") };
        let field = model.field(&solution).unwrap();
        let depth = field.layers().find(|(layer, _)| *layer == above).unwrap().1[1];
        let [touching, open] = places(contact, part);
        // approach of the upper body to the lower one, up to a constant
        let apart = |x: f64| {
            let [upper, lower] = [above, below].map(|layer| field.at_layer(x, depth, layer).unwrap());
            for face in [&upper, &lower] {
                let wrong = face.sigma_yy + contact.pressure(x);
                assert!(wrong.abs() < 1e-6 * contact.peak_pressure, "{name} at {x}: {face:?}");
                assert!(face.sigma_xy.abs() < 1e-6 * contact.peak_pressure, "{name} at {x}: {face:?}");
            }
            upper.v - lower.v
        };
        let closed: Vec<f64> = touching.iter().map(|x| apart(*x)).collect();
        let gaps: Vec<f64> = open.iter().map(|x| apart(*x) - closed[0]).collect();
        let widest = gaps.iter().fold(0.0, |widest: f64, gap| widest.max(gap.abs()));
        for (x, place) in touching.iter().zip(&closed) {
            assert!((place - closed[0]).abs() < 1e-4 * widest, "{name} at {x}: {:e} of {widest:e}", place - closed[0]);
        }
        // all of one sign: it opens
        assert!(gaps.iter().all(|gap| gap.signum() == gaps[0].signum() && *gap != 0.0), "{name}: {gaps:?}");
    }
}

#[test]
fn a_sheet_that_bends_as_far_as_the_punch_is_round_touches_it_in_two_strips() {
    for (name, radius) in [("seed_2_number_70", 277.1897857911962), ("seed_21_number_638", 13.072514773277263f64)] {
        let (model, solution) = solved(name, 1e-6);
        let contact = &solution.contacts()[0];
        let (from, to) = (contact.opening, contact.half_length);
        assert!(0.0 < from && from < to && contact.peak_pressure == 0.0, "{name}: {contact:?}");
        assert_eq!(contact.intervals().collect::<Vec<_>>(), [[-to, -from], [from, to]]);
        assert!((contact.resultant / solution.force() - 1.0).abs() < 1e-9, "{name}: {contact:?}");
        assert!(solution.warnings().iter().any(|warning| warning.contains("open about x = 0")));
        // height of the punch above the face, up to a constant
        let field = model.field(&solution).unwrap();
        let apart =
            |x: f64| (x * x / radius) / (1.0 + (1.0 - (x / radius).powi(2)).sqrt()) - field.at(x, 0.0).unwrap().v;
        let between = |from: f64, to: f64| [0.05, 0.3, 0.5, 0.7, 0.95].map(|t| from + t * (to - from));
        let closed = between(from, to).map(apart);
        let gaps = between(0.0, from).map(|x| apart(x) - closed[0]);
        let outside = [1.05, 1.2, 1.5].map(|t| apart(t * to) - closed[0]);
        assert!(gaps.iter().chain(&outside).all(|gap| *gap > 0.0), "{name}: {gaps:?} {outside:?}");
        let widest = gaps.iter().fold(0.0, |widest: f64, gap| widest.max(*gap));
        for place in closed {
            assert!((place - closed[0]).abs() < 1e-4 * widest, "{name}: {:e} of {widest:e}", place - closed[0]);
        }
        assert!(between(from, to).iter().all(|x| contact.pressure(*x) > 0.0 && contact.pressure(-x) > 0.0));
        assert!(between(0.0, from).iter().all(|x| contact.pressure(*x) == 0.0));
    }
}

#[test]
fn parts_share_the_force_and_push() {
    for name in ["seed_1_number_0", "seed_1_number_21", "seed_1_number_74", "seed_1_number_79"] {
        let (_, solution) = solved(name, 1e-6);
        let (contact, part) = in_parts(&solution);
        for contact in solution.contacts() {
            assert!((contact.resultant / solution.force() - 1.0).abs() < 1e-9, "{name}: {contact:?}");
        }
        let [touching, open] = places(contact, part);
        let even = |x: &f64| (contact.pressure(-x) - contact.pressure(*x)).abs() < 1e-9 * contact.pressure(0.0);
        assert!(touching.iter().all(|x| contact.pressure(*x) > 0.0 && even(x)), "{name}");
        assert!(open.iter().all(|x| contact.pressure(*x) == 0.0));
        // by a rule that knows nothing of series
        let all: f64 = contact
            .intervals()
            .map(|[from, to]| {
                let count = 4000;
                let place = |k: usize| std::f64::consts::PI * (k as f64 + 0.5) / count as f64;
                let half = 0.5 * (to - from);
                let term = |theta: f64| half * theta.sin() * contact.pressure(0.5 * (from + to) + half * theta.cos());
                (0..count).map(|k| term(place(k))).sum::<f64>() * std::f64::consts::PI / count as f64
            })
            .sum();
        assert!((all / contact.resultant - 1.0).abs() < 1e-6, "{name}: {all} {}", contact.resultant);
        assert_eq!(contact.reach(), part.to);
    }
}

#[test]
fn estimates_cover_what_a_tighter_tolerance_changes() {
    let (_, rough) = solved("seed_1_number_79", 1e-4);
    let (_, fine) = solved("seed_1_number_79", 1e-7);
    let ((rough, rough_part), (fine, fine_part)) = (in_parts(&rough), in_parts(&fine));
    for (off, estimate) in [
        (rough.half_length - fine.half_length, rough.half_length_error),
        (rough_part.from - fine_part.from, rough_part.from_error),
        (rough_part.to - fine_part.to, rough_part.to_error),
        (rough.peak_pressure - fine.peak_pressure, rough.peak_pressure_error),
    ] {
        assert!(off.abs() <= 10.0 * estimate, "{off:e} {estimate:e}");
    }
}
