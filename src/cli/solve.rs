//! `recede solve`: extents of contacts, and pressures.
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use recede::report::{Format, Report};
use recede::{Coordinates, FieldError};

use super::{Failure, SceneFile, outputs, solved, tell, warn};

/// Find the extents of all contacts of a scene, and the pressures in them
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede solve scene.ron
  recede solve scene.ron --format json --tolerance 1e-12
  recede solve scene.ron --format json --fields
  recede solve scene.ron --out result.json
  recede solve scene.ron --digits 4
  recede solve scene.ron --set force=0.01 --set layer[1].thickness=2
  recede solve scene.ron --extremes
  recede solve scene.ron --stats
  recede solve - --format csv < scene.ron")]
pub struct SolveArguments {
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
    /// `collocation` checks the solution by a second discretisation: gaps that are left where bodies touch
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

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Method {
    /// Sine series, tested with Chebyshev polynomials
    Galerkin,
    /// The same, and an independent check of it: pressures at nodes, at the half-lengths that were found
    Collocation,
}

impl SolveArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let format = self.format()?;
        let scene = self.file.read_for(self.out.as_deref().as_slice())?;
        let start = Instant::now();
        let (model, solution) = solved(&scene, self.tolerance)?;
        let seconds = start.elapsed().as_secs_f64();
        // of the scene as a whole, and CSV has a line for each contact
        let is_told = format != Format::Csv;
        let approaches = if is_told { model.approaches(&scene.top, &solution) } else { Vec::new() };
        // about one axis, or in the plane
        let is_searched = scene.coordinates() != Coordinates::Cartesian;
        let is_wanted = is_searched
            && match format {
                Format::Table => !self.no_fields,
                Format::Json => self.fields,
                // it has no column for the largest shear stress
                Format::Csv => false,
            };
        let field = || model.field(&solution);
        let failed = "the contacts are solved, the largest shear stress was not found:";
        let max_shear = searched(is_wanted, failed, || field()?.max_shear());
        let failed = "the contacts are solved, the extremes were not found:";
        let extremes = searched(self.extremes, failed, || field()?.extremes());
        warn(&solution);
        if self.stats {
            tell(&solution.stats().to_string());
        }
        let collocated = match self.method {
            Method::Galerkin => None,
            Method::Collocation => {
                let checked = model.collocate(&scene.top, &solution);
                Some(checked.map_err(|error| scene.locate(error))?)
            }
        };
        let report = Report {
            scene: &scene,
            solution: &solution,
            separation: if is_told { model.separation(&scene.top, &solution)? } else { None },
            approaches: &approaches,
            // infinite under a line load, and next to sharp corners
            max_shear: max_shear.filter(|found| found.value.is_finite()),
            extremes: extremes.as_ref(),
            collocated: collocated.as_deref(),
            digits: self.digits.map(usize::from),
            seconds,
        };
        outputs::write(self.out.as_deref(), out, |out| report.write(format, out))
    }

    /// The format that is asked for by name, or by the name of the file.
    fn format(&self) -> Result<Format, Failure> {
        let kinds = [("json", Format::Json), ("csv", Format::Csv), ("txt", Format::Table)];
        let hint = "let it end in .json, .csv or .txt, or say --format json, csv or table";
        let format = outputs::kind(self.out.as_deref(), self.format, &kinds, Format::Table, hint)?;
        if self.extremes && format == Format::Csv {
            return Err(Failure::usage(
                "CSV has a line for each contact, and no place for --extremes",
                "say --format json, or let `recede sweep --extremes` write them as columns",
            ));
        }
        Ok(format)
    }
}

/// The result of a search in the fields of a solution, if it is wanted. The contacts are solved without it, so that a failure is only a note.
fn searched<T>(is_wanted: bool, failed: &str, search: impl Fn() -> Result<T, FieldError>) -> Option<T> {
    let found = is_wanted.then(search)?;
    found.inspect_err(|error| tell(&format!("note: {failed} {error}\n"))).ok()
}
