//! The languages whose parts the scanner knows: those of the course's listings, and what else a course on numerical methods shows.

/// How a text in quotes is written.
pub(super) struct Quote {
    /// What opens and closes it.
    pub(super) mark: &'static str,
    /// Whether a backslash takes the meaning of the next character.
    pub(super) escapes: bool,
    /// Whether it may go over several lines.
    pub(super) lines: bool,
}

/// What says something about the code around it.
#[derive(Clone, Copy)]
pub(super) enum Attribute {
    /// `#[..]` and `#![..]`.
    Bracketed,
    /// A word with this mark before it, first in its line.
    Word(&'static str),
}

/// The table of a language.
#[allow(clippy::struct_excessive_bools, reason = "a table of what languages have and have not")]
pub(super) struct Language {
    /// What fences and endings of files call it.
    pub(super) names: &'static [&'static str],
    pub(super) line_comment: Option<&'static str>,
    pub(super) block_comment: Option<(&'static str, &'static str)>,
    /// Whether such comments may stand in each other.
    pub(super) nested: bool,
    /// Quotes, the longer ones first.
    pub(super) quotes: &'static [Quote],
    /// Letters that may stand before a quote, the longer ones first.
    pub(super) prefixes: &'static [&'static str],
    /// Whether a prefix with `r` takes hashes, as in Rust.
    pub(super) raw: bool,
    /// Whether a single quote begins a character or a lifetime, as in Rust.
    pub(super) lifetimes: bool,
    pub(super) attribute: Option<Attribute>,
    pub(super) keywords: &'static [&'static str],
    pub(super) types: &'static [&'static str],
    /// Whether names of types begin with a capital.
    pub(super) capitals: bool,
    /// Whether a name before a parenthesis is that of a function.
    pub(super) calls: bool,
    /// Whether it consists of keys and values.
    pub(super) keys: bool,
}

const DOUBLE: Quote = Quote { mark: "\"", escapes: true, lines: false };
const SINGLE: Quote = Quote { mark: "'", escapes: true, lines: false };

/// What a language has if nothing else is said.
const PLAIN: Language = Language {
    names: &[],
    line_comment: None,
    block_comment: None,
    nested: false,
    quotes: &[],
    prefixes: &[],
    raw: false,
    lifetimes: false,
    attribute: None,
    keywords: &[],
    types: &[],
    capitals: false,
    calls: false,
    keys: false,
};

/// Every language.
pub(super) static LANGUAGES: &[Language] = &[
    Language {
        names: &["rust", "rs"],
        line_comment: Some("//"),
        block_comment: Some(("/*", "*/")),
        nested: true,
        quotes: &[Quote { mark: "\"", escapes: true, lines: true }],
        prefixes: &["br", "cr", "b", "c", "r"],
        raw: true,
        lifetimes: true,
        attribute: Some(Attribute::Bracketed),
        keywords: &[
            "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false",
            "fn", "for", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return",
            "self", "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where", "while",
        ],
        types: &[
            "Self", "bool", "char", "f32", "f64", "i128", "i16", "i32", "i64", "i8", "isize", "str", "u128", "u16",
            "u32", "u64", "u8", "usize",
        ],
        capitals: true,
        calls: true,
        ..PLAIN
    },
    Language {
        names: &["c", "h", "cpp", "c++", "cc", "hpp", "cuda", "cu", "glsl"],
        line_comment: Some("//"),
        block_comment: Some(("/*", "*/")),
        quotes: &[DOUBLE, SINGLE],
        attribute: Some(Attribute::Word("#")),
        keywords: &[
            "alignas",
            "auto",
            "break",
            "case",
            "catch",
            "class",
            "const",
            "constexpr",
            "continue",
            "default",
            "delete",
            "do",
            "else",
            "enum",
            "extern",
            "false",
            "for",
            "friend",
            "goto",
            "if",
            "inline",
            "namespace",
            "new",
            "nullptr",
            "operator",
            "private",
            "protected",
            "public",
            "register",
            "restrict",
            "return",
            "sizeof",
            "static",
            "struct",
            "switch",
            "template",
            "this",
            "throw",
            "true",
            "try",
            "typedef",
            "typename",
            "union",
            "using",
            "virtual",
            "volatile",
            "while",
        ],
        types: &[
            "bool",
            "char",
            "double",
            "float",
            "int",
            "int16_t",
            "int32_t",
            "int64_t",
            "int8_t",
            "long",
            "ptrdiff_t",
            "short",
            "signed",
            "size_t",
            "uint",
            "uint16_t",
            "uint32_t",
            "uint64_t",
            "uint8_t",
            "unsigned",
            "void",
            "vec2",
            "vec3",
            "vec4",
        ],
        calls: true,
        ..PLAIN
    },
    Language {
        names: &["python", "py"],
        line_comment: Some("#"),
        quotes: &[
            Quote { mark: "\"\"\"", escapes: true, lines: true },
            Quote { mark: "'''", escapes: true, lines: true },
            DOUBLE,
            SINGLE,
        ],
        prefixes: &["rb", "br", "f", "r", "b", "u"],
        attribute: Some(Attribute::Word("@")),
        keywords: &[
            "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue", "def",
            "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in", "is", "lambda",
            "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
        ],
        types: &["bool", "bytes", "complex", "dict", "float", "int", "list", "set", "str", "tuple"],
        capitals: true,
        calls: true,
        ..PLAIN
    },
    Language {
        names: &["toml", "experiment", "listing"],
        line_comment: Some("#"),
        quotes: &[
            Quote { mark: "\"\"\"", escapes: true, lines: true },
            Quote { mark: "'''", escapes: false, lines: true },
            DOUBLE,
            Quote { mark: "'", escapes: false, lines: false },
        ],
        keywords: &["false", "true"],
        keys: true,
        ..PLAIN
    },
    Language {
        names: &["sh", "bash", "shell"],
        line_comment: Some("#"),
        quotes: &[Quote { mark: "\"", escapes: true, lines: true }, Quote { mark: "'", escapes: false, lines: true }],
        keywords: &[
            "case", "do", "done", "elif", "else", "esac", "export", "fi", "for", "function", "if", "in", "return",
            "then", "while",
        ],
        ..PLAIN
    },
];
