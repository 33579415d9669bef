//! Prescribed tractions in place of a punch.
//!
//! Goal: under a line load a loose strip has the contacts of the literature, whatever the force; wider loads come from and go
//! to what they must; fields are those of the prescribed traction.
//!
//! Source of the numbers: `crate::closed_forms::line_load`.
use crate::support;

use crate::closed_forms::line_load;
use crate::support::outwards;
use recede::{
    Exponential, HalfPlane, Homogeneous, Interval, Load, Loads, Model, Plane, Punch, Scene, Solution, Stack,
    StackBuilder, Top,
};

fn strip() -> StackBuilder {
    Stack::builder(Plane::Strain).layer(Homogeneous::new(2.0, 1.0, 0.25).unwrap()).receding()
}

fn ground(modulus: f64) -> HalfPlane {
    HalfPlane::new(modulus, 0.25).unwrap()
}

fn press(stack: StackBuilder, load: impl Into<Top>, force: f64) -> (Model, Solution) {
    let model = Model::new(stack.build().unwrap()).unwrap();
    let solution = model.press(load, force).unwrap();
    assert!(solution.warnings().iter().all(|warning| warning.code.is_about_theory()), "{:?}", solution.warnings());
    (model, solution)
}

fn receding(stack: StackBuilder, load: impl Into<Top>, force: f64) -> f64 {
    let (_, solution) = press(stack, load, force);
    let contact = &solution.contacts()[1];
    assert!(contact.half_length_error().unwrap() < 1e-10 * contact.half_length().unwrap(), "{contact:?}");
    assert!((contact.resultant / force - 1.0).abs() < 1e-12);
    contact.half_length().unwrap()
}

fn close(found: f64, expected: f64, error: f64) {
    assert!((found / expected - 1.0).abs() <= error, "{found} is not {expected}");
}

#[test]
fn under_a_line_load_a_strip_has_the_contacts_of_the_literature() {
    for force in [1e-9, 0.002, 1e6] {
        close(receding(strip().rigid(), Load::Line, force), 2.0 * line_load::RIGID_BASE, 1e-10);
        close(receding(strip().layer(ground(1.0)), Load::Line, force), 2.0 * line_load::EQUAL_MODULI, 1e-10);
        close(
            receding(strip().layer(ground(0.25)), Load::Line, force),
            2.0 * line_load::STRIP_FOUR_TIMES_STIFFER,
            1e-10,
        );
    }
}

#[test]
fn narrow_loads_are_line_loads() {
    let graded = || {
        let layer = Exponential::new(1.0, 1.0, 0.3, -1.5).unwrap();
        Stack::builder(Plane::Strain).layer(layer).receding().layer(ground(0.7))
    };
    let line = receding(graded(), Load::Line, 1.0);
    for load in [Load::uniform(1e-5), Load::parabolic(1e-5), Load::elliptic(1e-5)] {
        close(receding(graded(), load.unwrap(), 1.0), line, 1e-8);
    }
    // a wider load, a longer contact, by the square of its width to begin with
    let longer = |width: f64| receding(graded(), Load::uniform(width).unwrap(), 1.0) - line;
    close(longer(0.02) / longer(0.01), 4.0, 1e-2);
    assert!(longer(3.0) > longer(1.0) && longer(1.0) > 0.0);
}

#[test]
fn a_punch_pressed_ever_more_lightly_is_a_line_load() {
    let model = Model::new(strip().layer(ground(1.0)).build().unwrap()).unwrap();
    let line = 2.0 * line_load::EQUAL_MODULI;
    let solution = model.press(Punch::parabola(1.0).unwrap(), 1e-9).unwrap();
    close(solution.contacts()[1].half_length().unwrap(), line, 1e-8);
}

#[test]
fn fields_are_those_of_the_given_pressure() {
    let loads = [Load::uniform(0.8).unwrap(), Load::parabolic(0.8).unwrap(), Load::elliptic(0.8).unwrap()];
    for load in loads {
        let (model, solution) = press(strip().layer(ground(0.5)), load.clone(), 0.01);
        let top = &solution.contacts()[0];
        assert_eq!((top.half_length().unwrap(), top.half_length_error().unwrap()), (0.8, 0.0));
        let over_mean = match load {
            Load::Uniform { .. } => 1.0,
            Load::Parabolic { .. } => 1.5,
            _ => 4.0 / std::f64::consts::PI,
        };
        close(top.central_pressure, over_mean * 0.01 / 1.6, 1e-15);
        let shape = |s: f64| match load {
            Load::Uniform { .. } => 1.0,
            Load::Parabolic { .. } => 1.0 - s * s,
            _ => (1.0 - s * s).sqrt(),
        };
        let field = model.field(&solution).unwrap();
        for s in [0.0, 0.3, 0.7, 0.9] {
            let expected = top.central_pressure * shape(s);
            close(top.pressure(0.8 * s), expected, 1e-14);
            close(-field.at(0.8 * s, 0.0).unwrap().sigma_yy, expected, 1e-9);
        }
        // at the bottom of the strip, the other contact
        let below = solution.contacts()[1].central_pressure;
        close(-field.at_layer(0.0, 2.0, 1).unwrap().sigma_yy, below, 1e-8);
    }
    // far from a line load the field is that of a narrow one
    let (model, solution) = press(strip().layer(ground(0.5)), Load::Line, 0.01);
    let (other, narrow) = press(strip().layer(ground(0.5)), Load::elliptic(1e-5).unwrap(), 0.01);
    let [found, expected] =
        [model.field(&solution).unwrap(), other.field(&narrow).unwrap()].map(|field| field.at(0.4, 1.0).unwrap());
    close(found.sigma_yy, expected.sigma_yy, 1e-6);
    close(found.sigma_xx, expected.sigma_xx, 1e-6);
}

/// A uniform load as a number of narrower ones next to each other.
fn slices(half_width: f64, count: usize) -> Loads {
    let width = half_width / count as f64;
    let slice = |k: usize| ((k as f64 + 0.5) * width, 1.0, Load::uniform(0.5 * width).unwrap());
    crate::support::mirrored(&(0..count).map(slice).collect::<Vec<_>>()).unwrap()
}

/// Two stacks with a receding contact, one of them next to a graded face, and one without.
fn stacks() -> [StackBuilder; 3] {
    let layer = Exponential::new(1.0, 1.0, 0.3, -1.5).unwrap();
    [
        strip().layer(ground(0.5)),
        Stack::builder(Plane::Strain).layer(layer).receding().layer(ground(0.7)),
        Stack::builder(Plane::Strain).layer(layer).bonded().layer(ground(3.0)),
    ]
}

/// Contacts, fields inside and on the face.
fn assert_same(stack: StackBuilder, found: impl Into<Loads>, expected: Load, error: f64) {
    let found = found.into();
    let shifted = (found.reach() / expected.half_width() - 1.0).abs();
    let (found, expected) = (press(stack.clone(), found, 0.01), press(stack, expected, 0.01));
    for (found, expected) in found.1.contacts().iter().zip(expected.1.contacts()) {
        close(found.reach(), expected.reach(), error.max(shifted));
        close(found.central_pressure, expected.central_pressure, error);
        close(found.resultant, expected.resultant, error);
        for s in [0.13, 0.52, 0.93] {
            let x = s * expected.reach();
            assert!((found.pressure(x) - expected.pressure(x)).abs() < 10.0 * error * expected.central_pressure);
        }
    }
    let peak = expected.1.contacts()[0].central_pressure;
    let [found, expected] = [&found, &expected].map(|(model, solution)| model.field(solution).unwrap());
    for (x, depth) in [(0.0, 0.0), (0.31, 0.0), (0.0, 0.4), (0.5, 0.2), (0.3, 1.5), (2.0, 3.0)] {
        let (found, expected) = (found.at(x, depth).unwrap(), expected.at(x, depth).unwrap());
        let numbers = |p: &recede::FieldPoint| [p.sigma_xx, p.sigma_yy, p.sigma_xy, p.u, p.v];
        for (found, expected) in numbers(&found).into_iter().zip(numbers(&expected)) {
            let error = 1e-9f64.max(10.0 * error) * peak;
            assert!((found - expected).abs() < error, "({x}, {depth}): {found} {expected} {error}");
        }
    }
}

#[test]
fn several_loads_at_one_place_are_one() {
    for stack in stacks() {
        let elliptic = |a| Load::elliptic(a).unwrap();
        let halves = crate::support::mirrored(&[(0.0, 2.0, elliptic(0.7)), (0.0, 1.0, elliptic(0.7))]).unwrap();
        assert_same(stack.clone(), halves, elliptic(0.7), 1e-13);
        // and of a pair whose distance vanishes nothing but the square of the distance is left
        let pair = |at| crate::support::mirrored(&[(at, 1.0, elliptic(0.7))]).unwrap();
        assert_same(stack.clone(), pair(1e-7), elliptic(0.7), 1e-12);
    }
}

#[test]
fn slices_of_a_uniform_load_are_that_load() {
    for stack in stacks() {
        for count in [1, 3, 20] {
            assert_same(stack.clone(), slices(0.6, count), Load::uniform(0.6).unwrap(), 1e-12);
        }
    }
}

#[test]
fn many_lines_come_to_a_uniform_load() {
    let lines = |count: usize| {
        let line = |k: usize| ((k as f64 + 0.5) * 0.6 / count as f64, 1.0, Load::Line);
        crate::support::mirrored(&(0..count).map(line).collect::<Vec<_>>()).unwrap()
    };
    for stack in stacks().into_iter().take(2) {
        let expected = receding(stack.clone(), Load::uniform(0.6).unwrap(), 1.0);
        let error = |count| receding(stack.clone(), lines(count), 1.0) / expected - 1.0;
        let (few, many) = (error(8), error(32));
        assert!(many.abs() < 1e-4 && (few / many - 16.0).abs() < 0.3, "{few} {many}");
    }
}

#[test]
fn the_pressure_of_a_punch_in_slices_makes_the_contact_of_the_punch() {
    let model = Model::new(strip().layer(ground(0.5)).build().unwrap()).unwrap();
    let punch = model.press(Punch::parabola(100.0).unwrap(), 0.05).unwrap();
    let [top, below] = punch.contacts() else { panic!("two contacts") };
    let sliced = |count: usize| {
        let width = top.half_length().unwrap() / count as f64;
        let slice = |k: usize| {
            let x = (k as f64 + 0.5) * width;
            (x, top.pressure(x), Load::uniform(0.5 * width).unwrap())
        };
        let load = crate::support::mirrored(&(0..count).map(slice).collect::<Vec<_>>()).unwrap();
        model.press(load, 0.05).unwrap().contacts()[1].half_length().unwrap()
    };
    close(sliced(400), below.half_length().unwrap(), 1e-5);
    assert!(
        (sliced(400) - below.half_length().unwrap()).abs() < 0.4 * (sliced(200) - below.half_length().unwrap()).abs()
    );
}

#[test]
fn fields_of_several_loads_are_sums() {
    let [.., bonded] = stacks();
    let parts = [
        (0.5, 1.0, Load::uniform(0.2).unwrap()),
        (0.0, 2.0, Load::parabolic(0.4).unwrap()),
        (0.3, 0.5, Load::elliptic(0.1).unwrap()),
    ];
    let model = Model::new(bonded.build().unwrap()).unwrap();
    let solve = |load: Loads, force| model.press(load, force).unwrap();
    let all = solve(crate::support::mirrored(&parts).unwrap(), 0.07);
    let each = parts.map(|part| solve(crate::support::mirrored(std::slice::from_ref(&part)).unwrap(), 0.02 * part.1));
    close(all.contacts()[0].central_pressure, 0.04 * 0.75 / 0.4, 1e-14);
    assert_eq!((all.contacts()[0].half_length().unwrap(), all.contacts()[0].resultant), (0.7, 0.07));
    for x in [0.0, 0.25, 0.35, 0.6, 0.71] {
        let sum: f64 = each.iter().map(|solution| solution.contacts()[0].pressure(x)).sum();
        assert!((all.contacts()[0].pressure(x) - sum).abs() < 1e-15);
        for depth in [0.0, 0.1, 0.9, 1.4] {
            let found = model.field(&all).unwrap().at(x, depth).unwrap();
            let parts = each.iter().map(|solution| model.field(solution).unwrap().at(x, depth).unwrap());
            let sum = parts.fold([0.0; 3], |sum, p| [sum[0] + p.sigma_xx, sum[1] + p.sigma_yy, sum[2] + p.u]);
            for (found, sum) in [found.sigma_xx, found.sigma_yy, found.u].into_iter().zip(sum) {
                assert!((found - sum).abs() < 1e-10, "({x}, {depth}): {found} {sum}");
            }
        }
    }
}

#[test]
fn two_lines_on_a_half_plane_are_those_of_flamant() {
    let at = 0.8;
    let pair = crate::support::mirrored(&[(at, 1.0, Load::Line)]).unwrap();
    let (model, solution) = press(Stack::builder(Plane::Strain).layer(ground(1.0)), pair, 3.0);
    assert_eq!((solution.contacts()[0].reach(), solution.contacts()[0].central_pressure), (at, 0.0));
    assert_eq!(solution.contacts()[0].pressure(at), f64::INFINITY);
    for (x, d) in [(0.0, 0.5), (0.8, 0.1), (1.3, 0.7), (-4.0, 2.0)] {
        let line = |x: f64| -2.0 * 1.5 / std::f64::consts::PI * d / (x * x + d * d).powi(2);
        let point = model.field(&solution).unwrap().at(x, d).unwrap();
        let sum = |of: &dyn Fn(f64) -> f64| of(x - at) + of(x + at);
        for (found, expected) in [
            (point.sigma_xx, sum(&|x| line(x) * x * x)),
            (point.sigma_yy, sum(&|x| line(x) * d * d)),
            // y upwards: the sign of depth turned
            (point.sigma_xy, -sum(&|x| line(x) * x * d)),
        ] {
            assert!((found - expected).abs() < 1e-12, "({x}, {d}): {found} {expected}");
        }
    }
}

#[test]
fn loads_far_apart_open_the_contact_between_them() {
    let load = || Load::uniform(0.5).unwrap();
    let (_, alone) = press(strip().layer(ground(1.0)), load(), 0.01);
    let alone = alone.contacts()[1].half_length().unwrap();
    let mut before = f64::INFINITY;
    for at in [30.0, 120.0] {
        let far = crate::support::mirrored(&[(at, 1.0, load())]).unwrap();
        let model = Model::new(strip().layer(ground(1.0)).build().unwrap()).unwrap();
        let solution = model.press(far, 0.01).unwrap();
        let contact = &solution.contacts()[1];
        close(contact.resultant, 0.01, 1e-9);
        // each is pressed as by itself, the farther apart the more so
        let [Interval { left: inner, right: outer, force, centroid, .. }] = outwards(contact)[..] else {
            panic!("{contact:?}")
        };
        close(force, 0.005, 1e-9);
        close(centroid, at, 1e-2);
        let off = (0.5 * (outer - inner) / alone - 1.0).abs();
        assert!(off < 0.3 * before && off < 0.03, "{at}: {off}");
        before = off;
        // where the bodies touch, both faces move alike, and outside there is no penetration
        let field = model.field(&solution).unwrap();
        let gap = |x: f64| {
            let [upper, lower] = [1, 2].map(|layer| field.at_layer(x, 2.0, layer).unwrap());
            upper.v - lower.v
        };
        let reference = gap(at);
        let open = gap(inner - 1.0) - reference;
        assert!(open > 0.0 && gap(outer + 1.0) - reference > 0.0, "{at}");
        for x in [0.9 * inner + 0.1 * outer, 0.5 * (inner + outer), 0.1 * inner + 0.9 * outer] {
            assert!((gap(x) - reference).abs() < 1e-5 * open, "{at}, {x}: {:e} {open:e}", gap(x) - reference);
        }
    }
    // near each other they are pressed by one
    let near = crate::support::mirrored(&[(0.9, 1.0, load())]).unwrap();
    let (_, solution) = press(strip().layer(ground(1.0)), near, 0.01);
    assert!(solution.contacts()[1].half_length().unwrap() > 1.4 && solution.min_pressure() >= 0.0);
}

#[test]
fn bonded_stacks_have_nothing_to_solve_for() {
    let (_, solution) = press(Stack::builder(Plane::Strain).layer(ground(1.0)), Load::uniform(2.0).unwrap(), 3.0);
    let [contact] = solution.contacts() else { panic!("one contact") };
    assert_eq!((contact.half_length().unwrap(), contact.central_pressure), (2.0, 0.75));
    close(contact.resultant, 3.0, 1e-14);
}

const SCENE: &str = "Scene(geometry: PlaneStrain, load: Uniform(half_width: 0.5), force: 0.002, stack: [
    Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])";

#[test]
fn scenes_have_a_load_or_a_punch() {
    let scene = Scene::from_ron(SCENE).unwrap();
    assert_eq!(scene.top.loads().unwrap().alone(), Some(&Load::uniform(0.5).unwrap()));
    assert_eq!(scene.paths()[..2], ["force", "load.half_width"]);
    let written = |scene: &Scene| scene.top.written_in(scene.geometry);
    assert_eq!(written(&scene.with("load.half_width", 0.75).unwrap()), "Uniform(half_width: 0.75)");
    assert_eq!(Scene::from_ron(&scene.to_ron()).unwrap().top, scene.top);
    let list = "loads: [(load: Line, at: -1, force: 0.5), (load: Line, at: 1, force: 0.25)]";
    let several = Scene::from_ron(
        &SCENE.replace("load: Uniform(half_width: 0.5), force: 0.002", list).replace("Receding", "Bonded"),
    )
    .unwrap();
    assert_eq!(several.force, recede::Force::Given(0.75));
    assert_eq!(several.paths()[..4], ["loads[1].at", "loads[1].force", "loads[2].at", "loads[2].force"]);
    assert_eq!(several.with("loads[2].at", 2.5).unwrap().top.loads().unwrap().reach(), 2.5);
    let written = "[(load: Line, at: -1.0, force: 0.5), (load: Line, at: 1.0, force: 0.25)]";
    assert_eq!(several.top.written_in(several.geometry), written);
    for again in [several.to_ron(), several.to_json()] {
        assert_eq!(Scene::from_ron(&again).unwrap().top, several.top);
    }
    // the force of a sweep is the sum of the forces of its loads
    let sweep = recede::Sweep::new(several, vec!["loads[1].force=[0.25,1]".parse().unwrap()]).unwrap();
    let forces: Vec<f64> = sweep.rows().map(|row| row.result.unwrap().force()).collect();
    assert_eq!(forces[0], 0.5);
}

#[test]
fn where_loads_overlap_their_pressure_is_the_sum() {
    let load = || Load::uniform(1.0).unwrap();
    let loads = Loads::new(&[(load(), 1.1, 1.0), (load(), 2.9, 1.0)]).unwrap();
    let (_, solution) = press(Stack::builder(Plane::Strain).layer(ground(1.0)), loads, 2.0);
    let peak = solution.contacts()[0].peak();
    assert!(peak.pressure == 1.0 && (peak.x - 2.0).abs() < 0.1, "{peak:?}");
}

#[test]
fn loads_are_symmetric_in_any_order() {
    let [wide, round] = [Load::uniform(0.2).unwrap(), Load::parabolic(0.2).unwrap()];
    let mut loads = vec![(wide.clone(), -0.5, 0.5), (round.clone(), -0.5, 0.5), (round, 0.5, 0.5), (wide, 0.5, 0.5)];
    let forwards = Loads::new(&loads).unwrap();
    loads.swap(2, 3);
    let others = Loads::new(&loads).unwrap();
    assert!(forwards.is_even() && others.is_even());
    let [found, expected] = [others, forwards].map(|loads| receding(strip().layer(ground(0.5)), loads, 2.0));
    close(found, expected, 1e-12);
    // twice on one side
    loads[1].1 = 0.5;
    assert!(!Loads::new(&loads).unwrap().is_even());
}

#[test]
fn the_command_solves_them() {
    let json = support::recede(
        &["solve", "-", "--format", "json"],
        SCENE.replace("Uniform(half_width: 0.5)", "Line").as_bytes(),
    );
    assert_eq!(json.status, Some(0), "{}", json.stderr);
    assert!(
        json.stdout.contains("\"interface\": \"load\"") && json.stdout.contains("\"central_pressure\": null"),
        "{}",
        json.stdout
    );
    assert!(json.stdout.contains("\"half_length\": 0.0,"), "{}", json.stdout);
}
