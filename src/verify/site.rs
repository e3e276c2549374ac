//! The book as a reader would meet it: every link leads somewhere, every id stands once on its page.

use std::collections::{BTreeMap, BTreeSet};

use super::tags::tags;
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

/// Complains of links within the book that lead nowhere, and of ids that stand twice on a page. `root` is what addresses from the
/// root of the site's host begin with, if that is known.
pub fn check(book: &Book, root: Option<&str>) -> Vec<Diagnostic> {
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
            if let Some(message) = broken(link, path, root, &pages, book) {
                diagnostics.push(Diagnostic::error(Code::BrokenLink, message));
            }
        }
    }
    diagnostics
}

/// Why a link on the page `path` leads nowhere, if it does; what begins with `root` stands in the book as well.
fn broken(link: &str, path: &str, root: Option<&str>, pages: &BTreeMap<&str, Page<'_>>, book: &Book) -> Option<String> {
    let scheme = link.split_once(':').is_some_and(|(scheme, _)| !scheme.contains(['/', '#', '?']));
    if scheme || link.starts_with("//") {
        return None;
    }
    let (file, fragment) = link.split_once('#').unwrap_or((link, ""));
    let file = match (file, root.and_then(|root| file.strip_prefix(root))) {
        ("", _) => path.to_owned(),
        (_, Some("")) => "index.html".to_owned(),
        (_, Some(file)) => file.to_owned(),
        (file, None) => beside(path, file),
    };
    // `#fig-x:step=5` leads to a step of a figure.
    let fragment = fragment.split_once(":step=").map_or(fragment, |(id, _)| id);
    if !book.files.contains_key(&file) {
        return Some(format!("a link on `{path}` leads to `{link}`, which is not in the book"));
    }
    let missing = !fragment.is_empty() && pages.get(file.as_str()).is_some_and(|page| !page.ids.contains(fragment));
    missing.then(|| format!("a link on `{path}` leads to `{link}`, but `{file}` has no such id"))
}

/// The path in the book of the `file` that the page `path` names.
fn beside(path: &str, file: &str) -> String {
    let mut parts: Vec<&str> = path.split('/').collect();
    parts.pop();
    for part in file.split('/') {
        match part {
            "." => {}
            // Above the book there is nothing of it: such a path is not found.
            ".." if parts.last().is_some_and(|last| *last != "..") => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

/// Gathers ids and links from a page's tags.
fn read(text: &str) -> Page<'_> {
    let mut page = Page::default();
    for (name, value) in tags(text).flat_map(|tag| tag.attributes) {
        match name {
            "id" if page.ids.contains(value) => drop(page.repeated.insert(value)),
            "id" => drop(page.ids.insert(value)),
            "href" | "src" => page.links.push(value),
            _ => {}
        }
    }
    page
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::render::Book;

    fn messages(pages: &[(&str, &str)]) -> Vec<String> {
        let files = pages.iter().map(|(path, text)| ((*path).to_owned(), text.as_bytes().to_vec())).collect();
        check(&Book { files }, Some("/course/")).into_iter().map(|diagnostic| diagnostic.message).collect()
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
        let elsewhere = [
            ("404.html", r#"<a href="/course/">a</a><a href="/course/index.html#x">b</a>"#),
            ("deep/old.html", r#"<a href="../index.html#x">c</a><a href="./old.html">d</a>"#),
            ("index.html", r#"<p id="x"><a href='deep/old.html'>e</a>"#),
        ];
        assert_eq!(messages(&elsewhere), Vec::<String>::new());
        let lost = [(
            "deep/old.html",
            r#"<a href="old.html">a</a><a href="/other/">b</a><a href="../../x">c</a><a href='y'>d</a>"#,
        )];
        assert_eq!(messages(&lost).len(), 3, "a page may lead to itself");
        let broken = messages(&[("a.html", r##"<p id="x"></p><p id="x"><a href="#z">z</a><a href="c.html">c</a>"##)]);
        assert_eq!(broken.len(), 3);
        assert!(broken[0].contains("`x` stands twice") && broken[1].contains("#z") && broken[2].contains("c.html"));
    }
}
