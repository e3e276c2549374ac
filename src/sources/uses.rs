//! Which entries of catalogues a piece of code uses, read from the paths that it writes.
//!
//! The reading is generous: what might be a use counts as one. Too many uses compute something again; one too few would let a cache lie.

use std::collections::{BTreeMap, BTreeSet};

use super::lex::{Class, Token, close};

/// An entry: its folder and its module, e.g. `("samplers", "halton")`.
pub type Entry<'a> = (&'a str, &'a str);

/// A path as written, with its braces multiplied out.
#[derive(Debug, PartialEq, Eq)]
struct Path<'a> {
    segments: Vec<&'a str>,
    /// Whether it ends in `*` or gets another name, so that what stands below it can be reached unseen.
    opens: bool,
}

/// The entries of the catalogue in a folder's `mod.rs`, and the tokens of that file without the lines that only list them.
///
/// An entry has its line `mod x;` and its line `&x::X,` in a static slice of `&dyn` that holds nothing else.
pub fn catalogue<'a>(tokens: &[Token<'a>]) -> (BTreeSet<&'a str>, Vec<Token<'a>>) {
    let mut listed = BTreeSet::new();
    let mut modules = BTreeMap::new();
    let mut dropped = vec![false; tokens.len()];
    for at in 0..tokens.len() {
        if tokens[at].is("static")
            && let Some((open, names)) = slice(tokens, at)
        {
            dropped[open..open + 4 * names.len() + commas(tokens, open, names.len())].fill(true);
            listed.extend(names);
        } else if let [word, name, end, ..] = &tokens[at..]
            && word.is("mod")
            && name.class == Class::Word
            && end.is(";")
        {
            modules.insert(name.text, (visibility(tokens, at), at + 3));
        }
    }
    listed.retain(|name| modules.contains_key(name));
    for (_, (start, end)) in modules.into_iter().filter(|(name, _)| listed.contains(name)) {
        dropped[start..end].fill(true);
    }
    let kept = tokens.iter().zip(dropped).filter(|(_, dropped)| !dropped).map(|(&token, _)| token).collect();
    (listed, kept)
}

/// For `static NAME: &[&dyn ..] = &[&x::X, &y::Y];` at `at`: the index of the first `&` within, and the modules.
fn slice<'a>(tokens: &[Token<'a>], at: usize) -> Option<(usize, Vec<&'a str>)> {
    let equals = at + tokens[at..].iter().position(|token| token.is("=") || token.is(";"))?;
    let is_catalogue = tokens[at..equals].iter().any(|token| token.is("dyn"));
    let open = equals + 2;
    if !(is_catalogue && tokens.get(equals + 1)?.is("&") && tokens.get(open)?.is("[")) {
        return None;
    }
    let end = close(tokens, open)?;
    let names = tokens[open + 1..end]
        .split(|token| token.is(","))
        .filter(|item| !item.is_empty())
        .map(|item| match item {
            [and, module, path, _] if and.is("&") && path.is("::") => Some(module.text),
            _ => None,
        })
        .collect::<Option<Vec<_>>>()?;
    Some((open + 1, names))
}

/// How many commas stand among the first `names` items after `open`, one after each but perhaps the last.
fn commas(tokens: &[Token<'_>], open: usize, names: usize) -> usize {
    let last = open + (5 * names).saturating_sub(1);
    if tokens.get(last).is_some_and(|token| token.is(",")) { names } else { names.saturating_sub(1) }
}

/// The index where the item whose keyword stands at `at` begins: at its visibility, if it has one.
fn visibility(tokens: &[Token<'_>], at: usize) -> usize {
    match &tokens[..at] {
        [.., word] if word.is("pub") => at - 1,
        [.., word, open, _, close] if word.is("pub") && open.is("(") && close.is(")") => at - 4,
        _ => at,
    }
}

/// The entries among `entries` that the code `tokens`, in a file of `folder`, uses.
pub fn uses<'a>(tokens: &[Token<'a>], folder: &'a str, entries: &BTreeSet<Entry<'a>>) -> BTreeSet<Entry<'a>> {
    let mut found = BTreeSet::new();
    for path in paths(tokens) {
        let below: Vec<&str> =
            path.segments.iter().copied().skip_while(|part| matches!(*part, "crate" | "super" | "self")).collect();
        let below = below.strip_suffix(&["self"]).unwrap_or(&below);
        let rooted = path.segments.first() == Some(&"crate");
        let relative = below.len() < path.segments.len() && !rooted;
        if let [first, second, ..] = below {
            found.extend(entries.get(&(*first, *second)));
        }
        if let [first, rest @ ..] = below
            && (relative || (!rooted && !rest.is_empty()))
        {
            found.extend(entries.get(&(folder, *first)));
        }
        if path.opens {
            let opened = match below {
                [] => folder,
                [first, ..] => first,
            };
            // A name given to a whole folder, or all that is in it: any of its entries may be meant.
            let whole = below.len() <= 1 && !(below.is_empty() && rooted);
            found.extend(entries.iter().filter(|entry| whole && entry.0 == opened));
        }
    }
    found
}

/// Every path that `tokens` write.
fn paths<'a>(tokens: &[Token<'a>]) -> Vec<Path<'a>> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        if tokens[at].class == Class::Word {
            at = tree(tokens, at, &[], &mut found).max(at + 1);
        } else {
            at += 1;
        }
    }
    found
}

/// Reads the path, or the tree of paths, at `at`; gives the index after it.
fn tree<'a>(tokens: &[Token<'a>], mut at: usize, prefix: &[&'a str], found: &mut Vec<Path<'a>>) -> usize {
    let mut segments = prefix.to_vec();
    while let Some(token) = tokens.get(at) {
        match token.class {
            Class::Word => segments.push(token.text.trim_start_matches("r#")),
            Class::Mark if token.text == "*" && at > 0 && before_globs(tokens[at - 1]) => {
                found.push(Path { segments, opens: true });
                return at + 1;
            }
            Class::Mark if token.text == "{" => return group(tokens, at, &segments, found),
            _ => break,
        }
        at += 1;
        if !tokens.get(at).is_some_and(|token| token.is("::")) {
            break;
        }
        at += 1;
    }
    let opens = tokens.get(at).is_some_and(|token| token.is("as"));
    found.push(Path { segments, opens });
    at
}

/// Whether a star after `token` can stand for all names, rather than multiply.
fn before_globs(token: Token<'_>) -> bool {
    token.is("::") || token.is("{") || token.is(",")
}

/// Reads the trees in the braces that open at `open`.
fn group<'a>(tokens: &[Token<'a>], open: usize, prefix: &[&'a str], found: &mut Vec<Path<'a>>) -> usize {
    let end = close(tokens, open).unwrap_or(tokens.len());
    let mut at = open + 1;
    while at < end {
        let word = tokens[at].class == Class::Word || tokens[at].is("*") || tokens[at].is("{");
        at = if word { tree(&tokens[..end], at, prefix, found).max(at + 1) } else { at + 1 };
    }
    end + 1
}

#[cfg(test)]
mod tests {
    use super::super::lex::tokens;
    use super::*;

    const ENTRIES: [Entry<'static>; 5] =
        [("samplers", "halton"), ("samplers", "sobol"), ("integrands", "step"), ("kinds", "points"), ("kinds", "step")];

    fn used(folder: &'static str, source: &str) -> Vec<String> {
        let source: &'static str = String::leak(source.to_owned());
        uses(&tokens(source), folder, &ENTRIES.into_iter().collect()).iter().map(|(a, b)| format!("{a}/{b}")).collect()
    }

    #[test]
    fn sees_every_way_to_write_a_use() {
        for source in [
            "use super::halton::radical_inverse;",
            "use crate::samplers::halton::radical_inverse;",
            "use crate::{points::Points, samplers::{halton::{self, radical_inverse}}};",
            "fn f() { super::halton::radical_inverse(1) }",
            "use crate::samplers; fn f() { samplers::halton::radical_inverse(1) }",
            "use super::*; fn f() { halton::radical_inverse(1) }",
            "mod inner { use super::super::halton; }",
            "macro_rules! m { () => { $crate::samplers::halton::x() } }",
            "use super::{halton as h};",
        ] {
            assert!(used("samplers", source).contains(&"samplers/halton".to_owned()), "{source}");
        }
    }

    #[test]
    fn sees_no_use_where_there_is_none() {
        for source in [
            "use crate::points::Points; fn f(step: f64) -> f64 { step * 2.0 }",
            "// use super::points::X\nconst S: &str = \"super::points::X\";",
            "use crate::samplers::{Method, Sampler}; fn f() { Method::parse(\"halton\") }",
            "fn f() { for i in (0..n).step_by(2) { x as f64; } }",
        ] {
            assert_eq!(used("kinds", source), Vec::<String>::new(), "{source}");
        }
    }

    #[test]
    fn a_folder_opened_whole_counts_whole() {
        assert_eq!(used("kinds", "use crate::samplers as s;"), ["samplers/halton", "samplers/sobol"]);
        assert_eq!(used("kinds", "use crate::samplers::*;"), ["samplers/halton", "samplers/sobol"]);
        assert_eq!(used("kinds", "use super as k;"), ["kinds/points", "kinds/step"]);
    }

    #[test]
    fn a_catalogue_is_read_without_its_lines() {
        let before = "mod a;\npub mod shared;\npub static ALL: &[&dyn Any] = &[&a::A];\nfn rest() {}";
        let after = "mod a;\n/// New.\npub(crate) mod b;\npub mod shared;\n\
                     pub static ALL: &[&dyn Any] = &[\n    &a::A,\n    &b::B,\n];\nfn rest() {}";
        let (few, one) = (tokens(before), tokens(after));
        let (few, one) = (catalogue(&few), catalogue(&one));
        assert_eq!(few.0.into_iter().collect::<Vec<_>>(), ["a"]);
        assert_eq!(one.0.into_iter().collect::<Vec<_>>(), ["a", "b"]);
        let texts =
            |tokens: &[Token<'_>]| tokens.iter().map(|token| token.text.to_owned()).collect::<Vec<_>>().join(" ");
        assert_eq!(texts(&few.1), texts(&one.1));
        assert_eq!(texts(&few.1), "pub mod shared ; pub static ALL : & [ & dyn Any ] = & [ ] ; fn rest ( ) { }");
    }

    #[test]
    fn other_slices_are_no_catalogue() {
        for source in [
            "mod a; static ALL: &[u8] = &[&a::A];",
            "mod a; static ALL: &[&dyn Any] = &[&a::A, &OTHER];",
            "static ALL: &[&dyn Any] = &[&a::A];",
            "mod a; fn f() { g(&a::A, 1) }",
        ] {
            assert!(catalogue(&tokens(source)).0.is_empty(), "{source}");
        }
    }
}
