//! Reading what presses on top: a punch or a load, or a list of them.
use recede_layers::description::Value;
use recede_layers::tree::{Fault, Form, Kind, Node};
use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::origin::{Origin, SceneError};
use super::part::Part;
use super::round::{RoundLoad, RoundPunch};
use super::value::{LoadsError, PunchesError, ValueError};
use super::{Load, Loads, PlacedLoad, Pressed, Punch, Punches, Top};
use crate::geometry::Geometry;

/// The fields of a scene one of which says what presses on top.
pub(super) const TOPS: [&str; 4] = ["punch", "punches", "load", "loads"];

/// Whether what stands in one of these fields has forces of its own.
pub(super) fn has_forces(name: &str) -> bool {
    matches!(name, "punches" | "loads")
}

/// The one of these fields that is given.
pub(super) fn only_top(given: &[&'static str], origin: &Origin) -> Result<&'static str, SceneError> {
    let tree = &origin.tree;
    match given[..] {
        [name] => Ok(name),
        [] => {
            let hint =
                "add `punch: ...` or, for given pressures, `load: ...` or `loads: [...]` between its parentheses";
            let message = "`punch` is missing in the scene".into();
            Err(origin.error(Some(tree.place.start), message, Some(hint.into())))
        }
        [first, second, ..] => {
            let at = tree.field(second).map(|node| node.place.start);
            let hint = match (first, second) {
                ("punch", "punches") => "one punch at x = 0 is `punch`, several are `punches`: remove one of them",
                ("punch" | "punches", _) => "a load takes the place of a punch: remove one of them",
                _ => "one load about x = 0 is `load`, several are `loads`: remove one of them",
            };
            Err(origin.error(at, format!("the scene has `{first}` and `{second}`"), Some(hint.into())))
        }
    }
}

/// Reads what presses on top from the field of a scene in which it stands.
pub(super) fn read_top(name: &str, node: &Node, geometry: Geometry, origin: &Origin) -> Result<Top, SceneError> {
    let owner = format!("the {name}");
    let part = &Part { node, owner: &owner };
    let explained = |form: fn() -> Value| move |error| part.error_of(Some(&form()), origin, error);
    match (name, geometry) {
        ("loads", _) => loads(part, geometry, origin).map(Top::Loads),
        ("punches", _) => punches(part, geometry, origin).map(Top::Punches),
        ("load", _) if node.name.as_deref() == Some(SEVERAL) => Err(several(node, origin)),
        ("load", Geometry::Axisymmetric) => {
            node.read::<RoundLoad>().map(|load| Load::from(load).into()).map_err(explained(Value::of::<RoundLoad>))
        }
        ("load", _) => node.read::<Load>().map(Top::from).map_err(explained(Value::of::<Load>)),
        (_, Geometry::Axisymmetric) => {
            node.read::<RoundPunch>().map(|punch| Punch::from(punch).into()).map_err(explained(Value::of::<RoundPunch>))
        }
        _ => node.read::<Punch>().map(Top::from).map_err(explained(Value::of::<Punch>)),
    }
}

/// Reads a list of loads.
fn loads(list: &Part, geometry: Geometry, origin: &Origin) -> Result<Loads, SceneError> {
    let hint = "about an axis write `load: ...`, which is one disc, one ring, or a point force";
    let members: Vec<PlacedLoad> = members(list, "load", (geometry, hint), origin)?;
    members.try_into().map_err(|cause: LoadsError| refused(list.node, cause, origin))
}

/// Reads a list of punches.
fn punches(list: &Part, geometry: Geometry, origin: &Origin) -> Result<Punches, SceneError> {
    let hint = "about an axis write `punch: ...`, which is one punch about the axis";
    let members: Vec<Pressed> = members(list, "punch", (geometry, hint), origin)?;
    members.try_into().map_err(|cause: PunchesError| {
        let (number, path) = cause.place().unwrap_or_default();
        let whole = number.checked_sub(1).and_then(|index| list.node.members().get(index)).unwrap_or(list.node);
        let node = path.iter().fold(whole, |node, name| node.field(name).unwrap_or(node));
        refused(node, cause, origin)
    })
}

/// The error where the members of a list make none.
fn refused(node: &Node, cause: impl Into<ValueError>, origin: &Origin) -> SceneError {
    let cause = cause.into();
    origin.error(Some(node.place.start), cause.to_string(), None).because(cause)
}

/// Reads the members of a list, each called by a word with its number; about an axis there is none, with a hint.
fn members<T: DeserializeOwned>(
    list: &Part,
    word: &str,
    (geometry, hint): (Geometry, &str),
    origin: &Origin,
) -> Result<Vec<T>, SceneError> {
    let start = list.node.place.start;
    if geometry.is_axisymmetric() {
        let name = list.owner.trim_start_matches("the ");
        return Err(origin.error(Some(start), format!("`{name}` are for plane scenes"), Some(hint.into())));
    }
    let Kind::List(members) = &list.node.kind else {
        return Err(list.error(origin, Fault::Expected(Form::List).at(start)));
    };
    let read = |(i, node): (usize, &Node)| {
        let owner = format!("{word} {}", i + 1);
        let named = node.name.as_ref().map(|_| Fault::Expected(Form::Open).at(node.place.start));
        named.map_or_else(|| node.read::<T>(), Err).map_err(|error| Part { node, owner: &owner }.error(origin, error))
    };
    members.iter().enumerate().map(read).collect()
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
    let force = origin
        .tree
        .field("force")
        .and_then(|force| if let Kind::Number(force) = force.kind { Some(force) } else { None });
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
    let message = "`Several` is written as `loads`, each with its place and its force".to_owned();
    origin.error(Some(node.place.start), message, Some(hint))
}
