//! `workbook compare`: what differs between two books, as a report and in a few lines.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::Value as Json;

use super::progress::Progress;
use super::{Exit, Format, Options, report};
use crate::compare::{Report, Side, compare};
use crate::compose::{Request, compose};
use crate::diag::{Code, Diagnostic, any_error};
use crate::render;
use crate::workspace::Workspace;
use crate::workspace::revision::Checkout;
use crate::write::{self, fresh};

#[derive(Args)]
pub(super) struct Arguments {
    /// The old book: a folder with a built book, or a revision that git knows
    old: String,
    /// The new one; if it is not given, the course as it is now
    new: Option<String>,
    /// The file for the report
    #[arg(long, value_name = "FILE", default_value = "comparison.html")]
    report: PathBuf,
    /// End with 1 if anything differs
    #[arg(long)]
    exit_code: bool,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let sides = side(Some(&arguments.old), options)
        .and_then(|old| side(arguments.new.as_deref(), options).map(|new| (old, new)));
    let (old, new) = match sides {
        Ok(sides) => sides,
        Err(exit) => return exit,
    };
    let compared = match compare(&old, &new) {
        Ok(compared) => compared,
        Err(error) => return report::wrong(&error, Exit::Call, options),
    };
    let page = render::comparison(&compared, compared.is_empty(), &compared.added, &compared.removed);
    if let Err(error) = page.and_then(|page| fresh::replace(&arguments.report, &page)) {
        return report::wrong(&error, Exit::System, options);
    }
    if options.format == Format::Json {
        report::to_stdout_as_json(&json(&compared));
    } else {
        report::to_stdout(&compared.summary());
    }
    report::say(&format!("wrote {}", arguments.report.display()), options);
    if arguments.exit_code && !compared.is_empty() { Exit::Course } else { Exit::Fine }
}

/// The book that `name` means; the course as it is now if nothing is named.
fn side(name: Option<&str>, options: &Options) -> Result<Side, Exit> {
    let Some(name) = name else { return built("the course as it is now", &options.root, true, options) };
    let folder = Path::new(name);
    if folder.is_dir() {
        let files = write::contents(folder).unwrap_or_default();
        return Ok(Side { name: name.to_owned(), files });
    }
    match Checkout::of(&options.root, name, &std::env::temp_dir()) {
        Ok(checkout) => built(name, &checkout.root(), false, options),
        Err(why) => {
            let message = format!("`{name}` is neither a folder with a book nor a revision: {why}");
            Err(report::wrong(&Diagnostic::error(Code::History, message), Exit::Call, options))
        }
    }
}

/// The book of the course at `root`.
fn built(name: &str, root: &Path, cached: bool, options: &Options) -> Result<Side, Exit> {
    report::say(&format!("building {name}"), options);
    let cached = cached && !options.no_cache;
    let request = Request { root: root.to_owned(), cached, ..options.request() };
    let composed = compose(&request, &Progress::new(options));
    if any_error(&composed.diagnostics) {
        report::diagnostics(&composed.diagnostics, &composed.workspace, options);
        let message = format!("{name} gives no book");
        let error = Diagnostic::error(Code::NotABook, message).help("compare a folder with a book that was built then");
        report::diagnostics(&[error], &Workspace::default(), options);
        return Err(Exit::of(&composed.diagnostics));
    }
    Ok(Side { name: name.to_owned(), files: composed.book.files })
}

/// The comparison for machines: without the drawings themselves, which are files of the books.
fn json(compared: &Report) -> Json {
    let mut json = serde_json::to_value(compared).unwrap_or_default();
    let lists = ["changed", "added", "removed"];
    let lists =
        lists.iter().filter_map(|list| json.pointer(&format!("/{list}"))?.as_array().map(|all| (*list, all.len())));
    for (list, count) in lists.collect::<Vec<_>>() {
        for at in 0..count {
            let pictures = json.pointer_mut(&format!("/{list}/{at}/pictures")).and_then(Json::as_array_mut);
            for picture in pictures.into_iter().flatten().filter_map(Json::as_object_mut) {
                picture.retain(|name, _| name == "path" || name == "note");
            }
        }
    }
    json
}
