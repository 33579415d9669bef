//! Flat punches with sharp corners that are pressed beside their middle, turned, or not alone.
//!
//! Goal: on a half-plane pressures and tilts are the known closed forms, also where one side of a punch lifts off; on stacks contacts move and
//! are mirrored with the punches, carry the force on its line of action, and where all is even are the contacts that the solver for even contacts finds; all that
//! commands do with such scenes goes through.
//!
//! Source of the closed forms: N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, 1953, sections 116 and 117; K. L. Johnson,
//! Contact Mechanics, 1985, section 2.8.
use std::f64::consts::PI;

use recede::selftest::{CheckedScene, Outcome};
use recede::{
    Exponential, HalfPlane, Homogeneous, Interval, Model, Options, Plane, Pressed, Punch, Punches, Scene, Solution,
    Stack, Tilt,
};

const HALF_WIDTH: f64 = 0.5;

fn flat(at: f64, force: f64, tilt: Tilt) -> Pressed {
    Pressed::new(Punch::flat(HALF_WIDTH).unwrap(), at, force, tilt).unwrap()
}

fn free(eccentricity: f64) -> Tilt {
    Tilt::Free { eccentricity }
}

fn press(model: &Model, all: &[Pressed]) -> Solution {
    let punches = Punches::new(all).unwrap();
    let solution = model.press(&punches, punches.force()).unwrap();
    assert!(solution.warnings().iter().all(|warning| warning.code.is_about_theory()), "{:?}", solution.warnings());
    solution
}

/// A half-plane with this modulus E*.
fn half_plane() -> (Model, f64) {
    let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(1.3, 0.3).unwrap()).build().unwrap();
    (Model::new(stack).unwrap(), 2.0 * 1.3 / 0.7)
}

fn stacks() -> Vec<Model> {
    let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    let ground = || HalfPlane::new(0.6, 0.3).unwrap();
    let graded = Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
    let stack = || Stack::builder(Plane::Strain);
    [
        stack().layer(strip()).receding().layer(ground()),
        stack().layer(strip()).receding().layer(Homogeneous::new(0.5, 3.0, 0.2).unwrap()).receding().rigid(),
        stack().layer(strip()).bonded().layer(graded).bonded().layer(strip()).receding().layer(ground()),
    ]
    .map(|stack| Model::new(stack.build().unwrap()).unwrap())
    .into()
}

fn near(found: f64, expected: f64, error: f64) {
    assert!((found - expected).abs() <= error, "{found} is not {expected}");
}

#[test]
fn a_force_beside_the_middle_turns_a_punch_and_lifts_its_other_side() {
    let (model, modulus) = half_plane();
    let (at, force) = (2.0, 0.01);
    for share in [-0.5, -0.2, 0.0, 0.1, 0.49] {
        let e = share * HALF_WIDTH;
        let solution = press(&model, &[flat(at, force, free(e))]);
        let contact = &solution.contacts()[0];
        let Interval { left, right, left_error, right_error, .. } = contact.intervals()[0];
        near(left, at - HALF_WIDTH, 1e-15);
        near(right, at + HALF_WIDTH, 1e-15);
        assert_eq!((left_error, right_error), (0.0, 0.0));
        for s in [-0.999, -0.3, 0.0, 0.6, 0.999f64] {
            let x = s * HALF_WIDTH;
            let expected =
                force * (1.0 + 2.0 * e * x / HALF_WIDTH.powi(2)) / (PI * (HALF_WIDTH.powi(2) - x * x).sqrt());
            near(contact.pressure(at + x), expected, 1e-11 * (1.0 + expected));
        }
        // a positive tilt lifts the right
        near(solution.punches()[0].tilt, -4.0 * force * e / (PI * modulus * HALF_WIDTH.powi(2)), 1e-13);
        near(solution.punches()[0].moment, force * e, 1e-14);
    }
    for share in [0.51, 0.7, 0.95, -0.8f64] {
        let solution = press(&model, &[flat(at, force, free(share * HALF_WIDTH))]);
        let contact = &solution.contacts()[0];
        let half = 2.0 * (1.0 - share.abs()) * HALF_WIDTH;
        let corner = share.signum() * HALF_WIDTH;
        let ends = [corner, corner - 2.0 * share.signum() * half];
        let interval = contact.intervals()[0];
        near(interval.left, at + ends[0].min(ends[1]), 1e-11);
        near(interval.right, at + ends[0].max(ends[1]), 1e-11);
        for s in [-0.9, 0.0, 0.8, 0.99f64] {
            let x = at + corner - share.signum() * half + share.signum() * half * s;
            let expected = force / (PI * half) * ((1.0 + s) / (1.0 - s)).sqrt();
            near(contact.pressure(x), expected, 1e-9 * expected);
        }
    }
}

#[test]
fn punches_turned_by_an_angle_carry_the_moment_that_turns_them_so_far() {
    let (model, modulus) = half_plane();
    let force = 0.01;
    for share in [-0.3, 0.2, 0.45] {
        let angle = -4.0 * force * share / (PI * modulus * HALF_WIDTH);
        let solution = press(&model, &[flat(0.0, force, Tilt::Fixed(angle))]);
        near(solution.punches()[0].moment, share * HALF_WIDTH * force, 1e-13);
    }
    // turned so far that one side lifts: as when the force alone turns it so far
    let lifted = press(&model, &[flat(0.0, force, free(0.35))]);
    let turned = press(&model, &[flat(0.0, force, Tilt::Fixed(lifted.punches()[0].tilt))]);
    near(turned.punches()[0].moment, 0.35 * force, 1e-11);
    near(turned.contacts()[0].intervals()[0].left, -0.1, 1e-9);
}

#[test]
fn two_level_punches_press_the_more_the_farther_out() {
    let (model, _) = half_plane();
    let (force, middle): (f64, f64) = (0.01, 0.8);
    let solution = press(&model, &[flat(-middle, force, Tilt::None), flat(middle, force, Tilt::None)]);
    let [inner, outer] = [middle - HALF_WIDTH, middle + HALF_WIDTH];
    for x in [0.31, 0.5, 1.0, 1.29f64] {
        let expected = 2.0 * force * x / (PI * ((x * x - inner * inner) * (outer * outer - x * x)).sqrt());
        for sign in [-1.0, 1.0] {
            near(solution.contacts()[0].pressure(sign * x), expected, 1e-10 * expected);
        }
    }
}

/// Two level punches on a < |x| < b with forces of their own: p = ±(A + Bx)/√((x² − a²)(b² − x²)), where ∫ x dx/√... over one of them is π/2, and ∫ dx/√... is K(√(1 − a²/b²))/b,
/// a complete elliptic integral: π/2 over the arithmetic-geometric mean of b and a.
#[test]
fn two_level_punches_share_their_forces_by_elliptic_integrals() {
    let (model, _) = half_plane();
    let [a, b] = [0.8 - HALF_WIDTH, 0.8 + HALF_WIDTH];
    let mean = (0..8).fold([b, a], |[b, a], _| [0.5 * (a + b), (a * b).sqrt()])[0];
    for [left, right] in [[0.01, 0.006], [0.006, 0.009f64]] {
        let solution = press(&model, &[flat(-0.8, left, Tilt::None), flat(0.8, right, Tilt::None)]);
        let (constant, slope) = ((right - left) * mean / PI, (right + left) / PI);
        for x in [0.31, 0.5, 1.0, 1.29f64] {
            for x in [x, -x] {
                let root = ((x * x - a * a) * (b * b - x * x)).sqrt();
                let expected = (constant + slope * x) * x.signum() / root;
                near(solution.contacts()[0].pressure(x), expected, 1e-10 * expected.abs());
            }
        }
    }
}

#[test]
fn contacts_move_and_are_mirrored_with_flat_punches() {
    let cases = |sign: f64, by: f64| {
        let roller = Pressed::new(Punch::cylinder(30.0).unwrap(), sign * 2.5 + by, 0.004, Tilt::None).unwrap();
        [
            vec![flat(by, 0.01, free(sign * 0.1)), roller],
            vec![flat(by, 0.01, free(-sign * 0.4))],
            vec![flat(by, 0.01, Tilt::Fixed(sign * 2e-3)), flat(by - sign * 1.75, 0.003, free(0.0))],
        ]
    };
    for model in &stacks() {
        let here = cases(1.0, 0.0).map(|case| press(model, &case));
        for (sign, by) in [(1.0, 3.75), (-1.0, 0.0)] {
            for (here, there) in here.iter().zip(cases(sign, by).map(|case| press(model, &case))) {
                for (contact, other) in here.contacts().iter().zip(there.contacts()) {
                    let mut images: Vec<[f64; 2]> = contact
                        .intervals()
                        .iter()
                        .map(|interval| [interval.left, interval.right].map(|x| sign * x + by))
                        .map(|[a, b]| [a.min(b), a.max(b)])
                        .collect();
                    images.sort_by(|a, b| a[0].total_cmp(&b[0]));
                    assert_eq!(images.len(), other.intervals().len());
                    for ([left, right], interval) in images.iter().zip(other.intervals()) {
                        near(interval.left, *left, 1e-9);
                        near(interval.right, *right, 1e-9);
                        let x = left + 0.3 * (right - left);
                        let expected = contact.pressure(sign * (x - by));
                        near(other.pressure(x), expected, 2e-9 * expected.abs());
                    }
                }
            }
        }
    }
}

#[test]
fn every_contact_carries_the_force_on_its_line_of_action() {
    for model in &stacks() {
        let solution = press(model, &[flat(0.25, 0.01, free(0.3)), flat(2.0, 0.005, free(-0.1))]);
        let line = (0.01 * 0.55 + 0.005 * 1.9) / 0.015;
        for contact in solution.contacts() {
            let sum: f64 = contact.intervals().iter().map(|interval| interval.force).sum();
            let moment: f64 = contact.intervals().iter().map(|interval| interval.force * interval.centroid).sum();
            near(sum, 0.015, 1e-13);
            near(moment / sum, line, 1e-11);
        }
    }
}

#[test]
fn where_all_is_even_contacts_are_those_of_a_punch_by_itself() {
    for model in &stacks() {
        let even = model.press(Punch::flat(HALF_WIDTH).unwrap(), 0.01).unwrap();
        let moved = press(model, &[flat(1.5, 0.01, free(0.0))]);
        near(moved.punches()[0].tilt, 0.0, 1e-13);
        for (even, moved) in even.contacts().iter().zip(moved.contacts()) {
            near(moved.intervals()[0].right - 1.5, even.intervals()[0].right, 1e-9);
            for x in [-0.49, -0.2, 0.0, 0.3] {
                near(moved.pressure(1.5 + x), even.pressure(x), 1e-9 * even.pressure(x));
            }
        }
    }
}

/// Next to a graded face the terms of a singular pressure fall slowly; what is claimed holds.
#[test]
fn a_flat_punch_on_a_graded_face_is_even_without_symmetry() {
    let graded = Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
    let stack = Stack::builder(Plane::Strain).layer(graded).receding().layer(HalfPlane::new(0.6, 0.3).unwrap());
    let model = Model::new(stack.build().unwrap()).unwrap();
    let even = model.press(Punch::flat(HALF_WIDTH).unwrap(), 0.01).unwrap();
    let punches = Punches::new(&[flat(0.0, 0.01, free(1e-12))]).unwrap();
    let uneven = model.press(punches, 0.01).unwrap();
    for (even, uneven) in even.contacts().iter().zip(uneven.contacts()) {
        let claimed = even.central_pressure_error + uneven.central_pressure_error;
        near(uneven.central_pressure, even.central_pressure, claimed);
        assert!(claimed < 1e-8 * even.central_pressure, "{claimed:e}");
        near(uneven.intervals()[0].right, even.intervals()[0].right, 1e-10);
    }
}

#[test]
fn below_a_punch_there_is_a_gap_where_it_lifts_off_and_none_where_it_touches() {
    let (model, _) = half_plane();
    for at in [0.0, 0.06609717089569071, -3.3] {
        for share in [0.2, 0.83] {
            let punches = Punches::new(&[flat(at, 0.01, free(share * HALF_WIDTH))]).unwrap();
            let solution = model.press(&punches, 0.01).unwrap();
            let x: Vec<f64> = (-19..=19).map(|k| at + 0.05 * HALF_WIDTH * f64::from(k)).collect();
            let profile = model.profile(&punches, &solution, &x).unwrap();
            let gap = profile.contacts[0].gap.as_ref().unwrap();
            let left = solution.contacts()[0].intervals()[0].left;
            for (x, gap) in x.iter().zip(gap) {
                assert!(if *x < left { *gap > 0.0 } else { *gap == 0.0 }, "{at} {share}: {gap} at {x}");
            }
        }
    }
}

/// Reports, fields next to the corners, profiles and pictures.
#[test]
fn all_that_commands_do_with_flat_punches_goes_through() {
    for punches in [
        "(shape: Flat(half_width: 0.5), at: 1, force: 0.01, tilt: Free(eccentricity: 0.1))",
        "(shape: Flat(half_width: 0.5), at: 0, force: 0.01, tilt: Free(eccentricity: -0.35))",
        "(shape: Flat(half_width: 0.5), at: 0, force: 0.01), (shape: Parabola(radius: 40), at: 2.5, force: 0.004)",
    ] {
        for stack in [
            "[HalfPlane(shear_modulus: 1, poisson: 0.25)]",
            "[Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, HalfPlane(shear_modulus: 0.5, poisson: 0.3)]",
            "[Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Bonded, Rigid]",
        ] {
            let text = format!("Scene(geometry: PlaneStrain, punches: [{punches}], stack: {stack})");
            let checked = CheckedScene::run(&Scene::from_ron(&text).unwrap(), &Options::default(), true);
            assert!(matches!(checked.outcome, Outcome::Solved(_)), "{text}: {:?}", checked.outcome);
        }
    }
}
