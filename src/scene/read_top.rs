//! Reading what presses on top: a punch or a load, or a list of them.
use recede_layers::tree::{Fault, Form, Kind, Node};
use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::loads::PlacedRoundLoad;
use super::origin::{Origin, SceneError};
use super::read_item::read_covered;
use super::round::{RoundLoad, RoundPunch};
use super::value::{ListError, ValueError};
use super::{Load, Loads, PlacedLoad, Pressed, Punch, Punches, Top};
use crate::geometry::Geometry;

/// The fields of a scene one of which says what presses on top.
pub(super) const TOPS: [&str; 4] = ["punch", "punches", "load", "loads"];

/// Those of these fields that are given.
pub(super) fn tops(scene: &Node) -> impl Iterator<Item = (&'static str, &Node)> {
    let given = TOPS.into_iter().filter_map(|name| Some((name, scene.field(name)?)));
    given.filter(|(_, node)| node.name.as_deref() != Some("None") || node.kind != Kind::Nothing)
}

/// The one of these fields that is given.
pub(super) fn only_top(origin: &Origin) -> Result<(&'static str, &Node), SceneError> {
    let given: Vec<_> = tops(&origin.tree).collect();
    match given[..] {
        [only] => Ok(only),
        [] => {
            let hint =
                "add `punch: ...` or, for given pressures, `load: ...` or `loads: [...]` between its parentheses";
            Err(origin.error_at(&origin.tree, "`punch` is missing in the scene").hinted(Some(hint)))
        }
        [(first, _), (second, _), ..] => {
            let hint = match (first, second) {
                ("punch", "punches") => "one punch at x = 0 is `punch`, several are `punches`: remove one of them",
                ("punch" | "punches", _) => "a load takes the place of a punch: remove one of them",
                _ => "one load about x = 0 is `load`, several are `loads`: remove one of them",
            };
            Err(origin.both(first, second, hint))
        }
    }
}

/// Reads what presses on top from the field of a scene in which it stands.
pub(super) fn read_top(name: &str, node: &Node, geometry: Geometry, origin: &Origin) -> Result<Top, SceneError> {
    let owner = format!("the {name}");
    let not_round = |hint: &str| {
        let error = origin.error_at(node, format!("`{name}` are for plane scenes"));
        Err(error.hinted(Some(format!("about an axis write {hint}"))))
    };
    match (name, geometry.is_axisymmetric()) {
        ("loads", true) => list::<PlacedRoundLoad, PlacedLoad, Loads>(node, ["load", name], origin).map(Top::from),
        ("loads", false) => list::<PlacedLoad, PlacedLoad, Loads>(node, ["load", name], origin).map(Top::from),
        ("punches", true) => not_round("`punch: ...`, which is one punch about the axis"),
        ("punches", false) => list::<Pressed, Pressed, Punches>(node, ["punch", name], origin).map(Top::from),
        ("load", _) if node.name.as_deref() == Some(SEVERAL) => Err(several(node, origin)),
        ("load", true) => origin.read::<RoundLoad>(node, &owner).map(|load| Load::from(load).into()),
        ("load", false) => origin.read::<Load>(node, &owner).map(Top::from),
        (_, _) if node.name.as_deref() == Some("Covered") => {
            read_covered(node, geometry, origin).map(|covered| Punch::Covered(covered).into())
        }
        (_, true) => origin.read::<RoundPunch>(node, &owner).map(|punch| Punch::from(punch).into()),
        (_, false) => origin.read::<Punch>(node, &owner).map(Top::from),
    }
}

/// Reads a list of punches or loads as they are written; in messages each has a word and its number.
fn list<T, M, L>(list: &Node, [one, all]: [&str; 2], origin: &Origin) -> Result<L, SceneError>
where
    T: DeserializeOwned,
    M: From<T>,
    L: TryFrom<Vec<M>, Error = ListError>,
{
    let nodes = origin.list(list, &format!("the {all}"))?;
    let read = |(i, node): (usize, &Node)| {
        let named = node.name.as_ref().map(|_| Fault::Expected(Form::Open).at(node.place.start));
        let read = named.map_or_else(|| node.read::<T>(), Err);
        read.map(M::from).map_err(|error| origin.explained(node, &format!("{one} {}", i + 1), None, error))
    };
    let members = nodes.iter().enumerate().map(read).collect::<Result<Vec<M>, _>>()?;
    members.try_into().map_err(|cause: ListError| {
        let (number, path) = cause.place().unwrap_or_default();
        let whole = number.checked_sub(1).and_then(|index| nodes.get(index)).unwrap_or(list);
        let node = path.iter().fold(whole, |node, name| node.field(name).unwrap_or(node));
        origin.error_at(node, cause.to_string()).because(ValueError::from(cause))
    })
}

/// The name under which scenes once had several loads, each with its mirror image and a share of the force.
const SEVERAL: &str = "Several";
/// Most of the new lines that are shown in its place.
const SHOWN: usize = 6;

/// The error where a scene still has `Several`, with what to write in its place.
fn several(node: &Node, origin: &Origin) -> SceneError {
    #[derive(Deserialize)]
    struct Shared {
        at: f64,
        share: f64,
        load: Load,
    }
    let force = origin.tree.field("force").and_then(|force| force.read::<f64>().ok());
    let lines = |parts: Vec<Shared>| {
        let shares: f64 = parts.iter().map(|part| part.share).sum();
        let line = |Shared { at, share, load }: &Shared| {
            let places = if *at > 0.0 { vec![-at, *at] } else { vec![*at] };
            let force = share * force.unwrap_or(shares) / shares / places.len() as f64;
            places.into_iter().map(|at| format!("(load: {load}, at: {at:?}, force: {force:?})")).collect::<Vec<_>>()
        };
        let lines: Vec<String> = parts.iter().flat_map(line).collect();
        let more = if lines.len() > SHOWN { ", ..." } else { "" };
        format!("[{}{more}]", lines[..lines.len().min(SHOWN)].join(", "))
    };
    let lines = node.read_inner().map_or_else(|_| "[(load: ..., at: ..., force: ...), ...]".to_owned(), lines);
    let hint = format!("in place of `load` and `force` write `loads: {lines}`");
    let message = "`Several` is written as `loads`, each with its place and its force";
    origin.error_at(node, message).hinted(Some(hint))
}
