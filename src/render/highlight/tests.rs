//! Every language by an example, and what no text may break.

use super::languages::LANGUAGES;
use super::scan::{Class, pieces};
use super::*;

/// The words of `code` that have a class, each with its class.
fn classes(code: &str, language: &str) -> Vec<(&'static str, String)> {
    let known = LANGUAGES.iter().find(|known| known.names.contains(&language)).expect("a language");
    let found = pieces(code, known).into_iter();
    found.filter_map(|piece| Some((piece.class.name()?, piece.text.to_owned()))).collect()
}

fn of<'a>(found: &'a [(&'static str, String)], class: &str) -> Vec<&'a str> {
    found.iter().filter(|(name, _)| *name == class).map(|(_, text)| text.as_str()).collect()
}

#[test]
fn rust() {
    let code = "#[must_use]\npub fn inverse<'a, T: Copy>(n: u64, base: &'a [T]) -> f64 {\n    // the digits; \"no\" text\n    \
                let v = 1.5e-3 * r#\"a\"b\"#.len() as f64; /* a /* b */ c */\n    for i in 0..n { vec!['\\'', b'x']; v != 0x1F_u32 }\n}";
    let found = classes(code, "rust");
    assert_eq!(of(&found, "k"), ["pub", "fn", "let", "as", "for", "in"]);
    assert_eq!(of(&found, "t"), ["'a", "T", "Copy", "u64", "'a", "T", "f64", "f64"]);
    assert_eq!(of(&found, "f"), ["inverse", "len", "vec"]);
    assert_eq!(of(&found, "n"), ["1.5e-3", "0", "0x1F_u32"]);
    assert_eq!(of(&found, "s"), ["r#\"a\"b\"#", "'\\''", "b'x'"]);
    assert_eq!(of(&found, "c"), ["// the digits; \"no\" text", "/* a /* b */ c */"]);
    assert_eq!(of(&found, "a"), ["#[must_use]"]);
}

#[test]
fn c() {
    let code = "#include <math.h>\nfloat v = 0.0f; /* a /* b */\nfor (int i = n - 1; i >= 1; i--) swap(x[i], 'c', \"a\\\"b\"); // N\n\
                return i * 0x1p-32 + 1e-5;";
    let found = classes(code, "c");
    assert_eq!(of(&found, "a"), ["#include"]);
    assert_eq!(of(&found, "k"), ["for", "return"]);
    assert_eq!(of(&found, "t"), ["float", "int"]);
    assert_eq!(of(&found, "f"), ["swap"]);
    assert_eq!(of(&found, "n"), ["0.0f", "1", "1", "0x1p-32", "1e-5"]);
    assert_eq!(of(&found, "s"), ["'c'", "\"a\\\"b\""]);
    assert_eq!(of(&found, "c"), ["/* a /* b */", "// N"]);
}

#[test]
fn python() {
    let code = "@cache\ndef halton(n: int, base=2):\n    \"\"\"Two\n    lines.\"\"\"\n    return f'{n}' # not 'closed";
    let found = classes(code, "python");
    assert_eq!(of(&found, "a"), ["@cache"]);
    assert_eq!(of(&found, "k"), ["def", "return"]);
    assert_eq!(of(&found, "f"), ["halton"]);
    assert_eq!(of(&found, "s"), ["\"\"\"Two\n    lines.\"\"\"", "f'{n}'"]);
    assert_eq!(of(&found, "c"), ["# not 'closed"]);
}

#[test]
fn toml_and_shells() {
    let found = classes("[claims]\nid = \"fig-a\" # no\nn.m = [4, 1.5]\ndraft = true\npath = 'c:\\'\n", "toml");
    assert_eq!(of(&found, "a"), ["claims", "id", "n", "m", "draft", "path"]);
    assert_eq!(of(&found, "s"), ["\"fig-a\"", "'c:\\'"]);
    assert_eq!(of(&found, "n"), ["4", "1.5"]);
    assert_eq!((of(&found, "k"), of(&found, "c")), (vec!["true"], vec!["# no"]));
    let found = classes("for f in a#b; do echo \"x $f\"; done # end", "sh");
    assert_eq!((of(&found, "k"), of(&found, "c")), (vec!["for", "in", "do", "done"], vec!["# end"]));
}

#[test]
fn lines_are_whole_and_escaped() {
    let found = lines("/* a\n\n<b> */\nx", "c");
    let expected = ["<span class=\"c\">/* a</span>", "", "<span class=\"c\">&lt;b&gt; */</span>", "x"];
    assert_eq!(found, expected);
    assert_eq!(
        lines("let x = 1;\n\"&\"", "fortran"),
        ["let x = 1;", "&quot;&amp;&quot;"],
        "an unknown language is plain"
    );
    assert_eq!(lines("", ""), [""]);
}

#[test]
fn long_lines_may_break_between_words() {
    let found =
        lines("fn f() -> X { method.points(n, g(d), h(1))?.first::<f64>(0..n).last() } // a().b", "rust").concat();
    for place in [
        "<span class=\"held\">-&gt;</span>",
        "method.<span class=\"f\">points</span>(n, ",
        "</span>))?<wbr>.",
        "::<wbr>&lt;",
        ")<wbr>.<span",
        "// a().b",
    ] {
        assert!(found.contains(place), "{place}: {found}");
    }
    assert!(!lines("a().b(c)", "rust").concat().contains("<wbr>"), "a short line stays whole");
}

#[test]
fn no_text_is_lost_in_any_language() {
    let odd = [
        "",
        "\"",
        "'",
        "/*",
        "#[",
        "#![a",
        "r#\"",
        "b'",
        "0x",
        "1e",
        "1.",
        "'é'",
        "'é",
        "é'",
        "\\",
        "@",
        "#",
        "\"\"\"",
        "'''a",
        "\"\\",
        "[a",
        "= =",
        "r\"\\\"",
        "/* /* */",
        "\u{a0}x",
        "'\\u{7b}'",
        "f'",
        "日本(",
        "\r\n\t",
    ];
    for language in LANGUAGES {
        for a in odd {
            for b in odd {
                let code = format!("{a}{b} fn x");
                let joined: String = pieces(&code, language).iter().map(|piece| piece.text).collect();
                assert_eq!(joined, code, "{}", language.names[0]);
                assert!(pieces(&code, language).iter().all(|piece| !piece.text.is_empty()), "{code}");
            }
        }
    }
}

#[test]
fn languages_have_names_of_their_own() {
    let mut names: Vec<&str> = LANGUAGES.iter().flat_map(|language| language.names).copied().collect();
    let all = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all);
    let named =
        [Class::Comment, Class::Text, Class::Number, Class::Keyword, Class::Type, Class::Function, Class::Attribute];
    let mut classes: Vec<_> = named.iter().filter_map(|class| class.name()).collect();
    classes.sort_unstable();
    classes.dedup();
    assert_eq!(classes.len(), named.len());
}
