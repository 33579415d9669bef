//! A part of a scene that is read, and what is said where it cannot be.
use recede_layers::description::Value;
use recede_layers::tree::{Fault, Node, ReadError};

use super::explain::{Subject, explain};
use super::origin::{Origin, SceneError};

/// A part of a scene, and its name in messages.
pub(super) struct Part<'a> {
    pub(super) node: &'a Node,
    pub(super) owner: &'a str,
}

impl Part<'_> {
    pub(super) fn error(&self, origin: &Origin, error: ReadError) -> SceneError {
        self.error_of(None, origin, error)
    }

    /// The error, with what may be written there.
    pub(super) fn error_of(&self, form: Option<&Value>, origin: &Origin, error: ReadError) -> SceneError {
        let name = self.node.name.as_deref().unwrap_or_default();
        let form = form.and_then(|form| match form {
            Value::OneOf(forms) => forms.iter().find(|form| form.name == name)?.value.as_ref(),
            form => Some(form),
        });
        let subject = Subject { owner: self.owner, field: error.field.as_deref(), form: form.map(|form| (name, form)) };
        // what is wrong with all of it is told at its name
        let is_whole = error.field.is_none() && matches!(error.fault, Fault::Reason(_) | Fault::Missing(_));
        let at = error.at.filter(|_| !is_whole).unwrap_or(self.node.place.start);
        let (message, hint) = explain(&error.fault, &subject, origin.rest(at));
        origin.error(Some(at), message, hint).because(error)
    }
}
