//! The data and the drawing of an exhibit as files: CSV and JSON, SVG and PNG.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::{Serialize, Serializer};
use serde_json::{Map, Value as Json, json};

use super::machine::number;
use crate::chart::{Drawing, Figure};
use crate::kinds::{Entries, Frame, Outcome};
use crate::parse::Chapter;
use crate::plan::Exhibit;

/// The folder of the book that holds the exhibits' files.
pub(crate) const FOLDER: &str = "exhibits";

/// A file of an exhibit.
pub(crate) struct File {
    /// Its path in the book.
    pub path: String,
    /// What a reader is told that it is: `CSV`, or `CSV of slopes` if there are several.
    pub label: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// Which files of an exhibit a book keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Keep {
    /// All.
    All,
    /// Of the exhibit that stands for a page of the catalogue: its drawing, and data that are short.
    Picture,
    /// Of the others there: data that are short. `workbook run ID --format` writes the rest.
    Data,
}

/// The longest data, in bytes, that a page of the catalogue keeps as a file.
const SHORT: usize = 24_000;

impl Keep {
    /// What the exhibit `id` of a chapter keeps.
    pub(crate) fn of(chapter: &Chapter, id: &str) -> Self {
        match &chapter.front.picture {
            _ if chapter.shelf.is_none() => Self::All,
            Some(picture) if picture.id == id => Self::Picture,
            _ => Self::Data,
        }
    }
}

/// Every file of an exhibit that the book keeps: its data first, then its drawing.
pub(crate) fn files(exhibit: &Exhibit, outcome: &Outcome, drawing: &Drawing, keep: Keep) -> Vec<File> {
    let frames = exhibit.experiment.tables(outcome);
    let file = |name: &str, label: String, bytes: Vec<u8>| File {
        path: format!("{FOLDER}/{}{name}", exhibit.id),
        label,
        bytes,
    };
    let mut files: Vec<File> = match &frames[..] {
        [frame] => vec![file(".csv", "CSV".to_owned(), csv(frame).into_bytes())],
        frames => {
            let one = |frame: &Frame| {
                file(&format!(".{}.csv", slug(frame.name)), format!("CSV of {}", frame.name), csv(frame).into_bytes())
            };
            frames.iter().map(one).collect()
        }
    };
    if keep == Keep::All {
        let names = frames.iter().map(|frame| frame.name).zip(&files).map(|(name, file)| (name, file.path.as_str()));
        let text = summary(exhibit, outcome, names.collect());
        files.push(file(".json", "JSON".to_owned(), text.into_bytes()));
    } else {
        files.retain(|file| file.bytes.len() <= SHORT);
    }
    let svg = |figure: &Figure| file(".svg", "SVG".to_owned(), figure.svg.clone().into_bytes());
    files.extend(drawing.figure().filter(|_| keep != Keep::Data).map(svg));
    if let Drawing::Pictures(pictures) = drawing {
        for (index, picture) in pictures.items.iter().enumerate() {
            let label = format!("PNG of {}", picture.name);
            files.push(file(&png_name(index, &picture.name), label, picture.png.bytes.clone()));
        }
    }
    files
}

/// The path of the picture `index` of an exhibit.
pub(super) fn png_path(id: &str, index: usize, name: &str) -> String {
    format!("{FOLDER}/{id}{}", png_name(index, name))
}

/// Numbered, since different names may be alike without their signs.
fn png_name(index: usize, name: &str) -> String {
    format!(".{}-{}.png", index + 1, slug(name))
}

/// A name as part of a file's.
fn slug(name: &str) -> String {
    let mut slug = String::new();
    for c in name.chars() {
        match c.to_ascii_lowercase() {
            c if c.is_ascii_alphanumeric() => slug.push(c),
            _ if slug.ends_with('-') => {}
            _ => slug.push('-'),
        }
    }
    slug.trim_matches('-').to_owned()
}

/// A frame as CSV (RFC 4180): a row of heads, then the rows; numbers read back to the same bits, what does not exist is empty.
pub(crate) fn csv(frame: &Frame) -> String {
    let mut out = String::new();
    let heads: Vec<String> = frame.columns.iter().map(|(name, _)| quoted(name)).collect();
    out.push_str(&heads.join(","));
    out.push('\n');
    for row in 0..frame.rows() {
        for (index, (_, entries)) in frame.columns.iter().enumerate() {
            if index > 0 {
                out.push(',');
            }
            // Writing to a string cannot fail.
            let _ = match entries {
                Entries::Numbers(numbers) => match numbers.get(row) {
                    Some(number) if number.is_finite() => write!(out, "{number}"),
                    _ => Ok(()),
                },
                Entries::Integers(integers) => integers.get(row).map_or(Ok(()), |integer| write!(out, "{integer}")),
                Entries::Text(words) => words.get(row).map_or(Ok(()), |word| write!(out, "{}", quoted(word))),
            };
        }
        out.push('\n');
    }
    out
}

/// A word as CSV has it.
fn quoted(word: &str) -> String {
    if word.contains(['"', ',', '\n', '\r']) { format!("\"{}\"", word.replace('"', "\"\"")) } else { word.to_owned() }
}

/// The values of a result as JSON: `{"values": {..}, "standard_errors": {..}}`, with what was asked for.
pub(crate) fn provenance(exhibit: &Exhibit, outcome: &Outcome) -> Map<String, Json> {
    let values = || outcome.values.iter();
    let errors = values().filter_map(|(name, measured)| Some((name.to_owned(), json!(measured.standard_error?))));
    [
        ("id", json!(exhibit.id)),
        ("kind", json!(exhibit.experiment.kind().about().key)),
        ("parameters", exhibit.experiment.parameters()),
        ("seed", json!(exhibit.seed)),
        ("values", Json::Object(values().map(|(name, measured)| (name.to_owned(), number(measured))).collect())),
        ("standard_errors", Json::Object(errors.collect())),
    ]
    .map(|(name, value)| (name.to_owned(), value))
    .into_iter()
    .collect()
}

/// An exhibit as JSON: its provenance, and under `tables` which file has the columns of each table.
fn summary(exhibit: &Exhibit, outcome: &Outcome, tables: BTreeMap<&str, &str>) -> String {
    let name = |path: &str| path.rsplit('/').next().unwrap_or(path).to_owned();
    let mut whole = provenance(exhibit, outcome);
    whole.insert(
        "tables".to_owned(),
        tables.into_iter().map(|(table, path)| (table.to_owned(), json!(name(path)))).collect(),
    );
    serde_json::to_string(&whole).unwrap_or_default() + "\n"
}

/// The whole data of an exhibit as JSON: its provenance, and its frames as columns under `tables`.
pub(crate) fn json(exhibit: &Exhibit, outcome: &Outcome, frames: &[Frame]) -> String {
    #[derive(Serialize)]
    struct Whole<'a> {
        #[serde(flatten)]
        provenance: Map<String, Json>,
        tables: BTreeMap<&'a str, BTreeMap<&'a str, Column<'a>>>,
    }
    let column = |(name, entries)| (String::as_str(name), Column(entries));
    let columns = frames.iter().map(|frame| frame.columns.iter().map(|(name, entries)| column((name, entries))));
    let tables = frames.iter().map(|frame| frame.name).zip(columns.map(Iterator::collect)).collect();
    let whole = Whole { provenance: provenance(exhibit, outcome), tables };
    serde_json::to_string(&whole).unwrap_or_default() + "\n"
}

/// A column as JSON writes it: what is not finite is null.
struct Column<'a>(&'a Entries);

impl Serialize for Column<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Entries::Numbers(numbers) => numbers.serialize(serializer),
            Entries::Integers(integers) => integers.serialize(serializer),
            Entries::Text(words) => words.serialize(serializer),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_reads_back() {
        let frame = Frame::new("x")
            .numbers("a, b", [0.1 + 0.2, f64::NAN])
            .counts("n", [3, 4])
            .text("w", ["say \"no\"".to_owned(), String::new()]);
        assert_eq!(csv(&frame), "\"a, b\",n,w\n0.30000000000000004,3,\"say \"\"no\"\"\"\n,4,\n");
    }

    #[test]
    fn names_of_files_are_plain() {
        assert_eq!(slug("Sobol+owen (seed=3)"), "sobol-owen-seed-3");
        assert_eq!(png_path("fig-x", 0, "halton+shift"), "exhibits/fig-x.1-halton-shift.png");
    }
}
