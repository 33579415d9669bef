//! `recede init`: a scene to begin with.
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use recede::files;

use super::{Failure, outputs, tell};

/// Scenes to begin with.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum First {
    /// A roller on a plate that may lift off, every line explained
    Plate,
    /// Two rollers on a belt that lies loose on its bed
    TwoRollers,
    /// A ring on a gasket, pressed down beside its middle, which may turn
    EccentricSeal,
}

impl First {
    fn text(self) -> &'static str {
        match self {
            Self::Plate => include_str!("init.ron"),
            Self::TwoRollers => include_str!("../../examples/gallery/two_rollers.ron"),
            Self::EccentricSeal => include_str!("../../examples/gallery/eccentric_seal.ron"),
        }
    }
}

/// Write a scene to begin with, every line explained
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede init                                writes scene.ron
  recede init plate.ron
  recede init belt.ron --scene two-rollers   another one
  recede init -                              prints it")]
pub struct InitArguments {
    /// The new file, one that exists is left alone; `-` is standard output
    #[arg(value_name = "FILE.ron", default_value = "scene.ron")]
    file: PathBuf,
    /// Which scene
    #[arg(long, value_enum, default_value_t = First::Plate)]
    scene: First,
}

impl InitArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let scene = self.scene.text().as_bytes();
        if self.file == Path::new("-") {
            return Ok(out.write_all(scene)?);
        }
        outputs::fits(&self.file, &["ron"])?;
        let name = self.file.display();
        match files::create(&self.file, scene) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                let message = format!("{name} exists and is left as it is");
                return Err(Failure::usage(message, "name another file: recede init FILE.ron"));
            }
            other => other.map_err(|cause| Failure::file(&self.file, cause))?,
        }
        if !files::is_stream(&self.file) {
            tell(&format!("{name} is written; next: recede check {name}, recede solve {name}\n"));
        }
        Ok(())
    }
}
