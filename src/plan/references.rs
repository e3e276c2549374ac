//! What refers to something: references, citations, values and formulas, each checked before anything runs.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use pulldown_cmark::{Event, Tag};

use super::amount::Amount;
use super::claim::Bound;
use super::format::Format;
use super::formula::Converter;
use super::links::{self, BadLink};
use super::{Exhibit, Memo, Plan};
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic};
use crate::parse::{Callout, Chosen, Cited, Computed, Course, Formula, Node, ValueUse, What};
use crate::workspace::CONFIGURATION;

/// The exhibit and the value that a name in the brackets of an expression means: `fig-a.exact` is the value `exact` of `fig-a`. In a claim
/// a name that begins with no exhibit's id means a value of the exhibit itself, `home`.
pub fn address<'n>(name: &'n str, home: Option<&'n str>) -> Option<(&'n str, &'n str)> {
    let split = name.split_once('.').filter(|(exhibit, value)| !exhibit.is_empty() && !value.is_empty());
    match home {
        None => split,
        Some(home) => {
            let other = split.filter(|(exhibit, _)| exhibit.starts_with("fig-") || exhibit.starts_with("tbl-"));
            Some(other.unwrap_or((home, name)))
        }
    }
}

/// Checks everything that refers to something, in chapters, captions and titles.
pub(super) fn check(course: &Course, plan: &Plan, memo: &mut Memo, diagnostics: &mut Vec<Diagnostic>) {
    let converter = memo.converter(&course.configuration.macros, diagnostics);
    let places = RefCell::default();
    for (index, chapter) in course.chapters.iter().enumerate() {
        let file = &chapter.file;
        let mut checking = Checking { file, index, course, plan, converter: &converter, places: &places, diagnostics };
        checking.picture(chapter.front.picture.as_ref());
        checking.nodes(&chapter.content.nodes);
        for exhibit in plan.exhibits.iter().filter(|exhibit| exhibit.chapter == index) {
            checking.nodes(&exhibit.caption);
            checking.bounds(exhibit);
        }
        plan.seen.captions(index).for_each(|caption| checking.nodes(caption));
        for listing in plan.listings.iter().filter(|listing| listing.chapter == index) {
            checking.nodes(&listing.caption);
        }
    }
    let (file, index) = (Arc::from(CONFIGURATION), usize::MAX);
    let mut checking =
        Checking { file: &file, index, course, plan, converter: &converter, places: &places, diagnostics };
    for passage in &course.configuration.landing {
        checking.nodes(&passage.nodes);
    }
}

/// The ids on chapters' pages, in order and sorted, of those chapters that links have led to.
type Places = RefCell<BTreeMap<usize, (Vec<String>, BTreeSet<String>)>>;

struct Checking<'a> {
    file: &'a Arc<str>,
    /// The index of the chapter; what stands outside of chapters has one that none has.
    index: usize,
    course: &'a Course,
    plan: &'a Plan,
    converter: &'a Converter,
    places: &'a Places,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Checking<'_> {
    fn nodes(&mut self, nodes: &[Node]) {
        for node in nodes {
            match &node.what {
                What::Reference(id) => self.reference(id, &node.range),
                What::Citation(cited) => cited.iter().for_each(|cited| self.citation(cited)),
                What::Value(value) => self.value(value, &node.range),
                What::Computed(computed) => self.computed(computed, &node.range),
                What::Formula(formula) => self.formula(formula, false, &node.range),
                What::Equation { formula, .. } => self.formula(formula, true, &node.range),
                What::CalloutStart(Callout { title, .. }) => self.nodes(title),
                What::Term(term) => self.nodes(&term.words),
                What::Markdown(Event::Start(Tag::Link { dest_url, .. })) => self.link(dest_url, &node.range),
                _ => {}
            }
        }
    }

    fn tell(&mut self, code: Code, message: String, range: &Range<usize>, help: impl IntoIterator<Item = String>) {
        let mut diagnostic = Diagnostic::error(code, message).at(self.file, range.clone());
        diagnostic.help.extend(help);
        self.diagnostics.push(diagnostic);
    }

    /// The exhibit that stands for the chapter: one of its own. Whether it has a drawing is known once it has run.
    fn picture(&mut self, chosen: Option<&Chosen>) {
        let Some(Chosen { id, range }) = chosen else { return };
        let own = || self.plan.exhibits.iter().filter(|exhibit| exhibit.chapter == self.index);
        if own().any(|exhibit| exhibit.id == *id) || self.plan.seen.is_wrong(id) {
            return;
        }
        let near = nearest(id, own().map(|exhibit| exhibit.id.as_str())).map(|near| format!("did you mean `{near}`?"));
        self.tell(Code::MissingTarget, format!("the chapter has no exhibit `{id}` to stand for it"), range, near);
    }

    fn reference(&mut self, id: &str, range: &Range<usize>) {
        if self.plan.labels.target(id).is_none() && !self.plan.seen.is_wrong(id) {
            let near = nearest(id, self.plan.labels.ids()).map(|near| format!("did you mean `@{near}`?"));
            self.tell(Code::MissingTarget, format!("nothing in the book has the id `{id}`"), range, near);
        }
    }

    fn citation(&mut self, cited: &Cited) {
        if self.plan.bibliography.is_whole() && !self.plan.bibliography.contains(&cited.key) {
            let near =
                nearest(&cited.key, self.plan.bibliography.keys()).map(|near| format!("did you mean `@{near}`?"));
            let message = format!("the bibliography has no work `{}`", cited.key);
            self.tell(Code::UnknownCitation, message, &cited.range, near);
        }
    }

    /// The exhibit of a value; whether it gives the value is known once it has run.
    fn value(&mut self, value: &ValueUse, range: &Range<usize>) {
        self.exhibit(&value.exhibit, range);
        self.format(&value.format, range);
    }

    fn exhibit(&mut self, id: &str, range: &Range<usize>) {
        if self.plan.exhibit(id).is_none() && !self.plan.seen.is_wrong(id) {
            let ids = self.plan.exhibits.iter().map(|exhibit| exhibit.id.as_str());
            let near = nearest(id, ids).map(|near| format!("did you mean `{near}`?"));
            self.tell(Code::UnknownValue, format!("there is no exhibit `{id}`"), range, near);
        }
    }

    fn format(&mut self, format: &str, range: &Range<usize>) -> Option<Format> {
        let parsed = Format::parse(format);
        if let Err(message) = &parsed {
            let help = "formats are `.3` decimals, `.3e` powers of ten, `.3g` significant digits, `.1%` per cent, `d` a whole number, `.3±` with its standard error";
            self.tell(Code::Format, message.clone(), range, [help.to_owned()]);
        }
        parsed.ok()
    }

    /// The exhibits of an expression in the text; whether they give the values is known once they have run.
    fn computed(&mut self, computed: &Computed, range: &Range<usize>) {
        for (name, place) in computed.calculation.names() {
            let place = computed.place(&place, range);
            if let Some((exhibit, _)) = address(name, None) {
                self.exhibit(exhibit, &place);
            } else {
                let help = "write an exhibit, a dot, the value's name: `[fig-id.value.name]`".to_owned();
                self.tell(Code::UnknownValue, format!("`[{name}]` names no value"), &place, [help]);
            }
        }
        if matches!(self.format(&computed.format, range), Some(Format::WithError(_))) {
            let help = "write the decimals alone, `.3`".to_owned();
            self.tell(Code::Format, "a computed number has no standard error".to_owned(), range, [help]);
        }
    }

    /// The other exhibits that the bounds of an exhibit's claims name.
    fn bounds(&mut self, exhibit: &Exhibit) {
        let amounts = exhibit.claims.iter().flat_map(|claim| &claim.bounds).flat_map(Bound::amounts);
        for (name, place) in amounts.flat_map(Amount::names) {
            if let Some((other, _)) = address(name, Some(&exhibit.id)) {
                self.exhibit(other, &place);
            }
        }
    }

    fn link(&mut self, url: &str, range: &Range<usize>) {
        match links::resolve(url, self.course) {
            Ok(address) => self.fragment(&address, range),
            Err(BadLink::Scheme) => {
                let help = "links are of the kinds `http`, `https` and `mailto`, or lead to a place in the book";
                self.tell(
                    Code::Markup,
                    format!("`{url}` is of a kind that a page must not hold"),
                    range,
                    [help.to_owned()],
                );
            }
            Err(BadLink::NoChapter) => {
                let stems = self.course.chapters.iter().map(|chapter| chapter.stem.as_str());
                let near = nearest(url, stems).map(|near| format!("did you mean `{near}.md`?"));
                self.tell(Code::BrokenLink, format!("the book has no chapter `{url}`"), range, near);
            }
        }
    }

    /// The place on a chapter's page that an address in the book names.
    fn fragment(&mut self, address: &str, range: &Range<usize>) {
        let Some((page, id)) = address.split_once('#') else { return };
        let chapter = match page.strip_suffix(".html") {
            Some(slug) => self.course.chapters.iter().position(|chapter| chapter.slug == slug),
            None => page.is_empty().then_some(self.index),
        };
        // Raw HTML may have ids that the plan does not know; the finished book is checked again.
        let Some(chapter) = chapter.filter(|_| !self.course.configuration.allow_html) else { return };
        let places = self.places;
        let mut places = places.borrow_mut();
        let (ids, known) = places.entry(chapter).or_insert_with(|| {
            let labels = self.plan.labels.ids_in(chapter).map(str::to_owned);
            let ids: Vec<String> = labels.chain(self.plan.terms.ids_in(chapter)).collect();
            let known = ids.iter().cloned().collect();
            (ids, known)
        });
        if !known.contains(id) && !self.plan.seen.is_wrong(id) {
            let near = nearest(id, ids.iter().map(String::as_str)).map(|near| format!("did you mean `#{near}`?"));
            let file = &self.course.chapters[chapter].file;
            self.tell(Code::BrokenLink, format!("`{file}` has no place `#{id}`"), range, near);
        }
    }

    fn formula(&mut self, formula: &Formula, display: bool, range: &Range<usize>) {
        if let Some(error) = self.converter.error(&formula.tex, display) {
            let place = formula.map.range(error.range);
            let place = if place.is_empty() { range.clone() } else { place };
            self.tell(Code::Math, format!("the formula cannot be read: {}", error.message), &place, None);
        }
    }
}
