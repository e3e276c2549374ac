//! The text of a page: front matter, then markdown, piece by piece.

use std::fmt::Write as _;

use super::manual::Manual;
use super::typeset::typeset;
use crate::catalogue::{About, Paper};
use crate::parse::Shelf;

/// A page that is being written.
pub(super) struct Page<'a> {
    text: String,
    /// The shelves of the book, for links.
    shelves: &'a [Shelf],
}

/// A fence of an experiment that is being written.
pub(super) struct Fence {
    lines: Vec<String>,
    claims: Vec<String>,
}

impl<'a> Page<'a> {
    /// A page with its title, its sentence and, where there is one, the exhibit that stands for it.
    pub(super) fn new(title: &str, summary: &str, picture: Option<&str>, shelves: &'a [Shelf]) -> Self {
        let mut text = format!("+++\ntitle = {}\nsummary = {}\n", quoted(&printed(title)), quoted(&printed(summary)));
        if let Some(id) = picture {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "picture = {}", quoted(id));
        }
        text.push_str("+++\n\n");
        Self { text, shelves }
    }

    /// A section; `id` is the same on every page of a kind.
    pub(super) fn section(&mut self, title: &str, id: &str) {
        let _ = write!(self.text, "## {title} {{#{id}}}\n\n");
    }

    /// A block of markdown.
    pub(super) fn block(&mut self, markdown: &str) {
        self.text.push_str(markdown.trim_end());
        self.text.push_str("\n\n");
    }

    /// A list of markdown lines.
    pub(super) fn list(&mut self, items: impl IntoIterator<Item = String>) {
        for item in items {
            let _ = writeln!(self.text, "- {item}");
        }
        self.text.push('\n');
    }

    /// The paragraphs of an entry's own text that have one of these heads.
    pub(super) fn told(&mut self, manual: &Manual, heads: &[&str]) {
        for (head, words) in manual.parts.iter().filter(|(head, _)| heads.contains(&head.as_str())) {
            self.block(&format!("**{head}.** {}", typeset(words, self.shelves)));
        }
    }

    /// The same without the head.
    pub(super) fn words(&mut self, manual: &Manual, head: &str) {
        for (_, words) in manual.parts.iter().filter(|(own, _)| own == head) {
            self.block(&typeset(words, self.shelves));
        }
    }

    /// An experiment.
    pub(super) fn experiment(&mut self, fence: &Fence) {
        let _ = writeln!(self.text, "```experiment\n{}", fence.lines.join("\n"));
        if !fence.claims.is_empty() {
            let _ = writeln!(self.text, "\n[claims]\n{}", fence.claims.join("\n"));
        }
        self.text.push_str("```\n\n");
    }

    /// A listing of an item of the library.
    pub(super) fn listing(&mut self, id: &str, item: &str, caption: &str) {
        let caption = quoted(caption);
        let _ = write!(self.text, "```listing\nid = \"{id}\"\nitem = \"{item}\"\ncaption = {caption}\n```\n\n");
    }

    /// The section of the works that an entry comes from.
    pub(super) fn papers(&mut self, about: &About) {
        self.section(if about.papers.len() == 1 { "Paper" } else { "Papers" }, "papers");
        self.list(about.papers.iter().map(paper));
    }

    /// The finished text.
    pub(super) fn finish(self) -> String {
        self.text.trim_end().to_owned() + "\n"
    }
}

impl Fence {
    /// A fence of the kind `kind`.
    pub(super) fn new(kind: &str, id: &str) -> Self {
        Self { lines: vec![format!("id = \"{id}\""), format!("kind = \"{kind}\"")], claims: Vec::new() }
    }

    /// With a parameter, its value as TOML.
    pub(super) fn with(mut self, name: &str, value: impl std::fmt::Display) -> Self {
        self.lines.push(format!("{name} = {value}"));
        self
    }

    /// With a parameter that is a list of words.
    pub(super) fn words<S: AsRef<str>>(self, name: &str, words: &[S]) -> Self {
        let words: Vec<String> = words.iter().map(|word| quoted(word.as_ref())).collect();
        self.with(name, format!("[{}]", words.join(", ")))
    }

    /// With a parameter that is a word.
    pub(super) fn word(self, name: &str, word: &str) -> Self {
        self.with(name, quoted(word))
    }

    /// With a parameter that is a list of numbers.
    pub(super) fn numbers(self, name: &str, numbers: &[usize]) -> Self {
        self.with(name, format!("{numbers:?}"))
    }

    /// With its caption.
    pub(super) fn caption(self, caption: &str) -> Self {
        self.with("caption", quoted(caption))
    }

    /// With a claim, its bound as TOML.
    pub(super) fn claim(mut self, value: &str, bound: impl std::fmt::Display) -> Self {
        self.claims.push(format!("{} = {{ {bound} }}", quoted(value)));
        self
    }

    /// With more claims.
    pub(super) fn claims(self, claims: impl IntoIterator<Item = (String, String)>) -> Self {
        claims.into_iter().fold(self, |fence, (value, bound)| fence.claim(&value, bound))
    }
}

/// A text as TOML: as it stands where it can.
pub(super) fn quoted(text: &str) -> String {
    if text.contains(['\'', '\n']) { toml::Value::from(text).to_string() } else { format!("'{text}'") }
}

/// A work, as the list of a page has it.
fn paper(paper: &Paper) -> String {
    let Paper { authors, year, title, venue, doi } = paper;
    let title = plain(title);
    let told = if venue.starts_with("http") { format!("<{venue}>") } else { ranges(&plain(venue)) };
    let doi = doi.map(|doi| format!(". [doi:{}](<https://doi.org/{doi}>)", plain(doi))).unwrap_or_default();
    format!("{} ({year}). *{title}*. {told}{doi}", plain(authors))
}

/// Pages from one to another with a dash, at which no line is broken.
fn ranges(venue: &str) -> String {
    let parts: Vec<&str> = venue.split('-').collect();
    let mut out = parts.first().copied().unwrap_or_default().to_owned();
    for pair in parts.windows(2) {
        // Pages stand behind a comma; the number of a report keeps its hyphen.
        let first = pair[0].trim_end_matches(|c: char| c.is_ascii_digit());
        let digits =
            first.len() < pair[0].len() && first.ends_with(", ") && pair[1].starts_with(|c: char| c.is_ascii_digit());
        out.push_str(if digits { "–\u{2060}" } else { "-" });
        out.push_str(pair[1]);
    }
    out
}

/// Text that markdown takes as it is.
pub(super) fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if "\\*_[]`$<>@".contains(c) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

/// Scripts as signs of their own: what stands for a letter or a digit.
const RAISED: &[(char, char)] = &[
    ('0', '⁰'),
    ('1', '¹'),
    ('2', '²'),
    ('3', '³'),
    ('4', '⁴'),
    ('5', '⁵'),
    ('6', '⁶'),
    ('7', '⁷'),
    ('8', '⁸'),
    ('9', '⁹'),
    ('d', 'ᵈ'),
    ('k', 'ᵏ'),
    ('m', 'ᵐ'),
    ('n', 'ⁿ'),
    ('-', '⁻'),
    ('+', '⁺'),
    ('(', '⁽'),
    (')', '⁾'),
];
/// The same below the line.
const LOWERED: &[(char, char)] = &[
    ('0', '₀'),
    ('1', '₁'),
    ('2', '₂'),
    ('3', '₃'),
    ('j', 'ⱼ'),
    ('k', 'ₖ'),
    ('m', 'ₘ'),
    ('n', 'ₙ'),
    ('-', '₋'),
    ('+', '₊'),
];

/// The letter x as a sign between what can be multiplied: `p x p`, but not `1 for x < 1/pi`.
fn times(text: &str) -> String {
    let mut words: Vec<&str> = text.split(' ').collect();
    let factor = |word: &str| word.chars().count() == 1 && word != "=" || word.contains(|c: char| !c.is_alphabetic());
    for at in 1..words.len().saturating_sub(1) {
        if words[at] == "x" && factor(words[at - 1]) && !["<", "=", ">", "<=", ">=", "in"].contains(&words[at + 1]) {
            words[at] = "×";
        }
    }
    words.join(" ")
}

/// A sentence that is no markdown, with printed signs: `n = k^d` has a raised d, an apostrophe is round.
pub(super) fn printed(text: &str) -> String {
    let text = times(text).replace('\'', "’").replace(" - ", " − ").replace("<=", "≤");
    let mut out = String::with_capacity(text.len());
    let mut rest = text.as_str();
    while let Some(c) = rest.chars().next() {
        let signs = if c == '^' { RAISED } else { LOWERED };
        let found = script(&rest[c.len_utf8()..], signs).filter(|_| "^_".contains(c));
        let (sign, length) = found.unwrap_or_else(|| (c.to_string(), 0));
        out.push_str(&sign);
        rest = &rest[c.len_utf8() + length..];
    }
    out
}

/// A script in signs of its own, with its length in the text: brackets around all of it are left out. None if a sign is missing.
fn script(rest: &str, signs: &[(char, char)]) -> Option<(String, usize)> {
    let sign = |c: char| signs.iter().find(|(plain, _)| *plain == c).map(|(_, sign)| *sign);
    // A negative bracket stays one.
    if let Some((inside, _)) = rest.strip_prefix("-(").and_then(|rest| rest.split_once(')')) {
        let all = format!("-({inside})");
        return all.chars().map(sign).collect::<Option<String>>().map(|script| (script, all.len()));
    }
    if let Some((inside, _)) = rest.strip_prefix('(').and_then(|rest| rest.split_once(')')) {
        return inside.chars().map(sign).collect::<Option<String>>().map(|script| (script, inside.len() + 2));
    }
    let length = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(rest.len());
    let script: Option<String> = rest[..length].chars().map(sign).collect();
    script.filter(|script| !script.is_empty()).map(|script| (script, length))
}

#[cfg(test)]
mod tests {
    use super::printed;

    #[test]
    fn sentences_have_printed_signs() {
        assert_eq!(printed("n = k^d of Sobol's p x p, F_(k-1)"), "n = kᵈ of Sobol’s p × p, Fₖ₋₁");
        assert_eq!(printed("1 for x < 1/pi; 16 x 16"), "1 for x < 1/pi; 16 × 16");
        assert_eq!(printed("(1 + x_j)^-(d+1), a_j^-2"), "(1 + xⱼ)⁻⁽ᵈ⁺¹⁾, aⱼ⁻²");
        assert_eq!(printed("exp(-sum a_j^2 (x_j - u_j)^2), 2^(m/2)"), "exp(-sum aⱼ² (xⱼ − uⱼ)²), 2^(m/2)");
    }
}
