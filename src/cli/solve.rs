//! `recede solve`: extents of contacts, and pressures.
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use clap::ValueEnum;
use recede::report::{self, Report};
use recede::{Extremes, Field, FieldError, MaxShear, Model, Options, Solution, files};

use super::{Failure, SceneFile, outputs, tell};

/// Find the extents of all contacts of a scene, and the pressures in them
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede solve scene.ron
  recede solve scene.ron --format json --tolerance 1e-12
  recede solve scene.ron --format json --fields
  recede solve scene.ron --out result.json
  recede solve scene.ron --digits 4
  recede solve scene.ron --extremes
  recede solve scene.ron --stats
  recede solve - --format csv < scene.ron")]
pub struct Solve {
    #[command(flatten)]
    file: SceneFile,
    /// How to write the result [default: as the file of --out is called, or a table]
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// File to write rather than standard output
    #[arg(long, value_name = "FILE.json|csv|txt")]
    out: Option<PathBuf>,
    /// Significant digits of a table, at most; without it, as many as the error estimates justify
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=17))]
    digits: Option<u8>,
    /// Relative error to aim at, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
    /// `collocation` checks the solution by a second discretisation of the contact equations
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
    /// Search for the stresses by which layers and bonds break: largest tension, von Mises stress of each layer, shear stress and
    /// tension across each interface that does not open
    #[arg(long)]
    extremes: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
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
    /// The same, and an independent check of it: pressures at nodes, at the half-lengths that were found
    Collocation,
}

impl Solve {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let format = self.format()?;
        let scene = self.file.read_for(self.out.as_deref().as_slice())?;
        let options = Options { tolerance: self.tolerance };
        let start = Instant::now();
        let (model, solution) = Model::new(scene.stack()?)
            .and_then(|model| model.press_with(&scene.top, scene.force, &options).map(|solution| (model, solution)))
            .map_err(|error| scene.locate(error))?;
        let seconds = start.elapsed().as_secs_f64();
        let approach = measures(format).then(|| model.approach(&scene.top, &solution));
        let max_shear = if self.searches(format) { max_shear(&model, &solution) } else { None };
        let extremes = if self.extremes { extremes(format, &model, &solution)? } else { None };
        for warning in solution.warnings() {
            tell(&format!("warning: {warning}\n"));
        }
        if self.stats {
            tell(&solution.stats().to_string());
        }
        let collocated = match self.method {
            Method::Galerkin => None,
            Method::Collocation => {
                let checked = model.collocate(&scene.top, &solution, &options);
                Some(checked.map_err(|error| scene.locate(error))?)
            }
        };
        let collocated = collocated.as_deref();
        let digits = self.digits.map(usize::from);
        let approach = approach.as_ref();
        let extremes = extremes.as_ref();
        let report =
            Report { scene: &scene, solution: &solution, approach, max_shear, extremes, collocated, digits, seconds };
        let format = match format {
            Format::Table => report::Format::Table,
            Format::Json => report::Format::Json,
            Format::Csv => report::Format::Csv,
        };
        match &self.out {
            Some(path) => {
                files::replace(path, |out| report.write(format, out)).map_err(|cause| Failure::file(path, cause))
            }
            None => Ok(report.write(format, out)?),
        }
    }

    /// The format that is asked for by name, or by the name of the file.
    fn format(&self) -> Result<Format, Failure> {
        let kinds = [("json", Format::Json), ("csv", Format::Csv), ("txt", Format::Table)];
        let hint = "let it end in .json, .csv or .txt, or say --format json, csv or table";
        outputs::kind(self.out.as_deref(), self.format, &kinds, Format::Table, hint)
    }

    /// Whether the largest shear stress is printed: CSV has no column for it.
    fn searches(&self, format: Format) -> bool {
        match format {
            Format::Table => !self.no_fields,
            Format::Json => self.fields,
            Format::Csv => false,
        }
    }
}

/// Whether the approach is printed: it is one of the scene, and CSV has a line for each contact.
fn measures(format: Format) -> bool {
    !matches!(format, Format::Csv)
}

/// The stresses by which layers and bonds break, if they can be found.
fn extremes(format: Format, model: &Model, solution: &Solution) -> Result<Option<Extremes>, Failure> {
    if matches!(format, Format::Csv) {
        return Err(Failure::usage(
            "CSV has a line for each contact, and no place for --extremes",
            "say --format json, or let `recede sweep --extremes` write them as columns",
        ));
    }
    Ok(searched("the contacts are solved, the extremes were not found:", model, solution, Field::extremes))
}

/// The largest shear stress, if it is finite and can be found: it is infinite under a line load, and next to sharp corners.
fn max_shear(model: &Model, solution: &Solution) -> Option<MaxShear> {
    searched("the contacts are solved, the largest shear stress was not found:", model, solution, Field::max_shear)
        .filter(|found| found.value.is_finite())
}

/// What is found in the fields of a solution. The contacts are solved without it, so that a failure is only told.
fn searched<T>(
    what: &str,
    model: &Model,
    solution: &Solution,
    search: impl Fn(&Field) -> Result<T, FieldError>,
) -> Option<T> {
    match model.field(solution).and_then(|field| search(&field)) {
        Ok(found) => Some(found),
        Err(error) => {
            tell(&format!("note: {what} {error}\n"));
            None
        }
    }
}
