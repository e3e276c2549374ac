//! `workbook run`: run the experiment of one exhibit and print its values, its data or its drawing.

use std::fmt::Write as _;

use clap::Args;

use super::progress::Progress;
use super::{Exit, Format, Options, among, report};
use crate::compose::{check, job};
use crate::diag::Diagnostic;
use crate::kinds::{Entries, Failure, Frame, Outcome, Value};
use crate::plan::Exhibit;
use crate::render::data;
use crate::{exhibits, run};

#[derive(Args)]
pub(super) struct Arguments {
    /// The exhibit's id
    id: String,
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
    let ran = run::run(vec![job(exhibit)], request.cache().as_ref(), request.threads, &Progress::new(options));
    let Some(outcome) = ran.first().map(|ran| &ran.outcome) else { return Exit::System };
    let printed = outcome.as_ref().map_err(Clone::clone).and_then(|outcome| print(exhibit, outcome, arguments.format));
    match printed {
        Ok(text) => {
            report::to_stdout(&text);
            Exit::Fine
        }
        Err(failure) => {
            let failed: Diagnostic = exhibits::failed(exhibit, &failure);
            report::diagnostics(&[failed], &planned.workspace, options);
            Exit::Course
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
        let value = match &measured.value {
            Value::Number(number) => number.to_string(),
            Value::Integer(integer) => integer.to_string(),
            Value::Boolean(truth) => truth.to_string(),
            Value::Text(words) => words.clone(),
        };
        let error = measured.standard_error.map(|error| format!(" ± {error}")).unwrap_or_default();
        let _ = writeln!(text, "{name:width$}  {value}{error}");
    }
    text
}
