//! Drift: where the book of now and the lock differ, told with old and new values.

use std::collections::{BTreeMap, BTreeSet};

use super::lock::{Lock, Record, Series, summarised, written};
use crate::diag::{Code, Diagnostic, Place, Severity};
use crate::kinds::{Measured, Value, Values};
use crate::sources::Digest;

/// How many changed values a diagnostic lists.
const LISTED: usize = 8;

/// What an exhibit of the book is now.
#[derive(Debug, Clone)]
pub struct Now {
    /// The exhibit.
    pub id: String,
    /// The kind of its experiment.
    pub kind: String,
    /// Where the chapter asks for it.
    pub place: Place,
    /// The digest of the result's key.
    pub key: Digest,
    /// The digest of the result.
    pub data: Digest,
    /// The digest of the drawing.
    pub drawing: Digest,
    /// The values of the result.
    pub values: Values,
}

impl Now {
    /// The record of it.
    pub fn record(&self) -> Record {
        let (values, series) = summarised(&self.values);
        Record {
            kind: self.kind.clone(),
            chapter: self.place.file.to_string(),
            key: self.key,
            data: self.data,
            drawing: self.drawing,
            values,
            series,
            place: None,
        }
    }
}

/// A value that differs, as people read it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    /// The name of the value.
    pub name: String,
    /// What the lock has, if anything.
    pub old: Option<String>,
    /// What the book has, if anything.
    pub new: Option<String>,
}

/// Where the book and the lock differ.
#[derive(Debug, Clone, PartialEq)]
pub enum Drift {
    /// The result differs.
    Data {
        /// The exhibit.
        id: String,
        /// Where the chapter asks for it.
        place: Place,
        /// Whether the key is that of the lock: then the same question had another answer.
        same_key: bool,
        /// The values that differ.
        changes: Vec<Change>,
    },
    /// The result is the same, but it is drawn differently.
    Drawing {
        /// The exhibit.
        id: String,
        /// Where the chapter asks for it.
        place: Place,
    },
    /// The lock has it, but the book does not.
    Missing {
        /// The exhibit.
        id: String,
        /// The chapter that had it.
        chapter: String,
        /// Where the lock has it.
        place: Option<Place>,
    },
    /// The book has it, but the lock does not.
    New {
        /// The exhibit.
        id: String,
        /// Where the chapter asks for it.
        place: Place,
    },
}

/// Every difference between `lock` and the exhibits of the book: first those of the book in its order, then those only in the lock.
///
/// Another key alone is no drift: code that is written differently and computes the same has not changed the book.
pub fn compare(lock: &Lock, now: &[Now]) -> Vec<Drift> {
    let mut found: Vec<Drift> = now.iter().filter_map(|now| drift(lock.records.get(&now.id), now)).collect();
    let ids: BTreeSet<&str> = now.iter().map(|now| now.id.as_str()).collect();
    for (id, record) in lock.records.iter().filter(|(id, _)| !ids.contains(id.as_str())) {
        found.push(Drift::Missing { id: id.clone(), chapter: record.chapter.clone(), place: record.place.clone() });
    }
    found
}

/// The lock after a review of the exhibits `ids`, or of all: theirs are recorded as they are now, and what is no longer in the book is forgotten.
///
/// `now` must be the whole book. Gives the ids that neither the book nor the lock knows, if there are any.
pub fn accept(lock: &Lock, now: &[Now], ids: Option<&BTreeSet<String>>) -> Result<Lock, Vec<String>> {
    let book: BTreeMap<&str, &Now> = now.iter().map(|now| (now.id.as_str(), now)).collect();
    let unknown: Vec<String> = ids
        .into_iter()
        .flatten()
        .filter(|id| !book.contains_key(id.as_str()) && !lock.records.contains_key(*id))
        .cloned()
        .collect();
    if !unknown.is_empty() {
        return Err(unknown);
    }
    let reviewed = |id: &str| ids.is_none_or(|ids| ids.contains(id));
    let mut records = lock.records.clone();
    records.retain(|id, _| !reviewed(id));
    records.extend(now.iter().filter(|now| reviewed(&now.id)).map(|now| (now.id.clone(), now.record())));
    Ok(Lock { records })
}

fn drift(old: Option<&Record>, now: &Now) -> Option<Drift> {
    let (id, place) = (now.id.clone(), now.place.clone());
    let Some(old) = old else { return Some(Drift::New { id, place }) };
    let changes = changes(old, &now.record());
    if old.data != now.data || !changes.is_empty() {
        return Some(Drift::Data { id, place, same_key: old.key == now.key, changes });
    }
    (old.drawing != now.drawing).then_some(Drift::Drawing { id, place })
}

/// The values that differ, in the order of their names; then the series that do.
fn changes(old: &Record, new: &Record) -> Vec<Change> {
    let mut found = Vec::new();
    for name in union(&old.values, &new.values) {
        let (before, after) = (old.values.get(name), new.values.get(name));
        if before.map(written) != after.map(written) {
            found.push(Change { name: name.to_owned(), old: before.map(shown), new: after.map(shown) });
        }
    }
    for name in union(&old.series, &new.series) {
        let (before, after) = (old.series.get(name), new.series.get(name));
        let fields = |series: Option<&Series>| series.map(Series::fields).map(BTreeMap::from).unwrap_or_default();
        let (before, after) = (fields(before), fields(after));
        for field in ["count", "minimum", "maximum", "first", "last", "digest"] {
            if before.get(field) != after.get(field) {
                let name = format!("{name}.* ({field})");
                found.push(Change { name, old: before.get(field).cloned(), new: after.get(field).cloned() });
            }
        }
    }
    found
}

/// The names of two maps, sorted, each once.
fn union<'a, T>(old: &'a BTreeMap<String, T>, new: &'a BTreeMap<String, T>) -> BTreeSet<&'a str> {
    old.keys().chain(new.keys()).map(String::as_str).collect()
}

/// A value as people read it: in full precision, with its standard error.
fn shown(measured: &Measured) -> String {
    let plain = |value: Value| written(&Measured { value, standard_error: None });
    let value = plain(measured.value.clone());
    match measured.standard_error {
        Some(error) => format!("{value} ± {}", plain(Value::Number(error))),
        None => value,
    }
}

impl Drift {
    /// The exhibit.
    pub fn id(&self) -> &str {
        match self {
            Self::Data { id, .. } | Self::Drawing { id, .. } | Self::Missing { id, .. } | Self::New { id, .. } => id,
        }
    }

    /// What to tell people: an error for `verify`, a warning for `build`.
    pub fn diagnostic(&self, severity: Severity) -> Diagnostic {
        let told = |message: String| Diagnostic { severity, ..Diagnostic::error(Code::Drift, message) };
        let accept = format!("review it, then `workbook accept {}`", self.id());
        let diagnostic = match self {
            Self::Data { id, place, same_key, changes } => {
                let count = match changes.len() {
                    0 => "none of its values did".to_owned(),
                    1 => "1 value did".to_owned(),
                    many => format!("{many} values did"),
                };
                let mut diagnostic =
                    told(format!("the data of `{id}` changed since the lock; {count}")).at_place(place);
                diagnostic.help = listed(changes);
                diagnostic.help_if(same_key.then(|| SAME_KEY.to_owned()))
            }
            Self::Drawing { id, place } => {
                told(format!("the drawing of `{id}` changed since the lock; its data did not")).at_place(place)
            }
            Self::New { id, place } => told(format!("`{id}` is in the book, but not in the lock")).at_place(place),
            Self::Missing { id, chapter, place } => {
                let message = format!("`{id}` is in the lock, but no longer in the book; `{chapter}` had it");
                Diagnostic { place: place.clone(), ..told(message) }
            }
        };
        diagnostic.help(accept)
    }
}

/// What a changed result with an unchanged key means.
const SAME_KEY: &str = "the key is that of the lock: the same code and parameters gave something else here";

/// The changes, one a line, and how many more there are.
fn listed(changes: &[Change]) -> Vec<String> {
    let shown = |value: &Option<String>| value.clone().unwrap_or_else(|| "absent".to_owned());
    let line = |change: &Change| format!("{}: {} -> {}", change.name, shown(&change.old), shown(&change.new));
    let mut lines: Vec<String> = changes.iter().take(LISTED).map(line).collect();
    if changes.len() > LISTED {
        lines.push(format!("and {} more", changes.len() - LISTED));
    }
    lines
}
