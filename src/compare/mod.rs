//! Two books: which exhibits differ, in their numbers, their claims, their pictures and their places.
//!
//! What is compared is what the books hold, `figures.json` and the files that it names. A key that changed alone changes nothing: other code
//! that gives the same is no difference.

mod pictures;
mod record;
mod rows;
mod summary;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::diag::{Code, Diagnostic};
use crate::render::FIGURES;
use pictures::Picture;
use record::{Figures, Record};
use rows::{Row, Stated};

/// A book that is compared.
#[derive(Debug, Clone, Default)]
pub struct Side {
    /// How it is called: a folder or a revision.
    pub name: String,
    /// Its files.
    pub files: BTreeMap<String, Vec<u8>>,
}

/// How two books differ.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// How the old book is called.
    pub old: String,
    /// How the new book is called.
    pub new: String,
    /// How many exhibits the old book has.
    pub old_count: usize,
    /// How many exhibits the new book has.
    pub new_count: usize,
    /// What differs in exhibits that both books have, in the order of the new one.
    pub changed: Vec<Change>,
    /// What only the new book has.
    pub added: Vec<Brief>,
    /// What only the old book has.
    pub removed: Vec<Brief>,
    /// What has another number or stands in another chapter.
    pub moved: Vec<Moved>,
}

/// An exhibit that is named.
#[derive(Debug, Clone, Serialize)]
pub struct Brief {
    /// Its id.
    pub id: String,
    /// Its name, such as `Figure 2.3`.
    pub name: String,
    /// Where it is written.
    pub place: String,
    /// Its drawings, in the book that has it.
    pub pictures: Vec<Picture>,
    /// How many more drawings it has.
    pub more: usize,
}

/// An exhibit that has another number or stands elsewhere.
#[derive(Debug, Clone, Serialize)]
pub struct Moved {
    /// Its id.
    pub id: String,
    /// Its name and chapter in the old book.
    pub old: String,
    /// Its name and chapter in the new one.
    pub new: String,
}

/// An exhibit that differs.
#[derive(Debug, Clone, Serialize)]
pub struct Change {
    /// The exhibit in the new book.
    #[serde(flatten)]
    pub brief: Brief,
    /// What differs of it, in words.
    pub what: Vec<String>,
    /// Its kind, parameters and seed, where they differ.
    pub parameters: Vec<Row>,
    /// Its values, where they differ.
    pub values: Vec<Row>,
    /// What is claimed of it, where that or its verdict differs.
    pub claims: Vec<Stated>,
    /// Files of its data that differ.
    pub data: Vec<String>,
}

impl Report {
    /// Whether the books have the same exhibits, each with the same numbers, claims and pictures in the same place.
    pub fn is_empty(&self) -> bool {
        self.changed.is_empty() && self.added.is_empty() && self.removed.is_empty() && self.moved.is_empty()
    }

    /// It in a few lines of markdown.
    pub fn summary(&self) -> String {
        summary::markdown(self)
    }
}

/// Compares two books.
///
/// # Errors
/// If one of them has no list of exhibits that can be read.
pub fn compare(old: &Side, new: &Side) -> Result<Report, Diagnostic> {
    let (before, after) = (figures(old)?, figures(new)?);
    let of = |records: &Figures, id: &str| records.exhibits.iter().position(|record| record.id == id);
    let mut report = Report {
        old: old.name.clone(),
        new: new.name.clone(),
        old_count: before.exhibits.len(),
        new_count: after.exhibits.len(),
        changed: Vec::new(),
        added: Vec::new(),
        removed: Vec::new(),
        moved: Vec::new(),
    };
    for record in &after.exhibits {
        let Some(at) = of(&before, &record.id) else {
            report.added.push(brief(record, new, true));
            continue;
        };
        let was = &before.exhibits[at];
        report.changed.extend(change((was, old), (record, new)));
        if (&was.number, &was.chapter) != (&record.number, &record.chapter) {
            let place = |record: &Record| format!("{} in {}", record.name(), record.chapter);
            report.moved.push(Moved { id: record.id.clone(), old: place(was), new: place(record) });
        }
    }
    let gone = before.exhibits.iter().filter(|record| of(&after, &record.id).is_none());
    report.removed = gone.map(|record| brief(record, old, false)).collect();
    Ok(report)
}

/// The exhibits of a book.
fn figures(side: &Side) -> Result<Figures, Diagnostic> {
    let bad = |why: &str| {
        Diagnostic::error(Code::NotABook, format!("`{}` is no book that can be compared: {why}", side.name))
            .help(format!("a book has `{FIGURES}`; `workbook build` makes it"))
    };
    let bytes = side.files.get(FIGURES).ok_or_else(|| bad(&format!("it has no `{FIGURES}`")))?;
    serde_json::from_slice(bytes).map_err(|error| bad(&format!("`{FIGURES}` cannot be read: {error}")))
}

/// An exhibit that only `side` has, which is the new book or the old.
fn brief(record: &Record, side: &Side, new: bool) -> Brief {
    let (pictures, more) = pictures::of_one(record, side, new);
    Brief { id: record.id.clone(), name: record.name(), place: record.place.clone(), pictures, more }
}

/// What differs of an exhibit that both books have, if anything does.
fn change((was, old): (&Record, &Side), (is, new): (&Record, &Side)) -> Option<Change> {
    let parameters = rows::parameters(was, is);
    let values = rows::values(&was.values, &is.values);
    let claims = rows::claims(&was.claims, &is.claims);
    let (pictures, more) = pictures::differing_of((was, old), (is, new));
    let data: Vec<String> = differing(was, is, old, new, &["csv"]);
    let mut what = Vec::new();
    let count = |count: usize, one: &str, several: &str| match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        many => Some(format!("{many} {several}")),
    };
    let verdicts = claims.iter().filter(|stated| stated.verdict_changed).count();
    what.extend(count(verdicts, "verdict", "verdicts"));
    what.extend(count(claims.len() - verdicts, "claim", "claims"));
    what.extend(count(values.len(), "value", "values"));
    what.extend(count(parameters.len(), "parameter", "parameters"));
    what.extend(count(pictures.len() + more, "drawing", "drawings"));
    if values.is_empty() {
        what.extend(count(data.len(), "file of data", "files of data"));
    }
    let brief = Brief { id: is.id.clone(), name: is.name(), place: is.place.clone(), pictures, more };
    (!what.is_empty()).then_some(Change { brief, what, parameters, values, claims, data })
}

/// The files of an exhibit with one of these endings that are not in both books the same.
fn differing(was: &Record, is: &Record, old: &Side, new: &Side, endings: &[&str]) -> Vec<String> {
    let mut paths: Vec<&String> = was.files.iter().chain(&is.files).collect();
    paths.sort();
    paths.dedup();
    let ends = |path: &str| crate::workspace::extension(path).is_some_and(|ending| endings.contains(&ending));
    let differs = |path: &&String| ends(path) && old.files.get(*path) != new.files.get(*path);
    paths.into_iter().filter(differs).cloned().collect()
}
