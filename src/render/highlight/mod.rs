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

/// The lines of `code` as HTML, with classes if the language is known.
pub(super) fn lines(code: &str, language: &str) -> Vec<String> {
    let known = LANGUAGES.iter().find(|known| known.names.contains(&language));
    let pieces = match known {
        Some(language) => scan::pieces(code, language),
        None => vec![Piece { class: Class::Plain, text: code }],
    };
    let mut lines = vec![String::new()];
    for Piece { class, text } in pieces {
        for (index, part) in text.split('\n').enumerate() {
            if index > 0 {
                lines.push(String::new());
            }
            let Some(line) = lines.last_mut().filter(|_| !part.is_empty()) else { continue };
            match class.name() {
                // What is blank has no colour.
                Some(name) if !part.trim().is_empty() => {
                    for text in ["<span class=\"", name, "\">", &escape(part), "</span>"] {
                        line.push_str(text);
                    }
                }
                _ => line.push_str(&escape(part)),
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests;
