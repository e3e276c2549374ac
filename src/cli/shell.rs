//! `workbook completions` and `workbook man`: what a shell and the system's manual know of the program.

use std::io;

use clap::{Args, CommandFactory, ValueEnum};
use clap_complete::Shell;

use super::{Cli, Exit, Options, report};
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic};

#[derive(Args)]
pub(super) struct Completions {
    /// For which shell
    #[arg(value_enum)]
    shell: Words,
}

/// The shells that are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Words {
    Bash,
    Zsh,
    Fish,
    Powershell,
    Elvish,
}

#[derive(Args)]
pub(super) struct Manual {
    /// One command, to print its own page
    command: Option<String>,
}

/// Prints the completions of a shell.
pub(super) fn completions(arguments: &Completions, options: &Options) -> Exit {
    let shell = match arguments.shell {
        Words::Bash => Shell::Bash,
        Words::Zsh => Shell::Zsh,
        Words::Fish => Shell::Fish,
        Words::Powershell => Shell::PowerShell,
        Words::Elvish => Shell::Elvish,
    };
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "workbook", &mut text);
    report::stream(options, |out| out.write_all(&text))
}

/// Prints the manual's page of the program, or that of one command.
pub(super) fn manual(arguments: &Manual, options: &Options) -> Exit {
    let mut whole = Cli::command();
    whole.build();
    let page = match &arguments.command {
        None => whole,
        Some(name) => {
            let Some(command) = whole.find_subcommand(name) else {
                let near = nearest(name, whole.get_subcommands().map(clap::Command::get_name));
                let error = Diagnostic::error(Code::UnknownName, format!("there is no command `{name}`"))
                    .help_if(near.map(|near| format!("did you mean `{near}`?")));
                return report::wrong(&error, Exit::Call, options);
            };
            command.clone()
        }
    };
    let mut text = Vec::new();
    // Only writing to the text could fail, and it cannot.
    let rendered: io::Result<()> = clap_mangen::Man::new(page).render(&mut text);
    report::stream(options, |out| rendered.and_then(|()| out.write_all(&text)))
}
