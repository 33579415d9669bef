//! What quantities are called in pictures, and their units.
use super::picture::{italic, subscript};
use crate::field::FieldQuantity;
use crate::scene::{Scene, Units};
use crate::solution::Interface;

/// Small figures, for indices.
const INDICES: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];

/// What a quantity is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dimension {
    Length,
    Stress,
    LineLoad,
    PerLength,
    Number,
}

/// The label of the unit, if the scene names its units.
pub(super) fn unit(scene: &Scene, dimension: Dimension) -> Option<String> {
    let Units { length, force } = scene.units.as_ref()?;
    match dimension {
        Dimension::Length => Some(length.clone()),
        Dimension::Stress => Some(format!("{force}/{length}²")),
        Dimension::LineLoad => Some(format!("{force}/{length}")),
        Dimension::PerLength => Some(format!("1/{length}")),
        Dimension::Number => None,
    }
}

/// What a quantity inside the stack is called, and its dimension.
pub(super) fn of_quantity(quantity: FieldQuantity) -> (String, Dimension) {
    let stress = |name: &str, indices: &str| format!("{name}{}{}", italic("σ"), subscript(indices));
    let name = match quantity {
        FieldQuantity::SigmaXx => stress("stress ", "xx"),
        FieldQuantity::SigmaYy => stress("stress ", "yy"),
        FieldQuantity::SigmaXy => stress("stress ", "xy"),
        FieldQuantity::SigmaZz => stress("stress ", "zz"),
        FieldQuantity::Sigma1 => stress("larger principal stress ", "1"),
        FieldQuantity::Sigma2 => stress("smaller principal stress ", "2"),
        FieldQuantity::MaxShear => "largest shear stress".to_owned(),
        FieldQuantity::VonMises => "von Mises stress".to_owned(),
        FieldQuantity::U => return (format!("displacement {}", italic("u")), Dimension::Length),
        FieldQuantity::V => return (format!("displacement {}", italic("v")), Dimension::Length),
    };
    (name, Dimension::Stress)
}

/// Symbols of half-length and pressure of each contact from the top down: a, p for the punch; b, q below, with indices
/// if there is more than one.
pub(super) fn symbols(interfaces: &[Interface]) -> Vec<(String, String)> {
    let receding = interfaces.iter().filter(|interface| **interface != Interface::Punch).count();
    let mut number = 0;
    let symbol = |interface: &Interface| match interface {
        Interface::Punch => (italic("a"), italic("p")),
        Interface::Between { .. } if receding == 1 => (italic("b"), italic("q")),
        Interface::Between { .. } => {
            number += 1;
            (italic("b") + &index(number), italic("q") + &index(number))
        }
    };
    interfaces.iter().map(symbol).collect()
}

/// A number in small figures.
pub(super) fn index(number: usize) -> String {
    let figure = |c: char| Some(INDICES[c.to_digit(10)? as usize]);
    number.to_string().chars().filter_map(figure).collect()
}

/// What stands at a path of a scene: a name with a symbol where there is a usual one, and its dimension.
pub(super) fn of_path(path: &str) -> (String, Dimension) {
    let (owner, field) = path.rsplit_once('.').unwrap_or(("", path));
    let (name, dimension) = match field {
        "force" => (format!("force {}", italic("P")), Dimension::LineLoad),
        "half_length" => (format!("half-length {}", italic("a")), Dimension::Length),
        "radius" => (format!("radius {}", italic("R")), Dimension::Length),
        "thickness" => (format!("thickness {}", italic("h")), Dimension::Length),
        "shear_modulus" => (format!("shear modulus {}", italic("μ")), Dimension::Stress),
        "poisson" => (format!("Poisson’s ratio {}", italic("ν")), Dimension::Number),
        "beta" => (format!("grading exponent {}", italic("β")), Dimension::PerLength),
        other => (other.replace('_', " "), Dimension::Number),
    };
    let layer = owner.strip_prefix("layer[").and_then(|rest| rest.split(']').next()?.parse().ok());
    let name = match layer {
        Some(number) => name + &index(number),
        None => name,
    };
    (name, dimension)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_symbols() {
        assert_eq!(of_path("layer[12].beta"), (format!("grading exponent {}₁₂", italic("β")), Dimension::PerLength));
        assert_eq!(of_path("force").1, Dimension::LineLoad);
        assert_eq!(of_path("layer[1].own_number").0, "own number₁");
    }

    #[test]
    fn contacts_are_numbered_only_if_there_are_several() {
        let between = |above| Interface::Between { above, below: above + 1 };
        let symbols = |interfaces: &[Interface]| symbols(interfaces).into_iter().map(|(a, _)| a).collect::<Vec<_>>();
        assert_eq!(symbols(&[Interface::Punch, between(1)]), [italic("a"), italic("b")]);
        let several = symbols(&[Interface::Punch, between(1), between(2)]);
        assert_eq!(several, [italic("a"), italic("b") + "₁", italic("b") + "₂"]);
    }
}
