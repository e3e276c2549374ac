//! The lint `typed-number`: numbers in prose that an experiment or an expression could give.
//!
//! It reads what readers read as text: paragraphs, lists, tables, callouts, captions and their formulas; no code, headings or titles of works.

use std::ops::Range;
use std::sync::Arc;

use pulldown_cmark::{Event, LinkType, Tag, TagEnd};

use super::literal::{self, END, HOLE, MATH};
use super::{Memo, Plan};
use crate::diag::{Code, Diagnostic};
use crate::parse::{Callout, Chapter, Course, Formula, Given, Node, SourceMap, What};
use crate::workspace::Workspace;

/// Tells every typed number that the chapter's front matter does not give, and every entry there that nothing uses.
pub(super) fn check(
    course: &Course,
    plan: &Plan,
    workspace: &Workspace,
    memo: &mut Memo,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let Some(severity) = course.configuration.typed_numbers else { return };
    // What code wrote quotes the code's own manual.
    let written = course.chapters.iter().enumerate().filter(|(_, chapter)| chapter.shelf.is_none());
    for (index, chapter) in written {
        memo.once(chapter, "typed", diagnostics, |told| {
            let found = read(chapter, index, plan, workspace);
            told.extend(tell(chapter, found).map(|warning| Diagnostic { severity, ..warning }));
        });
    }
}

/// The numbers of a chapter, with their places in its file.
fn read(chapter: &Chapter, index: usize, plan: &Plan, workspace: &Workspace) -> Vec<(String, Range<usize>)> {
    let text = workspace.text(&chapter.file).map(|source| &*source.text).unwrap_or_default();
    let mut reading = Reading { text, stream: Stream::default(), found: Vec::new() };
    reading.nodes(&chapter.content.nodes);
    for exhibit in plan.exhibits.iter().filter(|exhibit| exhibit.chapter == index) {
        reading.nodes(&exhibit.caption);
    }
    for listing in plan.listings.iter().filter(|listing| listing.chapter == index) {
        reading.nodes(&listing.caption);
    }
    plan.seen.captions(index).for_each(|caption| reading.nodes(caption));
    reading.found
}

/// What to tell of the numbers `found` in a chapter.
fn tell(chapter: &Chapter, found: Vec<(String, Range<usize>)>) -> impl Iterator<Item = Diagnostic> + '_ {
    let given: Vec<String> = chapter.front.given.iter().map(|given| literal::normal(&given.literal)).collect();
    let normal: Vec<String> = found.iter().map(|(literal, _)| literal::normal(literal)).collect();
    let unused = |(at, _): &(usize, &Given)| !normal.contains(&given[*at]);
    let unused: Vec<&Given> = chapter.front.given.iter().enumerate().filter(unused).map(|(_, given)| given).collect();
    let typed = found.into_iter().zip(normal).filter(move |(_, normal)| !given.contains(normal));
    let typed = typed.map(|((literal, range), _)| typed_number(&literal, &chapter.file, range));
    typed.chain(unused.into_iter().map(|given| unused_given(given, &chapter.file)))
}

fn typed_number(literal: &str, file: &Arc<str>, range: Range<usize>) -> Diagnostic {
    let quote = if literal.contains('\\') { '\'' } else { '"' };
    Diagnostic::warning(Code::TypedNumber, format!("typed-number: `{literal}` is typed, where it could be computed"))
        .at(file, range)
        .help("take it from an exhibit, `=fig-id.value.name:.3`, or compute it, `=(1/sqrt([fig-id.value.name])):.3`")
        .help("what is exact is written as a fraction, 1/2; a measured number can be told in words beside its figure")
        .help(format!(
            "history, definitions and quotations stand in the front matter: `[given]`, `{quote}{literal}{quote} = \"the reason\"`"
        ))
}

fn unused_given(given: &Given, file: &Arc<str>) -> Diagnostic {
    let message = format!("typed-number: nothing in this chapter is `{}`", given.literal);
    Diagnostic::warning(Code::UnusedGiven, message)
        .at(file, given.range.clone())
        .help("remove it, or write it as it stands in the text, with `per cent` or `times` where that follows")
}

/// The walk over a chapter.
struct Reading<'a> {
    /// The chapter's file.
    text: &'a str,
    /// The text of the block that is being read.
    stream: Stream,
    /// The numbers, with their places in the file.
    found: Vec<(String, Range<usize>)>,
}

/// The text of a block, with marks for what is no text, and where it stands in the file.
#[derive(Default)]
struct Stream {
    text: String,
    map: SourceMap,
}

impl Stream {
    fn push(&mut self, text: &str, range: Range<usize>) {
        self.map.push(self.text.len(), range);
        self.text.push_str(text);
    }
}

impl Reading<'_> {
    /// Reads blocks, or a line that is a block by itself.
    fn nodes(&mut self, nodes: &[Node]) {
        self.within(nodes);
        self.flush();
    }

    fn within(&mut self, nodes: &[Node]) {
        // Within what is not read, the tag that ends it.
        let mut silent: Option<TagEnd> = None;
        for node in nodes {
            if let Some(end) = silent {
                silent = silent.filter(|_| node.what != What::Markdown(Event::End(end)));
                continue;
            }
            match &node.what {
                What::Markdown(Event::Start(tag)) if is_silent(tag) => {
                    silent = Some(tag.to_end());
                    self.stream.push(HOLE.encode_utf8(&mut [0; 4]), node.range.clone());
                }
                What::CalloutStart(Callout { title, .. }) => {
                    self.flush();
                    self.nodes(title);
                }
                What::Term(term) => self.within(&term.words),
                _ => self.node(node),
            }
        }
    }

    fn node(&mut self, node: &Node) {
        match &node.what {
            What::Markdown(Event::Text(text)) => self.words(text, &node.range),
            What::Markdown(Event::SoftBreak | Event::HardBreak) => self.stream.push(" ", node.range.clone()),
            What::Markdown(Event::Start(tag)) if is_inline(tag.to_end()) => {}
            What::Markdown(Event::End(tag)) if is_inline(*tag) => {}
            What::Formula(formula) => self.formula(formula, &node.range),
            What::Equation { formula, .. } => {
                self.flush();
                self.formula(formula, &node.range);
                self.flush();
            }
            What::Markdown(Event::Start(_) | Event::End(_) | Event::Rule)
            | What::Experiment(_)
            | What::Listing(_)
            | What::CalloutStart(_)
            | What::CalloutEnd(_) => self.flush(),
            _ => self.stream.push(HOLE.encode_utf8(&mut [0; 4]), node.range.clone()),
        }
    }

    /// Text, as it is in the file: markdown makes other signs of quotes and escapes, and then places would be lost.
    fn words(&mut self, text: &str, range: &Range<usize>) {
        let digits = |text: &str| text.chars().filter(char::is_ascii_digit).collect::<String>();
        let raw = self.text.get(range.clone()).filter(|raw| digits(raw) == digits(text));
        self.stream.push(raw.unwrap_or(text), range.clone());
    }

    fn formula(&mut self, formula: &Formula, range: &Range<usize>) {
        let place = formula.map.range(0..formula.tex.len());
        self.stream.push(MATH.encode_utf8(&mut [0; 4]), range.start..place.start);
        self.stream.push(&formula.tex, place.clone());
        self.stream.push(END.encode_utf8(&mut [0; 4]), place.end..range.end);
    }

    /// Ends a block: its numbers are found.
    fn flush(&mut self) {
        let Stream { text, map } = std::mem::take(&mut self.stream);
        for range in literal::find(&text) {
            let literal: String = text[range.clone()].chars().filter(|&c| c != MATH && c != END).collect();
            self.found.push((literal, map.range(range)));
        }
    }
}

/// Whether what `tag` encloses is not read as text.
fn is_silent(tag: &Tag<'_>) -> bool {
    matches!(
        tag,
        Tag::Heading { .. }
            | Tag::CodeBlock(_)
            | Tag::Image { .. }
            | Tag::Link { link_type: LinkType::Autolink | LinkType::Email, .. }
    )
}

/// Whether text goes on behind `tag`.
fn is_inline(tag: TagEnd) -> bool {
    matches!(tag, TagEnd::Emphasis | TagEnd::Strong | TagEnd::Strikethrough | TagEnd::Link)
}
