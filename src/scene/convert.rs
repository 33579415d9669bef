//! Numbers with a unit become numbers in the units of the scene.
use recede_layers::tree::{Entry, Kind, Node};

use super::origin::{Origin, SceneError};
use super::units::{Dimension, Units, converted, has_unit};

/// Converts the numbers with a unit in the tree of a scene.
pub(super) fn without_units(scene: &mut Node, origin: &Origin) -> Result<(), SceneError> {
    let units: Option<Units> = scene.field("units").and_then(|units| units.read().ok());
    let is_round = scene.field("geometry").is_some_and(|geometry| geometry.name.as_deref() == Some("Axisymmetric"));
    let Kind::Fields(fields) = &mut scene.kind else { return Ok(()) };
    let of_numbers = fields.iter_mut().filter(|field| !matches!(&*field.name, "name" | "description" | "units"));
    for Entry { name, value, .. } in of_numbers {
        // numbers of punches that say nothing else are lengths: heights and places in tables
        let own = if &**name == "force" && is_round { Some(Dimension::FORCE) } else { Dimension::of_field(name) };
        let dimension = own.or(matches!(&**name, "punch" | "punches").then_some(Dimension::LENGTH));
        convert(value, dimension, units.as_ref(), origin)?;
    }
    Ok(())
}

/// Converts the numbers with a unit within a value, which are to be measured in `dimension` unless their field says more.
fn convert(
    node: &mut Node,
    dimension: Option<Dimension>,
    units: Option<&Units>,
    origin: &Origin,
) -> Result<(), SceneError> {
    let is_row = node.name.is_none() && matches!(node.kind, Kind::Row(_));
    match &mut node.kind {
        Kind::Text(text) if has_unit(text) => {
            let failed =
                |(message, hint): (String, String)| origin.error(Some(node.place.start), message).hinted(Some(hint));
            node.kind = Kind::Number(converted(text, dimension, units).map_err(failed)?);
        }
        Kind::Fields(fields) => {
            for Entry { name, value, .. } in fields {
                convert(value, Dimension::of_field(name).or(dimension), units, origin)?;
            }
        }
        Kind::List(members) | Kind::Row(members) => {
            for (index, member) in members.iter_mut().enumerate() {
                // of the rows of a table, the first number is a place
                let dimension = if is_row && index == 0 { Some(Dimension::LENGTH) } else { dimension };
                convert(member, dimension, units, origin)?;
            }
        }
        Kind::Nothing | Kind::Number(_) | Kind::Text(_) => {}
    }
    Ok(())
}
