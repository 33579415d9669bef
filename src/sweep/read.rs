//! A sweep written in RON.
use std::io::Read;
use std::path::{Path, PathBuf};

use recede_layers::Registry;
use recede_layers::tree::first_name;
use serde::Deserialize;

use super::Sweep;
use crate::axis::Axis;
use crate::errors::Error;
use crate::options::Options;
use crate::scene::{Scene, open, read_document};

/// The whole of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Sweep")]
struct Written {
    scene: PathBuf,
    vary: Vec<Axis>,
    #[serde(default)]
    tolerance: Option<f64>,
}

impl Sweep {
    /// Whether a text begins as a sweep does, with `Sweep(`.
    pub fn begins(text: &str) -> bool {
        first_name(text) == Some("Sweep")
    }

    /// Reads a sweep from a file in RON. The scene is a file of its own, named from the sweep's folder.
    ///
    /// ```
    /// let sweep = recede::Sweep::read("examples/sweeps/radius_and_load.ron")?;
    /// assert_eq!(sweep.axes()[0].path(), "punch.radius");
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Scene`] with line and column if the text is no sweep, and the errors of [`Scene::read`] and [`Sweep::new`].
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Error> {
        let (_, reader) = open(path.as_ref())?;
        Self::from_reader(path, reader, &Registry::default())
    }

    /// Reads a sweep in RON from anything that yields bytes; `file` is its name in messages, and in its folder
    /// is the scene. `registry` has the layer types.
    ///
    /// # Errors
    /// As [`Sweep::read`].
    pub fn from_reader(file: impl AsRef<Path>, reader: impl Read, registry: &Registry) -> Result<Self, Error> {
        let file = file.as_ref();
        let Written { scene, vary, tolerance } = read_document(&file.display().to_string(), reader, "the sweep")?;
        let (scene, reader) = open(&file.with_file_name(scene))?;
        let tolerance = tolerance.unwrap_or(Options::default().tolerance);
        Self::new(Scene::from_reader(&scene, reader, registry)?, vary)?.with_options(Options { tolerance })
    }
}
