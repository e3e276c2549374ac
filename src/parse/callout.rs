//! Callouts: quotes whose first line is `[!NAME]`, with an optional title and label on that line.

use std::ops::Range;

use pulldown_cmark::{BlockQuoteKind, Event, Tag, TagEnd};

use super::events::Reader;
use super::inline::Run;
use super::node::{Callout, CalloutKind, Label, Node, What};
use crate::catalogue::nearest;
use crate::diag::Code;

impl Reader<'_, '_> {
    /// A quote: a callout if it says so, else a quotation.
    pub(super) fn quote(&mut self, kind: Option<BlockQuoteKind>, range: Range<usize>) {
        if let Some(kind) = kind {
            let callout = Callout { kind: standard(kind), label: None, title: Vec::new() };
            self.quotes.push(Some(callout.kind));
            return self.push(What::CalloutStart(callout), range);
        }
        if matches!(self.events.peek(), Some((Event::Start(Tag::Paragraph), _))) {
            let paragraph = self.events.next();
            if let Some(callout) = self.marked() {
                self.quotes.push(Some(callout.kind));
                return self.open(callout, range);
            }
            self.quotes.push(None);
            self.push(What::Markdown(Event::Start(Tag::BlockQuote(None))), range);
            // Whatever text was looked at has been put back as `pending`; the paragraph goes before it.
            if let Some((event, at)) = paragraph {
                self.event(event, at);
            }
            return self.scan_pending();
        }
        self.quotes.push(None);
        self.push(What::Markdown(Event::Start(Tag::BlockQuote(None))), range);
    }

    /// Reads `[!NAME] title {#label}` at the start of a paragraph; keeps the text for later if it is not there.
    fn marked(&mut self) -> Option<Callout> {
        let Some((Event::Text(text), _)) = self.events.peek() else { return None };
        if !text.starts_with('[') {
            return None;
        }
        let (Event::Text(text), at) = self.events.next()? else { return None };
        let run = self.gather(&text, at);
        let Some((kind, length)) = self.kind(&run) else {
            self.pending = Some(run);
            return None;
        };
        let (title, label) = self.title(&run.skip(length));
        Some(Callout { kind, label, title })
    }

    /// The kind that a run names, with the length of the mark; an unknown one is complained of.
    fn kind(&mut self, run: &Run) -> Option<(CalloutKind, usize)> {
        let close = run.text.strip_prefix("[!")?.find(']')? + 2;
        let name = &run.text[2..close];
        if name.is_empty() || !name.chars().all(|c| c.is_ascii_uppercase()) {
            return None;
        }
        let found = CalloutKind::ALL.iter().copied().find(|kind| kind.name() == name);
        if found.is_none() {
            let names = CalloutKind::ALL.iter().map(|kind| kind.name());
            let help = nearest(name, names.clone()).map(|near| format!("did you mean `[!{near}]`?"));
            let all = format!("callouts are {}", names.collect::<Vec<_>>().join(", "));
            let error = self.error(Code::UnknownName, format!("there is no callout `[!{name}]`"), run.span());
            self.diagnostics.push(error.help_if(help).help(all));
        }
        found.map(|kind| (kind, close + 1))
    }

    /// The title on the line of the mark, and the label at its end.
    fn title(&mut self, run: &Run) -> (Vec<Node>, Option<Label>) {
        let first = self.content.nodes.len();
        self.scan(run);
        while let Some((event, _)) = self.events.peek() {
            if matches!(event, Event::SoftBreak | Event::HardBreak | Event::End(TagEnd::Paragraph)) {
                break;
            }
            if let Some((event, at)) = self.events.next() {
                self.event(event, at);
            }
        }
        let mut title = self.content.nodes.split_off(first);
        let label = take_label(&mut title);
        trim(&mut title);
        (title, label)
    }

    /// Starts the callout, and its first paragraph if its text goes on behind the first line.
    fn open(&mut self, callout: Callout, range: Range<usize>) {
        self.push(What::CalloutStart(callout), range.clone());
        // If the paragraph ends here instead, it held the first line alone.
        if let Some((Event::SoftBreak | Event::HardBreak, _)) = self.events.next() {
            self.push(What::Markdown(Event::Start(Tag::Paragraph)), range);
        }
    }

    fn scan_pending(&mut self) {
        if let Some(run) = self.pending.take() {
            self.scan(&run);
        }
    }
}

/// The five callouts of the forges.
fn standard(kind: BlockQuoteKind) -> CalloutKind {
    match kind {
        BlockQuoteKind::Note => CalloutKind::Note,
        BlockQuoteKind::Tip => CalloutKind::Tip,
        BlockQuoteKind::Important => CalloutKind::Important,
        BlockQuoteKind::Warning => CalloutKind::Warning,
        BlockQuoteKind::Caution => CalloutKind::Caution,
    }
}

/// Takes `{#id}` off the end of a title.
fn take_label(title: &mut [Node]) -> Option<Label> {
    let Node { what: What::Markdown(Event::Text(text)), range } = title.last_mut()? else { return None };
    let trimmed = text.trim_end();
    let open = trimmed.rfind("{#")?;
    let id = trimmed[open..].strip_prefix("{#")?.strip_suffix('}')?.to_owned();
    let start = range.start + open;
    let label = Label { range: start..start + id.len() + 3, id };
    *text = text[..open].to_owned().into();
    Some(label)
}

/// Drops empty text and space at the ends of a title.
fn trim(title: &mut Vec<Node>) {
    if let Some(Node { what: What::Markdown(Event::Text(text)), .. }) = title.first_mut() {
        *text = text.trim_start().to_owned().into();
    }
    if let Some(Node { what: What::Markdown(Event::Text(text)), .. }) = title.last_mut() {
        *text = text.trim_end().to_owned().into();
    }
    title.retain(|node| !matches!(&node.what, What::Markdown(Event::Text(text)) if text.is_empty()));
}
