//! What git knows of the course: asked only where the course's settings want it, and never needed.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};

use super::CHAPTERS;
use crate::diag::{Code, Diagnostic};

/// What git knows of the course.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct History {
    /// The commit that is checked out.
    pub commit: Option<String>,
    /// The day of the last change of each file, as `2024-05-31`, by its path from the course's root.
    pub changed: BTreeMap<String, String>,
}

/// Asks git for the `commit`, and for the days of the last `changes`. Where it has no answer, that is told, and the book is built without.
pub fn ask(root: &Path, commit: bool, changes: bool) -> (History, Vec<Diagnostic>) {
    let mut history = History::default();
    let mut diagnostics = Vec::new();
    if commit {
        match git(root, &["rev-parse", "HEAD"]) {
            Ok(hash) => history.commit = Some(hash.trim().to_owned()),
            Err(why) => diagnostics.push(silent("which commit this is", "the pages have no links to code", &why)),
        }
    }
    if changes {
        let log = ["-c", "core.quotepath=off", "log", "--format=@%cs", "--name-only", "--relative", "--", CHAPTERS];
        match git(root, &log) {
            Ok(log) => history.changed = days(&log),
            Err(why) => diagnostics.push(silent("when chapters changed", "the pages do not tell it", &why)),
        }
    }
    (history, diagnostics)
}

/// The first day at which each file stands in a log, which begins with the latest.
fn days(log: &str) -> BTreeMap<String, String> {
    let mut days = BTreeMap::new();
    let mut day = "";
    for line in log.lines().filter(|line| !line.is_empty()) {
        match line.strip_prefix('@') {
            Some(next) => day = next,
            None => drop(days.entry(line.to_owned()).or_insert_with(|| day.to_owned())),
        }
    }
    days
}

/// What git answers, or why it does not.
fn git(root: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new("git")
        .arg("-C")
        .arg(root)
        .arg("--no-optional-locks")
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .map_err(|error| error.to_string())?;
    if output.status.success() {
        return String::from_utf8(output.stdout).map_err(|error| error.to_string());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(said.lines().next().unwrap_or("it said nothing").to_owned())
}

fn silent(what: &str, effect: &str, why: &str) -> Diagnostic {
    Diagnostic::warning(Code::History, format!("git cannot tell {what}: {why}"))
        .help(format!("{effect}; build in a clone with its history, or remove the setting from `[repository]`"))
}

#[cfg(test)]
mod tests {
    use super::days;

    #[test]
    fn the_latest_day_of_a_file_counts() {
        let log = "@2024-05-31\n\nchapters/a.md\n@2023-01-02\n\nchapters/a.md\nchapters/b c.md\n";
        let days = days(log);
        let pairs: Vec<(&str, &str)> = days.iter().map(|(file, day)| (file.as_str(), day.as_str())).collect();
        assert_eq!(pairs, [("chapters/a.md", "2024-05-31"), ("chapters/b c.md", "2023-01-02")]);
    }
}
