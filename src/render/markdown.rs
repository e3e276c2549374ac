//! From nodes to HTML: one function per kind of node.

use std::fmt::Write as _;
use std::ops::Range;

use pulldown_cmark::{Alignment, CodeBlockKind, Event, HeadingLevel, Tag, TagEnd};

use super::inline::{Hold, inline_code};
use super::notes::Notes;
use super::{Rendering, blocks, code};
use crate::diag::Diagnostic;
use crate::exhibits;
use crate::kinds::Measured;
use crate::parse::{Computed, Formula, Label, Node, Term, ValueUse, What};
use crate::plan::{Format, escape, links, terms};

/// Writes the nodes of one chapter.
pub(super) struct Writer<'a> {
    pub(super) rendering: &'a Rendering<'a>,
    pub(super) chapter: usize,
    pub(super) out: String,
    /// The node being written, as an index into the chapter; none within captions and titles.
    pub(super) at: Option<usize>,
    pub(super) notes: Notes,
    table: TableState,
    /// What holds the last formula and the words after it together.
    pub(super) hold: Hold,
    /// The block of code being written.
    code: Option<code::Fence>,
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// Where in a markdown table the writer is.
#[derive(Default)]
struct TableState {
    alignments: Vec<Alignment>,
    column: usize,
    head: bool,
}

impl<'a> Writer<'a> {
    pub(super) fn new(rendering: &'a Rendering<'a>, chapter: usize) -> Self {
        Self {
            rendering,
            chapter,
            out: String::new(),
            at: None,
            notes: Notes::default(),
            table: TableState::default(),
            hold: Hold::Free,
            code: None,
            diagnostics: Vec::new(),
        }
    }

    /// A writer of what stands outside of chapters: there, everything that is referred to is on another page.
    pub(super) fn outside(rendering: &'a Rendering<'a>) -> Self {
        Self::new(rendering, usize::MAX)
    }

    /// The whole chapter.
    pub(super) fn chapter(mut self) -> (String, Vec<Diagnostic>) {
        let nodes = self.nodes();
        self.notes = Notes::of(nodes);
        let mark = if self.rendering.marked { super::MARK } else { "" };
        self.out.push_str(mark);
        let mut at = 0;
        while at < nodes.len() {
            let end = blocks::end(nodes, at) + 1;
            self.range(at..end);
            self.out.push_str(mark);
            at = end;
        }
        self.done()
    }

    /// The nodes of the chapter; none outside of chapters.
    pub(super) fn nodes(&self) -> &'a [Node] {
        self.rendering.course.chapters.get(self.chapter).map_or(&[], |chapter| &chapter.content.nodes)
    }

    /// Writes some nodes of the chapter. What footnotes say is written where they are first referred to.
    pub(super) fn range(&mut self, range: Range<usize>) {
        let nodes = self.nodes();
        let outside = self.at;
        let mut at = range.start;
        while at < range.end {
            let node = &nodes[at];
            if matches!(&node.what, What::Markdown(Event::Start(Tag::FootnoteDefinition(_)))) {
                at = blocks::end(nodes, at) + 1;
                continue;
            }
            self.at = Some(at);
            self.notes.enter(node);
            self.node(node, nodes.get(at + 1));
            let notes = self.notes.leave(node);
            self.out.push_str(&notes);
            at += 1;
        }
        self.at = outside;
    }

    /// What has been written, and what there is to complain of.
    pub(super) fn done(self) -> (String, Vec<Diagnostic>) {
        (self.out, self.diagnostics)
    }

    /// Nodes that stand by themselves, such as a caption or a passage.
    pub(super) fn inline(mut self, nodes: &[Node]) -> (String, Vec<Diagnostic>) {
        for (at, node) in nodes.iter().enumerate() {
            self.node(node, nodes.get(at + 1));
        }
        self.done()
    }

    fn node(&mut self, node: &Node, next: Option<&Node>) {
        match &node.what {
            What::Markdown(event) => self.event(event),
            What::Formula(formula) => self.inline_formula(formula, next),
            What::Equation { formula, label } => self.equation(formula, label.as_ref()),
            What::Experiment(fence) => self.exhibit(*fence),
            What::Listing(fence) => self.listing(*fence),
            What::Value(value) => self.value(value),
            What::Computed(computed) => self.computed(computed),
            What::Reference(id) => self.reference(id),
            What::Citation(cited) => {
                let keys: Vec<String> = cited.iter().map(|cited| self.rendering.citations.link(cited)).collect();
                self.out.push_str(&keys.join(", "));
            }
            What::Term(term) => self.term(term, next),
            What::CalloutStart(callout) => self.callout(callout),
            What::CalloutEnd(kind) => self.callout_end(*kind),
        }
    }

    fn event(&mut self, event: &Event<'_>) {
        match event {
            Event::Start(tag) => self.start(tag),
            Event::End(tag) => self.end(*tag),
            Event::Text(text) => match &mut self.code {
                Some(code) => code.text.push_str(text),
                None => self.words(text),
            },
            Event::Code(code) => {
                self.out.push_str(&inline_code(code));
            }
            Event::Html(html) | Event::InlineHtml(html) => self.out.push_str(html),
            Event::SoftBreak => self.out.push('\n'),
            Event::HardBreak => self.out.push_str("<br>\n"),
            Event::Rule => self.out.push_str("<hr>\n"),
            Event::FootnoteReference(name) => self.footnote_reference(name),
            Event::TaskListMarker(done) => {
                let checked = if *done { " checked" } else { "" };
                let _ = write!(self.out, "<input type=\"checkbox\" disabled{checked}> ");
            }
            Event::InlineMath(_) | Event::DisplayMath(_) => {}
        }
    }

    fn start(&mut self, tag: &Tag<'_>) {
        match tag {
            Tag::Paragraph => self.out.push_str("<p>"),
            Tag::Heading { level, .. } => self.heading(*level),
            Tag::BlockQuote(_) => self.out.push_str("<blockquote>\n"),
            Tag::CodeBlock(CodeBlockKind::Fenced(info)) => self.code = Some(code::Fence::new(info)),
            Tag::CodeBlock(CodeBlockKind::Indented) => self.code = Some(code::Fence::new("")),
            Tag::List(None) => self.out.push_str("<ul>\n"),
            Tag::List(Some(1)) => self.out.push_str("<ol>\n"),
            Tag::List(Some(start)) => drop(writeln!(self.out, "<ol start=\"{start}\">")),
            Tag::Item => self.out.push_str("<li>"),
            Tag::Table(alignments) => {
                self.table = TableState { alignments: alignments.clone(), column: 0, head: false };
                self.out.push_str("<div class=\"table-wrap\"><table>\n");
            }
            Tag::TableHead => {
                self.table = TableState { head: true, column: 0, ..std::mem::take(&mut self.table) };
                self.out.push_str("<thead><tr>");
            }
            Tag::TableRow => {
                self.table.column = 0;
                self.out.push_str("<tr>");
            }
            Tag::TableCell => self.cell(),
            Tag::Emphasis => self.out.push_str("<em>"),
            Tag::Strong => self.out.push_str("<strong>"),
            Tag::Strikethrough => self.out.push_str("<del>"),
            Tag::Link { dest_url, title, .. } => self.link(dest_url, title),
            Tag::Image { dest_url, title, .. } => {
                let title = if title.is_empty() { String::new() } else { format!(" title=\"{}\"", escape(title)) };
                let _ = write!(self.out, "<img src=\"{}\"{title} alt=\"", escape(dest_url));
            }
            _ => {}
        }
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Paragraph => self.out.push_str("</p>\n"),
            TagEnd::Heading(level) => self.heading_end(level),
            TagEnd::BlockQuote(_) => self.out.push_str("</blockquote>\n"),
            TagEnd::CodeBlock => self.out.extend(self.code.take().map(|code| code.html())),
            TagEnd::List(false) => self.out.push_str("</ul>\n"),
            TagEnd::List(true) => self.out.push_str("</ol>\n"),
            TagEnd::Item => self.out.push_str("</li>\n"),
            TagEnd::Table => self.out.push_str("</tbody></table></div>\n"),
            TagEnd::TableHead => {
                self.table.head = false;
                self.out.push_str("</tr></thead>\n<tbody>\n");
            }
            TagEnd::TableRow => self.out.push_str("</tr>\n"),
            TagEnd::TableCell => {
                self.table.column += 1;
                self.out.push_str(if self.table.head { "</th>" } else { "</td>" });
            }
            TagEnd::Emphasis => self.out.push_str("</em>"),
            TagEnd::Strong => self.out.push_str("</strong>"),
            TagEnd::Strikethrough => self.out.push_str("</del>"),
            TagEnd::Link => self.out.push_str("</a>"),
            TagEnd::Image => self.out.push_str("\">"),
            _ => {}
        }
    }

    fn heading(&mut self, level: HeadingLevel) {
        let anchor = self.at.and_then(|at| self.rendering.plan.labels.anchor(self.chapter, at));
        let (id, number) = anchor.map_or(("", ""), |anchor| (&anchor.id, &anchor.number));
        let _ = write!(self.out, "<{level} id=\"{id}\"><span class=\"number\">{number}</span> ");
    }

    fn heading_end(&mut self, level: HeadingLevel) {
        let at = self.at.unwrap_or_default();
        let sections = self.rendering.plan.labels.sections(self.chapter);
        if let Some(section) = sections.iter().find(|section| section.title.end == at) {
            let _ = write!(
                self.out,
                " <a class=\"permalink\" href=\"#{}\" aria-label=\"Link to section {}\">#</a>",
                section.id, section.number
            );
        }
        let _ = writeln!(self.out, "</{level}>");
    }

    fn cell(&mut self) {
        let alignment = match self.table.alignments.get(self.table.column) {
            Some(Alignment::Left) => " class=\"left\"",
            Some(Alignment::Center) => " class=\"center\"",
            Some(Alignment::Right) => " class=\"number\"",
            _ => "",
        };
        let name = if self.table.head { "th scope=\"col\"" } else { "td" };
        let _ = write!(self.out, "<{name}{alignment}>");
    }

    fn link(&mut self, url: &str, title: &str) {
        let href = links::resolve(url, self.rendering.course).unwrap_or_default();
        let title = if title.is_empty() { String::new() } else { format!(" title=\"{}\"", escape(title)) };
        let _ = write!(self.out, "<a href=\"{}\"{title}>", escape(&href));
    }

    pub(super) fn formula(&mut self, formula: &Formula, display: bool) {
        // A malformed formula has been told while planning, and then nothing is rendered.
        self.out.push_str(&self.rendering.converter.convert(&formula.tex, display).unwrap_or_default());
    }

    fn equation(&mut self, formula: &Formula, label: Option<&Label>) {
        let anchor = label.and(self.at).and_then(|at| self.rendering.plan.labels.anchor(self.chapter, at));
        match anchor {
            Some(anchor) => drop(write!(self.out, "<div class=\"equation numbered\" id=\"{}\">", anchor.id)),
            None => self.out.push_str("<div class=\"equation\">"),
        }
        self.formula(formula, true);
        if let Some(anchor) = anchor {
            let _ = write!(self.out, "<a class=\"equation-number\" href=\"#{}\">({})</a>", anchor.id, anchor.number);
        }
        self.out.push_str("</div>\n");
    }

    fn exhibit(&mut self, fence: usize) {
        let index = self.rendering.plan.exhibit_of[self.chapter].get(fence).copied().flatten();
        if let Some(index) = index {
            let (html, diagnostics) = super::exhibit::render(self.rendering, index);
            self.out.push_str(&html);
            self.diagnostics.extend(diagnostics);
        }
    }

    fn listing(&mut self, fence: usize) {
        let index = self.rendering.plan.listing_of[self.chapter].get(fence).copied().flatten();
        if let Some(listing) = index.and_then(|index| self.rendering.plan.listings.get(index)) {
            let (html, diagnostics) = super::exhibit::listing(self.rendering, listing);
            self.out.push_str(&html);
            self.diagnostics.extend(diagnostics);
        }
    }

    fn value(&mut self, value: &ValueUse) {
        let index = self.rendering.plan.exhibits.iter().position(|exhibit| exhibit.id == value.exhibit);
        let measured = index.and_then(|index| self.rendering.shown[index].outcome.values.get(&value.name));
        self.number(measured, &value.format, &format!("{}.{}", value.exhibit, value.name));
    }

    fn computed(&mut self, computed: &Computed) {
        let measured = exhibits::computed(&computed.calculation, self.rendering.plan, self.rendering.shown);
        self.number(measured.as_ref(), &computed.format, computed.calculation.text());
    }

    /// A number from results, and where it is from. What is not there has been told before rendering.
    fn number(&mut self, measured: Option<&Measured>, format: &str, from: &str) {
        if let (Some(measured), Ok(format)) = (measured, Format::parse(format)) {
            let from = escape(from);
            let _ = write!(self.out, "<span class=\"value\" title=\"{from}\">{}</span>", format.write(measured));
        }
    }

    fn reference(&mut self, id: &str) {
        let Some(target) = self.rendering.plan.labels.target(id) else { return };
        let page = if target.chapter == self.chapter { String::new() } else { self.rendering.href(target.chapter) };
        let (word, number) = (target.kind.word(), &target.number);
        let _ = write!(self.out, "<a class=\"reference\" href=\"{page}#{id}\">{word}\u{a0}{number}</a>");
    }

    /// A term: where it is defined it has the id that its uses lead to.
    fn term(&mut self, term: &Term, next: Option<&Node>) {
        let key = terms::key(term);
        let id = terms::id(&key);
        if term.defines {
            let _ = write!(self.out, "<dfn id=\"{id}\">");
        } else {
            let definition = self.rendering.plan.terms.definition(&key);
            let other = definition.map(|definition| definition.spot.chapter).filter(|&other| other != self.chapter);
            let page = other.map(|other| self.rendering.href(other)).unwrap_or_default();
            let _ = write!(self.out, "<a class=\"term\" href=\"{page}#{id}\">");
        }
        for (at, node) in term.words.iter().enumerate() {
            self.node(node, term.words.get(at + 1).or(next));
        }
        self.out.push_str(if term.defines { "</dfn>" } else { "</a>" });
    }
}
