//! `recede completions` and `recede man`: generated from the definition of the command.
use std::io::Write;

use clap::CommandFactory;
use clap_complete::Shell;

use super::{Arguments, Failure};

/// Print completions for a shell
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede completions bash > ~/.local/share/bash-completion/completions/recede
  recede completions zsh > ~/.zfunc/_recede
  recede completions fish > ~/.config/fish/completions/recede.fish")]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl CompletionsArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let mut text = Vec::new();
        clap_complete::generate(self.shell, &mut Arguments::command(), "recede", &mut text);
        Ok(out.write_all(&text)?)
    }
}

/// Print the manual page
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede man | man -l -
  recede man sweep > recede-sweep.1
  recede man > ~/.local/share/man/man1/recede.1")]
pub struct ManArguments {
    /// The subcommand whose page it is to be, rather than the page of the whole
    command: Option<String>,
}

impl ManArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let mut whole = Arguments::command();
        whole.build();
        let command = match &self.command {
            None => &whole,
            Some(name) => whole.find_subcommand(name).ok_or_else(|| {
                let names: Vec<&str> = whole.get_subcommands().map(clap::Command::get_name).collect();
                Failure::usage(format!("there is no subcommand `{name}`"), format!("there are {}", names.join(", ")))
            })?,
        };
        Ok(clap_mangen::Man::new(command.clone()).render(out)?)
    }
}
