//! Terms: where each is defined, once in the book, and the sections that use it.

use std::collections::BTreeMap;
use std::sync::Arc;

use pulldown_cmark::{Event, Tag, TagEnd};

use super::Plan;
use super::slug::slug;
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic, Place};
use crate::parse::{Callout, Course, Node, Term, What};
use crate::workspace::Workspace;

/// The terms of a book by their keys.
#[derive(Debug, Clone, Default)]
pub struct Terms {
    definitions: BTreeMap<String, Definition>,
}

/// A term where it is defined.
#[derive(Debug, Clone)]
pub struct Definition {
    /// Its head-word.
    pub head: Vec<Node>,
    /// The head-word's slug, which puts it in its place in the alphabet.
    pub order: String,
    /// Where it is defined.
    pub spot: Spot,
    /// The same in the chapter's file.
    pub place: Place,
    /// Where else it is used, in the book's order, each once.
    pub uses: Vec<Spot>,
}

/// A section, or a chapter before its first section.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Spot {
    /// The index of the chapter.
    pub chapter: usize,
    /// The section's index in the chapter.
    pub section: Option<usize>,
}

impl Terms {
    /// Whether the book has no terms.
    pub fn is_empty(&self) -> bool {
        self.definitions.is_empty()
    }

    /// The definition of the term with this key.
    pub fn definition(&self, key: &str) -> Option<&Definition> {
        self.definitions.get(key)
    }

    /// Every term with its key, in alphabetical order.
    pub fn alphabetical(&self) -> Vec<(&str, &Definition)> {
        let mut terms: Vec<_> = self.definitions.iter().map(|(key, definition)| (key.as_str(), definition)).collect();
        terms.sort_by_key(|(key, definition)| (&definition.order, *key));
        terms
    }

    /// The ids of the definitions in a chapter.
    pub fn ids_in(&self, chapter: usize) -> impl Iterator<Item = String> {
        let own = self.definitions.iter().filter(move |(_, definition)| definition.spot.chapter == chapter);
        own.map(|(key, _)| id(key))
    }
}

/// The key of a term: what its address says, else the slug of its head-word.
pub fn key(term: &Term) -> String {
    if !term.key.is_empty() {
        return slug([term.key.as_str()]);
    }
    order(term)
}

/// The id of a definition on its page.
pub fn id(key: &str) -> String {
    format!("term-{key}")
}

/// The slug of a term's head-word.
fn order(term: &Term) -> String {
    if !term.title.is_empty() {
        return slug([term.title.as_str()]);
    }
    slug(term.words.iter().map(|node| match &node.what {
        What::Markdown(Event::Text(text) | Event::Code(text)) => text,
        What::Formula(formula) => formula.tex.as_str(),
        What::Markdown(Event::Start(_) | Event::End(_)) => "",
        _ => " ",
    }))
}

/// The head-word of a term: the title of its link, else its words without their emphasis.
fn head(term: &Term, place: &Place) -> Vec<Node> {
    if !term.title.is_empty() {
        let what = What::Markdown(Event::Text(term.title.clone().into()));
        return vec![Node { what, range: place.range.clone() }];
    }
    let stress = |what: &What| matches!(what, What::Markdown(Event::Start(_) | Event::End(_)));
    term.words.iter().filter(|node| !stress(&node.what)).cloned().collect()
}

/// Finds the terms of the book. What is defined twice or nowhere, and what stands where no term can stand, is told.
pub(super) fn find(course: &Course, plan: &Plan, workspace: &Workspace, diagnostics: &mut Vec<Diagnostic>) -> Terms {
    let mut found = Vec::new();
    for (index, chapter) in course.chapters.iter().enumerate() {
        let spot = Spot { chapter: index, section: None };
        let mut walk = Walk { plan, file: &chapter.file, spot, heading: false, found: &mut found, diagnostics };
        for (at, node) in chapter.content.nodes.iter().enumerate() {
            walk.node(node, Some(at));
        }
        plan.seen.captions(index).for_each(|caption| walk.nodes(caption));
    }
    let mut terms = Terms::default();
    for found in found.iter().filter(|found| found.term.defines) {
        define(found, &mut terms, plan, workspace, diagnostics);
    }
    for found in found.iter().filter(|found| !found.term.defines) {
        match terms.definitions.get_mut(&found.key) {
            Some(definition) if definition.spot != found.spot => definition.uses.push(found.spot),
            Some(_) => {}
            None => diagnostics.push(unknown(found, &terms)),
        }
    }
    for definition in terms.definitions.values_mut() {
        definition.uses.sort_unstable();
        definition.uses.dedup();
    }
    terms
}

/// A term where it stands.
struct Found<'a> {
    term: &'a Term,
    key: String,
    spot: Spot,
    place: Place,
}

/// The walk over one chapter, in the order of reading.
struct Walk<'a, 'd> {
    plan: &'a Plan,
    file: &'a Arc<str>,
    spot: Spot,
    heading: bool,
    found: &'d mut Vec<Found<'a>>,
    diagnostics: &'d mut Vec<Diagnostic>,
}

impl<'a> Walk<'a, '_> {
    fn nodes(&mut self, nodes: &'a [Node]) {
        for node in nodes {
            self.node(node, None);
        }
    }

    fn node(&mut self, node: &'a Node, at: Option<usize>) {
        match &node.what {
            What::Markdown(Event::Start(Tag::Heading { .. })) => {
                self.heading = true;
                let sections = self.plan.labels.sections(self.spot.chapter);
                let section = sections.iter().position(|section| at == section.title.start.checked_sub(1));
                self.spot.section = section.or(self.spot.section);
            }
            What::Markdown(Event::End(TagEnd::Heading(_))) => self.heading = false,
            What::Term(term) => self.term(term, node),
            What::CalloutStart(Callout { title, .. }) => self.nodes(title),
            What::Experiment(fence) => {
                let of = |index: &usize| self.plan.exhibits.get(*index).map(|exhibit| exhibit.caption.as_slice());
                self.nodes(self.fenced(&self.plan.exhibit_of, *fence).as_ref().and_then(of).unwrap_or_default());
            }
            What::Listing(fence) => {
                let of = |index: &usize| self.plan.listings.get(*index).map(|listing| listing.caption.as_slice());
                self.nodes(self.fenced(&self.plan.listing_of, *fence).as_ref().and_then(of).unwrap_or_default());
            }
            _ => {}
        }
    }

    /// What a fence of the chapter became, if it is right.
    fn fenced(&self, of: &[Vec<Option<usize>>], fence: usize) -> Option<usize> {
        of.get(self.spot.chapter)?.get(fence).copied().flatten()
    }

    fn term(&mut self, term: &'a Term, node: &Node) {
        let place = Place { file: Arc::clone(self.file), range: node.range.clone() };
        let key = key(term);
        if self.heading {
            let error = Diagnostic::error(Code::Markup, "a term stands within a heading").at_place(&place);
            self.diagnostics.push(error.help("headings are links themselves: write it in the text below"));
        }
        if key.is_empty() || order(term).is_empty() {
            let error = Diagnostic::error(Code::BadId, "a term without a word").at_place(&place);
            let help =
                "write the word between the brackets: `[*stratum*](define:)`, or as the title: `(define: \"stratum\")`";
            return self.diagnostics.push(error.help(help));
        }
        self.found.push(Found { term, key, spot: self.spot, place });
    }
}

/// Enters a definition, unless there is one already.
fn define(found: &Found<'_>, terms: &mut Terms, plan: &Plan, workspace: &Workspace, told: &mut Vec<Diagnostic>) {
    let Found { term, key, spot, place } = found;
    if let Some(first) = terms.definitions.get(key) {
        let message = format!("the term `{key}` is defined twice");
        let help =
            format!("it is defined at {} already: link to it with `(term:{key})`", line(&first.place, workspace));
        return told.push(Diagnostic::error(Code::DuplicateId, message).at_place(place).help(help));
    }
    let id = id(key);
    if plan.labels.stands_in(spot.chapter, &id) {
        let message = format!("the id `{id}` of this term is that of a heading on this page");
        told.push(Diagnostic::error(Code::DuplicateId, message).at_place(place).help("give the heading another id"));
    }
    let definition =
        Definition { head: head(term, place), order: order(term), spot: *spot, place: place.clone(), uses: Vec::new() };
    terms.definitions.insert(key.clone(), definition);
}

fn unknown(found: &Found<'_>, terms: &Terms) -> Diagnostic {
    let key = &found.key;
    let near = nearest(key, terms.definitions.keys().map(String::as_str));
    let help = near.map_or_else(
        || "define it where it is introduced: `[*word*](define:)`".to_owned(),
        |near| format!("did you mean `(term:{near})`?"),
    );
    Diagnostic::error(Code::MissingTarget, format!("no term `{key}` is defined")).at_place(&found.place).help(help)
}

/// A place as people name it: the file and the line.
fn line(place: &Place, workspace: &Workspace) -> String {
    let text = workspace.excerpt(&place.file).unwrap_or_default();
    let lines = text.as_bytes().iter().take(place.range.start).filter(|&&byte| byte == b'\n').count();
    format!("{}:{}", place.file, lines + 1)
}
