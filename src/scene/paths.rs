//! Quantities of a scene by path, such as `force` or `layer[2].beta`, and scenes in which they have other values.
//!
//! Values are replaced in the text, and what they belong to is read again: so a new value is checked as one in a file
//! is, and a mistake has a line and a column.
use std::ops::Range;
use std::sync::Arc;

use recede_layers::Positive;

use super::explain::bare_token;
use super::hints::did_you_mean;
use super::origin::{Origin, Places, SceneError};
use super::read::{parse, read_item, read_top};
use super::text::{Part, elements, field, fields, part, without_comments};
use super::{Force, Item, Punch, Scene, quoted_list};

/// Most paths that a message lists.
const LISTED: usize = 24;

/// Where a quantity stands in the text of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Slot {
    pub(crate) owner: Owner,
    /// Bytes of its number in the text.
    range: Range<usize>,
}

/// What a quantity belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    /// The scene itself: it is the force, or the half-length in its place.
    Force,
    /// The punch.
    Punch,
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
        self.slots().into_iter().map(|(path, _)| path).collect()
    }

    /// The same scene with another value of the quantity at `path`. Only for scenes read from a text.
    ///
    /// ```
    /// let text = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [
    ///     HalfPlane(shear_modulus: 1, poisson: 0.25)])";
    /// let scene = recede::Scene::from_ron(text)?.with("punch.radius", 250.0)?;
    /// assert_eq!(scene.punch.to_string(), "Parabola(radius: 250.0)");
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
        let slot = self.slot(path)?;
        let text = self.origin.as_deref().map_or("", |origin| &origin.text[slot.range]);
        // a slot is where a number was read
        Ok(text.parse().unwrap_or(f64::NAN))
    }

    /// Finds the quantity at `path`.
    pub(crate) fn slot(&self, path: &str) -> Result<Slot, SceneError> {
        let slots = self.slots();
        if let Some((_, slot)) = slots.iter().find(|(found, _)| found == path) {
            return Ok(slot.clone());
        }
        let nowhere = Origin { file: "scene".into(), ..Origin::default() };
        let origin = self.origin.as_deref().unwrap_or(&nowhere);
        let names: Vec<&str> = slots.iter().map(|(path, _)| &path[..]).collect();
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
        // in the text as written, so that a mistake is shown there
        let written = origin.written();
        let places = |range: &Range<usize>| origin.place(range.start)..origin.place(range.end);
        let slots: Vec<(Slot, f64)> =
            changes.iter().map(|(slot, value)| (Slot { range: places(&slot.range), ..**slot }, *value)).collect();
        let changes: Vec<Change> = slots.iter().map(|(slot, value)| (slot, *value)).collect();
        let text = changed(written, 0..written.len(), &changes);
        let new = Origin { text, source: None, places: Places::default(), ..(**origin).clone() };
        let mut origin = new.translated()?;
        let (scene, places) = parse(&origin)?;
        origin.places = places;
        Ok(Self { origin: Some(Arc::new(origin)), ..scene })
    }

    /// The force with other values; nothing but the force is read again.
    pub(crate) fn force_with(&self, changes: &[Change]) -> Result<Force, SceneError> {
        match changes.iter().find(|(slot, _)| slot.owner == Owner::Force) {
            Some((_, value)) => match Positive::try_from(*value) {
                Ok(number) => Ok(self.force.with(number)),
                Err(_) => self.with_changes(changes).map(|scene| scene.force),
            },
            None => Ok(self.force),
        }
    }

    /// The punch with other values; nothing but the punch is read again.
    pub(crate) fn punch_with(&self, changes: &[Change]) -> Result<Punch, SceneError> {
        let own = of(Owner::Punch, changes);
        let Some(origin) = self.origin.as_deref().filter(|_| !own.is_empty()) else {
            return Ok(self.punch.clone());
        };
        let at = &origin.places.punch;
        match read_top(&changed(&origin.text, at.start..at.end, &own), self.punch.load().is_some(), self.geometry) {
            Ok(punch) => Ok(punch),
            // once more, for the place of the mistake
            Err(_) => self.with_changes(changes).map(|scene| scene.punch),
        }
    }

    /// The items of the stack with other values; nothing but the items that change is read again.
    pub(crate) fn items_with(&self, changes: &[Change]) -> Result<Vec<Item>, SceneError> {
        let mut items = self.stack.clone();
        let Some(origin) = self.origin.as_deref() else { return Ok(items) };
        for (slot, _) in changes {
            let Owner::Item(index) = slot.owner else { continue };
            let (Some(item), Some(at)) = (items.get_mut(index), origin.places.items.get(index)) else { continue };
            let text = changed(&origin.text, at.start..at.end, &of(slot.owner, changes));
            let part = Part { text: &text, offset: 0, name_at: 0, owner: String::new() };
            match read_item(part, 1, &Origin { text: text.clone(), ..Origin::default() }, &origin.registry) {
                Ok(changed) => *item = changed,
                Err(_) => return self.with_changes(changes).map(|scene| scene.stack),
            }
        }
        Ok(items)
    }

    /// Where the number stands that says the force.
    pub(super) fn place_of_force(&self) -> Option<usize> {
        let text = &self.origin.as_deref()?.text[..];
        field(text, self.force.field()).map(|value| part(text, value).name_at)
    }

    fn slots(&self) -> Vec<(String, Slot)> {
        let Some(origin) = self.origin.as_deref() else { return Vec::new() };
        let text = &origin.text[..];
        let mut slots = Vec::new();
        let name = self.force.field();
        if let Some(force) = field(text, name) {
            add(name, Owner::Force, text, force, &mut slots);
        }
        let at = &origin.places.punch;
        let top = if self.punch.load().is_some() { "load" } else { "punch" };
        add(top, Owner::Punch, text, &text[at.start..at.end], &mut slots);
        let mut number = 0;
        for (index, (item, at)) in self.stack.iter().zip(&origin.places.items).enumerate() {
            number += usize::from(!item.is_interface());
            let kind = if item.is_interface() { "interface" } else { "layer" };
            add(&format!("{kind}[{number}]"), Owner::Item(index), text, &text[at.start..at.end], &mut slots);
        }
        slots
    }
}

/// Adds the quantities within `value`, a slice of `text`, to those found.
fn add(path: &str, owner: Owner, text: &str, value: &str, slots: &mut Vec<(String, Slot)>) {
    let value = without_comments(value);
    let number = bare_token(value);
    if number.parse::<f64>().is_ok() {
        let start = part(text, value).offset;
        slots.push((path.to_owned(), Slot { owner, range: start..start + number.len() }));
        return;
    }
    for (name, inner) in fields(value) {
        add(&format!("{path}.{name}"), owner, text, inner, slots);
    }
    for (index, inner) in elements(value).into_iter().enumerate() {
        add(&format!("{path}[{}]", index + 1), owner, text, inner, slots);
    }
}

fn of<'a>(owner: Owner, changes: &[Change<'a>]) -> Vec<Change<'a>> {
    changes.iter().filter(|(slot, _)| slot.owner == owner).copied().collect()
}

/// The bytes `within` of a text, with other numbers.
fn changed(text: &str, within: Range<usize>, changes: &[Change]) -> String {
    let mut changes = changes.to_vec();
    changes.sort_by_key(|(slot, _)| slot.range.start);
    let mut changed = String::with_capacity(within.len() + 24 * changes.len());
    let mut at = within.start;
    for (slot, value) in changes {
        changed += &text[at..slot.range.start];
        changed += &format!("{value:?}");
        at = slot.range.end;
    }
    changed + &text[at..within.end]
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!((changed.force, changed.punch.clone()), (Force::Given(0.004), Punch::cylinder(250.0).unwrap()));
        assert_eq!(changed.paths(), paths);
        // bit by bit is the same
        assert_eq!(scene.force_with(&changes).unwrap(), changed.force);
        assert_eq!(scene.punch_with(&changes).unwrap(), changed.punch);
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
            let parts = scene.force_with(&changes).err().or(scene.punch_with(&changes).err());
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
        let scene = Scene::new(scene.geometry, scene.punch, scene.force, scene.stack);
        assert!(scene.with("force", 1.0).unwrap_err().to_string().contains("not read from a text"));
    }
}
