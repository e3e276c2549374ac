//! Just enough of a lexer for Rust to tell code from comments and texts.

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// An identifier or keyword.
    Word,
    /// A number.
    Number,
    /// A string, byte string or character, with its quotes.
    Text,
    /// A lifetime or loop label, with its quote.
    Lifetime,
    /// One character of punctuation, or `::`.
    Mark,
}

/// A token: a piece of code that is neither space nor comment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token<'a> {
    /// What it is.
    pub class: Class,
    /// As written.
    pub text: &'a str,
    /// Its first byte in the source.
    pub start: usize,
}

impl Token<'_> {
    /// The byte after its last in the source.
    pub fn end(&self) -> usize {
        self.start + self.text.len()
    }

    /// Whether it is the word `word` or the mark `word`.
    pub fn is(&self, word: &str) -> bool {
        matches!(self.class, Class::Word | Class::Mark) && self.text == word
    }
}

/// The tokens of `source`. Text that is not Rust gives some tokens, never a panic.
pub fn tokens(source: &str) -> Vec<Token<'_>> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(first) = source.get(at..).and_then(|rest| rest.chars().next()) {
        let rest = &source[at..];
        if let Some(length) = blank(rest, first) {
            at += length;
            continue;
        }
        let (class, length) = token(rest, first);
        let end = (at + length.max(first.len_utf8())).min(source.len());
        found.push(Token { class, text: &source[at..end], start: at });
        at = end;
    }
    found
}

/// The length of the space or comment at the start of `rest`, if there is one.
fn blank(rest: &str, first: char) -> Option<usize> {
    if first.is_whitespace() {
        Some(first.len_utf8())
    } else if rest.starts_with("//") {
        Some(rest.find('\n').unwrap_or(rest.len()))
    } else if rest.starts_with("/*") {
        Some(block_comment(rest.as_bytes()))
    } else {
        None
    }
}

/// The length of the block comment, which may hold others, at the start of `rest`.
fn block_comment(rest: &[u8]) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while at < rest.len() {
        if rest[at..].starts_with(b"/*") {
            depth += 1;
            at += 2;
        } else if rest[at..].starts_with(b"*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += 1;
        }
    }
    rest.len()
}

/// The class and length of the token at the start of `rest`.
fn token(rest: &str, first: char) -> (Class, usize) {
    if let Some(length) = string(rest) {
        return (Class::Text, length);
    }
    match first {
        '\'' => quote(rest),
        'b' if rest.starts_with("b'") => (Class::Text, 1 + quote(&rest[1..]).1),
        '0'..='9' => (Class::Number, number(rest)),
        _ if is_word(first) => (Class::Word, word(rest)),
        _ if rest.starts_with("::") => (Class::Mark, 2),
        _ => (Class::Mark, first.len_utf8()),
    }
}

fn is_word(char: char) -> bool {
    char == '_' || char.is_alphanumeric()
}

/// The length of the identifier at the start of `rest`, a raw one included.
fn word(rest: &str) -> usize {
    let skipped = if rest.starts_with("r#") { 2 } else { 0 };
    skipped + rest[skipped..].find(|char| !is_word(char)).unwrap_or(rest.len() - skipped)
}

/// The length of the number at the start of `rest`; a sign within it is left to be a mark.
fn number(rest: &str) -> usize {
    let whole = word(rest);
    let fraction =
        rest[whole..].strip_prefix('.').filter(|after| after.starts_with(|char: char| char.is_ascii_digit()));
    whole + fraction.map_or(0, |digits| 1 + word(digits))
}

/// The length of the string, plain or raw, with any prefix, at the start of `rest`.
fn string(rest: &str) -> Option<usize> {
    let prefix = rest.bytes().take_while(|byte| matches!(byte, b'b' | b'c' | b'r')).count();
    let raw = match &rest[..prefix] {
        "" | "b" | "c" => false,
        "r" | "br" | "cr" => true,
        _ => return None,
    };
    let hashes = if raw { rest[prefix..].bytes().take_while(|&byte| byte == b'#').count() } else { 0 };
    let body = rest[prefix + hashes..].strip_prefix('"')?;
    let opened = prefix + hashes + 1;
    if raw {
        let close = format!("\"{}", "#".repeat(hashes));
        return Some(body.find(&close).map_or(rest.len(), |at| opened + at + close.len()));
    }
    Some(closing(body, b'"').map_or(rest.len(), |at| opened + at + 1))
}

/// Where the unescaped `quote` stands in `body`.
fn closing(body: &str, quote: u8) -> Option<usize> {
    let mut escaped = false;
    body.bytes().position(|byte| {
        let closes = byte == quote && !escaped;
        escaped = byte == b'\\' && !escaped;
        closes
    })
}

/// The character or the lifetime at the start of `rest`, which begins with a single quote.
fn quote(rest: &str) -> (Class, usize) {
    let body = &rest[1..];
    let first = body.chars().next();
    let character = match first {
        Some('\\') => true,
        Some(char) => body[char.len_utf8()..].starts_with('\''),
        None => false,
    };
    if character {
        return (Class::Text, closing(body, b'\'').map_or(rest.len(), |at| at + 2));
    }
    if first.is_some_and(is_word) { (Class::Lifetime, 1 + word(body)) } else { (Class::Mark, 1) }
}

/// For the opening bracket at `tokens[open]`, the index of the bracket that closes it.
pub fn close(tokens: &[Token<'_>], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        if token.class != Class::Mark {
            continue;
        }
        match token.text {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(source: &str) -> Vec<&str> {
        tokens(source).into_iter().map(|token| token.text).collect()
    }

    #[test]
    fn leaves_comments_out() {
        assert_eq!(texts("a // b\n/* c /* d */ e */ f /// g"), ["a", "f"]);
        assert_eq!(texts("a /* open"), ["a"]);
    }

    #[test]
    fn keeps_strings_whole() {
        assert_eq!(texts(r#"("a\"}{", b"\\", c"x")"#), ["(", r#""a\"}{""#, ",", r#"b"\\""#, ",", r#"c"x""#, ")"]);
        assert_eq!(texts("r#\"a\"{\"# br\"\\\" x"), ["r#\"a\"{\"#", "br\"\\\"", "x"]);
        assert_eq!(texts("\"// no\" r#type crab break"), ["\"// no\"", "r#type", "crab", "break"]);
        assert_eq!(texts("\"open"), ["\"open"]);
    }

    #[test]
    fn tells_characters_from_lifetimes() {
        assert_eq!(
            texts(r"'{' '\'' '\u{7b}' b'}' b'\\' &'a str 'é'"),
            ["'{'", r"'\''", r"'\u{7b}'", "b'}'", r"b'\\'", "&", "'a", "str", "'é'"]
        );
    }

    #[test]
    fn numbers_and_paths() {
        assert_eq!(
            texts("0..n 1.5e3 x.0 2_u32 a::b<c>"),
            ["0", ".", ".", "n", "1.5e3", "x", ".", "0", "2_u32", "a", "::", "b", "<", "c", ">"]
        );
    }

    #[test]
    fn never_panics_on_cut_text() {
        let source = "fn é<'a>(x: &'a str) -> char { /* ü */ let s = r#\"π\"#; let b = b\"\\\"\"; 'ß' } // ende";
        for (at, _) in source.char_indices() {
            let (head, tail) = source.split_at(at);
            assert!(tokens(head).len() + tokens(tail).len() > 3);
        }
    }

    #[test]
    fn finds_the_closing_bracket() {
        let tokens = tokens("{ a(b[0]) '}' } c");
        assert_eq!(close(&tokens, 0).map(|at| tokens[at + 1].text), Some("c"));
        assert_eq!(close(&tokens[..3], 0), None);
    }
}
