//! `recede check`: reads a scene and draws its stack.
use std::io::Write;

use recede::Force;

use terminal_size::terminal_size;

use super::{Failure, SceneFile};

/// Check a scene and draw its stack
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede check scene.ron
  recede check - < scene.ron")]
pub struct CheckArguments {
    #[command(flatten)]
    file: SceneFile,
}

impl CheckArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let scene = self.file.read()?;
        let stack = scene.stack()?;
        let label = match scene.force {
            Force::Given(0.0) => "no load".to_owned(),
            force => format!("{}, {}", scene.top.label(scene.geometry), force.label(scene.geometry)),
        };
        let columns = terminal_size().map(|(width, _)| usize::from(width.0));
        writeln!(out, "{}", stack.drawing(Some(&label), columns))?;
        Ok(())
    }
}
