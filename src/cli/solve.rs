//! `recede solve`: contact half-lengths and pressures.
use std::io::Write;
use std::time::Instant;

use clap::ValueEnum;
use recede::report::{self, Report};
use recede::{MaxShear, Model, Options, Solution};

use super::{Failure, SceneFile, tell};

/// Find the contact half-lengths and pressures of a scene
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede solve scene.ron
  recede solve scene.ron --format json --tolerance 1e-12
  recede solve scene.ron --format json --fields
  recede solve scene.ron --stats
  recede solve - --format csv < scene.ron")]
pub struct Solve {
    #[command(flatten)]
    file: SceneFile,
    /// How to write the result
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
    /// Relative error to aim at, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
    /// Discretisation of the contact equations
    #[arg(long, value_enum, default_value_t = Method::Galerkin)]
    method: Method,
    /// Tell, on standard error, what was computed and what was not needed
    #[arg(long)]
    stats: bool,
    /// Search for the largest shear stress also for JSON; a table has it anyway
    #[arg(long, overrides_with = "no_fields")]
    fields: bool,
    /// Do not search for the largest shear stress: contacts only
    #[arg(long, overrides_with = "fields")]
    no_fields: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    /// A table to be read
    Table,
    /// One JSON object, all digits
    Json,
    /// One line for each contact, all digits
    Csv,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Method {
    /// Sine series, tested with Chebyshev polynomials
    Galerkin,
    /// Pressures at nodes: slower, an independent check
    Collocation,
}

impl Solve {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let scene = self.file.read()?;
        let method = match self.method {
            Method::Galerkin => recede::Method::Galerkin,
            Method::Collocation => recede::Method::Collocation,
        };
        let options = Options { tolerance: self.tolerance, method };
        let start = Instant::now();
        let (model, solution) = Model::new(scene.stack()?)
            .and_then(|model| model.press_with(&scene.punch, scene.force, &options).map(|solution| (model, solution)))
            .map_err(|error| scene.locate(error))?;
        let seconds = start.elapsed().as_secs_f64();
        let approach = self.measures().then(|| model.approach(&scene.punch, &solution));
        let max_shear = if self.searches() { max_shear(&model, &solution) } else { None };
        for warning in solution.warnings() {
            tell(&format!("warning: {warning}\n"));
        }
        let format = match self.format {
            Format::Table => report::Format::Table,
            Format::Json => report::Format::Json,
            Format::Csv => report::Format::Csv,
        };
        if self.stats {
            tell(&solution.stats().to_string());
        }
        Ok(Report { scene: &scene, solution: &solution, approach: approach.as_ref(), max_shear, seconds }
            .write(format, out)?)
    }
    /// Whether the approach is printed: it is one of the scene, and CSV has a line for each contact.
    fn measures(&self) -> bool {
        !matches!(self.format, Format::Csv)
    }

    /// Whether the largest shear stress is printed: CSV has no column for it.
    fn searches(&self) -> bool {
        match self.format {
            Format::Table => !self.no_fields,
            Format::Json => self.fields,
            Format::Csv => false,
        }
    }
}

/// The largest shear stress, if it is finite and can be found: it is infinite under a line load, and next to sharp corners. The contacts are solved without it, so that a failure is only
/// told.
fn max_shear(model: &Model, solution: &Solution) -> Option<MaxShear> {
    match model.field(solution).and_then(|field| field.max_shear()) {
        Ok(found) => Some(found).filter(|found| found.value.is_finite()),
        Err(error) => {
            tell(&format!("note: the contacts are solved, the largest shear stress was not found: {error}\n"));
            None
        }
    }
}
