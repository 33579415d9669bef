//! Stresses by which layers and bonds break: as JSON, as a table, and as columns of a sweep.
use comfy_table::Table;
use serde::Serialize;

use super::digits::{Digits, shown};
use super::ruled::ruled;
use crate::field::{BondExtremes, Extreme, Extremes, LayerExtremes};
use crate::scene::{Item, Scene};

/// Columns of a sweep for one stress: where it is largest, and the layer where that is not known from the name.
const PLACE: [&str; 4] = ["error", "x", "depth", "layer"];
/// The columns for a stress on an interface, the depth of which is known.
const ALONG: [&str; 2] = ["error", "x"];

#[derive(Serialize)]
pub(super) struct Document {
    tension: Option<Stress>,
    layers: Vec<Layer>,
    interfaces: Vec<Bond>,
}

#[derive(Serialize)]
struct Layer {
    layer: usize,
    von_mises: Option<Stress>,
}

#[derive(Serialize)]
struct Bond {
    interface: String,
    shear: Option<Stress>,
    tension: Option<Stress>,
}

#[derive(Serialize)]
struct Stress {
    /// `null` if it is infinite.
    value: Option<f64>,
    error: f64,
    x: f64,
    depth: f64,
    layer: usize,
}

impl Stress {
    fn of(Extreme { value, error, x, depth, layer }: Extreme) -> Self {
        Self { value: value.is_finite().then_some(value), error, x, depth, layer }
    }
}

impl Document {
    pub(super) fn of(extremes: &Extremes) -> Self {
        let layer = |of: &LayerExtremes| Layer { layer: of.layer, von_mises: of.von_mises.map(Stress::of) };
        let bond = |of: &BondExtremes| Bond {
            interface: name(of),
            shear: of.shear.map(Stress::of),
            tension: of.tension.map(Stress::of),
        };
        Self {
            tension: extremes.tension.map(Stress::of),
            layers: extremes.layers.iter().map(layer).collect(),
            interfaces: extremes.bonds.iter().map(bond).collect(),
        }
    }
}

fn name(bond: &BondExtremes) -> String {
    format!("{}|{}", bond.above, bond.below)
}

/// A table with a line for each stress; `place` is what its place along the layers is called.
pub(super) fn table(extremes: &Extremes, place: &str, digits: Digits, [length, stress]: [&str; 2]) -> Table {
    let mut table = ruled();
    let header = |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name},{unit}") };
    table.set_header([
        "largest".to_owned(),
        header("stress", stress),
        header(&format!("at {place}"), length),
        header("depth", length),
    ]);
    let mut add = |what: String, found: Option<Extreme>, none: &str| {
        let row = match found {
            Some(Extreme { value, error, x, depth, .. }) => [
                if value.is_finite() { digits.with_error(value, error) } else { "infinite".to_owned() },
                shown::<3>(x),
                shown::<3>(depth),
            ],
            None => [none.to_owned(), String::new(), String::new()],
        };
        table.add_row([what].into_iter().chain(row));
    };
    let layer = |found: Option<Extreme>| found.map_or(String::new(), |found| format!(" (layer {})", found.layer));
    add(format!("tension{}", layer(extremes.tension)), extremes.tension, "none");
    for LayerExtremes { layer, von_mises } in &extremes.layers {
        add(format!("layer {layer}: von Mises stress"), *von_mises, "not known");
    }
    for bond in &extremes.bonds {
        add(format!("{}: shear stress", name(bond)), bond.shear, "none");
        add(format!("{}: opening tension", name(bond)), bond.tension, "none");
    }
    table
}

/// The columns of a sweep, which are the same whichever layers are there: each layer that the scene has may have them, and the interface
/// below it unless that is one that opens.
pub(super) fn columns(scene: &Scene) -> Vec<String> {
    let with = |name: String, places: &[&str]| {
        let places: Vec<String> = places.iter().map(|place| format!("{name}_{place}")).collect();
        [name].into_iter().chain(places)
    };
    let mut columns: Vec<String> = with("tension".to_owned(), &PLACE).collect();
    for (number, has_bond) in layers(scene) {
        columns.extend(with(format!("layer_{number}_von_mises"), &PLACE[..3]));
        if has_bond {
            columns.extend(with(format!("below_layer_{number}_shear"), &ALONG));
            columns.extend(with(format!("below_layer_{number}_tension"), &ALONG));
        }
    }
    columns
}

/// The numbers of a row in these columns; NaN for what is not there. A tension or shear stress that is nowhere is 0.
pub(super) fn numbers(scene: &Scene, extremes: Option<&Extremes>) -> Vec<f64> {
    let Some(extremes) = extremes else { return vec![f64::NAN; columns(scene).len()] };
    let number = |found: Option<Extreme>| match found {
        Some(Extreme { value, error, x, depth, layer }) => [value, error, x, depth, layer as f64],
        None => [f64::NAN; 5],
    };
    // nowhere: 0, without a place
    let or_none = |found: Option<Extreme>| {
        let mut numbers = number(found);
        numbers[0] = if found.is_none() { 0.0 } else { numbers[0] };
        numbers
    };
    let mut all = or_none(extremes.tension).to_vec();
    for (number_of, has_bond) in layers(scene) {
        let layer = extremes.layers.iter().find(|layer| layer.layer == number_of);
        all.extend(&number(layer.and_then(|layer| layer.von_mises))[..4]);
        if has_bond {
            let bond = extremes.bonds.iter().find(|bond| bond.above == number_of);
            let [shear, tension] = match bond {
                Some(bond) => [bond.shear, bond.tension].map(or_none),
                None => [[f64::NAN; 5]; 2],
            };
            all.extend(shear[..3].iter().chain(&tension[..3]));
        }
    }
    all
}

/// The numbers of the elastic layers of a scene, and whether there may be an interface below that does not open.
fn layers(scene: &Scene) -> impl Iterator<Item = (usize, bool)> {
    let items = scene.stack.iter().enumerate().filter(|(_, item)| !item.is_interface());
    items.zip(1..).filter_map(|((index, item), number)| {
        let below = scene.stack.get(index + 1);
        matches!(item, Item::Layer(_)).then(|| (number, below.is_some_and(|item| !matches!(item, Item::Receding))))
    })
}
