//! `recede show`: the symbolic block matrix.
use std::io::Write;

use recede::BlockSystem;

use super::{Failure, SceneFile};

/// Show the block matrix of a stack in symbols
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede show scene.ron
  recede show scene.ron --latex > matrix.tex")]
pub struct ShowArguments {
    #[command(flatten)]
    file: SceneFile,
    /// Write LaTeX
    #[arg(long)]
    latex: bool,
}

impl ShowArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let system = BlockSystem::new(&self.file.read()?.stack()?);
        if self.latex {
            write!(out, "{}", system.to_latex())?;
        } else {
            write!(out, "{system}")?;
        }
        Ok(())
    }
}
