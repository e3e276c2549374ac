//! Writing the lock: the same record gives the same text.

use std::fmt::Write as _;

use super::{FORMAT, Lock, Record, Series};
use crate::kinds::{Measured, Value};

/// What the file begins with.
const HEAD: &str = "\
# What the experiments of this book gave when they were last reviewed.
# `workbook verify` compares the book with it; `workbook accept` rewrites it.
";

impl Lock {
    /// The text of the lock.
    pub fn text(&self) -> String {
        let mut text = format!("{HEAD}format = {FORMAT}\n");
        for (id, record) in &self.records {
            record.write(&key(id), &mut text);
        }
        text
    }
}

impl Record {
    /// Writes the block of the exhibit with the quoted id `id`.
    fn write(&self, id: &str, text: &mut String) {
        let fields = [
            ("kind", quoted(&self.kind)),
            ("chapter", quoted(&self.chapter)),
            ("key", quoted(&self.key.to_string())),
            ("data", quoted(&self.data.to_string())),
            ("drawing", quoted(&self.drawing.to_string())),
        ];
        table(&format!("exhibit.{id}"), &fields, text);
        let mut values: Vec<(&str, String)> =
            self.values.iter().map(|(name, measured)| (name.as_str(), written(measured))).collect();
        values.sort_by_cached_key(|(name, _)| natural(name));
        if !values.is_empty() {
            table(&format!("exhibit.{id}.values"), &values, text);
        }
        for (name, series) in &self.series {
            table(&format!("exhibit.{id}.series.{}", key(name)), &series.fields(), text);
        }
    }
}

impl Series {
    /// The fields by name, as written.
    pub fn fields(&self) -> [(&'static str, String); 6] {
        [
            ("count", self.count.to_string()),
            ("digest", quoted(&self.digest.to_string())),
            ("minimum", float(self.minimum)),
            ("maximum", float(self.maximum)),
            ("first", float(self.first)),
            ("last", float(self.last)),
        ]
    }
}

/// Writes a table with its fields.
fn table(name: &str, fields: &[(&str, String)], text: &mut String) {
    let _ = writeln!(text, "\n[{name}]");
    for (name, value) in fields {
        let _ = writeln!(text, "{} = {value}", key(name));
    }
}

/// A value as the lock writes it, in full precision. Two values are the same if they are written alike.
pub fn written(measured: &Measured) -> String {
    let value = match &measured.value {
        Value::Boolean(holds) => holds.to_string(),
        Value::Integer(integer) => integer.to_string(),
        Value::Number(number) => float(*number),
        Value::Text(text) => quoted(text),
    };
    match measured.standard_error {
        Some(error) => format!("{{ value = {value}, error = {} }}", float(error)),
        None => value,
    }
}

/// The shortest text that gives back the very number.
fn float(number: f64) -> String {
    if number.is_nan() { "nan".to_owned() } else { format!("{number:?}") }
}

/// A text between quotes, as TOML has it.
fn quoted(text: &str) -> String {
    // JSON's escapes are TOML's, but for one character that JSON leaves as it is.
    serde_json::Value::from(text).to_string().replace('\u{7f}', "\\u007F")
}

/// A name, between quotes if it must be.
fn key(name: &str) -> String {
    let bare = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'-' || byte == b'_';
    if !name.is_empty() && name.bytes().all(bare) { name.to_owned() } else { quoted(name) }
}

/// An order of names in which 2 stands before 10.
fn natural(name: &str) -> Vec<(u64, String)> {
    let number = |part: &str| part.parse().unwrap_or(u64::MAX);
    name.split('.').map(|part| (number(part), part.to_owned())).collect()
}
