//! `workbook clean`: remove cached results.

use std::collections::BTreeSet;

use clap::Args;

use super::{Exit, Options, report};
use crate::compose::{cache, check, jobs};
use crate::diag::{Code, Diagnostic};
use crate::receipt::Receipt;

#[derive(Args)]
pub(super) struct Arguments {
    /// Remove only results that the course as it stands does not use
    #[arg(long)]
    stale: bool,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let cache = cache(&options.root);
    let before = cache.size();
    let removed = if arguments.stale {
        let planned = check(&options.request());
        if Exit::of(&planned.diagnostics) != Exit::Fine {
            report::diagnostics(&planned.diagnostics, &planned.workspace, options);
            report::say("nothing is removed: while the course is wrong it is not known what it uses", options);
            return Exit::of(&planned.diagnostics);
        }
        let live: BTreeSet<_> = jobs(&planned.plan).iter().map(|job| job.key.digest()).collect();
        cache.remove(&cache.stale(&live))
    } else {
        Receipt::forget(&options.root);
        cache.clean()
    };
    match removed {
        Ok(()) => {
            report::say(
                &format!("removed {:.1} kB of results", before.saturating_sub(cache.size()) as f64 / 1e3),
                options,
            );
            Exit::Fine
        }
        Err(error) => {
            let error = Diagnostic::error(Code::Unwritable, format!("the cache cannot be cleaned: {error}"));
            report::wrong(&error, Exit::System, options)
        }
    }
}
