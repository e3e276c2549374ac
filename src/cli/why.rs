//! `workbook why`: whether an exhibit is fresh or stale, and the parts of its key that differ from the last run's.

use std::fmt::Write as _;

use clap::Args;

use super::{Exit, Options, report};
use crate::compose::{cache, check, job};
use crate::run::{How, Why, status};

#[derive(Args)]
pub(super) struct Arguments {
    /// The exhibit's id
    id: String,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let planned = check(&options.request());
    let Some(exhibit) = planned.plan.exhibit(&arguments.id) else {
        return report::no_exhibit(&arguments.id, &planned, options);
    };
    let cache = cache(&options.root);
    let job = job(exhibit);
    let state = match status(&job, Some(&cache)) {
        How::Cached => "fresh: its result is in the cache".to_owned(),
        How::Computed(why) => format!("stale: {}", reason(&why)),
    };
    let mut text = format!(
        "{} is {state}\n\nkey {}\n{}\n",
        arguments.id,
        job.key.digest(),
        serde_json::to_string_pretty(&job.key).unwrap_or_default()
    );
    if let Some(old) = cache.latest(&arguments.id) {
        let differences = job.key.differences(&old);
        if !differences.is_empty() {
            text.push_str("\nwhat differs from the last run:\n");
        }
        for difference in differences {
            let _ = writeln!(text, "  {difference}");
        }
    }
    report::to_stdout(&text);
    Exit::Fine
}

/// Why a result would be computed, in words.
pub(super) fn reason(why: &Why) -> String {
    match why {
        Why::NoCache => "the cache is not used".to_owned(),
        Why::New => "it has not run yet".to_owned(),
        Why::Changed(difference) => format!("its key changed: {difference}"),
        Why::Gone => "its result is no longer in the cache".to_owned(),
        Why::Damaged => "its result in the cache is damaged".to_owned(),
    }
}
