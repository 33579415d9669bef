//! Errors of the readers in words of the scene: what was found, what is allowed, what to do.
use recede_layers::description::Value;
use recede_layers::tree::{Fault, Form, Node, ReadError, bare_token, token};

use super::hints::{instead_of, rows};
use super::origin::{Origin, SceneError};
use super::quoted_list;

impl Origin {
    /// Why a part of the scene that is called `owner` in messages cannot be read; `form` is what may be written there, if that is known.
    pub(super) fn explained(&self, node: &Node, owner: &str, form: Option<&Value>, error: ReadError) -> SceneError {
        let name = node.name.as_deref().unwrap_or_default();
        let form = form.and_then(|form| match form {
            Value::OneOf(forms) => forms.iter().find(|form| form.name == name)?.value.as_ref(),
            form => Some(form),
        });
        let subject = Subject { owner, field: error.field.as_deref(), form: form.map(|form| (name, form)) };
        // an error about the part as a whole is shown at its name
        let is_whole = error.field.is_none() && matches!(error.fault, Fault::Reason(_) | Fault::Missing(_));
        let at = error.at.filter(|_| !is_whole).unwrap_or(node.place.start);
        let (message, hint) = explain(&error.fault, &subject, self.rest(at));
        self.error(Some(at), message).hinted(hint).because(error)
    }
}

/// The part of a scene that was being read.
struct Subject<'a> {
    /// E.g. `layer 1 (Homogeneous)`.
    owner: &'a str,
    /// The field of it, e.g. `poisson`, if one was being read.
    field: Option<&'a str>,
    /// The name of what was being read, and what may stand in its parentheses, if that is known.
    form: Option<(&'a str, &'a Value)>,
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

    /// The hint to write the structure, also where the one number of another material was meant.
    fn write(&self, otherwise: &str) -> String {
        let one = self.field.and_then(|field| rows("several numbers", field).next());
        match self.written() {
            Some(written) => format!("write {written}{}", one.map_or(String::new(), |one| format!("; {one}"))),
            None => self.field.and_then(|field| rows("names", field).next()).unwrap_or(otherwise).to_owned(),
        }
    }

    /// The hint for a field that does not exist.
    fn instead(&self, found: &str, expected: &[&str]) -> Option<String> {
        let direction = rows("directions", found).find(|field| expected.contains(field));
        let Some(field) = direction else { return instead_of(found, expected) };
        let inner = Subject { field: Some(field), ..*self };
        let written = inner.written().map(|written| format!("write {written}"));
        written.or_else(|| rows("one number", field).next().map(|hint| format!("write `{field}`; {hint}")))
    }
}

/// Message and hint. `rest` is the text from the place of the error on.
fn explain(fault: &Fault, subject: &Subject, rest: &str) -> (String, Option<String>) {
    let name = subject.name();
    match fault {
        Fault::Reason(reason) => (format!("{name}: {reason}"), range_hint(rest)),
        Fault::UnknownField { found, allowed } => {
            (format!("{name} has no field `{found}`; {}", are_allowed(allowed)), subject.instead(found, allowed))
        }
        Fault::Missing(field) => {
            (format!("`{field}` is missing in {name}"), Some(format!("add `{field}: ...` between its parentheses")))
        }
        Fault::Twice(field) => (format!("{name} has `{field}` twice"), Some("remove one of them".into())),
        Fault::UnknownName { found, allowed } => {
            (format!("{name} is `{found}`; {}", are_allowed(allowed)), instead_of(found, allowed))
        }
        Fault::OtherName { expected, found } => {
            (format!("{} begins with `{expected}(`, found `{found}`", subject.owner), instead_of(found, &[expected]))
        }
        Fault::NotAlone => (
            format!("{} follows the end of {name}", token(rest)),
            Some("what has no fields is written by its name alone, without parentheses".into()),
        ),
        Fault::Expected(form) => (
            format!("{name}: {form} is expected, found {}", token(rest)),
            match form {
                Form::Number => subject
                    .field
                    .filter(|_| rest.starts_with(['(', '[', '{']))
                    .and_then(|field| rows("one number", field).next())
                    .map(str::to_owned),
                Form::Name => {
                    Some(subject.write("names are written without quotes, fields with their names: `field: value`"))
                }
                Form::Open if subject.field == Some("at") => {
                    Some("in axisymmetric scenes the place of a load has two coordinates: `at: (x, y)`".to_owned())
                }
                Form::Open => Some(subject.write("fields are written in parentheses: `name(field: value, ...)`")),
                Form::Text | Form::List | Form::Close => None,
            },
        ),
        Fault::Follows => (
            format!("{} follows the end of {}", token(rest), subject.owner),
            Some("is there a `)` or `]` too many before it?".into()),
        ),
        Fault::Syntax { message, hint } => (message.clone(), hint.clone()),
    }
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

fn are_allowed(names: &[&str]) -> String {
    format!("allowed {} {}", if names.len() == 1 { "is" } else { "are" }, quoted_list(names))
}
