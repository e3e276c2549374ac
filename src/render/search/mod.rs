//! The index of the search: a script, since a page opened from disk can load nothing else.
//!
//! It is one call with one object. `pages` are the pages, `kinds` the words for what can be found, and `entries` what can be found, in the
//! book's order: the kind and the page by their places in those lists, the id on the page, the number, the title, and what else is known
//! of it. `words` are the words of the chapters' text, sorted, each without what it shares with the one before; `posts` are the chapters and
//! sections that have them (see `posts`). What students do not get is not in the course that is rendered, and so not here.

mod posts;
mod words;

use std::fmt::Write as _;

use pulldown_cmark::{Event, Tag, TagEnd};
use serde_json::{Value, json};

use super::Rendering;
use super::markdown::Writer;
use super::matter;
use crate::catalogue::About;
use crate::parse::{Callout, CalloutKind, Node, What};
use crate::plan::{Exhibit, LabelKind, terms};
use crate::{integrands, kinds, metrics, samplers, scenes, scrambles};

use posts::Posts;

/// How many characters a reader sees of an exercise that has no title.
const OPENING: usize = 110;

/// What can be found.
struct Entry {
    kind: &'static str,
    page: String,
    id: String,
    number: String,
    title: String,
    more: String,
}

/// The index while it is gathered.
struct Gathering<'a> {
    rendering: &'a Rendering<'a>,
    entries: Vec<Entry>,
    posts: Posts,
    /// The place of the last chapter or section among those that have text.
    section: usize,
}

/// The path of the index in the book.
pub(super) const PATH: &str = "assets/search-index.js";

/// The file of the index: its path in the book, and its text.
pub(super) fn file(rendering: &Rendering<'_>) -> (String, String) {
    let posts = Posts::default();
    let mut gathering = Gathering { rendering, entries: Vec::new(), posts, section: 0 };
    for chapter in 0..rendering.course.chapters.len() {
        gathering.chapter(chapter);
    }
    gathering.catalogues();
    gathering.matter();
    (PATH.to_owned(), gathering.script())
}

impl Gathering<'_> {
    fn enter(&mut self, kind: &'static str, page: &str, id: &str, title: String) -> &mut Entry {
        let (page, id) = (page.to_owned(), id.to_owned());
        let at = self.entries.len();
        self.entries.push(Entry { kind, page, id, number: String::new(), title, more: String::new() });
        &mut self.entries[at]
    }

    fn plain(&self, chapter: usize, nodes: &[Node]) -> String {
        words::plain(nodes, &|node| Writer::new(self.rendering, chapter).inline(std::slice::from_ref(node)).0)
    }

    fn chapter(&mut self, index: usize) {
        let rendering = self.rendering;
        let chapter = &rendering.course.chapters[index];
        let page = rendering.href(index);
        let entry = self.enter(chapter.word(), &page, "", chapter.front.title.clone());
        entry.number.clone_from(&chapter.number);
        entry.more.clone_from(&chapter.front.summary);
        self.section = self.posts.open();
        let nodes = &chapter.content.nodes;
        let mut at = 0;
        while let Some(node) = nodes.get(at) {
            if let What::Markdown(Event::Start(Tag::Heading { .. })) = &node.what {
                at = self.heading(index, &page, at);
            } else {
                self.node(index, &page, node, Some(at));
            }
            at += 1;
        }
    }

    /// The section that begins at the node `at`; gives the node where its title ends.
    fn heading(&mut self, chapter: usize, page: &str, at: usize) -> usize {
        let sections = self.rendering.plan.labels.sections(chapter);
        let Some(section) = sections.iter().find(|section| section.title.start == at + 1) else { return at };
        let nodes = &self.rendering.course.chapters[chapter].content.nodes;
        let title = self.plain(chapter, &nodes[section.title.clone()]);
        // Every page of a catalogue's member has the same sections: the page itself is what is looked for.
        if !self.rendering.course.chapters[chapter].member {
            self.enter("Section", page, &section.id, title).number.clone_from(&section.number);
            self.section = self.posts.open();
        }
        section.title.end
    }

    fn node(&mut self, chapter: usize, page: &str, node: &Node, at: Option<usize>) {
        let rendering = self.rendering;
        let of = |all: &[Vec<Option<usize>>], fence: usize| all.get(chapter)?.get(fence).copied().flatten();
        match &node.what {
            What::Markdown(Event::Text(text) | Event::Code(text)) => self.posts.add(self.section, text),
            What::Term(term) => {
                if term.defines {
                    let key = terms::key(term);
                    let definition =
                        rendering.plan.terms.definition(&key).filter(|found| found.spot.chapter == chapter);
                    if let Some(definition) = definition {
                        let title = self.plain(chapter, &definition.head);
                        self.enter("Term", page, &terms::id(&key), title);
                    }
                }
                term.words.iter().for_each(|node| self.node(chapter, page, node, None));
            }
            What::CalloutStart(callout) => self.callout(chapter, page, callout, at),
            What::Equation { label: Some(_), .. } => {
                if let Some(anchor) = at.and_then(|at| rendering.plan.labels.anchor(chapter, at)) {
                    self.enter("Equation", page, &anchor.id, String::new()).number.clone_from(&anchor.number);
                }
            }
            What::Experiment(fence) => {
                let exhibit = of(&rendering.plan.exhibit_of, *fence).and_then(|at| rendering.plan.exhibits.get(at));
                let Some(exhibit) = exhibit else { return };
                let methods = methods(exhibit).join(" ");
                let title = self.plain(chapter, &exhibit.caption);
                self.labelled(page, &exhibit.id, title, methods);
                self.terms_of(chapter, page, &exhibit.caption);
            }
            What::Listing(fence) => {
                let listing = of(&rendering.plan.listing_of, *fence).and_then(|at| rendering.plan.listings.get(at));
                let Some(listing) = listing else { return };
                let file = listing.source.rsplit_once(':').map_or(listing.source.as_str(), |(file, _)| file);
                let title = self.plain(chapter, &listing.caption);
                self.labelled(page, &listing.id, title, file.to_owned());
                self.terms_of(chapter, page, &listing.caption);
            }
            _ => {}
        }
    }

    /// The terms that a caption defines; its words are in its entry already.
    fn terms_of(&mut self, chapter: usize, page: &str, caption: &[Node]) {
        for node in caption {
            if matches!(&node.what, What::Term(_)) {
                self.node(chapter, page, node, None);
            }
        }
    }

    /// An exhibit or listing, by the number that it has.
    fn labelled(&mut self, page: &str, id: &str, title: String, more: String) {
        let target = self.rendering.plan.labels.target(id);
        let (kind, number) = target.map_or(("", String::new()), |target| (target.kind.word(), target.number.clone()));
        let entry = self.enter(kind, page, id, title);
        entry.number = number;
        entry.more = more;
    }

    fn callout(&mut self, chapter: usize, page: &str, callout: &Callout, at: Option<usize>) {
        let anchor = at.and_then(|at| self.rendering.plan.labels.anchor(chapter, at));
        let kind = match callout.kind {
            CalloutKind::Exercise => Some(LabelKind::Exercise),
            CalloutKind::Definition => Some(LabelKind::Definition),
            _ => None,
        };
        if let (Some(anchor), Some(kind), Some(at)) = (anchor, kind, at) {
            let title = self.plain(chapter, &callout.title);
            let more = if title.is_empty() { self.opening(chapter, at) } else { String::new() };
            let entry = self.enter(kind.word(), page, &anchor.id, title);
            entry.number.clone_from(&anchor.number);
            entry.more = more;
        }
        callout.title.iter().for_each(|node| self.node(chapter, page, node, None));
    }

    /// The first words behind the node `at`: those of a paragraph.
    fn opening(&self, chapter: usize, at: usize) -> String {
        let nodes = self.rendering.course.chapters[chapter].content.nodes.get(at + 1..).unwrap_or_default();
        let end = |node: &Node| {
            matches!(
                &node.what,
                What::Markdown(Event::End(TagEnd::Paragraph)) | What::CalloutStart(_) | What::CalloutEnd(_)
            )
        };
        let length = nodes.iter().position(end).unwrap_or(nodes.len());
        words::shortened(&self.plain(chapter, &nodes[..length]), OPENING)
    }

    /// Members of catalogues that an exhibit uses and that have no page of their own: the first such exhibit has the method's name.
    fn catalogues(&mut self) {
        let rendering = self.rendering;
        let catalogues: [(&'static str, Vec<&'static About>); 5] = [
            ("Sampler", samplers::SAMPLERS.iter().map(|entry| entry.about()).collect()),
            ("Scramble", scrambles::SCRAMBLES.iter().map(|entry| entry.about()).collect()),
            ("Integrand", integrands::INTEGRANDS.iter().map(|entry| entry.about()).collect()),
            ("Measure", metrics::METRICS.iter().map(|entry| entry.about()).collect()),
            ("Scene", scenes::SCENES.iter().map(|entry| entry.about()).collect()),
        ];
        let used: Vec<(&Exhibit, Vec<String>)> =
            rendering.plan.exhibits.iter().map(|exhibit| (exhibit, methods(exhibit))).collect();
        for (kind, abouts) in catalogues {
            for about in abouts {
                let own = format!("{}-{}", kind.to_lowercase(), about.key);
                if rendering.course.chapters.iter().any(|chapter| chapter.slug == own) {
                    continue;
                }
                let first = used.iter().find(|(_, methods)| methods.iter().any(|method| method == about.key));
                let Some((exhibit, _)) = first else { continue };
                let page = rendering.href(exhibit.chapter);
                let more = format!("{}: {}", about.key, about.summary);
                self.enter(kind, &page, &exhibit.id, about.title.to_owned()).more = more;
            }
        }
    }

    /// The pages that the book makes of itself, and the kinds of experiments.
    fn matter(&mut self) {
        for page in matter::of(self.rendering) {
            self.enter("Page", page.href, "", page.title.to_owned()).more.push_str(page.summary);
        }
        for kind in kinds::KINDS {
            let about = kind.about();
            let entry = self.enter("Kind of experiment", matter::KINDS.href, about.key, about.title.to_owned());
            entry.more = format!("{}: {}", about.key, about.summary);
        }
    }

    fn script(self) -> String {
        let (mut kinds, mut pages): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
        let mut entries = Vec::new();
        for entry in &self.entries {
            let kind = place(&mut kinds, entry.kind);
            let page = place(&mut pages, &entry.page);
            let mut row = vec![json!(kind), json!(page)];
            let texts = [&entry.id, &entry.number, &entry.title, &entry.more];
            let last = texts.iter().rposition(|text| !text.is_empty()).map_or(0, |last| last + 1);
            row.extend(texts[..last].iter().map(|text| json!(text)));
            entries.push(Value::Array(row));
        }
        let (words, posts, common) = self.posts.encoded();
        // The names in the order in which they are told above; each on a line of its own, so that changes can be read.
        let mut script = String::from("workbook.search.load({\n");
        let parts = [
            ("pages", json!(pages)),
            ("kinds", json!(kinds)),
            ("entries", json!(entries)),
            ("words", json!(words)),
            ("posts", json!(posts)),
            ("common", json!(common)),
        ];
        for (name, value) in parts {
            // Writing to a string cannot fail.
            let _ = writeln!(script, "\"{name}\":{value},");
        }
        script.truncate(script.len() - ",\n".len());
        script.push_str("\n});\n");
        script
    }
}

/// The place of `name` in `list`, which gets it if it does not have it.
fn place<'n>(list: &mut Vec<&'n str>, name: &'n str) -> usize {
    list.iter().position(|known| *known == name).unwrap_or_else(|| {
        list.push(name);
        list.len() - 1
    })
}

/// The names of the methods that an exhibit is made with, as catalogues know them: the parts of `sobol+owen`, without what is in parentheses.
fn methods(exhibit: &Exhibit) -> Vec<String> {
    fn gather(value: &Value, found: &mut Vec<String>) {
        match value {
            Value::String(text) => {
                let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
                let parts = text.split('+').map(|part| part.split('(').next().unwrap_or_default());
                found.extend(parts.filter(|part| !part.is_empty() && part.chars().all(plain)).map(str::to_owned));
            }
            Value::Array(items) => items.iter().for_each(|item| gather(item, found)),
            _ => {}
        }
    }
    const NAMES: [&str; 9] =
        ["sampler", "samplers", "scramble", "scrambles", "integrand", "integrands", "metric", "metrics", "scene"];
    let parameters = exhibit.experiment.parameters();
    let mut found = Vec::new();
    NAMES.iter().filter_map(|name| parameters.get(name)).for_each(|value| gather(value, &mut found));
    let mut seen = std::collections::BTreeSet::new();
    found.retain(|name| seen.insert(name.clone()));
    found
}
