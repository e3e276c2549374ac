//! Chapters that have been parsed before: for whoever parses a course again and again while it is being written.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Chapter, Configuration, chapter};
use crate::diag::Diagnostic;
use crate::workspace::{CONFIGURATION, Source, Workspace};

/// The chapters of the last time, by their files. What no chapter asked for is forgotten.
#[derive(Default)]
pub struct Memo {
    /// What else a chapter's parsing depends on: the configuration, and which files there are.
    around: Option<(Arc<str>, Vec<Arc<str>>)>,
    known: BTreeMap<Arc<str>, Known>,
    used: BTreeMap<Arc<str>, Known>,
}

/// A chapter with the text that it was parsed from and what was said of it.
struct Known {
    text: Arc<str>,
    chapter: Chapter,
    told: Vec<Diagnostic>,
}

impl Memo {
    /// Begins to parse the course of `workspace`.
    pub(super) fn begin(&mut self, workspace: &Workspace) {
        let configuration = workspace.text(CONFIGURATION).map(|source| Arc::clone(&source.text)).unwrap_or_default();
        let around = Some((configuration, workspace.data().cloned().collect()));
        if self.around != around {
            self.known.clear();
            self.around = around;
        }
    }

    /// The chapter of a file.
    pub(super) fn chapter(
        &mut self,
        source: &Source,
        configuration: &Configuration,
        workspace: &Workspace,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Chapter {
        let before = self.known.remove(&source.path).filter(|known| Arc::ptr_eq(&known.text, &source.text));
        let known = before.unwrap_or_else(|| {
            let mut told = Vec::new();
            let chapter = chapter(source, configuration, workspace, &mut told);
            Known { text: Arc::clone(&source.text), chapter, told }
        });
        diagnostics.extend(known.told.iter().cloned());
        let chapter = known.chapter.clone();
        self.used.insert(Arc::clone(&source.path), known);
        chapter
    }

    /// Ends it: what was used is what is known next time.
    pub(super) fn end(&mut self) {
        self.known = std::mem::take(&mut self.used);
    }
}
