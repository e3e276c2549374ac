//! The index of terms: every term by its letter, where it is defined and where it is used.

use serde::Serialize;

use super::Rendering;
use super::markdown::Writer;
use crate::diag::Diagnostic;
use crate::parse::Chapter;
use crate::plan::terms::{Definition, Spot, id};

/// The terms that begin with the same letter.
#[derive(Serialize)]
pub(super) struct Letter {
    /// The letter as a reader sees it; `0–9` for digits.
    name: String,
    id: String,
    terms: Vec<TermContext>,
}

/// A term.
#[derive(Serialize)]
struct TermContext {
    /// Its head-word, as HTML.
    head: String,
    href: String,
    /// The section that defines it, e.g. `Section 3.1`.
    place: String,
    uses: Vec<UseContext>,
}

/// A section that uses a term.
#[derive(Serialize)]
struct UseContext {
    place: String,
    href: String,
}

/// The letters that terms begin with, in the order of the alphabet.
pub(super) fn letters(rendering: &Rendering<'_>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Letter> {
    let mut letters: Vec<Letter> = Vec::new();
    for (key, definition) in rendering.plan.terms.alphabetical() {
        let (name, id) = initial(&definition.order);
        let term = context(rendering, key, definition, diagnostics);
        match letters.last_mut().filter(|last| last.id == id) {
            Some(last) => last.terms.push(term),
            None => letters.push(Letter { name, id, terms: vec![term] }),
        }
    }
    letters
}

/// The letter of a slug, and its id on the page.
fn initial(slug: &str) -> (String, String) {
    match slug.chars().next() {
        Some(c) if c.is_numeric() => ("0–9".to_owned(), "digits".to_owned()),
        Some(c) => (c.to_uppercase().collect(), format!("letter-{c}")),
        None => (String::new(), "letter".to_owned()),
    }
}

fn context(
    rendering: &Rendering<'_>,
    key: &str,
    definition: &Definition,
    diagnostics: &mut Vec<Diagnostic>,
) -> TermContext {
    let spot = definition.spot;
    let (head, complaints) = Writer::new(rendering, spot.chapter).inline(&definition.head);
    diagnostics.extend(complaints);
    let uses = definition.uses.iter().map(|&spot| {
        let (number, href) = place(rendering, spot);
        UseContext { place: number.unwrap_or_else(|| chapter(rendering, spot)), href }
    });
    TermContext {
        head,
        href: format!("{}#{}", rendering.href(spot.chapter), id(key)),
        place: match place(rendering, spot).0 {
            Some(number) => format!("Section {number}"),
            None => chapter(rendering, spot),
        },
        uses: uses.collect(),
    }
}

/// The number of a section, if the place is in one, and the address.
fn place(rendering: &Rendering<'_>, spot: Spot) -> (Option<String>, String) {
    let page = rendering.href(spot.chapter);
    let section = spot.section.and_then(|section| rendering.plan.labels.sections(spot.chapter).get(section));
    match section {
        Some(section) => (Some(section.number.clone()), format!("{page}#{}", section.id)),
        None => (None, page),
    }
}

/// What a reader calls the chapter of a place.
fn chapter(rendering: &Rendering<'_>, spot: Spot) -> String {
    rendering.course.chapters.get(spot.chapter).map(Chapter::name).unwrap_or_default()
}
