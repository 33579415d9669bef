//! Contacts where nothing is even.
//!
//! Goal: under loads and punches anywhere independent programs find the same contacts; they move with the loads, are mirrored with them, and where loads are even but
//! for their place, the solver for even contacts finds the same; every contact carries the force on its line of action; random scenes are solved.
//!
//! Source of the numbers: an independent program, see [`ASYMMETRIC`].
use recede::selftest::{CheckedScene, Outcome, Ranges, scene_of_any_kind};
use recede::{
    Contact, Exponential, FaceSide, HalfPlane, Homogeneous, Interface, Load, Loads, Model, Options, Plane, Pressed,
    Punch, Punches, Scene, Solution, Stack, Tilt, Top,
};

/// Line loads (x, force) on a homogeneous strip of thickness 1 loose on a half-plane of (1 − ν)/μ = k times (1 − ν)/μ of the strip: ends of the contact and
/// the pressure at the centroid of the loads.
type UnderLines = ([(f64, f64); 2], f64, [f64; 2], f64);
const ASYMMETRIC: [UnderLines; 2] = [
    ([(0.0, 0.75), (1.0, 0.25)], 1.0, [-1.2392876863, 1.8855900970], 0.548302001),
    ([(0.0, 0.6), (0.8, 0.4)], 0.0, [-0.7614015647, 1.4751334522], 0.659934596),
];

/// Two parabolic punches (radius, x, force) that do not turn on a homogeneous strip of thickness 1, with μ = 1 and ν = 0.25, loose on a half-plane of its material: ends of the
/// contacts under both and below, and the pressures in the middle of the former.
type UnderParabolas = ([[f64; 3]; 2], [[f64; 2]; 3], [f64; 2]);
const TWO_PARABOLAS: [UnderParabolas; 2] = [
    (
        [[100.0, -1.0, 0.001], [100.0, 1.0, 0.001]],
        [[-1.2354917617, -0.796366114], [0.796366114, 1.2354917617], [-2.2321283719, 2.2321283719]],
        [0.002898992145, 0.002898992145],
    ),
    (
        [[100.0, 0.0, 0.002], [60.0, 1.5, 0.001]],
        [[-0.335552035, 0.2893111136], [1.3587556619, 1.6962259547], [-1.2852350667, 2.5575988136]],
        [0.004072717348, 0.003772659055],
    ),
];

fn lines(all: &[(f64, f64)]) -> Loads {
    Loads::new(&all.iter().map(|(at, force)| (Load::Line, *at, *force)).collect::<Vec<_>>()).unwrap()
}

/// Stacks with one and with two receding interfaces.
fn stacks() -> Vec<Model> {
    let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    let graded = || Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
    let ground = || HalfPlane::new(0.6, 0.3).unwrap();
    let stack = || Stack::builder(Plane::Strain);
    [
        stack().layer(strip()).receding().layer(ground()),
        stack().layer(strip()).receding().layer(Homogeneous::new(0.5, 3.0, 0.2).unwrap()).receding().layer(ground()),
        stack().layer(graded()).bonded().layer(strip()).receding().rigid(),
        stack().layer(strip()).bonded().layer(graded()).receding().layer(ground()),
    ]
    .map(|stack| Model::new(stack.build().unwrap()).unwrap())
    .into()
}

/// Parts of a load with their places, about as far apart as the contacts are long, or farther, so that there are several intervals.
fn cases() -> [Vec<(Load, f64, f64)>; 3] {
    [
        vec![(Load::Line, -0.3, 0.2), (Load::uniform(0.4).unwrap(), 0.7, 0.8)],
        vec![(Load::elliptic(0.6).unwrap(), 0.0, 1.0), (Load::Line, 6.5, 0.3)],
        vec![(Load::parabolic(0.2).unwrap(), -1.0, 0.3), (Load::parabolic(0.2).unwrap(), 1.2, 0.3)],
    ]
}

fn press(model: &Model, parts: &[(Load, f64, f64)]) -> Solution {
    let loads = Loads::new(parts).unwrap();
    let solution = model.press(&loads, loads.force()).unwrap();
    assert!(solution.warnings().iter().all(|warning| warning.code.is_about_theory()), "{:?}", solution.warnings());
    solution
}

/// Ends of all intervals of all contacts below the loads.
fn ends(solution: &Solution) -> Vec<[f64; 2]> {
    let intervals = solution.contacts()[1..].iter().flat_map(Contact::intervals);
    intervals.map(|interval| [interval.left, interval.right]).collect()
}

fn close(found: &[[f64; 2]], expected: &[[f64; 2]], error: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() <= error, "{found} is not {expected}");
    }
}

#[test]
fn under_line_loads_contacts_are_those_of_an_independent_program() {
    for (loads, k, expected, pressure) in ASYMMETRIC {
        let stack = Stack::builder(Plane::Strain).layer(Homogeneous::new(1.0, 1.0, 0.25).unwrap()).receding();
        let stack = if k == 0.0 { stack.rigid() } else { stack.layer(HalfPlane::new(1.0 / k, 0.25).unwrap()) };
        let model = Model::new(stack.build().unwrap()).unwrap();
        // lengths do not depend on the size of the loads
        for size in [1.0, 1e-6] {
            let solution = model.press(lines(&loads), size).unwrap();
            close(&ends(&solution), &[expected], 2e-10);
            let contact = &solution.contacts()[1];
            let middle = contact.intervals()[0].centroid;
            assert!((contact.pressure(middle) / size - pressure).abs() < 1e-9);
            assert!(contact.intervals()[0].left_error < 1e-9 && contact.intervals()[0].right_error < 1e-9);
        }
    }
}

#[test]
fn no_pressure_is_larger_than_the_largest() {
    // the largest pressure wanders from one load towards the other, and through the middle of the contact
    for at in [-0.8, -0.4, 0.4, 0.8] {
        for part in [0.1, 0.3, 0.45] {
            let solution = press(&stacks()[0], &[(Load::Line, 0.0, 1.0 - part), (Load::Line, at, part)]);
            let (contact, peak) = (&solution.contacts()[1], solution.contacts()[1].peak());
            let [left, right] = [contact.intervals()[0].left, contact.intervals()[0].right];
            for x in (0..=2000).map(|k| left + (right - left) * f64::from(k) / 2000.0) {
                let more = contact.pressure(x) - peak.pressure;
                assert!(more <= peak.error, "{more:e} at {x}, {peak:?}");
            }
        }
    }
}

#[test]
fn contacts_move_and_are_mirrored_with_the_loads() {
    for model in &stacks() {
        for parts in &cases() {
            let here = press(model, parts);
            for (sign, by) in [(1.0, 3.7), (-1.0, 0.0), (-1.0, -250.0)] {
                let moved: Vec<_> =
                    parts.iter().map(|(load, at, force)| (load.clone(), sign * at + by, *force)).collect();
                let there = press(model, &moved);
                let mut expected: Vec<[f64; 2]> = Vec::new();
                for (contact, moved) in here.contacts()[1..].iter().zip(&there.contacts()[1..]) {
                    let mut own: Vec<[f64; 2]> = contact
                        .intervals()
                        .iter()
                        .map(|interval| [sign * interval.left + by, sign * interval.right + by])
                        .map(|[a, b]| if a < b { [a, b] } else { [b, a] })
                        .collect();
                    own.sort_by(|a, b| a[0].total_cmp(&b[0]));
                    expected.extend(own);
                    let largest = contact.peak().pressure;
                    for interval in contact.intervals() {
                        let x = interval.left + 0.3 * (interval.right - interval.left);
                        let pressures = [contact.pressure(x), moved.pressure(sign * x + by)];
                        assert!((pressures[0] - pressures[1]).abs() < 1e-9 * largest, "{pressures:?}");
                    }
                }
                close(&ends(&there), &expected, 2e-10);
            }
        }
    }
}

#[test]
fn loads_that_are_even_but_for_their_place_make_even_contacts() {
    let parts = [(Load::uniform(0.3).unwrap(), 0.0, 1.0), (Load::Line, -0.8, 0.2), (Load::Line, 0.8, 0.2)];
    for model in &stacks() {
        let even = press(model, &parts);
        let moved = press(model, &parts.clone().map(|(load, at, force)| (load, at + 0.5, force)));
        let expected: Vec<[f64; 2]> = ends(&even).iter().map(|ends| ends.map(|x| x + 0.5)).collect();
        close(&ends(&moved), &expected, 2e-10);
        for (even, moved) in even.contacts()[1..].iter().zip(&moved.contacts()[1..]) {
            for x in [-0.9, -0.2, 0.0, 0.6] {
                assert!((even.pressure(x) - moved.pressure(x + 0.5)).abs() < 1e-9 * even.peak().pressure);
            }
        }
    }
}

#[test]
fn every_contact_carries_the_force_on_its_line_of_action() {
    for model in &stacks() {
        for parts in &cases() {
            let solution = press(model, parts);
            let force: f64 = parts.iter().map(|(.., force)| force).sum();
            let moment: f64 = parts.iter().map(|(_, at, force)| at * force).sum();
            for contact in solution.contacts() {
                let intervals = contact.intervals();
                let found: f64 = intervals.iter().map(|interval| interval.force).sum();
                let about_0: f64 = intervals.iter().map(|interval| interval.force * interval.centroid).sum();
                assert!((found / force - 1.0).abs() < 1e-12, "{found} {force}");
                assert!((about_0 - moment).abs() < 1e-12 * force * contact.reach(), "{about_0} {moment}");
            }
        }
    }
}

#[test]
fn layers_that_have_turned_lie_on_each_other() {
    for model in &stacks() {
        for parts in &cases() {
            let solution = press(model, parts);
            let reach = solution.extent().unwrap();
            let x: Vec<f64> = (-60..=60).map(|k| f64::from(k) / 40.0 * reach).collect();
            let loads = Loads::new(parts).unwrap();
            let profile = model.profile(&loads, &solution, &x).unwrap();
            for (contact, seen) in solution.contacts().iter().zip(&profile.contacts).skip(1) {
                let gap = seen.gap.as_ref().unwrap();
                let widest = gap.iter().copied().fold(0.0, f64::max);
                assert!(widest > 0.0 && gap.iter().all(|gap| *gap >= -1e-8 * widest), "{:?}", contact.interface);
            }
            // displacements of the faces, found from the pressures alone, are the same where the bodies touch
            let face = |layer: usize, side: FaceSide| {
                profile.faces.iter().find(|face| (face.layer, face.side) == (layer, side))
            };
            for contact in &solution.contacts()[1..] {
                let Interface::Between { above, below } = contact.interface else { continue };
                let (above, below) = (face(above, FaceSide::Bottom).unwrap(), face(below, FaceSide::Top));
                for (k, x) in x.iter().enumerate().filter(|(_, x)| contact.pressure(**x) > 0.0) {
                    let apart = above.points[k].v - below.map_or(0.0, |below| below.points[k].v);
                    let most = above.points.iter().map(|point| point.v.abs()).fold(0.0, f64::max);
                    assert!(apart.abs() < 1e-7 * most, "{:?} at {x}: {apart:e} of {most:e}", contact.interface);
                }
            }
        }
    }
}

fn press_punches(model: &Model, all: &[(Punch, f64, f64, Tilt)]) -> Solution {
    let pressed = |(shape, at, force, tilt): &(Punch, f64, f64, Tilt)| Pressed::new(shape.clone(), *at, *force, *tilt);
    let punches = Punches::new(&all.iter().map(pressed).collect::<Result<Vec<_>, _>>().unwrap()).unwrap();
    model.press(&punches, punches.force()).unwrap()
}

/// Ends of all intervals of all contacts.
fn all_ends(solution: &Solution) -> Vec<[f64; 2]> {
    let intervals = solution.contacts().iter().flat_map(Contact::intervals);
    intervals.map(|interval| [interval.left, interval.right]).collect()
}

#[test]
fn under_two_parabolas_contacts_are_those_of_an_independent_program() {
    let stack = Stack::builder(Plane::Strain).layer(Homogeneous::new(1.0, 1.0, 0.25).unwrap()).receding();
    let model = Model::new(stack.layer(HalfPlane::new(1.0, 0.25).unwrap()).build().unwrap()).unwrap();
    let parabola = |radius: f64, at: f64, force: f64| (Punch::parabola(radius).unwrap(), at, force, Tilt::None);
    for ((punches, expected, pressures), turned) in TWO_PARABOLAS.into_iter().zip([0.0, -6.75381e-5]) {
        let solution = press_punches(&model, &punches.map(|[radius, at, force]| parabola(radius, at, force)));
        close(&all_ends(&solution), &expected, 2e-10);
        assert!((solution.rotations()[0] - turned).abs() < 1e-10, "{:?}", solution.rotations());
        let top = &solution.contacts()[0];
        for (interval, pressure) in top.intervals().iter().zip(pressures) {
            assert!((top.pressure(0.5 * (interval.left + interval.right)) - pressure).abs() < 1e-11);
        }
        for (on, [.., force]) in solution.punches().iter().zip(punches) {
            assert!((on.force / force - 1.0).abs() < 1e-12 && on.tilt == 0.0);
        }
    }
}

/// Far from the contacts a loose layer is straight, and the mean of its slopes on both sides is the angle by which it is turned.
#[test]
fn layers_are_turned_by_the_mean_of_their_slopes_far_away() {
    for model in &stacks() {
        for parts in &cases() {
            let solution = press(model, parts);
            let far = 8.0 * solution.extent().unwrap();
            let field = model.field(&solution).unwrap();
            let first = solution.rotations()[0];
            let slope = |x: f64| field.at(x, 0.0).unwrap().slope;
            // in graded layers, whose equations are integrated, slopes far away are known to 1e-7
            assert!((0.5 * (slope(-far) + slope(far)) - first).abs() < 1e-6 * slope(far).abs(), "{first}");
        }
    }
}

#[test]
fn a_parabola_that_is_turned_is_one_that_is_moved() {
    let parabola = || Punch::parabola(80.0).unwrap();
    for model in &stacks() {
        let turned = press_punches(model, &[(parabola(), 1.0, 0.01, Tilt::Fixed(2e-3))]);
        let moved = press_punches(model, &[(parabola(), 1.0 - 80.0 * 2e-3, 0.01, Tilt::None)]);
        close(&all_ends(&turned), &all_ends(&moved), 2e-10);
        // also where that is many times as far as the contact is long
        let turned = press_punches(model, &[(parabola(), 1.0, 1e-3, Tilt::Fixed(0.02))]);
        let moved_far = press_punches(model, &[(parabola(), 1.0 - 80.0 * 0.02, 1e-3, Tilt::None)]);
        close(&all_ends(&turned), &all_ends(&moved_far), 2e-10);
        // a force beside the tip turns it as far as it would have to be moved
        let free = press_punches(model, &[(parabola(), 1.0, 0.01, Tilt::Free { eccentricity: -0.16 })]);
        close(&all_ends(&free), &all_ends(&moved), 2e-10);
        assert!((free.punches()[0].tilt - 2e-3).abs() < 1e-10, "{:?}", free.punches());
        assert!((free.punches()[0].moment + 0.16 * 0.01).abs() < 1e-12);
        let upright = model.press(parabola(), 0.01).unwrap();
        let expected: Vec<[f64; 2]> = all_ends(&upright).iter().map(|ends| ends.map(|x| x + 0.84)).collect();
        close(&all_ends(&moved), &expected, 2e-10);
    }
}

#[test]
fn one_punch_or_even_loads_make_even_contacts_wherever_they_are() {
    let shapes = [Punch::flat(0.4), Punch::wedge(0.02), Punch::rounded_flat(0.3, 20.0), Punch::cylinder(40.0)];
    for shape in shapes.map(Result::unwrap) {
        for model in &stacks() {
            let expected = model.press(&shape, 0.01).unwrap();
            let moved = press_punches(model, &[(shape.clone(), -7.25, 0.01, Tilt::None)]);
            assert!(expected.punches().is_empty() && (moved.punches()[0].force - 0.01).abs() < 1e-14);
            for (expected, moved) in expected.contacts().iter().zip(moved.contacts()) {
                assert_eq!(expected.intervals().len(), moved.intervals().len());
                for x in [-0.3, 0.1, 0.35] {
                    let [a, b] = [expected.pressure(x), moved.pressure(x - 7.25)];
                    assert!((a - b).abs() <= 1e-9 * a.abs(), "{shape} at {x}: {a} {b}");
                }
            }
        }
    }
}

/// Where a punch is not smooth terms fall slowly: they go on as on a half-plane, and pressures have all digits.
#[test]
fn punches_with_kinks_press_alike_with_and_without_symmetry() {
    let table = Punch::table(&[(0.0, 0.0), (0.25, 0.0006), (0.5, 0.0026), (0.75, 0.0058), (1.0, 0.0099)]).unwrap();
    let rounded = Punch::rounded_flat(0.5, 20.0).unwrap();
    for (punch, force) in [(table, 0.005), (rounded, 0.05)] {
        for model in &stacks() {
            let even = model.press(punch.clone(), force).unwrap();
            let free = Tilt::Free { eccentricity: 1e-12 };
            let uneven = press_punches(model, &[(punch.clone(), 0.0, force, free)]);
            close(&all_ends(&uneven), &all_ends(&even), 1e-9);
            let [a, b] = [&even, &uneven].map(|solution| &solution.contacts()[0]);
            let size = a.pressure(0.0);
            for x in [0.0, 0.1, 0.3, 0.9].map(|part| part * a.half_length().unwrap()) {
                // with 3,072 terms pressures are known so well away from kinks; the middle of the table is one
                let known = if x == 0.0 { 1e-6 } else { 5e-8 };
                assert!(
                    (a.pressure(x) - b.pressure(x)).abs() < known * size,
                    "{x}: {} {}",
                    a.pressure(x),
                    b.pressure(x)
                );
            }
            let off = (a.central_pressure - b.central_pressure).abs();
            assert!(off <= 2.0 * (a.central_pressure_error + b.central_pressure_error), "{off:e} {b:?}");
        }
    }
}

#[test]
fn punches_are_mirrored_and_a_table_may_be_uneven() {
    let rows = |sign: f64| -> Vec<(f64, f64)> {
        let mut rows: Vec<_> = (-8..=8)
            .map(|k| 0.25 * f64::from(k))
            .map(|x| (sign * x, 0.01 * x * x + if x > 0.0 { 0.004 * x * x * x } else { 0.0 }))
            .collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        rows
    };
    let punch = |sign: f64| Punch::table(&rows(sign)).unwrap();
    for model in &stacks() {
        let [here, there] = [1.0, -1.0].map(|sign| {
            let roller = (Punch::cylinder(30.0).unwrap(), 3.5 * sign, 0.004, Tilt::Fixed(1e-3 * sign));
            press_punches(model, &[(punch(sign), -0.5 * sign, 0.006, Tilt::None), roller])
        });
        for (here, there) in here.contacts().iter().zip(there.contacts()) {
            for (interval, image) in here.intervals().iter().zip(there.intervals().iter().rev()) {
                assert!((interval.left + image.right).abs() < 1e-9 && (interval.right + image.left).abs() < 1e-9);
                assert!((interval.force / image.force - 1.0).abs() < 1e-9);
            }
        }
        let [one, other] = [here.punches(), there.punches()];
        assert!((one[0].moment + other[1].moment).abs() < 1e-11, "{one:?} {other:?}");
        assert!((one[1].tilt + other[0].tilt).abs() < 1e-16, "{one:?} {other:?}");
    }
}

/// Two loads far apart make a contact of two intervals: where the forces differ by rounding, nothing is even, and the contact is the same.
#[test]
fn pairs_of_intervals_are_the_same_without_symmetry() {
    let graded = Exponential::new(1.0, 1.0, 0.25, 1.0).unwrap();
    let stack = Stack::builder(Plane::Strain).layer(graded).receding().layer(HalfPlane::new(1.0, 0.25).unwrap());
    let model = Model::new(stack.build().unwrap()).unwrap();
    let load = Load::uniform(0.2).unwrap();
    let pressed = |left: f64| press(&model, &[(load.clone(), -3.0, left), (load.clone(), 3.0, 5e-3)]);
    let (even, uneven) = (pressed(5e-3), pressed(5e-3 * (1.0 + 1e-13)));
    assert_eq!(even.contacts()[1].intervals().len(), 2);
    close(&ends(&even), &ends(&uneven), 2e-11);
    for x in [1.2, 2.5, 3.1, 4.2] {
        let [one, other] = [&even, &uneven].map(|solution| solution.contacts()[1].pressure(x));
        assert!((one / other - 1.0).abs() < 1e-9, "{x}: {one} {other}");
    }
}

/// Random scenes whose loads are not even and whose layers may lift off.
fn random(seed: u64, count: usize) -> impl Iterator<Item = (u64, Scene)> {
    let scene = move |number| (number, scene_of_any_kind(&Ranges::moderate(), seed, number).unwrap());
    let is_uneven = |(_, scene): &(u64, Scene)| {
        let recedes = scene.stack().unwrap().contacts().len() > 1;
        recedes && matches!(&scene.top, Top::Loads(loads) if !loads.is_even())
    };
    (0..).map(scene).filter(is_uneven).take(count)
}

#[test]
fn random_scenes_are_solved_and_reported() {
    let mut unsolved = Vec::new();
    for (number, scene) in random(37, 3) {
        match CheckedScene::run(&scene, &Options::default(), false).outcome {
            Outcome::Solved(_) => {}
            Outcome::Unsolved(error) => unsolved.push((number, error)),
            Outcome::Wrong(what) | Outcome::Panicked(what) => panic!("{number}: {what}\n{}", scene.to_ron()),
        }
    }
    assert!(unsolved.is_empty(), "{unsolved:?}");
}
