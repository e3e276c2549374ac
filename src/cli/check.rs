//! `workbook check`: every mistake that can be known without running.

use super::{Exit, Options, Readers, report, timings};
use crate::compose::Request;
use crate::{compose, render};

pub(super) fn run(readers: &Readers, options: &Options) -> Exit {
    let request = Request { audience: readers.audience, ..options.request() };
    let mut planned = compose::check(&request);
    planned.diagnostics.extend(render::check(&planned.course, &planned.plan, &planned.workspace));
    report::diagnostics(&planned.diagnostics, &planned.workspace, options);
    timings::tell(&planned.timings, &[], options);
    let exit = Exit::of(&planned.diagnostics);
    if exit == Exit::Fine {
        let exhibits = planned.plan.exhibits.len();
        report::say(
            &format!(
                "well written: {}, {}",
                report::counted(planned.course.chapters.len(), "chapter"),
                report::counted(exhibits, "exhibit")
            ),
            options,
        );
    }
    exit
}
