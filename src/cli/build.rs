//! `workbook build`: make the book.

use std::path::Path;
use std::time::Instant;

use super::progress::Progress;
use super::{Exit, Options, Readers, report, timings};
use crate::compose::{Composed, Request, compose};
use crate::diag::{Diagnostic, Severity, any_error};
use crate::parse::Audience;
use crate::receipt::{self, Counts, Receipt};
use crate::run::How;
use crate::verify::{drift, now, read_lock};
use crate::workspace::{self, Workspace};
use crate::write;

pub(super) fn run(readers: &Readers, options: &Options) -> Exit {
    let start = Instant::now();
    if let Some((workspace, receipt)) = unchanged(readers, options) {
        let out = options.out(Audience::Instructor);
        report::say(&summary(&receipt.counts, write::Outcome::Unchanged, 0, start, &out), options);
        report::diagnostics(&receipt.diagnostics, &workspace, options);
        timings::tell(&[("in all", start.elapsed())], &[], options);
        return Exit::of(&receipt.diagnostics);
    }
    let request = Request { audience: readers.audience, ..options.request() };
    let mut composed = compose(&request, &Progress::new(options));
    let mut stages = composed.timings.clone();
    if !any_error(&composed.diagnostics) {
        let inputs = receipt::inputs(composed.course_digest, readers.audience, &options.root);
        composed.diagnostics.extend(drifted(&composed, options));
        let writing = Instant::now();
        let out = options.out(composed.audience);
        let written = match composed.audience {
            Audience::Student => write::without_lock(&composed.book, &out),
            Audience::Instructor => write::write(&composed.book, &out),
        };
        match written {
            Ok(outcome) => {
                let (counts, ran) = counts(&composed);
                report::say(&summary(&counts, outcome, ran, start, &out), options);
                if may_be_repeated(&composed, options) {
                    Receipt::new(inputs, &composed.book, counts, composed.diagnostics.clone()).keep(&options.root);
                }
            }
            Err(error) => composed.diagnostics.push(error),
        }
        stages.push(("write", writing.elapsed()));
    }
    stages.push(("in all", start.elapsed()));
    report::diagnostics(&composed.diagnostics, &composed.workspace, options);
    timings::tell(&stages, &composed.ran, options);
    Exit::of(&composed.diagnostics)
}

/// The receipt of the last build, if it was made of the same and its book is still there.
fn unchanged(readers: &Readers, options: &Options) -> Option<(Workspace, Receipt)> {
    if options.no_cache || readers.audience == Some(Audience::Student) {
        return None;
    }
    let (workspace, complaints) = workspace::load(&options.root);
    let digest = complaints.is_empty().then(|| receipt::course(&workspace))?;
    let inputs = receipt::inputs(digest, readers.audience, &options.root);
    Receipt::find(&options.root, inputs, &options.out(Audience::Instructor)).map(|receipt| (workspace, receipt))
}

/// Whether the build depends on nothing but what a receipt knows of: not on git, and all that was said is of files of the course.
fn may_be_repeated(composed: &Composed, options: &Options) -> bool {
    let repository = &composed.course.configuration.site.repository;
    let generated = |diagnostic: &Diagnostic| {
        diagnostic.place.as_ref().is_some_and(|place| !options.root.join(&*place.file).is_file())
    };
    !options.no_cache
        && composed.audience == Audience::Instructor
        && !repository.asks_for_commit()
        && !repository.last_change
        && !composed.diagnostics.iter().any(generated)
}

/// What has drifted from the lock, as warnings: building never writes the lock.
fn drifted(composed: &Composed, options: &Options) -> Vec<Diagnostic> {
    match read_lock(&options.root) {
        Ok(Some(lock)) => {
            let drifts = drift::compare(&lock, &now(&composed.plan, &composed.shown));
            // The lock is of the whole book: what is withheld is not missing.
            let drifts = drifts.iter().filter(|drift| !composed.withheld.contains(drift.id()));
            drifts.map(|drift| drift.diagnostic(Severity::Warning)).collect()
        }
        Ok(None) => Vec::new(),
        Err(broken) => broken.into_iter().map(|error| Diagnostic { severity: Severity::Warning, ..error }).collect(),
    }
}

/// How much a book has, and how many of its experiments ran.
fn counts(composed: &Composed) -> (Counts, usize) {
    let counts = Counts {
        chapters: composed.course.chapters.len(),
        exhibits: composed.shown.len(),
        experiments: composed.ran.len(),
        claims: composed.shown.iter().map(|shown| shown.verdicts.len()).sum(),
    };
    (counts, composed.ran.iter().filter(|ran| ran.how != How::Cached).count())
}

fn summary(counts: &Counts, outcome: write::Outcome, ran: usize, start: Instant, out: &Path) -> String {
    let place = out.join("index.html");
    let what = match outcome {
        write::Outcome::Written => "wrote",
        write::Outcome::Unchanged => "nothing changed in",
    };
    format!(
        "{what} {}: {}, {} ({ran} of {} ran), {} verified, {:.2} s",
        place.display(),
        report::counted(counts.chapters, "chapter"),
        report::counted(counts.exhibits, "exhibit"),
        report::counted(counts.experiments, "experiment"),
        report::counted(counts.claims, "claim"),
        start.elapsed().as_secs_f64()
    )
}
