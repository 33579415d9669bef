//! `recede show`: the symbolic block matrix, and what the contact equations find.
use std::io::Write;

use recede::{BlockSystem, Model};

use super::{Failure, SceneFile};

/// Show the block matrix of a stack in symbols, or the contact equations
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede show scene.ron
  recede show scene.ron --latex > matrix.tex
  recede show scene.ron --contacts")]
pub struct ShowArguments {
    #[command(flatten)]
    file: SceneFile,
    /// Write LaTeX
    #[arg(long)]
    latex: bool,
    /// Show the unknowns and rows of the contact equations that were solved
    #[arg(long, conflicts_with = "latex")]
    contacts: bool,
}

impl ShowArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let scene = self.file.read()?;
        let system = BlockSystem::pressed(&scene.stack()?);
        if self.contacts {
            let model = Model::new(scene.stack()?)?;
            let ledger = model.press(&scene.top, scene.force).and_then(|found| model.ledger(&scene.top, &found));
            write!(out, "{}", ledger.map_err(|error| scene.locate(error))?)?;
        } else if self.latex {
            write!(out, "{}", system.to_latex())?;
        } else {
            write!(out, "{system}")?;
        }
        Ok(())
    }
}
