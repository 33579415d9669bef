//! `recede convert`: a scene in RON as JSON, and the other way round.
use std::io::Write;
use std::path::PathBuf;

use clap::ValueEnum;

use super::{Failure, SceneFile, outputs};

/// Write a scene in JSON or in RON, with the same names
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede convert scene.ron                   JSON on standard output
  recede convert scene.ron --out scene.json
  recede convert scene.json --out scene.ron

Numbers with a unit are written in the units of the scene, comments are left out.

Exit status: 0 written, 2 bad input.")]
pub struct ConvertArguments {
    #[command(flatten)]
    file: SceneFile,
    /// File to write; without it, standard output
    #[arg(long, value_name = "FILE.json|ron")]
    out: Option<PathBuf>,
    /// What to write [default: as the file is called, or JSON]
    #[arg(long, value_enum)]
    to: Option<Language>,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Language {
    /// JavaScript Object Notation, which other programs write
    Json,
    /// Rusty Object Notation
    Ron,
}

impl ConvertArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let kinds = [("json", Language::Json), ("ron", Language::Ron)];
        let hint = "let it end in .json or .ron, or say --to json or --to ron";
        let language = outputs::kind(self.out.as_deref(), self.to, &kinds, Language::Json, hint)?;
        let scene = self.file.read_for(self.out.as_deref().as_slice())?;
        let text = match language {
            Language::Json => scene.to_json(),
            Language::Ron => scene.to_ron(),
        };
        outputs::write(self.out.as_deref(), out, |out| out.write_all(text.as_bytes()))
    }
}
