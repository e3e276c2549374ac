//! `workbook list`: the entries of a catalogue, or the exhibits of the course.

use std::fmt::Write as _;

use clap::{Args, ValueEnum};
use serde_json::{Map, Value as Json, json};

use super::{Exit, Format, Options, report};
use crate::catalogue::{About, Paper, find, nearest};
use crate::compose::check;
use crate::diag::{Code, Diagnostic};
use crate::integrands::INTEGRANDS;
use crate::kinds::{self, KINDS};
use crate::metrics::METRICS;
use crate::samplers::{Preset, SAMPLERS, Sampler, Setting};
use crate::scenes::SCENES;
use crate::scrambles::SCRAMBLES;

#[derive(Args)]
pub(super) struct Arguments {
    /// What to list
    #[arg(value_enum)]
    catalogue: Catalogue,
    /// One entry, to list it with its parameters or settings (kinds and samplers)
    entry: Option<String>,
    /// Write JSON, as with `--format json`
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Catalogue {
    Samplers,
    Scrambles,
    Integrands,
    Scenes,
    Metrics,
    Kinds,
    Exhibits,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let options = &Options { format: if arguments.json { Format::Json } else { options.format }, ..options.clone() };
    match (arguments.catalogue, &arguments.entry) {
        (Catalogue::Kinds, Some(entry)) => return kind(entry, options),
        (Catalogue::Samplers, Some(entry)) => return sampler(entry, options),
        (_, Some(entry)) => {
            let message = format!("only kinds and samplers have more to tell than the list: `{entry}` is too much");
            return report::wrong(&Diagnostic::error(Code::Combination, message), Exit::Call, options);
        }
        (_, None) => {}
    }
    let abouts: Vec<&'static About> = match arguments.catalogue {
        Catalogue::Samplers => SAMPLERS.iter().map(|entry| entry.about()).collect(),
        Catalogue::Scrambles => SCRAMBLES.iter().map(|entry| entry.about()).collect(),
        Catalogue::Integrands => INTEGRANDS.iter().map(|entry| entry.about()).collect(),
        Catalogue::Scenes => SCENES.iter().map(|entry| entry.about()).collect(),
        Catalogue::Metrics => METRICS.iter().map(|entry| entry.about()).collect(),
        Catalogue::Kinds => KINDS.iter().map(|entry| entry.about()).collect(),
        Catalogue::Exhibits => return exhibits(options),
    };
    let json: Vec<_> = match arguments.catalogue {
        Catalogue::Samplers => SAMPLERS.iter().map(|sampler| sampler_json(*sampler)).collect(),
        _ => abouts.iter().map(|about| Json::Object(about_json(about))).collect(),
    };
    let rows = abouts.iter().map(|about| [about.key.to_owned(), about.summary.to_owned()]);
    print(&rows.collect::<Vec<_>>(), &json!(json), options);
    Exit::Fine
}

/// What an entry tells about itself.
fn about_json(about: &About) -> Map<String, Json> {
    let paper = |paper: &Paper| json!({ "authors": paper.authors, "year": paper.year, "title": paper.title, "venue": paper.venue, "doi": paper.doi });
    let papers: Vec<_> = about.papers.iter().map(paper).collect();
    let fields = [
        ("key", json!(about.key)),
        ("title", json!(about.title)),
        ("summary", json!(about.summary)),
        ("file", json!(format!("src/{}", about.file))),
        ("papers", json!(papers)),
    ];
    fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

/// What a sampler tells about itself, with its guarantees, settings and limits.
fn sampler_json(sampler: &dyn Sampler) -> Json {
    let setting = |setting: &Setting| {
        let default = match setting.default {
            Preset::Number(number) => json!(number),
            Preset::Rule(words) => json!(words),
        };
        json!({
            "name": setting.name,
            "meaning": setting.meaning,
            "least": setting.least,
            "most": setting.most,
            "prime": setting.is_prime,
            "default": default,
        })
    };
    let mut fields = about_json(sampler.about());
    let guarantees: Vec<String> = sampler.guarantees().iter().map(ToString::to_string).collect();
    fields.insert("guarantees".to_owned(), json!(guarantees));
    fields.insert("settings".to_owned(), sampler.settings().iter().map(setting).collect());
    fields.insert("limits".to_owned(), json!(paragraph(sampler.about().source, "Limits")));
    Json::Object(fields)
}

/// The paragraph `**head.** ...` of a file's own page.
fn paragraph(source: &str, head: &str) -> String {
    let start = format!("//! **{head}.** ");
    let lines = source.lines().skip_while(|line| !line.starts_with(&start)).map_while(|line| line.strip_prefix("//! "));
    let words: Vec<&str> = lines.collect();
    words.join(" ").trim_start_matches(&format!("**{head}.** ")).to_owned()
}

/// One sampler with its guarantees and each of its settings.
fn sampler(key: &str, options: &Options) -> Exit {
    let Some(sampler) = find(SAMPLERS, key) else {
        let near = nearest(key, SAMPLERS.iter().map(|sampler| sampler.about().key));
        let error = Diagnostic::error(Code::UnknownName, format!("there is no sampler `{key}`"))
            .help_if(near.map(|near| format!("did you mean `{near}`?")))
            .help("`workbook list samplers` names them all");
        return report::wrong(&error, Exit::Call, options);
    };
    let about = sampler.about();
    let mut rows = vec![[about.key.to_owned(), about.summary.to_owned()]];
    let guarantees = sampler.guarantees().iter();
    rows.extend(guarantees.map(|guarantee| ["guarantee".to_owned(), guarantee.to_string()]));
    rows.extend(sampler.settings().iter().map(|setting| {
        let words = format!("{} ({}, default {})", setting.meaning, setting.limits(), setting.default);
        [format!("setting {}", setting.name), words]
    }));
    rows.push(["limits".to_owned(), paragraph(about.source, "Limits")]);
    print(&rows, &sampler_json(sampler), options);
    Exit::Fine
}

/// One kind with each of its parameters: name, type, default, meaning.
fn kind(key: &str, options: &Options) -> Exit {
    let Some(kind) = kinds::find(key) else {
        let near = nearest(key, KINDS.iter().map(|kind| kind.about().key));
        let error = Diagnostic::error(Code::UnknownName, format!("there is no kind `{key}`"))
            .help_if(near.map(|near| format!("did you mean `{near}`?")))
            .help("`workbook list kinds` names them all");
        return report::wrong(&error, Exit::Call, options);
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
        return report::to_stdout_as_json(json);
    }
    let width = rows.iter().map(|row| row[0].chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    for [key, words] in rows {
        let _ = writeln!(text, "{key:width$}  {words}");
    }
    report::to_stdout(&text);
}
