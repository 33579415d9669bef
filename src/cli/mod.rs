//! The command line: one file for each subcommand.
mod check;
mod convert;
mod field;
mod generate;
mod grid;
mod init;
mod list;
mod merge;
mod outputs;
mod plot;
mod profile;
mod progress;
mod rows_file;
mod selftest;
mod show;
mod solve;
mod sweep;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand};
use recede::plot::PlotError;
use recede::{Error, FieldError, Model, Options, Registry, Scene, Solution, visible};

/// Receding and advancing contact of layered elastic stacks.
#[derive(Debug, Parser)]
#[command(version, about, max_term_width = 100, after_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  recede init scene.ron                       a scene to begin with
  recede check scene.ron                      draw the stack, solve nothing
  recede solve scene.ron                      extents of contacts, and pressures
  recede solve scene.ron --format json        the same for a script
  recede solve - < scene.ron                  a scene from standard input
  recede plot scene.ron --out scene.svg       stack, contacts and pressures
  recede field scene.ron --out field.csv      stresses and displacements inside
  recede field scene.ron --out shear.svg      a map of the largest shear stress
  recede profile scene.ron --out profile.csv  pressures and gaps along the faces
  recede sweep scene.ron --vary force=1:9:5   contacts for five forces
  recede show scene.ron --latex               the block matrix for LaTeX
  recede convert scene.ron --out scene.json   a scene for other programs
  recede list                                 all that a scene may contain

Exit status: 0 solved, 1 no admissible solution, 2 bad input.";

#[derive(Debug, Subcommand)]
enum Command {
    Solve(solve::SolveArguments),
    Check(check::CheckArguments),
    Show(show::ShowArguments),
    Convert(convert::ConvertArguments),
    Field(field::FieldArguments),
    Profile(profile::ProfileArguments),
    List(list::ListArguments),
    Selftest(selftest::SelftestArguments),
    Sweep(sweep::SweepArguments),
    Merge(merge::MergeArguments),
    Plot(plot::PlotArguments),
    Init(init::InitArguments),
    Completions(generate::CompletionsArguments),
    Man(generate::ManArguments),
}

/// Why a command did not end well.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The scene, or its solution.
    #[error(transparent)]
    Scene(#[from] Error),
    /// Arguments that do not go together, or a file that is not what it should be.
    #[error("{message}")]
    Usage {
        /// What is wrong.
        message: String,
        /// What to do.
        hint: String,
    },
    /// A file that could not be read or written.
    #[error("{file}: {cause}")]
    File {
        /// The name of the file.
        file: String,
        /// Why.
        #[source]
        cause: io::Error,
    },
    /// A picture that could not be drawn or written.
    #[error(transparent)]
    Picture(#[from] PlotError),
    /// Output that could not be written.
    #[error("cannot write the output: {0}")]
    Output(#[from] io::Error),
    /// Random scenes with answers that cannot be right.
    #[error("{0} scenes ended with a panic, a wrong answer, or beyond their limits")]
    Wrong(usize),
}

impl From<FieldError> for Failure {
    fn from(error: FieldError) -> Self {
        Self::Scene(error.into())
    }
}

impl Failure {
    fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Usage { message: message.into(), hint: hint.into() }
    }

    fn file(path: &Path, cause: io::Error) -> Self {
        Self::File { file: path.display().to_string(), cause }
    }

    /// What to do about it, if that can be said.
    fn hint(&self) -> Option<String> {
        match self {
            Self::Scene(error) => error.hint(),
            Self::Usage { hint, .. } => Some(hint.clone()),
            _ => None,
        }
    }
}

impl Arguments {
    /// Runs the subcommand; data go to standard output.
    pub fn run(&self) -> Result<(), Failure> {
        let mut out = io::BufWriter::new(io::stdout().lock());
        let done = match &self.command {
            Command::Solve(command) => command.run(&mut out),
            Command::Check(command) => command.run(&mut out),
            Command::Show(command) => command.run(&mut out),
            Command::Convert(command) => command.run(&mut out),
            Command::Field(command) => command.run(&mut out),
            Command::Profile(command) => command.run(&mut out),
            Command::List(command) => command.run(&mut out),
            Command::Selftest(command) => command.run(&mut out),
            Command::Sweep(command) => command.run(&mut out),
            Command::Merge(command) => command.run(),
            Command::Plot(command) => command.run(),
            Command::Init(command) => command.run(&mut out),
            Command::Completions(command) => command.run(&mut out),
            Command::Man(command) => command.run(&mut out),
        };
        match done.and_then(|()| Ok(out.flush()?)) {
            // the reader has closed the pipe
            Err(
                Failure::Output(cause) | Failure::File { cause, .. } | Failure::Picture(PlotError::File { cause, .. }),
            ) if cause.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            other => other,
        }
    }
}

/// The scene file of a subcommand.
#[derive(Debug, clap::Args)]
struct SceneFile {
    /// Scene in RON or JSON; `-` reads standard input
    #[arg(value_name = "SCENE.ron")]
    scene: PathBuf,
    #[command(flatten)]
    settings: Settings,
}

/// Other values of some quantities of a scene.
#[derive(Debug, clap::Args)]
struct Settings {
    /// Give a quantity of the scene another value: `force=0.01`, `layer[2].young="31 GPa"`; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = setting)]
    all: Vec<(String, String)>,
}

impl Settings {
    /// The scene with these values.
    fn made(&self, scene: Scene) -> Result<Scene, Error> {
        let made =
            |scene: Scene, (path, value): &(String, String)| scene.with(path, scene.written_number(path, value)?);
        Ok(self.all.iter().try_fold(scene, made)?)
    }
}

/// Reads PATH=VALUE.
fn setting(text: &str) -> Result<(String, String), String> {
    let wrong = || format!("PATH=VALUE is expected, such as force=0.01, found `{text}`");
    let (path, value) = text.split_once('=').ok_or_else(wrong)?;
    Ok((path.trim().to_owned(), value.trim().trim_matches('"').to_owned()))
}

impl SceneFile {
    /// The scene, from which the command writes these files.
    fn read_for(&self, written: &[&Path]) -> Result<Scene, Failure> {
        outputs::check(&[&self.scene], written)?;
        Ok(self.read()?)
    }

    fn read(&self) -> Result<Scene, Error> {
        let scene = if self.scene == Path::new("-") {
            Scene::from_reader("stdin", io::stdin().lock(), &Registry::default())?
        } else {
            Scene::read(&self.scene)?
        };
        self.settings.made(scene)
    }
}

/// The model of a scene's stack, and the solution under what presses in the scene.
fn solved(scene: &Scene, tolerance: f64) -> Result<(Model, Solution), Error> {
    let solved = Model::new(scene.stack()?).and_then(|model| {
        let solution = model.press_with(&scene.top, scene.force, &Options { tolerance })?;
        Ok((model, solution))
    });
    solved.map_err(|error| scene.locate(error))
}

/// Tells the warnings of a solution.
fn warn(solution: &Solution) {
    solution.warnings().iter().for_each(|warning| tell(&format!("warning: {warning}\n")));
}

/// Tells on standard error what went wrong, where, and what to do.
pub fn explain(failure: &Failure) {
    const ERROR: anstyle::Style = anstyle::AnsiColor::Red.on_default().bold();
    const HINT: anstyle::Style = anstyle::AnsiColor::Cyan.on_default().bold();
    let mut text = format!("{ERROR}error{ERROR:#}: {}\n", visible(&failure.to_string()));
    if let Failure::Scene(Error::Scene(error)) = failure {
        for line in error.excerpt().iter().flat_map(|excerpt| excerpt.lines()) {
            text += &format!("  {line}\n");
        }
    }
    if let Some(hint) = failure.hint() {
        text += &format!("{HINT}hint{HINT:#}: {}\n", visible(&hint));
    }
    to_stderr(&text);
}

/// Tells something in whole lines on standard error.
fn tell(lines: &str) {
    to_stderr(&lines.lines().map(|line| visible(line) + "\n").collect::<String>());
}

/// Writes to standard error, in colour on a terminal only. A failure to write is ignored.
fn to_stderr(text: &str) {
    let _ = anstream::stderr().write_all(text.as_bytes());
}
