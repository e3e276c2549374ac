//! The book as a reader would meet it: every link leads somewhere, every id stands once on its page.

use std::collections::{BTreeMap, BTreeSet};

use crate::diag::{Code, Diagnostic};
use crate::render::Book;
use crate::workspace::extension;

/// What a page's tags say about ids and links.
#[derive(Default)]
struct Page<'a> {
    ids: BTreeSet<&'a str>,
    repeated: BTreeSet<&'a str>,
    links: Vec<&'a str>,
}

/// Complains of links within the book that lead nowhere, of other hosts' resources, and of ids that stand twice on a page.
pub fn check(book: &Book) -> Vec<Diagnostic> {
    let mut pages = BTreeMap::new();
    for (path, bytes) in book.files.iter().filter(|(path, _)| extension(path) == Some("html")) {
        let text = std::str::from_utf8(bytes).unwrap_or_default();
        pages.insert(path.as_str(), read(text));
    }
    let mut diagnostics = Vec::new();
    for (path, page) in &pages {
        for id in &page.repeated {
            diagnostics.push(Diagnostic::error(Code::RepeatedId, format!("the id `{id}` stands twice on `{path}`")));
        }
        for link in &page.links {
            if let Some(message) = broken(link, path, &pages, book) {
                diagnostics.push(Diagnostic::error(Code::BrokenLink, message));
            }
        }
    }
    diagnostics
}

/// Why a link on the page `path` leads nowhere, if it does.
fn broken(link: &str, path: &str, pages: &BTreeMap<&str, Page<'_>>, book: &Book) -> Option<String> {
    let scheme = link.split_once(':').is_some_and(|(scheme, _)| !scheme.contains(['/', '#', '?']));
    if scheme || link.starts_with("//") {
        return None;
    }
    let (file, fragment) = link.split_once('#').unwrap_or((link, ""));
    let file = if file.is_empty() { path } else { file };
    // `#fig-x:step=5` leads to a step of a figure.
    let fragment = fragment.split_once(":step=").map_or(fragment, |(id, _)| id);
    if !book.files.contains_key(file) {
        return Some(format!("a link on `{path}` leads to `{link}`, which is not in the book"));
    }
    let missing = !fragment.is_empty() && pages.get(file).is_some_and(|page| !page.ids.contains(fragment));
    missing.then(|| format!("a link on `{path}` leads to `{link}`, but `{file}` has no such id"))
}

/// Gathers ids and links from a page's tags.
fn read(text: &str) -> Page<'_> {
    let mut page = Page::default();
    let mut rest = text;
    while let Some(open) = rest.find('<') {
        let tag = &rest[open..];
        let close = tag_end(tag);
        for (name, value) in attributes(&tag[..close]) {
            match name {
                "id" if page.ids.contains(value) => drop(page.repeated.insert(value)),
                "id" => drop(page.ids.insert(value)),
                "href" | "src" => page.links.push(value),
                _ => {}
            }
        }
        rest = &tag[close.max(1)..];
    }
    page
}

/// Where a tag ends: at the first `>` outside of quotes.
fn tag_end(tag: &str) -> usize {
    let mut quote = None;
    for (at, byte) in tag.bytes().enumerate() {
        match (quote, byte) {
            (None, b'>') => return at,
            (None, b'"' | b'\'') => quote = Some(byte),
            (Some(open), byte) if open == byte => quote = None,
            _ => {}
        }
    }
    tag.len()
}

/// The attributes of a tag that have values in double quotes.
fn attributes(tag: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = tag;
    std::iter::from_fn(move || {
        let (before, after) = rest.split_once("=\"")?;
        let (value, behind) = after.split_once('"')?;
        rest = behind;
        let name = before.rsplit(|c: char| c.is_ascii_whitespace()).next().unwrap_or_default();
        Some((name, value))
    })
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::render::Book;

    fn messages(pages: &[(&str, &str)]) -> Vec<String> {
        let files = pages.iter().map(|(path, text)| ((*path).to_owned(), text.as_bytes().to_vec())).collect();
        check(&Book { files }).into_iter().map(|diagnostic| diagnostic.message).collect()
    }

    #[test]
    fn links_and_ids_are_followed_across_pages() {
        let sound = messages(&[
            (
                "a.html",
                r##"<p id="x" title="a > b"><a href="#x">x</a><a href="b.html#y">y</a><a href="b.html#y:step=3">step</a><a href="https://example.org/#q">out</a>"##,
            ),
            ("b.html", r#"<p id="y"><img src="picture.png">"#),
            ("picture.png", ""),
        ]);
        assert_eq!(sound, Vec::<String>::new());
        let broken = messages(&[("a.html", r##"<p id="x"></p><p id="x"><a href="#z">z</a><a href="c.html">c</a>"##)]);
        assert_eq!(broken.len(), 3);
        assert!(broken[0].contains("`x` stands twice") && broken[1].contains("#z") && broken[2].contains("c.html"));
    }
}
