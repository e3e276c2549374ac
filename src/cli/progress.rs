//! How a run goes: a bar on a terminal, plain lines elsewhere.

use std::io::{IsTerminal, stderr};
use std::sync::atomic::{AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::Options;
use super::report::say;
use crate::run::{How, Job, Observer, Ran};

/// Shows how a run goes.
pub(super) struct Progress<'a> {
    options: &'a Options,
    bar: Option<ProgressBar>,
    due: AtomicUsize,
    done: AtomicUsize,
}

impl<'a> Progress<'a> {
    /// Nothing is shown where the options ask for quiet.
    pub(super) fn new(options: &'a Options) -> Self {
        let bar = (!options.quiet && stderr().is_terminal()).then(|| {
            let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr());
            if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} experiments  {wide_msg}") {
                bar.set_style(style);
            }
            bar
        });
        Self { options, bar, due: AtomicUsize::new(0), done: AtomicUsize::new(0) }
    }
}

impl Observer for Progress<'_> {
    fn planned(&self, _: usize, due: usize) {
        self.due.store(due, Ordering::Relaxed);
        if let Some(bar) = &self.bar {
            bar.set_length(due as u64);
        }
    }

    fn started(&self, job: &Job) {
        if let Some(bar) = &self.bar {
            bar.set_message(names(&job.ids));
        }
    }

    fn finished(&self, ran: &Ran) {
        if ran.how == How::Cached {
            return;
        }
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        let due = self.due.load(Ordering::Relaxed);
        match &self.bar {
            Some(bar) => bar.inc(1),
            None => say(&format!("ran {} ({done} of {due}, {:.0?})", names(&ran.ids), ran.time), self.options),
        }
        if done == due
            && let Some(bar) = &self.bar
        {
            bar.finish_and_clear();
        }
    }
}

/// The exhibits that show an experiment, in words.
fn names(ids: &[String]) -> String {
    if ids.is_empty() { "the changed experiment".to_owned() } else { ids.join(", ") }
}
