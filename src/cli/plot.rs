//! `recede plot`: the stack, its contacts and their pressures as a picture.
use std::path::PathBuf;

use recede::plot::{self, Kind};
use recede::{Model, Options};

use super::{Failure, SceneFile};

/// Draw a scene to scale with its contacts, and the pressures below it
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede plot scene.ron --out scene.svg
  recede plot scene.ron --out scene.png

Exit status: 0 drawn, 1 no admissible solution, 2 bad input.")]
pub struct Plot {
    #[command(flatten)]
    file: SceneFile,
    /// The picture; its ending, .svg or .png, says of which kind it is
    #[arg(long, value_name = "FILE.svg|png")]
    out: PathBuf,
    /// Relative error to aim at, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
}

impl Plot {
    pub fn run(&self) -> Result<(), Failure> {
        Kind::of(&self.out)?;
        let scene = self.file.read()?;
        let options = Options { tolerance: self.tolerance, ..Options::default() };
        let model = Model::new(scene.stack()?).map_err(|error| scene.locate(error))?;
        let solution = model.press_with(&scene.punch, scene.force, &options).map_err(|error| scene.locate(error))?;
        Ok(plot::save(&self.out, &plot::stack(&scene, model.stack(), &solution))?)
    }
}
