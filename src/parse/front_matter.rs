//! A chapter's front matter: TOML between two lines of `+++`.

use std::ops::Range;

use super::given::{self, Given};
use super::source_map::SourceMap;
use super::toml_text;
use crate::diag::{Code, Diagnostic};
use crate::parameters::{Fields, Parameters, parameters};
use crate::workspace::Source;

parameters! {
    /// The keys of a chapter's front matter.
    pub struct Written {
        /// The chapter's title.
        title: String,
        /// What the chapter is about, in a sentence.
        summary: String,
    }
}

/// A chapter's title and summary.
#[derive(Debug, Clone, Default)]
pub struct FrontMatter {
    /// The chapter's title.
    pub title: String,
    /// What the chapter is about, in a sentence.
    pub summary: String,
    /// The numbers in its text that are given.
    pub given: Vec<Given>,
}

/// Reads the front matter at `range` of a chapter; what is missing or wrong is told.
pub(super) fn read(range: Option<Range<usize>>, source: &Source, diagnostics: &mut Vec<Diagnostic>) -> FrontMatter {
    let Some(range) = range else {
        let error = Diagnostic::error(Code::MissingKey, "the chapter has no front matter").at(&source.path, 0..0);
        diagnostics.push(error.help("begin it with lines `+++`, `title = \"…\"`, `summary = \"…\"`, `+++`"));
        return FrontMatter::default();
    };
    let map = SourceMap::whole(range.start, range.len());
    let table = toml_text::table(&source.text[range], &source.path, &map, diagnostics);
    let mut fields = Fields::plain(table.get_ref());
    let written = Written::read(&mut fields);
    let mut given = given::read(&mut fields);
    for given in &mut given {
        given.range = map.range(given.range.clone());
    }
    fields.finish(&["title", "summary", "given"]);
    for complaint in fields.complaints {
        let mut diagnostic =
            Diagnostic::error(complaint.code, complaint.message).at(&source.path, map.range(complaint.range));
        diagnostic.help = complaint.help;
        diagnostics.push(diagnostic);
    }
    let (title, summary) = written.map(|written| (written.title, written.summary)).unwrap_or_default();
    FrontMatter { title, summary, given }
}
