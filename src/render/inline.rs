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

/// A word of code longer than this may be broken anywhere: it may be wider than a small screen.
const HELD: usize = 26;

/// Code within a line. Browsers break lines behind a hyphen, which would tear options and names apart.
pub(super) fn inline_code(code: &str) -> String {
    let torn = |word: &str| word.contains('-') && (2..=HELD).contains(&word.chars().count());
    if !code.contains(' ') {
        let class = if torn(code) { " class=\"held\"" } else { "" };
        return format!("<code{class}>{}</code>", escape(code));
    }
    let mut words: Vec<String> = Vec::new();
    for word in code.split(' ') {
        match words.last_mut() {
            // An option stays with its value.
            Some(option) if option.starts_with('-') && !option.contains(' ') && option.len() + word.len() < HELD => {
                option.push(' ');
                option.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    let words = words.iter().map(|word| match escape(word) {
        html if torn(word) => format!("<span class=\"held\">{html}</span>"),
        html => html,
    });
    format!("<code>{}</code>", words.collect::<Vec<_>>().join(" "))
}

/// How many characters a formula shows.
fn letters(math: &str) -> usize {
    math.split('>').filter_map(|piece| piece.split('<').next()).map(|text| text.chars().count()).sum()
}

#[cfg(test)]
mod tests {
    use super::inline_code;

    #[test]
    fn options_and_names_with_hyphens_are_held() {
        assert_eq!(inline_code("t-value"), "<code class=\"held\">t-value</code>");
        assert_eq!(inline_code("a < b"), "<code>a &lt; b</code>");
        let held = "<code>run <span class=\"held\">fig-a</span> <span class=\"held\">-p n=4</span></code>";
        assert_eq!(inline_code("run fig-a -p n=4"), held);
        let long = "a-".repeat(20);
        assert_eq!(inline_code(&long), format!("<code>{long}</code>"), "what is long may be torn");
    }
}
