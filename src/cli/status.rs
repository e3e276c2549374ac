//! `workbook status`: which exhibits are fresh, which are stale and why.

use std::fmt::Write as _;

use clap::Args;
use serde_json::{Value as Json, json};

use super::why::reason;
use super::{Exit, Format, Options, report};
use crate::compose::{cache, check, job};
use crate::run::{How, status};

#[derive(Args)]
pub(super) struct Arguments {
    /// Write JSON, as with `--format json`
    #[arg(long)]
    json: bool,
}

/// An exhibit, and why it would be computed if it would.
struct Line<'a> {
    id: &'a str,
    place: String,
    stale: Option<String>,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let options = &Options { format: if arguments.json { Format::Json } else { options.format }, ..options.clone() };
    let planned = check(&options.request());
    let cache = (!options.no_cache).then(|| cache(&options.root));
    let lines = planned.plan.exhibits.iter().map(|exhibit| Line {
        id: &exhibit.id,
        place: report::line_of(&exhibit.place, &planned.workspace),
        stale: match status(&job(exhibit), cache.as_ref()) {
            How::Cached => None,
            How::Computed(why) => Some(reason(&why)),
        },
    });
    let lines: Vec<Line<'_>> = lines.collect();
    if options.format == Format::Json {
        let json: Vec<Json> = lines
            .iter()
            .map(|line| json!({ "id": line.id, "place": line.place, "fresh": line.stale.is_none(), "why": line.stale }))
            .collect();
        report::to_stdout_as_json(&json);
        return Exit::of(&planned.diagnostics);
    }
    report::diagnostics(&planned.diagnostics, &planned.workspace, options);
    report::to_stdout(&table(&lines));
    let stale = lines.iter().filter(|line| line.stale.is_some()).count();
    let all = report::counted(lines.len(), "exhibit");
    report::say(&format!("{all}, {} fresh, {stale} stale", lines.len() - stale), options);
    Exit::of(&planned.diagnostics)
}

fn table(lines: &[Line<'_>]) -> String {
    let width = lines.iter().map(|line| line.id.chars().count()).max().unwrap_or(0);
    lines.iter().fold(String::new(), |mut text, line| {
        let state = line.stale.as_ref().map_or_else(|| "fresh".to_owned(), |why| format!("stale: {why}"));
        let _ = writeln!(text, "{:width$}  {state}", line.id);
        text
    })
}
