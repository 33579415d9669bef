//! The command `recede`: reads a scene, runs the subcommand, and returns its exit status.
mod cli;

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    // bad arguments end here, with status 2
    let arguments = cli::Arguments::parse();
    let Err(failure) = arguments.run() else { return ExitCode::SUCCESS };
    cli::explain(&failure);
    match failure {
        cli::Failure::Scene(error) if !error.is_input() => ExitCode::from(1),
        cli::Failure::Wrong(_) => ExitCode::from(1),
        _ => ExitCode::from(2),
    }
}
