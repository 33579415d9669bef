//! `recede sweep`: a scene for many values of some of its quantities.
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;

use recede::plot::{self, DrawnColumns, Kind, MapStyle};
use recede::report::SweepCsv;
use recede::{Part, Sweep};

use super::grid::GridArguments;
use super::plot::{ColourOptions, Page};
use super::progress::Progress;
use super::rows_file;
use super::{Failure, outputs, tell};

/// Solve a scene for many values of some of its quantities
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Several --vary make a grid, in which the last one changes first. PATH is `force`, `punch.radius`, `layer[2].beta` and so \
on, with layers numbered from the top, starting at 1.

Examples:
  recede sweep scene.ron --vary force=0.001:0.004:4
  recede sweep scene.ron --vary punch.radius=1:1000:31:log --out radii.csv
  recede sweep scene.ron --vary layer[2].beta=[-1,0,1] --vary force=1:9:9
  recede sweep scene.ron --vary layer[2].beta=-3:1:41 --plot beta.svg
  recede sweep scene.ron --vary depth=0.01:0.1:10 --approach --out depths.csv
  recede sweep scene.ron --vary force=1:10:10 --extremes --out stresses.csv
  recede sweep scene.ron --vary depth=1:9:9 --plot p.svg --x depth --y force
  recede sweep scene.ron --vary force=1:9:9 --plot p.svg --log x,y
  recede sweep sweep.ron --plot map.png --log colours --colours viridis
  recede sweep scene.ron --vary force=1:10:10 --at 0,0.2@1=eps_xx
  recede sweep scene.ron --rows samples.csv --out results.csv
  recede sweep scene.ron --set layer[1].thickness=2 --vary force=1:10:10
  recede sweep sweep.ron --out grid.csv --resume
  recede sweep sweep.ron --part 17/400 --out part_17.csv

A scene without solution is a row with its reason. Exit status: 0 all rows were made, 2 bad input.")]
pub struct SweepArguments {
    #[command(flatten)]
    grid: GridArguments,
    /// Write rows to this file rather than to standard output: comma-separated values, or Parquet if it is built in
    #[arg(long, value_name = "FILE.csv|parquet")]
    out: Option<PathBuf>,
    /// Go on where an interrupted sweep has left the file
    #[arg(long, requires = "out")]
    resume: bool,
    /// Compute part K of N only, neighbouring rows: `recede merge` puts the files of all parts together
    #[arg(long, value_name = "K/N")]
    part: Option<Part>,
    /// Draw curves over the axis with most values, or maps over two axes of six values or more
    #[arg(long, value_name = "FILE.svg|pdf|png")]
    plot: Option<PathBuf>,
    /// Draw these columns of the table rather than half-lengths and pressures: `--y approach,layer_1_von_mises`
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', requires = "plot")]
    y: Vec<String>,
    /// Draw them over this column rather than over the axis with most values: `--x approach --y force`
    #[arg(long, value_name = "NAME", requires = "y")]
    x: Option<String>,
    /// Axes on which equal ratios, not equal differences, are equally far apart, and colours of maps: `--log x`, `--log x,y`, `--log colours`
    #[arg(long, value_name = "x,y,colours", value_delimiter = ',', requires = "plot")]
    log: Vec<Logarithmic>,
    #[command(flatten)]
    colours: ColourOptions,
    #[command(flatten)]
    page: Page,
    /// Threads that compute [default: one for each processor]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
}

/// A scale of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Logarithmic {
    X,
    Y,
    Colours,
}

impl SweepArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        self.check_picture()?;
        let is_parquet = self.out.as_deref().map_or(Ok(false), rows_file::is_parquet)?;
        // a Parquet file is none before it is complete: rows are kept as lines until then
        let lines = self.out.as_ref().map(|out| if is_parquet { lines_of(out) } else { out.clone() });
        let sweep = Arc::new(self.grid.sweep()?);
        self.check_files(&sweep, lines.as_deref().filter(|_| is_parquet))?;
        let csv = SweepCsv::new(&sweep);
        let columns = self.columns(&csv)?;
        if self.style() != MapStyle::default() && !plot::is_map(&sweep, &columns) {
            return Err(Failure::usage(
                "colours are of a map, and this sweep is drawn as curves",
                "leave out --range, --levels, --colours and --log colours and the column --x, or vary two quantities with six values or more each",
            ));
        }
        let drawn = |index| self.plot.is_some() && plot::is_drawn(&sweep, index);
        let mut rows = Vec::new();
        let wanted = self.part.map_or(0..sweep.len(), |part| part.rows(sweep.len()));
        let (mut file, done) = match &lines {
            Some(path) if self.resume => rows_file::resume(path, &csv, wanted.clone(), |index, line| {
                if drawn(index) {
                    rows.push(csv.point_of(line));
                }
            })?,
            Some(path) => (rows_file::create(path, &csv)?, 0),
            None => {
                out.write_all(csv.header()?.as_bytes())?;
                (Box::new(out) as Box<dyn Write>, 0)
            }
        };
        // rows on a terminal show by themselves how far the sweep has come
        let is_shown = self.out.is_some() || !io::stdout().is_terminal();
        let bar = is_shown.then(|| Progress::new("rows", wanted.len() as u64, done as u64));
        let mut unsolved = 0;
        let threads = self.threads.or_else(|| thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
        for row in sweep.parallel_rows(wanted.start + done..wanted.end, threads) {
            file.write_all(csv.line(&row)?.as_bytes())?;
            unsolved += usize::from(row.result.is_err());
            if drawn(row.index) {
                rows.push(csv.point(&row));
            }
            bar.iter().for_each(Progress::step);
        }
        bar.iter().for_each(Progress::finish);
        if let (true, Some(lines), Some(path)) = (is_parquet, &lines, &self.out) {
            rows_file::copy(path, &csv, [&**lines])?;
            fs::remove_file(lines).map_err(|cause| Failure::file(lines, cause))?;
        }
        if unsolved > 0 {
            let rows = wanted.len() - done;
            tell(&format!("warning: {unsolved} of {rows} rows have no solution; column `message` says why\n"));
        }
        if let Some(file) = &self.plot {
            let picture = plot::sweep(&sweep, &rows, &columns)?;
            self.page.save(picture, sweep.scene(), file)?;
        }
        Ok(())
    }

    /// How maps are coloured.
    fn style(&self) -> MapStyle {
        self.colours.style(self.log.contains(&Logarithmic::Colours))
    }

    /// The columns that are drawn, by their names.
    fn columns(&self, csv: &SweepCsv) -> Result<DrawnColumns, Failure> {
        let column = |name: &String| {
            let names = csv.names();
            let found = names.iter().position(|own| own == name);
            let unknown = || {
                Failure::usage(
                    format!("the table has no column of numbers `{name}`"),
                    format!("there are {}; `--approach`, `--extremes` and `--at` add more", names.join(", ")),
                )
            };
            Ok((found.ok_or_else(unknown)?, name.clone()))
        };
        Ok(DrawnColumns {
            along: self.x.as_ref().map(column).transpose()?,
            up: self.y.iter().map(column).collect::<Result<_, Failure>>()?,
            logarithmic: [Logarithmic::X, Logarithmic::Y].map(|axis| self.log.contains(&axis)),
            style: self.style(),
        })
    }

    /// Whether the picture, if there is to be one, can be drawn.
    fn check_picture(&self) -> Result<(), Failure> {
        if let (Some(part), Some(_)) = (self.part, &self.plot) {
            return Err(Failure::usage(
                format!(
                    "--plot cannot be used with --part: a picture of part {part} would show some of the rows as if they were all"
                ),
                "leave out --plot; once `recede merge` has put the parts together, the sweep with --resume and --plot draws the merged file",
            ));
        }
        if self.grid.rows.is_some() && self.plot.is_some() {
            return Err(Failure::usage(
                "--plot cannot be used with --rows: pictures are drawn of grids",
                "leave out --plot, or make a grid by --vary",
            ));
        }
        if self.plot.is_none() && self.style() != MapStyle::default() {
            return Err(Failure::usage("colours are of a map", "name the file of the picture, --plot FILE.svg"));
        }
        if self.colours.range.is_some() && self.y.len() != 1 {
            return Err(Failure::usage(
                format!("--range is of one column, found {} names in --y", self.y.len()),
                "name the column that is drawn: --y punch_peak_pressure",
            ));
        }
        // that a picture cannot be written is better known before than after
        self.plot.as_deref().map(Kind::of).transpose()?;
        Ok(())
    }

    /// Whether the rows, the picture, and the lines from which a file of another kind is made, are files of their own.
    fn check_files(&self, sweep: &Sweep, lines: Option<&Path>) -> Result<(), Failure> {
        let stdout = Some(Path::new(outputs::OUTPUT)).filter(|stdout| stdout.exists());
        let rows = self.out.as_deref().or(stdout);
        let written: Vec<&Path> = [rows, lines, self.plot.as_deref()].into_iter().flatten().collect();
        outputs::check(&self.grid.files(sweep), &written)
    }
}

/// The file of lines from which a Parquet file is made.
fn lines_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".csv");
    name.into()
}
