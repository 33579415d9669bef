//! One case of the gallery: a scene whose first comment says what it is, and what is found for it.
//!
//! The comment ends at `Scene(`. Paragraphs are separated by empty comment lines; lines with a keyword are for the table:
//!
//! ```text
//! // Compare: PATH = VALUE; PATH = VALUE    the same scene with other values, as a column
//! // Compare: interface 1|2 = Bonded        with another interface
//! // At: X, top|bottom of LAYER, QUANTITY   a stress or displacement on a face, as a row
//! ```
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use recede::{Contact, Field, FieldQuantity, Geometry, Item, Model, Scene, Solution};

/// What the path of an interface begins with.
const INTERFACE: &str = "interface ";

/// A case as it is written.
pub struct Case {
    /// Where it is read from.
    pub file: PathBuf,
    /// The scene.
    pub scene: Scene,
    /// What is said of it.
    pub paragraphs: Vec<String>,
    /// What is changed in each further column.
    compare: Vec<Vec<Change>>,
    spots: Vec<Spot>,
}

/// A change of a scene: the path of a number, or an interface; and what is there instead.
struct Change(String, String);

/// A place on the face of a layer, and a quantity there.
struct Spot {
    x: f64,
    bottom: bool,
    layer: usize,
    quantity: FieldQuantity,
}

/// What is found for a scene.
pub struct Found {
    /// What is different from the scene as it is written.
    pub label: String,
    /// What is computed.
    pub solution: Solution,
    /// Names and values, in the order of the table.
    pub numbers: Vec<(String, Value)>,
}

/// A number, and where along x it is found, unless that is the middle.
#[derive(Clone, Copy, Debug)]
pub struct Value {
    /// The number.
    pub number: f64,
    /// The place, 0 in the middle.
    pub at: f64,
    /// Whether the number is the same at the place on the other side of the middle.
    pub is_mirrored: bool,
}

/// A result, or what is wrong with a case.
pub type Outcome<T> = Result<T, Box<dyn Error>>;

impl Case {
    /// Reads a scene and its comment.
    pub fn read(file: &Path) -> Outcome<Self> {
        let text = fs::read_to_string(file)?;
        let comment = text.lines().map_while(|line| line.strip_prefix("//")).map(str::trim);
        let (mut paragraphs, mut compare, mut spots) = (vec![String::new()], Vec::new(), Vec::new());
        for line in comment {
            if let Some(what) = line.strip_prefix("Compare: ") {
                compare.push(what.split("; ").map(Change::parse).collect::<Outcome<_>>()?);
            } else if let Some(what) = line.strip_prefix("At: ") {
                spots.push(what.to_owned());
            } else if line.is_empty() {
                paragraphs.push(String::new());
            } else if let Some(paragraph) = paragraphs.last_mut() {
                let space = if paragraph.is_empty() { "" } else { " " };
                *paragraph += &format!("{space}{line}");
            }
        }
        paragraphs.retain(|paragraph| !paragraph.is_empty());
        let scene = Scene::read(file)?;
        let spots = spots.iter().map(|what| Spot::parse(what, scene.geometry)).collect::<Outcome<_>>()?;
        Ok(Self { file: file.to_owned(), scene, paragraphs, compare, spots })
    }

    /// The name of the file without its ending.
    pub fn stem(&self) -> &str {
        self.file.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default()
    }

    /// Solves the scene as it is written, and with the values with which it is compared.
    pub fn solve(&self) -> Outcome<Vec<Found>> {
        let mut columns = vec![self.found("as drawn".to_owned(), &self.scene)?];
        for changes in &self.compare {
            // interfaces last: a scene with another number is read again from its text
            let (interfaces, numbers): (Vec<_>, Vec<_>) = changes.iter().partition(|change| change.is_interface());
            let mut all = numbers.into_iter().chain(interfaces);
            let scene = all.try_fold(self.scene.clone(), |scene, change| change.made(scene))?;
            let label: Vec<String> = changes.iter().map(|Change(path, value)| format!("{path} = {value}")).collect();
            columns.push(self.found(label.join(", "), &scene)?);
        }
        Ok(columns)
    }

    fn found(&self, label: String, scene: &Scene) -> Outcome<Found> {
        let model = Model::new(scene.stack()?)?;
        let solution = model.press(&scene.top, scene.force)?;
        let field = model.field(&solution)?;
        let units = scene.units.as_ref().ok_or("a scene of the gallery has units")?;
        let (length, stress) = (&units.length, units.stress());
        // about an axis the force is a whole one, and the stiffness one per length
        let (force, stiffness) = match scene.geometry.is_axisymmetric() {
            true => (units.force.clone(), units.line_load()),
            false => (units.line_load(), stress.clone()),
        };
        // a maximum in the middle is found there up to a small part of the contact
        let middle = 1e-3 * solution.contacts()[0].reach();
        let is_mirrored = solution.punches().is_empty();
        let largest = |number: f64, x: f64| Value { number, at: if x.abs() > middle { x } else { 0.0 }, is_mirrored };
        let mut numbers = Vec::new();
        if scene.force.given().is_none() {
            numbers.push((format!("force, {force}"), Value::of(solution.force())));
        }
        for contact in solution.contacts().iter().skip(usize::from(scene.top.loads().is_some())) {
            let peak = contact.peak();
            if is_mirrored {
                numbers.push((format!("{}: width, {length}", contact.interface), Value::of(width(contact))));
            }
            for (k, interval) in contact.intervals().iter().enumerate().filter(|_| !is_mirrored) {
                let name = |what: &str| format!("{}: {what} of interval {}, {length}", contact.interface, k + 1);
                numbers.push((name("left end"), Value::of(interval.left)));
                numbers.push((name("width"), Value::of(interval.right - interval.left)));
            }
            let pressure = largest(peak.pressure, peak.x);
            numbers.push((format!("{}: largest pressure, {stress}", contact.interface), pressure));
        }
        for own in solution.closed() {
            let pressure = Value { number: own.smallest_pressure, at: own.smallest_at, is_mirrored };
            numbers.push((format!("{}: smallest pressure, {stress}", own.interface), pressure));
            if let Some(opening) = own.openings.last() {
                let name = |what: &str| format!("{}: {what}, {length}", own.interface);
                numbers.push((name("gap on the right, from"), Value::of(opening.left)));
                numbers.push((name("its length"), Value::of(opening.right - opening.left)));
                numbers.push((name("its height"), Value::of(opening.largest_gap)));
            }
        }
        if let Some(separation) = model.separation(&scene.top, &solution)? {
            let value = Value { number: separation.critical_force, at: separation.x, is_mirrored };
            numbers.push((format!("force under which {} opens, {force}", separation.interface), value));
        }
        for (k, punch) in solution.punches().iter().enumerate().filter(|(_, punch)| punch.tilt.abs() > 1e-12) {
            numbers.push((format!("tilt of punch {}, rad", k + 1), Value::of(punch.tilt)));
        }
        let shear = field.max_shear()?;
        numbers.push((format!("largest shear stress, {stress}"), largest(shear.value, shear.x)));
        numbers.push((format!("its depth, {length}"), Value::of(shear.depth)));
        for spot in &self.spots {
            if let Some(value) = spot.value(&field)? {
                numbers.push((format!("{}, {stress}", spot.name(scene.geometry)), Value::of(value)));
            }
        }
        if let Ok(approach) = model.approach(&scene.top, &solution) {
            numbers.push((format!("approach, {length}"), Value::of(approach.value)));
            let value = approach.stiffness.value().map(Value::of);
            numbers.extend(value.map(|value| (format!("stiffness, {stiffness}"), value)));
        }
        Ok(Found { label, solution, numbers })
    }
}

impl Found {
    /// A number by its name.
    pub fn number(&self, name: &str) -> Option<Value> {
        self.numbers.iter().find(|(found, _)| found == name).map(|(_, value)| *value)
    }
}

impl Change {
    fn parse(text: &str) -> Outcome<Self> {
        let (path, value) = text.split_once(" = ").ok_or("Compare: PATH = VALUE; PATH = VALUE")?;
        Ok(Self(path.to_owned(), value.to_owned()))
    }

    fn is_interface(&self) -> bool {
        self.0.starts_with(INTERFACE)
    }

    fn made(&self, mut scene: Scene) -> Outcome<Scene> {
        let Self(path, value) = self;
        let Some(between) = path.strip_prefix(INTERFACE) else { return Ok(scene.with(path, value.parse()?)?) };
        let above = between.split('|').next().unwrap_or_default().parse::<usize>()?;
        // layers and interfaces take turns
        let item = scene.stack.get_mut(2 * above - 1).ok_or("an interface of the stack")?;
        *item = if value == "Bonded" { Item::Bonded } else { Err(format!("Bonded, not {value}"))? };
        Ok(scene)
    }
}

impl Value {
    fn of(number: f64) -> Self {
        Self { number, at: 0.0, is_mirrored: true }
    }
}

impl Spot {
    fn parse(text: &str, geometry: Geometry) -> Outcome<Self> {
        let wrong = || format!("At: X, top|bottom of LAYER, QUANTITY, not {text}");
        let [x, face, quantity] = text.split(", ").collect::<Vec<_>>()[..] else { Err(wrong())? };
        let (side, layer) = face.split_once(" of ").ok_or_else(wrong)?;
        let quantity =
            FieldQuantity::ALL.into_iter().find(|one| one.name_in(geometry) == quantity).ok_or_else(wrong)?;
        Ok(Self { x: x.parse()?, bottom: side == "bottom", layer: layer.parse()?, quantity })
    }

    fn name(&self, geometry: Geometry) -> String {
        let face = if self.bottom { "bottom" } else { "top" };
        let along = geometry.words().along;
        format!("`{}` at {along} = {}, {face} of layer {}", self.quantity.name_in(geometry), self.x, self.layer)
    }

    /// `None` if the layer is not there.
    fn value(&self, field: &Field) -> Outcome<Option<f64>> {
        let Some((_, [top, bottom])) = field.layers().find(|(layer, _)| *layer == self.layer) else { return Ok(None) };
        let depth = if self.bottom { bottom } else { top };
        Ok(Some(self.quantity.of(&field.at_layer(self.x, depth, self.layer)?)))
    }
}

/// From the left end of the first interval to the right end of the last, of a contact about the middle.
fn width(contact: &Contact) -> f64 {
    2.0 * contact.reach()
}
