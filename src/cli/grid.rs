//! The sweep that a file and options name together, for all commands that need one.
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use recede::{Axis, Error, MAX_BYTES, Options, Probe, Registry, Scene, Sweep};

use super::{Failure, Settings};

/// The scene and the axes of a sweep, and its options, by which it is told from others.
#[derive(Debug, clap::Args)]
pub(super) struct GridArguments {
    /// Scene, or sweep, in RON; `-` reads standard input
    #[arg(value_name = "SCENE.ron")]
    pub(super) file: PathBuf,
    /// What varies: PATH=START:STOP:COUNT, PATH=START:STOP:COUNT:log or PATH=[v,v,...]; numbers may have units, `depth=[20 nm, 30 nm]`
    #[arg(long, value_name = "PATH=VALUES")]
    vary: Vec<String>,
    /// Solve each row of this table rather than a grid: comma-separated values, with the paths of quantities as the first line
    #[arg(long, value_name = "FILE.csv", conflicts_with = "vary")]
    pub(super) rows: Option<PathBuf>,
    #[command(flatten)]
    settings: Settings,
    /// Add columns with the approach of the punch and the stiffness: how far it sinks, dP/d(approach)
    #[arg(long)]
    approach: bool,
    /// Add columns with the stresses and strains by which layers and bonds break: tension, von Mises stress and tensile strain of each layer, shear stress and
    /// tension across each interface that does not open
    #[arg(long)]
    extremes: bool,
    /// Add a column with a stress, strain or displacement at a point, with names as in `recede field`: `0,0.2@1=eps_xx`, `0,0.2@asphalt=eps_xx`, or X,Y,DEPTH under loads at places (x, y);
    /// may be repeated
    #[arg(long, value_name = "X,DEPTH[@LAYER]=QUANTITY", allow_hyphen_values = true)]
    at: Vec<String>,
    /// Relative error to aim at, from 1e-13 to 1e-2 [default: 1e-10]
    #[arg(long)]
    tolerance: Option<f64>,
}

impl GridArguments {
    /// The sweep.
    pub(super) fn sweep(&self) -> Result<Sweep, Failure> {
        let registry = Registry::default();
        let name = if self.file == Path::new("-") { Path::new("stdin") } else { &self.file };
        let text = self.text().map_err(|cause| Failure::file(&self.file, cause))?;
        let sweep = if std::str::from_utf8(&text).is_ok_and(Sweep::begins) {
            if self.rows.is_some() || !self.settings.all.is_empty() {
                return Err(Failure::usage(
                    format!("{} is a sweep, and --rows and --set are for scenes", self.file.display()),
                    "name the scene itself, or write its values there",
                ));
            }
            let sweep = Sweep::from_reader(name, &text[..], &registry)?;
            let axes = self.axes(sweep.scene())?;
            sweep.and_vary(axes)?
        } else {
            let scene = Scene::from_reader(&name.display().to_string(), &text[..], &registry).map_err(Error::from)?;
            let scene = self.settings.made(scene)?;
            match &self.rows {
                Some(rows) => Sweep::of_rows(scene, columns(rows)?)?,
                None if self.vary.is_empty() => {
                    let paths = scene.paths().join(", ");
                    return Err(Failure::usage(
                        "nothing varies: --vary PATH=START:STOP:COUNT, or --rows FILE.csv, is missing",
                        format!("what can vary in this scene: {paths}"),
                    ));
                }
                None => {
                    let axes = self.axes(&scene)?;
                    Sweep::new(scene, axes)?
                }
            }
        };
        let tolerance = self.tolerance.unwrap_or(sweep.options().tolerance);
        let sweep = sweep.with_options(Options { tolerance })?;
        let probe = |text: &String| Probe::parse(&sweep.scene().numbered(text), sweep.scene().coordinates());
        let probes = self.at.iter().map(probe).collect::<Result<_, _>>().map_err(Error::from)?;
        let sweep = sweep.with_probes(probes);
        let sweep = if self.approach { sweep.with_approach() } else { sweep };
        Ok(if self.extremes { sweep.with_extremes() } else { sweep })
    }

    /// What varies.
    fn axes(&self, scene: &Scene) -> Result<Vec<Axis>, Error> {
        self.vary.iter().map(|text| scene.axis(text)).collect()
    }

    /// The files that are read: the one that was named, and the scene of a sweep in a file of its own.
    pub(super) fn files<'a>(&'a self, sweep: &'a Sweep) -> Vec<&'a Path> {
        [&*self.file].into_iter().chain(self.rows.as_deref()).chain(sweep.scene().file().map(Path::new)).collect()
    }

    /// The bytes of the file, at most as many as a scene may have.
    fn text(&self) -> io::Result<Vec<u8>> {
        let is_input = self.file == Path::new("-");
        let file: Box<dyn Read> = if is_input { Box::new(io::stdin()) } else { Box::new(File::open(&self.file)?) };
        let mut text = Vec::new();
        file.take(MAX_BYTES as u64 + 1).read_to_end(&mut text)?;
        Ok(text)
    }
}

/// The columns of a table, each as an axis; its first line has their paths.
fn columns(file: &Path) -> Result<Vec<Axis>, Failure> {
    let hint =
        "the first line has paths such as force,layer[1].thickness, and each other line a number for each of them";
    let wrong = |message: String| Failure::usage(format!("{}: {message}", file.display()), hint);
    let unread = |cause: csv::Error| wrong(cause.to_string());
    let open = File::open(file).map_err(|cause| Failure::file(file, cause))?;
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(open);
    let paths: Vec<String> = reader.headers().map_err(unread)?.iter().map(str::to_owned).collect();
    let mut columns = vec![Vec::new(); paths.len()];
    for record in reader.records() {
        let record = record.map_err(unread)?;
        let line = record.position().map_or(0, csv::Position::line);
        for ((field, path), column) in record.iter().zip(&paths).zip(&mut columns) {
            let value = field
                .parse()
                .map_err(|_| wrong(format!("found `{field}` as {path} in line {line}, a number is expected")))?;
            column.push(value);
        }
    }
    if columns.iter().all(Vec::is_empty) {
        return Err(wrong("there are no rows".to_owned()));
    }
    let axis = |(path, values): (&String, Vec<f64>)| Ok(Axis::list(path, values).map_err(Error::from)?);
    paths.iter().zip(columns).map(axis).collect()
}
