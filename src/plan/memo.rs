//! What has been planned before: for whoever plans a course again and again while it is being written.
//!
//! Of a chapter with the same text at the same place of the same course, its fences are the same, and so is all that is said of it alone.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Bibliography, Converter, Exhibit, Listing, Plan, Reading, Seen, bibliography, exhibit, listing};
use crate::diag::Diagnostic;
use crate::parse::{Chapter, Content, Course};
use crate::workspace::{TEMPLATES, Workspace, chapter_stem};

/// What is known of the last plan. What the next one does not have is forgotten.
#[derive(Default)]
pub struct Memo {
    /// The texts that are no chapters' and no templates: on them, all depends.
    around: Vec<Text>,
    /// The files that are no texts.
    blobs: Vec<Arc<str>>,
    chapters: BTreeMap<Arc<str>, Known>,
    bibliography: Option<(Arc<Bibliography>, Vec<Diagnostic>)>,
    converter: Option<(Arc<Converter>, Vec<Diagnostic>)>,
}

/// A path and the text there.
type Text = (Arc<str>, Arc<str>);

/// What is known of a chapter.
struct Known {
    content: Arc<Content>,
    text: Arc<str>,
    index: usize,
    fences: Option<Fences>,
    /// What was said, by who said it.
    told: BTreeMap<&'static str, Vec<Diagnostic>>,
}

/// The fences of a chapter, read as if it were the only one.
#[derive(Default)]
struct Fences {
    exhibits: Vec<Exhibit>,
    listings: Vec<Listing>,
    exhibit_of: Vec<Option<usize>>,
    listing_of: Vec<Option<usize>>,
    seen: Seen,
    told: Vec<Diagnostic>,
}

impl Memo {
    /// Begins to plan `course`.
    pub(super) fn begin(&mut self, course: &Course, workspace: &Workspace) {
        let others = workspace.texts.values().filter(|source| {
            chapter_stem(&source.path).is_none() && !source.path.starts_with(TEMPLATES) && !is_generated(&source.path)
        });
        let around: Vec<_> = others.map(|source| (Arc::clone(&source.path), Arc::clone(&source.text))).collect();
        let blobs: Vec<_> = workspace.data().cloned().collect();
        let same = |(old, new): (&Text, &Text)| old.0 == new.0 && (Arc::ptr_eq(&old.1, &new.1) || old.1 == new.1);
        if self.around.len() != around.len() || !self.around.iter().zip(&around).all(same) || self.blobs != blobs {
            *self = Self { around, blobs, ..Self::default() };
        }
        let mut before = std::mem::take(&mut self.chapters);
        for (index, chapter) in course.chapters.iter().enumerate() {
            let text = workspace.text(&chapter.file).map(|source| Arc::clone(&source.text)).unwrap_or_default();
            let same = |known: &Known| {
                known.index == index
                    && Arc::ptr_eq(&known.content, &chapter.content)
                    && (Arc::ptr_eq(&known.text, &text) || known.text == text)
            };
            let known = before.remove(&chapter.file).filter(same).unwrap_or_else(|| Known {
                content: Arc::clone(&chapter.content),
                text,
                index,
                fences: None,
                told: BTreeMap::new(),
            });
            self.chapters.insert(Arc::clone(&chapter.file), known);
        }
        if let Some((converter, _)) = &self.converter {
            converter.forget();
        }
    }

    /// The converter of the course, which remembers its formulas.
    pub(super) fn converter(
        &mut self,
        macros: &BTreeMap<String, String>,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Arc<Converter> {
        let (converter, told) = self.converter.get_or_insert_with(|| {
            let mut told = Vec::new();
            let converter = Converter::new(macros, &mut told).remembering();
            (Arc::new(converter), told)
        });
        diagnostics.extend(told.iter().cloned());
        Arc::clone(converter)
    }

    /// The converter of the last plan.
    pub fn last_converter(&self) -> Option<Arc<Converter>> {
        self.converter.as_ref().map(|(converter, _)| Arc::clone(converter))
    }

    /// The course's bibliography.
    pub(super) fn bibliography(
        &mut self,
        course: &Course,
        workspace: &Workspace,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Arc<Bibliography> {
        let (bibliography, told) = self.bibliography.get_or_insert_with(|| {
            let mut told = Vec::new();
            (Arc::new(bibliography::read(course, workspace, &mut told)), told)
        });
        diagnostics.extend(told.iter().cloned());
        Arc::clone(bibliography)
    }

    /// Adds the fences of a chapter to the plan.
    pub(super) fn fences(&mut self, reading: &Reading<'_>, plan: &mut Plan, diagnostics: &mut Vec<Diagnostic>) {
        let Some(known) = self.chapters.get_mut(&reading.chapter.file) else {
            return read(reading, plan, diagnostics);
        };
        let fences = known.fences.get_or_insert_with(|| Fences::read(reading));
        if plan.seen.meets(&fences.seen) {
            // Who has an id that an earlier chapter has must hear it, and what is said of the chapter depends on others.
            known.fences = None;
            known.told.clear();
            return read(reading, plan, diagnostics);
        }
        fences.add(plan, diagnostics);
        // Such a listing depends on the text of another chapter.
        if fences.listings.iter().any(|listing| chapter_stem(&listing.source).is_some()) {
            known.fences = None;
        }
    }

    /// Tells what `find` finds in a chapter, or what it has found before.
    pub(super) fn once(
        &mut self,
        chapter: &Chapter,
        who: &'static str,
        diagnostics: &mut Vec<Diagnostic>,
        find: impl FnOnce(&mut Vec<Diagnostic>),
    ) {
        let Some(known) = self.chapters.get_mut(&chapter.file).filter(|known| known.fences.is_some()) else {
            return find(diagnostics);
        };
        let told = known.told.entry(who).or_insert_with(|| {
            let mut told = Vec::new();
            find(&mut told);
            told
        });
        diagnostics.extend(told.iter().cloned());
    }
}

/// Whether a text was written by code.
fn is_generated(path: &str) -> bool {
    path.strip_prefix(crate::generate::FOLDER).is_some_and(|rest| rest.starts_with('/'))
}

/// Reads the fences of a chapter into the plan, those of the chapters before it in sight.
fn read(reading: &Reading<'_>, plan: &mut Plan, diagnostics: &mut Vec<Diagnostic>) {
    plan.exhibit_of.push(exhibit::read_all(reading, &mut plan.exhibits, &mut plan.seen, diagnostics));
    plan.listing_of.push(listing::read_all(reading, &mut plan.listings, &mut plan.seen, diagnostics));
}

impl Fences {
    fn read(reading: &Reading<'_>) -> Self {
        let mut read = Self::default();
        read.exhibit_of = exhibit::read_all(reading, &mut read.exhibits, &mut read.seen, &mut read.told);
        read.listing_of = listing::read_all(reading, &mut read.listings, &mut read.seen, &mut read.told);
        read
    }

    fn add(&self, plan: &mut Plan, diagnostics: &mut Vec<Diagnostic>) {
        let behind = |of: &[Option<usize>], offset: usize| of.iter().map(|at| at.map(|at| at + offset)).collect();
        plan.exhibit_of.push(behind(&self.exhibit_of, plan.exhibits.len()));
        plan.listing_of.push(behind(&self.listing_of, plan.listings.len()));
        plan.exhibits.extend(self.exhibits.iter().cloned());
        plan.listings.extend(self.listings.iter().cloned());
        plan.seen.add(&self.seen);
        diagnostics.extend(self.told.iter().cloned());
    }
}
