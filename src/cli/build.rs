//! `workbook build`: make the book.

use std::time::Instant;

use super::progress::Progress;
use super::{Exit, Options, report, timings};
use crate::compose::{Composed, compose};
use crate::diag::{Diagnostic, Severity, any_error};
use crate::run::How;
use crate::verify::{drift, now, read_lock};
use crate::write;

pub(super) fn run(options: &Options) -> Exit {
    let start = Instant::now();
    let mut composed = compose(&options.request(), &Progress::new(options));
    let mut stages = composed.timings.clone();
    if !any_error(&composed.diagnostics) {
        composed.diagnostics.extend(drifted(&composed, options));
        let writing = Instant::now();
        match write::write(&composed.book, &options.out()) {
            Ok(outcome) => report::say(&summary(&composed, outcome, start, options), options),
            Err(error) => composed.diagnostics.push(error),
        }
        stages.push(("write", writing.elapsed()));
    }
    stages.push(("in all", start.elapsed()));
    report::diagnostics(&composed.diagnostics, &composed.workspace, options);
    timings::tell(&stages, &composed.ran, options);
    Exit::of(&composed.diagnostics)
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

fn summary(composed: &Composed, outcome: write::Outcome, start: Instant, options: &Options) -> String {
    let ran = composed.ran.iter().filter(|ran| ran.how != How::Cached).count();
    let claims: usize = composed.shown.iter().map(|shown| shown.verdicts.len()).sum();
    let place = options.out().join("index.html");
    let what = match outcome {
        write::Outcome::Written => "wrote",
        write::Outcome::Unchanged => "nothing changed in",
    };
    format!(
        "{what} {}: {}, {} ({ran} of {} ran), {} verified, {:.2} s",
        place.display(),
        report::counted(composed.course.chapters.len(), "chapter"),
        report::counted(composed.shown.len(), "exhibit"),
        report::counted(composed.ran.len(), "experiment"),
        report::counted(claims, "claim"),
        start.elapsed().as_secs_f64()
    )
}
