//! The units of a scene: what quantities are measured in, and numbers that are written with a unit.
use recede_layers::tree::{Entry, Kind, Node};
use schemars::JsonSchema;
use serde::Deserialize;

use super::origin::{Origin, SceneError};
use super::{Scene, visible};

/// Labels of the units in which the numbers of a scene are. Numbers without a unit are not converted.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// Label of the unit of length, e.g. `mm`.
    pub length: String,
    /// Label of the unit of force, e.g. `N`.
    pub force: String,
}

/// The dimension of a quantity: powers of length, force and angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dimension([i32; 3]);

impl Dimension {
    pub(crate) const NUMBER: Self = Self([0, 0, 0]);
    pub(crate) const LENGTH: Self = Self([1, 0, 0]);
    pub(crate) const PER_LENGTH: Self = Self([-1, 0, 0]);
    pub(crate) const STRESS: Self = Self([-2, 1, 0]);
    pub(crate) const FORCE: Self = Self([0, 1, 0]);
    /// The dimension of a stiffness in axisymmetric problems.
    pub(crate) const FORCE_PER_LENGTH: Self = Self::LINE_LOAD;
    pub(crate) const LINE_LOAD: Self = Self([-1, 1, 0]);
    pub(crate) const STRESS_PER_LENGTH: Self = Self([-3, 1, 0]);
    pub(crate) const ANGLE: Self = Self([0, 0, 1]);

    /// The dimension of a field of a scene; `None` for a field that says nothing of it, such as the `top` of a profile.
    pub(crate) fn of_field(name: &str) -> Option<Self> {
        Some(match name {
            "thickness" | "radius" | "half_width" | "half_length" | "depth" | "height" | "heights" | "length"
            | "centre" | "width" | "at" | "eccentricity" => Self::LENGTH,
            "shear_modulus" | "young" | "pressure_on_top" => Self::STRESS,
            "force" => Self::LINE_LOAD,
            "beta" => Self::PER_LENGTH,
            "stiffness" | "shear_stiffness" | "normal" | "tangential" | "specific_weight" => Self::STRESS_PER_LENGTH,
            "half_angle" | "tilt" => Self::ANGLE,
            "poisson" | "poisson_profile" | "exponent" | "slope" => Self::NUMBER,
            _ => return None,
        })
    }

    /// The name of the dimension, if it has one, with an example of a number with a unit.
    fn name(self) -> Option<(&'static str, &'static str)> {
        Some(match self {
            Self::NUMBER => ("a number without unit", "0.3"),
            Self::LENGTH => ("a length", "\"12.5 um\""),
            Self::PER_LENGTH => ("a number per length", "\"0.5 1/mm\""),
            Self::STRESS => ("a stress", "\"26 GPa\""),
            Self::FORCE => ("a force", "\"13 N\""),
            Self::LINE_LOAD => ("a force per length", "\"13 N/mm\""),
            Self::ANGLE => ("an angle", "\"70.3 deg\""),
            Self::STRESS_PER_LENGTH => ("a stress per length", "\"2 MPa/mm\""),
            _ => return None,
        })
    }
}

/// A unit as a multiple of powers of metre, newton and radian: factor · 10^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Unit {
    dimension: Dimension,
    factor: f64,
    exponent: i32,
}

/// Units by name, with factor and exponent. Of those that are equal the first is written.
const KNOWN: [(Dimension, &str); 4] = [
    (Dimension::LENGTH, "m=1e0 km=1e3 dm=1e-1 cm=1e-2 mm=1e-3 µm=1e-6 μm=1e-6 um=1e-6 nm=1e-9 in=2.54e-2 ft=3.048e-1"),
    (
        Dimension::FORCE,
        "N=1e0 µN=1e-6 uN=1e-6 nN=1e-9 mN=1e-3 kN=1e3 MN=1e6 GN=1e9 kgf=9.80665e0 lbf=4.4482216152605e0 kip=4.4482216152605e3",
    ),
    (
        Dimension::STRESS,
        "Pa=1e0 kPa=1e3 MPa=1e6 GPa=1e9 TPa=1e12 hPa=1e2 bar=1e5 psi=6894.757293168361e0 ksi=6894.757293168361e3",
    ),
    (Dimension::ANGLE, "rad=1e0 deg=0.017453292519943295e0 °=0.017453292519943295e0"),
];

/// Factors that differ by no more than this, relative, are equal but for rounding.
const EQUAL: f64 = 1e-12;
/// Powers of units beyond this are no quantities of mechanics.
const LARGEST_POWER: i32 = 9;

impl Unit {
    const ONE: Self = Self { dimension: Dimension::NUMBER, factor: 1.0, exponent: 0 };

    /// All known units by name.
    fn known() -> impl Iterator<Item = (&'static str, Self)> {
        let one = |dimension, text: &'static str| {
            let (name, number) = text.split_once('=')?;
            let (factor, exponent) = number.split_once('e')?;
            Some((name, Self { dimension, factor: factor.parse().ok()?, exponent: exponent.parse().ok()? }))
        };
        KNOWN.into_iter().flat_map(move |(dimension, all)| all.split(' ').filter_map(move |text| one(dimension, text)))
    }

    fn times(self, other: Self, power: i32) -> Self {
        Self {
            dimension: Dimension([0, 1, 2].map(|k| self.dimension.0[k] + power * other.dimension.0[k])),
            factor: self.factor * other.factor.powi(power),
            exponent: self.exponent + power * other.exponent,
        }
    }

    fn equals(self, other: Self) -> bool {
        self.dimension == other.dimension
            && (self.factor / other.factor * 10f64.powi(self.exponent - other.exponent) - 1.0).abs() <= EQUAL
    }

    /// A product or quotient of known units with powers, such as `N/mm2`, `kN/m^2`, `1/mm` or `MPa mm⁻¹`.
    fn read(text: &str) -> Option<Self> {
        let (mut unit, mut sign) = (Self::ONE, 1);
        let mut rest = text.trim();
        while !rest.is_empty() {
            let end = rest.find(['/', '*', '·', ' ']).unwrap_or(rest.len());
            unit = unit.times(Self::power(&rest[..end])?, sign);
            let between = rest[end..].trim_start();
            sign = if between.starts_with('/') { -1 } else { 1 };
            rest = between.trim_start_matches(['/', '*', '·']).trim_start();
            if rest.is_empty() && !between.is_empty() {
                return None;
            }
        }
        Some(unit)
    }

    /// A known unit with its power: `mm2`, `mm^2`, `mm²`, `mm^-1`; or 1.
    fn power(text: &str) -> Option<Self> {
        if text == "1" {
            return Some(Self::ONE);
        }
        let plain =
            |c| "⁻¹²³".chars().zip("-123".chars()).find(|(raised, _)| *raised == c).map_or(c, |(_, plain)| plain);
        let text: String = text.chars().map(plain).collect();
        let name = text.trim_end_matches(|c: char| c == '-' || c.is_ascii_digit());
        let (name, power) = match &text[name.len()..] {
            "" => (name, 1),
            digits => (name.trim_end_matches('^'), digits.parse().ok()?),
        };
        let (_, unit) = Self::known().find(|(known, _)| *known == name)?;
        (-LARGEST_POWER..=LARGEST_POWER).contains(&power).then(|| Self::ONE.times(unit, power))
    }
}

impl Units {
    /// The label of stresses, with the name that their unit has.
    ///
    /// ```
    /// let units = recede::Units { length: "mm".to_owned(), force: "N".to_owned() };
    /// assert_eq!((units.stress(), units.line_load()), ("MPa".to_owned(), "N/mm".to_owned()));
    /// ```
    pub fn stress(&self) -> String {
        self.symbol(Dimension::STRESS)
    }

    /// The label of a force per unit length out of the plane.
    pub fn line_load(&self) -> String {
        self.symbol(Dimension::LINE_LOAD)
    }

    /// The label of the unit of a quantity, e.g. `mm`, `MPa` or `N/mm`; empty for a number.
    pub(crate) fn symbol(&self, dimension: Dimension) -> String {
        let stress = self.unit(dimension).filter(|_| dimension == Dimension::STRESS);
        if let Some((name, _)) = stress.and_then(|unit| Unit::known().find(|(_, known)| known.equals(unit))) {
            return name.to_owned();
        }
        let [length, force] = [&self.length, &self.force].map(|label| visible(label));
        let Dimension([lengths, forces, _]) = dimension;
        let raised = ["", "", "²", "³"].get(lengths.unsigned_abs() as usize).unwrap_or(&"");
        match (forces, lengths) {
            _ if dimension == Dimension::ANGLE => "rad".to_owned(),
            (0, 0) => String::new(),
            (0, 1..) => format!("{length}{raised}"),
            (0, _) => format!("1/{length}{raised}"),
            (_, 0) => force.into_owned(),
            (_, _) => format!("{force}/{length}{raised}"),
        }
    }

    /// The label behind a number, with a space; nothing if a scene does not name its units.
    pub(crate) fn after(units: Option<&Self>, dimension: Dimension) -> String {
        let symbol = units.map(|units| units.symbol(dimension)).filter(|symbol| !symbol.is_empty());
        symbol.map_or(String::new(), |symbol| format!(" {symbol}"))
    }

    /// The unit of a quantity, if the units of length and force are known.
    fn unit(&self, dimension: Dimension) -> Option<Unit> {
        let length = Unit::read(&self.length).filter(|unit| unit.dimension == Dimension::LENGTH)?;
        let force = Unit::read(&self.force).filter(|unit| unit.dimension == Dimension::FORCE)?;
        Some(Unit::ONE.times(length, dimension.0[0]).times(force, dimension.0[1]))
    }
}

impl Scene {
    /// The number that a text stands for at a path: as it is, or with a unit, which is converted to the units of the scene.
    ///
    /// ```
    /// let scene = recede::Scene::read("examples/gallery/slab_on_soil.ron")?;
    /// assert_eq!(scene.written_number("layer[1].young", "30 GPa")?, 30e6);
    /// assert!(scene.written_number("layer[1].thickness", "30 GPa").is_err());
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError`] if it is no number, or one in another unit.
    pub fn written_number(&self, path: &str, text: &str) -> Result<f64, SceneError> {
        if let Ok(number) = text.trim().parse() {
            return Ok(number);
        }
        let field = path.rsplit('.').next().and_then(|field| field.split('[').next()).unwrap_or(path);
        let dimension = match field {
            "force" => Some(self.force_dimension()),
            _ => Dimension::of_field(field).or(path.starts_with("punch").then_some(Dimension::LENGTH)),
        };
        let none = || (format!("`{path}`: found `{text}`, a number is expected"), "write it as in a scene".to_owned());
        let found = converted(text.trim(), dimension, self.units.as_ref());
        found.and_then(|number| number.ok_or_else(none)).map_err(|(message, hint)| {
            let origin = Origin { file: self.file().unwrap_or("scene").into(), ..Origin::default() };
            origin.error(None, message).hinted(Some(hint))
        })
    }
}

/// Converts the numbers with a unit in the tree of a scene.
pub(super) fn without_units(scene: &mut Node, origin: &Origin) -> Result<(), SceneError> {
    let units: Option<Units> = scene.field("units").and_then(|units| units.read().ok());
    let is_round = scene.field("geometry").is_some_and(|geometry| geometry.name.as_deref() == Some("Axisymmetric"));
    let Kind::Fields(fields) = &mut scene.kind else { return Ok(()) };
    let of_numbers = fields.iter_mut().filter(|field| !matches!(&*field.name, "name" | "description" | "units"));
    for Entry { name, value, .. } in of_numbers {
        // numbers of punches that say nothing else are lengths: heights and places in tables
        let dimension = of_field(name, is_round);
        let dimension = dimension.or(matches!(&**name, "punch" | "punches").then_some(Dimension::LENGTH));
        convert(value, dimension, (units.as_ref(), is_round, Dimension::LENGTH), origin)?;
    }
    Ok(())
}

/// The dimension of a field of this name: forces are whole forces about an axis.
fn of_field(name: &str, is_round: bool) -> Option<Dimension> {
    if name == "force" && is_round { Some(Dimension::FORCE) } else { Dimension::of_field(name) }
}

/// Converts the numbers with a unit within a value, which are to be measured in `dimension` unless their field says more, and in `at` the places in tables.
fn convert(
    node: &mut Node,
    dimension: Option<Dimension>,
    (units, is_round, at): (Option<&Units>, bool, Dimension),
    origin: &Origin,
) -> Result<(), SceneError> {
    let at = if node.name.as_deref() == Some("RelativeTable") { Dimension::NUMBER } else { at };
    let is_row = node.name.is_none() && matches!(node.kind, Kind::Row(_));
    match &mut node.kind {
        Kind::Text(text) => {
            let failed =
                |(message, hint): (String, String)| origin.error(Some(node.place.start), message).hinted(Some(hint));
            if let Some(number) = converted(text, dimension, units).map_err(failed)? {
                node.kind = Kind::Number(number);
            }
        }
        Kind::Fields(fields) => {
            for Entry { name, value, .. } in fields.iter_mut().filter(|field| &*field.name != "name") {
                convert(value, of_field(name, is_round).or(dimension), (units, is_round, at), origin)?;
            }
        }
        Kind::List(members) | Kind::Row(members) => {
            for (index, member) in members.iter_mut().enumerate() {
                // of the rows of a table, the first number is a place
                let dimension = if is_row && index == 0 { Some(at) } else { dimension };
                convert(member, dimension, (units, is_round, at), origin)?;
            }
        }
        Kind::Nothing | Kind::Number(_) => {}
    }
    Ok(())
}

/// A number with a unit, in the units of a scene, or why it cannot be converted, and what to do; `None` for a text that is no number with
/// something behind it.
fn converted(text: &str, expected: Option<Dimension>, units: Option<&Units>) -> Result<Option<f64>, (String, String)> {
    let (number, name) = text.split_at(number_end(text));
    let name = name.trim();
    if number.parse::<f64>().is_err() || name.is_empty() {
        return Ok(None);
    }
    let (allowed, example) = expected.and_then(Dimension::name).unwrap_or(("a number with a unit", "\"12.5 um\""));
    let Some(unit) = Unit::read(name) else {
        let known = Unit::known().map(|(name, _)| name).collect::<Vec<_>>().join(", ");
        return Err((
            format!("`\"{text}\"` is no number with a known unit; allowed is {allowed}, such as {example}"),
            format!("known units are {known}, and their products and quotients, such as N/mm2"),
        ));
    };
    if expected.is_some_and(|expected| expected != unit.dimension) {
        let found = unit.dimension.name().map_or_else(|| format!("in {name}"), |(found, _)| found.to_owned());
        let message = format!("`\"{text}\"` is {found}; allowed is {allowed}, such as {example}");
        let hint = match expected {
            Some(Dimension::NUMBER) => "it has no unit: write the number alone, without quotes",
            Some(Dimension::ANGLE) => "a number without quotes is in radians",
            _ => "a number without quotes is in the units of the scene",
        };
        return Err((message, hint.to_owned()));
    }
    // angles are in radians whatever lengths and forces are in
    if unit.dimension == Dimension::ANGLE {
        return Ok(Some(scaled(number, unit.factor, unit.exponent)));
    }
    let Some(units) = units else {
        let message = format!("`\"{text}\"` has a unit, and the scene does not say in which units it is");
        return Err((message, "add `units: (length: \"mm\", force: \"N\")` to the scene".to_owned()));
    };
    let Some(own) = units.unit(unit.dimension) else {
        let message =
            format!("`\"{text}\"` cannot be converted to units called `{}` and `{}`", units.length, units.force);
        return Err((message, "give `units` in known ones, such as `(length: \"mm\", force: \"N\")`".to_owned()));
    };
    let ratio = unit.times(own, -1);
    Ok(Some(scaled(number, ratio.factor, ratio.exponent)))
}

/// A decimal number times factor · 10^exponent; exactly, if the factor is 1.
fn scaled(number: &str, factor: f64, exponent: i32) -> f64 {
    let (digits, own) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let exponent = i64::from(exponent) + own.parse::<i64>().unwrap_or(0);
    let value: f64 = format!("{digits}e{exponent}").parse().unwrap_or(f64::NAN);
    value * factor
}

/// Where the number ends with which a text begins.
fn number_end(text: &str) -> usize {
    let digits =
        |from: usize| text[from..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |n| from + n);
    let mantissa = digits(usize::from(text.starts_with(['-', '+'])));
    let rest = &text[mantissa..];
    let sign = rest.strip_prefix(['e', 'E']).map(|rest| usize::from(rest.starts_with(['-', '+'])));
    match sign.map(|sign| mantissa + 1 + sign) {
        Some(from) if text[from..].starts_with(|c: char| c.is_ascii_digit()) => digits(from),
        _ => mantissa,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn units(length: &str, force: &str) -> Units {
        Units { length: length.into(), force: force.into() }
    }

    #[test]
    fn units_have_their_usual_names() {
        for (length, force, stress) in [
            ("mm", "N", "MPa"),
            ("m", "N", "Pa"),
            ("m", "kN", "kPa"),
            ("mm", "kN", "GPa"),
            ("in", "lbf", "psi"),
            ("µm", "mN", "GPa"),
            ("cm", "N", "N/cm²"),
            ("ell", "N", "N/ell²"),
        ] {
            assert_eq!(units(length, force).symbol(Dimension::STRESS), stress);
        }
        let metric = units("mm", "N");
        let all = [
            (Dimension::NUMBER, ""),
            (Dimension::LENGTH, "mm"),
            (Dimension::PER_LENGTH, "1/mm"),
            (Dimension::LINE_LOAD, "N/mm"),
            (Dimension::STRESS_PER_LENGTH, "N/mm³"),
        ];
        for (dimension, symbol) in all {
            assert_eq!(metric.symbol(dimension), symbol);
        }
    }

    #[test]
    fn numbers_are_converted_to_the_last_digit() {
        let metric = units("mm", "N");
        for (text, dimension, expected) in [
            ("12.5 um", Dimension::LENGTH, 0.0125),
            ("0.1um", Dimension::LENGTH, 1e-4),
            ("26 GPa", Dimension::STRESS, 26000.0),
            ("26000 N/mm2", Dimension::STRESS, 26000.0),
            ("-1.5e1 kN/m^2", Dimension::STRESS, -0.015),
            ("13.6 kN/m", Dimension::LINE_LOAD, 13.6),
            ("0.3 1/um", Dimension::PER_LENGTH, 300.0),
            ("5 MPa/mm", Dimension::STRESS_PER_LENGTH, 5.0),
            ("7 N mm⁻³", Dimension::STRESS_PER_LENGTH, 7.0),
            ("1 in", Dimension::LENGTH, 25.4),
            ("45 deg", Dimension::ANGLE, std::f64::consts::FRAC_PI_4),
            ("0.5rad", Dimension::ANGLE, 0.5),
        ] {
            let converted = converted(text, Some(dimension), Some(&metric)).unwrap();
            assert_eq!(converted, Some(expected), "{text}");
        }
    }

    #[test]
    fn what_cannot_be_converted_is_told() {
        let metric = units("mm", "N");
        for (text, message) in [
            ("26 GPa", "is a stress; allowed is a length"),
            ("26 N/", "is no number with a known unit"),
            ("3 mm2", "is in mm2; allowed is a length"),
        ] {
            let (found, _) = converted(text, Some(Dimension::LENGTH), Some(&metric)).unwrap_err();
            assert!(found.contains(message), "{text}: {found}");
        }
    }

    #[test]
    fn any_text_is_converted_or_refused() {
        use proptest::prelude::*;
        proptest!(|(text in "\\PC{0,20}")| {
            let _ = converted(&text, Some(Dimension::LENGTH), Some(&units("mm", "N")));
        });
    }
}
