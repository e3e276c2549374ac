//! What has been seen of fences while they are read, the wrong ones included: so that one mistake hides no other.

use std::collections::{BTreeMap, BTreeSet};

use crate::diag::{Code, Diagnostic, Place};
use crate::parse::Node;

/// The ids and captions of fences.
#[derive(Debug, Clone, Default)]
pub struct Seen {
    ids: BTreeMap<String, Place>,
    wrong: BTreeSet<String>,
    captions: Vec<(usize, Vec<Node>)>,
    failed: usize,
}

impl Seen {
    /// Whether any fence is wrong.
    pub fn any_wrong(&self) -> bool {
        self.failed > 0
    }

    /// Whether `id` belongs to a fence that is wrong: then what refers to it is not to blame.
    pub fn is_wrong(&self, id: &str) -> bool {
        self.wrong.contains(id)
    }

    /// The captions of the wrong fences of a chapter.
    pub fn captions(&self, chapter: usize) -> impl Iterator<Item = &[Node]> {
        self.captions.iter().filter(move |(of, _)| *of == chapter).map(|(_, caption)| caption.as_slice())
    }

    /// Whether both have met the same id.
    pub(super) fn meets(&self, other: &Self) -> bool {
        other.ids.keys().any(|id| self.ids.contains_key(id))
    }

    /// Adds what has been seen of another chapter, which has none of these ids.
    pub(super) fn add(&mut self, other: &Self) {
        self.ids.extend(other.ids.iter().map(|(id, place)| (id.clone(), place.clone())));
        self.wrong.extend(other.wrong.iter().cloned());
        self.captions.extend(other.captions.iter().cloned());
        self.failed += other.failed;
    }

    /// Notes the id of a fence; complains if another fence has it already.
    pub(super) fn enter(&mut self, id: &str, place: &Place, diagnostics: &mut Vec<Diagnostic>) {
        if let Some(before) = self.ids.get(id) {
            let error = Diagnostic::error(Code::DuplicateId, format!("the id `{id}` is used twice")).at_place(place);
            let first = format!("another fence in {} has it already; give one of them another id", before.file);
            diagnostics.push(error.help(first));
        } else {
            self.ids.insert(id.to_owned(), place.clone());
        }
    }

    /// Notes that a fence of the chapter is wrong.
    pub(super) fn fail(&mut self, chapter: usize, id: Option<String>, caption: Option<Vec<Node>>) {
        self.failed += 1;
        self.wrong.extend(id);
        self.captions.extend(caption.map(|caption| (chapter, caption)));
    }
}
