//! Formulas within a line, held together with what touches them: browsers break lines on either side of a formula.

use pulldown_cmark::Event;

use super::markdown::Writer;
use crate::parse::{Formula, Node, What};
use crate::plan::escape;

/// What stands right before a formula belongs to it.
const OPENING: [char; 7] = ['(', '[', '“', '‘', '-', '–', '/'];

/// A formula that shows more letters and signs than this may be wider than a small screen.
const LONG: usize = 22;

const END: &str = "</span>";

/// How the writer holds a formula and its neighbours together.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hold {
    /// Not at all.
    #[default]
    Free,
    /// The words that follow begin with what touches the formula.
    Open,
    /// It ended when this much was written: a formula that follows at once belongs to it.
    Ended(usize),
}

impl Writer<'_> {
    /// A formula, with the node that follows it.
    pub(super) fn inline_formula(&mut self, formula: &Formula, next: Option<&Node>) {
        let from = self.out.len();
        self.formula(formula, false);
        if letters(&self.out[from..]) > LONG {
            // Lines do not break within a formula: on a small screen this one scrolls.
            self.out.insert_str(from, "<span class=\"long-formula\">");
            self.out.push_str(END);
            self.hold = Hold::Free;
            return;
        }
        let touched = matches!(
            next.map(|next| &next.what),
            Some(What::Markdown(Event::Text(text))) if text.starts_with(|c: char| !c.is_whitespace())
        );
        let open = self.out[..from].trim_end_matches(OPENING).len();
        if self.hold == Hold::Ended(from) {
            self.out.replace_range(from - END.len()..from, "");
        } else if touched || open < from {
            self.out.insert_str(open, "<span class=\"held\">");
        } else {
            self.hold = Hold::Free;
            return;
        }
        if touched {
            self.hold = Hold::Open;
        } else {
            self.release();
        }
    }

    /// Words; up to the first space they touch a formula that waits for them.
    pub(super) fn words(&mut self, text: &str) {
        if self.hold != Hold::Open {
            self.out.push_str(&escape(text));
            return;
        }
        let end = text.find(char::is_whitespace).unwrap_or(text.len());
        self.out.push_str(&escape(&text[..end]));
        self.release();
        self.out.push_str(&escape(&text[end..]));
    }

    fn release(&mut self) {
        self.out.push_str(END);
        self.hold = Hold::Ended(self.out.len());
    }
}

/// How many characters a formula shows.
fn letters(math: &str) -> usize {
    math.split('>').filter_map(|piece| piece.split('<').next()).map(|text| text.chars().count()).sum()
}
