//! What texts, lists and objects of JSON stand for in a tree.
use super::{Entry, Fault, Kind, Node, ReadError};

/// The key under which a text in JSON may say, for editors, by which schema it is written.
const SCHEMA: &str = "$schema";
/// Fields whose texts are no names, even with a capital letter.
const LABELS: [&str; 4] = ["name", "description", "length", "force"];

/// Letters, digits and underscores, a letter first.
fn is_word(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic()) && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// A word with a capital letter.
fn is_name(text: &str) -> bool {
    is_word(text) && text.starts_with(|c: char| c.is_ascii_uppercase())
}

/// A text that is a word with a capital letter is a name.
pub(super) fn name_of_text(node: Node) -> Node {
    match node.kind {
        Kind::Text(name) if is_name(&name) => {
            Node { name: Some(name.into()), inner: node.place.end, kind: Kind::Nothing, ..node }
        }
        _ => node,
    }
}

/// Lists in a list are rows.
pub(super) fn rows(mut members: Vec<Node>) -> Vec<Node> {
    for member in &mut members {
        if let Kind::List(row) = &mut member.kind {
            member.kind = Kind::Row(std::mem::take(row));
        }
    }
    members
}

/// What an object with these fields says: a name with what follows it, or fields. `text` is all that is read.
pub(super) fn object(object: Node, text: &str) -> Result<Node, ReadError> {
    let Kind::Fields(mut fields) = object.kind else { return Ok(object) };
    if fields.first().is_some_and(|field| is_name(&field.name)) {
        if let Some(second) = fields.get(1) {
            let name = &fields[0].name;
            let hint = format!("what belongs to `{name}` stands in an object of its own: `{{\"{name}\": {{...}}}}`");
            return Err(Fault::syntax(format!("`{name}` is followed by a second key"), &hint).at(second.at));
        }
        return Ok(named(fields.swap_remove(0), object.place.end));
    }
    fields.retain(|field| &*field.name != SCHEMA);
    if let Some(Entry { name, at, .. }) = fields.iter().find(|field| !is_word(&field.name)) {
        let message = format!("`{}` is no name of a field", name.chars().take(40).collect::<String>());
        let hint = "names of fields are those of a scene in RON, such as `shear_modulus`";
        return Err(Fault::syntax(message, hint).at(*at));
    }
    for Entry { name, value, .. } in &mut fields {
        let is_label = LABELS.contains(&&**name) && text[value.place.start..].starts_with('"');
        if let Some(label) = value.name.take_if(|_| is_label) {
            value.kind = Kind::Text(label.into());
        }
    }
    Ok(Node { kind: Kind::Fields(fields), ..object })
}

/// The name that is the only key of an object, which ends at a place, with what follows it.
fn named(only: Entry, end: usize) -> Node {
    let Entry { name, at, value } = only;
    let inner = value.place.start;
    let kind = match (value.name.as_deref(), value.kind) {
        (Some("None"), Kind::Nothing) => Kind::Nothing,
        (None, Kind::Fields(fields)) => Kind::Fields(fields),
        (_, kind) => Kind::Row(vec![Node { kind, ..value }]),
    };
    Node { name: Some(name), inner, place: at..end, kind }
}
