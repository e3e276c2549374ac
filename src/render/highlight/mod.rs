//! Code with its parts marked by classes, which the style sheet colours in both themes.
//!
//! One scanner reads every language by a table of its own: comments, texts, numbers and words are all that a page of ten or twenty lines
//! needs to be read with ease, and such a scanner costs neither a C compiler nor time while the program is built. A language without a
//! table is shown plain.

mod languages;
mod scan;

use crate::plan::escape;

use languages::LANGUAGES;
use scan::{Class, Piece};

/// A line of more characters than this may be too long for a small screen.
const LONG: usize = 34;

/// The lines of `code` as HTML, with classes if the language is known.
pub(super) fn lines(code: &str, language: &str) -> Vec<String> {
    let known = LANGUAGES.iter().find(|known| known.names.contains(&language));
    let pieces = match known {
        Some(language) => scan::pieces(code, language),
        None => vec![Piece { class: Class::Plain, text: code }],
    };
    let long: Vec<bool> = code.split('\n').map(|line| line.chars().count() > LONG).collect();
    let mut lines = vec![String::new()];
    let mut pieces = pieces.into_iter().peekable();
    while let Some(Piece { class, text }) = pieces.next() {
        let before_word = pieces.peek().is_some_and(|next| next.class != Class::Number);
        for (index, part) in text.split('\n').enumerate() {
            if index > 0 {
                lines.push(String::new());
            }
            let at = lines.len() - 1;
            let Some(line) = lines.last_mut().filter(|_| !part.is_empty()) else { continue };
            match class.name() {
                // What is blank has no colour.
                Some(name) if !part.trim().is_empty() => {
                    for text in ["<span class=\"", name, "\">", &escape(part), "</span>"] {
                        line.push_str(text);
                    }
                }
                _ if long[at] => line.push_str(&breakable(part, before_word)),
                _ => line.push_str(&escape(part)),
            }
        }
    }
    lines
}

/// Signs between words, with places at which a line that is too long is broken rather than within a word: before a method of what was
/// called, behind a path's colons, and behind a bracket if a `word` follows. An arrow is not torn.
fn breakable(signs: &str, word: bool) -> String {
    let html = escape(signs).replace("::", "::<wbr>").replace(").", ")<wbr>.").replace("?.", "?<wbr>.");
    let html = html.replace("-&gt;", "<span class=\"held\">-&gt;</span>");
    if word && html.ends_with('(') { html + "<wbr>" } else { html }
}

#[cfg(test)]
mod tests;
