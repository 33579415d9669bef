//! `recede plot`: the stack, its contacts and their pressures as a picture.
use std::path::PathBuf;

use recede::Scene;
use recede::plot::{self, Kind, Picture};

use super::{Failure, SceneFile, solved};

/// A line above a picture
#[derive(Debug, clap::Args)]
pub struct Title {
    /// Write a title above the picture: TEXT, or without it the name of the scene
    #[arg(long, value_name = "TEXT", num_args = 0..=1, require_equals = true, default_missing_value = "")]
    title: Option<String>,
}

impl Title {
    /// The picture with the title, if there is to be one.
    pub fn above(&self, picture: Picture, scene: &Scene) -> Picture {
        match self.title.as_deref() {
            None => picture,
            Some("") => picture.titled(scene.title()),
            Some(title) => picture.titled(title),
        }
    }
}

/// Draw a scene to scale with its contacts, and the pressures below it
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede plot scene.ron --out scene.svg
  recede plot scene.ron --out scene.pdf
  recede plot scene.ron --out scene.png --title='A strip on rock'

Exit status: 0 drawn, 1 no admissible solution, 2 bad input.")]
pub struct PlotArguments {
    #[command(flatten)]
    file: SceneFile,
    /// The picture; its ending, .svg, .pdf or .png, says of which kind it is
    #[arg(long, value_name = "FILE.svg|pdf|png")]
    out: PathBuf,
    /// Relative error to aim at, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
    #[command(flatten)]
    title: Title,
}

impl PlotArguments {
    pub fn run(&self) -> Result<(), Failure> {
        Kind::of(&self.out)?;
        let scene = self.file.read_for(&[&self.out])?;
        let (model, solution) = solved(&scene, self.tolerance)?;
        let picture = plot::stack(&scene, model.stack(), &solution);
        Ok(plot::save(&self.out, &self.title.above(picture, &scene))?)
    }
}
