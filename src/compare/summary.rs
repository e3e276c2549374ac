//! A comparison in a few lines, for a terminal and for the summary of a workflow.

use std::fmt::Write as _;

use super::{Brief, Report};

/// The most exhibits that a list names.
const MOST: usize = 40;

/// The comparison in markdown that reads well as it is.
pub(super) fn markdown(report: &Report) -> String {
    if report.is_empty() {
        return format!("The {} exhibits of {} are those of {}.\n", report.new_count, report.new, report.old);
    }
    let mut text = format!("Exhibits of {} and of {}: ", report.old, report.new);
    let counts = [
        (report.changed.len(), "changed"),
        (report.added.len(), "added"),
        (report.removed.len(), "removed"),
        (report.moved.len(), "with another number or chapter"),
    ];
    let parts = counts.iter().filter(|(count, _)| *count > 0).map(|(count, word)| format!("{count} {word}"));
    let _ = writeln!(text, "{}.", parts.collect::<Vec<_>>().join(", "));
    let changed = report.changed.iter().map(|change| (&change.brief, change.what.join(", ")));
    list(&mut text, "Changed", changed.collect());
    list(&mut text, "Added", report.added.iter().map(|brief| (brief, String::new())).collect());
    list(&mut text, "Removed", report.removed.iter().map(|brief| (brief, String::new())).collect());
    text
}

fn list(text: &mut String, head: &str, entries: Vec<(&Brief, String)>) {
    if entries.is_empty() {
        return;
    }
    let _ = writeln!(text, "\n{head}:\n");
    let more = entries.len().saturating_sub(MOST);
    for (brief, what) in entries.into_iter().take(MOST) {
        let what = if what.is_empty() { String::new() } else { format!(": {what}") };
        let _ = writeln!(text, "- `{}` ({}, {}){what}", brief.id, brief.name, brief.place);
    }
    if more > 0 {
        let _ = writeln!(text, "- and {more} more");
    }
}
