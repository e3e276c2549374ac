//! Chapters to nodes with places. Every complaint of every chapter is collected; nothing stops at the first.
//!
//! Markdown goes through `pulldown-cmark` and stays at the level of its events: no text is changed before it is parsed,
//! so that every place is true to the file.

mod audience;
mod budgets;
mod callout;
mod configuration;
pub mod documented;
mod emphasis;
mod events;
mod fence;
mod front_matter;
mod given;
mod inline;
mod landing;
mod memo;
mod node;
mod shelf;
mod site;
mod source_map;
mod term;
mod toml_text;
mod value;

use std::sync::Arc;

use crate::diag::{Code, Diagnostic};
use crate::workspace::{self, Workspace};

pub use audience::{Audience, without_files_of_solutions, without_solutions};
pub use budgets::Budgets;
pub use configuration::Configuration;
pub use emphasis::{Emphasis, HELP, fence};
pub use events::{inline as caption, parser_options};
pub use fence::Fence;
pub use front_matter::{Chosen, FrontMatter};
pub use given::Given;
pub use landing::Passage;
pub use memo::Memo;
pub use node::{Callout, CalloutKind, Cited, Computed, Formula, Label, Node, Term, ValueUse, What};
pub use shelf::{Generated, Shelf};
pub use site::{Commit, Redirect, Repository, Site};
pub use source_map::SourceMap;
pub use toml_text::table;

/// A chapter as written.
#[derive(Debug, Clone)]
pub struct Chapter {
    /// The file, from the course's root.
    pub file: Arc<str>,
    /// The file's stem, e.g. `01-history`.
    pub stem: String,
    /// The stem without its leading number, e.g. `history`: the page's name.
    pub slug: String,
    /// Its number as a reader sees it: `3`, `A` if it is an appendix, `S7` if code wrote it.
    pub number: String,
    /// Whether it is an appendix.
    pub appendix: bool,
    /// The shelf of the catalogue that it belongs to, if code wrote it.
    pub shelf: Option<Shelf>,
    /// Whether it is the page of one member of the shelf, not that of the shelf.
    pub member: bool,
    /// Title and summary.
    pub front: FrontMatter,
    /// What it consists of.
    pub content: Arc<Content>,
}

impl Chapter {
    /// What a reader calls such a part of the book.
    pub fn word(&self) -> &'static str {
        match self.shelf {
            Some(shelf) if self.member => shelf.singular(),
            Some(_) => "Catalogue",
            None if self.appendix => "Appendix",
            None => "Chapter",
        }
    }

    /// What a reader calls it, e.g. `Chapter 3`.
    pub fn name(&self) -> String {
        format!("{} {}", self.word(), self.number)
    }
}

/// The number of the appendix with this index: `A` to `Z`, then `AA`.
fn letters(index: usize) -> String {
    let letter = ('A'..='Z').nth(index % 26).unwrap_or_default();
    std::iter::repeat_n(letter, 1 + index / 26).collect()
}

/// The pieces of a chapter in order, and its fences.
#[derive(Debug, Clone, Default)]
pub struct Content {
    /// The pieces in order.
    pub nodes: Vec<Node>,
    /// The `experiment` fences, in order.
    pub experiments: Vec<Fence>,
    /// The `listing` fences, in order.
    pub listings: Vec<Fence>,
}

/// The course as written: its configuration and its chapters in the reader's order.
#[derive(Debug, Clone)]
pub struct Course {
    /// `workbook.toml`.
    pub configuration: Configuration,
    /// The chapters in the order of the book.
    pub chapters: Vec<Chapter>,
}

/// Parses the configuration of a course.
pub fn configuration(workspace: &Workspace) -> (Configuration, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    (configuration::read(workspace, &mut diagnostics), diagnostics)
}

/// Parses the chapters of a course, then those that code wrote.
pub fn course(
    configuration: Configuration,
    workspace: &Workspace,
    generated: &[Generated],
) -> (Course, Vec<Diagnostic>) {
    course_again(configuration, workspace, generated, &mut Memo::default())
}

/// The same, for a course that is read again and again: a chapter whose text is that which `memo` knows is not parsed anew.
pub fn course_again(
    configuration: Configuration,
    workspace: &Workspace,
    generated: &[Generated],
    memo: &mut Memo,
) -> (Course, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    memo.begin(workspace);
    let sources = configuration::ordered_chapters(&configuration, workspace, &mut diagnostics);
    let count = sources.iter().filter(|(_, appendix)| !appendix).count();
    let chapters = sources.into_iter().enumerate().map(|(index, (source, appendix))| Chapter {
        number: if appendix { letters(index - count) } else { (index + 1).to_string() },
        appendix,
        ..memo.chapter(source, &configuration, workspace, &mut diagnostics)
    });
    let mut chapters: Vec<Chapter> = chapters.collect();
    check_slugs(&chapters, generated, &mut diagnostics);
    chapters.extend(generated.iter().map(|page| Chapter {
        number: page.number.clone(),
        shelf: Some(page.shelf),
        member: page.member,
        stem: page.name().to_owned(),
        slug: page.name().to_owned(),
        ..memo.chapter(&page.source, &configuration, workspace, &mut diagnostics)
    }));
    memo.end();
    site::check_redirects(&configuration.site, &chapters, workspace, &mut diagnostics);
    (Course { configuration, chapters }, diagnostics)
}

/// The pages that the book makes of itself: no chapter can have their names.
pub const OWN_PAGES: [&str; 7] = ["index", "exhibits", "terms", "kinds", "bibliography", "made", "404"];

/// Complains of chapters whose pages would take each other's place, or that of a page of the book.
fn check_slugs(chapters: &[Chapter], generated: &[Generated], diagnostics: &mut Vec<Diagnostic>) {
    for (index, chapter) in chapters.iter().enumerate() {
        let other = chapters[..index].iter().find(|other| other.slug == chapter.slug).map(|other| &*other.file);
        let own = OWN_PAGES.contains(&chapter.slug.as_str()).then_some("the book itself");
        let page = generated.iter().any(|page| page.name() == chapter.slug).then_some("the catalogue");
        if let Some(other) = other.or(own).or(page) {
            let message =
                format!("the page of `{}` would be `{}.html`, which is that of {other}", chapter.file, chapter.slug);
            diagnostics.push(Diagnostic::error(Code::ChapterOrder, message).help("give the chapter another name"));
        }
    }
}

/// Parses one chapter, whatever its number.
fn chapter(
    source: &workspace::Source,
    configuration: &Configuration,
    workspace: &Workspace,
    diagnostics: &mut Vec<Diagnostic>,
) -> Chapter {
    let stem = workspace::chapter_stem(&source.path).unwrap_or_default().to_owned();
    let slug = stem.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start_matches('-').to_owned();
    let (events, front) = events::split_front_matter(&source.text);
    let front = front_matter::read(front, source, diagnostics);
    let content = events::read(events, source, configuration.allow_html, workspace, diagnostics);
    Chapter {
        file: Arc::clone(&source.path),
        slug: if slug.is_empty() { stem.clone() } else { slug },
        stem,
        number: String::new(),
        appendix: false,
        shelf: None,
        member: false,
        front,
        content: Arc::new(content),
    }
}
