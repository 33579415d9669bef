//! The example scenes with numbers, layers, interfaces, bases and punches changed at random.
//!
//! What the ranges of [`super::scenes`] do not reach: stacks of a single half-plane, layers of thickness 0, numbers far
//! from 1. A change that makes a scene illegal is left out, so every variant is a legal scene.
use proptest::prelude::*;
use proptest::sample::Index;
use recede_layers::Registry;

use super::strategy::drawn;
use crate::errors::Error;
use crate::scene::{Item, Scene};

macro_rules! scenes {
    ($($name:literal)*) => { [$(include_str!(concat!("../../examples/scenes/", $name, ".ron"))),*] };
}

/// The scenes that ship with the program.
pub const EXAMPLES: [&str; 31] = scenes! {
    "blunt_power" "bonded_coating" "bonded_to_rigid" "covered_rollers" "elastic_roller" "glued_coating" "graded_by_a_table" "hertz"
    "line_load" "measured_punch" "orthotropic_ply" "plate_on_springs" "polynomial_punch" "prescribed_half_length"
    "prescribed_depth" "rounded_flat" "sharp_flat" "sliding_leaves" "soil" "stiffening_ground" "strip_fgm_half_plane"
    "strip_on_rigid" "table1_strip_half_plane" "table2_graded_half_plane" "two_strips" "two_wheels" "uniform_load"
    "wedge" "curled_slab" "stressed_coating" "heavy_slab"
};

/// Most changes of structure and of numbers.
const STRUCTURE: usize = 3;
const NUMBERS: usize = 4;

/// One change of what a stack is made of; the places are drawn before it is known how many there are.
#[derive(Clone, Debug)]
enum Structure {
    /// A layer and the interface below it go.
    Remove(Index),
    /// A layer and the interface below it are there twice.
    Double(Index),
    /// A layer of another example comes on top, with an interface.
    Add(Index, Index, Item),
    Interface(Index, Item),
    /// The base of another example, or none but a rigid one.
    Base(Index),
    Rigid,
    /// Punch and force of another example.
    Punch(Index),
    /// Nothing but the base is left.
    BaseAlone,
}

/// One of the example scenes, changed: the same seed and number give the same scene.
///
/// # Errors
/// None in practice: only an example that cannot be read.
pub fn variant(seed: u64, number: u64) -> Result<Scene, Error> {
    let structure = prop::collection::vec(structure(), 0..=STRUCTURE);
    let numbers = prop::collection::vec((any::<Index>(), new_number()), 0..=NUMBERS);
    let (first, structure, numbers) = drawn(&(any::<Index>(), structure, numbers), seed, number);
    let mut scene = example(&first)?;
    for change in &structure {
        // a change that makes the scene illegal is left out
        scene = changed(&scene, change).unwrap_or(scene);
    }
    for (place, (factor, more)) in numbers {
        let paths = scene.paths();
        let path = place.get(&paths);
        let new = factor * scene.number(path).unwrap_or(1.0) + more;
        scene = scene.with(path, new).map_err(Error::from).and_then(checked).unwrap_or(scene);
    }
    Ok(scene)
}

fn example(index: &Index) -> Result<Scene, Error> {
    Ok(Scene::from_ron(EXAMPLES[index.index(EXAMPLES.len())])?)
}

fn structure() -> impl Strategy<Value = Structure> {
    let place = any::<Index>;
    let interface = || prop::sample::select(vec![Item::Bonded, Item::Receding, Item::Sliding]);
    prop_oneof![
        3 => place().prop_map(Structure::Remove),
        2 => place().prop_map(Structure::Double),
        3 => (place(), place(), interface()).prop_map(|(a, b, item)| Structure::Add(a, b, item)),
        3 => (place(), interface()).prop_map(|(place, item)| Structure::Interface(place, item)),
        3 => place().prop_map(Structure::Base),
        1 => Just(Structure::Rigid),
        3 => place().prop_map(Structure::Punch),
        2 => Just(Structure::BaseAlone),
    ]
}

/// A factor of a number, and what is added to it.
fn new_number() -> impl Strategy<Value = (f64, f64)> {
    let decades = |range: std::ops::Range<f64>| range.prop_map(|power| (10f64.powf(power), 0.0));
    prop_oneof![
        8 => decades(-1.0..1.0),
        4 => decades(-4.0..4.0),
        1 => decades(-12.0..12.0),
        1 => Just((0.0, 0.0)),
        1 => Just((0.0, 0.5)),
        1 => Just((-1.0, 0.0)),
    ]
}

/// The scene with one change; an error if it is no scene then.
fn changed(scene: &Scene, change: &Structure) -> Result<Scene, Error> {
    let (mut top, mut force, mut items) = (scene.top.clone(), scene.force, scene.stack.clone());
    // layers and interfaces alternate, and the base is the last item
    let base = items.len() - 1;
    // a layer with the interface below it; nothing of a base alone
    let pair = |index: &Index| {
        let first = 2 * index.index((base / 2).max(1));
        first..(first + 2).min(base)
    };
    match change {
        Structure::Remove(index) => drop(items.drain(pair(index))),
        Structure::Double(index) => {
            let copy = items[pair(index)].to_vec();
            items.splice(pair(index).start..pair(index).start, copy);
        }
        Structure::Add(other, index, interface) => {
            let others = example(other)?.stack;
            let layer = others[2 * index.index(others.len().div_ceil(2))].clone();
            items.splice(0..0, [layer, interface.clone()]);
        }
        Structure::Interface(index, interface) => {
            items[pair(index)].iter_mut().skip(1).for_each(|old| *old = interface.clone());
        }
        Structure::Base(other) => drop(items.splice(base.., example(other)?.stack.pop())),
        Structure::Rigid => items[base] = Item::Rigid,
        Structure::Punch(other) => {
            let other = example(other)?;
            (top, force) = (other.top, other.force);
        }
        Structure::BaseAlone => drop(items.drain(..base)),
    }
    let written = Scene::new(scene.geometry, top, force, items).to_ron();
    checked(Scene::from_reader("variant", written.as_bytes(), &Registry::default())?)
}

/// The same scene, if its items are a stack.
fn checked(scene: Scene) -> Result<Scene, Error> {
    scene.stack().map(|_| scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_examples_are_there() {
        let mut files: Vec<String> = std::fs::read_dir("examples/scenes")
            .unwrap()
            .map(|entry| std::fs::read_to_string(entry.unwrap().path()).unwrap())
            .collect();
        let mut known = EXAMPLES.map(str::to_owned).to_vec();
        files.sort();
        known.sort();
        assert_eq!(known, files);
    }

    #[test]
    fn variants_are_legal_repeatable_and_of_all_kinds() {
        let (mut bare, mut without_thickness, mut changed) = (0, 0, 0);
        for number in 0..300 {
            let scene = variant(5, number).unwrap();
            assert_eq!(scene.to_ron(), variant(5, number).unwrap().to_ron());
            let stack = scene.stack().unwrap();
            bare += usize::from(stack.total_thickness() == 0.0);
            without_thickness += usize::from(!stack.dropped().is_empty());
            changed +=
                usize::from(!EXAMPLES.iter().any(|text| Scene::from_ron(text).unwrap().to_ron() == scene.to_ron()));
        }
        assert!(bare > 30 && without_thickness > 2 && changed > 200, "{bare} {without_thickness} {changed}");
    }
}
