//! `recede profile`: pressures, gaps, displacements and slopes along the faces.
use std::io::Write;
use std::path::PathBuf;

use recede::profile_places;
use recede::report::write_profile;

use super::{Failure, SceneFile, outputs, solved, warn};

/// Pressures, gaps, displacements and slopes along the faces
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede profile scene.ron --out profile.csv
  recede profile scene.ron --to 5 --points 1000 --out profile.csv

Columns: x; punch_pressure and punch_gap, contact_1_2_pressure and contact_1_2_gap, ...; layer_1_top_u, layer_1_top_v and \
layer_1_top_slope, layer_1_bottom_u, ... About an axis x is the distance r from it, and u, v are u_r and u_z, downwards. Places are \
dense next to the ends of the contacts.

Exit status: 0 written, 1 no admissible solution, 2 bad input.")]
pub struct ProfileArguments {
    #[command(flatten)]
    file: SceneFile,
    /// File to write, as comma-separated values; without it, they go to standard output
    #[arg(long, value_name = "FILE.csv")]
    out: Option<PathBuf>,
    /// How many places, about
    #[arg(long, value_name = "N", default_value_t = 400, value_parser = clap::value_parser!(u32).range(10..=100_000))]
    points: u32,
    /// How far to go from x = 0 on both sides [default: twice as far as the bodies touch, from the middle of what touches]
    #[arg(long, value_name = "X", value_parser = length, allow_hyphen_values = true)]
    to: Option<f64>,
    /// Relative error to aim at in the contacts, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
}

fn length(text: &str) -> Result<f64, String> {
    let legal = text.parse().ok().filter(|length: &f64| length.is_finite() && *length > 0.0);
    legal.ok_or_else(|| format!("found `{text}`, allowed is a length > 0"))
}

impl ProfileArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        self.out.as_deref().map_or(Ok(()), |out| outputs::fits(out, &["csv"]))?;
        let scene = self.file.read_for(self.out.as_deref().as_slice())?;
        let (model, solution) = solved(&scene, self.tolerance)?;
        warn(&solution);
        let places = profile_places(&solution, self.to, self.points as usize);
        let profile = model.profile(&scene.top, &solution, &places)?;
        outputs::write(self.out.as_deref(), out, |out| write_profile(&profile, out))
    }
}
