//! What each diagnostic means and what to do about it, with a wrong and a right example: one page a code, for the command line and for the guide.
//!
//! A page is the file `explain/CODE.md`: some text, then `Wrong:` and `Right:` with blocks of code. The first word behind a block's language is the
//! file that it is: a path in the course, or `chapter` for what stands in its only chapter; a `console` has the commands. The tests run both.

use std::fmt::Write as _;

use crate::diag::Code;

/// The pages, by their files' names.
mod embedded {
    include!(concat!(env!("OUT_DIR"), "/explain.rs"));
}

/// What a code means.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Explanation {
    /// The code.
    pub code: Code,
    /// What is wrong and what to do, in markdown.
    pub text: String,
    /// What gives this diagnostic and no other.
    pub wrong: Example,
    /// The same without the mistake.
    pub right: Example,
}

/// Something that can be tried.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Example {
    /// What is said of it in parentheses; may be empty.
    pub note: String,
    /// What it is made of.
    pub pieces: Vec<Piece>,
}

/// A part of an example.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// What the text is, as markdown names languages.
    pub language: String,
    /// What it is of the course.
    pub part: Part,
    /// The text.
    pub text: String,
}

/// What a piece is of the course.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Part {
    /// The text of its only chapter, without the front matter.
    Chapter,
    /// A whole file, by its path, and whether it is written as Latin-1.
    File(String, bool),
    /// Commands as they are typed.
    Commands,
}

/// The file in which the text of the only chapter stands.
pub const CHAPTER: &str = "chapters/01-one.md";

/// What `code` means; none if nobody has written it.
pub fn explanation(code: Code) -> Option<Explanation> {
    let name = format!("{}.md", code.id());
    let (_, bytes) = embedded::EXPLANATIONS.iter().find(|(file, _)| *file == name)?;
    read(code, std::str::from_utf8(bytes).ok()?)
}

/// The codes that have a page.
pub fn explained() -> impl Iterator<Item = &'static str> {
    embedded::EXPLANATIONS.iter().filter_map(|(file, _)| file.strip_suffix(".md"))
}

/// Reads a page.
fn read(code: Code, page: &str) -> Option<Explanation> {
    let page = page.replace("\r\n", "\n");
    let head = |line: &str, word: &str| line.starts_with(word) && line.ends_with(':');
    let lines: Vec<&str> = page.lines().collect();
    let wrong = lines.iter().position(|line| head(line, "Wrong"))?;
    let right = lines.iter().position(|line| head(line, "Right"))?;
    let example = |lines: &[&str]| {
        let (first, rest) = lines.split_first()?;
        let note = first.find('(').map_or("", |at| first[at..].trim_matches(['(', ')', ':'])).to_owned();
        Some(Example { note, pieces: pieces(rest) })
    };
    Some(Explanation {
        code,
        text: lines[..wrong].join("\n").trim().to_owned(),
        wrong: example(lines.get(wrong..right)?)?,
        right: example(&lines[right..])?,
    })
}

/// The blocks of code in `lines`.
fn pieces(lines: &[&str]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut lines = lines.iter();
    while let Some(line) = lines.next() {
        let info = line.trim_start_matches('`');
        let fence = &line[..line.len() - info.len()];
        if fence.len() < 3 {
            continue;
        }
        let text: String = lines.by_ref().take_while(|line| **line != fence).fold(String::new(), |mut text, line| {
            let _ = writeln!(text, "{line}");
            text
        });
        let mut words = info.split_whitespace();
        let language = words.next().unwrap_or_default().to_owned();
        let part = match words.next() {
            None => Part::Commands,
            Some("chapter") => Part::Chapter,
            Some(path) => Part::File(path.to_owned(), words.next() == Some("latin1")),
        };
        pieces.push(Piece { language, part, text });
    }
    pieces
}

impl Explanation {
    /// It as people read it on a terminal.
    pub fn for_terminals(&self) -> String {
        let mut out = format!("{}: {}\n\n{}\n", self.code.id(), self.code.meaning(), self.text);
        for (word, example) in [("Wrong", &self.wrong), ("Right", &self.right)] {
            let _ = writeln!(out, "\n{word}{}:", noted(&example.note));
            for piece in &example.pieces {
                let _ =
                    writeln!(out, "{}", named(&piece.part).map_or_else(String::new, |path| format!("\n  {path}\n")));
                for line in piece.text.lines() {
                    let _ = writeln!(out, "{}", format!("    {line}").trim_end());
                }
            }
        }
        out
    }

    /// It as a section of a chapter.
    pub fn for_chapters(&self) -> String {
        let id = self.code.id();
        let mut out = format!("### {id}: {} {{#sec-{}}}\n\n{}\n", self.code.meaning(), id.to_lowercase(), self.text);
        for (word, example) in [("Wrong", &self.wrong), ("Right", &self.right)] {
            let _ = writeln!(out, "\n{word}{}:", noted(&example.note));
            for piece in &example.pieces {
                if let Some(path) = named(&piece.part) {
                    let _ = writeln!(out, "\nIn `{path}`:");
                }
                let fence = "`".repeat(if piece.text.contains("```") { 4 } else { 3 });
                let _ = write!(out, "\n{fence}{}\n{}{fence}\n", piece.language, piece.text);
            }
        }
        out
    }
}

/// What is said of an example, behind its word.
fn noted(note: &str) -> String {
    if note.is_empty() { String::new() } else { format!(" ({note})") }
}

/// The file that a piece is, where it is not the chapter that everything is about.
fn named(part: &Part) -> Option<&str> {
    match part {
        Part::File(path, _) => Some(path),
        Part::Chapter | Part::Commands => None,
    }
}
