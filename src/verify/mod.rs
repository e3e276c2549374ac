//! Verifying: the book as its reader would meet it, held against what was reviewed.

pub mod drift;
pub mod lock;
pub mod requests;
pub mod site;
mod sitemap;
mod tags;
pub mod weight;

use std::path::Path;

use crate::diag::{Code, Diagnostic};
use crate::exhibits::Shown;
use crate::parse::Course;
use crate::plan::Plan;
use crate::render::Book;
use crate::sources::Digest;
use drift::Now;
use lock::Lock;

/// Everything that must hold of a finished book: links and ids, no request to another host, the sitemap, the weight.
pub fn book(book: &Book, course: &Course) -> Vec<Diagnostic> {
    let site = &course.configuration.site;
    let mut diagnostics = site::check(book, site.root());
    diagnostics.extend(requests::check(book));
    diagnostics.extend(sitemap::check(book, site.base_url.as_deref()));
    diagnostics.extend(weight::check(book, course));
    diagnostics
}

/// The lock of the course at `root`: `None` if there is none, and what is wrong with it if it cannot be read.
pub fn read_lock(root: &Path) -> Result<Option<Lock>, Vec<Diagnostic>> {
    let path = root.join(lock::FILE);
    if !path.exists() {
        return Ok(None);
    }
    let text = std::fs::read_to_string(&path)
        .map_err(|error| vec![Diagnostic::error(Code::Lock, format!("`{}` cannot be read: {error}", lock::FILE))])?;
    Lock::read(&text).map(Some)
}

/// What each exhibit of a plan is now, in the order of the book; `shown` are the plan's exhibits.
pub fn now(plan: &Plan, shown: &[Shown]) -> Vec<Now> {
    let exhibits = plan.exhibits.iter().zip(shown);
    exhibits
        .map(|(exhibit, shown)| Now {
            id: exhibit.id.clone(),
            kind: exhibit.experiment.kind().about().key.to_owned(),
            place: exhibit.place.clone(),
            key: Digest::parse(&shown.key).unwrap_or_else(|| Digest::of(shown.key.as_bytes())),
            data: Digest::of(&shown.outcome.bytes),
            drawing: Digest::of(shown.drawing.text().as_bytes()),
            values: shown.outcome.values.clone(),
        })
        .collect()
}
