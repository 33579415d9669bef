//! Layer types by name: what a scene file may contain.
use serde::de::DeserializeOwned;

use crate::Layer;

/// Reads one layer from its fields in a scene file.
pub type ReadLayer = fn(&mut dyn erased_serde::Deserializer) -> Result<Box<dyn Layer>, erased_serde::Error>;

/// One layer type of a [`Registry`].
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name in the scene file, e.g. `Homogeneous`.
    pub name: &'static str,
    /// One line on what it is.
    pub summary: &'static str,
    /// Reads the fields.
    pub read: ReadLayer,
}

/// Layer types by name. [`Registry::default`] holds those that ship; [`Registry::register`] adds one's own.
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
        self.entries.retain(|entry| entry.name != name);
        let read: ReadLayer = |fields| Ok(Box::new(erased_serde::deserialize::<L>(fields)?));
        self.entries.push(Entry { name, summary, read });
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
