//! Where the time went: per stage and per experiment.

use std::time::Duration;

use super::Options;
use super::report::say;
use crate::run::{How, Ran};

/// Tells how long each stage and each experiment that ran took, if the options ask for it.
pub(super) fn tell(stages: &[(&'static str, Duration)], ran: &[Ran], options: &Options) {
    if !options.timings {
        return;
    }
    for (stage, time) in stages {
        say(&format!("{:>9.2} ms  {stage}", milliseconds(*time)), options);
    }
    let mut slowest: Vec<&Ran> = ran.iter().collect();
    slowest.sort_by_key(|ran| std::cmp::Reverse(ran.time));
    for ran in slowest {
        let how = if ran.how == How::Cached { "from the cache" } else { "ran" };
        say(&format!("{:>9.2} ms    {} ({how})", milliseconds(ran.time), ran.ids.join(", ")), options);
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
