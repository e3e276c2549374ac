//! `workbook build`: make the book.

use std::time::Instant;

use super::progress::Progress;
use super::{Exit, Options, report, timings};
use crate::compose::{Composed, compose};
use crate::diag::{Diagnostic, Severity, any_error};
use crate::receipt::{self, Counts, Receipt};
use crate::run::How;
use crate::verify::{drift, now, read_lock};
use crate::workspace::{self, Workspace};
use crate::write;

pub(super) fn run(options: &Options) -> Exit {
    let start = Instant::now();
    if let Some((workspace, receipt)) = unchanged(options) {
        report::say(&summary(&receipt.counts, write::Outcome::Unchanged, 0, start, options), options);
        report::diagnostics(&receipt.diagnostics, &workspace, options);
        timings::tell(&[("in all", start.elapsed())], &[], options);
        return Exit::of(&receipt.diagnostics);
    }
    let mut composed = compose(&options.request(), &Progress::new(options));
    let mut stages = composed.timings.clone();
    if !any_error(&composed.diagnostics) {
        let inputs = receipt::inputs(&options.root, &composed.workspace);
        composed.diagnostics.extend(drifted(&composed, options));
        let writing = Instant::now();
        match write::write(&composed.book, &options.out()) {
            Ok(outcome) => {
                let (counts, ran) = counts(&composed);
                report::say(&summary(&counts, outcome, ran, start, options), options);
                if !options.no_cache {
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
fn unchanged(options: &Options) -> Option<(Workspace, Receipt)> {
    if options.no_cache {
        return None;
    }
    let (workspace, complaints) = workspace::load(&options.root);
    let inputs = complaints.is_empty().then(|| receipt::inputs(&options.root, &workspace))?;
    Receipt::find(&options.root, inputs, &options.out()).map(|receipt| (workspace, receipt))
}

/// What has drifted from the lock, as warnings: building never writes the lock.
fn drifted(composed: &Composed, options: &Options) -> Vec<Diagnostic> {
    match read_lock(&options.root) {
        Ok(Some(lock)) => {
            let drifts = drift::compare(&lock, &now(&composed.plan, &composed.shown));
            drifts.iter().map(|drift| drift.diagnostic(Severity::Warning)).collect()
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

fn summary(counts: &Counts, outcome: write::Outcome, ran: usize, start: Instant, options: &Options) -> String {
    let place = options.out().join("index.html");
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
