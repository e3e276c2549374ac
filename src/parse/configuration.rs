//! `workbook.toml`: the course's title, its authors, the order of its chapters and what holds for all of them.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use toml::de::DeValue;

use super::audience::Audience;
use super::budgets::{self, Budgets};
use super::landing::{self, Passage};
use super::shelf::{self, Shelf};
use super::site::{self, Site};
use super::source_map::SourceMap;
use super::toml_text;
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic, Severity};
use crate::parameters::{Complaint, Fields, Parameters, choices, parameters};
use crate::workspace::{CHAPTERS, CONFIGURATION, Source, Workspace, chapter_stem};

parameters! {
    /// The keys of `workbook.toml` itself.
    pub struct Head {
        /// The title of the course.
        title: String,
        /// A line below the title.
        subtitle: Option<String>,
        /// What the course is about, in a sentence or two, for the landing page.
        summary: Option<String>,
        /// Who wrote it.
        authors: Vec<String>,
        /// The language of the text, as in HTML's `lang`.
        language: String = "en",
        /// The chapters in the order of the book, each by its file's stem; all of them by name if it is not given.
        order: Option<Vec<String>>,
        /// The appendices in their order, each by its file's stem: they come after the chapters, with letters for numbers.
        appendices: Option<Vec<String>>,
        /// The bibliography's file in the chapters' folder.
        bibliography: Option<String>,
        /// Whether chapters may hold raw HTML.
        allow_html: bool = false,
        /// What becomes of a number in the text that could be computed.
        typed_numbers: TypedNumbers = "warning",
        /// For whom the book is made, if the command line does not say.
        audience: Audience = "instructor",
        /// Where the site will stand: then pages have canonical links, and the site has a map.
        base_url: Option<String>,
    }
}

choices! {
    /// What becomes of a number in the text that could be computed.
    pub enum TypedNumbers {
        /// It is told, and the book is built.
        Warning = "warning",
        /// It is told, and there is no book.
        Error = "error",
        /// Nothing is said.
        Allowed = "allowed",
    }
}

parameters! {
    /// The table `[defaults]`.
    pub struct Defaults {
        /// The seed of every experiment that does not give its own.
        seed: usize [in 0..=9_007_199_254_740_991] = 1,
    }
}

impl TypedNumbers {
    /// How bad it is; nothing if it is allowed.
    fn severity(self) -> Option<Severity> {
        match self {
            Self::Warning => Some(Severity::Warning),
            Self::Error => Some(Severity::Error),
            Self::Allowed => None,
        }
    }
}

/// What holds for the whole course.
#[derive(Debug, Clone, Default)]
pub struct Configuration {
    /// The title of the course.
    pub title: String,
    /// A line below the title; may be empty.
    pub subtitle: String,
    /// What the course is about; may be empty.
    pub summary: String,
    /// Who wrote it.
    pub authors: Vec<String>,
    /// The language of the text.
    pub language: String,
    /// The listed chapters' stems, each with its place in the configuration; none lists all of them.
    pub order: Option<Vec<Listed>>,
    /// The same of the appendices.
    pub appendices: Vec<Listed>,
    /// The bibliography's path from the course's root.
    pub bibliography: Option<String>,
    /// Whether chapters may hold raw HTML.
    pub allow_html: bool,
    /// How bad a number in the text is that could be computed; nothing if that is allowed.
    pub typed_numbers: Option<Severity>,
    /// For whom the book is made, if nothing else is said.
    pub audience: Audience,
    /// Where the site will stand, what has moved in it, and where its sources are.
    pub site: Site,
    /// How heavy it may be.
    pub budgets: Budgets,
    /// The seed of every experiment that does not give its own.
    pub seed: u64,
    /// What the landing page says of the course.
    pub landing: Vec<Passage>,
    /// The parts of the catalogue that the book has pages of.
    pub catalogue: Vec<Shelf>,
    /// LaTeX macros: name to replacement.
    pub macros: BTreeMap<String, String>,
}

/// A chapter's stem as it is listed, with its place in the configuration.
pub type Listed = (String, Range<usize>);

/// Reads the configuration; what is missing or wrong is told, and the default stands in.
pub(super) fn read(workspace: &Workspace, diagnostics: &mut Vec<Diagnostic>) -> Configuration {
    let Some(source) = workspace.text(CONFIGURATION) else { return Configuration::default() };
    let map = SourceMap::whole(0, source.text.len());
    let table = toml_text::table(&source.text, &source.path, &map, diagnostics);
    let mut fields = Fields::plain(table.get_ref());
    let head = Head::read(&mut fields);
    let mut configuration = Configuration { seed: 1, ..Configuration::default() };
    let mut base_url = None;
    if let Some(head) = head {
        base_url = head.base_url;
        configuration = Configuration {
            title: head.title,
            subtitle: head.subtitle.unwrap_or_default(),
            summary: head.summary.unwrap_or_default(),
            authors: head.authors,
            language: head.language,
            order: head.order.map(|stems| listed(stems, "order", &fields)),
            appendices: head.appendices.map(|stems| listed(stems, "appendices", &fields)).unwrap_or_default(),
            bibliography: head.bibliography.map(|file| format!("{CHAPTERS}/{file}")),
            allow_html: head.allow_html,
            typed_numbers: head.typed_numbers.severity(),
            audience: head.audience,
            ..configuration
        };
    }
    if let Some(seed) = read_defaults(&mut fields) {
        configuration.seed = seed;
    }
    configuration.macros = read_macros(&mut fields);
    configuration.site = site::read(base_url, &mut fields);
    configuration.budgets = budgets::read(&mut fields);
    configuration.landing = landing::read(&mut fields, source, workspace, diagnostics);
    shelf::read(&mut fields, &mut configuration);
    let tables = ["budgets", "catalogue", "defaults", "landing", "math", "redirects", "repository"];
    let known: Vec<&str> = Head::docs().iter().map(|doc| doc.name).chain(tables).collect();
    fields.finish(&known);
    diagnostics.extend(fields.complaints.into_iter().map(|complaint| located(complaint, source)));
    check_bibliography(&configuration, workspace, source, diagnostics);
    configuration
}

/// A complaint of a TOML file, at its place.
pub(super) fn located(complaint: Complaint, source: &Source) -> Diagnostic {
    let code = if complaint.code == Code::MissingKey { Code::Configuration } else { complaint.code };
    let mut diagnostic = Diagnostic::error(code, complaint.message).at(&source.path, complaint.range);
    diagnostic.help = complaint.help;
    diagnostic
}

/// The stems of the list `name` with their places.
fn listed(stems: Vec<String>, name: &str, fields: &Fields<'_>) -> Vec<Listed> {
    let places = match fields.value(name).map(|value| (value.span(), value.get_ref())) {
        Some((_, DeValue::Array(elements))) => elements.iter().map(toml::Spanned::span).collect(),
        Some((span, _)) => vec![span],
        None => Vec::new(),
    };
    stems.into_iter().zip(places).collect()
}

fn read_defaults(fields: &mut Fields<'_>) -> Option<u64> {
    let table = fields.table("defaults")?;
    let mut inner = Fields::plain(table);
    let defaults = Defaults::read(&mut inner);
    inner.finish(&["seed"]);
    fields.complaints.append(&mut inner.complaints);
    defaults.map(|defaults| defaults.seed as u64)
}

fn read_macros(fields: &mut Fields<'_>) -> BTreeMap<String, String> {
    let mut macros = BTreeMap::new();
    let Some(table) = fields.table("math") else { return macros };
    let mut math = Fields::plain(table);
    if let Some(written) = math.table("macros") {
        for (name, value) in written {
            match value.get_ref().as_str() {
                Some(text) => drop(macros.insert(name.get_ref().trim_start_matches('\\').to_owned(), text.to_owned())),
                None => {
                    math.complaints.push(Complaint::new(Code::WrongType, value.span(), "a macro is a string of LaTeX"));
                }
            }
        }
    }
    math.finish(&["macros"]);
    fields.complaints.append(&mut math.complaints);
    macros
}

fn check_bibliography(
    configuration: &Configuration,
    workspace: &Workspace,
    source: &Source,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let Some(path) = &configuration.bibliography else { return };
    if workspace.text(path).is_none() {
        let range = source.text.find("bibliography").map_or(0..0, |start| start..start + "bibliography".len());
        let error = Diagnostic::error(Code::MissingInclude, format!("there is no bibliography `{path}`"));
        diagnostics.push(
            error
                .at(&source.path, range)
                .help(format!("the path starts at `{CHAPTERS}/`; the file is BibLaTeX, `.bib`")),
        );
    }
}

/// The chapters in the order of the book, each with whether it is an appendix. A listed one that is missing, and one that is not
/// listed, are told.
pub(super) fn ordered_chapters<'w>(
    configuration: &Configuration,
    workspace: &'w Workspace,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<(&'w Source, bool)> {
    let file: Arc<str> = CONFIGURATION.into();
    let all: Vec<&Source> = workspace.chapters().collect();
    if all.is_empty() && diagnostics.is_empty() && workspace.text(CONFIGURATION).is_some() {
        let error = Diagnostic::error(Code::ChapterOrder, "the course has no chapter");
        diagnostics.push(error.help(format!("chapters are files directly in `{CHAPTERS}/`: `{CHAPTERS}/01-first.md`")));
    }
    let stem = |source: &&Source| chapter_stem(&source.path).unwrap_or_default().to_owned();
    let is_in = |list: &[Listed], source: &&Source| list.iter().any(|(listed, _)| *listed == stem(source));
    let appendices = &configuration.appendices;
    let mut chosen = Vec::new();
    if configuration.order.is_none() {
        chosen.extend(all.iter().filter(|source| !is_in(appendices, source)).map(|source| (*source, false)));
    }
    let order = configuration.order.as_deref().unwrap_or_default();
    let listed = order.iter().map(|listed| (listed, false)).chain(appendices.iter().map(|listed| (listed, true)));
    for ((listed, range), appendix) in listed {
        if let Some(source) = all.iter().find(|source| stem(source) == *listed) {
            chosen.push((*source, appendix));
        } else {
            let stems: Vec<String> = all.iter().map(stem).collect();
            let near = nearest(listed, stems.iter().map(String::as_str)).map(|near| format!("did you mean `{near}`?"));
            let error = Diagnostic::error(Code::ChapterOrder, format!("there is no chapter `{CHAPTERS}/{listed}.md`"));
            diagnostics.push(error.at(&file, range.clone()).help_if(near));
        }
    }
    for source in &all {
        if !chosen.iter().any(|(known, _)| known.path == source.path) {
            let error =
                Diagnostic::warning(Code::ChapterOrder, format!("the chapter `{}` is not in the book", source.path));
            diagnostics.push(
                error.help(format!("add `\"{}\"` to `order` in {CONFIGURATION}, or remove the file", stem(source))),
            );
        }
    }
    chosen
}
