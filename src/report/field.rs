//! Stresses and displacements at points: one line or one object for each.
use std::io;

use comfy_table::Table;
use serde::Serialize;

use super::digits::Digits;
use super::ruled::ruled;
use super::sweep::number;
use crate::field::FieldPoint;
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

#[derive(Serialize)]
struct Document {
    points: Vec<Point>,
}

/// The keys, which are the columns too; they are stable, more may be added. What is infinite or not known is `null` in JSON, as
/// serde_json writes such numbers, and empty in CSV.
#[derive(Serialize)]
struct Point {
    x: f64,
    depth: f64,
    layer: usize,
    sigma_xx: f64,
    sigma_yy: f64,
    sigma_xy: f64,
    sigma_zz: f64,
    sigma_1: f64,
    sigma_2: f64,
    max_shear: f64,
    von_mises: f64,
    u: f64,
    v: f64,
    slope: f64,
}

const HEADER: &str = "x,depth,layer,sigma_xx,sigma_yy,sigma_xy,sigma_zz,sigma_1,sigma_2,max_shear,von_mises,u,v,slope";

impl From<&FieldPoint> for Point {
    fn from(point: &FieldPoint) -> Self {
        let [sigma_1, sigma_2] = point.principal();
        let FieldPoint { x, depth, layer, u, v, slope, sigma_xx, sigma_yy, sigma_xy, sigma_zz } = *point;
        let (max_shear, von_mises) = (point.max_shear(), point.von_mises());
        Self {
            x,
            depth,
            layer,
            sigma_xx,
            sigma_yy,
            sigma_xy,
            sigma_zz,
            sigma_1,
            sigma_2,
            max_shear,
            von_mises,
            u,
            v,
            slope,
        }
    }
}

/// Writes stresses and displacements at points; a table also shows the units.
///
/// ```
/// use recede::{Scene, Model, report::{FieldFormat, write_field}};
/// let scene = Scene::read("examples/scenes/hertz.ron")?;
/// let model = Model::new(scene.stack()?)?;
/// let field = model.field(&model.press(&scene.punch, scene.force)?)?;
/// let mut text = Vec::new();
/// write_field(&[field.at(0.0, 0.5)?], scene.units.as_ref(), FieldFormat::Csv, &mut text)?;
/// assert!(text.starts_with(b"x,depth,layer,sigma_xx,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the writer.
pub fn write_field(
    points: &[FieldPoint],
    units: Option<&Units>,
    format: FieldFormat,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    match format {
        FieldFormat::Table => writeln!(out, "{}", table(points, units)),
        FieldFormat::Json => {
            let document = Document { points: points.iter().map(Point::from).collect() };
            serde_json::to_writer_pretty(&mut *out, &document)?;
            writeln!(out)
        }
        FieldFormat::Csv => {
            writeln!(out, "{HEADER}")?;
            for point in points.iter().map(Point::from) {
                let Point { x, depth, layer, sigma_xx, sigma_yy, sigma_xy, sigma_zz, .. } = point;
                let Point { sigma_1, sigma_2, max_shear, von_mises, u, v, slope, .. } = point;
                let stresses = [sigma_xx, sigma_yy, sigma_xy, sigma_zz, sigma_1, sigma_2, max_shear, von_mises];
                let numbers = stresses.into_iter().chain([u, v, slope]).map(number).collect::<Vec<_>>().join(",");
                writeln!(out, "{x:?},{depth:?},{layer},{numbers}")?;
            }
            Ok(())
        }
    }
}

/// Significant digits in a table.
const SHOWN: Digits = Digits(Some(5));

fn table(points: &[FieldPoint], units: Option<&Units>) -> Table {
    let (length, stress) = (Dimension::LENGTH, Dimension::STRESS);
    let stresses = ["sigma_xx", "sigma_yy", "sigma_xy", "max_shear", "von_mises"];
    let columns = [("x", length), ("depth", length), ("layer", Dimension::NUMBER)].into_iter();
    let columns = columns.chain(stresses.map(|name| (name, stress))).chain([("u", length), ("v", length)]);
    let header = columns.map(|(name, dimension)| match Units::after(units, dimension) {
        unit if unit.is_empty() => name.to_owned(),
        unit => format!("{name},{unit}"),
    });
    let mut table = ruled();
    table.set_header(header);
    for point in points {
        let FieldPoint { x, depth, layer, u, v, sigma_xx, sigma_yy, sigma_xy, .. } = *point;
        let numbers = [sigma_xx, sigma_yy, sigma_xy, point.max_shear(), point.von_mises(), u, v];
        let place = [SHOWN.exact(x), SHOWN.exact(depth), layer.to_string()];
        let unknown = |number: f64| if number.is_nan() { "not known".to_owned() } else { SHOWN.exact(number) };
        table.add_row(place.into_iter().chain(numbers.map(unknown)));
    }
    table
}
