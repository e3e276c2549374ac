//! What a page chooses: the nearest counts that an entry admits, and where its links lead.

use crate::catalogue::About;
use crate::integrands::INTEGRANDS;
use crate::metrics::METRICS;
use crate::parse::Shelf;
use crate::samplers::{Method, Refused, SAMPLERS};
use crate::scrambles::SCRAMBLES;

/// The count nearest to `n` that a method admits in `d` dimensions; none if it has not so many dimensions.
pub(super) fn nearest_count(method: &Method, n: usize, d: usize) -> Option<usize> {
    match method.admits(n, d) {
        Ok(()) => Some(n),
        Err(Refused::Count { below, above, .. }) => {
            // By the ratio: 8 is as far from 16 as 32 is.
            let far = |other: usize| if other > n { other as f64 / n as f64 } else { n as f64 / other as f64 };
            [below, above].into_iter().flatten().filter(|&n| n > 1).min_by(|a, b| far(*a).total_cmp(&far(*b)))
        }
        Err(_) => None,
    }
}

/// The counts nearest to `counts` that all `methods` admit alike, ascending; a count that they do not share is left out.
pub(super) fn counts(methods: &[Method], counts: &[usize], d: usize) -> Vec<usize> {
    let nearest = |&n: &usize| nearest_count(methods.first()?, n, d);
    let shared = |n: &usize| methods.iter().all(|method| method.admits(*n, d).is_ok());
    let mut counts: Vec<usize> = counts.iter().filter_map(nearest).filter(shared).collect();
    counts.sort_unstable();
    counts.dedup();
    counts
}

/// Two dimensions where the method has them, else one.
pub(super) fn dimensions(method: &Method) -> usize {
    if nearest_count(method, 64, 2).is_some() { 2 } else { 1 }
}

/// A link of an entry's own text, `[words](super::halton)`: to the page of that entry if the book has it, else the words alone.
pub(super) fn link(words: &str, target: &str, shelves: &[Shelf]) -> String {
    let module = target.rsplit("::").find(|part| !part.is_empty()).unwrap_or(target);
    let stem = |about: &About| about.file.rsplit('/').next().and_then(|file| file.strip_suffix(".rs")) == Some(module);
    let found = entries().find(|(shelf, about)| shelves.contains(shelf) && stem(about));
    found.map_or_else(
        || words.to_owned(),
        |(shelf, about)| {
            let words = if words.starts_with('`') { about.title } else { words };
            format!("[{words}]({}.md)", shelf.page(about.key))
        },
    )
}

/// A link to the page of a member if the book has the shelf, else its title.
pub(super) fn member(shelf: Shelf, about: &About, shelves: &[Shelf]) -> String {
    if shelves.contains(&shelf) {
        format!("[{}]({}.md)", about.title, shelf.page(about.key))
    } else {
        about.title.to_owned()
    }
}

/// Every entry that can have a page, with its shelf.
fn entries() -> impl Iterator<Item = (Shelf, &'static About)> {
    let samplers = SAMPLERS.iter().map(|entry| (Shelf::Samplers, entry.about()));
    let scrambles = SCRAMBLES.iter().map(|entry| (Shelf::Scrambles, entry.about()));
    let integrands = INTEGRANDS.iter().map(|entry| (Shelf::Integrands, entry.about()));
    samplers.chain(scrambles).chain(integrands).chain(METRICS.iter().map(|entry| (Shelf::Measures, entry.about())))
}
