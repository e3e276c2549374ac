//! Where the time went: per stage and per experiment.

use std::time::Duration;

use serde_json::{Value as Json, json};

use super::report::{say, to_stdout};
use super::{Format, Options};
use crate::run::{How, Ran};

/// Tells how long each stage and each experiment that ran took, if the options ask for it.
pub(super) fn tell(stages: &[(&'static str, Duration)], ran: &[Ran], options: &Options) {
    if !options.timings {
        return;
    }
    let mut slowest: Vec<&Ran> = ran.iter().collect();
    slowest.sort_by_key(|ran| std::cmp::Reverse(ran.time));
    if options.format == Format::Json {
        return to_stdout(&format!("{}\n", machine(stages, &slowest)));
    }
    for (stage, time) in stages {
        say(&format!("{:>9.2} ms  {stage}", milliseconds(*time)), options);
    }
    for ran in slowest {
        let how = if ran.how == How::Cached { "from the cache" } else { "ran" };
        say(&format!("{:>9.2} ms    {} ({how})", milliseconds(ran.time), ran.ids.join(", ")), options);
    }
}

/// The same as an object on one line, as diagnostics are.
fn machine(stages: &[(&'static str, Duration)], slowest: &[&Ran]) -> Json {
    let stages = stages.iter().map(|(stage, time)| json!({ "stage": stage, "milliseconds": milliseconds(*time) }));
    let experiments = slowest.iter().map(
        |ran| json!({ "exhibits": ran.ids, "milliseconds": milliseconds(ran.time), "cached": ran.how == How::Cached }),
    );
    json!({ "timings": { "stages": stages.collect::<Vec<_>>(), "experiments": experiments.collect::<Vec<_>>() } })
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
