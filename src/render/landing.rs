//! The landing page: what the course is, and its chapters with a picture each.

use serde::Serialize;

use super::Rendering;
use super::markdown::Writer;
use super::matter;
use super::pages::{self, BookContext, ChapterContext, PageContext, SectionContext};
use super::templates::ASSETS;
use crate::diag::{Code, Diagnostic};
use crate::parse::Chosen;
use crate::workspace::extension;

#[derive(Serialize)]
struct LandingPage<'a> {
    book: BookContext<'a>,
    page: PageContext<'a>,
    assets: &'static str,
    passages: Vec<PassageContext<'a>>,
    cards: Vec<Card<'a>>,
    exhibit_count: usize,
    claim_count: usize,
    contents: Vec<SectionContext>,
}

/// A passage on the course.
#[derive(Serialize)]
struct PassageContext<'a> {
    title: &'a str,
    body: String,
}

/// A chapter as the landing page shows it.
#[derive(Serialize)]
struct Card<'a> {
    #[serde(flatten)]
    chapter: ChapterContext<'a>,
    /// The files of its picture; none if nothing in it is drawn.
    images: Vec<&'a str>,
    exhibits: usize,
    claims: usize,
}

/// The landing page.
pub(super) fn page(rendering: &Rendering<'_>, diagnostics: &mut Vec<Diagnostic>) -> String {
    let configuration = &rendering.course.configuration;
    let passages = configuration.landing.iter().map(|passage| {
        let (body, complaints) = Writer::outside(rendering).inline(&passage.nodes);
        diagnostics.extend(complaints);
        PassageContext { title: &passage.title, body }
    });
    let context = LandingPage {
        passages: passages.collect(),
        cards: pages::chapters(rendering, None).enumerate().map(|(at, chapter)| card(rendering, at, chapter)).collect(),
        book: pages::book(rendering, None),
        page: PageContext {
            title: &configuration.title,
            number: None,
            word: "",
            summary: &configuration.summary,
            href: "index.html".to_owned(),
        },
        assets: ASSETS,
        exhibit_count: rendering.shown.len(),
        claim_count: rendering.shown.iter().map(|shown| shown.verdicts.len()).sum(),
        contents: Vec::new(),
    };
    diagnostics.extend((0..rendering.course.chapters.len()).filter_map(|chapter| not_drawn(rendering, chapter)));
    rendering.templates.fill("index.html", &context, diagnostics)
}

fn card<'a>(rendering: &'a Rendering<'_>, index: usize, chapter: ChapterContext<'a>) -> Card<'a> {
    let picture = match &rendering.course.chapters[index].front.picture {
        Some(Chosen { id, .. }) => exhibits(rendering, index).find(|&at| rendering.plan.exhibits[at].id == *id),
        None => exhibits(rendering, index).find(|&at| matter::images(rendering, at).next().is_some()),
    };
    Card {
        chapter,
        images: picture.map(|at| images(rendering, at)).unwrap_or_default(),
        exhibits: exhibits(rendering, index).count(),
        claims: exhibits(rendering, index).map(|at| rendering.shown[at].verdicts.len()).sum(),
    }
}

/// The exhibits of a chapter, as indices into the plan.
fn exhibits(rendering: &Rendering<'_>, chapter: usize) -> impl Iterator<Item = usize> {
    (0..rendering.plan.exhibits.len()).filter(move |&at| rendering.plan.exhibits[at].chapter == chapter)
}

/// What a small sheet shows of an exhibit: its drawing, or of several pictures the first two.
fn images<'a>(rendering: &'a Rendering<'_>, exhibit: usize) -> Vec<&'a str> {
    let pixels = || matter::images(rendering, exhibit).filter(|path| extension(path) == Some("png")).take(2);
    if pixels().next().is_some() { pixels().collect() } else { matter::images(rendering, exhibit).collect() }
}

/// A complaint if the exhibit that the chapter names to stand for it has no drawing.
fn not_drawn(rendering: &Rendering<'_>, chapter: usize) -> Option<Diagnostic> {
    let chapter_of = &rendering.course.chapters[chapter];
    let Chosen { id, range } = chapter_of.front.picture.as_ref()?;
    let named = exhibits(rendering, chapter).find(|&at| rendering.plan.exhibits[at].id == *id)?;
    let first = exhibits(rendering, chapter).find(|&at| matter::images(rendering, at).next().is_some());
    let near = first.map(|at| format!("choose one that has, such as `{}`", rendering.plan.exhibits[at].id));
    matter::images(rendering, named).next().is_none().then(|| {
        Diagnostic::error(Code::MissingTarget, format!("`{id}` has no drawing that could stand for the chapter"))
            .at(&chapter_of.file, range.clone())
            .help_if(near)
    })
}
