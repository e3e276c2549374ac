//! Listings: an item of the library, found by its path in the very text that was compiled.

use super::lex::{Class, Token, close, tokens};
use super::{embedded, text};

/// An item as a listing shows it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Item {
    /// The file that defines it, from the folder `src`.
    pub file: &'static str,
    /// The line of that file where the text starts, from 1.
    pub first_line: usize,
    /// The item without its documentation and attributes, moved to the left margin, without a line end at its end.
    pub text: String,
}

/// The item `path` of the library, e.g. `samplers::halton::radical_inverse`: a function, type, constant, trait or macro
/// of a module, or a function of a type (`points::Points::rows`).
pub fn item(path: &str) -> Option<Item> {
    let parts: Vec<&str> = path.split("::").map(str::trim).collect();
    let parts = parts.strip_prefix(&["crate"]).unwrap_or(&parts);
    (1..parts.len()).rev().find_map(|length| {
        let folder = parts[..length].join("/");
        [format!("{folder}.rs"), format!("{folder}/mod.rs")].iter().find_map(|file| {
            let at = embedded::FILES.binary_search_by(|(name, _)| (*name).cmp(file.as_str())).ok()?;
            let (file, _) = embedded::FILES.get(at)?;
            let (first_line, text) = item_in(text(file)?, &parts[length..])?;
            Some(Item { file, first_line, text })
        })
    })
}

/// The paths of all items that a listing can show, in order; for the nearest to a path that is wrong.
pub fn items() -> Vec<String> {
    let mut found = Vec::new();
    for (file, _) in embedded::FILES {
        let (Some(text), Some(module)) = (text(file), file.strip_suffix(".rs")) else { continue };
        let module = module.strip_suffix("/mod").unwrap_or(module).replace('/', "::");
        let tokens = tokens(text);
        found
            .extend(declarations(&tokens).filter(|found| found.named).map(|found| format!("{module}::{}", found.name)));
    }
    found.sort();
    found.dedup();
    found
}

/// A declaration at one level of a file.
struct Declaration<'a> {
    /// The name; for an `impl`, that of the type.
    name: &'a str,
    /// Whether it has a name of its own: everything but an `impl`.
    named: bool,
    /// The first token, after attributes.
    first: usize,
    /// The last token.
    last: usize,
    /// The brace of its body, if it has one.
    open: Option<usize>,
}

/// The first line and the text of the item `path` of a file.
pub(super) fn item_in(source: &str, path: &[&str]) -> Option<(usize, String)> {
    let tokens = tokens(source);
    let (first, rest) = path.split_first()?;
    if rest.is_empty() {
        let found = declarations(&tokens).find(|found| found.named && found.name == *first)?;
        let start = tokens[found.first].start;
        return Some((line_of(source, start), dedented(source, start, tokens[found.last].end())));
    }
    let bodies = declarations(&tokens).filter(|found| found.name == *first);
    bodies.filter_map(|found| Some((found.open?, found.last))).find_map(|(open, end)| {
        let inner = tokens.get(open + 1..end)?;
        let (start, end) = (inner.first()?.start, inner.last()?.end());
        let (line, text) = item_in(&indented(source, start, end), rest)?;
        Some((line + line_of(source, start) - 1, text))
    })
}

/// The bytes `start..end` of `source` with the space before them on their line.
fn indented(source: &str, start: usize, end: usize) -> String {
    let line = source[..start].rfind('\n').map_or(0, |at| at + 1);
    let space = if source[line..start].trim().is_empty() { &source[line..start] } else { "" };
    format!("{space}{}", &source[start..end])
}

/// The line, from 1, of the byte `at`.
fn line_of(source: &str, at: usize) -> usize {
    source[..at].bytes().filter(|&byte| byte == b'\n').count() + 1
}

/// The text `start..end`, its lines moved to the left by as much as the first is indented.
fn dedented(source: &str, start: usize, end: usize) -> String {
    let line = source[..start].rfind('\n').map_or(0, |at| at + 1);
    let indent = source[line..start].bytes().take_while(|&byte| byte == b' ').count();
    let mut lines = source[start..end].lines();
    let mut text = lines.next().unwrap_or_default().to_owned();
    for line in lines {
        let spaces = line.bytes().take_while(|&byte| byte == b' ').count().min(indent);
        text.push('\n');
        text.push_str(&line[spaces..]);
    }
    text
}

/// The declarations at the outermost level of `tokens`.
fn declarations<'t, 'a>(tokens: &'t [Token<'a>]) -> impl Iterator<Item = Declaration<'a>> + 't {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            at = after_attributes(tokens, at);
            tokens.get(at)?;
            let first = at;
            let (open, last) = extent(tokens, first);
            at = last + 1;
            if let Some((name, named)) = name(&tokens[first..=last]) {
                return Some(Declaration { name, named, first, last, open });
            }
        }
    })
}

/// The index after the attributes at `at`.
fn after_attributes(tokens: &[Token<'_>], mut at: usize) -> usize {
    while tokens.get(at).is_some_and(|token| token.is("#")) {
        let open = at + 1 + usize::from(tokens.get(at + 1).is_some_and(|token| token.is("!")));
        match close(tokens, open) {
            Some(end) if tokens[open].is("[") => at = end + 1,
            _ => return at,
        }
    }
    at
}

/// The brace of the body and the last token of the item that starts at `first`.
fn extent(tokens: &[Token<'_>], first: usize) -> (Option<usize>, usize) {
    let end = tokens.len() - 1;
    let value = value_item(&tokens[first..]);
    let mut at = first;
    while at <= end {
        let token = tokens[at];
        if token.is(";") {
            return (None, at);
        }
        if token.is("{") || token.is("(") || token.is("[") {
            let Some(closed) = close(tokens, at) else { return (None, end) };
            if token.is("{") && !value {
                return (Some(at), closed);
            }
            at = closed;
        }
        at += 1;
    }
    (None, end)
}

/// Whether the item ends at its semicolon whatever braces come before: a constant, an import, a type's other name.
fn value_item(tokens: &[Token<'_>]) -> bool {
    let keyword = keyword(tokens);
    keyword.is_some_and(|at| matches!(tokens[at].text, "const" | "static" | "use" | "type" | "let"))
}

/// The index of the keyword that says what the item is.
fn keyword(tokens: &[Token<'_>]) -> Option<usize> {
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let next = tokens.get(at + 1);
        let before_fn = next.is_some_and(|next| ["fn", "unsafe", "async", "extern"].iter().any(|word| next.is(word)));
        match token.text {
            "pub" if next.is_some_and(|next| next.is("(")) => at = close(tokens, at + 1)? + 1,
            "pub" | "unsafe" | "async" | "default" => at += 1,
            "const" | "extern" if before_fn => at += 1,
            "extern" if next.is_some_and(|next| next.class == Class::Text) => at += 2,
            _ => return Some(at),
        }
    }
    None
}

/// The name of an item, and whether it is its own.
fn name<'a>(tokens: &[Token<'a>]) -> Option<(&'a str, bool)> {
    let at = keyword(tokens)?;
    let after = tokens.get(at + 1)?;
    match tokens[at].text {
        "static" | "const" if after.is("mut") => Some((tokens.get(at + 2)?.text, true)),
        "fn" | "struct" | "enum" | "union" | "trait" | "type" | "const" | "static" | "mod"
            if after.class == Class::Word =>
        {
            Some((after.text, true))
        }
        "macro_rules" => Some((tokens.get(at + 2)?.text, true)),
        "impl" => implemented(&tokens[at + 1..]).map(|name| (name, false)),
        _ => None,
    }
}

/// The type that an `impl` is for: the last name of the path before its body, without generics.
fn implemented<'a>(tokens: &[Token<'a>]) -> Option<&'a str> {
    let end = tokens.iter().position(|token| token.is("{") || token.is("where")).unwrap_or(tokens.len());
    let head = &tokens[..end];
    let start = head.iter().rposition(|token| token.is("for")).map_or(0, |at| at + 1);
    let (mut depth, mut name) = (0_usize, None);
    for token in &head[start..] {
        match token.text {
            "<" => depth += 1,
            ">" => depth = depth.saturating_sub(1),
            text if depth == 0 && token.class == Class::Word => name = Some(text),
            _ => {}
        }
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = r#"//! A module.
use a::b;

/// Doc.
#[inline]
pub(crate) const fn digits<'a>(x: &'a [u8; 3]) -> char {
    // A brace in a comment: }
    let _ = "}";
    '}'
}

/// A table.
pub const TABLE: [P; 2] = [P { x: 1 }, P { x: 2 }];

/// A point.
#[derive(Debug)]
pub struct P {
    /// The x.
    x: u8,
}

struct Unit;
struct Pair(u8, u8);

impl<'a, T: Into<u8>> super::Frame<'a, T> for P
where
    T: Copy,
{
    /// Doc.
    fn first(&self) -> u8 {
        self.x
    }

    /// Doc.
    #[must_use]
    fn second(&self) -> u8 {
        match self.x {
            0 => 1,
            x => x,
        }
    }
}

macro_rules! m { () => {}; }

#[cfg(test)]
mod tests {
    fn hidden() {}
}
"#;

    fn found(path: &str) -> Option<(usize, String)> {
        item_in(SOURCE, &path.split("::").collect::<Vec<_>>())
    }

    #[test]
    fn gives_items_without_their_documentation() {
        let (line, text) = found("digits").unwrap();
        assert_eq!(line, 6);
        assert!(text.starts_with("pub(crate) const fn digits<'a>"), "{text}");
        assert!(text.ends_with("    '}'\n}"), "{text}");
        assert_eq!(found("TABLE").unwrap().1, "pub const TABLE: [P; 2] = [P { x: 1 }, P { x: 2 }];");
        assert_eq!(found("P").unwrap(), (17, "pub struct P {\n    /// The x.\n    x: u8,\n}".to_owned()));
        assert_eq!(found("Unit").unwrap().1, "struct Unit;");
        assert_eq!(found("Pair").unwrap().1, "struct Pair(u8, u8);");
        assert_eq!(found("m").unwrap().1, "macro_rules! m { () => {}; }");
        assert_eq!(found("hidden"), None);
        assert_eq!(found("b"), None);
        assert_eq!(found(""), None);
    }

    #[test]
    fn gives_methods_at_the_left_margin() {
        assert_eq!(found("P::first").unwrap(), (30, "fn first(&self) -> u8 {\n    self.x\n}".to_owned()));
        let (line, text) = found("P::second").unwrap();
        assert_eq!(line, 36);
        assert!(text.ends_with("        x => x,\n    }\n}"), "{text}");
        assert_eq!(found("P::third"), None);
    }

    #[test]
    fn finds_items_of_this_library() {
        let found = item("sources::digest::Digest::parse").unwrap();
        assert_eq!(found.file, "sources/digest.rs");
        assert!(found.text.starts_with("pub fn parse(text: &str) -> Option<Self> {"));
        assert_eq!(item("crate::catalogue::find").unwrap().file, "catalogue.rs");
        assert_eq!(item("sources::text").unwrap().file, "sources/mod.rs");
        for wrong in ["", "::", "catalogue", "catalogue::nothing", "nothing::at::all", "é::ü"] {
            assert_eq!(item(wrong), None, "{wrong}");
        }
        assert!(items().contains(&"catalogue::nearest".to_owned()));
    }

    #[test]
    fn every_listed_item_is_found() {
        for path in items() {
            assert!(item(&path).is_some(), "{path}");
        }
    }
}
