//! A proof of the book: everything that its pages are made of, so that any file can be rendered when it is asked for.
//!
//! A preview makes one after the other; what has not changed is taken from the one before.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::citations::{Citations, cited};
use super::templates::{self, Templates};
use super::{Book, FIGURES, Rendering, data, files_of, machine, pages, previews, search};
use crate::diag::Diagnostic;
use crate::exhibits::Shown;
use crate::kinds::Experiment;
use crate::parse::Course;
use crate::plan::{Converter, Exhibit, Plan};
use crate::sources::Digest;
use crate::workspace::{CHAPTERS, TEMPLATES, Workspace, extension};

/// What a book is rendered from.
#[derive(Clone)]
pub struct Parts {
    /// The inputs.
    pub workspace: Arc<Workspace>,
    /// The course as written.
    pub course: Arc<Course>,
    /// All that is due.
    pub plan: Arc<Plan>,
    /// Its exhibits, in its order.
    pub shown: Vec<Shown>,
    /// The places of those that are not what is asked for, but what was there before, or what stands in for it.
    pub stale: BTreeSet<usize>,
    /// The converter of the course's formulas.
    pub converter: Arc<Converter>,
}

/// A book whose files are rendered when they are asked for.
pub struct Proof {
    parts: Parts,
    /// The course's own templates and assets.
    own: Vec<Own>,
    templates: Arc<Templates>,
    cited: Vec<String>,
    citations: Arc<Citations>,
    files: Vec<Arc<Vec<data::File>>>,
    looks: Looks,
}

/// By what it is known how pages look and what they do: a page that shows another than the last has to load something again.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Looks {
    /// Sheets, pictures, fonts.
    pub assets: String,
    /// Scripts.
    pub scripts: String,
}

/// A file that overrides an embedded one: its path, and where its bytes are.
type Own = (Arc<str>, usize, usize);

impl Proof {
    /// The proof of these parts, and what there is to tell of the templates and the citations; none without templates.
    pub fn new(parts: Parts, before: Option<&Self>) -> (Option<Self>, Vec<Diagnostic>) {
        let mut told = Vec::new();
        let own = own(&parts.workspace);
        let same = before.filter(|before| before.own == own);
        let Some(templates) = same
            .map(|before| Arc::clone(&before.templates))
            .or_else(|| Templates::load(&parts.workspace, &mut told).map(Arc::new))
        else {
            return (None, told);
        };
        let cited = cited(&parts.course, &parts.plan);
        let same = same.filter(|before| {
            before.cited == cited && Arc::ptr_eq(&before.parts.plan.bibliography, &parts.plan.bibliography)
        });
        let citations = same.map_or_else(
            || Arc::new(Citations::format(&parts.course, &parts.plan, &parts.workspace, &mut told)),
            |before| Arc::clone(&before.citations),
        );
        let files = files(&parts, before);
        let looks = looks(&parts.workspace);
        (Some(Self { parts, own, templates, cited, citations, files, looks }), told)
    }

    /// The parts that it was made of.
    pub fn parts(&self) -> &Parts {
        &self.parts
    }

    /// How its pages look and what they do.
    pub fn looks(&self) -> &Looks {
        &self.looks
    }

    fn rendering(&self, marked: bool) -> Rendering<'_> {
        Rendering {
            course: &self.parts.course,
            plan: &self.parts.plan,
            shown: &self.parts.shown,
            workspace: &self.parts.workspace,
            converter: &self.parts.converter,
            citations: &self.citations,
            templates: &self.templates,
            files: &self.files,
            marked,
        }
    }

    /// The page at this path, with a mark around the blocks of a chapter, and what there is to tell of it.
    pub fn page(&self, path: &str) -> Option<(String, Vec<Diagnostic>)> {
        let mut told = Vec::new();
        let page = pages::page(&self.rendering(true), path, &mut told)?;
        Some((page, told))
    }

    /// The file at this path, if the book has one there that is no page. The map of the site and its card are only for the site itself.
    pub fn file(&self, path: &str) -> Option<Vec<u8>> {
        let rendering = self.rendering(false);
        if let Some(asset) = self.templates.asset(path) {
            return Some(asset.to_vec());
        }
        if let Some(previews) = previews::whole(&rendering, path) {
            return Some(previews.into_bytes());
        }
        if path == search::PATH {
            return Some(search::file(&rendering).1.into_bytes());
        }
        if path == FIGURES {
            return Some(machine::figures(&rendering).into_bytes());
        }
        let mut files = self.files.iter().flat_map(|files| files.iter());
        let file = files.find(|file| file.path == path).map(|file| file.bytes.clone());
        file.or_else(|| self.parts.workspace.blobs.get(&*format!("{CHAPTERS}/{path}")).map(|bytes| bytes.to_vec()))
    }

    /// The whole book, as a build writes it; none if `go_on` says no on the way.
    pub fn book(&self, go_on: &dyn Fn() -> bool) -> Option<(Book, Vec<Diagnostic>)> {
        let mut told = Vec::new();
        let book = super::book(&self.rendering(false), &mut told, go_on)?;
        Some((book, told))
    }
}

/// A file that only a preview has, such as the script of its pages.
pub fn of_preview(name: &str) -> &'static [u8] {
    templates::embedded(&format!("preview/{name}")).unwrap_or_default()
}

/// The course's own templates and assets: the same as long as their bytes are at the same places.
fn own(workspace: &Workspace) -> Vec<Own> {
    let is_own = |path: &Arc<str>| path.starts_with(TEMPLATES);
    let texts = workspace.texts.iter().filter(|(path, _)| is_own(path));
    let blobs = workspace.blobs.iter().filter(|(path, _)| is_own(path));
    let texts = texts.map(|(path, source)| (Arc::clone(path), source.text.as_ptr() as usize, source.text.len()));
    texts.chain(blobs.map(|(path, bytes)| (Arc::clone(path), bytes.as_ptr() as usize, bytes.len()))).collect()
}

fn looks(workspace: &Workspace) -> Looks {
    let own = |script: bool| {
        let texts = workspace.texts.iter().filter(move |(path, _)| {
            path.starts_with(TEMPLATES) && path.ends_with(".js") == script && extension(path) != Some("html")
        });
        texts.flat_map(|(path, source)| [path.as_bytes(), source.text.as_bytes()])
    };
    let blobs = workspace.blobs.iter().flat_map(|(path, bytes)| [path.as_bytes(), bytes]);
    Looks { assets: Digest::of_parts(own(false).chain(blobs)).short(), scripts: Digest::of_parts(own(true)).short() }
}

/// The files of all exhibits; those of an exhibit that is the same are not made anew.
fn files(parts: &Parts, before: Option<&Proof>) -> Vec<Arc<Vec<data::File>>> {
    let old: BTreeMap<&str, usize> = before.map_or_else(BTreeMap::new, |before| {
        before.parts.plan.exhibits.iter().enumerate().map(|(at, exhibit)| (exhibit.id.as_str(), at)).collect()
    });
    let exhibits = parts.plan.exhibits.iter().zip(&parts.shown);
    exhibits
        .enumerate()
        .map(|(index, (exhibit, shown))| {
            let known = before.zip(old.get(exhibit.id.as_str()));
            if parts.stale.contains(&index) {
                // What is asked for now says nothing of what was there before.
                return known.map(|(before, at)| Arc::clone(&before.files[*at])).unwrap_or_default();
            }
            let known = known.filter(|(before, at)| {
                let (was, had) = (&before.parts.plan.exhibits[**at], &before.parts.shown[**at]);
                !before.parts.stale.contains(*at)
                    && Arc::ptr_eq(&had.outcome, &shown.outcome)
                    && Arc::ptr_eq(&had.drawing, &shown.drawing)
                    && same(was, exhibit)
                    && kept(&before.parts, was) == kept(parts, exhibit)
            });
            match known {
                Some((before, at)) => Arc::clone(&before.files[*at]),
                None => Arc::new(files_of(&parts.course, exhibit, &shown.outcome, &shown.drawing)),
            }
        })
        .collect()
}

fn kept(parts: &Parts, exhibit: &Exhibit) -> data::Keep {
    data::Keep::of(&parts.course.chapters[exhibit.chapter], &exhibit.id)
}

/// Whether two exhibits ask for the same.
fn same(one: &Exhibit, other: &Exhibit) -> bool {
    let ask = |exhibit: &Exhibit| {
        let experiment: &dyn Experiment = exhibit.experiment.as_ref();
        (experiment.kind().about().key, experiment.parameters())
    };
    one.seed == other.seed && (Arc::ptr_eq(&one.experiment, &other.experiment) || ask(one) == ask(other))
}
