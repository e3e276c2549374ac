//! Chapters that code writes: the catalogue, with a page for every sampler, scramble, integrand and measure.
//!
//! A page is markdown, as an author would write it, with ordinary `experiment` and `listing` fences: from here on nothing knows that no person
//! wrote it. What it says comes from the entry itself: its text about itself, what it declares, what it admits. A new entry has its
//! page as soon as it stands in its catalogue.

mod choice;
mod code;
mod integrand;
mod manual;
mod measure;
mod page;
mod sampler;
mod sampler_claims;
mod scramble;
mod shelves;
mod typeset;

use crate::diag::Diagnostic;
use crate::integrands::INTEGRANDS;
use crate::metrics::METRICS;
use crate::parse::{Configuration, Generated, Shelf};
use crate::samplers::SAMPLERS;
use crate::scrambles::SCRAMBLES;
use crate::workspace::Source;

/// The folder of the pages' paths. No file of a course is read from there.
pub const FOLDER: &str = "catalogue";

/// The pages that the configuration asks for: each shelf's own, then those of its members.
pub fn chapters(configuration: &Configuration) -> Vec<Generated> {
    configuration.catalogue.iter().flat_map(|&shelf| shelf_of(shelf, &configuration.catalogue)).collect()
}

/// The pages of one shelf; `all` are the shelves of the book.
fn shelf_of(shelf: Shelf, all: &[Shelf]) -> Vec<Generated> {
    let mut pages = vec![generated(shelf, None, shelves::page(shelf, all))];
    let mut add = |about: &str, text: String| {
        let number = pages.len();
        pages.push(generated(shelf, Some((number, about)), text));
    };
    match shelf {
        Shelf::Samplers => SAMPLERS.iter().for_each(|entry| add(entry.about().key, sampler::page(*entry, all))),
        Shelf::Scrambles => SCRAMBLES.iter().for_each(|entry| add(entry.about().key, scramble::page(*entry, all))),
        Shelf::Integrands => INTEGRANDS.iter().for_each(|entry| add(entry.about().key, integrand::page(*entry, all))),
        Shelf::Measures => METRICS.iter().for_each(|entry| add(entry.about().key, measure::page(*entry, all))),
    }
    pages
}

/// A page with its number and its path; of a member, its place on the shelf from 1 and its key are given.
fn generated(shelf: Shelf, member: Option<(usize, &str)>, text: String) -> Generated {
    let name = member.map_or_else(|| shelf.name().to_owned(), |(_, key)| shelf.page(key));
    let number = member.map_or_else(|| shelf.letter().to_owned(), |(at, _)| format!("{}{at}", shelf.letter()));
    let source = Source { path: format!("{FOLDER}/{name}.md").into(), text: text.into() };
    Generated { source, shelf, member: member.is_some(), number }
}

/// Adds to diagnostics that are about such pages where their text comes from.
pub fn explain(diagnostics: &mut [Diagnostic]) {
    let generated = |diagnostic: &&mut Diagnostic| {
        let place = diagnostic.place.as_ref();
        place.is_some_and(|place| {
            place.file.starts_with(FOLDER) && place.file.as_bytes().get(FOLDER.len()) == Some(&b'/')
        })
    };
    for diagnostic in diagnostics.iter_mut().filter(generated) {
        let help = "this page is no file: the program writes it from the entry of the catalogue; `[catalogue]` in workbook.toml asks for it";
        if !diagnostic.help.iter().any(|line| line == help) {
            diagnostic.help.push(help.to_owned());
        }
    }
}
