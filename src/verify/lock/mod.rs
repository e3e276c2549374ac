//! The lock: the committed record of what each exhibit's experiment gave when it was last reviewed.
//!
//! It is text, sorted, one block for each exhibit, so that people can read it, compare it and merge it.

use std::collections::BTreeMap;

use crate::diag::{Code, Diagnostic, Place};
use crate::kinds::{Measured, Value, Values};
use crate::sources::Digest;

mod read;
mod write;

pub use write::written;

pub use crate::workspace::LOCK as FILE;

/// The version of the lock's format.
pub const FORMAT: i64 = 1;

/// If an exhibit has more values than this, its long series are recorded by their digest and a summary.
const MANY: usize = 64;
/// The least length of a long series. The values of a shorter one are no more to read than its summary, and tell more.
const SERIES: usize = 17;

/// The record of all exhibits.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Lock {
    /// What is recorded, by the exhibits' ids.
    pub records: BTreeMap<String, Record>,
}

/// The record of one exhibit.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// The kind of its experiment.
    pub kind: String,
    /// The chapter's file, from the course's root. Its line is not recorded: prose moves it.
    pub chapter: String,
    /// The digest of the result's key.
    pub key: Digest,
    /// The digest of the result.
    pub data: Digest,
    /// The digest of the drawing.
    pub drawing: Digest,
    /// The values in full.
    pub values: BTreeMap<String, Measured>,
    /// The long series of values: those whose names agree but for the number at their end.
    pub series: BTreeMap<String, Series>,
    /// Where the record stands, if it was read from a file.
    pub place: Option<Place>,
}

/// A long series of numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// How many there are.
    pub count: usize,
    /// The digest of all names and numbers.
    pub digest: Digest,
    /// The least number.
    pub minimum: f64,
    /// The greatest number.
    pub maximum: f64,
    /// The first, in the order of the numbers at the ends of the names.
    pub first: f64,
    /// The last.
    pub last: f64,
}

/// The warning or, for `verify`, the error that there is no lock.
pub fn absent() -> Diagnostic {
    Diagnostic::error(Code::Lock, format!("there is no lock: `{FILE}`")).help("`workbook accept` writes it")
}

/// Sorts `values` into those to be recorded in full and long series.
pub fn summarised(values: &Values) -> (BTreeMap<String, Measured>, BTreeMap<String, Series>) {
    let mut full: BTreeMap<String, Measured> =
        values.iter().map(|(name, measured)| (name.to_owned(), measured.clone())).collect();
    let mut found = BTreeMap::new();
    if full.len() <= MANY {
        return (full, found);
    }
    let mut families: BTreeMap<String, Vec<(u64, String, f64)>> = BTreeMap::new();
    for (name, measured) in &full {
        if let (Some((family, number)), Some(value)) = (ending(name), as_number(&measured.value)) {
            families.entry(family.to_owned()).or_default().push((number, name.clone(), value));
        }
    }
    for (family, mut members) in families.into_iter().filter(|(_, members)| members.len() >= SERIES) {
        members.sort_by(|a, b| (a.0, &a.1).cmp(&(b.0, &b.1)));
        let lines: Vec<String> = members
            .iter()
            .filter_map(|(_, name, _)| Some(format!("{name} = {}", written(&full.remove(name)?))))
            .collect();
        if let Some(series) = series(&members, &lines) {
            found.insert(family, series);
        }
    }
    (full, found)
}

/// The summary of the numbers of `members`, whose digest is that of `lines`.
fn series(members: &[(u64, String, f64)], lines: &[String]) -> Option<Series> {
    let numbers = || members.iter().map(|member| member.2);
    Some(Series {
        count: members.len(),
        digest: Digest::of_parts(lines.iter().map(String::as_bytes)),
        minimum: numbers().min_by(f64::total_cmp)?,
        maximum: numbers().max_by(f64::total_cmp)?,
        first: numbers().next()?,
        last: numbers().next_back()?,
    })
}

/// A name without the number at its end, and that number.
fn ending(name: &str) -> Option<(&str, u64)> {
    let (family, number) = name.rsplit_once('.')?;
    Some((family, number.parse().ok()?))
}

/// The value as a number, if it is one.
fn as_number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => Some(*number),
        Value::Integer(integer) => Some(*integer as f64),
        Value::Boolean(_) | Value::Text(_) => None,
    }
}

#[cfg(test)]
mod tests;
