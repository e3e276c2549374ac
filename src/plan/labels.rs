//! Labels and their numbers: chapters, sections, figures, tables, listings, equations, definitions, exercises.

use std::collections::BTreeMap;
use std::sync::Arc;

use pulldown_cmark::{Event, Tag, TagEnd};

use super::Plan;
use super::slug::slug;
use crate::diag::{Code, Diagnostic, Place};
use crate::parse::{CalloutKind, Chapter, Course, Label, Node, What};

/// The ids that the templates of pages have for themselves.
const OF_PAGES: &[&str] = &["main", "on-this-page"];

/// What a label can name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum LabelKind {
    /// `fig-`.
    Figure,
    /// `tbl-`.
    Table,
    /// `lst-`.
    Listing,
    /// `eq-`.
    Equation,
    /// `sec-`, or any other heading.
    Section,
    /// `exr-`.
    Exercise,
    /// `def-`.
    Definition,
}

impl LabelKind {
    /// The word before the number, e.g. `Figure`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Figure => "Figure",
            Self::Table => "Table",
            Self::Listing => "Listing",
            Self::Equation => "Equation",
            Self::Section => "Section",
            Self::Exercise => "Exercise",
            Self::Definition => "Definition",
        }
    }

    /// The kind that an exhibit's id has by its prefix.
    fn of_exhibit(id: &str) -> Self {
        if id.starts_with("tbl-") { Self::Table } else { Self::Figure }
    }
}

/// What a label names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Target {
    /// What kind of thing.
    pub kind: LabelKind,
    /// Its number, e.g. `2.3`.
    pub number: String,
    /// The index of its chapter.
    pub chapter: usize,
    /// Where it is defined.
    pub place: Place,
}

/// A heading of a chapter, for its contents.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Section {
    /// The heading's id.
    pub id: String,
    /// Its number, e.g. `2.1`.
    pub number: String,
    /// Its level: 2 for a section, 3 for a subsection.
    pub level: usize,
    /// The nodes of its title in the chapter.
    pub title: std::ops::Range<usize>,
}

/// The id and the number that a node of a chapter got.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Anchor {
    /// The id, unique in the book if an author wrote it, else on its page.
    pub id: String,
    /// The number, e.g. `2.3`.
    pub number: String,
}

/// Every label of the book.
#[derive(Debug, Clone, Default)]
pub struct Labels {
    targets: BTreeMap<String, Target>,
    anchors: BTreeMap<(usize, usize), Anchor>,
    sections: Vec<Vec<Section>>,
}

impl Labels {
    /// What `id` names.
    pub fn target(&self, id: &str) -> Option<&Target> {
        self.targets.get(id)
    }

    /// The ids of all labels, sorted.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.targets.keys().map(String::as_str)
    }

    /// Whether something in the chapter `chapter` has this id.
    pub fn stands_in(&self, chapter: usize, id: &str) -> bool {
        self.ids_in(chapter).any(|known| known == id)
    }

    /// The ids of a chapter: those of its labels, and those of its headings and callouts.
    pub fn ids_in(&self, chapter: usize) -> impl Iterator<Item = &str> {
        let labels = self.targets.iter().filter(move |(_, target)| target.chapter == chapter).map(|(id, _)| id);
        let anchors = self.anchors.range((chapter, 0)..(chapter + 1, 0)).map(|(_, anchor)| &anchor.id);
        labels.chain(anchors).map(String::as_str)
    }

    /// The id and number of a heading, equation or callout: the node `node` of the chapter `chapter`.
    pub fn anchor(&self, chapter: usize, node: usize) -> Option<&Anchor> {
        self.anchors.get(&(chapter, node))
    }

    /// Gives everything the id and the number that it has in `whole`, which is of the same chapters with the same places of nodes.
    pub(super) fn numbered_as_in(&mut self, whole: &Self) {
        for (id, target) in &mut self.targets {
            if let Some(known) = whole.targets.get(id) {
                target.number.clone_from(&known.number);
            }
        }
        for (node, anchor) in &mut self.anchors {
            if let Some(known) = whole.anchors.get(node) {
                anchor.clone_from(known);
            }
        }
        for (sections, whole) in self.sections.iter_mut().zip(&whole.sections) {
            for section in sections {
                if let Some(known) = whole.iter().find(|known| known.title == section.title) {
                    section.clone_from(known);
                }
            }
        }
    }

    /// The headings of a chapter in order.
    pub fn sections(&self, chapter: usize) -> &[Section] {
        self.sections.get(chapter).map(Vec::as_slice).unwrap_or_default()
    }
}

/// Numbers everything that has a label or a number; an id that is used twice is told.
pub(super) fn number(course: &Course, plan: &Plan, diagnostics: &mut Vec<Diagnostic>) -> Labels {
    let mut labels = Labels::default();
    for (index, chapter) in course.chapters.iter().enumerate() {
        let mut numbering = Numbering {
            chapter,
            index,
            plan,
            labels: &mut labels,
            diagnostics,
            counts: BTreeMap::new(),
            section: [0; 6],
            sections: Vec::new(),
        };
        numbering.run();
        let sections = numbering.sections;
        labels.sections.push(sections);
    }
    labels
}

/// The walk over one chapter.
struct Numbering<'a> {
    chapter: &'a Chapter,
    index: usize,
    plan: &'a Plan,
    labels: &'a mut Labels,
    diagnostics: &'a mut Vec<Diagnostic>,
    counts: BTreeMap<LabelKind, usize>,
    /// The current section's number on each level.
    section: [usize; 6],
    sections: Vec<Section>,
}

impl Numbering<'_> {
    fn run(&mut self) {
        for (at, node) in self.chapter.content.nodes.iter().enumerate() {
            match &node.what {
                What::Markdown(Event::Start(Tag::Heading { level, id, .. })) => {
                    self.heading(*level as usize, id.as_deref(), at, node);
                }
                What::Experiment(fence) => self.exhibit(*fence),
                What::Listing(fence) => self.listing(*fence),
                What::Equation { label: Some(label), .. } => self.equation(label, at),
                What::CalloutStart(callout) => self.callout(callout.kind, callout.label.as_ref(), at),
                _ => {}
            }
        }
    }

    /// The next number of a kind: the chapter's number or letter, a dot, and the count in the chapter.
    fn next(&mut self, kind: LabelKind) -> String {
        let count = self.counts.entry(kind).or_default();
        *count += 1;
        format!("{}.{count}", self.chapter.number)
    }

    fn define(&mut self, id: &str, kind: LabelKind, number: String, place: Place) {
        // Fences with the same id have been told while they were read.
        if let Some(before) = self.labels.targets.get(id) {
            let message = format!("the id `{id}` is used twice");
            let first = format!(
                "it is already the id of {} {} in {}",
                kind_word(before.kind),
                before.number,
                before.place.file
            );
            self.diagnostics.push(
                Diagnostic::error(Code::DuplicateId, message)
                    .at_place(&place)
                    .help(first)
                    .help("give one of them another id"),
            );
            return;
        }
        self.labels.targets.insert(id.to_owned(), Target { kind, number, chapter: self.index, place });
    }

    fn place(&self, range: std::ops::Range<usize>) -> Place {
        Place { file: Arc::clone(&self.chapter.file), range }
    }

    fn heading(&mut self, level: usize, id: Option<&str>, at: usize, node: &Node) {
        if level == 1 {
            let error = Diagnostic::error(Code::Markup, "the chapter's title comes from its front matter");
            let error = error.at(&self.chapter.file, node.range.clone());
            return self.diagnostics.push(error.help("begin sections with `##`"));
        }
        let end = self.chapter.content.nodes[at..]
            .iter()
            .position(|node| matches!(node.what, What::Markdown(Event::End(TagEnd::Heading(_)))))
            .map_or(at, |length| at + length);
        self.section[level - 1] += 1;
        self.section[level..].fill(0);
        let inner = self.section[1..level].iter().map(usize::to_string).collect::<Vec<_>>().join(".");
        let number = format!("{}.{inner}", self.chapter.number);
        if let Some(id) = id.filter(|id| !id.starts_with("sec-") && self.taken(id)) {
            let error = Diagnostic::error(Code::DuplicateId, format!("the id `{id}` is used twice on this page"));
            self.diagnostics.push(error.at_place(&self.place(node.range.clone())).help("give one of them another id"));
        }
        let id =
            id.map_or_else(|| self.free_id(&heading_slug(&self.chapter.content.nodes[at + 1..end])), str::to_owned);
        if id.starts_with("sec-") {
            self.define(&id, LabelKind::Section, number.clone(), self.place(node.range.clone()));
        }
        self.labels.anchors.insert((self.index, at), Anchor { id: id.clone(), number: number.clone() });
        self.sections.push(Section { id, number, level, title: at + 1..end });
    }

    /// Whether a heading of the chapter, or the page around it, has this id.
    fn taken(&self, id: &str) -> bool {
        OF_PAGES.contains(&id) || self.sections.iter().any(|section| section.id == id)
    }

    /// `slug`, or the first of `slug-2`, `slug-3`, ... that is free on the page.
    fn free_id(&self, slug: &str) -> String {
        let mut id = slug.to_owned();
        let mut count = 1;
        while self.taken(&id) {
            count += 1;
            id = format!("{slug}-{count}");
        }
        id
    }

    fn exhibit(&mut self, fence: usize) {
        let index = self.plan.exhibit_of[self.index].get(fence).copied().flatten();
        let Some(exhibit) = index.and_then(|index| self.plan.exhibits.get(index)) else { return };
        let kind = LabelKind::of_exhibit(&exhibit.id);
        let number = self.next(kind);
        self.define(&exhibit.id, kind, number, exhibit.place.clone());
    }

    fn listing(&mut self, fence: usize) {
        let index = self.plan.listing_of[self.index].get(fence).copied().flatten();
        let Some(listing) = index.and_then(|index| self.plan.listings.get(index)) else { return };
        let number = self.next(LabelKind::Listing);
        self.define(&listing.id, LabelKind::Listing, number, listing.place.clone());
    }

    fn equation(&mut self, label: &Label, at: usize) {
        let number = self.next(LabelKind::Equation);
        self.labelled(label, "eq", LabelKind::Equation, number, at);
    }

    fn callout(&mut self, kind: CalloutKind, label: Option<&Label>, at: usize) {
        let numbered = match kind {
            CalloutKind::Exercise => LabelKind::Exercise,
            CalloutKind::Definition => LabelKind::Definition,
            _ => {
                if let Some(label) = label {
                    let error = Diagnostic::error(
                        Code::BadId,
                        format!("a callout `[!{}]` has no number to refer to", kind.name()),
                    );
                    self.diagnostics.push(
                        error
                            .at(&self.chapter.file, label.range.clone())
                            .help("only definitions and exercises have labels"),
                    );
                }
                return;
            }
        };
        let number = self.next(numbered);
        if let (Some(label), Some(prefix)) = (label, kind.prefix()) {
            self.labelled(label, prefix, numbered, number, at);
        } else {
            let id = format!("{}-{}", numbered.word().to_lowercase(), number.replace('.', "-"));
            self.labels.anchors.insert((self.index, at), Anchor { id, number });
        }
    }

    /// A node with a label that must have the prefix of its kind.
    fn labelled(&mut self, label: &Label, prefix: &str, kind: LabelKind, number: String, at: usize) {
        let place = self.place(label.range.clone());
        if !label.id.strip_prefix(prefix).is_some_and(|rest| rest.starts_with('-') && rest.len() > 1) {
            let error =
                Diagnostic::error(Code::BadId, format!("the id of {} begins with `{prefix}-`", kind_word(kind)));
            return self.diagnostics.push(error.at_place(&place));
        }
        self.define(&label.id, kind, number.clone(), place);
        self.labels.anchors.insert((self.index, at), Anchor { id: label.id.clone(), number });
    }
}

fn kind_word(kind: LabelKind) -> String {
    kind.word().to_lowercase()
}

/// The text of a heading as an id: lower-case letters and digits, joined by hyphens.
fn heading_slug(nodes: &[Node]) -> String {
    let slug = slug(nodes.iter().map(|node| match &node.what {
        What::Markdown(Event::Text(text) | Event::Code(text)) => text,
        _ => " ",
    }));
    if slug.is_empty() { "section".to_owned() } else { slug }
}
