//! `workbook build`: make the book.

use std::time::Instant;

use super::progress::Progress;
use super::{Exit, Options, Readers, report, timings};
use crate::compose::{Composed, Request, compose};
use crate::diag::{Diagnostic, Severity, any_error};
use crate::parse::Audience;
use crate::run::How;
use crate::verify::{drift, now, read_lock};
use crate::write;

pub(super) fn run(readers: &Readers, options: &Options) -> Exit {
    let start = Instant::now();
    let request = Request { audience: readers.audience, ..options.request() };
    let mut composed = compose(&request, &Progress::new(options));
    let mut stages = composed.timings.clone();
    if !any_error(&composed.diagnostics) {
        composed.diagnostics.extend(drifted(&composed, options));
        let writing = Instant::now();
        let out = options.out(composed.audience);
        let written = match composed.audience {
            Audience::Student => write::without_lock(&composed.book, &out),
            Audience::Instructor => write::write(&composed.book, &out),
        };
        match written {
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
            // The lock is of the whole book: what is withheld is not missing.
            let drifts = drifts.iter().filter(|drift| !composed.withheld.contains(drift.id()));
            drifts.map(|drift| drift.diagnostic(Severity::Warning)).collect()
        }
        Ok(None) => Vec::new(),
        Err(broken) => broken.into_iter().map(|error| Diagnostic { severity: Severity::Warning, ..error }).collect(),
    }
}

fn summary(composed: &Composed, outcome: write::Outcome, start: Instant, options: &Options) -> String {
    let ran = composed.ran.iter().filter(|ran| ran.how != How::Cached).count();
    let claims: usize = composed.shown.iter().map(|shown| shown.verdicts.len()).sum();
    let place = options.out(composed.audience).join("index.html");
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
