//! The programme against the solver: nothing in common but the kernels.
use crate::contact::problem::Expected;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::SAFETY;
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::selftest::{Ranges, about_axis, scene, scene_with_punches};
use crate::{Geometry, Load, Loads, Model, Options, Punch, Scene, Solution, Top};

use crate::contact::programme::compliances::Compliances;
use crate::contact::programme::energy::Energy;
use crate::contact::programme::equilibrium::{Equilibrium, State};
use crate::contact::programme::grid::Grid;
use crate::contact::programme::patch::Patch;
use crate::contact::programme::{COARSE, answer, between, touching};

/// In the plane, or the like about an axis.
fn drawn(geometry: Geometry, seed: u64, number: u64) -> Scene {
    let scene = scene(&Ranges::moderate(), seed, number).scene().unwrap();
    if geometry.is_axisymmetric() { about_axis(scene) } else { scene }
}

/// Calls back with so many random scenes, the kernels of each, what is expected of it, and the solver's answer.
fn each_solved(
    geometry: Geometry,
    seed: u64,
    count: usize,
    mut look: impl FnMut(u64, &Problem, &[Expected], &Solution),
) {
    let options = Options { tolerance: 1e-6 };
    let solved = (0..).filter_map(|number| {
        let scene = drawn(geometry, seed, number);
        let stack = scene.stack().unwrap();
        let solution = Model::new(stack.clone()).unwrap().press_with(&scene.top, scene.force, &options).ok()?;
        Some((number, scene, stack, solution))
    });
    for (number, scene, stack, solution) in solved.take(count) {
        let kernel = Kernel::new(&stack).unwrap();
        let interfaces = stack.contacts();
        let problem = Problem::new(
            &kernel,
            &interfaces,
            (&scene.top, &[], None),
            scene.force.given().unwrap(),
            options.tolerance,
        );
        let expected = formulas::anywhere(&problem);
        look(number, &problem, &expected, &solution);
    }
}

#[test]
fn half_lengths_are_those_of_the_quadratic_programme() {
    for (geometry, count) in [(Geometry::PlaneStrain, 100), (Geometry::Axisymmetric, 30)] {
        each_solved(geometry, 5, count, |number, problem, expected, solution| {
            let touching = touching(problem, problem.kernel, expected, 0.0).unwrap();
            assert_eq!(touching.len(), solution.contacts().len(), "{number}");
            for (touching, contact) in touching.iter().zip(solution.contacts()) {
                let error = touching.ends[1] * problem.kernel.length() / contact.innermost().right - 1.0;
                assert!(error.abs() < SAFETY * COARSE.ends, "{geometry:?}, {number}, {}: {error}", contact.interface);
            }
        });
    }
}

#[test]
fn its_own_answer_is_as_good_as_it_says() {
    for (geometry, count) in [(Geometry::PlaneStrain, 20), (Geometry::Axisymmetric, 10)] {
        each_solved(geometry, 6, count, |number, problem, expected, solution| {
            let coarse = answer(problem, problem.kernel, expected, 0.0).unwrap().into_solution(
                problem,
                problem.total_force(),
                None,
            );
            for (coarse, fine) in coarse.contacts().iter().zip(solution.contacts()) {
                assert!((coarse.resultant / fine.resultant - 1.0).abs() < 1e-12, "{number}: {}", coarse.resultant);
                assert!(
                    (coarse.innermost().right - fine.innermost().right).abs() < coarse.innermost().right_error,
                    "{number}: {coarse:?}"
                );
                let pressure = (coarse.central_pressure - fine.central_pressure).abs();
                assert!(pressure < coarse.central_pressure_error, "{number}, {}: {pressure}", coarse.interface);
                // and so is the pressure elsewhere, on average
                let off = (0..50).map(|k| 0.9 * fine.innermost().right * (f64::from(k) + 0.5) / 50.0);
                let off: f64 = off.map(|x| (coarse.pressure(x) - fine.pressure(x)).abs() / 50.0).sum();
                assert!(off < 0.1 * fine.central_pressure, "{number}, {}: {off}", coarse.interface);
            }
        });
    }
}

#[test]
fn openings_of_layers_that_weights_press_together_are_known_as_well() {
    let two = "punches: [(shape: Parabola(radius: 100), at: 0.0, force: 2e-3), (shape: Parabola(radius: 60), at: 1.5, force: 1e-3)]";
    for top in ["punch: Parabola(radius: 100), force: 2e-3", "load: Uniform(half_width: 0.2), force: 3e-3", two] {
        let scene = Scene::from_ron(&format!(
            "Scene(geometry: PlaneStrain, {top}, pressure_on_top: 1e-5, stack: [
            Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Receding,
            Homogeneous(thickness: 2.0, shear_modulus: 0.5, poisson: 0.25), Receding,
            HalfPlane(shear_modulus: 1.0, poisson: 0.25)])"
        ));
        let scene = scene.unwrap();
        let stack = scene.stack().unwrap();
        let (kernel, laminates) = (Kernel::of_openings(&stack).unwrap(), Kernel::new(&stack).unwrap());
        let interfaces = stack.contacts();
        let weights: Vec<_> = interfaces.iter().skip(1).copied().zip(stack.weights()).collect();
        let fine = Model::new(stack.clone()).unwrap().press(&scene.top, scene.force).unwrap();
        let force = fine.force();
        let problem = Problem::opened(&kernel, &interfaces, (&scene.top, &[], None), (&weights, &[]), force, 1e-6);
        let mut expected = formulas::anywhere(&problem);
        expected.push(Expected { contact: 1, punch: 0, ends: [3.0, 4.0] });
        let coarse = answer(&problem, &laminates, &expected, 0.0).unwrap();
        let coarse = coarse.into_solution(&problem, force, None);
        assert_eq!(fine.closed().len(), 2);
        for (coarse, fine) in coarse.closed().iter().zip(fine.closed()) {
            assert!((coarse.openings.len(), fine.openings.len()) == (2, 2), "{top}: {coarse:?}");
            for (coarse, fine) in coarse.openings.iter().zip(&fine.openings) {
                let moved = [(coarse.left - fine.left).abs(), (coarse.right - fine.right).abs()];
                assert!(moved[0] < coarse.left_error && moved[1] < coarse.right_error, "{top}: {coarse:?} {fine:?}");
                assert!((coarse.largest_gap / fine.largest_gap - 1.0).abs() < 0.05, "{top}: {coarse:?} {fine:?}");
            }
            let pressure = (coarse.central_pressure - fine.central_pressure).abs();
            assert!(pressure < coarse.central_pressure_error, "{top}: {pressure}");
            // the slope of the gap, of which fields are made
            let widest = &fine.openings[0];
            let gaps = [&coarse.gap(widest.largest_gap_at), &fine.gap(widest.largest_gap_at)].map(|gap| gap.abs());
            assert!((gaps[0] / gaps[1] - 1.0).abs() < 0.05, "{top}: {gaps:?}");
        }
    }
}

#[test]
fn corners_tips_and_given_loads_are_known_as_well() {
    let options = Options { tolerance: 1e-6 };
    for number in 0..12 {
        let scene = scene(&Ranges::moderate(), 9, number).scene().unwrap();
        let stack = scene.stack().unwrap();
        let kernel = Kernel::new(&stack).unwrap();
        let width = 0.3 * kernel.length();
        let lines = [(-2.0 * width, 0.5), (0.0, 1.0), (2.0 * width, 0.5)].map(|(at, force)| (Load::Line, at, force));
        let loads = [Top::from(Load::uniform(width).unwrap()), Loads::new(&lines).unwrap().into()];
        let mut compared = 0;
        for punch in [Punch::flat(width).unwrap(), Punch::wedge(0.01).unwrap()].map(Top::from).iter().chain(&loads) {
            let Ok(fine) = Model::new(stack.clone()).unwrap().press_with(punch, scene.force, &options) else {
                continue;
            };
            if fine.contacts().iter().any(|contact| contact.half_length().is_none()) {
                continue;
            }
            let interfaces = stack.contacts();
            let problem =
                Problem::new(&kernel, &interfaces, (punch, &[], None), scene.force.given().unwrap(), options.tolerance);
            let expected = formulas::anywhere(&problem);
            let Some(coarse) = answer(&problem, problem.kernel, &expected, 0.0) else {
                // nothing is unknown
                assert!(kernel.contacts() == 1 && punch.loads().is_some(), "{number}, {punch:?}");
                continue;
            };
            let coarse = coarse.into_solution(&problem, scene.force.given().unwrap(), None);
            for (coarse, fine) in coarse.contacts().iter().zip(fine.contacts()) {
                let off = (coarse.innermost().right - fine.innermost().right).abs();
                assert!(
                    off <= coarse.innermost().right_error,
                    "{number}, {punch:?}: {coarse:?} {}",
                    fine.innermost().right
                );
                if fine.central_pressure.is_finite() {
                    let off = (coarse.central_pressure - fine.central_pressure).abs();
                    assert!(off <= coarse.central_pressure_error, "{number}, {punch:?}: {off} {}", coarse.interface);
                } else {
                    assert_eq!(coarse.central_pressure, fine.central_pressure);
                }
                compared += 1;
            }
        }
        assert!(compared > 0, "{number}");
    }
}

#[test]
fn where_bodies_touch_there_is_no_gap_and_where_not_no_pressure() {
    for number in 0..8 {
        let geometry = if number < 6 { Geometry::PlaneStrain } else { Geometry::Axisymmetric };
        let scene = drawn(geometry, 8, number);
        let kernel = Kernel::new(&scene.stack().unwrap()).unwrap();
        let problem = Problem::new(&kernel, &[], (&scene.top, &[], None), scene.force.given().unwrap(), 1e-10);
        let patch = if geometry.is_axisymmetric() { Patch::Ring } else { Patch::Pair };
        let grid = Grid::new(vec![[0.0, 0.5]], [0.0, 20.0], &[], patch).unwrap();
        let energy = Energy::new(&Compliances::new(&problem, problem.kernel, &[]), &grid).unwrap();
        let (contacts, elements) = (energy.contacts(), energy.elements());
        // in one interval each, and in parts that are others in each contact
        for parts in [false, true] {
            let touches = |i: usize, e: usize| {
                !energy.inadmissible[i][e]
                    && if parts { e == 0 || (e / 3 + i).is_multiple_of(2) } else { e < 9 + 2 * i }
            };
            let touching: Vec<Vec<bool>> =
                (0..contacts).map(|i| (0..elements).map(|e| touches(i, e)).collect()).collect();
            let State { pressures, gaps, .. } = Equilibrium::new(&energy, &touching).solve().unwrap();
            for i in 0..contacts {
                let resultant: f64 = pressures[i].iter().zip(&energy.resultants).map(|(p, area)| p * area).sum();
                assert!((resultant - 1.0).abs() < 1e-9, "{number}, {i}: {resultant}");
                let widest = gaps[i].iter().fold(0.0, |widest: f64, gap| widest.max(gap.abs()));
                for e in 0..elements {
                    let nothing = if touching[i][e] { gaps[i][e] / widest } else { pressures[i][e] };
                    assert!(nothing.abs() < 1e-8, "{number}, {i}, {e}: {nothing}");
                }
            }
        }
    }
}

#[test]
fn where_nothing_is_even_it_is_as_good_as_it_says() {
    let options = Options { tolerance: 1e-6 };
    // one to four punches that turn or do not, over one to three contacts that nothing but these presses and without gaps
    for number in [1, 3, 4, 5, 10, 16, 22, 23] {
        let scene = scene_with_punches(&Ranges::moderate(), 3, number).unwrap();
        let stack = scene.stack().unwrap();
        let fine = Model::new(stack.clone()).unwrap().press_with(&scene.top, scene.force, &options).unwrap();
        let (kernel, interfaces) = (Kernel::new(&stack).unwrap(), stack.contacts());
        let problem = Problem::new(
            &kernel,
            &interfaces,
            (&scene.top, &[], None),
            scene.force.given().unwrap(),
            options.tolerance,
        );
        let mut expected = formulas::anywhere(&problem);
        let look = |expected: &[Expected]| {
            let coarse = answer(&problem, problem.kernel, expected, 0.0).unwrap();
            is_as_good_as_it_says(number, &coarse.into_solution(&problem, problem.total_force(), None), &fine);
        };
        look(&expected);
        // from a place between two punches that is under the right one of them; under three of them exchanging elements may not end from there
        if problem.groups(0).len() == 2 {
            let [left, right] = expected[1].ends;
            expected[0].ends[1] = left + 0.2 * (right - left);
            look(&expected);
        }
    }
}

/// Ends of intervals agree within their errors, forces and angles to one per cent.
fn is_as_good_as_it_says(number: u64, coarse: &Solution, fine: &Solution) {
    for (coarse, fine) in coarse.contacts().iter().zip(fine.contacts()) {
        assert_eq!(coarse.intervals().len(), fine.intervals().len(), "{number}");
        for (coarse, fine) in coarse.intervals().iter().zip(fine.intervals()) {
            let [left, right] = [coarse.left - fine.left, coarse.right - fine.right].map(f64::abs);
            assert!(left <= coarse.left_error + fine.left_error, "{number}: {coarse:?} {fine:?}");
            assert!(right <= coarse.right_error + fine.right_error, "{number}: {coarse:?} {fine:?}");
            assert!((coarse.force / fine.force - 1.0).abs() < 0.01, "{number}: {coarse:?} {fine:?}");
        }
    }
    for (coarse, fine) in coarse.punches().iter().zip(fine.punches()) {
        assert!((coarse.force / fine.force - 1.0).abs() < 1e-9, "{number}: {coarse:?} {fine:?}");
        assert!((coarse.tilt - fine.tilt).abs() <= 0.01 * fine.tilt.abs(), "{number}: {coarse:?} {fine:?}");
    }
    let largest = fine.rotations().iter().chain(fine.punches().iter().map(|own| &own.tilt));
    let largest = largest.fold(0.0, |largest: f64, own| largest.max(own.abs()));
    for (coarse, fine) in coarse.rotations().iter().zip(fine.rotations()) {
        assert!((coarse - fine).abs() < 0.01 * largest, "{number}: {coarse} {fine}");
    }
}

#[test]
fn places_between_punches_are_under_none_of_them() {
    let one = |punch: usize, ends: [f64; 2]| Expected { contact: 0, punch, ends };
    // the second punch touches in two intervals
    let all = [one(0, [0.0, 1.0]), one(1, [2.0, 3.0]), one(1, [4.0, 5.0]), one(2, [7.0, 8.0])];
    assert_eq!(between(&all), [1.5, 6.0]);
}
