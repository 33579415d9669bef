//! Wedges with two slopes, turned, pressed beside their tips or beside other punches.
//!
//! Goal: ends and pressures on a half-plane are as the closed form says; contacts move and are mirrored with the punches; what is even but for its place or
//! a rounding is what the solver for even contacts finds; everything that commands do goes through.
//!
//! Source of the closed form: ∫ f'(x)/√((x − l)(r − x)) dx = 0 and ∫ x f'(x)/√(...) dx = 2 P/E* between the ends l and r, of a slope that jumps.
use std::f64::consts::PI;

use recede::{
    Exponential, HalfPlane, Homogeneous, Model, Plane, Pressed, Punch, Punches, Scene, Solution, Stack, Tilt,
};

fn wedge(at: f64, slope: f64, force: f64, tilt: Tilt) -> Pressed {
    Pressed::new(Punch::wedge(slope).unwrap(), at, force, tilt).unwrap()
}

fn press(model: &Model, all: &[Pressed]) -> Solution {
    let punches = Punches::new(all).unwrap();
    let solution = model.press(&punches, punches.force()).unwrap();
    assert!(solution.warnings().iter().all(|warning| warning.code.is_about_theory()), "{:?}", solution.warnings());
    solution
}

fn stacks() -> Vec<Model> {
    let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    let graded = || Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
    let ground = || HalfPlane::new(0.6, 0.3).unwrap();
    let stack = || Stack::builder(Plane::Strain);
    [
        stack().layer(strip()).receding().layer(ground()),
        stack().layer(strip()).receding().layer(graded()).receding().rigid(),
    ]
    .map(|stack| Model::new(stack.build().unwrap()).unwrap())
    .into()
}

/// Between the ends l and r of a half-plane of the modulus E* under a wedge with slopes to the right and to the left of its tip at x = 0.
struct ClosedForm {
    left: f64,
    right: f64,
    modulus: f64,
    slopes: f64,
}

impl ClosedForm {
    fn new(modulus: f64, force: f64, [right, left]: [f64; 2]) -> Self {
        let slopes = right + left;
        let theta = PI * left / slopes;
        let half = 2.0 * force / (modulus * slopes * theta.sin());
        let middle = -half * theta.cos();
        Self { left: middle - half, right: middle + half, modulus, slopes }
    }

    fn pressure(&self, x: f64) -> f64 {
        let (middle, half) = (0.5 * (self.left + self.right), 0.5 * (self.right - self.left));
        let [s, tip] = [(x - middle) / half, -middle / half];
        self.modulus * self.slopes / (2.0 * PI) * ((1.0 - s * tip) / (s - tip).abs()).acosh()
    }
}

#[test]
fn wedges_on_a_half_plane_press_as_the_closed_form_says() {
    let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25).unwrap()).build().unwrap());
    let (model, modulus, force) = (model.unwrap(), 2.0 / 0.75, 0.01);
    for (slope, angle) in [(0.02, 0.005), (0.03, -0.02), (0.02, 0.019)] {
        let expected = ClosedForm::new(modulus, force, [slope + angle, slope - angle]);
        let turned = press(&model, &[wedge(0.0, slope, force, Tilt::Fixed(angle))]);
        let uneven = Punch::uneven_wedge(slope - angle, slope + angle).unwrap();
        let uneven = press(&model, &[Pressed::new(uneven, 0.0, force, Tilt::None).unwrap()]);
        // pressed where the pressures of the turned wedge act, it turns as far
        let eccentricity = turned.punches()[0].moment / force;
        let free = press(&model, &[wedge(0.0, slope, force, Tilt::Free { eccentricity })]);
        assert!((free.punches()[0].tilt - angle).abs() < 1e-11, "{} {angle}", free.punches()[0].tilt);
        for solution in [turned, uneven, free] {
            let contact = &solution.contacts()[0];
            let interval = contact.intervals()[0];
            let size = expected.right - expected.left;
            assert!((interval.left - expected.left).abs() < 1e-10 * size, "{interval:?} {}", expected.left);
            assert!((interval.right - expected.right).abs() < 1e-10 * size, "{interval:?} {}", expected.right);
            for part in [0.02, 0.3, 0.5, 0.9, 0.999] {
                let x = interval.left + part * size;
                let pressure = expected.pressure(x);
                assert!((contact.pressure(x) / pressure - 1.0).abs() < 1e-9, "{x}: {} {pressure}", contact.pressure(x));
            }
            let peak = contact.peak();
            assert!(peak.pressure.is_infinite() && peak.x == 0.0 && contact.central_pressure.is_infinite(), "{peak:?}");
        }
    }
}

#[test]
fn contacts_move_and_are_mirrored_with_wedges() {
    let cases = |sign: f64, by: f64| {
        let roller = Pressed::new(Punch::cylinder(30.0).unwrap(), sign * 2.5 + by, 0.004, Tilt::None).unwrap();
        [
            vec![wedge(by, 0.02, 0.01, Tilt::Fixed(sign * 0.004)), roller],
            vec![
                wedge(by, 0.03, 0.01, Tilt::Free { eccentricity: sign * 0.05 }),
                wedge(by - sign * 1.75, 0.01, 0.003, Tilt::None),
            ],
        ]
    };
    for model in &stacks() {
        let here = cases(1.0, 0.0).map(|case| press(model, &case));
        for (sign, by) in [(1.0, 3.75), (-1.0, 0.0)] {
            for (here, there) in here.iter().zip(cases(sign, by).map(|case| press(model, &case))) {
                for (contact, other) in here.contacts().iter().zip(there.contacts()) {
                    for interval in contact.intervals() {
                        let ends = [interval.left, interval.right].map(|x| sign * x + by);
                        let [left, right] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                        let is_there = |image: &recede::Interval| {
                            (image.left - left).abs() < 2e-10 && (image.right - right).abs() < 2e-10
                        };
                        assert!(other.intervals().iter().any(is_there), "{left} {right}: {:?}", other.intervals());
                        let x = interval.left + 0.3 * (interval.right - interval.left);
                        let [one, two] = [contact.pressure(x), other.pressure(sign * x + by)];
                        assert!((one / two - 1.0).abs() < 1e-9, "{x}: {one} {two}");
                    }
                }
            }
        }
    }
}

/// A wedge that turns onto its right face lets go of the layer below in between, and no spike at the tip hides that.
#[test]
fn a_wedge_that_turns_onto_a_face_touches_twice() {
    let stack = Stack::builder(Plane::Strain)
        .layer(Homogeneous::new(1.123, 7.609, 0.348).unwrap())
        .receding()
        .layer(Exponential::new(0.3052, 1.679, 0.228, 1.352).unwrap())
        .receding()
        .layer(HalfPlane::new(1.634, 0.248).unwrap());
    let model = Model::new(stack.build().unwrap()).unwrap();
    let pressed = |side: f64| {
        let (right, left) = if side > 0.0 { (0.03724, 0.02921) } else { (0.02921, 0.03724) };
        let shape = Punch::uneven_wedge(right, left).unwrap();
        let tilt = Tilt::Free { eccentricity: 0.167_942 * side };
        let punches = Punches::new(&[Pressed::new(shape, 1.2469 * side, 0.002_719_76, tilt).unwrap()]).unwrap();
        model.press(&punches, punches.force()).unwrap()
    };
    let [right, left] = [1.0, -1.0].map(pressed);
    for solution in [&right, &left] {
        assert!(solution.min_pressure() >= -1e-4 * 0.002_719_76, "{}", solution.min_pressure());
        assert_eq!(solution.contacts()[0].intervals().len(), 2, "{:?}", solution.contacts()[0].intervals());
    }
    for (right, left) in right.contacts().iter().zip(left.contacts()) {
        for (right, left) in right.intervals().iter().zip(left.intervals().iter().rev()) {
            let off = (right.left + left.right).abs().max((right.right + left.left).abs());
            assert!(off < right.left_error + right.right_error, "{right:?} {left:?}");
        }
    }
}

#[test]
fn what_is_even_but_for_rounding_is_what_another_solver_finds() {
    for model in &stacks() {
        let even = model.press(Punch::wedge(0.02).unwrap(), 0.01).unwrap();
        let uneven = press(model, &[wedge(0.0, 0.02, 0.01, Tilt::Free { eccentricity: 1e-12 })]);
        for (even, uneven) in even.contacts().iter().zip(uneven.contacts()) {
            let [a, b] = [even, uneven].map(|contact| contact.intervals()[0].right);
            assert!((a - b).abs() < 1e-9 * a, "{a} {b}");
            for part in [0.1, 0.5, 0.95] {
                let [one, two] = [even.pressure(part * a), uneven.pressure(part * a)];
                // away from the middle of a contact on a graded face the series is right to some 1e-7 of the largest pressure
                let known = if part > 0.2 { 5e-7 } else { 1e-8 } * even.pressure(0.1 * a);
                assert!((one - two).abs() < known, "{part}: {one} {two}");
            }
        }
        // stresses below the tip, from the closed forms of pressures
        let [one, two] = [&even, &uneven].map(|solution| model.field(solution).unwrap().at(0.01, 0.05).unwrap());
        assert!(
            (one.sigma_yy / two.sigma_yy - 1.0).abs() < 1e-8 && (one.v / two.v - 1.0).abs() < 1e-8,
            "{one:?} {two:?}"
        );
    }
}

/// Contacts are found about the middle of all punches, and moved from there: a rounding of that place is no distance from the tip.
#[test]
fn under_a_tip_at_the_origin_the_pressure_is_infinite() {
    for model in &stacks() {
        for at in [0.31, 0.713, 0.157, 2.9, 17.3] {
            let solution = press(model, &[wedge(0.0, 0.2, 1e-3, Tilt::None), wedge(at, 0.1, 1e-3, Tilt::None)]);
            let contact = &solution.contacts()[0];
            assert!(contact.central_pressure.is_infinite(), "{at}: {}", contact.central_pressure);
            assert!(contact.pressure(1e-9 * at).is_finite());
        }
    }
}

#[test]
fn all_that_commands_do_with_wedges_goes_through() {
    let text = "Scene(geometry: PlaneStrain, punches: [(shape: Wedge(slope: 0.02, left: 0.03), at: -1.0, force: 0.004),
        (shape: Wedge(slope: 0.02), at: 1.0, force: 0.006, tilt: Free(eccentricity: 0.02))],
        stack: [Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Receding, Rigid])";
    let scene = Scene::from_ron(text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let (field, tips) = (model.field(&solution).unwrap(), [-1.0, 1.0]);
    for x in tips {
        assert!(solution.contacts()[0].pressure(x).is_infinite());
        let at = field.at(x, 0.0).unwrap();
        assert!(at.sigma_yy == f64::NEG_INFINITY && at.v.is_finite(), "{at:?}");
    }
    assert!(field.max_shear().unwrap().value.is_finite() && field.extremes().unwrap().layers.len() == 1);
    for approach in model.approaches(&scene.top, &solution) {
        let approach = approach.unwrap();
        assert!(approach.value > 0.0 && approach.error < 1e-7 * approach.value, "{approach:?}");
    }
    let profile = model.profile(&scene.top, &solution, &[-3.0, -1.0, 0.0, 1.0, 3.0]).unwrap();
    let gap = profile.contacts[0].gap.as_ref().unwrap();
    assert!(gap[1] == 0.0 && gap[3] == 0.0 && gap[0] > 0.0 && gap[2] > 0.0 && gap[4] > 0.0, "{gap:?}");
}

/// A strip on soft springs touches about the tip of a wedge, and again farther out: in all intervals its face is as deep as the wedge.
#[test]
fn strips_on_springs_bend_round_wedges() {
    let stack = "[Homogeneous(thickness: 6.84, shear_modulus: 24, poisson: 0.3), Spring(normal: 4.8e-4),
        Homogeneous(thickness: 1.04, shear_modulus: 0.122, poisson: 0.07), Bonded, Rigid]";
    for (top, at, [right, left]) in [
        ("punch: Wedge(slope: 0.0048), force: 3.77", 0.0, [0.0048; 2]),
        ("punches: [(shape: Wedge(slope: 0.0048, left: 0.0047), at: 3, force: 3.77)]", 3.0, [0.0048, 0.0047]),
    ] {
        let scene = Scene::from_ron(&format!("(geometry: PlaneStress, {top}, stack: {stack})")).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press_with(&scene.top, scene.force, &Default::default()).unwrap();
        let field = model.field(&solution).unwrap();
        let intervals = solution.contacts()[0].intervals();
        assert_eq!(intervals.len(), 3, "{intervals:?}");
        let depth = |x: f64| field.at(x, 0.0).unwrap().v - if x > at { right * (x - at) } else { left * (at - x) };
        let under_tip = depth(at + 1e-3);
        for interval in intervals {
            for part in [0.1, 0.4, 0.9] {
                let x = interval.left + part * (interval.right - interval.left);
                let off = depth(x) / under_tip - 1.0;
                assert!(off.abs() < 1e-9, "{x} in {interval:?}: {off:e}");
            }
        }
    }
}
