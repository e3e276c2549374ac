//! The walk over markdown's events: one function per kind of event.

use std::ops::Range;
use std::sync::Arc;

use pulldown_cmark::{CodeBlockKind, CowStr, Event, LinkType, MetadataBlockKind, Options, Parser, Tag, TagEnd};

use super::Content;
use super::fence::Fence;
use super::inline::Run;
use super::node::{CalloutKind, Formula, Label, Node, What};
use super::source_map::SourceMap;
use super::term::{self, Brackets};
use crate::diag::{Code, Diagnostic};
use crate::workspace::{CHAPTERS, Source, Workspace};

/// An event with the bytes that it was read from.
pub(super) type Placed<'a> = (Event<'a>, Range<usize>);

/// The markdown that chapters are written in.
pub fn parser_options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_PLUSES_DELIMITED_METADATA_BLOCKS
        | Options::ENABLE_MATH
        | Options::ENABLE_GFM
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_SMART_PUNCTUATION
}

/// The events of a chapter, and the bytes of its front matter without the fences, if it has any.
pub(super) fn split_front_matter(text: &str) -> (Vec<Placed<'_>>, Option<Range<usize>>) {
    let mut front = None;
    let mut inside = false;
    let mut events = Vec::new();
    for (event, range) in Parser::new_ext(text, parser_options()).into_offset_iter() {
        match event {
            Event::Start(Tag::MetadataBlock(MetadataBlockKind::PlusesStyle)) => inside = true,
            Event::End(TagEnd::MetadataBlock(MetadataBlockKind::PlusesStyle)) => inside = false,
            Event::Text(_) if inside => {
                front = Some(front.map_or(range.clone(), |before: Range<usize>| before.start..range.end));
            }
            event => events.push((event, range)),
        }
    }
    (events, front)
}

/// Reads the events of a chapter into nodes.
pub(super) fn read(
    events: Vec<Placed<'_>>,
    source: &Source,
    allow_html: bool,
    workspace: &Workspace,
    diagnostics: &mut Vec<Diagnostic>,
) -> Content {
    let map = SourceMap::whole(0, source.text.len());
    let mut reader = Reader::new(&source.text, events, &source.path, map, workspace, diagnostics);
    reader.allow_html = allow_html;
    reader.run();
    reader.content
}

/// Reads a line of markdown that stands elsewhere, such as a caption, into nodes without a paragraph around them.
pub fn inline(
    text: &str,
    file: &Arc<str>,
    map: SourceMap,
    workspace: &Workspace,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Node> {
    let events = Parser::new_ext(text, parser_options()).into_offset_iter().collect();
    let mut reader = Reader::new(text, events, file, map, workspace, diagnostics);
    reader.run();
    let paragraph =
        |what: &What| matches!(what, What::Markdown(Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph)));
    reader.content.nodes.retain(|node| !paragraph(&node.what));
    reader.content.nodes
}

/// Reads markdown that stands outside of chapters into nodes, its paragraphs and lists included.
pub(super) fn passage(
    text: &str,
    file: &Arc<str>,
    map: SourceMap,
    workspace: &Workspace,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Node> {
    let events = Parser::new_ext(text, parser_options()).into_offset_iter().collect();
    let mut reader = Reader::new(text, events, file, map, workspace, diagnostics);
    reader.run();
    reader.content.nodes
}

/// The state of the walk.
pub(super) struct Reader<'a, 'w> {
    /// The text that the events were read from.
    pub(super) parsed: &'w str,
    pub(super) events: std::iter::Peekable<std::vec::IntoIter<Placed<'a>>>,
    pub(super) file: &'w Arc<str>,
    pub(super) content: Content,
    pub(super) diagnostics: &'w mut Vec<Diagnostic>,
    /// From the parsed text to the file.
    pub(super) map: SourceMap,
    workspace: &'w Workspace,
    allow_html: bool,
    /// For each open quote, which callout it is, if any.
    pub(super) quotes: Vec<Option<CalloutKind>>,
    /// How many links, pictures and blocks of code are open: no reference may stand within them.
    pub(super) links: usize,
    /// Whether a paragraph is open.
    paragraph: bool,
    /// The brackets in the text of the block being read.
    pub(super) brackets: Brackets,
    /// Text that was looked at to see whether a quote is a callout, and is yet to be read.
    pub(super) pending: Option<Run>,
}

impl<'a, 'w> Reader<'a, 'w> {
    fn new(
        parsed: &'w str,
        events: Vec<Placed<'a>>,
        file: &'w Arc<str>,
        map: SourceMap,
        workspace: &'w Workspace,
        diagnostics: &'w mut Vec<Diagnostic>,
    ) -> Self {
        let content = Content::default();
        let events = events.into_iter().peekable();
        Self {
            parsed,
            events,
            file,
            content,
            diagnostics,
            map,
            workspace,
            allow_html: false,
            quotes: Vec::new(),
            links: 0,
            paragraph: false,
            brackets: Brackets::default(),
            pending: None,
        }
    }

    fn run(&mut self) {
        while let Some((event, range)) = self.events.next() {
            self.event(event, range);
        }
    }

    pub(super) fn event(&mut self, event: Event<'a>, range: Range<usize>) {
        match event {
            Event::Start(tag) => self.start(tag, range),
            Event::End(tag) => self.end(tag, range),
            Event::Text(text) => self.text(text, range),
            Event::Code(code) => self.code(code, range),
            Event::InlineMath(tex) => {
                let formula = self.formula(&tex, range.start + 1);
                self.push(What::Formula(formula), range);
            }
            Event::DisplayMath(tex) => self.equation(&tex, range),
            Event::Html(html) | Event::InlineHtml(html) => self.html(html, range),
            event => self.push(What::Markdown(event.into_static()), range),
        }
    }

    pub(super) fn push(&mut self, what: What, range: Range<usize>) {
        match what {
            What::Markdown(Event::Start(Tag::Paragraph)) => self.paragraph = true,
            What::Markdown(Event::End(TagEnd::Paragraph)) => self.paragraph = false,
            _ => {}
        }
        if matches!(
            what,
            What::Markdown(Event::Start(Tag::Paragraph | Tag::Heading { .. } | Tag::Item | Tag::TableCell))
        ) {
            self.brackets = Brackets::default();
        }
        self.content.nodes.push(Node { what, range: self.map.range(range) });
    }

    /// A complaint at bytes of the parsed text.
    pub(super) fn error(&mut self, code: Code, message: impl Into<String>, range: Range<usize>) -> Diagnostic {
        Diagnostic::error(code, message).at(self.file, self.map.range(range))
    }

    fn start(&mut self, tag: Tag<'a>, range: Range<usize>) {
        match tag {
            Tag::CodeBlock(CodeBlockKind::Fenced(info)) => self.fence(info, range),
            Tag::BlockQuote(kind) => self.quote(kind, range),
            Tag::Image { link_type, dest_url, title, id } => self.image(link_type, &dest_url, title, id, range),
            Tag::HtmlBlock => {}
            Tag::Link { link_type, dest_url, title, id } => {
                if let Some((defines, key)) = term::address(link_type, &dest_url) {
                    return self.term(defines, key, &title, range);
                }
                self.links += 1;
                let tag = Tag::Link { link_type, dest_url, title, id };
                self.push(What::Markdown(Event::Start(tag).into_static()), range);
            }
            tag => {
                self.links += usize::from(matches!(tag, Tag::CodeBlock(_)));
                self.push(What::Markdown(Event::Start(tag).into_static()), range);
            }
        }
    }

    fn end(&mut self, tag: TagEnd, range: Range<usize>) {
        match tag {
            TagEnd::BlockQuote(_) => match self.quotes.pop().flatten() {
                Some(kind) => self.push(What::CalloutEnd(kind), range),
                None => self.push(What::Markdown(Event::End(tag)), range),
            },
            TagEnd::HtmlBlock => {}
            tag => {
                self.links -= usize::from(matches!(tag, TagEnd::Link | TagEnd::CodeBlock) && self.links > 0);
                self.push(What::Markdown(Event::End(tag)), range);
            }
        }
    }

    /// A fence: the workbook's own are collected, all others stay code blocks.
    fn fence(&mut self, info: CowStr<'a>, range: Range<usize>) {
        let word = info.split_whitespace().next().unwrap_or_default().to_owned();
        if word != "experiment" && word != "listing" {
            self.links += 1;
            return self
                .push(What::Markdown(Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))).into_static()), range);
        }
        let mut fence = Fence { text: String::new(), map: SourceMap::default(), range: self.map.range(range.clone()) };
        for (event, at) in self.events.by_ref() {
            match event {
                Event::Text(text) => {
                    fence.map.push(fence.text.len(), self.map.range(at));
                    fence.text.push_str(&text);
                }
                Event::End(TagEnd::CodeBlock) => break,
                _ => {}
            }
        }
        let fences = if word == "experiment" { &mut self.content.experiments } else { &mut self.content.listings };
        fences.push(fence);
        let index = fences.len() - 1;
        self.push(if word == "experiment" { What::Experiment(index) } else { What::Listing(index) }, range);
    }

    fn formula(&self, tex: &str, start: usize) -> Formula {
        let place = self.map.range(start..start + tex.len());
        Formula { tex: tex.to_owned(), map: SourceMap::whole(place.start, place.len()) }
    }

    /// A formula on lines of its own, with its label if one follows. It ends the paragraph it stands in.
    fn equation(&mut self, tex: &str, range: Range<usize>) {
        let formula = self.formula(tex, range.start + 2);
        let label = self.equation_label();
        let paragraph = self.paragraph;
        if paragraph {
            self.close_paragraph(&range);
        }
        self.push(What::Equation { formula, label }, range.clone());
        if !paragraph {
            return;
        }
        match self.events.peek() {
            Some((Event::End(TagEnd::Paragraph), _)) => drop(self.events.next()),
            Some((Event::SoftBreak | Event::HardBreak, _)) => {
                self.events.next();
                self.push(What::Markdown(Event::Start(Tag::Paragraph)), range);
            }
            _ => self.push(What::Markdown(Event::Start(Tag::Paragraph)), range),
        }
    }

    /// Takes ` {#eq-name}` behind an equation.
    fn equation_label(&mut self) -> Option<Label> {
        let (Event::Text(text), range) = self.events.peek()? else { return None };
        let id = text.trim().strip_prefix("{#")?.strip_suffix('}')?.to_owned();
        let range = self.map.range(range.clone());
        self.events.next();
        Some(Label { id, range })
    }

    /// Ends the open paragraph, or takes its start back if nothing stands in it yet.
    fn close_paragraph(&mut self, range: &Range<usize>) {
        while matches!(self.content.nodes.last(), Some(Node { what: What::Markdown(Event::SoftBreak), .. })) {
            self.content.nodes.pop();
        }
        if matches!(self.content.nodes.last(), Some(Node { what: What::Markdown(Event::Start(Tag::Paragraph)), .. })) {
            self.content.nodes.pop();
            self.paragraph = false;
        } else {
            self.push(What::Markdown(Event::End(TagEnd::Paragraph)), range.clone());
        }
    }

    /// A picture of the course: it needs words for those who cannot see it, and a file.
    fn image(&mut self, link_type: LinkType, url: &str, title: CowStr<'a>, id: CowStr<'a>, range: Range<usize>) {
        let mut alt = String::new();
        while let Some((event, at)) = self.events.next() {
            match event {
                Event::Text(text) | Event::Code(text) => alt.push_str(&text),
                Event::SoftBreak => alt.push(' '),
                Event::Start(Tag::Link { link_type, dest_url, .. }) => self.no_term(link_type, &dest_url, at),
                Event::End(TagEnd::Image) => break,
                _ => {}
            }
        }
        if alt.trim().is_empty() {
            let error =
                self.error(Code::MissingAlt, format!("the picture `{url}` has no alternative text"), range.clone());
            self.diagnostics
                .push(error.help("write between the brackets what the picture shows: `![words](file.png)`"));
        }
        if !self.workspace.blobs.contains_key(format!("{CHAPTERS}/{url}").as_str()) {
            let error =
                self.error(Code::MissingInclude, format!("there is no picture `{url}` in the course"), range.clone());
            self.diagnostics
                .push(error.help(format!("paths start at `{CHAPTERS}/`; pictures from other hosts are not shown")));
        }
        let dest_url = CowStr::from(url.to_owned());
        let tag = Tag::Image { link_type, dest_url, title, id };
        self.push(What::Markdown(Event::Start(tag).into_static()), range.clone());
        self.push(What::Markdown(Event::Text(alt.into())), range.clone());
        self.push(What::Markdown(Event::End(TagEnd::Image)), range);
    }

    /// Raw HTML: passed on only where the course's settings allow it; comments are dropped.
    fn html(&mut self, html: CowStr<'a>, range: Range<usize>) {
        if html.trim_start().starts_with("<!--") {
            return;
        }
        if self.allow_html {
            return self.push(What::Markdown(Event::Html(html).into_static()), range);
        }
        let error = self.error(Code::Markup, "raw HTML is not allowed in this course", range);
        self.diagnostics.push(error.help("write it in markdown, or set `allow_html = true` in workbook.toml"));
    }
}
