//! The pages around the chapters that the book makes of itself: the index of exhibits, and the kinds of experiments.

use serde::Serialize;

use super::Rendering;
use super::exhibit::label;
use super::inline::inline_code;
use super::markdown::Writer;
use super::table;
use crate::chart::Drawing;
use crate::diag::Diagnostic;
use crate::kinds;
use crate::parameters::ParameterDoc;
use crate::plan::{escape, minus};

/// A page that is no chapter.
pub(super) struct Matter {
    /// Its name in the lists of pages.
    pub title: &'static str,
    /// Its path in the book, and the name of its template.
    pub href: &'static str,
    /// What it holds, in a sentence.
    pub summary: &'static str,
}

/// The index of exhibits.
pub(super) const EXHIBITS: Matter =
    Matter { title: "Exhibits", href: "exhibits.html", summary: "Every figure and table of the book, with its place." };

/// The index of terms, of a book that has any.
pub(super) const TERMS: Matter = Matter {
    title: "Index of terms",
    href: "terms.html",
    summary: "Every term, with the place of its definition and the sections that use it.",
};

/// The kinds of experiments.
pub(super) const KINDS: Matter = Matter {
    title: "Kinds of experiments",
    href: "kinds.html",
    summary: "What a chapter can ask to be computed, and how it asks.",
};

/// The works that are cited.
pub(super) const BIBLIOGRAPHY: Matter =
    Matter { title: "Bibliography", href: "bibliography.html", summary: "The works that the chapters cite." };

/// What the build knows of itself.
pub(super) const MADE: Matter = Matter {
    title: "How this book was made",
    href: "made.html",
    summary: "What is computed, how claims are verified, and where every number comes from.",
};

/// The pages that are no chapters, in their order.
pub(super) const MATTER: [Matter; 5] = [EXHIBITS, TERMS, KINDS, BIBLIOGRAPHY, MADE];

/// Those of them that this book has.
pub(super) fn of(rendering: &Rendering<'_>) -> impl Iterator<Item = &'static Matter> {
    let terms = !rendering.plan.terms.is_empty();
    MATTER.iter().filter(move |matter| terms || matter.href != TERMS.href)
}

/// A chapter's part of the index of exhibits.
#[derive(Serialize)]
pub(super) struct Group<'a> {
    number: &'a str,
    title: &'a str,
    href: String,
    exhibits: Vec<Thumbnail<'a>>,
}

/// An exhibit, small.
#[derive(Serialize)]
struct Thumbnail<'a> {
    id: &'a str,
    label: String,
    kind: &'static str,
    caption: String,
    claims: usize,
    /// The picture's files, if it is a picture.
    images: Vec<&'a str>,
    /// A table's HTML, if it is a table.
    table: Option<String>,
}

/// The exhibits by chapter.
pub(super) fn groups<'a>(rendering: &'a Rendering<'a>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Group<'a>> {
    let chapters = rendering.course.chapters.iter().enumerate().filter(|(_, chapter)| chapter.shelf.is_none());
    let groups = chapters.map(|(index, chapter)| {
        let indices = (0..rendering.plan.exhibits.len()).filter(|&at| rendering.plan.exhibits[at].chapter == index);
        let exhibits = indices.map(|index| thumbnail(rendering, index, diagnostics)).collect();
        Group { number: &chapter.number, title: &chapter.front.title, href: rendering.href(index), exhibits }
    });
    groups.filter(|group| !group.exhibits.is_empty()).collect()
}

fn thumbnail<'a>(rendering: &'a Rendering<'a>, index: usize, diagnostics: &mut Vec<Diagnostic>) -> Thumbnail<'a> {
    let (exhibit, shown) = (&rendering.plan.exhibits[index], &rendering.shown[index]);
    let (caption, complaints) = Writer::new(rendering, exhibit.chapter).inline(&exhibit.caption);
    diagnostics.extend(complaints);
    Thumbnail {
        id: &exhibit.id,
        label: label(rendering, &exhibit.id),
        kind: exhibit.experiment.kind().about().key,
        // Links within links are no HTML, and a definition stands in its chapter.
        caption: without_marks(&caption),
        claims: shown.verdicts.len(),
        images: images(rendering, index).collect(),
        table: match &*shown.drawing {
            Drawing::Table(drawn) => Some(table::html(drawn, rendering.converter)),
            _ => None,
        },
    }
}

/// The files of an exhibit that are pictures.
pub(super) fn images<'a>(rendering: &'a Rendering<'_>, index: usize) -> impl Iterator<Item = &'a str> {
    let is_picture = |path: &&str| [".svg", ".png"].iter().any(|end| path.ends_with(end));
    rendering.files[index].iter().map(|file| file.path.as_str()).filter(is_picture)
}

/// HTML without the tags of links and definitions; their words stay.
fn without_marks(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = ["<a ", "<a>", "</a>", "<dfn ", "</dfn>"].iter().filter_map(|tag| rest.find(tag)).min() {
        out.push_str(&rest[..at]);
        rest = rest[at..].find('>').map_or("", |end| &rest[at + end + 1..]);
    }
    out + rest
}

/// A kind with what a chapter can ask of it.
#[derive(Serialize)]
pub(super) struct KindContext {
    key: &'static str,
    title: String,
    summary: String,
    parameters: Vec<ParameterContext>,
    exhibits: Vec<UseContext>,
}

/// What a chapter can ask of a kind.
#[derive(Serialize)]
struct ParameterContext {
    name: &'static str,
    meaning: String,
    expected: String,
    required: bool,
    default: Option<&'static str>,
}

impl From<ParameterDoc> for ParameterContext {
    fn from(doc: ParameterDoc) -> Self {
        let limits = doc.limits.map(|limits| format!(", {}", minus(&limits))).unwrap_or_default();
        Self {
            name: doc.name,
            meaning: literals(doc.meaning),
            expected: literals(&(doc.type_name + &limits)),
            required: doc.required,
            default: doc.default,
        }
    }
}

/// Plain words as HTML, with what stands between backticks as code.
fn literals(words: &str) -> String {
    let parts = words.split('`').enumerate();
    let prose = |part: &str| escape(&part.replace('\'', "’"));
    let part = |(index, part)| if index % 2 == 0 { prose(part) } else { inline_code(part) };
    parts.map(part).collect()
}

/// An exhibit of a kind.
#[derive(Serialize)]
struct UseContext {
    label: String,
    href: String,
}

/// Every kind, in the order of the catalogue, with the exhibits of this book that are of it.
pub(super) fn kinds(rendering: &Rendering<'_>) -> Vec<KindContext> {
    let of = |key: &'static str| {
        let exhibits =
            rendering.plan.exhibits.iter().filter(move |exhibit| exhibit.experiment.kind().about().key == key);
        let (catalogue, chapters): (Vec<_>, Vec<_>) =
            exhibits.partition(|exhibit| rendering.course.chapters[exhibit.chapter].shelf.is_some());
        // The catalogue has many alike: some of them do where no chapter has any.
        let shown = if chapters.is_empty() { catalogue.into_iter().take(6).collect() } else { chapters };
        let uses = shown.into_iter().map(|exhibit| UseContext {
            label: label(rendering, &exhibit.id),
            href: format!("{}#{}", rendering.href(exhibit.chapter), exhibit.id),
        });
        uses.collect()
    };
    let context = |kind: &&'static dyn kinds::AnyKind| {
        let about = kind.about();
        KindContext {
            key: about.key,
            title: about.title.replace('\'', "’"),
            summary: literals(about.summary),
            parameters: kind.parameters().into_iter().map(ParameterContext::from).collect(),
            exhibits: of(about.key),
        }
    };
    kinds::KINDS.iter().map(context).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_chapter_can_have_the_name_of_a_page() {
        for matter in &MATTER {
            let name = matter.href.strip_suffix(".html").unwrap_or_default();
            assert!(crate::parse::OWN_PAGES.contains(&name), "{name}");
        }
    }

    #[test]
    fn links_and_definitions_lose_their_tags_only() {
        let html = "a <a class=\"x\" href=\"y\">b</a> <abbr>c</abbr> <dfn id=\"term-d\"><em>d</em></dfn>";
        assert_eq!(without_marks(html), "a b <abbr>c</abbr> <em>d</em>");
        assert_eq!(without_marks("plain"), "plain");
    }
}
