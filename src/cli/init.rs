//! `recede init`: a scene to begin with.
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

use super::{Failure, tell};

/// What is written.
const SCENE: &str = include_str!("init.ron");

/// Write a scene to begin with, every line explained
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede init                                writes scene.ron
  recede init plate.ron")]
pub struct Init {
    /// The new file; one that exists is left alone
    #[arg(value_name = "FILE.ron", default_value = "scene.ron")]
    file: PathBuf,
}

impl Init {
    pub fn run(&self) -> Result<(), Failure> {
        let mut file = match OpenOptions::new().write(true).create_new(true).open(&self.file) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                let message = format!("{} exists and is left as it is", self.file.display());
                return Err(Failure::usage(message, "name another file: recede init FILE.ron"));
            }
            other => other.map_err(|cause| Failure::file(&self.file, cause))?,
        };
        file.write_all(SCENE.as_bytes()).map_err(|cause| Failure::file(&self.file, cause))?;
        let name = self.file.display();
        tell(&format!("{name} is written; next: recede check {name}, recede solve {name}\n"));
        Ok(())
    }
}
