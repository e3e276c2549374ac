//! The news that open pages are told: what is wrong with the course, and what is still to come.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::{Value, json};

use super::Teller;
use crate::diag::{Diagnostic, Severity};
use crate::workspace::{CHAPTERS, TEMPLATES, Workspace};

/// The most mistakes, and the most warnings, that a page is told in full.
const MOST: usize = 30;

/// Where mistakes are mended.
pub(super) struct Editor {
    /// The course's folder.
    pub root: String,
    /// What a place links to.
    pub pattern: String,
}

impl Editor {
    /// The links to places in the course at `root`.
    pub fn new(root: &Path, pattern: &str) -> Self {
        let root = root.canonicalize().unwrap_or_else(|_| root.to_path_buf());
        Self { root: root.to_string_lossy().into_owned(), pattern: pattern.to_owned() }
    }

    /// The link to a place in a file of the course.
    fn link(&self, file: &str, (line, column): (usize, usize)) -> String {
        let path = encoded(&format!("{}/{file}", self.root));
        // Absolute paths begin with a stroke where they begin with one; it stands in some patterns already.
        let pattern = self.pattern.replace("/{path}", &format!("/{}", path.trim_start_matches('/')));
        let pattern = pattern.replace("{path}", &path);
        pattern.replace("{line}", &line.to_string()).replace("{column}", &column.to_string())
    }
}

/// A path as part of an address.
fn encoded(path: &str) -> String {
    let mut out = String::with_capacity(path.len());
    for byte in path.replace(std::path::MAIN_SEPARATOR, "/").bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'/' | b':' => {
                out.push(char::from(byte));
            }
            byte => drop(write!(out, "%{byte:02X}")),
        }
    }
    out
}

/// What the news are of.
pub(super) struct State<'a> {
    pub found: &'a [Diagnostic],
    pub workspace: &'a Workspace,
    /// The exhibits that are being computed.
    pub stale: &'a [String],
}

/// The news as JSON.
pub(super) fn text(state: &State<'_>, teller: &dyn Teller, editor: &Editor) -> String {
    let of = |severity: Severity| {
        let mut of: Vec<&Diagnostic> = state.found.iter().filter(|found| found.severity == severity).collect();
        of.sort_by_key(|found| found.place.as_ref().map(|place| (place.file.clone(), place.range.start)));
        of
    };
    let (errors, warnings) = (of(Severity::Error), of(Severity::Warning));
    let told = |found: &[&Diagnostic]| -> Vec<Value> {
        found.iter().take(MOST).map(|found| one(found, state.workspace, teller, editor)).collect()
    };
    json!({
        "errors": told(&errors),
        "error_count": errors.len(),
        "warnings": told(&warnings),
        "warning_count": warnings.len(),
        "stale": state.stale,
    })
    .to_string()
}

fn one(found: &Diagnostic, workspace: &Workspace, teller: &dyn Teller, editor: &Editor) -> Value {
    let place = found.place.as_ref().map(|place| {
        let position = teller.position(place, workspace);
        // What code wrote has no file.
        let is_file = place.file.starts_with(CHAPTERS) || place.file.starts_with(TEMPLATES);
        let link = is_file.then(|| editor.link(&place.file, position));
        json!({ "text": format!("{}:{}:{}", place.file, position.0, position.1), "link": link })
    });
    // There may be many warnings, and nobody has asked to see them yet: they come without an excerpt.
    let text = match found.severity {
        Severity::Error => teller.text(found, workspace),
        Severity::Warning => [std::slice::from_ref(&found.message), &found.help].concat().join("\n"),
    };
    json!({ "code": found.code.id(), "message": found.message, "text": text, "place": place })
}

#[cfg(test)]
mod tests {
    use super::Editor;

    #[test]
    fn places_link_to_the_editor() {
        let editor = Editor { root: "/a course".into(), pattern: "vscode://file/{path}:{line}:{column}".into() };
        assert_eq!(editor.link("chapters/é.md", (3, 9)), "vscode://file/a%20course/chapters/%C3%A9.md:3:9");
        let editor = Editor { pattern: "idea://open?file={path}&line={line}".into(), ..editor };
        assert_eq!(editor.link("chapters/a.md", (3, 9)), "idea://open?file=/a%20course/chapters/a.md&line=3");
    }
}
