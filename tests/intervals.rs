//! Contacts as lists of intervals, and their largest pressures.
//!
//! Goal: for scenes of all kinds intervals are in order and apart, carry the whole force in balance, and the pressure integrates to
//! what they say; nowhere is a pressure larger than the largest one.
use recede::selftest::{CheckedScene, Outcome, Ranges, scene_of_any_kind};
use recede::{Contact, HalfPlane, Load, Model, Options, Plane, Punch, Scene, Solution, Stack};

/// The contacts of scenes of all kinds, and of hard ones with several intervals.
fn contacts() -> Vec<(String, Contact)> {
    let random =
        (0..60).map(|number| (format!("{number}"), scene_of_any_kind(&Ranges::moderate(), 17, number).unwrap()));
    let hard = ["seed_1_number_79", "seed_2_number_70", "seed_23_number_1121"].map(|name| {
        let path = format!("{}/tests/data/hard/{name}.ron", env!("CARGO_MANIFEST_DIR"));
        (name.to_owned(), Scene::read(std::path::Path::new(&path)).unwrap())
    });
    let solved = random.chain(hard).filter_map(|(name, scene)| {
        match CheckedScene::of_contacts(&scene, &Options::default()).outcome {
            Outcome::Solved(solution) => Some((name, *solution)),
            _ => None,
        }
    });
    let each = |(name, solution): (String, Solution)| {
        let contacts = solution.contacts().to_vec();
        contacts.into_iter().map(move |contact| (name.clone(), contact)).collect::<Vec<_>>()
    };
    solved.flat_map(each).collect()
}

/// Places x = from + (to − from)(1 − cos φ)/2, and how much of the interval belongs to each.
fn dense(from: f64, to: f64, count: usize) -> impl Iterator<Item = (f64, f64)> {
    let step = std::f64::consts::PI / count as f64;
    (0..count).map(move |k| {
        let phi = (k as f64 + 0.5) * step;
        (from + 0.5 * (to - from) * (1.0 - phi.cos()), 0.5 * (to - from) * step * phi.sin())
    })
}

fn half_plane(punch: &Punch, force: f64) -> Solution {
    let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25).unwrap()).build().unwrap();
    Model::new(stack).unwrap().press(punch, force).unwrap()
}

#[test]
fn intervals_carry_the_force_in_balance() {
    let (mut several, mut seen) = (0, 0);
    for (name, contact) in contacts() {
        let intervals = contact.intervals();
        several += usize::from(intervals.len() > 1);
        seen += 1;
        assert!(intervals.windows(2).all(|pair| pair[0].right < pair[1].left), "{name}: {intervals:?}");
        let force: f64 = intervals.iter().map(|interval| interval.force).sum();
        let moment: f64 = intervals.iter().map(|interval| interval.force * interval.centroid).sum();
        assert!((force / contact.resultant - 1.0).abs() < 1e-12, "{name}: {force} {}", contact.resultant);
        // what presses need not be symmetric
        let mean = contact.resultant / contact.reach();
        let is_mirrored = |x: f64| (contact.pressure(x) - contact.pressure(-x)).abs() < 1e-9 * mean;
        if [0.1, 0.3, 0.6, 0.9].into_iter().all(|part| is_mirrored(part * contact.reach())) {
            assert!(moment.abs() <= 1e-12 * contact.resultant * contact.reach(), "{name}: {moment:e}");
            let whole = contact.half_length().is_some();
            assert_eq!(whole, intervals.len() == 1, "{name}");
        } else {
            // loads may overlap on an interval that is symmetric
            let is_given = contact.interface == recede::Interface::Punch;
            assert!(is_given || contact.half_length().is_none(), "{name}");
        }
        for interval in intervals {
            assert!((interval.left..=interval.right).contains(&interval.centroid), "{name}: {interval:?}");
            // a singular pressure has a part of the force next to its singularity that this rule sees slowly
            if contact.peak().pressure.is_finite() && interval.right > interval.left {
                let places = dense(interval.left, interval.right, 4000);
                let [force, moment] = places.fold([0.0; 2], |sum, (x, weight)| {
                    let force = weight * contact.pressure(x);
                    [sum[0] + force, sum[1] + force * x]
                });
                let error = 1e-4 * contact.resultant;
                assert!((force - interval.force).abs() < error, "{name}: {force} {interval:?}");
                let expected = interval.force * interval.centroid;
                assert!((moment - expected).abs() < error * contact.reach(), "{name}: {moment} {interval:?}");
            }
        }
    }
    assert!(several > 3 && seen > 80, "{several} of {seen}");
}

#[test]
fn no_pressure_is_larger_than_the_largest() {
    let mut away = 0;
    for (name, contact) in contacts() {
        let peak = contact.peak();
        if peak.pressure.is_infinite() {
            assert_eq!(contact.pressure(peak.x), f64::INFINITY, "{name}: {peak:?}");
            continue;
        }
        away += usize::from(peak.x > 0.0);
        // next to graded faces the pressure in the middle is known better than its series
        let found = contact.pressure(peak.x);
        assert!((found / peak.pressure - 1.0).abs() < 1e-7, "{name}: {found} {peak:?}");
        for interval in contact.intervals() {
            for (x, _) in dense(interval.left, interval.right, 5000) {
                let more = contact.pressure(x) - peak.pressure;
                assert!(more <= peak.error + 1e-7 * peak.pressure, "{name}: {more:e} at {x}, {peak:?}");
            }
        }
    }
    assert!(away > 5, "{away}");
}

#[test]
fn largest_pressures_are_those_of_closed_forms() {
    // a parabola: 2P/(πa) in the middle
    let contact = &half_plane(&Punch::parabola(500.0).unwrap(), 0.002).contacts()[0].clone();
    assert_eq!((contact.peak().pressure, contact.peak().x), (contact.central_pressure, 0.0));
    // next to a sharp tip and next to sharp corners it is infinite
    let infinite = |contact: &Contact| (contact.peak().pressure, contact.peak().error, contact.peak().x);
    let wedge = half_plane(&Punch::wedge(0.01).unwrap(), 0.002);
    assert_eq!(infinite(&wedge.contacts()[0]), (f64::INFINITY, 0.0, 0.0));
    let flat = half_plane(&Punch::flat(0.5).unwrap(), 0.002);
    assert_eq!(infinite(&flat.contacts()[0]), (f64::INFINITY, 0.0, 0.5));
    // a fourth power: p = p₀ (1 + 2s²)√(1 − s²), largest where s² = 1/2
    let power = half_plane(&Punch::power(4.0, 1.0, 0.01).unwrap(), 0.002);
    let contact = &power.contacts()[0];
    let (peak, expected) = (contact.peak(), contact.half_length().unwrap() * 0.5f64.sqrt());
    assert!((peak.x - expected).abs() <= peak.x_error && peak.x_error < 1e-4 * expected, "{peak:?} {expected}");
    let ratio = 2f64.sqrt();
    assert!((peak.pressure / contact.central_pressure - ratio).abs() < 1e-11, "{peak:?} {ratio}");
}

#[test]
fn a_load_presses_in_intervals_too() {
    let pair = |half_width: f64| {
        let load = Load::uniform(half_width).unwrap();
        crate::support::mirrored(&[(2.0, 0.75, load), (0.0, 0.25, Load::Line)]).unwrap()
    };
    let stack = || Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25).unwrap()).build().unwrap();
    let solution = Model::new(stack()).unwrap().press(recede::Top::from(pair(0.5)), 4.0).unwrap();
    let found: Vec<_> =
        solution.contacts()[0].intervals().iter().map(|i| [i.left, i.right, i.force, i.centroid]).collect();
    assert_eq!(found, [[-2.5, -1.5, 1.5, -2.0], [0.0, 0.0, 1.0, 0.0], [1.5, 2.5, 1.5, 2.0]]);
}

/// Next to a round edge that is four thousand times shorter than the contact the pressure falls like a logarithm, below zero in the end: bodies are apart there. How far
/// they touch grows by what is proportional to the flat part.
#[test]
fn bodies_are_apart_under_a_flat_part_that_is_next_to_nothing() {
    let solve = |punch: &str| {
        let scene = Scene::from_ron(&format!(
            "Scene(geometry: PlaneStress, punch: {punch}, force: 0.5, stack: [\
             Exponential(thickness: 31.6, shear_modulus: 100.0, poisson: 0.08, beta: -0.178), Bonded, \
             PowerHalfPlane(shear_modulus: 0.01, poisson: 0.0, length: 31.6, exponent: -0.5)])"
        ))
        .unwrap();
        let solution = Model::new(scene.stack().unwrap()).unwrap().press(&scene.top, scene.force).unwrap();
        solution.contacts()[0].intervals().to_vec()
    };
    let [parabola] = solve("Parabola(radius: 5150)")[..] else { panic!("a parabola touches everywhere") };
    let longer = [1.0, 0.1].map(|flat| {
        let [left, right] = solve(&format!("RoundedFlat(half_width: {flat}, radius: 5150)"))[..] else {
            panic!("bodies touch under the flat part of {flat}")
        };
        assert!(right.left > 10.0 * flat && (right.left + left.right).abs() < 1e-12 * right.right);
        right.right - parabola.right
    });
    assert!((longer[0] / longer[1] - 10.0).abs() < 0.3, "{longer:?}");
}
