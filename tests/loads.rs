//! Given pressures in place of a punch.
//!
//! Goal: under a line load a loose strip has the contacts of the literature, whatever the force; wider loads come from and go
//! to what they must; fields are those of the given pressure; and mistakes are told where they are.
//!
//! Source of the numbers: `recede::exact::line_load`.
#[path = "support/mod.rs"]
mod support;

use recede::exact::line_load;
use recede::{
    Error, Exponential, HalfPlane, Homogeneous, Load, Method, Model, Options, Plane, Punch, Scene, Solution, Stack,
    StackBuilder,
};

fn strip() -> StackBuilder {
    Stack::builder(Plane::Strain).layer(Homogeneous::new(2.0, 1.0, 0.25).unwrap()).receding()
}

fn ground(modulus: f64) -> HalfPlane {
    HalfPlane::new(modulus, 0.25).unwrap()
}

fn press(stack: StackBuilder, load: Load, force: f64) -> (Model, Solution) {
    let model = Model::new(stack.build().unwrap()).unwrap();
    let solution = model.press(&Punch::Given(load), force).unwrap();
    assert_eq!(solution.warnings(), [""; 0]);
    (model, solution)
}

fn receding(stack: StackBuilder, load: Load, force: f64) -> f64 {
    let (_, solution) = press(stack, load, force);
    let contact = &solution.contacts()[1];
    assert!(contact.half_length_error < 1e-10 * contact.half_length, "{contact:?}");
    assert!((contact.resultant / force - 1.0).abs() < 1e-12);
    contact.half_length
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
    let solution = model.press(&Punch::parabola(1.0).unwrap(), 1e-9).unwrap();
    close(solution.contacts()[1].half_length, line, 1e-8);
}

#[test]
fn fields_are_those_of_the_given_pressure() {
    let loads = [Load::uniform(0.8).unwrap(), Load::parabolic(0.8).unwrap(), Load::elliptic(0.8).unwrap()];
    for load in loads {
        let (model, solution) = press(strip().layer(ground(0.5)), load.clone(), 0.01);
        let top = &solution.contacts()[0];
        assert_eq!((top.half_length, top.half_length_error), (0.8, 0.0));
        assert_eq!(top.peak_pressure, load.peak_pressure(0.01));
        let shape = |s: f64| match load {
            Load::Uniform { .. } => 1.0,
            Load::Parabolic { .. } => 1.0 - s * s,
            _ => (1.0 - s * s).sqrt(),
        };
        let field = model.field(&solution);
        for s in [0.0, 0.3, 0.7, 0.9] {
            let expected = top.peak_pressure * shape(s);
            close(top.pressure(0.8 * s), expected, 1e-5);
            close(-field.at(0.8 * s, 0.0).unwrap().sigma_yy, expected, 1e-5);
        }
        // at the bottom of the strip, the other contact
        let below = solution.contacts()[1].peak_pressure;
        close(-field.at_layer(0.0, 2.0, 1).unwrap().sigma_yy, below, 1e-8);
    }
    // far from a line load the field is that of a narrow one
    let (model, solution) = press(strip().layer(ground(0.5)), Load::Line, 0.01);
    let (other, narrow) = press(strip().layer(ground(0.5)), Load::elliptic(1e-5).unwrap(), 0.01);
    let [found, expected] = [model.field(&solution), other.field(&narrow)].map(|field| field.at(0.4, 1.0).unwrap());
    close(found.sigma_yy, expected.sigma_yy, 1e-6);
    close(found.sigma_xx, expected.sigma_xx, 1e-6);
}

#[test]
fn bonded_stacks_have_nothing_to_solve_for() {
    let (_, solution) = press(Stack::builder(Plane::Strain).layer(ground(1.0)), Load::uniform(2.0).unwrap(), 3.0);
    let [contact] = solution.contacts() else { panic!("one contact") };
    assert_eq!((contact.half_length, contact.peak_pressure), (2.0, 0.75));
    close(contact.resultant, 3.0, 1e-14);
}

const SCENE: &str = "Scene(plane: Strain, load: Uniform(half_width: 0.5), force: 0.002, stack: [
    Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])";

#[test]
fn scenes_have_a_load_or_a_punch() {
    let scene = Scene::from_ron(SCENE).unwrap();
    assert_eq!(scene.punch.load(), Some(&Load::uniform(0.5).unwrap()));
    assert_eq!(scene.paths()[..2], ["force", "load.half_width"]);
    assert_eq!(scene.with("load.half_width", 0.75).unwrap().punch.to_string(), "Uniform(half_width: 0.75)");
    assert_eq!(Scene::from_ron(&scene.to_ron()).unwrap().punch, scene.punch);
    let said = |from: &str, to: &str| Scene::from_ron(&SCENE.replace(from, to)).unwrap_err().to_string();
    assert_eq!(said("0.5)", "0)"), "scene:1:48: `half_width` of the load: found 0.0, allowed is a finite number > 0");
    assert_eq!(said("load:", "punch: Wedge(slope: 1), load:"), "scene:1:52: the scene has `punch` and `load`");
    assert_eq!(said("load: Uniform(half_width: 0.5), ", ""), "scene:1:1: `punch` is missing in the scene");
    assert!(said("Uniform", "Unifrom").contains("the load is `Unifrom`; allowed are `Line`, `Uniform`"));
    assert!(said("half_width: 0.5", "width: 0.5").contains("the load has no field `width`; allowed is `half_width`"));
    assert!(said("load: Uniform", "punch: Uniform").contains("the punch is `Uniform`"));
    assert!(said("load: Uniform(half_width: 0.5)", "punch: Given(Line)").contains("the punch is `Given`"));
}

#[test]
fn the_command_solves_them() {
    let json = support::recede(
        &["solve", "-", "--format", "json"],
        SCENE.replace("Uniform(half_width: 0.5)", "Line").as_bytes(),
    );
    assert_eq!(json.status, Some(0), "{}", json.stderr);
    assert!(
        json.stdout.contains("\"interface\": \"load\"") && json.stdout.contains("\"peak_pressure\": null"),
        "{}",
        json.stdout
    );
    assert!(json.stdout.contains("\"half_length\": 0.0,"), "{}", json.stdout);
    let collocation = support::recede(&["solve", "-", "--method", "collocation"], SCENE.as_bytes());
    assert_eq!(collocation.status, Some(2), "{}", collocation.stdout);
    let model = Model::new(strip().rigid().build().unwrap()).unwrap();
    let options = Options { method: Method::Collocation, ..Options::default() };
    let refused = model.press_with(&Punch::Given(Load::Line), 1.0, &options);
    assert!(matches!(refused, Err(Error::LoadByCollocation)));
}
