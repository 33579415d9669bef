//! Stresses and strains by which layers and bonds break: as JSON, as a table, and as columns of a sweep.
use comfy_table::Table;
use serde_json::{Value, json};

use super::digits::{Digits, to_digits};
use super::ruled::ruled;
use crate::field::{BondExtremes, Extreme, Extremes, LayerExtremes};
use crate::scene::{Item, Scene};

/// Columns of a sweep behind a stress: its error, and where it is largest. Of these the depth is known on an interface, and the layer
/// wherever the name of the column has it.
const PLACE: [&str; 4] = ["error", "x", "depth", "layer"];

pub(super) fn json(scene: &Scene, extremes: &Extremes) -> Value {
    let layer = |of: &LayerExtremes| {
        let mut layer = json!(of);
        scene.layer_name(of.layer).into_iter().for_each(|name| layer["name"] = name.into());
        layer
    };
    let bond = |of: &BondExtremes| json!({"interface": name(of), "shear": of.shear, "tension": of.tension});
    json!({
        "tension": extremes.tension,
        "layers": extremes.layers.iter().map(layer).collect::<Vec<_>>(),
        "interfaces": extremes.bonds.iter().map(bond).collect::<Vec<_>>(),
    })
}

fn name(bond: &BondExtremes) -> String {
    format!("{}|{}", bond.above, bond.below)
}

/// A table with a line for each stress or strain; `place` is what its place along the layers is called.
pub(super) fn table(
    scene: &Scene,
    extremes: &Extremes,
    place: &str,
    digits: Digits,
    [length, stress]: [&str; 2],
) -> Table {
    let mut table = ruled([("largest", ""), ("stress", stress), (&format!("at {place}"), length), ("depth", length)]);
    let mut add = |what: String, found: Option<Extreme>, none: &str| {
        let row = match found {
            Some(Extreme { value, error, x, depth, .. }) => {
                [digits.or_infinite(value, error), to_digits(x, 4), to_digits(depth, 4)]
            }
            None => [none.to_owned(), String::new(), String::new()],
        };
        table.add_row([what].into_iter().chain(row));
    };
    let within = extremes.tension.map(|found| format!(" ({})", scene.layer_label(found.layer)));
    add(format!("tension{}", within.unwrap_or_default()), extremes.tension, "none");
    for LayerExtremes { layer, von_mises, tensile_strain } in &extremes.layers {
        let layer = scene.layer_label(*layer);
        add(format!("{layer}: von Mises stress"), *von_mises, "not known");
        add(format!("{layer}: tensile strain (no unit)"), *tensile_strain, "none");
    }
    for bond in &extremes.bonds {
        add(format!("{}: shear stress", name(bond)), bond.shear, "none");
        add(format!("{}: opening tension", name(bond)), bond.tension, "none");
    }
    table
}

/// The columns of a sweep by name, with the numbers of a row. They are the same whichever layers are there: each layer that the scene has
/// may have them, and the interface below it unless that opens. NaN for what is not there; a tension or shear stress that is
/// nowhere is 0.
pub(super) fn cells(scene: &Scene, extremes: Option<&Extremes>) -> Vec<(String, f64)> {
    let mut cells = Vec::new();
    let mut add = |name: String, places: &[&str], found: Option<Extreme>, nowhere: f64| {
        let numbers = found.map_or([nowhere, f64::NAN, f64::NAN, f64::NAN, f64::NAN], |found| {
            [found.value, found.error, found.x, found.depth, found.layer as f64]
        });
        let names = places.iter().map(|place| format!("{name}_{place}"));
        cells.extend([name.clone()].into_iter().chain(names).zip(numbers));
    };
    let zero = if extremes.is_some() { 0.0 } else { f64::NAN };
    add("tension".to_owned(), &PLACE, extremes.and_then(|extremes| extremes.tension), zero);
    for (number, has_bond) in layers(scene) {
        let layer = extremes.and_then(|extremes| extremes.layers.iter().find(|layer| layer.layer == number));
        let [von_mises, strain] = [|own: &LayerExtremes| own.von_mises, |own: &LayerExtremes| own.tensile_strain];
        add(format!("layer_{number}_von_mises"), &PLACE[..3], layer.and_then(von_mises), f64::NAN);
        let zero = if layer.is_some() { 0.0 } else { f64::NAN };
        add(format!("layer_{number}_tensile_strain"), &PLACE[..3], layer.and_then(strain), zero);
        if has_bond {
            let bond = extremes.and_then(|extremes| extremes.bonds.iter().find(|bond| bond.above == number));
            let zero = if bond.is_some() { 0.0 } else { f64::NAN };
            add(format!("below_layer_{number}_shear"), &PLACE[..2], bond.and_then(|bond| bond.shear), zero);
            add(format!("below_layer_{number}_tension"), &PLACE[..2], bond.and_then(|bond| bond.tension), zero);
        }
    }
    cells
}

/// The numbers of the elastic layers of a scene, and whether there may be an interface below that does not open.
fn layers(scene: &Scene) -> impl Iterator<Item = (usize, bool)> {
    let items = scene.stack.iter().enumerate().filter(|(_, item)| !item.is_interface());
    items.zip(1..).filter_map(|((index, item), number)| {
        let below = scene.stack.get(index + 1);
        matches!(item, Item::Layer(_)).then(|| (number, below.is_some_and(|item| !item.is_receding())))
    })
}
