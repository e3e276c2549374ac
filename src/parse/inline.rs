//! Runs of text: references, citations and what looks like a footnote that is not there.

use std::ops::Range;

use pulldown_cmark::{CowStr, Event};

use super::events::Reader;
use super::node::{Cited, What};
use super::source_map::SourceMap;
use crate::diag::Code;

/// The prefixes of ids that a reference can name.
pub(crate) const PREFIXES: &[&str] = &["fig", "tbl", "lst", "eq", "sec", "exr", "def"];

/// A run of adjacent texts, which markdown's parser cuts at every bracket.
pub(super) struct Run {
    pub(super) text: String,
    map: SourceMap,
    /// Where a backslash stood: the character behind it is meant as it stands.
    pub(super) escaped: Vec<usize>,
    end: usize,
}

impl Run {
    /// The bytes of the parsed text behind bytes of the run.
    pub(super) fn range(&self, range: Range<usize>) -> Range<usize> {
        self.map.range(range)
    }

    /// The run from the byte `at` on.
    pub(super) fn skip(&self, at: usize) -> Self {
        Self {
            text: self.text[at..].to_owned(),
            map: self.map.from(at),
            escaped: self.escaped.iter().filter_map(|&place| place.checked_sub(at)).collect(),
            end: self.end,
        }
    }

    /// The bytes of the parsed text that the run spans.
    pub(super) fn span(&self) -> Range<usize> {
        self.map.byte(0)..self.end
    }
}

impl<'a> Reader<'a, '_> {
    /// A run of text that starts with `text`.
    pub(super) fn text(&mut self, text: CowStr<'a>, range: Range<usize>) {
        if self.links > 0 {
            return self.push(What::Markdown(Event::Text(text).into_static()), range);
        }
        let run = self.gather(&text, range);
        self.unread_formula(&run);
        self.unread_term(&run);
        self.scan(&run);
    }

    /// Markdown leaves a formula in the text if its braces do not match or its dollars do not: a dollar with LaTeX behind it.
    fn unread_formula(&mut self, run: &Run) {
        let dollars = || run.text.match_indices('$').filter(|(at, _)| !run.escaped.contains(at));
        for (at, _) in dollars() {
            let end = run.text[at + 1..].find('$').map_or(run.text.len(), |length| at + length + 2);
            let inside = &run.text[at + 1..end];
            if inside.starts_with('$') || inside.contains(['{', '}', '\\', '^', '_']) {
                let error =
                    self.error(Code::Math, "this dollar begins a formula that does not end", run.range(at..end));
                let help = "the braces of a formula match, no space stands inside its dollars; for a dollar itself write `\\$`";
                return self.diagnostics.push(error.help(help));
            }
        }
    }

    /// The run of adjacent texts that starts with `text`.
    pub(super) fn gather(&mut self, text: &str, range: Range<usize>) -> Run {
        let mut run = Run { text: text.to_owned(), map: SourceMap::default(), escaped: Vec::new(), end: range.end };
        if self.parsed.as_bytes()[..range.start.min(self.parsed.len())].ends_with(b"\\") {
            run.escaped.push(0);
        }
        run.map.push(0, range);
        while let Some((text, range)) = self.next_text(&run) {
            if range.start > run.end && self.parsed.as_bytes()[..range.start].ends_with(b"\\") {
                run.escaped.push(run.text.len());
            }
            run.end = range.end;
            run.map.push(run.text.len(), range);
            run.text.push_str(&text);
        }
        run
    }

    /// The text that follows a run and belongs to it: a citation may go on in the next line.
    fn next_text(&mut self, run: &Run) -> Option<(CowStr<'a>, Range<usize>)> {
        let cites = || run.text.rfind("[@").is_some_and(|at| !run.text[at..].contains(']'));
        match self.events.peek()? {
            (Event::Text(_), _) => {}
            (Event::SoftBreak, _) if cites() => {}
            _ => return None,
        }
        match self.events.next()? {
            (Event::Text(text), range) => Some((text, range)),
            (_, range) => Some(("\n".into(), range)),
        }
    }

    /// Splits a run into text, references and citations.
    pub(super) fn scan(&mut self, run: &Run) {
        let mut from = 0;
        let mut at = 0;
        while let Some(found) = run.text[at..].find(['@', '[']).map(|found| found + at) {
            at = found + 1;
            if run.escaped.contains(&found) {
                continue;
            }
            let Some((what, length)) = self.mark(run, found) else { continue };
            self.plain(run, from..found);
            self.push(what, run.range(found..found + length));
            from = found + length;
            at = from;
        }
        self.plain(run, from..run.text.len());
    }

    fn plain(&mut self, run: &Run, range: Range<usize>) {
        if !range.is_empty() {
            let text = run.text[range.clone()].to_owned();
            self.push(What::Markdown(Event::Text(text.into())), run.range(range));
        }
    }

    /// The reference or citation at the byte `at` of a run, with its length.
    fn mark(&mut self, run: &Run, at: usize) -> Option<(What, usize)> {
        let rest = &run.text[at..];
        if rest.starts_with("[@") {
            let close = rest.find(']')?;
            if let Some(cited) =
                citation(&rest[1..close], |range| self.map.range(run.range(at + 1 + range.start..at + 1 + range.end)))
            {
                return Some((What::Citation(cited), close + 1));
            }
        }
        if rest.starts_with("[^") {
            self.missing_footnote(run, at);
        }
        let before = run.text[..at].chars().next_back();
        if rest.starts_with('@') && !before.is_some_and(|c| c.is_alphanumeric() || c == '@') {
            let id = reference(&rest[1..])?;
            return Some((What::Reference(id.to_owned()), 1 + id.len()));
        }
        None
    }

    /// Markdown leaves a footnote's mark in the text if the chapter does not define the footnote.
    fn missing_footnote(&mut self, run: &Run, at: usize) {
        let Some(close) = run.text[at..].find(']') else { return };
        let name = &run.text[at + 2..at + close];
        if !name.is_empty() && !name.contains(char::is_whitespace) {
            let range = run.range(at..at + close + 1);
            let error =
                self.error(Code::MissingTarget, format!("there is no footnote `{name}` in this chapter"), range);
            self.diagnostics.push(error.help(format!("define it on a line of its own: `[^{name}]: …`")));
        }
    }
}

/// The id at the start of `text`, e.g. `fig-rmse` of `fig-rmse.`; none if it has no known prefix.
fn reference(text: &str) -> Option<&str> {
    let length = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(text.len());
    let id = text[..length].trim_end_matches('-');
    let (prefix, name) = id.split_once('-')?;
    (PREFIXES.contains(&prefix) && !name.is_empty()).then_some(id)
}

/// The works of `@a; @b, p. 3`; none if any part is no key.
fn citation(inside: &str, place: impl Fn(Range<usize>) -> Range<usize>) -> Option<Vec<Cited>> {
    let mut cited = Vec::new();
    let mut start = 0;
    for part in inside.split(';') {
        let key = part.trim_start();
        let at = start + (part.len() - key.len());
        let (key, locator) = key.strip_prefix('@')?.split_once(',').unwrap_or((&key[1..], ""));
        let key = key.trim_end();
        if key.is_empty() || reference(key) == Some(key) || key.contains(char::is_whitespace) {
            return None;
        }
        cited.push(Cited {
            key: key.to_owned(),
            locator: locator.trim().to_owned(),
            range: place(at..at + 1 + key.len()),
        });
        start += part.len() + 1;
    }
    Some(cited)
}

#[cfg(test)]
mod tests {
    use super::{citation, reference};

    #[test]
    fn a_reference_ends_where_its_id_ends() {
        assert_eq!(reference("fig-rmse-1d, which"), Some("fig-rmse-1d"));
        assert_eq!(reference("tbl-deck."), Some("tbl-deck"));
        assert_eq!(reference("fig-"), None);
        assert_eq!(reference("figure-1"), None);
        assert_eq!(reference("owen1997"), None);
    }

    #[test]
    fn a_citation_names_works_and_where_in_them() {
        let cited = citation("@owen1997; @sobol1967, p. 12", |range| range).expect("two works");
        assert_eq!((cited[0].key.as_str(), cited[0].range.clone()), ("owen1997", 0..9));
        assert_eq!((cited[1].key.as_str(), cited[1].locator.as_str()), ("sobol1967", "p. 12"));
        assert!(citation("@fig-a", |range| range).is_none());
        assert!(citation("see @owen1997", |range| range).is_none());
    }
}
