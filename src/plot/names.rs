//! Names of quantities in pictures, and their units.
use recede_layers::tree::{Entry, Kind, Node};

use super::picture::{italic, subscript};
use super::scale::short;
use crate::field::FieldQuantity;
use crate::geometry::{Coordinates, Words};
pub(super) use crate::scene::Dimension;
use crate::scene::{Loads, Scene, Units};
use crate::solution::{ClosedInterface, Contact, Interface};

/// Labels of units that are longer are cut.
const LONGEST: usize = 12;

/// The label of the unit, if the scene names its units.
pub(super) fn unit(scene: &Scene, dimension: Dimension) -> Option<String> {
    let Units { length, force } = scene.units.as_ref()?;
    // scenes may write u for a letter that keyboards lack
    let written = |unit: &String| if matches!(&unit[..], "um" | "uN") { unit.replace('u', "µ") } else { unit.clone() };
    let [length, force] = [length, force].map(|unit| written(unit).chars().take(LONGEST).collect());
    Some(Units { length, force }.symbol(dimension)).filter(|symbol| !symbol.is_empty())
}

/// The unit behind a number, with a space.
pub(super) fn after(scene: &Scene, dimension: Dimension) -> String {
    unit(scene, dimension).map_or(String::new(), |unit| format!(" {unit}"))
}

/// The punch or load in short lines: its kind, then its sizes, as they are written in a scene; several by their number.
pub(super) fn of_top(scene: &Scene) -> Vec<String> {
    let punch = scene.top.punch().or_else(|| scene.top.even_punch());
    let (written, load) = match (punch, scene.top.loads().and_then(Loads::alone)) {
        (Some(punch), _) => (punch.written_in(scene.geometry), ""),
        (None, Some(load)) => (load.written_in(scene.geometry), " load"),
        (None, None) => return vec![scene.top.label(scene.geometry)],
    };
    let node = Node::from_ron(&written).unwrap_or_default();
    let size = |field: &Entry| {
        let Kind::Number(number) = field.value.kind else { return None };
        let (name, dimension) = of_path(scene, &field.name);
        Some(format!("{name} = {}{}", short(number), after(scene, dimension)))
    };
    // in words: `RoundedFlat` as "rounded flat"
    let spaced = |c: char| if c.is_uppercase() { format!(" {c}") } else { c.to_string() };
    let kind: String = node.name.as_deref().unwrap_or_default().chars().map(spaced).collect();
    let kind = kind.trim_start().to_lowercase() + load;
    [kind].into_iter().chain(node.fields().iter().filter_map(size)).collect()
}

/// Which bodies touch there.
pub(super) fn of_contact(scene: &Scene, interface: Interface) -> String {
    match interface {
        Interface::Punch if scene.top.loads().is_some() => "under the load".to_owned(),
        Interface::Punch => "under the punch".to_owned(),
        between => format!("contact {between}"),
    }
}

/// As far as bodies touch: the half-length of one interval about x = 0, or between which places there are how many.
pub(super) fn reach(scene: &Scene, contact: &Contact, symbol: &str) -> String {
    let length = after(scene, Dimension::LENGTH);
    let intervals = contact.intervals();
    match (intervals, contact.half_length()) {
        (_, Some(half_length)) if half_length > 0.0 && contact.is_even() => {
            format!("{symbol} = {}{length}", short(half_length))
        }
        ([one], _) if one.left == one.right => {
            format!("{} = {}{length}", italic(scene.geometry.words().along), short(one.left + 0.0))
        }
        ([first, .., last], _) => {
            let count = intervals.len();
            format!("{count} intervals, {} … {}{length}", short(first.left), short(last.right))
        }
        ([one], _) => format!("{} … {}{length}", short(one.left), short(one.right)),
        ([], _) => String::new(),
    }
}

/// The largest pressure and, unless that is in the middle, where it is; in short lines.
pub(super) fn largest(scene: &Scene, contact: &Contact) -> Vec<String> {
    let peak = contact.peak();
    let value = if peak.pressure.is_finite() {
        short(peak.pressure) + &after(scene, Dimension::STRESS)
    } else {
        "∞".to_owned()
    };
    let Words { along, distance, .. } = scene.geometry.words();
    let along = if contact.is_even() { distance } else { along }.replace(along, &italic(along));
    let place = format!("at {along} = {}{}", short(peak.x), after(scene, Dimension::LENGTH));
    let is_aside = (peak.x - contact.about.unwrap_or(0.0)).abs() > peak.x_error;
    let aside = is_aside.then_some(place);
    [format!("largest {value}")].into_iter().chain(aside).collect()
}

/// The pressure at x = 0 on an interface that weights press together, unless layers are apart there; in short lines.
pub(super) fn central(scene: &Scene, own: &ClosedInterface) -> Vec<String> {
    let at = format!("at {} = 0", italic(scene.geometry.words().along));
    let pressure = format!("{}{} {at}", short(own.central_pressure), after(scene, Dimension::STRESS));
    vec![if own.gap(0.0) > 0.0 { format!("open {at}") } else { pressure }]
}

/// The unit of a column of the table of a sweep, by its name; none of numbers and of columns that are not known.
pub(super) fn of_column(scene: &Scene, name: &str) -> Option<String> {
    let name = name.strip_suffix("_error").unwrap_or(name);
    let is_one_of = |ends: &str| {
        ends.split(' ').any(|end| name.strip_suffix(end).is_some_and(|rest| rest.is_empty() || rest.ends_with('_')))
    };
    let probed = |own: &&FieldQuantity| {
        name.split_once("_at_").is_some_and(|(first, _)| first == own.name_in(scene.coordinates()))
    };
    if let Some(quantity) = FieldQuantity::ALL.iter().find(probed) {
        return unit(scene, of_quantity(*quantity, scene.coordinates()).1);
    }
    let dimension = match scene.geometry.is_axisymmetric() {
        _ if is_one_of("force") => scene.force_dimension(),
        _ if is_one_of("half_length approach left right at x depth thickness radius") => Dimension::LENGTH,
        _ if is_one_of("pressure tension shear von_mises young shear_modulus") => Dimension::STRESS,
        true if is_one_of("stiffness") => Dimension::FORCE_PER_LENGTH,
        false if is_one_of("stiffness") => Dimension::STRESS,
        _ => return None,
    };
    unit(scene, dimension)
}

/// The name of a quantity inside the stack, and its dimension.
pub(super) fn of_quantity(quantity: FieldQuantity, coordinates: Coordinates) -> (String, Dimension) {
    let symbol = written(quantity.name_in(coordinates));
    let name = match quantity {
        FieldQuantity::U | FieldQuantity::V | FieldQuantity::W => {
            return (format!("displacement {symbol}"), Dimension::LENGTH);
        }
        FieldQuantity::Sigma1 => format!("larger principal stress {symbol}"),
        FieldQuantity::Sigma2 => format!("smaller principal stress {symbol}"),
        FieldQuantity::MaxShear => "largest shear stress".to_owned(),
        FieldQuantity::VonMises => "von Mises stress".to_owned(),
        FieldQuantity::Eps1 => format!("larger principal strain {symbol}"),
        FieldQuantity::Eps2 => format!("smaller principal strain {symbol}"),
        FieldQuantity::GammaXy | FieldQuantity::GammaXz | FieldQuantity::GammaYz => format!("angle of shear {symbol}"),
        _ if quantity.is_strain() => format!("strain {symbol}"),
        _ => format!("stress {symbol}"),
    };
    (name, if quantity.is_strain() { Dimension::NUMBER } else { Dimension::STRESS })
}

/// The name of a column as a symbol with indices: `sigma_tt` as σ with the index θθ.
fn written(name: &str) -> String {
    let (letter, indices) = name.split_once('_').unwrap_or((name, ""));
    let letter = match letter {
        "sigma" => "σ",
        "tau" => "τ",
        "eps" => "ε",
        "gamma" => "γ",
        other => other,
    };
    italic(letter) + &if indices.is_empty() { String::new() } else { subscript(&indices.replace('t', "θ")) }
}

/// Symbols of half-length and pressure of each contact from the top down: a, p for the punch; b, q below, with indices
/// if there is more than one.
pub(super) fn symbols(interfaces: impl Iterator<Item = Interface>) -> Vec<(String, String)> {
    let interfaces: Vec<Interface> = interfaces.collect();
    let first = usize::from(interfaces.first() == Some(&Interface::Punch));
    let symbols = interfaces.iter().enumerate().map(|(i, interface)| match interface {
        Interface::Punch => (italic("a"), italic("p")),
        Interface::Between { .. } => {
            let number = if interfaces.len() > first + 1 { index(i + 1 - first) } else { String::new() };
            (italic("b") + &number, italic("q") + &number)
        }
    });
    symbols.collect()
}

/// A number in small figures, for indices.
pub(super) fn index(number: usize) -> String {
    number.to_string().chars().filter_map(|c| char::from_u32(u32::from('₀') + c.to_digit(10)?)).collect()
}

/// The quantity at a path of a scene: its name, with a symbol where there is a usual one, and its dimension.
pub(super) fn of_path(scene: &Scene, path: &str) -> (String, Dimension) {
    let (owner, field) = path.rsplit_once('.').unwrap_or(("", path));
    let (field, number) = match field.split_once('[') {
        Some((field, number)) => (field, format!(" {}", number.trim_end_matches(']'))),
        None => (field, String::new()),
    };
    let symbol = |name: &str, symbol: &str| format!("{name} {}", italic(symbol));
    let words = scene.geometry.words();
    let dimension = match field {
        "force" => scene.force_dimension(),
        _ => Dimension::of_field(field).unwrap_or(Dimension::NUMBER),
    };
    let name = match field {
        "force" => symbol("force", "P"),
        "half_length" => symbol(words.half_length, "a"),
        "half_width" => "half-width".to_owned(),
        "radius" => symbol("radius", "R"),
        "thickness" => symbol("thickness", "h"),
        "height" | "heights" => "height".to_owned(),
        "at" => symbol("place", words.along),
        "shear_modulus" => symbol("shear modulus", "μ"),
        "young" => symbol("Young’s modulus", "E"),
        "poisson" => symbol("Poisson’s ratio", "ν"),
        "beta" => symbol("grading exponent", "β"),
        other => other.replace('_', " "),
    };
    let (of, layer) = match owner.split_once('[') {
        Some((of, rest)) => (of, rest.split(']').next().and_then(|number| number.parse().ok())),
        None => (owner, None),
    };
    let name = match layer {
        Some(layer) if of == "layer" => name + &index(layer),
        Some(one) => format!("{name} of {} {one}", of.rsplit('.').next().unwrap_or(of)),
        None => name,
    };
    (name + &number, dimension)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_symbols() {
        let text = "(geometry: PlaneStrain, load: Line, force: 1, stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)])";
        let plane = Scene::from_ron(text).unwrap();
        let of_path = |path| of_path(&plane, path);
        assert_eq!(of_path("layer[12].beta"), (format!("grading exponent {}₁₂", italic("β")), Dimension::PER_LENGTH));
        assert_eq!(of_path("force").1, Dimension::LINE_LOAD);
        assert_eq!(of_path("layer[1].own_number").0, "own number₁");
        assert_eq!(of_path("punch.heights[2]"), ("height 2".to_owned(), Dimension::LENGTH));
    }

    #[test]
    fn contacts_are_numbered_only_if_there_are_several() {
        let between = |above| Interface::Between { above, below: above + 1 };
        let symbols = |interfaces: &[Interface]| {
            symbols(interfaces.iter().copied()).into_iter().map(|(a, _)| a).collect::<Vec<_>>()
        };
        assert_eq!(symbols(&[Interface::Punch, between(1)]), [italic("a"), italic("b")]);
        let several = symbols(&[Interface::Punch, between(1), between(2)]);
        assert_eq!(several, [italic("a"), italic("b") + "₁", italic("b") + "₂"]);
    }
}
