//! `workbook list`: the entries of a catalogue, or the exhibits of the course.

use std::fmt::Write as _;

use clap::{Args, ValueEnum};
use serde_json::json;

use super::{Exit, Format, Options, report};
use crate::catalogue::About;
use crate::compose::check;
use crate::integrands::INTEGRANDS;
use crate::kinds::{self, KINDS};
use crate::samplers::SAMPLERS;
use crate::scenes::SCENES;
use crate::scrambles::SCRAMBLES;

#[derive(Args)]
pub(super) struct Arguments {
    /// What to list
    #[arg(value_enum)]
    catalogue: Catalogue,
    /// One entry, to list it with its parameters (kinds only)
    entry: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Catalogue {
    Samplers,
    Scrambles,
    Integrands,
    Scenes,
    Kinds,
    Exhibits,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    if let (Catalogue::Kinds, Some(entry)) = (arguments.catalogue, &arguments.entry) {
        return kind(entry, options);
    }
    let abouts: Vec<&'static About> = match arguments.catalogue {
        Catalogue::Samplers => SAMPLERS.iter().map(|entry| entry.about()).collect(),
        Catalogue::Scrambles => SCRAMBLES.iter().map(|entry| entry.about()).collect(),
        Catalogue::Integrands => INTEGRANDS.iter().map(|entry| entry.about()).collect(),
        Catalogue::Scenes => SCENES.iter().map(|entry| entry.about()).collect(),
        Catalogue::Kinds => KINDS.iter().map(|entry| entry.about()).collect(),
        Catalogue::Exhibits => return exhibits(options),
    };
    let json: Vec<_> = abouts
        .iter()
        .map(|about| {
            let papers: Vec<_> = about.papers.iter().map(|paper| json!({ "authors": paper.authors, "year": paper.year, "title": paper.title, "venue": paper.venue, "doi": paper.doi })).collect();
            json!({ "key": about.key, "title": about.title, "summary": about.summary, "file": format!("src/{}", about.file), "papers": papers })
        })
        .collect();
    let rows = abouts.iter().map(|about| [about.key.to_owned(), about.summary.to_owned()]);
    print(&rows.collect::<Vec<_>>(), &json!(json), options);
    Exit::Fine
}

/// One kind with each of its parameters: name, type, default, meaning.
fn kind(key: &str, options: &Options) -> Exit {
    let Some(kind) = kinds::find(key) else {
        report::say(&format!("there is no kind `{key}`; `workbook list kinds` names them all"), options);
        return Exit::Call;
    };
    let docs = kind.parameters();
    let json: Vec<_> = docs
        .iter()
        .map(|doc| json!({ "name": doc.name, "type": doc.type_name, "required": doc.required, "default": doc.default, "limits": doc.limits, "meaning": doc.meaning, "schema": doc.schema }))
        .collect();
    let rows = docs.iter().map(|doc| {
        let default = doc.default.map(|default| format!(", default {default}")).unwrap_or_default();
        let limits = doc.limits.as_ref().map(|limits| format!(", {limits}")).unwrap_or_default();
        let required = if doc.required { ", required" } else { "" };
        [doc.name.to_owned(), format!("{} ({}{limits}{default}{required})", doc.meaning, doc.type_name)]
    });
    print(&rows.collect::<Vec<_>>(), &json!({ "kind": key, "parameters": json }), options);
    Exit::Fine
}

/// The exhibits of the course with their kinds and places.
fn exhibits(options: &Options) -> Exit {
    let planned = check(&options.request());
    let rows = planned.plan.exhibits.iter().map(|exhibit| {
        let number = planned.plan.labels.target(&exhibit.id).map_or("", |target| &target.number);
        [exhibit.id.clone(), format!("{number}  {}  {}", exhibit.experiment.kind().about().key, exhibit.place.file)]
    });
    let rows: Vec<_> = rows.collect();
    print(&rows, &json!(rows.iter().map(|row| &row[0]).collect::<Vec<_>>()), options);
    Exit::of(&planned.diagnostics)
}

fn print(rows: &[[String; 2]], json: &serde_json::Value, options: &Options) {
    if options.format == Format::Json {
        return report::to_stdout(&format!("{}\n", serde_json::to_string_pretty(json).unwrap_or_default()));
    }
    let width = rows.iter().map(|row| row[0].chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    for [key, words] in rows {
        let _ = writeln!(text, "{key:width$}  {words}");
    }
    report::to_stdout(&text);
}
