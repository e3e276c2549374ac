//! `workbook init`: a small complete course to start from.

use std::path::PathBuf;

use clap::Args;

use super::{Exit, Options, report};
use crate::starter;
use crate::write::fresh;

#[derive(Args)]
pub(super) struct Arguments {
    /// The folder of the new course; it is made if it is not there
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// The title of the course
    #[arg(long, value_name = "TITLE")]
    title: Option<String>,
    /// Who writes it
    #[arg(long, value_name = "NAME")]
    author: Option<String>,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let files = starter::course(arguments.title.as_deref(), arguments.author.as_deref());
    if let Err(error) = fresh::create(&arguments.folder, &files) {
        return report::wrong(&error, Exit::of_code(error.code), options);
    }
    let folder = arguments.folder.display();
    report::say(&format!("wrote a course into {folder}:"), options);
    for (path, _) in &files {
        report::say(&format!("  {path}"), options);
    }
    let enter = if arguments.folder.as_os_str() == "." { String::new() } else { format!("cd {folder} && ") };
    report::say(&format!("next: {enter}workbook build"), options);
    report::say("when you have looked at its figures, `workbook accept` records them in book/workbook.lock", options);
    Exit::Fine
}
