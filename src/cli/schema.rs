//! `workbook schema`: the JSON schema of something that authors write.

use clap::{Args, ValueEnum};

use super::{Exit, report};
use crate::schema;

#[derive(Args)]
pub(super) struct Arguments {
    /// Of what
    #[arg(value_enum)]
    of: Of,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Of {
    /// An `experiment` fence
    Fence,
    /// A `listing` fence
    Listing,
    /// The front matter of a chapter
    FrontMatter,
    /// The settings, chapters/workbook.toml
    Config,
}

pub(super) fn run(arguments: &Arguments) -> Exit {
    let schema = match arguments.of {
        Of::Fence => schema::fence(),
        Of::Listing => schema::listing(),
        Of::FrontMatter => schema::front_matter(),
        Of::Config => schema::configuration(),
    };
    report::to_stdout_as_json(&schema);
    Exit::Fine
}
