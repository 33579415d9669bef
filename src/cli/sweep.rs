//! `recede sweep`: a scene for many values of some of its quantities.
use std::fs::File;
use std::io::{self, IsTerminal, Read, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;

use recede::plot::{self, Kind};
use recede::report::SweepCsv;
use recede::{Axis, MAX_BYTES, Options, Registry, Scene, Sweep};

use super::plot::Title;
use super::progress::Progress;
use super::rows_file::RowsFile;
use super::{Failure, tell};

/// Solve a scene for many values of some of its quantities
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Several --vary make a grid, in which the last one changes first. PATH is `force`, `punch.radius`, `layer[2].beta` and so
on, with layers numbered from the top, starting at 1.

Examples:
  recede sweep scene.ron --vary force=0.001:0.004:4
  recede sweep scene.ron --vary punch.radius=1:1000:31:log --out radii.csv
  recede sweep scene.ron --vary layer[2].beta=[-1,0,1] --vary force=0.001:0.01:10 --out grid.csv
  recede sweep scene.ron --vary layer[2].beta=-3:1:41 --out beta.csv --plot beta.svg
  recede sweep scene.ron --vary depth=0.01:0.1:10 --approach --out depths.csv
  recede sweep scene.ron --vary force=1:10:10 --extremes --out stresses.csv
  recede sweep sweep.ron --out grid.csv --resume

A scene without solution is a row with its reason. Exit status: 0 all rows were made, 2 bad input.")]
pub struct Command {
    /// Scene, or sweep, in RON; `-` reads standard input
    #[arg(value_name = "SCENE.ron")]
    file: PathBuf,
    /// What varies: PATH=START:STOP:COUNT, PATH=START:STOP:COUNT:log or PATH=[v,v,...]
    #[arg(long, value_name = "PATH=VALUES")]
    vary: Vec<Axis>,
    /// Write comma-separated values to this file rather than to standard output
    #[arg(long, value_name = "FILE.csv")]
    out: Option<PathBuf>,
    /// Go on where an interrupted sweep has left the file
    #[arg(long, requires = "out")]
    resume: bool,
    /// Add columns with the approach of the punch and the stiffness: how far it sinks, dP/d(approach)
    #[arg(long)]
    approach: bool,
    /// Add columns with the stresses by which layers and bonds break: tension, von Mises stress of each layer, shear stress and tension
    /// across each interface that does not open
    #[arg(long)]
    extremes: bool,
    /// Draw curves over the axis with most values, or maps over two axes of six values or more
    #[arg(long, value_name = "FILE.svg|pdf|png")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    title: Title,
    /// Threads that compute [default: one for each processor]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Relative error to aim at, from 1e-13 to 1e-2 [default: 1e-10]
    #[arg(long)]
    tolerance: Option<f64>,
}

impl Command {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        // that a picture cannot be written is better known before than after
        self.plot.as_deref().map(Kind::of).transpose()?;
        let sweep = Arc::new(self.sweep()?);
        let csv = SweepCsv::new(&sweep);
        let drawn = |index| self.plot.is_some() && plot::is_drawn(&sweep, index);
        let mut rows = Vec::new();
        let (mut file, first) = match &self.out {
            Some(path) if self.resume => RowsFile::resume(path, &csv, sweep.len(), |index, line| {
                if drawn(index) {
                    rows.push(csv.point_of(line));
                }
            })?,
            Some(path) => (RowsFile::create(path, &csv)?, 0),
            None => {
                out.write_all(csv.header()?.as_bytes())?;
                (RowsFile::Stream(out), 0)
            }
        };
        let bar = progress(sweep.len(), first, self.out.is_some());
        let mut unsolved = 0;
        let threads = self.threads.or_else(|| thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
        for row in sweep.parallel_rows(first, threads) {
            file.write(&csv.line(&row)?)?;
            unsolved += usize::from(row.result.is_err());
            if drawn(row.index) {
                rows.push(csv.point(&row));
            }
            bar.step();
        }
        bar.finish();
        if unsolved > 0 {
            let rows = sweep.len() - first;
            tell(&format!("warning: {unsolved} of {rows} rows have no solution; column `message` says why\n"));
        }
        if let Some(file) = &self.plot {
            let picture = plot::sweep(&sweep, &rows)?;
            plot::save(file, &self.title.above(picture, sweep.scene()))?;
        }
        Ok(())
    }

    /// The sweep given by file and options together.
    fn sweep(&self) -> Result<Sweep, Failure> {
        let registry = Registry::default();
        let name = if self.file == Path::new("-") { Path::new("stdin") } else { &self.file };
        let text = self.text().map_err(|cause| Failure::file(&self.file, cause))?;
        let sweep = if std::str::from_utf8(&text).is_ok_and(Sweep::begins) {
            let sweep = Sweep::from_reader(name, &text[..], &registry)?;
            if self.vary.is_empty() { sweep } else { sweep.and_vary(self.vary.clone())? }
        } else {
            let scene = Scene::from_reader(&name.display().to_string(), &text[..], &registry)?;
            if self.vary.is_empty() {
                let paths = scene.paths().join(", ");
                return Err(Failure::usage(
                    "nothing varies: --vary PATH=START:STOP:COUNT is missing",
                    format!("what can vary in this scene: {paths}"),
                ));
            }
            Sweep::new(scene, self.vary.clone())?
        };
        let sweep = match self.tolerance {
            Some(tolerance) => sweep.with_options(Options { tolerance, ..Options::default() })?,
            None => sweep,
        };
        let sweep = if self.approach { sweep.with_approach() } else { sweep };
        Ok(if self.extremes { sweep.with_extremes() } else { sweep })
    }

    /// What is in the file; no more than a scene may have.
    fn text(&self) -> io::Result<Vec<u8>> {
        let mut text = Vec::new();
        let most = MAX_BYTES as u64 + 1;
        match self.file == Path::new("-") {
            true => io::stdin().lock().take(most).read_to_end(&mut text)?,
            false => File::open(&self.file)?.take(most).read_to_end(&mut text)?,
        };
        Ok(text)
    }
}

/// How far the sweep has come, unless its rows on a terminal show it.
fn progress(rows: usize, first: usize, rows_elsewhere: bool) -> Progress {
    if !rows_elsewhere && io::stdout().is_terminal() {
        return Progress::hidden();
    }
    Progress::new("rows", rows as u64, first as u64)
}
