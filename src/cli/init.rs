//! `recede init`: a scene to begin with.
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use recede::files;

use super::{Failure, outputs, tell};

/// The first scene, every line explained.
const SCENE: &str = include_str!("init.ron");

/// Write a scene to begin with, every line explained
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede init                                writes scene.ron
  recede init plate.ron
  recede init -                              prints it")]
pub struct InitArguments {
    /// The new file, one that exists is left alone; `-` is standard output
    #[arg(value_name = "FILE.ron", default_value = "scene.ron")]
    file: PathBuf,
}

impl InitArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        if self.file == Path::new("-") {
            return Ok(out.write_all(SCENE.as_bytes())?);
        }
        outputs::fits(&self.file, &["ron"])?;
        let name = self.file.display();
        match files::create(&self.file, SCENE.as_bytes()) {
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
