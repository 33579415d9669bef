//! Stresses, strains and displacements at points, one line or one object for each; and profiles along x.
use std::collections::BTreeMap;
use std::io;

use comfy_table::Table;
use serde::{Serialize, Serializer};
use serde_json::Value;

use super::Format;
use super::csv::{LAYER, write_columns};
use super::digits::Digits;
use super::ruled::ruled;
use super::sweep::owner;
use crate::field::{FaceProfile, FieldPoint, FieldQuantity};
use crate::geometry::Coordinates;
use crate::profile::{ContactProfile, FaceProfiles};
use crate::scene::{Dimension, Scene, Units};

/// The stresses, displacements and strains at points, by the names that they have in this geometry, after the places; stable, more may be added. What
/// is infinite, or not known, is infinite or NaN.
pub fn field_columns(points: &[FieldPoint], coordinates: impl Into<Coordinates>) -> Vec<(String, Vec<f64>)> {
    let (coordinates, mut columns) = (coordinates.into(), Vec::new());
    let mut add = |name: &str, of: &dyn Fn(&FieldPoint) -> f64| {
        columns.push((name.to_owned(), points.iter().map(of).collect()));
    };
    add("x", &|point| point.x);
    if coordinates == Coordinates::Cartesian {
        add("y", &|point| point.z);
    }
    add("depth", &|point| point.depth);
    add(LAYER, &|point| point.layer as f64);
    for quantity in FieldQuantity::all_in(coordinates) {
        add(quantity.name_in(coordinates), &|point| quantity.of_in(point, coordinates));
    }
    add("slope", &|point| point.slope);
    columns
}

/// One point as an object; what is infinite or not known is `null`, as serde_json writes such numbers.
struct PointRow<'a>(&'a [(String, Vec<f64>)], usize);

impl Serialize for PointRow<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(columns, k) = self;
        let value = |name: &str, value: f64| if name == LAYER { Value::from(value as usize) } else { value.into() };
        serializer.collect_map(columns.iter().map(|(name, values)| (name, value(name, values[*k]))))
    }
}

/// Writes stresses, displacements and strains at points: as two tables without the stresses that follow from others, but with units, as one JSON object
/// `{"points": [...]}`, or as comma-separated values with one line for each point.
///
/// ```
/// use recede::{Scene, Model, report::{Format, write_field}};
/// let scene = Scene::read("examples/scenes/hertz.ron")?;
/// let model = Model::new(scene.stack()?)?;
/// let field = model.field(&model.press(&scene.top, scene.force)?)?;
/// let mut text = Vec::new();
/// write_field(&[field.at(0.0, 0.5)?], &scene, Format::Csv, &mut text)?;
/// assert!(text.starts_with(b"x,depth,layer,sigma_xx,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of the writer.
pub fn write_field(points: &[FieldPoint], scene: &Scene, format: Format, out: &mut dyn io::Write) -> io::Result<()> {
    let coordinates = scene.coordinates();
    match format {
        Format::Table => {
            writeln!(out, "{}", table(points, scene))?;
            writeln!(out, "{}", strains(points, scene))
        }
        Format::Json => {
            let columns = field_columns(points, coordinates);
            let points: Vec<PointRow> = (0..points.len()).map(|k| PointRow(&columns, k)).collect();
            serde_json::to_writer_pretty(&mut *out, &BTreeMap::from([("points", points)]))?;
            writeln!(out)
        }
        Format::Csv => write_columns(&field_columns(points, coordinates), out),
    }
}

/// Significant digits in a table.
const SHOWN: Digits = Digits(Some(5));

/// The stresses and displacements.
fn table(points: &[FieldPoint], scene: &Scene) -> Table {
    use FieldQuantity::{MaxShear, SigmaXx, SigmaXy, SigmaXz, SigmaYy, SigmaYz, SigmaZz, U, V, VonMises, W};
    let quantities: &[FieldQuantity] = match scene.coordinates() {
        Coordinates::Plane => &[SigmaXx, SigmaYy, SigmaXy, MaxShear, VonMises, U, V],
        Coordinates::Cylindrical => &[SigmaXx, SigmaYy, SigmaXy, SigmaZz, MaxShear, VonMises, U, V],
        Coordinates::Cartesian => &[SigmaXx, SigmaZz, SigmaYy, SigmaXz, SigmaXy, SigmaYz, VonMises, U, W, V],
    };
    table_of(quantities, points, scene)
}

/// The strains.
fn strains(points: &[FieldPoint], scene: &Scene) -> Table {
    let strains: Vec<FieldQuantity> =
        FieldQuantity::all_in(scene.coordinates()).filter(|own| own.is_strain()).collect();
    table_of(&strains, points, scene)
}

/// Some quantities behind the places of points.
fn table_of(quantities: &[FieldQuantity], points: &[FieldPoint], scene: &Scene) -> Table {
    let (coordinates, units) = (scene.coordinates(), scene.units.as_ref());
    let [length, stress] = [Dimension::LENGTH, Dimension::STRESS].map(|dimension| Units::after(units, dimension));
    let unit = |quantity: &FieldQuantity| match quantity {
        quantity if quantity.is_strain() => "",
        FieldQuantity::U | FieldQuantity::V | FieldQuantity::W => &length[..],
        _ => &stress,
    };
    let across = (coordinates == Coordinates::Cartesian).then_some(("y", &length[..]));
    let place = [(coordinates.along(), &length[..])].into_iter().chain(across);
    let place = place.chain([("depth", &length[..]), (LAYER, "")]);
    let mut table = ruled(place.chain(quantities.iter().map(|own| (own.name_in(coordinates), unit(own)))));
    for point in points {
        let numbers = quantities.iter().map(|quantity| quantity.of_in(point, coordinates));
        let across = across.map(|_| SHOWN.exact(point.z));
        let place = [SHOWN.exact(point.x)].into_iter().chain(across);
        let name = scene.layer_name(point.layer).map_or(String::new(), |name| format!(" {name}"));
        let place = place.chain([SHOWN.exact(point.depth), format!("{}{name}", point.layer)]);
        let unknown = |number: f64| if number.is_nan() { "not known".to_owned() } else { SHOWN.exact(number) };
        table.add_row(place.chain(numbers.map(unknown)));
    }
    table
}

/// The displacements of a face, in the order of the columns.
const DISPLACEMENTS: [FieldQuantity; 2] = [FieldQuantity::U, FieldQuantity::V];

/// The columns of a profile by name: x, then pressure and gap of each contact, displacements and slope of each face.
pub fn profile_columns(profile: &FaceProfiles) -> Vec<(String, Vec<f64>)> {
    let mut columns = vec![("x".to_owned(), profile.x.clone())];
    for ContactProfile { interface, pressure, gap } in &profile.contacts {
        let owner = owner(interface);
        columns.push((format!("{owner}_pressure"), pressure.clone()));
        columns.extend(gap.clone().map(|gap| (format!("{owner}_gap"), gap)));
    }
    for FaceProfile { layer, side, points } in &profile.faces {
        let mut add = |what: &str, of: &dyn Fn(&FieldPoint) -> f64| {
            columns.push((format!("layer_{layer}_{side}_{what}"), points.iter().map(of).collect()));
        };
        for quantity in DISPLACEMENTS {
            add(quantity.name_in(profile.coordinates), &|point| quantity.of_in(point, profile.coordinates));
        }
        add("slope", &|point| point.slope);
    }
    columns
}

/// Writes a profile: a header, then one line for each place, with all digits. What is infinite, or is not there, is empty.
///
/// ```
/// use recede::{Model, Scene, profile_places, report::write_profile};
/// let scene = Scene::read("examples/scenes/two_strips.ron")?;
/// let model = Model::new(scene.stack()?)?;
/// let solution = model.press(&scene.top, scene.force)?;
/// let profile = model.profile(&scene.top, &solution, &profile_places(&solution, None, 100))?;
/// let mut text = Vec::new();
/// write_profile(&profile, &mut text)?;
/// assert!(text.starts_with(b"x,punch_pressure,punch_gap,contact_1_2_pressure,contact_1_2_gap,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of the writer.
pub fn write_profile(profile: &FaceProfiles, out: &mut dyn io::Write) -> io::Result<()> {
    write_columns(&profile_columns(profile), out)
}
