//! Notes: a footnote stands at its first reference, from where the style puts it into the margin, or below the line where there is none.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::Range;

use pulldown_cmark::{Event, Tag, TagEnd};

use super::blocks;
use super::markdown::Writer;
use crate::parse::{Node, What};

/// The footnotes of a chapter, and where among its blocks the writer is.
#[derive(Default)]
pub(super) struct Notes {
    /// The nodes of each footnote: its definition without the markers of start and end.
    texts: BTreeMap<String, Range<usize>>,
    /// The footnotes in the order of their first references.
    order: Vec<String>,
    /// How often each has been referred to.
    references: BTreeMap<String, usize>,
    /// How many blocks are open.
    depth: usize,
    /// How many of the open elements can hold no note: headings, tables, links.
    narrow: usize,
    /// Notes that stand after the block that refers to them.
    pending: String,
}

impl Notes {
    /// The footnotes that a chapter defines.
    pub(super) fn of(nodes: &[Node]) -> Self {
        let mut texts = BTreeMap::new();
        for (at, node) in nodes.iter().enumerate() {
            if let What::Markdown(Event::Start(Tag::FootnoteDefinition(name))) = &node.what {
                texts.insert(name.to_string(), at + 1..blocks::end(nodes, at));
            }
        }
        Self { texts, ..Self::default() }
    }

    /// Keeps count of what is open when a node begins.
    pub(super) fn enter(&mut self, node: &Node) {
        match &node.what {
            What::Markdown(Event::Start(tag)) => {
                self.narrow += usize::from(matches!(tag, Tag::Heading { .. } | Tag::Table(_) | Tag::Link { .. }));
                self.depth += 1;
            }
            What::CalloutStart(_) => self.depth += 1,
            _ => {}
        }
    }

    /// Keeps count of what is open when a node has ended. Gives the notes that wait for the end of the outermost block.
    pub(super) fn leave(&mut self, node: &Node) -> String {
        match &node.what {
            What::Markdown(Event::End(tag)) => {
                let narrow = matches!(tag, TagEnd::Heading(_) | TagEnd::Table | TagEnd::Link);
                self.narrow = self.narrow.saturating_sub(usize::from(narrow));
                self.depth = self.depth.saturating_sub(1);
            }
            What::CalloutEnd(_) => self.depth = self.depth.saturating_sub(1),
            _ => return String::new(),
        }
        if self.depth == 0 { std::mem::take(&mut self.pending) } else { String::new() }
    }

    /// The number of the footnote `name`, and how often it has been referred to.
    fn refer(&mut self, name: &str) -> (usize, usize) {
        let number = self.order.iter().position(|other| other == name).unwrap_or_else(|| {
            self.order.push(name.to_owned());
            self.order.len() - 1
        });
        let count = self.references.entry(name.to_owned()).or_default();
        *count += 1;
        (number + 1, *count)
    }
}

impl Writer<'_> {
    /// A footnote's mark, and at its first the note. Captions and titles have no footnotes.
    pub(super) fn footnote_reference(&mut self, name: &str) {
        let Some(range) = self.notes.texts.get(name).cloned() else { return };
        let (number, count) = self.notes.refer(name);
        let suffix = if count > 1 { format!("-{count}") } else { String::new() };
        let _ = write!(
            self.out,
            "<sup class=\"footnote-reference\"><a href=\"#fn-{number}\" id=\"fnref-{number}{suffix}\" aria-label=\"Footnote {number}\">{number}</a></sup>"
        );
        if count == 1 {
            self.note(number, range);
        }
    }

    /// The note: within the line if it is one paragraph and the place allows it, else after the block.
    fn note(&mut self, number: usize, range: Range<usize>) {
        let short = self.notes.narrow == 0 && is_paragraph(&self.nodes()[range.clone()]);
        let page = std::mem::take(&mut self.out);
        self.range(range);
        let text = std::mem::replace(&mut self.out, page);
        let text = text.trim();
        let back = format!(
            "<a class=\"note-number\" href=\"#fnref-{number}\" aria-label=\"Back to the text of footnote {number}\">{number}</a> "
        );
        let inner = text.strip_prefix("<p>");
        if let Some(line) = inner.and_then(|inner| inner.strip_suffix("</p>")).filter(|_| short) {
            let _ = write!(self.out, "<span class=\"side-note\" role=\"note\" id=\"fn-{number}\">{back}{line}</span>");
            return;
        }
        let text = inner.map_or_else(|| format!("<p>{back}</p>{text}"), |inner| format!("<p>{back}{inner}"));
        let _ =
            writeln!(self.notes.pending, "<aside class=\"side-note\" role=\"note\" id=\"fn-{number}\">{text}</aside>");
    }
}

/// Whether these nodes are a single paragraph of nothing but text.
fn is_paragraph(nodes: &[Node]) -> bool {
    let block = |node: &Node| match &node.what {
        What::Markdown(Event::Start(tag)) => {
            !matches!(tag, Tag::Emphasis | Tag::Strong | Tag::Strikethrough | Tag::Link { .. } | Tag::Image { .. })
        }
        What::Equation { .. } | What::Experiment(_) | What::Listing(_) | What::CalloutStart(_) => true,
        _ => false,
    };
    let starts = nodes.first().is_some_and(|node| matches!(&node.what, What::Markdown(Event::Start(Tag::Paragraph))));
    starts && !nodes[1..].iter().any(block)
}
