//! The sweep that a file and options name together, for all commands that need one.
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use recede::{Axis, Error, MAX_BYTES, Options, Registry, Scene, Sweep};

use super::Failure;

/// The scene and the axes of a sweep, and its options, by which it is told from others.
#[derive(Debug, clap::Args)]
pub(super) struct GridArguments {
    /// Scene, or sweep, in RON; `-` reads standard input
    #[arg(value_name = "SCENE.ron")]
    pub(super) file: PathBuf,
    /// What varies: PATH=START:STOP:COUNT, PATH=START:STOP:COUNT:log or PATH=[v,v,...]
    #[arg(long, value_name = "PATH=VALUES")]
    vary: Vec<Axis>,
    /// Add columns with the approach of the punch and the stiffness: how far it sinks, dP/d(approach)
    #[arg(long)]
    approach: bool,
    /// Add columns with the stresses by which layers and bonds break: tension, von Mises stress of each layer, shear stress and tension
    /// across each interface that does not open
    #[arg(long)]
    extremes: bool,
    /// Relative error to aim at, from 1e-13 to 1e-2 [default: 1e-10]
    #[arg(long)]
    tolerance: Option<f64>,
}

impl GridArguments {
    /// The sweep.
    pub(super) fn sweep(&self) -> Result<Sweep, Failure> {
        let registry = Registry::default();
        let name = if self.file == Path::new("-") { Path::new("stdin") } else { &self.file };
        let text = self.text().map_err(|cause| Failure::file(&self.file, cause))?;
        let sweep = if std::str::from_utf8(&text).is_ok_and(Sweep::begins) {
            Sweep::from_reader(name, &text[..], &registry)?.and_vary(self.vary.clone())?
        } else {
            let scene = Scene::from_reader(&name.display().to_string(), &text[..], &registry).map_err(Error::from)?;
            if self.vary.is_empty() {
                let paths = scene.paths().join(", ");
                return Err(Failure::usage(
                    "nothing varies: --vary PATH=START:STOP:COUNT is missing",
                    format!("what can vary in this scene: {paths}"),
                ));
            }
            Sweep::new(scene, self.vary.clone())?
        };
        let tolerance = self.tolerance.unwrap_or(sweep.options().tolerance);
        let sweep = sweep.with_options(Options { tolerance })?;
        let sweep = if self.approach { sweep.with_approach() } else { sweep };
        Ok(if self.extremes { sweep.with_extremes() } else { sweep })
    }

    /// The files that are read: the one that was named, and the scene of a sweep in a file of its own.
    pub(super) fn files<'a>(&'a self, sweep: &'a Sweep) -> Vec<&'a Path> {
        [&*self.file].into_iter().chain(sweep.scene().file().map(Path::new)).collect()
    }

    /// The bytes of the file, at most as many as a scene may have.
    fn text(&self) -> io::Result<Vec<u8>> {
        let is_input = self.file == Path::new("-");
        let file: Box<dyn Read> = if is_input { Box::new(io::stdin()) } else { Box::new(File::open(&self.file)?) };
        let mut text = Vec::new();
        file.take(MAX_BYTES as u64 + 1).read_to_end(&mut text)?;
        Ok(text)
    }
}
