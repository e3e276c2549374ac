//! `workbook new`: one chapter more, at the end of the order.

use clap::Args;

use super::{Exit, Options, report};
use crate::compose::check;
use crate::diag::{Code, Diagnostic, Severity};
use crate::starter;
use crate::workspace::{CHAPTERS, CONFIGURATION};
use crate::write::fresh;

#[derive(Args)]
pub(super) struct Arguments {
    /// The title of the chapter
    title: String,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let planned = check(&options.request());
    // Mistakes in chapters are no matter; without a sound configuration it is not known what the order is.
    let bars = |error: &&Diagnostic| {
        error.severity == Severity::Error
            && (error.code == Code::NoCourse || error.place.as_ref().is_some_and(|place| &*place.file == CONFIGURATION))
    };
    let barring: Vec<Diagnostic> = planned.diagnostics.iter().filter(bars).cloned().collect();
    if !barring.is_empty() {
        report::diagnostics(&barring, &planned.workspace, options);
        return Exit::of(&barring);
    }
    let added = starter::addition(&arguments.title, &planned.workspace, &planned.course, &planned.plan);
    let addition = match added {
        Ok(addition) => addition,
        Err(error) => return report::wrong(&error, Exit::Call, options),
    };
    let file = (addition.path.clone(), addition.text.into_bytes());
    let written = fresh::create(&options.root, &[file]).and_then(|()| match &addition.configuration {
        Some(text) => fresh::replace(&options.root.join(CONFIGURATION), text).inspect_err(|_| {
            fresh::take_back(&options.root.join(&addition.path));
        }),
        None => Ok(()),
    });
    if let Err(error) = written {
        return report::wrong(&error, Exit::of_code(error.code), options);
    }
    let place = match addition.configuration {
        Some(_) => format!("and its place in `order` of {CONFIGURATION}"),
        None => format!("which is read by its name, as all files in {CHAPTERS}/ are"),
    };
    report::say(&format!("wrote {}, {place}", addition.path), options);
    Exit::Fine
}
