//! A scene: what is pressed by what, as read from a text.
mod covered;
mod elastic_cylinder;
mod explain;
mod force;
mod gap;
mod heights;
mod hints;
mod item;
mod load;
mod loads;
mod origin;
mod paths;
mod punch;
mod punches;
mod read;
mod read_item;
mod read_top;
mod round;
mod shape;
mod spline;
mod text;
mod top;
mod units;
mod value;
mod vocabulary;
mod wedge;
mod write;

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use recede_layers::layer_label;
use recede_layers::tree::Node;

pub use covered::Covered;
pub use elastic_cylinder::ElasticCylinder;
pub use force::Force;
pub use heights::HeightsError;
pub use item::{Item, Spring};
pub use load::Load;
pub use loads::{Loads, PlacedLoad};
pub use origin::SceneError;
pub use punch::Punch;
pub use punches::{Pressed, Punches, Tilt};
pub use text::visible;
pub use top::Top;
pub use units::Units;
pub use value::{ListError, ValueError};
pub use vocabulary::{Vocabulary, scene_schema};
pub use wedge::Wedge;

pub(crate) use gap::Gap;
pub(crate) use item::quoted_list;
pub(crate) use paths::{Change, Owner, Slot};
#[cfg(feature = "files")]
pub(crate) use read::{open, read_document};
pub(crate) use shape::{Piece, Shape};
pub(crate) use text::visible_json;
pub(crate) use units::Dimension;

use crate::geometry::{Coordinates, Geometry};
use origin::Origin;
use read::PRESSURE_ON_TOP;
use read_top::tops;

/// Largest scene text that is read, in bytes.
pub const MAX_BYTES: usize = 1 << 20;
/// Largest number of items, layers and interfaces together, in a stack.
pub const MAX_ITEMS: usize = 100_000;

/// A scene as written: a punch pressed onto a stack of layers by a force. Any consistent units; of the numbers of a text those with
/// a unit of their own, such as `"26 GPa"`, are converted to the units of the scene.
///
/// ```
/// use recede::Scene;
/// let scene = Scene::from_ron(
///     "Scene(
///         geometry: PlaneStrain,
///         punch: Cylinder(radius: 500.0),
///         force: 0.002,
///         stack: [
///             Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
///             Receding,
///             HalfPlane(shear_modulus: 1.0, poisson: 0.25),
///         ],
///     )",
/// )?;
/// assert_eq!(scene.stack.len(), 3);
/// assert_eq!(scene.stack()?.laminates().len(), 1);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Scene {
    /// A name for reports.
    pub name: Option<String>,
    /// What the scene shows.
    pub description: Option<String>,
    /// Labels of the units, for reports; they convert numbers with a unit of their own when a scene is read.
    pub units: Option<Units>,
    /// Plane, and in which way, or axisymmetric.
    pub geometry: Geometry,
    /// The punch on top, or several, or the loads that are given in their place.
    pub top: Top,
    /// Line load P > 0 pressing the punch down, or the resultant of the loads: force per unit length out of plane, or the half-length that
    /// it makes; 0 if nothing presses but weights.
    pub force: Force,
    /// Pressure everywhere on the top face, also under a punch, in stress; 0 if there is none.
    pub pressure_on_top: f64,
    /// Layers and the interfaces between them from the top down, ending in a base.
    pub stack: Vec<Item>,
    origin: Option<Arc<Origin>>,
}

impl Scene {
    /// A scene without name and units. Nothing is checked here: [`Scene::stack`] checks the stack and
    /// [`Model::press_with`](crate::Model::press_with) the force.
    pub fn new(geometry: impl Into<Geometry>, top: impl Into<Top>, force: impl Into<Force>, stack: Vec<Item>) -> Self {
        let (geometry, top, force) = (geometry.into(), top.into(), force.into());
        Self {
            name: None,
            description: None,
            units: None,
            geometry,
            top,
            force,
            pressure_on_top: 0.0,
            stack,
            origin: None,
        }
    }

    /// The file from which the scene was read, as it is called in messages; `None` if it was not read from a text.
    pub fn file(&self) -> Option<&str> {
        self.origin.as_deref().map(|origin| &origin.file[..])
    }

    /// Whether weights, or a pressure on top, press layers together.
    pub(crate) fn is_weighed(&self) -> bool {
        let mut layers = self.stack.iter().filter_map(Item::elastic);
        self.pressure_on_top > 0.0 || layers.any(|layer| layer.specific_weight() > 0.0)
    }

    /// The dimension of its forces: in plane problems they are per unit of length.
    pub(crate) fn force_dimension(&self) -> Dimension {
        if self.geometry.is_axisymmetric() { Dimension::FORCE } else { Dimension::LINE_LOAD }
    }

    /// The coordinates in which the fields of the scene are told.
    pub fn coordinates(&self) -> Coordinates {
        let is_spatial = self.top.loads().is_some_and(|loads| loads.axes().is_some());
        if is_spatial { Coordinates::Cartesian } else { self.geometry.into() }
    }

    /// The name of the layer with this number, counted from 1 at the top, if it has one.
    ///
    /// ```
    /// let scene = recede::Scene::from_ron("(geometry: Axisymmetric, load: Uniform(radius: 0.1), force: 1, stack: [
    ///     HalfPlane(name: \"soil\", young: 1, poisson: 0.3)])")?;
    /// assert_eq!((scene.layer_name(1), scene.numbered("0,0.1@soil")), (Some("soil"), "0,0.1@1".to_owned()));
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn layer_name(&self, number: usize) -> Option<&str> {
        self.layers().find(|(own, _)| *own == number)?.1.own_name()
    }

    /// A place such as `0,0.2@asphalt`, or a quantity there, with the number of the layer in place of its name.
    pub fn numbered(&self, place: &str) -> String {
        let is_end = |rest: &str| rest.is_empty() || rest.starts_with('=');
        let named = |(number, item): (usize, &Item)| {
            let (before, layer) = place.split_once('@')?;
            let rest = layer.trim_start().strip_prefix(item.own_name()?)?.trim_start();
            is_end(rest).then(|| format!("{before}@{number}{rest}"))
        };
        self.layers().find_map(named).unwrap_or_else(|| place.to_owned())
    }

    /// What the layer with this number is called in reports and pictures.
    pub(crate) fn layer_label(&self, number: usize) -> String {
        layer_label(number, self.layer_name(number))
    }

    /// The layers and the base with their numbers from the top.
    fn layers(&self) -> impl Iterator<Item = (usize, &Item)> {
        (1..).zip(self.stack.iter().filter(|item| !item.is_interface()))
    }

    /// The title of the scene in a report: its name, or else the name of its file without folder and ending.
    pub fn title(&self) -> &str {
        match (&self.name, self.file()) {
            (Some(name), _) => name,
            (None, Some(file)) => Path::new(file).file_stem().and_then(|stem| stem.to_str()).unwrap_or(file),
            (None, None) => "scene",
        }
    }

    /// A part of the text.
    fn node(&self, part: Owner) -> Option<&Node> {
        let tree = &self.origin.as_deref()?.tree;
        match part {
            Owner::Force => tree.field(self.force.field()),
            Owner::Top => tops(tree).next().map(|(_, node)| node),
            Owner::PressureOnTop => tree.field(PRESSURE_ON_TOP),
            Owner::Stack => tree.field("stack"),
            Owner::Item(index) => tree.field("stack")?.members().get(index),
        }
    }

    /// An error about a part of the text, of an item that is no longer there about the stack; `None` if the scene was not read from a text.
    pub(crate) fn error_at<E>(&self, part: Owner, hint: Option<String>, cause: &E) -> Option<SceneError>
    where
        E: Error + Clone + Send + Sync + 'static,
    {
        let origin = self.origin.as_deref()?;
        // items may have been added or taken away since the text was read
        let is_known = self.stack.len() == self.node(Owner::Stack)?.members().len();
        let part = if matches!(part, Owner::Item(_)) && !is_known { Owner::Stack } else { part };
        let error = origin.error(self.node(part).map(|node| node.place.start), cause.to_string());
        Some(error.hinted(hint).because(cause.clone()))
    }
}
