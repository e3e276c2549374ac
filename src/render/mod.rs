//! Chapters and exhibits to the book: typed contexts for the templates, one function per kind of node.

mod blocks;
mod callouts;
mod card;
mod citations;
mod code;
mod comparison;
pub(crate) mod data;
mod exhibit;
mod highlight;
mod inline;
mod landing;
pub(crate) mod machine;
mod made;
mod markdown;
mod matter;
mod notes;
mod pages;
mod pictures;
mod previews;
mod proof;
mod search;
mod shelf;
mod site;
mod stepper;
mod table;
mod templates;
mod terms;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::chart::Drawing;
use crate::diag::{Code, Diagnostic};
use crate::exhibits::Shown;
use crate::kinds::Outcome;
use crate::parse::Course;
use crate::plan::{Converter, Exhibit, Plan};
use crate::workspace::{CHAPTERS, Workspace};

pub use comparison::comparison;
pub use proof::{Looks, Parts, Proof, of_preview};
pub use site::LOST;

use citations::Citations;
use templates::Templates;

/// Every byte of the site, by its path from the book's folder.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Book {
    /// The files of the site.
    pub files: BTreeMap<String, Vec<u8>>,
}

/// The name of the file that tells machines about every exhibit.
pub const FIGURES: &str = "figures.json";

/// The name of the map of the site, which a site whose address is known has.
pub const SITEMAP: &str = "sitemap.xml";

/// What rendering needs to know.
pub(crate) struct Rendering<'a> {
    course: &'a Course,
    plan: &'a Plan,
    shown: &'a [Shown],
    workspace: &'a Workspace,
    converter: &'a Converter,
    citations: &'a Citations,
    templates: &'a Templates,
    /// The files of each exhibit, in the order of `shown`.
    files: &'a [Arc<Vec<data::File>>],
    /// Whether the blocks of chapters are marked, so that a preview can tell them apart.
    marked: bool,
}

/// The mark between the blocks of a chapter.
pub(crate) const MARK: &str = "<!--block-->";

impl Rendering<'_> {
    /// The page of a chapter.
    fn href(&self, chapter: usize) -> String {
        self.course.chapters.get(chapter).map_or_else(String::new, |chapter| format!("{}.html", chapter.slug))
    }
}

/// Renders the book: `shown` are the plan's exhibits, in its order.
pub fn render(course: &Course, plan: &Plan, shown: &[Shown], workspace: &Workspace) -> (Book, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let Some(templates) = Templates::load(workspace, &mut diagnostics) else { return (Book::default(), diagnostics) };
    let converter = Converter::new(&course.configuration.macros, &mut diagnostics);
    let citations = Citations::format(course, plan, workspace, &mut diagnostics);
    let files: Vec<Arc<Vec<data::File>>> = plan
        .exhibits
        .iter()
        .zip(shown)
        .map(|(exhibit, shown)| Arc::new(files_of(course, exhibit, &shown.outcome, &shown.drawing)))
        .collect();
    let rendering = Rendering {
        course,
        plan,
        shown,
        workspace,
        converter: &converter,
        citations: &citations,
        templates: &templates,
        files: &files,
        marked: false,
    };
    let book = book(&rendering, &mut diagnostics, &|| true).unwrap_or_default();
    (book, diagnostics)
}

/// The files of an exhibit.
fn files_of(course: &Course, exhibit: &Exhibit, outcome: &Outcome, drawing: &Drawing) -> Vec<data::File> {
    let keep = data::Keep::of(&course.chapters[exhibit.chapter], &exhibit.id);
    data::files(exhibit, outcome, drawing, keep)
}

/// The whole book; none if `go_on` says no on the way.
fn book(rendering: &Rendering<'_>, diagnostics: &mut Vec<Diagnostic>, go_on: &dyn Fn() -> bool) -> Option<Book> {
    let mut book = Book::default();
    let pages = pages::all(rendering, diagnostics, go_on)?;
    let previews = previews::files(rendering, &pages);
    for (path, bytes) in pages.into_iter().chain(previews) {
        book.files.insert(path, bytes.into_bytes());
    }
    let (path, index) = go_on().then(|| search::file(rendering))?;
    book.files.insert(path, index.into_bytes());
    book.files.extend(rendering.templates.assets());
    if rendering.course.configuration.catalogue.is_empty() {
        book.files.remove(&format!("{}/{}", templates::ASSETS, shelf::STYLE));
    }
    site::files(rendering, &mut book);
    book.files.insert(FIGURES.to_owned(), machine::figures(rendering).into_bytes());
    let files = rendering.files.iter().flat_map(|files| files.iter());
    book.files.extend(files.map(|file| (file.path.clone(), file.bytes.clone())));
    for (path, bytes) in &rendering.workspace.blobs {
        let Some(name) = path.strip_prefix(CHAPTERS).and_then(|path| path.strip_prefix('/')) else { continue };
        if book.files.contains_key(name) {
            let message = format!("`{path}` has the name of a file that the book makes itself");
            diagnostics.push(Diagnostic::error(Code::Configuration, message).help("give it another name"));
            continue;
        }
        book.files.insert(name.to_owned(), bytes.to_vec());
    }
    Some(book)
}

/// Loads the templates and the citation style only to see whether they are right: what `check` can know without running.
pub fn check(course: &Course, plan: &Plan, workspace: &Workspace) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    Templates::load(workspace, &mut diagnostics);
    Citations::format(course, plan, workspace, &mut diagnostics);
    diagnostics
}
