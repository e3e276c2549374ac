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
        /// The exhibit whose drawing stands for the chapter on the landing page.
        picture: Option<String>,
    }
}

/// An exhibit that is named, and the place of its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chosen {
    /// The exhibit's id.
    pub id: String,
    /// Where it stands in the chapter's file.
    pub range: Range<usize>,
}

/// A chapter's title and summary, and what stands for it.
#[derive(Debug, Clone, Default)]
pub struct FrontMatter {
    /// The chapter's title.
    pub title: String,
    /// What the chapter is about, in a sentence.
    pub summary: String,
    /// The exhibit whose drawing stands for the chapter; else it is the first that has one.
    pub picture: Option<Chosen>,
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
    let place = map.range(fields.place("picture"));
    let mut given = given::read(&mut fields);
    for given in &mut given {
        given.range = map.range(given.range.clone());
    }
    fields.finish(&["title", "summary", "picture", "given"]);
    for complaint in fields.complaints {
        let mut diagnostic =
            Diagnostic::error(complaint.code, complaint.message).at(&source.path, map.range(complaint.range));
        diagnostic.help = complaint.help;
        diagnostics.push(diagnostic);
    }
    let picture = |id| Chosen { id, range: place };
    written.map_or_else(FrontMatter::default, |written| FrontMatter {
        title: written.title,
        summary: written.summary,
        picture: written.picture.map(picture),
        given,
    })
}
