//! What the RON reader says, in words of the scene: what was found, what is allowed, what to do.
use recede_layers::description::Value;
use ron::Error as Code;

use super::hints::{directions, instead_of, is_unit, number_of_material};
use super::quoted_list;

/// The part of a scene that was being read.
pub(super) struct Subject<'a> {
    /// E.g. `layer 1 (Homogeneous)`.
    pub owner: &'a str,
    /// The field of it, e.g. `poisson`, if one was being read.
    pub field: Option<&'a str>,
    /// The name of what was being read, and what may stand in its parentheses, if that is known.
    pub form: Option<(&'a str, &'a Value)>,
}

/// Which end of the span reported by the reader is the place of the error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum At {
    /// The beginning of the last token read.
    Token,
    /// Where the next token was expected.
    Next,
    /// The name of the layer or punch that was being read.
    Owner,
}

impl Subject<'_> {
    /// E.g. `` `poisson` of layer 1 (Homogeneous) ``.
    fn name(&self) -> String {
        match self.field {
            Some(field) => format!("`{field}` of {}", self.owner),
            None => self.owner.to_owned(),
        }
    }

    /// How the structure that was being read is written, e.g. `young: (x: ..., y: ..., z: ...)`, if it has the same fields always.
    fn written(&self) -> Option<String> {
        let (name, mut form) = self.form?;
        for part in self.field.iter().flat_map(|path| path.split('.')) {
            let Value::Fields(fields) = form else { return None };
            form = &fields.iter().find(|field| field.name == part)?.value;
        }
        let Value::Fields(fields) = form else { return None };
        if fields.iter().any(|field| field.optional) {
            return None;
        }
        let fields = fields.iter().map(|field| format!("{}: ...", field.name)).collect::<Vec<_>>().join(", ");
        Some(match self.field.and_then(|path| path.rsplit('.').next()) {
            Some(field) => format!("`{field}: ({fields})`"),
            None => format!("`{name}({fields})`"),
        })
    }

    /// The same, with what to do where the one number of another material was meant.
    fn write(&self, otherwise: &str) -> String {
        let one = self.field.and_then(|field| number_of_material(field, true));
        match self.written() {
            Some(written) => format!("write {written}{}", one.map_or(String::new(), |one| format!("; {one}"))),
            None => otherwise.to_owned(),
        }
    }

    /// What to do about a field that there is not.
    fn instead(&self, found: &str, expected: &[&str]) -> Option<String> {
        let Some(field) = directions(found, expected) else { return instead_of(found, expected) };
        let inner = Subject { field: Some(field), ..*self };
        let written = inner.written().map(|written| format!("write {written}"));
        written.or_else(|| number_of_material(field, false).map(|hint| format!("write `{field}`; {hint}")))
    }

    /// What the field at fault belongs to: `` `units` of the scene `` for a field of the units.
    fn parent(&self, field: &str) -> String {
        let path = self.field.unwrap_or_default();
        let path = path.strip_suffix(field).unwrap_or(path).trim_end_matches('.');
        if path.is_empty() { self.owner.to_owned() } else { format!("`{path}` of {}", self.owner) }
    }
}

/// The place of an error within the span that the reader reports.
pub(super) fn place(code: &Code, subject: &Subject) -> At {
    match code {
        Code::Message(_) | Code::MissingStructField { .. } if subject.field.is_none() => At::Owner,
        Code::Message(_)
        | Code::InvalidValueForType { .. }
        | Code::ExpectedDifferentStructName { .. }
        | Code::MissingStructField { .. }
        | Code::NoSuchEnumVariant { .. }
        | Code::NoSuchStructField { .. }
        | Code::DuplicateStructField { .. } => At::Token,
        _ => At::Next,
    }
}

/// Message and hint. `rest` is the text from the place of the error on.
pub(super) fn explain(code: &Code, subject: &Subject, rest: &str) -> (String, Option<String>) {
    if place(code, subject) == At::Next && rest.trim().is_empty() {
        return ("the text ends too early".into(), Some("is a closing `)`, `]` or `\"` missing?".into()));
    }
    match code {
        Code::Message(reason) => (format!("{}: {reason}", subject.name()), range_hint(rest)),
        Code::NoSuchStructField { expected, found, .. } => (
            format!("{} has no field `{found}`; {}", subject.parent(found), allowed(expected)),
            subject.instead(found, expected),
        ),
        Code::MissingStructField { field, .. } => (
            format!("`{field}` is missing in {}", subject.name()),
            Some(format!("add `{field}: ...` between its parentheses")),
        ),
        Code::DuplicateStructField { field, .. } => {
            (format!("{} has `{field}` twice", subject.parent(field)), Some("remove one of them".into()))
        }
        Code::NoSuchEnumVariant { expected, found, .. } => {
            (format!("{} is `{found}`; {}", subject.name(), allowed(expected)), instead_of(found, expected))
        }
        Code::InvalidValueForType { expected, found } => {
            (format!("{}: {expected} is expected, found {found}", subject.name()), None)
        }
        Code::ExpectedDifferentStructName { expected, found } => {
            (format!("{} begins with `{expected}(`, found `{found}`", subject.owner), instead_of(found, &[expected]))
        }
        other => syntax(other, subject, rest),
    }
}

/// The same where the text is not written as a scene is.
fn syntax(code: &Code, subject: &Subject, rest: &str) -> (String, Option<String>) {
    let found = token(rest);
    let expected = |what: &str| format!("{}: {what} is expected, found {found}", subject.name());
    match code {
        Code::ExpectedFloat | Code::ExpectedInteger => {
            let field = subject.field.filter(|_| rest.starts_with(['(', '[']));
            (expected("a number"), field.and_then(|field| number_of_material(field, false)).map(str::to_owned))
        }
        Code::ExpectedString => (expected("a text in double quotes"), None),
        Code::ExpectedStringEnd => ("a closing `\"` is missing".into(), None),
        Code::ExpectedArray => (expected("a list in `[` and `]`"), None),
        Code::ExpectedIdentifier | Code::SuggestRawIdentifier(_) => (
            expected("a name"),
            Some(subject.write("names are written without quotes, fields with their names: `field: value`")),
        ),
        Code::ExpectedStructLike | Code::ExpectedNamedStructLike(_) => (
            format!("{}: `(` is expected, found {found}", subject.name()),
            Some(subject.write("fields are written in parentheses: `name(field: value, ...)`")),
        ),
        Code::ExpectedComma if rest.starts_with([')', ']', '}']) => (
            format!("{found} makes no sense here"),
            Some("is it one too many, or is another bracket not closed?".into()),
        ),
        Code::ExpectedComma if is_unit(unit_token(rest)) => (
            format!("{found} follows a number"),
            Some("write a number with its unit in double quotes: `\"210 GPa\"`".into()),
        ),
        Code::ExpectedComma => (format!("a comma is missing before {found}"), None),
        Code::ExpectedMapColon => (
            format!("a colon is missing before {found}"),
            Some("fields are written with their names, `field: value`; is a `)` missing before?".into()),
        ),
        Code::ExpectedStructLikeEnd => (format!("`)` is expected, found {found}"), None),
        Code::ExpectedArrayEnd => (format!("`]` is expected, found {found}"), None),
        Code::UnexpectedChar(_) => (format!("{found} makes no sense here"), None),
        Code::TrailingCharacters if rest.starts_with('(') => (
            format!("{found} follows the end of {}", subject.owner),
            Some("what has no fields is written by its name alone, without parentheses".into()),
        ),
        Code::TrailingCharacters => (
            format!("{found} follows the end of {}", subject.owner),
            Some("is there a `)` or `]` too many before it?".into()),
        ),
        Code::ExceededRecursionLimit => {
            let (message, hint) = too_deep();
            (message, Some(hint))
        }
        other => (format!("{}: {other}", subject.name()), None),
    }
}

/// What is said of brackets that are nested without measure.
pub(super) fn too_deep() -> (String, String) {
    ("brackets are nested too deeply".into(), "a scene needs no more than four levels of brackets".into())
}

/// Numbers too large or too small for double precision are read as infinite or zero.
fn range_hint(rest: &str) -> Option<String> {
    let number = bare_token(rest);
    let value: f64 = number.parse().ok()?;
    let mantissa = number.split(['e', 'E']).next()?;
    if !mantissa.contains(|c: char| matches!(c, '1'..='9')) {
        None
    } else if value.is_infinite() {
        Some(format!("`{number}` is beyond the largest number, about 1.8e308"))
    } else {
        (value == 0.0).then(|| format!("`{number}` is below the smallest number, about 5e-324"))
    }
}

fn allowed(names: &[&str]) -> String {
    format!("allowed {} {}", if names.len() == 1 { "is" } else { "are" }, quoted_list(names))
}

/// The first token of a text, for messages.
pub(super) fn token(rest: &str) -> String {
    const LONGEST: usize = 30;
    let rest = rest.trim_start();
    let bare = bare_token(rest);
    let token: String = match rest.chars().next() {
        None => return "the end of the text".into(),
        Some('"') => rest.chars().take(1 + rest[1..].find('"').map_or(LONGEST, |end| end + 1)).collect(),
        Some(first) if bare.is_empty() => first.into(),
        Some(_) => bare.into(),
    };
    let shown: String = token.chars().take(LONGEST).collect();
    let more = if token.chars().count() > LONGEST { "..." } else { "" };
    format!("`{shown}{more}`")
}

/// The characters up to the next space, comma or bracket.
fn unit_token(rest: &str) -> &str {
    rest.split(|c: char| c.is_whitespace() || ",()[]".contains(c)).next().unwrap_or_default()
}

/// The characters up to the next space or punctuation.
pub(super) fn bare_token(rest: &str) -> &str {
    rest.split(|c: char| c.is_whitespace() || ",:()[]{}\"".contains(c)).next().unwrap_or_default()
}
