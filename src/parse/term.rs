//! Terms: links to `define:` and `term:`, the place where a word is introduced and those that use it.

use std::ops::Range;

use pulldown_cmark::{Event, LinkType, TagEnd};

use super::events::Reader;
use super::inline::Run;
use super::node::{Term, What};
use crate::diag::Code;

/// What the address of a definition begins with.
const DEFINE: &str = "define:";
/// What the address of a use begins with.
const TERM: &str = "term:";

/// The brackets in the text of a block: markdown leaves those of a link in the text if a term stands within it.
#[derive(Default)]
pub(super) struct Brackets {
    open: usize,
    /// A term that stands behind an open bracket.
    within: Option<Range<usize>>,
}

/// Whether a link is a term, and what stands behind its colon; a bare address in angle brackets is none.
pub(super) fn address(link_type: LinkType, url: &str) -> Option<(bool, String)> {
    if matches!(link_type, LinkType::Autolink | LinkType::Email) {
        return None;
    }
    let define = url.strip_prefix(DEFINE).map(|key| (true, key.to_owned()));
    define.or_else(|| url.strip_prefix(TERM).map(|key| (false, key.to_owned())))
}

impl Reader<'_, '_> {
    /// A term, up to the end of its link.
    pub(super) fn term(&mut self, defines: bool, key: String, title: &str, range: Range<usize>) {
        let first = self.content.nodes.len();
        self.links += 1;
        while let Some((event, at)) = self.events.next() {
            match event {
                Event::End(TagEnd::Link) => break,
                // A term is part of a line.
                Event::DisplayMath(tex) => self.event(Event::InlineMath(tex), at.start + 1..at.end - 1),
                event => self.event(event, at),
            }
        }
        self.links -= 1;
        let words = self.content.nodes.split_off(first);
        if self.brackets.open > 0 {
            self.brackets.within = Some(range.clone());
        }
        self.push(What::Term(Term { defines, key, title: title.replace('\'', "’"), words }), range);
    }

    /// Tells of a term in the words of a picture, which are no links.
    pub(super) fn no_term(&mut self, link_type: LinkType, url: &str, range: Range<usize>) {
        if address(link_type, url).is_some() {
            let error = self.error(Code::Markup, "a term stands within the words of a picture", range);
            self.diagnostics.push(error.help("write it in the text"));
        }
    }

    /// Markdown leaves a link in the text if its address holds a space, or if another link, such as a term, stands within it.
    pub(super) fn unread_term(&mut self, run: &Run) {
        for (at, c) in run.text.char_indices().filter(|(at, _)| !run.escaped.contains(at)) {
            match c {
                '[' => self.brackets.open += 1,
                ']' if self.brackets.open > 0 => {
                    self.brackets.open -= 1;
                    if let Some(address) = run.text[at + 1..].strip_prefix('(') {
                        self.unread_link(run, at + 2, address);
                    }
                }
                _ => {}
            }
        }
    }

    /// Tells of a link that was left in the text: its address stands at the byte `at` of the run.
    fn unread_link(&mut self, run: &Run, at: usize, address: &str) {
        let end = address.find(')').unwrap_or(address.len());
        let scheme = [DEFINE, TERM].into_iter().find(|scheme| address.starts_with(scheme));
        if let Some(scheme) = scheme {
            let key = address[scheme.len()..end].trim().replace(char::is_whitespace, "-");
            let error = self.error(Code::Markup, "the address of a term holds no spaces", run.range(at..at + end));
            self.diagnostics.push(error.help(format!("write hyphens instead: `{scheme}{key}`")));
        } else if let Some(term) = self.brackets.within.take().filter(|_| self.brackets.open == 0) {
            let error = self.error(Code::Markup, "a term stands within a link", term);
            self.diagnostics.push(error.help("one of the two can be a link: write them beside each other"));
        }
    }
}
