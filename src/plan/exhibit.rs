//! Experiment fences: from TOML to validated experiments.

use std::sync::Arc;

use super::{Exhibit, Reading, Seen, claim};
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic, Place};
use crate::kinds::{AnyKind, KINDS};
use crate::parameters::{COMMON_KEYS, Complaint, Fields};
use crate::parse::{self, Fence, SourceMap};

/// Reads every experiment fence of a chapter; gives for each the index of its exhibit, unless it is wrong.
pub(super) fn read_all(
    reading: &Reading<'_>,
    exhibits: &mut Vec<Exhibit>,
    seen: &mut Seen,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Option<usize>> {
    let mut indices = Vec::new();
    for fence in &reading.chapter.content.experiments {
        let exhibit = read(fence, reading, seen, diagnostics);
        indices.push(exhibit.is_some().then_some(exhibits.len()));
        exhibits.extend(exhibit);
    }
    indices
}

/// Reads one fence; `None` if anything is wrong, and then all that is wrong has been told.
pub(super) fn read(
    fence: &Fence,
    reading: &Reading<'_>,
    seen: &mut Seen,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Exhibit> {
    let file = &reading.chapter.file;
    let before = diagnostics.len();
    let table = parse::table(&fence.text, file, &fence.map, diagnostics);
    let mut fields = Fields::new(table.get_ref());
    let head = read_head(&mut fields);
    let experiment = read_kind(&mut fields).and_then(|kind| kind.plan(&mut fields));
    let claims = claim::read_all(&mut fields);
    tell(fields.complaints, fence, reading, diagnostics);
    let caption = head.caption.map(|caption| {
        let map = caption.map(fence);
        parse::caption(&caption.text, file, map, reading.workspace, diagnostics)
    });
    let place = Place { file: Arc::clone(file), range: fence.head(&reading.workspace.text(file)?.text) };
    if let Some(id) = &head.id {
        seen.enter(id, &place, diagnostics);
    }
    if diagnostics.len() > before {
        seen.fail(reading.index, head.id, caption);
        return None;
    }
    Some(Exhibit {
        id: head.id?,
        chapter: reading.index,
        place,
        caption: caption?,
        alt: head.alt,
        claims: claims.into_iter().map(|claim| claim.placed(&fence.map)).collect(),
        seed: head.seed.map_or(reading.seed, |seed| seed as u64),
        experiment: Arc::from(experiment?),
    })
}

/// Complaints of a fence become diagnostics at their places in the chapter; those without a place go to the fence's head.
pub(super) fn tell(
    complaints: Vec<Complaint>,
    fence: &Fence,
    reading: &Reading<'_>,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let text = reading.workspace.text(&reading.chapter.file).map(|source| &*source.text).unwrap_or_default();
    for complaint in complaints {
        let range =
            if complaint.range.is_empty() { fence.head(text) } else { fence.map.range(complaint.range.clone()) };
        let mut diagnostic = Diagnostic::error(complaint.code, complaint.message).at(&reading.chapter.file, range);
        diagnostic.help = complaint.help;
        diagnostics.push(diagnostic);
    }
}

/// What every experiment's fence says, whatever its kind.
struct Head {
    id: Option<String>,
    caption: Option<Quoted>,
    alt: Option<String>,
    seed: Option<usize>,
}

/// A string of a fence whose inside has places.
pub(super) struct Quoted {
    pub(super) text: String,
    /// The bytes in the fence's TOML, quotes included.
    range: std::ops::Range<usize>,
}

impl Quoted {
    /// The string at `key`.
    pub(super) fn read(fields: &mut Fields<'_>, key: &str) -> Option<Self> {
        let text = fields.read::<String>(key)?;
        Some(Self { text, range: fields.place(key) })
    }

    /// Where each byte of the string stands in the file: exactly if it holds no escapes, else at the string as a whole.
    pub(super) fn map(&self, fence: &Fence) -> SourceMap {
        let raw = &fence.text[self.range.clone()];
        match raw.find(self.text.as_str()) {
            Some(inside) => fence.map.from(self.range.start + inside),
            None => SourceMap::whole(fence.map.byte(self.range.start), 1),
        }
    }
}

fn read_head(fields: &mut Fields<'_>) -> Head {
    for key in COMMON_KEYS {
        fields.take(key);
    }
    let missing = |fields: &mut Fields<'_>, key: &str, help: &str| {
        if fields.value(key).is_none() {
            let place = fields.place("kind");
            let complaint = Complaint::new(Code::MissingKey, place, format!("the key `{key}` is missing"));
            fields.complaints.push(complaint.help(help));
        }
    };
    missing(fields, "id", "every exhibit has an id: `id = \"fig-…\"` for a figure, `id = \"tbl-…\"` for a table");
    missing(fields, "caption", "every exhibit has a caption that says what to see: `caption = \"…\"`");
    let id = fields.read::<String>("id");
    if let Some(id) = &id
        && let Some(complaint) = bad_id(id, &["fig", "tbl"], fields.place("id"))
    {
        fields.complaints.push(complaint);
    }
    let alt = fields.read::<String>("alt");
    if alt.as_ref().is_some_and(|alt| alt.trim().is_empty()) {
        let place = fields.place("alt");
        let complaint = Complaint::new(Code::MissingAlt, place, "the alternative text is empty");
        fields
            .complaints
            .push(complaint.help("say what the exhibit shows, or remove the key to have it derived from the data"));
    }
    Head { id, caption: Quoted::read(fields, "caption"), alt, seed: fields.read::<usize>("seed") }
}

/// A complaint if `id` is not one of `prefixes`, a hyphen, and lower-case letters, digits and hyphens.
pub(super) fn bad_id(id: &str, prefixes: &[&str], range: std::ops::Range<usize>) -> Option<Complaint> {
    let ends = prefixes.iter().map(|prefix| format!("`{prefix}-`")).collect::<Vec<_>>().join(" or ");
    let plain = |name: &str| {
        !name.is_empty()
            && !name.ends_with('-')
            && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
    };
    match id.split_once('-') {
        Some((prefix, name)) if prefixes.contains(&prefix) && plain(name) => None,
        _ => Some(
            Complaint::new(Code::BadId, range, format!("`{id}` is not an id of this kind"))
                .help(format!("an id is {ends} and then lower-case letters, digits and hyphens")),
        ),
    }
}

/// The kind that the fence names.
fn read_kind(fields: &mut Fields<'_>) -> Option<&'static dyn AnyKind> {
    const ALL: &str = "`workbook list kinds` shows them all, `workbook list kinds NAME` what one of them takes";
    let Some(written) = fields.read::<String>("kind") else {
        if fields.value("kind").is_none() {
            let complaint = Complaint::new(Code::MissingKey, fields.place("id"), "the key `kind` is missing");
            fields.complaints.push(complaint.help("such as `kind = \"convergence\"`").help(ALL));
        }
        return None;
    };
    let found = KINDS.iter().copied().find(|kind| kind.about().key == written);
    if found.is_none() {
        let near =
            nearest(&written, KINDS.iter().map(|kind| kind.about().key)).map(|near| format!("did you mean `{near}`?"));
        let complaint =
            Complaint::new(Code::UnknownName, fields.place("kind"), format!("there is no kind `{written}`"));
        fields.complaints.push(complaint.help_if(near).help(ALL));
    }
    found
}
