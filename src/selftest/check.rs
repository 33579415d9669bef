//! One scene solved, and its answer checked by conditions that hold without knowing the exact one.
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use super::commands;
use crate::errors::Error;
use crate::model::Model;
use crate::options::Options;
use crate::scene::{Force, Pressed, Punch, Scene};
use crate::solution::{Contact, Interface, Interval, Solution};

/// Number of places per contact at which the sign of the pressure is checked.
const PLACES: usize = 500;
/// Tension of this part of the largest pressure is within the truncation error of the highest modes.
const TENSION: f64 = 1e-5;
/// Relative error allowed in the resultant of a pressure.
const RESULTANT: f64 = 1e-9;

/// A scene that was solved and checked.
#[derive(Clone, Debug)]
pub struct CheckedScene {
    /// The result.
    pub outcome: Outcome,
    /// Time for the contact problem in seconds, kernels included.
    pub seconds: f64,
}

/// The result of a scene.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// An answer that passed all checks.
    Solved(Box<Solution>),
    /// No answer, and the reason.
    Unsolved(Error),
    /// An answer that cannot be right: NaN, tension, a wrong resultant.
    Wrong(String),
    /// A panic.
    Panicked(String),
}

impl CheckedScene {
    /// Solves a scene with a tolerance, and does what the commands do with the answer: reports, fields, and pictures if
    /// requested. A panic is caught.
    pub fn run(scene: &Scene, options: &Options, pictures: bool) -> Self {
        Self::with(scene, options, |model, solution| commands::run(scene, model, solution, pictures))
    }

    /// Solves the contact problem of a scene and checks its answer, without what commands do with it.
    pub fn of_contacts(scene: &Scene, options: &Options) -> Self {
        Self::with(scene, options, |_, _| Ok(()))
    }

    fn with(scene: &Scene, options: &Options, more: impl Fn(&Model, &Solution) -> Result<(), String>) -> Self {
        let start = Instant::now();
        let mut seconds = None;
        let solved = catch_unwind(AssertUnwindSafe(|| -> Result<_, Error> {
            let model = Model::new(scene.stack()?)?;
            let solution = model.press_with(&scene.top, scene.force, options)?;
            seconds = Some(start.elapsed().as_secs_f64());
            let what = wrong(scene, &solution).or_else(|| more(&model, &solution).err());
            Ok((solution, what))
        }));
        let seconds = seconds.unwrap_or_else(|| start.elapsed().as_secs_f64());
        let outcome = match solved {
            Ok(Ok((_, Some(what)))) => Outcome::Wrong(what),
            Ok(Ok((solution, None))) => Outcome::Solved(Box::new(solution)),
            Ok(Err(error)) => Outcome::Unsolved(error),
            Err(panic) => {
                let text = panic.downcast_ref::<String>().map(String::as_str);
                let text = text.or_else(|| panic.downcast_ref().copied()).unwrap_or("without a message");
                Outcome::Panicked(text.to_owned())
            }
        };
        Self { outcome, seconds }
    }
}

impl Outcome {
    /// The answer, if there is one.
    pub fn solution(&self) -> Option<&Solution> {
        if let Self::Solved(solution) = self { Some(solution) } else { None }
    }

    /// Whether the outcome must never happen, whatever the scene.
    pub fn is_wrong(&self) -> bool {
        matches!(self, Self::Wrong(_) | Self::Panicked(_))
    }

    /// The outcome in a word.
    pub fn status(&self) -> &'static str {
        match self {
            Self::Solved(_) => "solved",
            Self::Unsolved(_) => "unsolved",
            Self::Wrong(_) => "wrong",
            Self::Panicked(_) => "panicked",
        }
    }

    /// Why there is no answer; the same words for the same cause, numbers left out. Empty if there is one.
    pub fn reason(&self) -> String {
        without_numbers(&match self {
            Self::Solved(_) => String::new(),
            Self::Unsolved(error) => error.to_string(),
            Self::Wrong(text) | Self::Panicked(text) => text.clone(),
        })
    }
}

/// What is wrong with an answer, if a check fails.
fn wrong(scene: &Scene, solution: &Solution) -> Option<String> {
    if solution.contacts().is_empty() {
        return Some("there are no contacts".to_owned());
    }
    if !(solution.min_pressure().is_finite() && solution.min_gap().is_finite()) {
        return Some("the smallest pressure or gap is not a number".to_owned());
    }
    // under each of several punches, the forces of which are given one by one
    let given = |number: usize| scene.top.punches().and_then(|all| all.parts().nth(number)).map(|(pressed, _)| pressed);
    let of = |contact: &Contact| {
        let each = contact.of_each_punch();
        let total = if let Force::Given(force) = scene.force { force } else { f64::NAN };
        let what = each.iter().enumerate().find_map(|(number, own)| {
            let pressed = given(number).filter(|_| contact.interface == Interface::Punch);
            let of_one = |pressed: &Pressed| pressed.pressed_by().given().unwrap_or(f64::NAN);
            let force = pressed.filter(|_| each.len() > 1).map_or(total, of_one);
            wrong_contact(scene, own, pressed.map(Pressed::shape), force)
        });
        Some(format!("{} at contact {}", what?, contact.interface))
    };
    solution.contacts().iter().find_map(of)
}

fn wrong_contact(scene: &Scene, contact: &Contact, punch: Option<&Punch>, force: f64) -> Option<String> {
    let Contact { central_pressure, central_pressure_error, .. } = *contact;
    let Interval { left: opening, right, right_error: half_length_error, .. } = contact.innermost();
    // an even contact is checked on its right half
    let (from, half_length) = if contact.is_even() { (0.0, right) } else { (opening, right - opening) };
    let is_apart = opening > 0.0 || right < 0.0;
    if contact.interface == Interface::Punch && scene.top.loads().is_some() {
        // the traction is prescribed
        return None;
    }
    let sharp = punch.is_some_and(Punch::is_sharp) && contact.pressure(0.0).is_infinite();
    for (name, value, infinite) in [("half-length", half_length, false), ("pressure", central_pressure, sharp)] {
        let none = name == "pressure" && is_apart && value == 0.0;
        if !(none || value > 0.0 && value.is_infinite() == infinite) {
            return Some(format!("the {name} is {value:e}"));
        }
    }
    for (name, error) in [("half-length", half_length_error), ("pressure", central_pressure_error)] {
        if !(error >= 0.0 && error.is_finite()) {
            return Some(format!("the error of the {name} is {error:e}"));
        }
    }
    // what is left of singular pressures at the ends is missing in the resultant
    let known = if central_pressure > 0.0 { central_pressure_error / central_pressure } else { 0.0 };
    if (contact.resultant / force - 1.0).abs() > RESULTANT.max(known) || contact.resultant.is_nan() {
        return Some(format!("the resultant is {:e} times the force", contact.resultant / force));
    }
    let round = punch.filter(|punch| contact.is_even() && !matches!(punch, Punch::Flat { .. }));
    let edge = round.and_then(Punch::max_half_length);
    if edge.is_some_and(|edge| half_length >= edge) {
        return Some("the contact reaches past the edge of the punch".to_owned());
    }
    let pressures = (0..PLACES).map(|i| contact.pressure(from + half_length * (i as f64 + 0.5) / PLACES as f64));
    let pressures: Vec<f64> = pressures.collect();
    let largest = pressures.iter().copied().fold(0.0, f64::max);
    let smallest = pressures.iter().copied().fold(largest, f64::min);
    if pressures.iter().any(|pressure| !pressure.is_finite()) {
        return Some("a pressure is not a number".to_owned());
    }
    // tension below the answer's own error estimate is no error
    let allowed = if sharp || is_apart { TENSION } else { TENSION.max(central_pressure_error / central_pressure) };
    (smallest < -allowed * largest).then(|| format!("tension of {:.1e} of the largest pressure", -smallest / largest))
}

/// A message with `…` for every number, and for every list of them.
fn without_numbers(text: &str) -> String {
    let is_of_number = |c: &char| c.is_ascii_digit() || matches!(c, '.' | 'e' | '-' | '+');
    let chars: Vec<char> = text.chars().collect();
    let pieces = chars.chunk_by(|a, b| is_of_number(a) == is_of_number(b)).map(|piece| {
        let is_number = is_of_number(&piece[0]) && piece.iter().any(char::is_ascii_digit);
        if is_number { "…".to_owned() } else { piece.iter().collect() }
    });
    let plain = pieces.collect::<String>().replace(", …", "");
    plain.replace("[…]", "…")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_that_differ_in_numbers_are_the_same_reason() {
        for (text, expected) in [
            (
                "the interface 2|3 would open -1.5e-3 from its middle: no",
                "the interface …|… would open … from its middle: no",
            ),
            ("did not converge; the last were [1.0, 2.5e7]", "did not converge; the last were …"),
            ("the punch Cylinder(radius: 5.0) cannot", "the punch Cylinder(radius: …) cannot"),
            ("µ - ]", "µ - ]"),
        ] {
            assert_eq!(without_numbers(text), expected);
        }
    }

    #[test]
    fn an_answer_to_another_question_is_wrong() {
        let text = "(geometry: PlaneStrain, punch: Parabola(radius: 1), force: 1e-3,
            stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)])";
        let mut scene = Scene::from_ron(text).unwrap();
        let check = CheckedScene::run(&scene, &Options::default(), false);
        let solution = check.outcome.solution().unwrap();
        assert_eq!(wrong(&scene, solution), None);
        scene.force = Force::Given(1e-3 * (1.0 + 1e-6));
        assert!(wrong(&scene, solution).unwrap().ends_with("at contact punch"));
        let mut tensile = solution.contacts()[0].clone();
        let first = tensile.strips[0].coefficients[0];
        tensile.strips[0].coefficients = vec![first, -first];
        scene.force = tensile.resultant.into();
        assert!(wrong_contact(&scene, &tensile, scene.top.punch(), f64::NAN).unwrap().starts_with("tension of"));
        tensile.central_pressure_error = f64::NAN;
        assert_eq!(
            wrong_contact(&scene, &tensile, scene.top.punch(), f64::NAN).unwrap(),
            "the error of the pressure is NaN"
        );
    }
}
