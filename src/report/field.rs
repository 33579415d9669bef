//! Stresses and displacements at points: one line or one object for each.
use std::collections::BTreeMap;
use std::io;

use comfy_table::Table;
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::digits::Digits;
use super::ruled::ruled;
use super::sweep::number;
use crate::field::{FieldPoint, FieldQuantity};
use crate::geometry::Geometry;
use crate::scene::{Dimension, Units};

/// How a field is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FieldFormat {
    /// A table to be read, without the stresses that follow from others.
    Table,
    /// One JSON object, `{"points": [...]}`, with all digits.
    Json,
    /// Comma-separated values: a header, then one line for each point, with all digits.
    Csv,
}

/// Names that are columns, and keys, in every geometry before and after the names of the quantities.
const PLACE: [&str; 3] = ["x", "depth", "layer"];
const STRAINS: [&str; 3] = ["eps_rr", "eps_tt", "eps_zz"];

/// The quantities, in their order, with their names; stable, more may be added.
fn columns(geometry: Geometry) -> impl Iterator<Item = &'static str> {
    let strains: &[&str] = if geometry.is_axisymmetric() { &STRAINS } else { &[] };
    FieldQuantity::ALL
        .into_iter()
        .map(move |quantity| quantity.name_in(geometry))
        .chain(["slope"])
        .chain(strains.iter().copied())
}

/// The numbers in these columns.
fn numbers(point: &FieldPoint, geometry: Geometry) -> impl Iterator<Item = f64> {
    let quantities = FieldQuantity::ALL.map(|quantity| quantity.of_in(point, geometry));
    quantities.into_iter().chain([point.slope]).chain(point.strains.into_iter().flatten())
}

/// One point as an object; what is infinite or not known is `null`, as serde_json writes such numbers.
struct Point<'a>(&'a FieldPoint, Geometry);

impl Serialize for Point<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(point, geometry) = self;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("x", &point.x)?;
        map.serialize_entry("depth", &point.depth)?;
        map.serialize_entry("layer", &point.layer)?;
        for (name, number) in columns(*geometry).zip(numbers(point, *geometry)) {
            map.serialize_entry(name, &number)?;
        }
        map.end()
    }
}

/// Writes stresses and displacements at points; a table also shows the units.
///
/// ```
/// use recede::{Scene, Model, report::{FieldFormat, write_field}};
/// let scene = Scene::read("examples/scenes/hertz.ron")?;
/// let model = Model::new(scene.stack()?)?;
/// let field = model.field(&model.press(&scene.top, scene.force)?)?;
/// let mut text = Vec::new();
/// write_field(&[field.at(0.0, 0.5)?], scene.geometry, scene.units.as_ref(), FieldFormat::Csv, &mut text)?;
/// assert!(text.starts_with(b"x,depth,layer,sigma_xx,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of the writer.
pub fn write_field(
    points: &[FieldPoint],
    geometry: Geometry,
    units: Option<&Units>,
    format: FieldFormat,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    match format {
        FieldFormat::Table => writeln!(out, "{}", table(points, geometry, units)),
        FieldFormat::Json => {
            let points: Vec<Point> = points.iter().map(|point| Point(point, geometry)).collect();
            serde_json::to_writer_pretty(&mut *out, &BTreeMap::from([("points", points)]))?;
            writeln!(out)
        }
        FieldFormat::Csv => {
            let header: Vec<&str> = PLACE.into_iter().chain(columns(geometry)).collect();
            writeln!(out, "{}", header.join(","))?;
            for point in points {
                let numbers = numbers(point, geometry).map(number).collect::<Vec<_>>().join(",");
                writeln!(out, "{:?},{:?},{},{numbers}", point.x, point.depth, point.layer)?;
            }
            Ok(())
        }
    }
}

/// Significant digits in a table.
const SHOWN: Digits = Digits(Some(5));

fn table(points: &[FieldPoint], geometry: Geometry, units: Option<&Units>) -> Table {
    let (length, stress) = (Dimension::LENGTH, Dimension::STRESS);
    let hoop = geometry.is_axisymmetric().then_some(FieldQuantity::SigmaZz);
    let stresses: Vec<FieldQuantity> = [FieldQuantity::SigmaXx, FieldQuantity::SigmaYy, FieldQuantity::SigmaXy]
        .into_iter()
        .chain(hoop)
        .chain([FieldQuantity::MaxShear, FieldQuantity::VonMises])
        .collect();
    let displacements = [FieldQuantity::U, FieldQuantity::V];
    let named = |quantity: &FieldQuantity| quantity.name_in(geometry);
    let columns = [(geometry.words().along, length), ("depth", length), ("layer", Dimension::NUMBER)].into_iter();
    let columns = columns.chain(stresses.iter().map(|quantity| (named(quantity), stress)));
    let columns = columns.chain(displacements.iter().map(|quantity| (named(quantity), length)));
    let header = columns.map(|(name, dimension)| match Units::after(units, dimension) {
        unit if unit.is_empty() => name.to_owned(),
        unit => format!("{name},{unit}"),
    });
    let mut table = ruled();
    table.set_header(header);
    for point in points {
        let numbers = stresses.iter().chain(&displacements).map(|quantity| quantity.of_in(point, geometry));
        let place = [SHOWN.exact(point.x), SHOWN.exact(point.depth), point.layer.to_string()];
        let unknown = |number: f64| if number.is_nan() { "not known".to_owned() } else { SHOWN.exact(number) };
        table.add_row(place.into_iter().chain(numbers.map(unknown)));
    }
    table
}
