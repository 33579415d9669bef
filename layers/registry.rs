//! Layer types by name: what a scene file may contain, and how it is read.
use std::sync::Arc;

use schemars::{JsonSchema, Schema};
use serde::de::DeserializeOwned;

use crate::description::{Value, schema_of};
use crate::tree::{Node, ReadError};
use crate::{Layer, Notation, Support};

/// What is read by a name: a layer, or a support at the bottom.
#[derive(Clone, Debug)]
pub enum Body {
    /// An elastic layer or half-plane.
    Layer(Arc<dyn Layer>),
    /// A support that is no elastic body.
    Support(Arc<dyn Support>),
}

impl Body {
    /// The layer, unless it is a support.
    pub fn layer(&self) -> Option<&Arc<dyn Layer>> {
        match self {
            Self::Layer(layer) => Some(layer),
            Self::Support(_) => None,
        }
    }

    /// Its name in reports and pictures, if it has one.
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Layer(layer) => layer.name(),
            Self::Support(support) => support.name(),
        }
    }

    /// How it is written in drawings and messages.
    pub fn notation(&self) -> Notation {
        match self {
            Self::Layer(layer) => layer.notation(),
            Self::Support(support) => support.notation(),
        }
    }
}

/// Reads one layer or support from its fields in a scene, as in `Homogeneous(thickness: 1.0, shear_modulus: ...)`; the name
/// is the name of the [`Entry`].
pub type ReadBody = fn(&Node) -> Result<Body, ReadError>;

fn read_layer<L: Layer + DeserializeOwned>(node: &Node) -> Result<Body, ReadError> {
    Ok(Body::Layer(Arc::new(node.read_inner::<L>()?)))
}

/// One layer type of a [`Registry`].
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name in the scene file, e.g. `Homogeneous`.
    pub name: &'static str,
    /// One line on the layer, interface or base of this name.
    pub summary: &'static str,
    /// Reads the fields.
    pub read: ReadBody,
    /// The JSON Schema of the fields, if the type has one, see [`Registry::register_described`].
    pub schema: Option<fn() -> Schema>,
}

impl Entry {
    /// The fields, if the type tells them.
    pub fn describe(&self) -> Option<Value> {
        self.schema.map(|schema| Value::of_schema(&schema()))
    }
}

/// Layer types by name. [`Registry::default`] holds those that ship; [`Registry::register`] adds one's own.
///
/// ```
/// use recede_layers::Registry;
/// use recede_layers::tree::Node;
/// let registry = Registry::default();
/// let entry = registry.get("Homogeneous").ok_or("not registered")?;
/// let strip = (entry.read)(&Node::from_ron("(thickness: 1.0, shear_modulus: 80e9, poisson: 0.3)")?)?;
/// assert_eq!(strip.layer().ok_or("a layer")?.thickness(), Some(1.0));
/// let error = (entry.read)(&Node::from_ron("(thickness: -1.0, shear_modulus: 80e9, poisson: 0.3)")?).unwrap_err();
/// assert_eq!(error.field.as_deref(), Some("thickness"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Registry {
    entries: Vec<Entry>,
}

impl Default for Registry {
    fn default() -> Self {
        let mut registry = Self { entries: Vec::new() };
        crate::register_shipped(&mut registry);
        registry
    }
}

impl Registry {
    /// Adds a layer type under `name`; a type registered before under the same name is replaced.
    pub fn register<L: Layer + DeserializeOwned>(&mut self, name: &'static str, summary: &'static str) {
        self.enter(Entry { name, summary, read: read_layer::<L>, schema: None });
    }

    /// The same for a layer type that also derives [`JsonSchema`]: its fields, with their documentation, are listed by
    /// [`Entry::describe`].
    pub fn register_described<L>(&mut self, name: &'static str, summary: &'static str)
    where
        L: Layer + DeserializeOwned + JsonSchema,
    {
        self.enter(Entry { name, summary, read: read_layer::<L>, schema: Some(schema_of::<L>) });
    }

    /// Adds a type of supports, with the documentation of their fields; a type registered before under the same name is replaced.
    pub fn register_support<S>(&mut self, name: &'static str, summary: &'static str)
    where
        S: Support + DeserializeOwned + JsonSchema + 'static,
    {
        let read: ReadBody = |node| Ok(Body::Support(Arc::new(node.read_inner::<S>()?)));
        self.enter(Entry { name, summary, read, schema: Some(schema_of::<S>) });
    }

    fn enter(&mut self, entry: Entry) {
        self.entries.retain(|other| other.name != entry.name);
        self.entries.push(entry);
    }

    /// The entries in the order of registration.
    pub fn iter(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter()
    }

    /// The entry called `name`.
    pub fn get(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.name == name)
    }
}
