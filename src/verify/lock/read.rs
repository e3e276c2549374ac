//! Reading the lock, strictly: what was not written by `workbook accept`, or merged well, is refused with its place.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{FILE, FORMAT, Lock, Record, Series};
use crate::diag::{Code, Diagnostic, Place};
use crate::kinds::{Measured, Value};
use crate::sources::Digest;

impl Lock {
    /// Reads the text of a lock, or tells everything that is wrong with it.
    pub fn read(text: &str) -> Result<Self, Vec<Diagnostic>> {
        let mut reader = Reader { file: Arc::from(FILE), complaints: Vec::new() };
        let (table, errors) = DeTable::parse_recoverable(text);
        for error in errors {
            let place = error.span().unwrap_or(0..0);
            reader.complain(place, format!("the lock is not TOML: {}", error.message()));
        }
        let records = if reader.complaints.is_empty() { reader.lock(&table) } else { BTreeMap::new() };
        if reader.complaints.is_empty() { Ok(Self { records }) } else { Err(reader.complaints) }
    }
}

type Item<'t, 'a> = &'t Spanned<DeValue<'a>>;

/// Reads values and gathers complaints.
struct Reader {
    file: Arc<str>,
    complaints: Vec<Diagnostic>,
}

impl Reader {
    fn complain(&mut self, place: Range<usize>, message: impl Into<String>) {
        let complaint = Diagnostic::error(Code::Lock, message).at(&self.file, place);
        self.complaints
            .push(complaint.help("restore it from version control, or review the book and run `workbook accept`"));
    }

    /// The whole file.
    fn lock(&mut self, table: &Spanned<DeTable<'_>>) -> BTreeMap<String, Record> {
        self.known(table.get_ref(), &["format", "exhibit"]);
        let format = self.field(table.get_ref(), table.span(), "format", integer);
        if let Some(format) = format.filter(|&format| format != FORMAT) {
            let message = format!("the lock has format {format}; this program knows format {FORMAT}");
            self.complain(table.get_ref().get("format").map_or(table.span(), Spanned::span), message);
        }
        let mut records = BTreeMap::new();
        for (id, place, exhibit) in self.tables(table.get_ref(), "exhibit") {
            if let Some(record) = self.record(exhibit, place) {
                records.insert(id, record);
            }
        }
        records
    }

    /// The block of one exhibit, whose id stands at `place`.
    fn record(&mut self, table: &DeTable<'_>, place: Range<usize>) -> Option<Record> {
        self.known(table, &["kind", "chapter", "key", "data", "drawing", "values", "series"]);
        let kind = self.field(table, place.clone(), "kind", text);
        let chapter = self.field(table, place.clone(), "chapter", text);
        let [key, data, drawing] =
            ["key", "data", "drawing"].map(|name| self.field(table, place.clone(), name, digest));
        let values = self.values(table);
        let series = self.tables(table, "series").into_iter();
        let series: BTreeMap<String, Series> =
            series.filter_map(|(name, place, table)| Some((name, self.series(table, place)?))).collect();
        let place = Some(Place { file: Arc::clone(&self.file), range: place });
        Some(Record {
            kind: kind?,
            chapter: chapter?,
            key: key?,
            data: data?,
            drawing: drawing?,
            values,
            series,
            place,
        })
    }

    /// The values of an exhibit.
    fn values(&mut self, table: &DeTable<'_>) -> BTreeMap<String, Measured> {
        let Some(values) = table.get("values") else { return BTreeMap::new() };
        let Some(fields) = values.get_ref().as_table() else {
            self.complain(values.span(), "`values` must be a table");
            return BTreeMap::new();
        };
        let read = fields.iter().filter_map(|(name, value)| {
            let measured = self.measured(value);
            if measured.is_none() {
                self.complain(value.span(), format!("`{}` is no value", name.get_ref()));
            }
            Some((name.get_ref().clone().into_owned(), measured?))
        });
        read.collect()
    }

    /// A value, or a table of a value and its standard error.
    fn measured(&mut self, value: Item<'_, '_>) -> Option<Measured> {
        let Some(fields) = value.get_ref().as_table() else {
            return Some(Measured { value: plain(value)?, standard_error: None });
        };
        self.known(fields, &["value", "error"]);
        Some(Measured { value: plain(fields.get("value")?)?, standard_error: Some(float(fields.get("error")?)?) })
    }

    /// The summary of a long series.
    fn series(&mut self, table: &DeTable<'_>, place: Range<usize>) -> Option<Series> {
        self.known(table, &["count", "digest", "minimum", "maximum", "first", "last"]);
        let count = self.field(table, place.clone(), "count", |item| usize::try_from(integer(item)?).ok());
        let digest = self.field(table, place.clone(), "digest", digest);
        let [minimum, maximum, first, last] =
            ["minimum", "maximum", "first", "last"].map(|name| self.field(table, place.clone(), name, float));
        Some(Series {
            count: count?,
            digest: digest?,
            minimum: minimum?,
            maximum: maximum?,
            first: first?,
            last: last?,
        })
    }

    /// The tables in the table `name`, each with its name and the place of that.
    fn tables<'t, 'a>(&mut self, table: &'t DeTable<'a>, name: &str) -> Vec<(String, Range<usize>, &'t DeTable<'a>)> {
        let Some(value) = table.get(name) else { return Vec::new() };
        let Some(fields) = value.get_ref().as_table() else {
            self.complain(value.span(), format!("`{name}` must be a table"));
            return Vec::new();
        };
        let mut found = Vec::new();
        for (name, value) in fields {
            match value.get_ref().as_table() {
                Some(table) => found.push((name.get_ref().clone().into_owned(), name.span(), table)),
                None => self.complain(value.span(), format!("`{}` must be a table", name.get_ref())),
            }
        }
        found
    }

    /// The field `name` as `read` reads it; complains if it is missing or cannot be read.
    fn field<T>(
        &mut self,
        table: &DeTable<'_>,
        place: Range<usize>,
        name: &str,
        read: impl Fn(Item<'_, '_>) -> Option<T>,
    ) -> Option<T> {
        let Some(value) = table.get(name) else {
            self.complain(place, format!("`{name}` is missing"));
            return None;
        };
        let found = read(value);
        if found.is_none() {
            self.complain(value.span(), format!("`{name}` cannot be read"));
        }
        found
    }

    /// Complains of every key of `table` that is not one of `names`.
    fn known(&mut self, table: &DeTable<'_>, names: &[&str]) {
        for name in table.keys().filter(|name| !names.contains(&name.get_ref().as_ref())) {
            self.complain(name.span(), format!("the lock has no key `{}`", name.get_ref()));
        }
    }
}

fn text(item: Item<'_, '_>) -> Option<String> {
    item.get_ref().as_str().map(str::to_owned)
}

fn digest(item: Item<'_, '_>) -> Option<Digest> {
    Digest::parse(item.get_ref().as_str()?)
}

fn integer(item: Item<'_, '_>) -> Option<i64> {
    let integer = item.get_ref().as_integer()?;
    i64::from_str_radix(integer.as_str(), integer.radix()).ok()
}

fn float(item: Item<'_, '_>) -> Option<f64> {
    item.get_ref().as_float()?.as_str().parse().ok()
}

fn plain(item: Item<'_, '_>) -> Option<Value> {
    match item.get_ref() {
        DeValue::Boolean(holds) => Some(Value::Boolean(*holds)),
        DeValue::Integer(_) => integer(item).map(Value::Integer),
        DeValue::Float(_) => float(item).map(Value::Number),
        DeValue::String(text) => Some(Value::Text(text.clone().into_owned())),
        _ => None,
    }
}
