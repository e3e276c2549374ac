//! `workbook run`: run the experiment of one exhibit and print its values.

use std::fmt::Write as _;

use clap::Args;
use serde_json::{Map, Value as Json, json};

use super::progress::Progress;
use super::{Exit, Format, Options, report};
use crate::compose::{check, job};
use crate::diag::Diagnostic;
use crate::kinds::{Outcome, Value};
use crate::plan::Exhibit;
use crate::render::machine::number;
use crate::{exhibits, run};

#[derive(Args)]
pub(super) struct Arguments {
    /// The exhibit's id
    id: String,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let request = options.request();
    let planned = check(&request);
    let Some(exhibit) = planned.plan.exhibit(&arguments.id) else {
        return report::no_exhibit(&arguments.id, &planned, options);
    };
    let ran = run::run(vec![job(exhibit)], request.cache().as_ref(), request.threads, &Progress::new(options));
    match ran.first().map(|ran| &ran.outcome) {
        Some(Ok(outcome)) => {
            report::to_stdout(&if options.format == Format::Json {
                as_json(exhibit, outcome)
            } else {
                as_text(outcome)
            });
            Exit::Fine
        }
        Some(Err(failure)) => {
            let failed: Diagnostic = exhibits::failed(exhibit, failure);
            report::diagnostics(&[failed], &planned.workspace, options);
            Exit::Course
        }
        None => Exit::System,
    }
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

fn as_json(exhibit: &Exhibit, outcome: &Outcome) -> String {
    let values: Map<String, Json> =
        outcome.values.iter().map(|(name, measured)| (name.to_owned(), number(measured))).collect();
    let errors =
        outcome.values.iter().filter_map(|(name, measured)| Some((name.to_owned(), json!(measured.standard_error?))));
    let errors: Map<String, Json> = errors.collect();
    let whole = json!({
        "id": exhibit.id,
        "kind": exhibit.experiment.kind().about().key,
        "parameters": exhibit.experiment.parameters(),
        "seed": exhibit.seed,
        "values": values,
        "standard_errors": errors,
    });
    format!("{}\n", serde_json::to_string_pretty(&whole).unwrap_or_default())
}
