//! Quantities of a scene by path, such as `force` or `layer[2].beta`, and scenes in which they have other values.
//!
//! Values are replaced among the values of the text, and the scene is read from them again: so a new value is checked as one in a file is.
use std::ops::Range;
use std::sync::Arc;

use recede_layers::Pressing;
use recede_layers::tree::{Kind, Node};

use super::hints::did_you_mean;
use super::origin::{Origin, SceneError};
use super::read::{Draft, PRESSURE_ON_TOP, THE_SCENE, check_force, force_of};
use super::read_item::read_item;
use super::read_top::{only_top, read_top, tops};
use super::{Scene, quoted_list};

/// Most paths that a message lists.
const LISTED: usize = 24;

/// Where a quantity stands in the text of a scene.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slot {
    pub(crate) owner: Owner,
    /// The place of the number in the text.
    place: Range<usize>,
    value: f64,
}

/// The part of a scene to which a quantity belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    /// The scene itself: it is the force, or the half-length in its place.
    Force,
    /// The punches, or the loads in their place.
    Top,
    /// The pressure everywhere on the top face.
    PressureOnTop,
    /// The stack as a whole, which is no quantity.
    Stack,
    /// The item of the stack with this index.
    Item(usize),
}

/// A quantity and its new value.
pub(crate) type Change<'a> = (&'a Slot, f64);

impl Scene {
    /// The paths of all quantities that a sweep may vary, as written in the scene's text: `force`, `punch.radius`,
    /// `layer[1].thickness` and so on. Empty for a scene that was not read from a text.
    ///
    /// ```
    /// let scene = recede::Scene::read("examples/scenes/hertz.ron")?;
    /// assert_eq!(scene.paths(), ["force", "punch.radius", "layer[1].shear_modulus", "layer[1].poisson"]);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn paths(&self) -> Vec<String> {
        self.slots().into_iter().map(|(path, _)| path).collect()
    }

    /// The same scene with another value of the quantity at `path`. Only for scenes read from a text.
    ///
    /// ```
    /// let scene = recede::Scene::read("examples/scenes/hertz.ron")?.with("punch.radius", 250.0)?;
    /// assert_eq!(scene.top.written_in(scene.geometry), "Parabola(radius: 250.0)");
    /// let error = scene.with("layer[1].poisson", 0.7).unwrap_err();
    /// assert!(error.to_string().ends_with("`poisson` of layer 1 (HalfPlane): found 0.7, allowed is -1 < poisson <= 0.5"));
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError`] if there is no such quantity, or the value is not legal there.
    pub fn with(&self, path: &str, value: f64) -> Result<Self, SceneError> {
        let slot = self.slot(path)?;
        self.with_changes(&[(&slot, value)])
    }

    /// The value of the quantity at `path`, in the units of the scene. Only for scenes read from a text.
    ///
    /// ```
    /// let scene = recede::Scene::read("examples/scenes/hertz.ron")?;
    /// assert_eq!(scene.with("force", 2.5)?.number("force")?, 2.5);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError`] if there is no such quantity.
    pub fn number(&self, path: &str) -> Result<f64, SceneError> {
        self.slot(path).map(|slot| slot.value)
    }

    /// Finds the quantity at `path`.
    pub(crate) fn slot(&self, path: &str) -> Result<Slot, SceneError> {
        let Some(origin) = &self.origin else {
            let origin = Origin { file: "scene".into(), ..Origin::default() };
            return Err(origin.error(None, format!("there is no `{path}` in a scene that was not read from a text")));
        };
        let slots = self.slots();
        if let Some((_, slot)) = slots.iter().find(|(found, _)| found == path) {
            return Ok(slot.clone());
        }
        let names: Vec<&str> = slots.iter().map(|(path, _)| &path[..]).collect();
        let more = if names.len() > LISTED { ", ..." } else { "" };
        let allowed = quoted_list(&names[..names.len().min(LISTED)]);
        let message = format!("the scene has no quantity `{path}`; those that can vary are {allowed}{more}");
        Err(origin.error(None, message).hinted(did_you_mean(path, &names)))
    }

    /// The same scene with other values: what they belong to is read again. An error names the place of the value that the text has there.
    pub(crate) fn with_changes(&self, changes: &[Change]) -> Result<Self, SceneError> {
        let mut scene = self.clone();
        let Some(origin) = &mut scene.origin else { return Ok(scene) };
        set(&mut Arc::make_mut(origin).tree, changes);
        let origin = &Arc::clone(origin);
        for (slot, _) in changes {
            match slot.owner {
                Owner::Item(index) => {
                    let number = 1 + self.stack[..index].iter().filter(|item| !item.is_interface()).count();
                    let node = scene.node(slot.owner).unwrap_or(&origin.tree);
                    scene.stack[index] = read_item(node, number, self.geometry, origin)?;
                    continue;
                }
                Owner::Top => {
                    let (name, top) = only_top(origin)?;
                    scene.top = read_top(name, top, self.geometry, origin)?;
                }
                Owner::PressureOnTop => {
                    let draft: Draft = origin.read(&origin.tree, THE_SCENE)?;
                    scene.pressure_on_top = draft.pressure_on_top.map_or(0.0, Pressing::get);
                    continue;
                }
                Owner::Force | Owner::Stack => {}
            }
            // punches and loads in a list have forces of their own
            let (name, _) = only_top(origin)?;
            scene.force = force_of(&origin.read(&origin.tree, THE_SCENE)?, name, &scene.top, origin)?;
        }
        check_force(&scene, origin)?;
        Ok(scene)
    }

    /// All quantities by path.
    fn slots(&self) -> Vec<(String, Slot)> {
        let mut slots = Vec::new();
        let mut add = |name: &str, owner| {
            self.node(owner).into_iter().for_each(|node| add(name, owner, node, &mut slots));
        };
        add(self.force.field(), Owner::Force);
        add(PRESSURE_ON_TOP, Owner::PressureOnTop);
        let top = self.origin.iter().find_map(|origin| tops(&origin.tree).next());
        add(top.map_or("", |(name, _)| name), Owner::Top);
        let mut number = 0;
        for (index, item) in self.stack.iter().enumerate() {
            number += usize::from(!item.is_interface());
            let kind = if item.is_interface() { "interface" } else { "layer" };
            add(&format!("{kind}[{number}]"), Owner::Item(index));
        }
        slots
    }
}

/// Adds the quantities of a value to those found.
fn add(path: &str, owner: Owner, node: &Node, slots: &mut Vec<(String, Slot)>) {
    match &node.kind {
        Kind::Number(value) => slots.push((path.to_owned(), Slot { owner, place: node.place.clone(), value: *value })),
        Kind::Fields(fields) => {
            fields.iter().for_each(|field| add(&format!("{path}.{}", field.name), owner, &field.value, slots));
        }
        Kind::List(members) => {
            for (path, member) in numbered(path, members) {
                match &member.kind {
                    // of a row of a table: the value under its number, and where it is
                    Kind::Row(row) if row.len() == 2 => {
                        add(&format!("{path}.at"), owner, &row[0], slots);
                        add(&path, owner, &row[1], slots);
                    }
                    _ => add(&path, owner, member, slots),
                }
            }
        }
        // a number or a list behind a name, as in `Fixed(0.1)`, is the number or the list of the name
        Kind::Row(members) if node.name.is_some() => {
            members.iter().for_each(|member| add(path, owner, member, slots));
        }
        Kind::Row(members) => numbered(path, members).for_each(|(path, member)| add(&path, owner, member, slots)),
        Kind::Nothing | Kind::Text(_) => {}
    }
}

/// The members of a list with their paths.
fn numbered<'a>(path: &str, members: &'a [Node]) -> impl Iterator<Item = (String, &'a Node)> {
    members.iter().enumerate().map(move |(index, member)| (format!("{path}[{}]", index + 1), member))
}

/// Gives the values that change their new numbers.
fn set(node: &mut Node, changes: &[Change]) {
    if let Some((_, value)) = changes.iter().find(|(slot, _)| slot.place == node.place) {
        node.kind = Kind::Number(*value);
    }
    node.values_mut().into_iter().for_each(|value| set(value, changes));
}
