//! An entry's own text: the `//!` comment of its file, which is its manual page.

/// The comment at the top of a file, taken apart.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Manual {
    /// Its first paragraph.
    pub(super) title: String,
    /// The paragraphs behind it, each with the words in bold that it begins with, if it does, without their full stop.
    pub(super) parts: Vec<(String, String)>,
    /// The code of its example, without the lines that only the compiler needs.
    pub(super) example: Option<String>,
}

impl Manual {
    /// Reads the text of a file.
    pub(super) fn read(source: &str) -> Self {
        let lines = source.lines().map_while(|line| line.strip_prefix("//!"));
        let mut paragraphs: Vec<String> = vec![String::new()];
        let mut example: Option<Vec<&str>> = None;
        let mut code = false;
        for line in lines.map(|line| line.strip_prefix(' ').unwrap_or(line)) {
            if line.starts_with("```") {
                code = !code;
                example.get_or_insert_default();
            } else if code {
                let hidden = line == "#" || line.starts_with("# ");
                if let Some(code) = example.as_mut().filter(|_| !hidden) {
                    code.push(line);
                }
            } else if line.is_empty() {
                paragraphs.push(String::new());
            } else if let Some(last) = paragraphs.last_mut() {
                if !last.is_empty() {
                    last.push(' ');
                }
                last.push_str(line);
            }
        }
        let mut paragraphs = paragraphs.into_iter().filter(|paragraph| !paragraph.is_empty());
        let title = paragraphs.next().unwrap_or_default();
        Self {
            title,
            parts: paragraphs.map(|text| headed(&text)).collect(),
            example: example.map(|code| code.join("\n")),
        }
    }
}

/// A paragraph without the bold words that it begins with, and those.
fn headed(text: &str) -> (String, String) {
    let head = text.strip_prefix("**").and_then(|rest| rest.split_once("**"));
    match head {
        Some((head, rest)) => (head.trim_end_matches('.').to_owned(), rest.trim_start().to_owned()),
        None => (String::new(), text.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::Manual;

    #[test]
    fn a_comment_is_taken_apart() {
        let text = "//! Points: many\n//! of them.\n//!\n//! **What.** One\n//! by one.\n//!\n//! Plain.\n//!\n//! ```\n//! let x = 1;\n//! # Ok(())\n//! ```\n\nuse x;\n//! no\n";
        let part = |head: &str, words: &str| (head.to_owned(), words.to_owned());
        let expected = Manual {
            title: "Points: many of them.".to_owned(),
            parts: vec![part("What", "One by one."), part("", "Plain.")],
            example: Some("let x = 1;".to_owned()),
        };
        assert_eq!(Manual::read(text), expected);
    }
}
