//! `workbook run`: run the experiment of one exhibit and print its values, its data or its drawing.

use std::fmt::Write as _;
use std::sync::Arc;

use clap::Args;

use super::progress::Progress;
use super::{Exit, Format, Options, among, report};
use crate::compose::{Planned, check, job};
use crate::diag::Diagnostic;
use crate::kinds::{Entries, Failure, Frame, Measured, Outcome, Value};
use crate::parameters::COMMON_KEYS;
use crate::plan::{Change, Exhibit};
use crate::render::data;
use crate::run::Job;
use crate::workspace::Workspace;
use crate::{exhibits, run};

#[derive(Args)]
pub(super) struct Arguments {
    /// The exhibit's id
    id: String,
    /// A parameter of the experiment, or its seed, and the value that it is to have: TOML, or a word
    #[arg(short, long = "parameter", value_name = "NAME=VALUE", value_parser = change)]
    parameters: Vec<Change>,
    /// What is printed: its values (human), all of its data (json), its tables (csv, table) or its drawing (svg)
    #[arg(long, default_value = "human",
        value_parser = among(&[Format::Human, Format::Json, Format::Github, Format::Csv, Format::Table, Format::Svg]))]
    format: Format,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let told = if matches!(arguments.format, Format::Json | Format::Github) { arguments.format } else { Format::Human };
    let options = &Options { format: told, ..options.clone() };
    let request = options.request();
    let planned = check(&request);
    let Some(exhibit) = planned.plan.exhibit(&arguments.id) else {
        return report::no_exhibit(&arguments.id, &planned, options);
    };
    if !arguments.parameters.is_empty() {
        return run_changed(arguments, &planned, exhibit, options);
    }
    let ran = run::run(vec![job(exhibit)], request.cache().as_ref(), request.threads, &Progress::new(options));
    let Some(outcome) = ran.first().map(|ran| &ran.outcome) else { return Exit::System };
    let printed = outcome.as_ref().map_err(Clone::clone).and_then(|outcome| print(exhibit, outcome, arguments.format));
    end(printed, exhibit, &planned.workspace, options).unwrap_or(Exit::Course)
}

/// Reads `NAME=VALUE`.
fn change(written: &str) -> Result<Change, String> {
    let (name, value) = written.split_once('=').ok_or("write it as `name=value`, such as `n=4000`")?;
    let name = name.trim();
    if COMMON_KEYS.contains(&name) && name != "seed" {
        return Err(format!("`{name}` is no parameter of the experiment"));
    }
    if name.is_empty() || !name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"_-".contains(&byte)) {
        return Err(format!("`{name}` is no name of a parameter"));
    }
    Change::new(name, value.trim())
}

/// Runs the experiment with other parameters. For people, its values stand next to those in the book.
fn run_changed(arguments: &Arguments, planned: &Planned, exhibit: &Exhibit, options: &Options) -> Exit {
    let Some(changed) = planned.plan.changed(&planned.course, &exhibit.id, &arguments.parameters) else {
        return Exit::System;
    };
    let Some(after) = changed.exhibit else {
        report::diagnostics(&changed.diagnostics, &changed.workspace, options);
        return Exit::Call;
    };
    let request = options.request();
    let run = |job| {
        let ran = run::run(vec![job], request.cache().as_ref(), request.threads, &Progress::new(options));
        ran.into_iter().next().map(|ran| ran.outcome)
    };
    // The cache is to remember the exhibit as it is in the book.
    let Some(outcome) = run(Job::new(Vec::new(), Arc::clone(&after.experiment), after.seed)) else {
        return Exit::System;
    };
    let printed = outcome.and_then(|outcome| match arguments.format {
        Format::Human => {
            let before = run(job(exhibit)).and_then(Result::ok);
            Ok(before.map_or_else(|| as_text(&outcome), |before| side_by_side(&before, &outcome)))
        }
        format => print(&after, &outcome, format),
    });
    end(printed, &after, &changed.workspace, options).unwrap_or(Exit::Call)
}

/// Prints a text; tells what failed if there is none, and then how that ends is for the caller to say.
fn end(printed: Result<String, Failure>, exhibit: &Exhibit, workspace: &Workspace, options: &Options) -> Option<Exit> {
    match printed {
        Ok(text) => {
            report::to_stdout(&text);
            Some(Exit::Fine)
        }
        Err(failure) => {
            let failed: Diagnostic = exhibits::failed(exhibit, &failure);
            report::diagnostics(&[failed], workspace, options);
            None
        }
    }
}

/// What is printed of a result.
fn print(exhibit: &Exhibit, outcome: &Outcome, format: Format) -> Result<String, Failure> {
    let frames = || exhibit.experiment.tables(outcome);
    let several = |text: fn(&Frame) -> String| frames().iter().map(text).collect::<Vec<_>>().join("\n");
    Ok(match format {
        Format::Json => data::json(exhibit, outcome, &frames()),
        Format::Csv => several(data::csv),
        Format::Table => several(as_table),
        Format::Svg => drawing(exhibit, outcome)?,
        Format::Human | Format::Github | Format::Npy => as_text(outcome),
    })
}

/// The drawing, if it is one of lines.
fn drawing(exhibit: &Exhibit, outcome: &Outcome) -> Result<String, Failure> {
    let drawing = exhibits::draw(exhibit, outcome, &exhibits::words(exhibit, outcome))?;
    drawing.figure().map(|figure| figure.svg.clone()).ok_or_else(|| Failure {
        parameter: None,
        message: "it has no drawing of lines".to_owned(),
        help: Some(format!(
            "`--format table` prints its numbers; its pictures are files of the book, in `{}/`",
            data::FOLDER
        )),
    })
}

/// A frame with its columns aligned: words at the left, numbers at the right.
fn as_table(frame: &Frame) -> String {
    let cell = |entries: &Entries, row: usize| match entries {
        Entries::Numbers(numbers) => numbers.get(row).filter(|number| number.is_finite()).map(ToString::to_string),
        Entries::Integers(integers) => integers.get(row).map(ToString::to_string),
        Entries::Text(words) => words.get(row).cloned(),
    };
    let columns: Vec<(bool, Vec<String>)> = frame
        .columns
        .iter()
        .map(|(name, entries)| {
            let cells = (0..frame.rows()).map(|row| cell(entries, row).unwrap_or_default());
            (matches!(entries, Entries::Text(_)), std::iter::once(name.clone()).chain(cells).collect())
        })
        .collect();
    let mut text = format!("{}\n", frame.name);
    for row in 0..=frame.rows() {
        let padded = columns.iter().map(|(is_text, cells)| {
            let width = cells.iter().map(|cell| cell.chars().count()).max().unwrap_or(0);
            let cell = cells.get(row).map_or("", String::as_str);
            if *is_text { format!("{cell:width$}") } else { format!("{cell:>width$}") }
        });
        text += padded.collect::<Vec<_>>().join("  ").trim_end();
        text.push('\n');
    }
    text
}

/// The values one a line, in full precision, standard errors behind them.
fn as_text(outcome: &Outcome) -> String {
    let width = outcome.values.names().map(|name| name.chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    for (name, measured) in outcome.values.iter() {
        let _ = writeln!(text, "{name:width$}  {}", in_full(measured));
    }
    text
}

/// The values of a changed experiment, those that the book has next to them.
fn side_by_side(before: &Outcome, after: &Outcome) -> String {
    let head = ["", "in the book", "changed"].map(str::to_owned);
    let rows = after.values.iter().map(|(name, measured)| {
        let book = before.values.get(name).map(in_full).unwrap_or_default();
        [name.to_owned(), book, in_full(measured)]
    });
    let rows: Vec<[String; 3]> = std::iter::once(head).chain(rows).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let (names, books) = (width(0), width(1));
    let line = |[name, book, changed]: &[String; 3]| format!("{name:names$}  {book:books$}  {changed}\n");
    rows.iter().map(line).collect()
}

/// A value in full precision, its standard error behind it.
fn in_full(measured: &Measured) -> String {
    let value = match &measured.value {
        Value::Number(number) => number.to_string(),
        Value::Integer(integer) => integer.to_string(),
        Value::Boolean(truth) => truth.to_string(),
        Value::Text(words) => words.clone(),
    };
    let error = measured.standard_error.map(|error| format!(" ± {error}")).unwrap_or_default();
    value + &error
}
