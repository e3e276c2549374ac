//! The pages of the book and what their templates are given.

use serde::Serialize;
use serde_json::json;

use super::Rendering;
use super::landing;
use super::made::made;
use super::markdown::Writer;
use super::matter::{self, BIBLIOGRAPHY, EXHIBITS, KINDS, Matter, TERMS};
use super::shelf::{self, MemberContext};
use super::site::{self, SiteContext};
use super::templates::ASSETS;
use super::terms;
use crate::diag::Diagnostic;

/// The page that a reader meets first.
const LANDING: &str = "index.html";

/// What every page knows of the book.
#[derive(Serialize)]
pub(super) struct BookContext<'a> {
    title: &'a str,
    subtitle: &'a str,
    summary: &'a str,
    authors: &'a [String],
    language: &'a str,
    chapters: Vec<ChapterContext<'a>>,
    /// The shelves of the catalogue.
    catalogue: Vec<ChapterContext<'a>>,
    matter: Vec<MatterContext>,
    version: &'static str,
    site: SiteContext<'a>,
}

/// A line of the list of chapters.
#[derive(Serialize)]
pub(super) struct ChapterContext<'a> {
    number: &'a str,
    appendix: bool,
    title: &'a str,
    summary: &'a str,
    href: String,
    current: bool,
}

/// A line of the list of pages that are no chapters.
#[derive(Serialize)]
struct MatterContext {
    title: &'static str,
    href: &'static str,
    summary: &'static str,
}

impl From<&Matter> for MatterContext {
    fn from(matter: &Matter) -> Self {
        Self { title: matter.title, href: matter.href, summary: matter.summary }
    }
}

/// What a page knows of itself.
#[derive(Serialize)]
pub(super) struct PageContext<'a> {
    pub(super) title: &'a str,
    /// A chapter's number, and `Chapter` or `Appendix`.
    pub(super) number: Option<&'a str>,
    pub(super) word: &'static str,
    pub(super) summary: &'a str,
    pub(super) href: String,
}

/// A neighbour in the order of the book.
#[derive(Serialize)]
pub(super) struct Neighbour<'a> {
    title: &'a str,
    href: String,
    number: &'a str,
}

/// A line of a chapter's contents.
#[derive(Serialize)]
pub(super) struct SectionContext {
    id: String,
    title: String,
    number: String,
    level: usize,
}

#[derive(Serialize)]
struct ChapterPage<'a> {
    book: BookContext<'a>,
    page: PageContext<'a>,
    assets: &'static str,
    body: String,
    contents: Vec<SectionContext>,
    previous: Option<Neighbour<'a>>,
    next: Option<Neighbour<'a>>,
    /// The shelf whose member it is.
    up: Option<Neighbour<'a>>,
    /// The members of the shelf that it is the page of.
    members: Vec<MemberContext<'a>>,
}

/// A page that the book makes of itself, with what is its own.
#[derive(Serialize)]
struct MatterPage<'a, T> {
    book: BookContext<'a>,
    page: PageContext<'a>,
    assets: &'static str,
    contents: Vec<SectionContext>,
    #[serde(flatten)]
    own: T,
}

/// Every page, by its path in the book; none if `go_on` says no on the way.
pub(super) fn all(
    rendering: &Rendering<'_>,
    diagnostics: &mut Vec<Diagnostic>,
    go_on: &dyn Fn() -> bool,
) -> Option<Vec<(String, String)>> {
    let mut pages = Vec::new();
    for path in paths(rendering) {
        let page = go_on().then(|| page(rendering, &path, diagnostics))?;
        pages.extend(page.map(|page| (path, page)));
    }
    Some(pages)
}

/// The paths of all pages.
pub(super) fn paths(rendering: &Rendering<'_>) -> Vec<String> {
    let own = [LANDING].into_iter().chain(matter::of(rendering).map(|matter| matter.href)).map(str::to_owned);
    let chapters = (0..rendering.course.chapters.len()).map(|chapter| rendering.href(chapter));
    own.chain(chapters).chain(site::extra_paths(rendering)).collect()
}

/// The page at this path, if the book has it.
pub(super) fn page(rendering: &Rendering<'_>, path: &str, diagnostics: &mut Vec<Diagnostic>) -> Option<String> {
    if path == LANDING {
        return Some(landing::page(rendering, diagnostics));
    }
    if let Some(matter) = matter::of(rendering).find(|matter| matter.href == path) {
        return Some(own_page(rendering, matter, diagnostics));
    }
    match (0..rendering.course.chapters.len()).find(|&chapter| rendering.href(chapter) == path) {
        Some(chapter) => Some(chapter_page(rendering, chapter, diagnostics)),
        None => site::extra_page(rendering, path, diagnostics),
    }
}

/// A page that the book makes of itself.
fn own_page(rendering: &Rendering<'_>, matter: &Matter, diagnostics: &mut Vec<Diagnostic>) -> String {
    match matter.href {
        href if href == EXHIBITS.href => {
            let groups = matter::groups(rendering, diagnostics);
            matter_page(rendering, matter, json!({ "groups": groups }), diagnostics)
        }
        href if href == KINDS.href => {
            matter_page(rendering, matter, json!({ "kinds": matter::kinds(rendering) }), diagnostics)
        }
        href if href == BIBLIOGRAPHY.href => {
            matter_page(rendering, matter, json!({ "entries": rendering.citations.list() }), diagnostics)
        }
        href if href == TERMS.href => {
            let letters = terms::letters(rendering, diagnostics);
            matter_page(rendering, matter, json!({ "letters": letters }), diagnostics)
        }
        _ => matter_page(rendering, matter, made(rendering), diagnostics),
    }
}

pub(super) fn book<'a>(rendering: &Rendering<'a>, current: Option<usize>) -> BookContext<'a> {
    let configuration = &rendering.course.configuration;
    BookContext {
        title: &configuration.title,
        subtitle: &configuration.subtitle,
        summary: &configuration.summary,
        authors: &configuration.authors,
        language: &configuration.language,
        chapters: chapters(rendering, current).collect(),
        catalogue: shelf::shelves(rendering, current).collect(),
        matter: matter::of(rendering).map(MatterContext::from).collect(),
        version: env!("CARGO_PKG_VERSION"),
        site: site::context(rendering, current),
    }
}

/// The chapters that people wrote, as lists of them show them.
pub(super) fn chapters<'a>(
    rendering: &Rendering<'a>,
    current: Option<usize>,
) -> impl Iterator<Item = ChapterContext<'a>> {
    let chapters = rendering.course.chapters.iter().enumerate().filter(|(_, chapter)| chapter.shelf.is_none());
    chapters.map(move |(index, _)| line(rendering, index, current == Some(index)))
}

/// A line of a list of chapters.
pub(super) fn line<'a>(rendering: &Rendering<'a>, index: usize, current: bool) -> ChapterContext<'a> {
    let chapter = &rendering.course.chapters[index];
    ChapterContext {
        number: &chapter.number,
        appendix: chapter.appendix,
        title: &chapter.front.title,
        summary: &chapter.front.summary,
        href: rendering.href(index),
        current,
    }
}

pub(super) fn neighbour<'a>(rendering: &Rendering<'a>, chapter: Option<usize>) -> Option<Neighbour<'a>> {
    let index = chapter?;
    let chapter = rendering.course.chapters.get(index)?;
    Some(Neighbour { title: &chapter.front.title, href: rendering.href(index), number: &chapter.number })
}

fn chapter_page(rendering: &Rendering<'_>, index: usize, diagnostics: &mut Vec<Diagnostic>) -> String {
    let chapter = &rendering.course.chapters[index];
    let (body, complaints) = Writer::new(rendering, index).chapter();
    diagnostics.extend(complaints);
    let (previous, next) = shelf::neighbours(&rendering.course.chapters, index);
    let context = ChapterPage {
        book: book(rendering, Some(index)),
        page: PageContext {
            title: &chapter.front.title,
            number: Some(&chapter.number),
            word: chapter.word(),
            summary: &chapter.front.summary,
            href: rendering.href(index),
        },
        assets: ASSETS,
        body,
        contents: contents(rendering, index),
        previous: neighbour(rendering, previous),
        next: neighbour(rendering, next),
        up: neighbour(rendering, shelf::above(&rendering.course.chapters, index)),
        members: shelf::members(rendering, index),
    };
    rendering.templates.fill("page.html", &context, diagnostics)
}

fn contents(rendering: &Rendering<'_>, chapter: usize) -> Vec<SectionContext> {
    let nodes = &rendering.course.chapters[chapter].content.nodes;
    let sections = rendering.plan.labels.sections(chapter).iter();
    sections
        .map(|section| SectionContext {
            id: section.id.clone(),
            title: Writer::new(rendering, chapter).inline(&nodes[section.title.clone()]).0,
            number: section.number.clone(),
            level: section.level,
        })
        .collect()
}

/// A page of the book's own, from the template of its name.
pub(super) fn matter_page(
    rendering: &Rendering<'_>,
    matter: &Matter,
    own: impl Serialize,
    diagnostics: &mut Vec<Diagnostic>,
) -> String {
    let context = MatterPage {
        book: book(rendering, None),
        page: PageContext {
            title: matter.title,
            number: None,
            word: "",
            summary: matter.summary,
            href: matter.href.to_owned(),
        },
        assets: ASSETS,
        contents: Vec::new(),
        own,
    };
    rendering.templates.fill(matter.href, &context, diagnostics)
}
