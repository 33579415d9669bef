//! The units of a scene: what quantities are measured in, and numbers that are written with a unit.
use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::Deserialize;

use super::visible;

/// Labels of the units in which the numbers of a scene are. Numbers without a unit are not converted.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// Label of the unit of length, e.g. `mm`.
    pub length: String,
    /// Label of the unit of force, e.g. `N`.
    pub force: String,
}

/// What a quantity is measured in: powers of length, force and angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dimension {
    length: i32,
    force: i32,
    angle: i32,
}

const fn powers(length: i32, force: i32) -> Dimension {
    Dimension { length, force, angle: 0 }
}

impl Dimension {
    pub(crate) const NUMBER: Self = powers(0, 0);
    pub(crate) const LENGTH: Self = powers(1, 0);
    pub(crate) const PER_LENGTH: Self = powers(-1, 0);
    pub(crate) const STRESS: Self = powers(-2, 1);
    pub(crate) const FORCE: Self = FORCE;
    /// Of a stiffness in axisymmetric problems.
    pub(crate) const FORCE_PER_LENGTH: Self = Self::LINE_LOAD;
    pub(crate) const LINE_LOAD: Self = powers(-1, 1);
    pub(crate) const STRESS_PER_LENGTH: Self = powers(-3, 1);
    pub(crate) const ANGLE: Self = Self { length: 0, force: 0, angle: 1 };

    /// That of a field of a scene; `None` for those that say nothing of it, such as the `top` of a profile.
    pub(crate) fn of_field(name: &str) -> Option<Self> {
        Some(match name {
            "thickness" | "radius" | "half_width" | "half_length" | "depth" | "height" | "heights" | "length"
            | "centre" | "width" | "at" | "eccentricity" => Self::LENGTH,
            "shear_modulus" | "young" => Self::STRESS,
            "force" => Self::LINE_LOAD,
            "beta" => Self::PER_LENGTH,
            "stiffness" | "shear_stiffness" | "normal" | "tangential" => Self::STRESS_PER_LENGTH,
            "half_angle" | "tilt" => Self::ANGLE,
            "poisson" | "poisson_profile" | "exponent" | "slope" => Self::NUMBER,
            _ => return None,
        })
    }

    /// What it is called, with an example of a number with a unit.
    fn name(self) -> (&'static str, &'static str) {
        match self {
            Self::NUMBER => ("a number without unit", "0.3"),
            Self::LENGTH => ("a length", "\"12.5 um\""),
            Self::PER_LENGTH => ("a number per length", "\"0.5 1/mm\""),
            Self::STRESS => ("a stress", "\"26 GPa\""),
            Self::FORCE => ("a force", "\"13 N\""),
            Self::LINE_LOAD => ("a force per length", "\"13 N/mm\""),
            Self::ANGLE => ("an angle", "\"70.3 deg\""),
            Self::STRESS_PER_LENGTH => ("a stress per length", "\"2 MPa/mm\""),
            _ => ("something else", "\"1 mm\""),
        }
    }
}

/// A unit as a multiple of powers of metre, newton and radian: factor · 10^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Unit {
    dimension: Dimension,
    factor: f64,
    exponent: i32,
}

const fn unit(dimension: Dimension, factor: f64, exponent: i32) -> Unit {
    Unit { dimension, factor, exponent }
}

const FORCE: Dimension = powers(0, 1);

/// Units by name. Of those that are equal the first is written.
const KNOWN: &[(&str, Unit)] = &[
    ("m", unit(Dimension::LENGTH, 1.0, 0)),
    ("km", unit(Dimension::LENGTH, 1.0, 3)),
    ("dm", unit(Dimension::LENGTH, 1.0, -1)),
    ("cm", unit(Dimension::LENGTH, 1.0, -2)),
    ("mm", unit(Dimension::LENGTH, 1.0, -3)),
    ("µm", unit(Dimension::LENGTH, 1.0, -6)),
    ("μm", unit(Dimension::LENGTH, 1.0, -6)),
    ("um", unit(Dimension::LENGTH, 1.0, -6)),
    ("nm", unit(Dimension::LENGTH, 1.0, -9)),
    ("in", unit(Dimension::LENGTH, 2.54, -2)),
    ("ft", unit(Dimension::LENGTH, 3.048, -1)),
    ("N", unit(FORCE, 1.0, 0)),
    ("µN", unit(FORCE, 1.0, -6)),
    ("uN", unit(FORCE, 1.0, -6)),
    ("nN", unit(FORCE, 1.0, -9)),
    ("mN", unit(FORCE, 1.0, -3)),
    ("kN", unit(FORCE, 1.0, 3)),
    ("MN", unit(FORCE, 1.0, 6)),
    ("GN", unit(FORCE, 1.0, 9)),
    ("kgf", unit(FORCE, 9.80665, 0)),
    ("lbf", unit(FORCE, 4.448_221_615_260_5, 0)),
    ("kip", unit(FORCE, 4.448_221_615_260_5, 3)),
    ("Pa", unit(Dimension::STRESS, 1.0, 0)),
    ("kPa", unit(Dimension::STRESS, 1.0, 3)),
    ("MPa", unit(Dimension::STRESS, 1.0, 6)),
    ("GPa", unit(Dimension::STRESS, 1.0, 9)),
    ("TPa", unit(Dimension::STRESS, 1.0, 12)),
    ("hPa", unit(Dimension::STRESS, 1.0, 2)),
    ("bar", unit(Dimension::STRESS, 1.0, 5)),
    ("psi", unit(Dimension::STRESS, 6_894.757_293_168_361, 0)),
    ("ksi", unit(Dimension::STRESS, 6_894.757_293_168_361, 3)),
    ("rad", unit(Dimension::ANGLE, 1.0, 0)),
    ("deg", unit(Dimension::ANGLE, PI / 180.0, 0)),
    ("°", unit(Dimension::ANGLE, PI / 180.0, 0)),
];

/// Factors that differ by no more than this, relative, are equal but for rounding.
const EQUAL: f64 = 1e-12;
/// Powers of units beyond this are no quantities of mechanics.
const LARGEST_POWER: i32 = 9;

impl Unit {
    const ONE: Self = unit(Dimension::NUMBER, 1.0, 0);

    fn times(self, other: Self, power: i32) -> Self {
        Self {
            dimension: Dimension {
                length: self.dimension.length + power * other.dimension.length,
                force: self.dimension.force + power * other.dimension.force,
                angle: self.dimension.angle + power * other.dimension.angle,
            },
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
            let (name, power) = power(&rest[..end])?;
            let factor = if name == "1" { Self::ONE } else { KNOWN.iter().find(|(known, _)| *known == name)?.1 };
            unit = unit.times(factor, sign * power);
            let between = rest[end..].trim_start();
            sign = if between.starts_with('/') { -1 } else { 1 };
            rest = between.trim_start_matches(['/', '*', '·']).trim_start();
            if rest.is_empty() && !between.is_empty() {
                return None;
            }
        }
        Some(unit)
    }
}

/// A unit with its power: `mm2`, `mm^2`, `mm²`, `mm^-1`.
fn power(text: &str) -> Option<(&str, i32)> {
    if text == "1" {
        return Some((text, 1));
    }
    let end = text.find(|c: char| c == '^' || c == '-' || c.is_ascii_digit() || "⁻¹²³".contains(c));
    let Some(end) = end.filter(|end| *end > 0) else { return Some((text, 1)) };
    let digits: String = text[end..].trim_start_matches('^').chars().map(plain_digit).collect();
    let power: i32 = digits.parse().ok()?;
    (power.abs() <= LARGEST_POWER).then_some((&text[..end], power))
}

fn plain_digit(c: char) -> char {
    match c {
        '⁻' => '-',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        other => other,
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
        let named = self
            .unit(dimension)
            .filter(|_| dimension == Dimension::STRESS)
            .and_then(|unit| KNOWN.iter().find(|(_, known)| known.equals(unit)).map(|(name, _)| (*name).to_owned()));
        if let Some(name) = named {
            return name;
        }
        let Dimension { length: power, force, .. } = dimension;
        let [own_length, own_force] = [&self.length, &self.force].map(|label| visible(label));
        let superscript = |power: i32| match power.abs() {
            2 => "²",
            3 => "³",
            _ => "",
        };
        let length = format!("{own_length}{}", superscript(power));
        match (force, power) {
            _ if dimension == Dimension::ANGLE => "rad".to_owned(),
            (0, 0) => String::new(),
            (0, 1..) => length,
            (0, _) => format!("1/{length}"),
            (_, 0) => own_force.into_owned(),
            (_, _) => format!("{own_force}/{length}"),
        }
    }

    /// The label behind a number, with a space; nothing if a scene does not name its units.
    pub(crate) fn after(units: Option<&Self>, dimension: Dimension) -> String {
        let symbol = units.map(|units| units.symbol(dimension)).filter(|symbol| !symbol.is_empty());
        symbol.map_or(String::new(), |symbol| format!(" {symbol}"))
    }

    /// The unit of a quantity, if those of length and force are known.
    fn unit(&self, dimension: Dimension) -> Option<Unit> {
        let length = Unit::read(&self.length).filter(|unit| unit.dimension == Dimension::LENGTH)?;
        let force = Unit::read(&self.force).filter(|unit| unit.dimension == FORCE)?;
        Some(Unit::ONE.times(length, dimension.length).times(force, dimension.force))
    }
}

/// Whether a text is a number with something behind it.
pub(super) fn has_unit(text: &str) -> bool {
    let (number, rest) = text.split_at(number_end(text));
    number.parse::<f64>().is_ok() && !rest.trim().is_empty()
}

/// A number with a unit, in the units of a scene; or why it is none, and what to do.
pub(super) fn converted(
    text: &str,
    expected: Option<Dimension>,
    units: Option<&Units>,
) -> Result<f64, (String, String)> {
    let (allowed, example) = expected.map_or(("a number with a unit", "\"12.5 um\""), Dimension::name);
    let end = number_end(text);
    let (number, name) = (&text[..end], text[end..].trim());
    let unit = Unit::read(name).filter(|_| number.parse::<f64>().is_ok());
    let Some(unit) = unit.filter(|_| !name.is_empty()) else {
        let known = KNOWN.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
        return Err((
            format!("`\"{text}\"` is no number with a known unit; allowed is {allowed}, such as {example}"),
            format!("known units are {known}, and their products and quotients, such as N/mm2"),
        ));
    };
    if expected.is_some_and(|expected| expected != unit.dimension) {
        let found = match unit.dimension.name() {
            ("something else", _) => format!("in {name}"),
            (found, _) => found.to_owned(),
        };
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
        return Ok(scaled(number, unit.factor, unit.exponent));
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
    Ok(scaled(number, ratio.factor, ratio.exponent))
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
            assert_eq!(converted, expected, "{text}");
        }
    }

    #[test]
    fn what_cannot_be_converted_is_told() {
        let metric = units("mm", "N");
        for (text, dimension, units, message) in [
            (
                "26 GPa",
                Dimension::LENGTH,
                Some(&metric),
                "`\"26 GPa\"` is a stress; allowed is a length, such as \"12.5 um\"",
            ),
            ("26 Gpa", Dimension::STRESS, Some(&metric), "is no number with a known unit"),
            ("26 N/", Dimension::STRESS, Some(&metric), "is no number with a known unit"),
            ("3 mm2", Dimension::LENGTH, Some(&metric), "is in mm2; allowed is a length"),
            ("26 GPa", Dimension::STRESS, None, "the scene does not say in which units it is"),
        ] {
            let (found, _) = converted(text, Some(dimension), units).unwrap_err();
            assert!(found.contains(message), "{text}: {found}");
        }
        let (found, _) = converted("1 mm", None, Some(&units("ell", "N"))).unwrap_err();
        assert!(found.contains("cannot be converted to units called `ell` and `N`"), "{found}");
    }

    #[test]
    fn any_text_is_converted_or_refused() {
        use proptest::prelude::*;
        proptest!(|(text in "\\PC{0,20}")| {
            let _ = converted(&text, Some(Dimension::LENGTH), Some(&units("mm", "N")));
        });
    }
}
