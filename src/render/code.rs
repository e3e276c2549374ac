//! Code on a page: one form for listings and for plain fences, so that style and scripts find both.
//!
//! Each line is an element, so that it can have a number, stand out, and be broken with an indent where the page is narrow. Numbers are
//! of the style sheet's making: no text holds them, and they are neither copied nor read out.

use std::fmt::Write as _;

use super::highlight;
use crate::parse::Emphasis;
use crate::plan::escape;

/// From this many lines on, numbers need a third place.
const LONG: usize = 100;
/// The most steps of an indent that the style sheet knows.
const STEPS: usize = 8;

/// A plain fence while its text is being gathered.
pub(super) struct Fence {
    pub(super) language: String,
    pub(super) emphasis: Emphasis,
    pub(super) text: String,
}

impl Fence {
    /// A fence by the words behind its marks. What cannot be read there has been told while planning.
    pub(super) fn new(info: &str) -> Self {
        let (language, emphasis) = crate::parse::fence(info);
        let emphasis = emphasis.and_then(|text| Emphasis::read(text).ok()).unwrap_or_default();
        Self { language: language.to_owned(), emphasis, text: String::new() }
    }

    /// The fence as HTML.
    pub(super) fn html(&self) -> String {
        html(&self.text, &self.language, &self.emphasis, false)
    }
}

/// Code in a language, which may be unknown or empty, as HTML.
pub(super) fn html(code: &str, language: &str, emphasis: &Emphasis, numbered: bool) -> String {
    let code = code.trim_end_matches('\n');
    let lines = highlight::lines(code, language);
    let class = match (numbered, lines.len()) {
        (false, _) | (true, 0 | 1) => "code",
        (true, count) if count < LONG => "code numbered",
        _ => "code numbered long",
    };
    let mut html = format!("<pre class=\"{class}\" tabindex=\"0\"><code");
    if !language.is_empty() {
        let _ = write!(html, " class=\"language-{}\"", escape(language));
    }
    html.push('>');
    for (index, (line, source)) in lines.iter().zip(code.split('\n')).enumerate() {
        let name = if emphasis.holds(index + 1) { "mark" } else { "span" };
        let steps = indent(source);
        let step = if steps == 0 { String::new() } else { format!(" in{steps}") };
        let _ = write!(html, "<{name} class=\"line{step}\">{line}\n</{name}>");
    }
    html.push_str("</code></pre>\n");
    html
}

/// How far a line is indented, in steps of two characters, so that what does not fit goes on below its beginning.
fn indent(line: &str) -> usize {
    let space = line.bytes().map_while(|byte| match byte {
        b' ' => Some(1),
        b'\t' => Some(4),
        _ => None,
    });
    space.sum::<usize>().div_ceil(2).min(STEPS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_knows_its_indent() {
        let found = ["a", "  a", "    a", "\ta", "   a", "", &" ".repeat(99)].map(indent);
        assert_eq!(found, [0, 1, 2, 2, 2, 0, STEPS]);
        assert!(
            html("{\n    a\n", "", &Emphasis::default(), false).contains("<span class=\"line in2\">    a\n</span>")
        );
    }

    #[test]
    fn lines_are_elements_and_hold_the_code_alone() {
        let emphasis = Emphasis::read("2").unwrap_or_default();
        let code = html("a < b\n\nc\n", "", &emphasis, true);
        let expected = "<pre class=\"code numbered\" tabindex=\"0\"><code><span class=\"line\">a &lt; b\n</span>\
                        <mark class=\"line\">\n</mark><span class=\"line\">c\n</span></code></pre>\n";
        assert_eq!(code, expected);
        assert!(
            html("a\n", "\"x", &emphasis, true)
                .starts_with("<pre class=\"code\" tabindex=\"0\"><code class=\"language-&quot;x\">")
        );
        assert!(html(&"a\n".repeat(100), "", &emphasis, true).starts_with("<pre class=\"code numbered long\""));
    }
}
