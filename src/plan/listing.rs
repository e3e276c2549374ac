//! Listing fences: code of this very library, as it was compiled, or a file of the course.

use std::sync::Arc;

use super::exhibit::{Quoted, bad_id, tell};
use super::{Reading, Seen};
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic, Place};
use crate::parameters::{Complaint, Fields, ParameterDoc, Parameters, parameters};
use crate::parse::{self, Emphasis, Fence, HELP, Node};
use crate::sources;
use crate::workspace::CHAPTERS;

parameters! {
    /// The keys of a listing fence.
    pub struct Written {
        /// The id of the listing, `lst-…`.
        id: String,
        /// What to see in it.
        caption: String,
        /// The item of the library to show, e.g. `samplers::halton::radical_inverse`.
        item: Option<String>,
        /// A file of the course to show instead, from the chapters' folder; it is shown, not run.
        file: Option<String>,
        /// The lines to be looked at first, from 1: `3,5-7`.
        emphasis: Option<String>,
    }
}

/// What can be written in a listing fence.
pub fn listing_docs() -> Vec<ParameterDoc> {
    Written::docs()
}

/// Code that the book shows.
#[derive(Debug, Clone)]
pub struct Listing {
    /// Its id, e.g. `lst-radical-inverse`.
    pub id: String,
    /// The index of its chapter.
    pub chapter: usize,
    /// The fence's first line.
    pub place: Place,
    /// The caption's nodes.
    pub caption: Vec<Node>,
    /// The code.
    pub code: String,
    /// The language of the code, by the ending of its file.
    pub language: String,
    /// Where it stands, e.g. `src/samplers/halton.rs:41`.
    pub source: String,
    /// The lines that stand out.
    pub emphasis: Emphasis,
}

/// Reads every listing fence of a chapter; gives for each the index of its listing, unless it is wrong.
pub(super) fn read_all(
    reading: &Reading<'_>,
    listings: &mut Vec<Listing>,
    seen: &mut Seen,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Option<usize>> {
    let mut indices = Vec::new();
    for fence in &reading.chapter.content.listings {
        let listing = read(fence, reading, seen, diagnostics);
        indices.push(listing.is_some().then_some(listings.len()));
        listings.extend(listing);
    }
    indices
}

fn read(fence: &Fence, reading: &Reading<'_>, seen: &mut Seen, diagnostics: &mut Vec<Diagnostic>) -> Option<Listing> {
    let file = &reading.chapter.file;
    let before = diagnostics.len();
    let table = parse::table(&fence.text, file, &fence.map, diagnostics);
    let mut fields = Fields::plain(table.get_ref());
    let written = Written::read(&mut fields);
    let caption = Quoted::read(&mut fields, "caption");
    fields.finish(&["id", "caption", "item", "file", "emphasis"]);
    let code = written.as_ref().and_then(|written| find_code(written, reading, &mut fields));
    let text = code.as_ref().map(|(text, ..)| text.as_str());
    let emphasis = written.as_ref().and_then(|written| written.emphasis.as_deref()).unwrap_or_default();
    let emphasis = read_emphasis(emphasis, text, &mut fields);
    if let Some(complaint) = written.as_ref().and_then(|written| bad_id(&written.id, &["lst"], fields.place("id"))) {
        fields.complaints.push(complaint);
    }
    tell(fields.complaints, fence, reading, diagnostics);
    let caption =
        caption.map(|caption| parse::caption(&caption.text, file, caption.map(fence), reading.workspace, diagnostics));
    let place = Place { file: Arc::clone(file), range: fence.head(&reading.workspace.text(file)?.text) };
    if let Some(written) = &written {
        seen.enter(&written.id, &place, diagnostics);
    }
    if diagnostics.len() > before {
        seen.fail(reading.index, written.map(|written| written.id), caption);
        return None;
    }
    let (code, language, source) = code?;
    Some(Listing {
        id: written?.id,
        chapter: reading.index,
        place,
        caption: caption?,
        code,
        language,
        source,
        emphasis,
    })
}

/// The lines of the code that stand out; none where nothing is `written`.
fn read_emphasis(written: &str, code: Option<&str>, fields: &mut Fields<'_>) -> Emphasis {
    if written.is_empty() {
        return Emphasis::default();
    }
    let (emphasis, told) = match Emphasis::read(written) {
        Ok(read) => {
            let told = code.and_then(|code| read.beyond(code.lines().count()));
            (read, told.map(|message| (Code::OutOfRange, message)))
        }
        Err(part) => (Emphasis::default(), Some((Code::WrongType, format!("`{part}` is no line of code")))),
    };
    let place = fields.place("emphasis");
    fields.complaints.extend(told.map(|(code, message)| Complaint::new(code, place, message).help(HELP)));
    emphasis
}

/// The code that a listing names, with its language and where it stands.
fn find_code(written: &Written, reading: &Reading<'_>, fields: &mut Fields<'_>) -> Option<(String, String, String)> {
    match (&written.item, &written.file) {
        (Some(item), None) => {
            let found = sources::item(item);
            if found.is_none() {
                let complaint = Complaint::new(
                    Code::UnknownItem,
                    fields.place("item"),
                    format!("the library has no item `{item}`"),
                );
                let complaint = complaint
                    .help_if(
                        nearest(item, sources::items().iter().map(String::as_str))
                            .map(|near| format!("did you mean `{near}`?")),
                    )
                    .help("name it by its path below the crate, e.g. `samplers::halton::radical_inverse`");
                fields.complaints.push(complaint);
            }
            found.map(|item| (item.text, "rust".to_owned(), format!("src/{}:{}", item.file, item.first_line)))
        }
        (None, Some(file)) => {
            let path = format!("{CHAPTERS}/{file}");
            let found = reading.workspace.text(&path);
            if found.is_none() {
                let complaint =
                    Complaint::new(Code::MissingInclude, fields.place("file"), format!("there is no file `{path}`"));
                fields.complaints.push(complaint.help(format!("paths start at `{CHAPTERS}/`")));
            }
            let language = file.rsplit_once('.').map_or("text", |(_, extension)| extension).to_owned();
            found.map(|source| (source.text.to_string(), language, format!("{path}:1")))
        }
        _ => {
            let place = fields.place("id");
            let complaint = Complaint::new(Code::MissingKey, place, "a listing shows either an item or a file");
            fields.complaints.push(
                complaint.help("write `item = \"samplers::halton::radical_inverse\"`, or `file = \"code/halton.c\"`"),
            );
            None
        }
    }
}
