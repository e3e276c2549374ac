//! `workbook verify`: compute everything anew and compare it with the lock.

use super::progress::Progress;
use super::{Exit, Options, report, timings};
use crate::compose::{Composed, Request, compose};
use crate::diag::{Diagnostic, Severity};
use crate::verify::{drift, lock, now, read_lock};

pub(super) fn run(options: &Options) -> Exit {
    let request = Request { cached: false, ..options.request() };
    let mut composed = compose(&request, &Progress::new(options));
    // A false claim is most often drift: both are told in one run.
    if composed.is_whole() {
        let compared = compare(&composed, options);
        composed.diagnostics.extend(compared);
    }
    report::diagnostics(&composed.diagnostics, &composed.workspace, options);
    timings::tell(&composed.timings, &composed.ran, options);
    let exit = Exit::of(&composed.diagnostics);
    if exit == Exit::Fine {
        let claims: usize = composed.shown.iter().map(|shown| shown.verdicts.len()).sum();
        let exhibits = composed.shown.len();
        let (exhibits, claims) = (report::counted(exhibits, "exhibit"), report::counted(claims, "claim"));
        report::say(&format!("as in the lock: {exhibits}; verified: {claims}"), options);
    }
    exit
}

/// Every difference from the lock, as errors.
fn compare(composed: &Composed, options: &Options) -> Vec<Diagnostic> {
    match read_lock(&options.root) {
        Ok(Some(lock)) => {
            let drifts = drift::compare(&lock, &now(&composed.plan, &composed.shown));
            drifts.iter().map(|drift| drift.diagnostic(Severity::Error)).collect()
        }
        Ok(None) => vec![lock::absent()],
        Err(broken) => broken,
    }
}
