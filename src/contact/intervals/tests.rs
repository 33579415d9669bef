//! Intervals against the answers of one interval about the middle, and columns against integrals over pressures.
use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;
use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

use super::columns::Columns;
use super::equations::{Equations, Solved};
use super::kept::Kept;
use super::newton::converge;
use super::pressure::{Pressure, Tip};
use super::support::{ContactInterval, Intervals, Parity};
use super::{Refused, of_formulas, refine, solve};
use crate::contact::integrals::layout::{Layout, Lengths};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, MOST_OPERATIONS};
use crate::contact::problem::iteration::Work;
use crate::contact::problem::twin::Twin;
use crate::contact::starts::formulas;
use crate::geometry::Geometry;
use crate::kernel::Kernel;
use crate::numeric::longest;
use crate::numeric::quadrature::rule;
use crate::scene::{Force, Load, Punch, Top};
use crate::selftest::{Ranges, about_axis, scene};
use crate::solution::Contact;
use crate::stack::{Stack, StackBuilder};
use crate::{Model, Options};

/// Contacts of one interval, from half-lengths that are a third too long or too short, are what the solver for one interval finds.
#[test]
fn one_interval_is_what_another_solver_finds() {
    let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    let graded = || Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
    let stacks = [Geometry::PlaneStrain, Geometry::Axisymmetric].into_iter().flat_map(|geometry| {
        let stack = || Stack::builder(geometry);
        [
            stack().layer(strip()).receding().layer(HalfPlane::new(0.5, 0.3).unwrap()),
            stack().layer(strip()).receding().layer(graded()).receding().rigid(),
        ]
    });
    for stack in stacks {
        let stack = stack.build().unwrap();
        let (kernel, interfaces) = (Kernel::new(&stack).unwrap(), stack.contacts());
        let options = Options { tolerance: 1e-8 };
        for top in [
            Top::from(Punch::parabola(30.0).unwrap()),
            Top::from(Punch::cylinder(30.0).unwrap()),
            Top::from(Punch::flat(0.4).unwrap()),
            Top::from(Load::uniform(0.3).unwrap()),
        ] {
            let expected = Model::new(stack.clone()).unwrap().press_with(&top, 0.01, &options).unwrap();
            let problem = Problem::new(&kernel, &interfaces, (&top, &[], None), 0.01, options.tolerance);
            for factor in [0.7, 1.4] {
                let half = |contact: &Contact| contact.half_length().unwrap() / kernel.length();
                let start = |contact: usize| {
                    let is_flat = problem.sides[contact].is_flat();
                    let factor = if is_flat { 1.0 } else { factor };
                    let ends = [0.0, factor * half(&expected.contacts[contact])];
                    ContactInterval::even(problem.twin(), contact, ends).with_corners([is_flat; 2])
                };
                let support = Intervals(problem.unknown().map(start).collect());
                let counts = vec![20; support.0.len()];
                let mut work = Work::at_most(MOST_OPERATIONS);
                let first = converge(&problem, support, None, &counts, COARSE, &mut work).unwrap();
                let found = refine(&problem, first, false, &mut work).unwrap().into_solution(&problem, 0.01, None);
                for (found, expected) in found.contacts.iter().zip(&expected.contacts) {
                    let off = found.half_length().unwrap() - expected.half_length().unwrap();
                    let claimed = found.innermost().right_error + expected.innermost().right_error;
                    assert!(off.abs() <= claimed, "{top:?} {factor}: {off:e} {claimed:e} of {found:?}");
                    assert!(claimed < 1e-6, "{top:?} {factor}: {claimed:e}");
                    for part in [0.0, 0.3, 0.9] {
                        let x = part * expected.half_length().unwrap();
                        let off = (found.pressure(x) - expected.pressure(x)) / expected.central_pressure;
                        assert!(off.abs() < 1e-6, "{top:?} {factor} at {part}: {off:e}");
                    }
                }
            }
        }
    }
}

/// Random scenes are solved the same from formulas, in the plane as even ones or as if nothing were even, and about an axis: their ends are as far out as another solver says, on
/// both sides.
#[test]
fn random_scenes_are_solved_alike_without_symmetry() {
    let (mut compared, mut left) = (0, 0);
    let drawn = (0..24).map(|number| (number, scene(&Ranges::default(), 12, number).scene()));
    let scenes = drawn.filter_map(|(number, scene)| Some((number, scene.ok()?)));
    for (number, scene) in scenes.flat_map(|(number, scene)| [(number, scene.clone()), (number, about_axis(scene))]) {
        let Ok(stack) = scene.stack() else { continue };
        let Force::Given(force) = scene.force else { continue };
        let top = scene.top;
        let options = Options { tolerance: 1e-8 };
        let expected = Model::new(stack.clone()).unwrap().press_with(&top, force, &options);
        let Ok(expected) = expected else { continue };
        let is_one = |contact: &Contact| contact.half_length().is_some();
        if !expected.warnings.is_empty() || !expected.contacts.iter().all(is_one) {
            continue;
        }
        let kernel = Kernel::new(&stack).unwrap();
        let interfaces = stack.contacts();
        let problem = Problem::new(&kernel, &interfaces, (&top, &[], None), force, options.tolerance);
        let even = of_formulas(&problem, &formulas::anywhere(&problem)).unwrap();
        let whole = |interval: &ContactInterval| {
            ContactInterval::anywhere(interval.contact, 0, [-interval.half, interval.half])
        };
        let uneven = Intervals(even.0.iter().map(whole).collect());
        let starts = if problem.twin() == Twin::Round { vec![even] } else { vec![even, uneven] };
        for start in starts {
            let Some(found) = solve(&problem, start, &mut Refused::default(), &mut Work::at_most(MOST_OPERATIONS))
            else {
                left += 1;
                continue;
            };
            compared += 1;
            for (found, expected) in found.contacts.iter().zip(&expected.contacts) {
                let (found, expected) = (found.innermost(), expected.innermost());
                let half = expected.right / kernel.length();
                let claimed = found.right_error + found.left_error + expected.right_error / kernel.length();
                let off = (found.right - half).abs().max((found.left + half).abs());
                assert!(off <= 1.5 * claimed, "{number}: {off:e} {claimed:e} of {half}");
            }
        }
    }
    assert!(compared >= 50 && left * 10 <= compared, "{compared} compared, {left} not solved");
}

/// A thin layer between two contacts makes intensities at the ends of both depend on each other strongly: Newton's method takes it to the ends that another solver finds.
#[test]
fn contacts_on_both_faces_of_a_thin_layer_are_found_from_formulas() {
    let layer = |thickness, modulus, poisson| Homogeneous::new(thickness, modulus, poisson).unwrap();
    let stack = Stack::builder(Plane::Stress)
        .layer(layer(0.58, 0.052, 0.25))
        .bonded()
        .layer(layer(0.27, 0.107, -0.45))
        .receding()
        .layer(layer(0.0316, 0.0372, -0.155))
        .receding()
        .layer(HalfPlane::new(0.98, -0.068).unwrap());
    let stack = stack.build().unwrap();
    let (top, force) = (Top::from(Punch::parabola(0.44).unwrap()), 3e-4);
    let expected = Model::new(stack.clone()).unwrap().press(&top, force).unwrap();
    let (kernel, interfaces) = (Kernel::new(&stack).unwrap(), stack.contacts());
    let problem = Problem::new(&kernel, &interfaces, (&top, &[], None), force, Options::default().tolerance);
    let start = of_formulas(&problem, &formulas::anywhere(&problem)).unwrap();
    let found = solve(&problem, start, &mut Refused::default(), &mut Work::at_most(MOST_OPERATIONS)).unwrap();
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    for (found, expected) in found.contacts.iter().zip(&expected.contacts) {
        let (found, expected) = (found.innermost(), expected.innermost());
        let half = expected.right / kernel.length();
        assert!((found.right / half - 1.0).abs() < 1e-9, "{} {half}", found.right);
    }
}

/// Pressures that solve the equations miss nothing in sums that are made without their matrix, and kept equations correct pressures between ends that have
/// moved by a ten-thousandth to the square of that.
#[test]
fn kept_equations_correct_pressures() {
    let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    let graded = || Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
    let stack = |builder: StackBuilder| {
        let stack = builder.layer(strip()).receding().layer(graded()).receding();
        stack.layer(HalfPlane::new(0.5, 0.3).unwrap()).build().unwrap()
    };
    let stacks = [Geometry::PlaneStrain, Geometry::Axisymmetric].map(|geometry| stack(Stack::builder(geometry)));
    let top = Top::from(Punch::parabola(30.0).unwrap());
    let anywhere = |contact: usize, ends: [f64; 2]| ContactInterval::anywhere(contact, 0, ends);
    let about_zero = |twin: Twin| {
        let ends = [[0.0, 0.5], [0.0, 1.6], [0.0, 2.1]].into_iter().enumerate();
        ends.map(|(k, ends)| ContactInterval::even(twin, k, ends)).collect()
    };
    let lists: [Vec<ContactInterval>; 4] = [
        about_zero(Twin::Plane),
        about_zero(Twin::Round),
        vec![
            ContactInterval::even(Twin::Plane, 0, [0.0, 0.5]),
            ContactInterval::even(Twin::Plane, 1, [0.3, 1.6]),
            ContactInterval::even(Twin::Plane, 2, [0.0, 2.1]),
        ],
        vec![anywhere(0, [-0.4, 0.6]), anywhere(1, [-1.5, 1.7]), anywhere(2, [-2.2, -0.3]), anywhere(2, [0.1, 2.0])],
    ];
    for list in lists {
        let (before, counts) = (Intervals(list), [9; 4]);
        let counts = &counts[..before.0.len()];
        let stack = &stacks[usize::from(before.0[0].twin == Twin::Round)];
        let (kernel, interfaces) = (Kernel::new(stack).unwrap(), stack.contacts());
        let problem = Problem::new(&kernel, &interfaces, (&top, &[], None), 0.01, 1e-10);
        let lengths = Lengths::of(&problem, &before, counts, 1e-13);
        let layout = Layout::new(&kernel, &lengths, 1e-13, 0.0).unwrap();
        let equations = Equations::new(&problem, &layout, &before, counts);
        let (kept, solved) = Kept::new(&equations, &before, counts).unwrap();
        let (_, change) = kept.corrected(&equations, &solved, counts).unwrap();
        assert!(change < 1e-11, "{before:?}: {change:e}");
        let after = before.moved(&vec![1e-4; before.ends().len()]);
        let equations = Equations::new(&problem, &layout, &after, counts);
        let (corrected, _) = kept.corrected(&equations, &solved.on(&before, &after), counts).unwrap();
        let (_, expected) = Kept::new(&equations, &after, counts).unwrap();
        let terms = |solved: &Solved| solved.pressures.iter().flat_map(|own| own.terms.clone()).collect::<Vec<f64>>();
        let expected = terms(&expected);
        let off = terms(&corrected).iter().zip(&expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(off < 2e-6 * longest(expected), "{before:?}: {off:e}");
    }
}

/// Columns with any amplitudes are the transform of the pressure that these are, by a rule that knows nothing of Bessel functions.
#[test]
fn columns_are_transforms_of_pressures() {
    for intervals in [
        vec![ContactInterval::even(Twin::Plane, 0, [0.0, 0.8]), ContactInterval::even(Twin::Plane, 0, [1.3, 2.9])],
        vec![ContactInterval::even(Twin::Plane, 0, [0.4, 0.9]), ContactInterval::even(Twin::Plane, 0, [1.0, 1.1])],
        vec![ContactInterval::anywhere(0, 0, [-1.7, -0.4])],
        vec![ContactInterval::even(Twin::Round, 0, [0.0, 0.8])],
        vec![
            ContactInterval::anywhere(0, 0, [-0.3, 0.9]),
            ContactInterval::anywhere(0, 0, [1.0, 1.1]),
            ContactInterval::anywhere(0, 1, [2.0, 3.1]),
        ],
    ] {
        // long waves have no part of the last terms
        let counts = vec![40; intervals.len()];
        let columns = Columns::new(&intervals, &counts, intervals[0].parity == Parity::None);
        let zeta = [1e-4, 0.3, 2.0, 9.0];
        let mut waves = columns.waves(&zeta, &Arc::default());
        let long = columns.long_waves(&zeta, &Arc::default());
        for (number, column) in long.places.iter().enumerate() {
            let sums = waves.column_mut(*column).iter_mut().zip(long.values.column(number));
            sums.for_each(|(sum, value)| *sum += value);
        }
        let amplitudes: Vec<f64> =
            (0..columns.terms() + columns.ends()).map(|c| (1.3 * c as f64 + 0.4).sin()).collect();
        let mut own = amplitudes.clone();
        columns.as_they_are(&mut own);
        let (terms, singular) = own.split_at(columns.terms());
        let pressures = columns.pressures(terms, singular);
        let transform = |zeta: f64, wave: fn(f64) -> f64| -> f64 {
            let of = |(interval, pressure): (&ContactInterval, &Pressure)| {
                let strip = pressure.strip(interval);
                let place = |(phi, weight): (f64, f64)| {
                    let x = interval.place(phi);
                    let wave = match interval.twin {
                        Twin::Plane => wave(zeta * x),
                        // ∫ p J₀(ζr) r dr on both sides of the axis
                        Twin::Round => 0.5 * x.abs() * libm::j0(zeta * x),
                    };
                    weight * strip.pressure(x) * interval.half * phi.sin() * wave
                };
                let halves = [[0.0, 0.5 * PI], [0.5 * PI, PI]];
                let places = halves.into_iter().flat_map(|[from, to]| rule(64).on(from, to));
                interval.images() * places.map(place).sum::<f64>()
            };
            intervals.iter().zip(&pressures).map(of).sum()
        };
        for (k, wavenumber) in zeta.iter().enumerate() {
            for part in 0..columns.parts() {
                let expected = wavenumber * transform(*wavenumber, if part == 0 { f64::cos } else { f64::sin });
                let row = part * zeta.len() + k;
                let found: f64 =
                    amplitudes.iter().enumerate().map(|(c, amplitude)| amplitude * waves.column(c)[row]).sum();
                assert!((found - expected).abs() < 1e-11 * wavenumber, "{part} at {wavenumber}: {found} {expected}");
            }
        }
    }
}

/// No column but the first ones of a group has a resultant, or a moment where nothing is even, and long waves keep their digits.
#[test]
fn long_waves_are_felt_through_resultants_and_moments() {
    let intervals = [ContactInterval::anywhere(0, 0, [-0.3, 0.9]), ContactInterval::anywhere(0, 0, [1.0, 1.1])];
    let columns = Columns::new(&intervals, &[6, 4], intervals[0].parity == Parity::None);
    let zeta = [1e-5, 2e-5];
    let waves = columns.waves(&zeta, &Arc::default());
    let carried = columns.carried.len();
    for column in 0..carried {
        // the square of the wavenumber, or the cube, is the first power left of the transform
        for (part, power) in [(0, 3), (1, 4)] {
            let [one, two] = [0, 1].map(|k| waves.column(column)[2 * part + k]);
            let ratio = two / one / 2f64.powi(power);
            assert!(
                one == 0.0 || (ratio - 1.0).abs() < 1e-6 || one.abs() < 1e-3 * zeta[0].powi(power),
                "{column}: {ratio}"
            );
        }
    }
}

/// Beside an interval the terms of a sharp tip have closed forms, all together.
#[test]
fn terms_of_a_tip_are_summed_beside_its_interval() {
    let interval = ContactInterval::anywhere(0, 0, [-0.3, 0.9]);
    for at in [-0.9, 0.0, 0.3] {
        let tip = Tip { strength: 0.7, at };
        let terms: Vec<f64> = (0..1000).map(|m| tip.term(&interval, m)).collect();
        let [whole, series] = [(vec![], tip), (terms.clone(), Tip::default())].map(|(terms, tip)| Pressure {
            terms,
            tip,
            ..Pressure::default()
        });
        let columns = Columns::new(std::slice::from_ref(&interval), &[1000], true);
        for x in [-3.0, -0.31, 0.92, 7.0] {
            let s = (x - interval.middle) / interval.half;
            let z = Complex64::from((s.abs() + (s * s - 1.0).sqrt()).recip().copysign(s));
            let parts = terms.iter().enumerate().map(|(m, y)| y / interval.order(m) as f64 * z.powu(m as u32 + 1));
            let (found, expected) = (tip.slope(z), parts.sum::<Complex64>());
            assert!((found - expected).norm() < 1e-14, "{at} {x}: {found} {expected}");
            let [found, expected] = [&whole, &series].map(|own| columns.closed(x, std::slice::from_ref(own)));
            assert!((found - expected).abs() < 1e-14 * expected.abs().max(1.0), "{at} {x}: {found} {expected}");
        }
    }
}
