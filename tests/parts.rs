//! Contacts in several intervals: what is solved for is what the fields inside the bodies say.
use std::path::Path;

use recede::{Contact, Interface, Interval, Model, Options, Scene, Solution};

use crate::support::outwards;

fn solved(name: &str, tolerance: f64) -> (Model, Solution) {
    let path = format!("{}/tests/data/hard/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let scene = Scene::read(Path::new(&path)).unwrap();
    let options = Options { tolerance };
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press_with(&scene.top, scene.force, &options).unwrap();
    (model, solution)
}

/// The contact that has several intervals, the one about x = 0, and the next one.
fn in_parts(solution: &Solution) -> (&Contact, Interval, Interval) {
    let contact = solution.contacts().iter().find(|contact| contact.intervals().len() > 1).unwrap();
    let intervals = outwards(contact);
    (contact, intervals[0], intervals[1])
}

/// Places in both intervals, in the gap between them, and beyond.
fn places(first: Interval, next: Interval) -> [Vec<f64>; 2] {
    let between = |from: f64, to: f64| [0.1, 0.3, 0.5, 0.7, 0.9].map(|t| from + t * (to - from));
    let touching = between(0.0, first.right).into_iter().chain(between(next.left, next.right));
    let open = between(first.right, next.left).into_iter().chain([1.2 * next.right, 1.5 * next.right]);
    [touching.collect(), open.collect()]
}

#[test]
fn bodies_meet_where_they_touch_and_only_there() {
    for name in ["seed_1_number_79", "seed_2_number_92"] {
        let (model, solution) = solved(name, 1e-6);
        let (contact, first, part) = in_parts(&solution);
        let Interface::Between { above, below } = contact.interface else { panic!("{name}: {contact:?}") };
        let field = model.field(&solution).unwrap();
        let depth = field.layers().find(|(layer, _)| *layer == above).unwrap().1[1];
        let [touching, open] = places(first, part);
        // approach of the upper body to the lower one, up to a constant
        let apart = |x: f64| {
            let [upper, lower] = [above, below].map(|layer| field.at_layer(x, depth, layer).unwrap());
            for face in [&upper, &lower] {
                let wrong = face.sigma_yy + contact.pressure(x);
                assert!(wrong.abs() < 1e-6 * contact.central_pressure, "{name} at {x}: {face:?}");
                assert!(face.sigma_xy.abs() < 1e-6 * contact.central_pressure, "{name} at {x}: {face:?}");
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
        let [mirrored, Interval { left: from, right: to, .. }] = contact.intervals()[..] else { panic!("{contact:?}") };
        assert!(0.0 < from && from < to && contact.central_pressure == 0.0, "{name}: {contact:?}");
        assert_eq!([mirrored.left, mirrored.right], [-to, -from]);
        assert!((mirrored.force / solution.force() - 0.5).abs() < 1e-9 && mirrored.centroid < -from, "{mirrored:?}");
        assert!((contact.resultant / solution.force() - 1.0).abs() < 1e-9, "{name}: {contact:?}");
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
        let (contact, first, part) = in_parts(&solution);
        for contact in solution.contacts() {
            assert!((contact.resultant / solution.force() - 1.0).abs() < 1e-9, "{name}: {contact:?}");
        }
        let [touching, open] = places(first, part);
        let even = |x: &f64| (contact.pressure(-x) - contact.pressure(*x)).abs() < 1e-9 * contact.pressure(0.0);
        assert!(touching.iter().all(|x| contact.pressure(*x) > 0.0 && even(x)), "{name}");
        assert!(open.iter().all(|x| contact.pressure(*x) == 0.0));
        // by a rule that knows nothing of series
        let all: f64 = contact
            .intervals()
            .iter()
            .map(|Interval { left: from, right: to, force, centroid, .. }| {
                let count = 4000;
                let place = |k: usize| std::f64::consts::PI * (k as f64 + 0.5) / count as f64;
                let half = 0.5 * (to - from);
                let term = |theta: f64| half * theta.sin() * contact.pressure(0.5 * (from + to) + half * theta.cos());
                let sum = |moment: bool| {
                    let at = |k: usize| if moment { 0.5 * (from + to) + half * place(k).cos() } else { 1.0 };
                    let terms = (0..count).map(|k| term(place(k)) * at(k));
                    terms.sum::<f64>() * std::f64::consts::PI / count as f64
                };
                assert!((sum(false) / force - 1.0).abs() < 1e-6, "{name}: {force}");
                assert!(
                    (sum(true) - force * centroid).abs() < 1e-6 * (force * (to - from)).abs(),
                    "{name}: {centroid}"
                );
                sum(false)
            })
            .sum();
        assert!((all / contact.resultant - 1.0).abs() < 1e-6, "{name}: {all} {}", contact.resultant);
        assert_eq!(contact.reach(), part.right);
    }
}

#[test]
fn estimates_cover_what_a_tighter_tolerance_changes() {
    let (_, rough) = solved("seed_1_number_79", 1e-4);
    let (_, fine) = solved("seed_1_number_79", 1e-7);
    let ((rough, rough_first, rough_next), (fine, fine_first, fine_next)) = (in_parts(&rough), in_parts(&fine));
    for (off, estimate) in [
        (rough_first.right - fine_first.right, rough_first.right_error),
        (rough_next.left - fine_next.left, rough_next.left_error),
        (rough_next.right - fine_next.right, rough_next.right_error),
        (rough.central_pressure - fine.central_pressure, rough.central_pressure_error),
    ] {
        assert!(off.abs() <= 10.0 * estimate, "{off:e} {estimate:e}");
    }
}

/// Pairs of uniform loads of equal resultant, each of half-width 1/2, on a loose strip of thickness 1.
fn pairs_on_a_loose_strip(places: &[f64]) -> (Model, Solution) {
    let load = |at: f64| format!("(load: Uniform(half_width: 0.5), at: {at:?}, force: 0.005)");
    let text = format!(
        "Scene(geometry: PlaneStrain, loads: [{}], stack: [
            Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.3), Receding, HalfPlane(shear_modulus: 1, poisson: 0.3)])",
        places.iter().flat_map(|at| [-at, *at]).map(load).collect::<Vec<_>>().join(", ")
    );
    let scene = Scene::from_ron(&text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press_with(&scene.top, scene.force, &Options::default()).unwrap();
    (model, solution)
}

#[test]
fn contacts_of_any_number_of_intervals_meet_the_tolerance() {
    for places in [&[3.0, 12.0, 25.0][..], &[3.0, 12.0, 25.0, 41.0]] {
        let (model, solution) = pairs_on_a_loose_strip(places);
        let contact = &solution.contacts()[1];
        let outwards = outwards(contact);
        assert_eq!(outwards.len(), places.len(), "{places:?}: {contact:?}");
        let ends = |interval: &Interval| [(interval.left, interval.left_error), (interval.right, interval.right_error)];
        let tolerance = Options::default().tolerance;
        let mut errors = outwards.iter().flat_map(ends);
        assert!(errors.all(|(end, error)| error / end.abs() <= tolerance), "{places:?}: {outwards:?}");
        assert!((contact.resultant / solution.force() - 1.0).abs() < 1e-9, "{places:?}: {contact:?}");
        // the gap between strip and half-plane, up to a constant, from the fields inside both
        let field = model.field(&solution).unwrap();
        let gap = |x: f64| [1, 2].map(|layer| field.at_layer(x, 1.0, layer).unwrap().v);
        let gap = |x: f64| gap(x).iter().zip([1.0, -1.0]).map(|(v, sign)| sign * v).sum::<f64>();
        let intervals: Vec<[f64; 2]> = outwards.iter().map(|part| [part.left.max(0.0), part.right]).collect();
        let inside = |[from, to]: [f64; 2]| [0.1, 0.5, 0.9].map(|t| from + t * (to - from));
        let touching: Vec<f64> = intervals.iter().flat_map(|interval| inside(*interval)).collect();
        let mut open: Vec<f64> = intervals.windows(2).flat_map(|pair| inside([pair[0][1], pair[1][0]])).collect();
        open.extend([1.2, 1.5].map(|t| t * contact.reach()));
        let closed = gap(touching[0]);
        let gaps: Vec<f64> = open.iter().map(|x| gap(*x) - closed).collect();
        let widest = gaps.iter().fold(0.0, |widest: f64, gap| widest.max(gap.abs()));
        assert!(gaps.iter().all(|gap| gap.signum() == gaps[0].signum() && *gap != 0.0), "{places:?}: {gaps:?}");
        for x in touching {
            assert!((gap(x) - closed).abs() < 1e-6 * widest, "{places:?} at {x}: {:e} of {widest:e}", gap(x) - closed);
            assert!(contact.pressure(x) > 0.0, "{places:?} at {x}");
        }
    }
}

/// Strips that are about to lift off the ground, or to come down on it, between two line loads: next to the end of the contact there is hardly
/// any pressure on one side, and hardly any gap on the other.
#[test]
fn bodies_that_graze_each_other_touch_in_one_interval_on_either_side() {
    let soft_film = |at: f64| {
        format!(
            "loads: [(load: Line, at: -{at:?}, force: 0.001), (load: Line, at: {at:?}, force: 0.001)], stack: [
                Homogeneous(thickness: 1.0959, shear_modulus: 3.4117, poisson: 0.382), Bonded,
                Homogeneous(thickness: 0.0509, shear_modulus: 0.1178, poisson: 0.242), Receding,
                HalfPlane(shear_modulus: 3.2758, poisson: 0.3)]"
        )
    };
    let two_slabs = "loads: [
            (load: Uniform(half_width: 0.1), at: -5.734563, force: 0.001), (load: Uniform(half_width: 0.1), at: 5.734563, force: 0.001),
        ], stack: [
        Homogeneous(thickness: 2.0787, shear_modulus: 0.1207, poisson: 0.111), Bonded,
        Homogeneous(thickness: 0.4734, shear_modulus: 0.7627, poisson: 0.140), Receding,
        Homogeneous(thickness: 1.9203, shear_modulus: 0.3689, poisson: 0.204), Receding,
        HalfPlane(shear_modulus: 0.3665, poisson: 0.3)]";
    for text in [soft_film(2.843953), soft_film(2.81671), two_slabs.to_owned()] {
        let scene = Scene::from_ron(&format!("Scene(geometry: PlaneStrain, {text})")).unwrap();
        let solution = recede::solve(&scene).unwrap();
        for contact in &solution.contacts()[1..] {
            let [mirrored, interval] = contact.intervals()[..] else { panic!("{text}: {contact:?}") };
            assert_eq!(mirrored.right, -interval.left, "{text}");
            assert!(interval.left_error < 1e-7 * interval.left, "{text}: {interval:?}");
        }
    }
}
