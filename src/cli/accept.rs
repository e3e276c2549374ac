//! `workbook accept`: record reviewed exhibits in the lock.

use std::collections::BTreeSet;

use clap::Args;

use super::progress::Progress;
use super::{Exit, Options, report};
use crate::compose::compose;
use crate::diag::{Code, Diagnostic, any_error};
use crate::verify::lock::Lock;
use crate::verify::{drift, now, read_lock};
use crate::write;

#[derive(Args)]
pub(super) struct Arguments {
    /// The exhibits that were reviewed; all if none is named
    ids: Vec<String>,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let composed = compose(&options.request(), &Progress::new(options));
    report::diagnostics(&composed.diagnostics, &composed.workspace, options);
    if any_error(&composed.diagnostics) {
        report::say("the lock is untouched: what is wrong cannot be accepted", options);
        return Exit::of(&composed.diagnostics);
    }
    let old = match read_lock(&options.root) {
        Ok(lock) => lock.unwrap_or_default(),
        // A broken lock can only be replaced whole.
        Err(broken) if !arguments.ids.is_empty() => {
            report::diagnostics(&broken, &composed.workspace, options);
            return Exit::Course;
        }
        Err(_) => Lock::default(),
    };
    let now = now(&composed.plan, &composed.shown);
    let reviewed: BTreeSet<String> = arguments.ids.iter().cloned().collect();
    let accepted = match drift::accept(&old, &now, (!reviewed.is_empty()).then_some(&reviewed)) {
        Ok(lock) => lock,
        Err(unknown) => {
            let message = format!("no exhibit has the id {}", unknown.join(", "));
            let error = Diagnostic::error(Code::MissingTarget, message).help("`workbook list exhibits` names them all");
            return report::wrong(&error, Exit::Call, options);
        }
    };
    if let Err(error) = write::write_lock(&options.root, &accepted.text()) {
        report::diagnostics(&[error], &composed.workspace, options);
        return Exit::System;
    }
    let drifts = drift::compare(&old, &now);
    let changed = drifts.iter().filter(|drift| reviewed.is_empty() || reviewed.contains(drift.id())).count();
    report::say(&format!("the lock holds {} exhibits; {changed} changed", accepted.records.len()), options);
    Exit::Fine
}
