//! The scanner: code cut into pieces by the table of its language. Pieces put together again are the code, whatever it is.

use super::languages::{Attribute, Language, Quote};

/// What a piece of code is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    Plain,
    Comment,
    Text,
    Number,
    Keyword,
    Type,
    Function,
    /// An attribute, a directive, a decorator, or the key of a setting.
    Attribute,
}

impl Class {
    /// Its class on the page.
    pub(super) fn name(self) -> Option<&'static str> {
        match self {
            Self::Plain => None,
            Self::Comment => Some("c"),
            Self::Text => Some("s"),
            Self::Number => Some("n"),
            Self::Keyword => Some("k"),
            Self::Type => Some("t"),
            Self::Function => Some("f"),
            Self::Attribute => Some("a"),
        }
    }
}

/// A piece of code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Piece<'a> {
    pub(super) class: Class,
    pub(super) text: &'a str,
}

/// The pieces of `code`, in order and without gaps.
pub(super) fn pieces<'a>(code: &'a str, language: &Language) -> Vec<Piece<'a>> {
    let mut found: Vec<Piece<'a>> = Vec::new();
    let mut at = 0;
    let mut plain = 0;
    while let Some(first) = code[at..].chars().next() {
        let rest = &code[at..];
        let (class, length) = piece(&code[..at], rest, first, language);
        let end = code.ceil_char_boundary((at + length.max(first.len_utf8())).min(code.len()));
        if class != Class::Plain {
            found.extend((plain < at).then(|| Piece { class: Class::Plain, text: &code[plain..at] }));
            found.push(Piece { class, text: &code[at..end] });
            plain = end;
        }
        at = end;
    }
    found.extend((plain < at).then(|| Piece { class: Class::Plain, text: &code[plain..at] }));
    found
}

/// The class and the length of what `rest` begins with.
fn piece(before: &str, rest: &str, first: char, language: &Language) -> (Class, usize) {
    if first.is_whitespace() {
        return (Class::Plain, rest.len() - rest.trim_start().len());
    }
    if let Some(length) = comment(before, rest, language) {
        return (Class::Comment, length);
    }
    if let Some(length) = attribute(before, rest, language) {
        return (Class::Attribute, length);
    }
    if let Some(length) = text(rest, language) {
        return (Class::Text, length);
    }
    if language.lifetimes && first == '\'' {
        return quoted_or_lifetime(rest);
    }
    if language.lifetimes && rest.starts_with("b'") {
        return (Class::Text, 1 + quoted_or_lifetime(&rest[1..]).1);
    }
    if first.is_ascii_digit() {
        return (Class::Number, number(rest));
    }
    if is_word(first) {
        let word = &rest[..word(rest)];
        return (word_class(before, word, &rest[word.len()..], language), word.len());
    }
    (Class::Plain, first.len_utf8())
}

fn comment(before: &str, rest: &str, language: &Language) -> Option<usize> {
    if let Some(mark) = language.line_comment.filter(|mark| rest.starts_with(mark)) {
        // In a shell `#` is a comment only where a word could begin.
        let free =
            mark != "#" || before.is_empty() || before.ends_with(|c: char| c.is_whitespace() || c == ';' || c == ']');
        return free.then(|| rest.find('\n').unwrap_or(rest.len()));
    }
    let (open, close) = language.block_comment.filter(|(open, _)| rest.starts_with(open))?;
    let mut depth = 0_usize;
    let mut at = 0;
    while at < rest.len() {
        let here = &rest[at..];
        if here.starts_with(open) && (depth == 0 || language.nested) {
            depth += 1;
            at += open.len();
        } else if here.starts_with(close) {
            depth -= 1;
            at += close.len();
            if depth == 0 {
                return Some(at);
            }
        } else {
            at += here.chars().next().map_or(1, char::len_utf8);
        }
    }
    Some(rest.len())
}

/// The length of an attribute, directive or decorator at the start of `rest`.
fn attribute(before: &str, rest: &str, language: &Language) -> Option<usize> {
    match language.attribute? {
        Attribute::Bracketed => {
            let open = ["#![", "#["].iter().find(|open| rest.starts_with(**open))?.len() - 1;
            let mut depth = 0_usize;
            let close = rest[open..].find(|c| {
                depth = (depth + usize::from(c == '[')).saturating_sub(usize::from(c == ']'));
                depth == 0
            });
            Some(close.map_or(rest.len(), |at| open + at + 1))
        }
        Attribute::Word(mark) => {
            let after = rest.strip_prefix(mark)?;
            let first = before.rsplit('\n').next().unwrap_or_default().trim().is_empty();
            first.then(|| mark.len() + word(after))
        }
    }
}

/// The length of a text in quotes, with its prefix, at the start of `rest`.
fn text(rest: &str, language: &Language) -> Option<usize> {
    let prefix = language.prefixes.iter().find(|prefix| {
        rest.strip_prefix(**prefix).is_some_and(|rest| rest.starts_with(['"', '\'', '#']) && !rest.starts_with("#["))
    });
    let skipped = prefix.map_or(0, |prefix| prefix.len());
    if prefix.is_some_and(|prefix| language.raw && prefix.contains('r')) {
        let hashes = rest[skipped..].bytes().take_while(|&byte| byte == b'#').count();
        let body = rest[skipped + hashes..].strip_prefix('"')?;
        let close = format!("\"{}", "#".repeat(hashes));
        return Some(body.find(&close).map_or(rest.len(), |at| skipped + hashes + 1 + at + close.len()));
    }
    let after = &rest[skipped..];
    let quote = language.quotes.iter().find(|quote| after.starts_with(quote.mark))?;
    Some(skipped + quote.mark.len() + closed(&after[quote.mark.len()..], quote))
}

/// The length of the rest of a text, its closing quote included. A text of one line ends with it, closed or not.
fn closed(body: &str, quote: &Quote) -> usize {
    let mut escaped = false;
    for (at, c) in body.char_indices() {
        if !escaped && body[at..].starts_with(quote.mark) {
            return at + quote.mark.len();
        }
        if c == '\n' && !quote.lines && !escaped {
            return at;
        }
        escaped = quote.escapes && c == '\\' && !escaped;
    }
    body.len()
}

/// A character, or a lifetime or loop label.
fn quoted_or_lifetime(rest: &str) -> (Class, usize) {
    let body = &rest[1..];
    let quote = Quote { mark: "'", escapes: true, lines: false };
    match body.chars().next() {
        Some('\\') => (Class::Text, 1 + closed(body, &quote)),
        Some(c) if body[c.len_utf8()..].starts_with('\'') => (Class::Text, 2 + c.len_utf8()),
        Some(c) if is_word(c) => (Class::Type, 1 + word(body)),
        _ => (Class::Plain, 1),
    }
}

fn is_word(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

fn word(rest: &str) -> usize {
    rest.find(|c| !is_word(c)).unwrap_or(rest.len())
}

/// The length of a number: digits and letters, a point before a digit, a sign in an exponent.
fn number(rest: &str) -> usize {
    let digit = |at: usize| rest[at..].starts_with(|c: char| c.is_ascii_digit());
    let hexadecimal = rest.starts_with("0x") || rest.starts_with("0X");
    let mut at = 0;
    loop {
        let length = word(&rest[at..]);
        let exponent = if hexadecimal { ['p', 'P'] } else { ['e', 'E'] };
        let raised = rest[at..at + length].ends_with(exponent);
        at += length;
        let next = rest[at..].chars().next();
        let goes_on = match next {
            Some('.') => digit(at + 1),
            Some('+' | '-') => raised && digit(at + 1),
            _ => false,
        };
        if !goes_on {
            return at;
        }
        at += 1;
    }
}

fn word_class(before: &str, word: &str, after: &str, language: &Language) -> Class {
    if language.keywords.contains(&word) {
        return Class::Keyword;
    }
    if language.types.contains(&word) {
        return Class::Type;
    }
    if language.keys {
        let line = before.rsplit('\n').next().unwrap_or_default();
        let path = after.trim_start_matches(|c: char| is_word(c) || "-. \"'".contains(c));
        let key = path.starts_with('=') && !line.contains('=');
        return if key || line.trim_start().starts_with('[') && !line.contains('=') {
            Class::Attribute
        } else {
            Class::Plain
        };
    }
    let capital = word.starts_with(|c: char| c.is_uppercase());
    if language.capitals && capital && (word.len() == 1 || word.contains(|c: char| c.is_lowercase())) {
        return Class::Type;
    }
    let introduced = before.trim_end().rsplit(|c| !is_word(c)).next().is_some_and(|last| ["fn", "def"].contains(&last));
    let macro_call = language.lifetimes && after.starts_with('!') && !after.starts_with("!=");
    if language.calls && (after.starts_with('(') || macro_call || introduced) {
        return Class::Function;
    }
    Class::Plain
}
