//! Quantities of a scene by path, such as `force` or `layer[2].beta`, and scenes in which they have other values.
//!
//! Values are replaced among those of the text, and what they belong to is read again: so a new value is checked as one in a
//! file is. Only a mistake, which has a line and a column, takes the whole text with the new values.
use std::ops::Range;

use recede_layers::Positive;
use recede_layers::tree::{Kind, Node};

use super::hints::did_you_mean;
use super::origin::{Origin, SceneError};
use super::read::{parse, read_item};
use super::read_top::{has_forces, read_top};
use super::{Force, Item, Scene, Top, quoted_list};

/// Most paths that a message lists.
const LISTED: usize = 24;

/// Where a quantity stands in the text of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Slot {
    pub(crate) owner: Owner,
    /// Where its number stands in the text.
    place: Range<usize>,
}

/// What a quantity belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    /// The scene itself: it is the force, or the half-length in its place.
    Force,
    /// The punches, or the loads in their place.
    Top,
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
    /// let text = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [
    ///     HalfPlane(shear_modulus: 1, poisson: 0.25)])";
    /// let scene = recede::Scene::from_ron(text)?;
    /// assert_eq!(scene.paths(), ["force", "punch.radius", "layer[1].shear_modulus", "layer[1].poisson"]);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn paths(&self) -> Vec<String> {
        self.slots().into_iter().map(|(path, ..)| path).collect()
    }

    /// The same scene with another value of the quantity at `path`. Only for scenes read from a text.
    ///
    /// ```
    /// let text = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [
    ///     HalfPlane(shear_modulus: 1, poisson: 0.25)])";
    /// let scene = recede::Scene::from_ron(text)?.with("punch.radius", 250.0)?;
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
        self.found(path).map(|(_, number)| number)
    }

    /// Finds the quantity at `path`.
    pub(crate) fn slot(&self, path: &str) -> Result<Slot, SceneError> {
        self.found(path).map(|(slot, _)| slot)
    }

    /// The same, with its value.
    fn found(&self, path: &str) -> Result<(Slot, f64), SceneError> {
        let mut slots = self.slots();
        if let Some(index) = slots.iter().position(|(found, ..)| found == path) {
            let (_, slot, number) = slots.swap_remove(index);
            return Ok((slot, number));
        }
        let nowhere = Origin { file: "scene".into(), ..Origin::default() };
        let origin = self.origin.as_deref().unwrap_or(&nowhere);
        let names: Vec<&str> = slots.iter().map(|(path, ..)| &path[..]).collect();
        if names.is_empty() {
            let message = format!("there is no `{path}` in a scene that was not read from a text");
            return Err(origin.error(None, message, None));
        }
        let more = if names.len() > LISTED { ", ..." } else { "" };
        let allowed = quoted_list(&names[..names.len().min(LISTED)]);
        let message = format!("the scene has no quantity `{path}`; those that can vary are {allowed}{more}");
        Err(origin.error(None, message, did_you_mean(path, &names)))
    }

    /// The same scene with other values.
    pub(crate) fn with_changes(&self, changes: &[Change]) -> Result<Self, SceneError> {
        let Some(origin) = &self.origin else { return Ok(self.clone()) };
        let text = changed(&origin.text, changes);
        parse(Origin { file: origin.file.clone(), text, registry: origin.registry.clone(), ..Origin::default() })
    }

    /// The force with other values; nothing but the force is read again, or the punches or loads whose forces it is the sum of.
    pub(crate) fn force_with(&self, changes: &[Change]) -> Result<Force, SceneError> {
        if self.node_of_top().is_some_and(|(name, _)| has_forces(name)) {
            return Ok(Force::Given(self.top_with(changes)?.force()));
        }
        match changes.iter().find(|(slot, _)| slot.owner == Owner::Force) {
            Some((_, value)) => match Positive::try_from(*value) {
                Ok(number) => Ok(self.force.with(number)),
                Err(_) => self.with_changes(changes).map(|scene| scene.force),
            },
            None => Ok(self.force),
        }
    }

    /// What presses with other values; nothing else is read again.
    pub(crate) fn top_with(&self, changes: &[Change]) -> Result<Top, SceneError> {
        let top = self.origin.as_deref().zip(self.node_of_top());
        let changed = top.and_then(|(origin, (name, node))| Some((origin, name, with(node, Owner::Top, changes)?)));
        let Some((origin, name, node)) = changed else { return Ok(self.top.clone()) };
        // where it is none, once more for the place of the mistake
        read_top(name, &node, self.geometry, origin).or_else(|_| self.with_changes(changes).map(|scene| scene.top))
    }

    /// The items of the stack with other values; nothing but the items that change is read again.
    pub(crate) fn items_with(&self, changes: &[Change]) -> Result<Vec<Item>, SceneError> {
        let mut items = self.stack.clone();
        let Some(origin) = self.origin.as_deref() else { return Ok(items) };
        let nodes = origin.tree.field("stack").map_or(&[][..], Node::members);
        for (slot, _) in changes {
            let Owner::Item(index) = slot.owner else { continue };
            let (Some(item), Some(node)) = (items.get_mut(index), nodes.get(index)) else { continue };
            let Some(node) = with(node, slot.owner, changes) else { continue };
            match read_item(&node, 1, origin) {
                Ok(changed) => *item = changed,
                Err(_) => return self.with_changes(changes).map(|scene| scene.stack),
            }
        }
        Ok(items)
    }

    /// All quantities by path, with their values.
    fn slots(&self) -> Vec<(String, Slot, f64)> {
        let Some(origin) = self.origin.as_deref() else { return Vec::new() };
        let mut slots = Vec::new();
        let force = origin.tree.field(self.force.field()).map(|node| (self.force.field(), Owner::Force, node));
        let top = self.node_of_top().map(|(name, node)| (name, Owner::Top, node));
        for (name, owner, node) in force.into_iter().chain(top) {
            add(name, owner, node, &mut slots);
        }
        let mut number = 0;
        let nodes = origin.tree.field("stack").map_or(&[][..], Node::members);
        for (index, (item, node)) in self.stack.iter().zip(nodes).enumerate() {
            number += usize::from(!item.is_interface());
            let kind = if item.is_interface() { "interface" } else { "layer" };
            add(&format!("{kind}[{number}]"), Owner::Item(index), node, &mut slots);
        }
        slots
    }
}

/// Adds the quantities of a value to those found.
fn add(path: &str, owner: Owner, node: &Node, slots: &mut Vec<(String, Slot, f64)>) {
    match &node.kind {
        Kind::Number(number) => slots.push((path.to_owned(), Slot { owner, place: node.place.clone() }, *number)),
        Kind::Fields(fields) => {
            fields.iter().for_each(|field| add(&format!("{path}.{}", field.name), owner, &field.value, slots));
        }
        Kind::List(members) => {
            let members = members.iter().enumerate();
            members.for_each(|(index, member)| add(&format!("{path}[{}]", index + 1), owner, member, slots));
        }
        // a number or a list behind a name, as in `Fixed(0.1)`, is the number or the list of the name
        Kind::Row(members) => {
            let is_only = node.name.is_some() && members.len() == 1;
            let own = members.iter().filter(|member| is_only || !member.members().is_empty());
            own.for_each(|member| add(path, owner, member, slots));
        }
        Kind::Nothing | Kind::Text(_) => {}
    }
}

/// A value of this owner with other numbers; `None` if none of its numbers changes.
fn with(node: &Node, owner: Owner, changes: &[Change]) -> Option<Node> {
    let own: Vec<&Change> = changes.iter().filter(|(slot, _)| slot.owner == owner).collect();
    let mut node = (!own.is_empty()).then(|| node.clone())?;
    set(&mut node, &own);
    Some(node)
}

fn set(node: &mut Node, changes: &[&Change]) {
    if let Some((_, value)) = changes.iter().find(|(slot, _)| slot.place == node.place) {
        node.kind = Kind::Number(*value);
    }
    match &mut node.kind {
        Kind::List(members) | Kind::Row(members) => members.iter_mut().for_each(|member| set(member, changes)),
        Kind::Fields(fields) => fields.iter_mut().for_each(|field| set(&mut field.value, changes)),
        Kind::Nothing | Kind::Number(_) | Kind::Text(_) => {}
    }
}

/// A text with other numbers.
fn changed(text: &str, changes: &[Change]) -> String {
    let mut changes = changes.to_vec();
    changes.sort_by_key(|(slot, _)| slot.place.start);
    let mut changed = String::with_capacity(text.len() + 24 * changes.len());
    let mut at = 0;
    for (slot, value) in changes {
        changed += &text[at..slot.place.start];
        changed += &format!("{value:?}");
        at = slot.place.end;
    }
    changed + &text[at..]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Punch;

    const SCENE: &str =
        "// force: 7\nScene(\n  geometry: PlaneStrain, punch: /* a: 1 */ Cylinder(radius: 500),\n  force: 0.002,
        stack: [Homogeneous(thickness: 1, shear_modulus: /* b */ 2.0 /* c */, poisson: 0.25), Receding, Rigid])";

    #[test]
    fn values_are_found_among_comments_and_replaced() {
        let scene = Scene::from_ron(SCENE).unwrap();
        let paths =
            ["force", "punch.radius", "layer[1].thickness", "layer[1].shear_modulus", "layer[1].poisson"].to_vec();
        assert_eq!(scene.paths(), paths);
        let slots: Vec<Slot> = paths.iter().map(|path| scene.slot(path).unwrap()).collect();
        let values = [0.004, 250.0, 3.0, 1e-7, 0.5];
        let changes: Vec<Change> = slots.iter().zip(values).collect();
        let changed = scene.with_changes(&changes).unwrap();
        assert_eq!(
            (changed.force, changed.top.clone()),
            (Force::Given(0.004), Top::from(Punch::cylinder(250.0).unwrap()))
        );
        assert_eq!(changed.paths(), paths);
        // bit by bit is the same
        assert_eq!(scene.force_with(&changes).unwrap(), changed.force);
        assert_eq!(scene.top_with(&changes).unwrap(), changed.top);
        assert_eq!(format!("{:?}", scene.items_with(&changes).unwrap()), format!("{:?}", changed.stack));
        assert!(format!("{:?}", changed.stack).contains("1e-7"), "{:?}", changed.stack);
    }

    #[test]
    fn mistakes_have_a_place_however_they_are_found() {
        let scene = Scene::from_ron(SCENE).unwrap();
        let said = |path: &str| {
            let slot = scene.slot(path).unwrap();
            let changes = [(&slot, -1.0)];
            let whole = scene.with_changes(&changes).unwrap_err().to_string();
            let parts = scene.force_with(&changes).err().or(scene.top_with(&changes).err());
            assert_eq!(parts.or(scene.items_with(&changes).err()).unwrap().to_string(), whole);
            whole
        };
        assert_eq!(said("force"), "scene:4:10: `force` of the scene: found -1.0, allowed is a finite number > 0");
        assert_eq!(
            said("punch.radius"),
            "scene:3:61: `radius` of the punch: found -1.0, allowed is a finite number > 0"
        );
        assert!(said("layer[1].thickness").starts_with("scene:5:40: `thickness` of layer 1 (Homogeneous): found -1.0"));
    }

    #[test]
    fn who_asks_for_something_else_is_told_what_there_is() {
        let scene = Scene::from_ron(SCENE).unwrap();
        let error = scene.with("layer[1].posson", 0.3).unwrap_err();
        assert_eq!(error.hint().unwrap(), "did you mean `layer[1].poisson`?");
        assert!(error.to_string().contains("those that can vary are `force`, `punch.radius`, `layer[1].thickness`"));
        let scene = Scene::new(scene.geometry, scene.top, scene.force, scene.stack);
        assert!(scene.with("force", 1.0).unwrap_err().to_string().contains("not read from a text"));
    }
}
