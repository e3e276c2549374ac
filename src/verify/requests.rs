//! No request to another host: a page loads only what is in the book, so that it works from a folder, and tells nobody who reads it.

use super::tags::{Tag, tags};
use crate::diag::{Code, Diagnostic};
use crate::render::Book;
use crate::workspace::extension;

/// The attributes whose addresses a browser loads by itself.
const LOADED: [&str; 7] = ["src", "poster", "data", "background", "manifest", "ping", "action"];
/// The elements whose `href` is followed only by a reader, or says something and is followed by nobody.
const FOLLOWED: [&str; 2] = ["a", "area"];
/// What a `link` can be without being loaded.
const SAID: [&str; 9] = ["canonical", "prev", "next", "alternate", "author", "license", "help", "me", "bookmark"];

/// Complains of everything in the book that asks another host for something.
pub fn check(book: &Book) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    for (path, bytes) in &book.files {
        if !["html", "svg", "css"].iter().any(|kind| extension(path) == Some(kind)) {
            continue;
        }
        let text = std::str::from_utf8(bytes).unwrap_or_default();
        let found: Vec<String> = match extension(path) {
            // Most drawings name no address but those of their own formats.
            _ if text.split("//").skip(1).all(|rest| rest.starts_with("www.w3.org/")) => continue,
            Some("html" | "svg") => tags(text).flat_map(|tag| asked(&tag)).collect(),
            _ => styled(text).filter(|url| is_foreign(url)).map(|url| format!("url({url})")).collect(),
        };
        diagnostics.extend(found.into_iter().map(|what| {
            Diagnostic::error(Code::ForeignRequest, format!("`{path}` asks another host: `{what}`"))
                .help("keep a copy in the course and name that: pages work offline, and tell nobody who reads them")
        }));
    }
    diagnostics
}

/// What a tag asks another host for.
fn asked(tag: &Tag<'_>) -> Vec<String> {
    let said = |name: &str, value: &str| format!("<{} {name}=\"{value}\">", tag.name);
    let mut found = Vec::new();
    for &(name, value) in &tag.attributes {
        let lower = name.to_ascii_lowercase();
        let foreign = match lower.as_str() {
            name if LOADED.contains(&name) => is_foreign(value),
            "href" | "xlink:href" => is_loaded(tag) && is_foreign(value),
            "srcset" | "imagesrcset" => value.split(',').any(|part| is_foreign(part.trim_ascii_start())),
            "content" => refreshed(tag, value).is_some_and(is_foreign),
            _ if value.contains("url(") => styled(value).any(is_foreign),
            _ => false,
        };
        found.extend(foreign.then(|| said(name, value)));
    }
    if tag.name.eq_ignore_ascii_case("style") {
        found.extend(styled(tag.text).filter(|url| is_foreign(url)).map(|url| format!("url({url})")));
    }
    found
}

/// Whether a browser loads the `href` of a tag.
fn is_loaded(tag: &Tag<'_>) -> bool {
    if tag.name.eq_ignore_ascii_case("link") {
        return !tag.get("rel").unwrap_or_default().split_ascii_whitespace().all(|rel| SAID.contains(&rel));
    }
    !FOLLOWED.iter().any(|name| tag.name.eq_ignore_ascii_case(name))
}

/// Where a page that refreshes itself leads.
fn refreshed<'p>(tag: &Tag<'p>, content: &'p str) -> Option<&'p str> {
    tag.get("http-equiv").filter(|kind| kind.eq_ignore_ascii_case("refresh"))?;
    content.split_once('=').map(|(_, url)| url.trim_matches(|c: char| c.is_ascii_whitespace() || "'\"".contains(c)))
}

/// The addresses in a style: those in `url(..)`, and those that `@import` names without it.
fn styled(style: &str) -> impl Iterator<Item = &str> {
    let quotes = |c: char| c.is_ascii_whitespace() || "'\"".contains(c);
    let urls = style.split("url(").skip(1).filter_map(|rest| rest.split(')').next());
    let imports = style.split("@import").skip(1).filter_map(|rest| rest.split(';').next());
    urls.map(move |url| url.trim_matches(quotes)).chain(imports.map(move |url| url.trim_matches(quotes)))
}

/// Whether an address leads out of the book. What it holds itself leads nowhere.
fn is_foreign(url: &str) -> bool {
    let url = url.trim_ascii_start();
    let scheme = url.split_once(':').map(|(scheme, _)| scheme).filter(|scheme| !scheme.contains(['/', '#', '?', '(']));
    url.starts_with("//") || scheme.is_some_and(|scheme| !["data", "about"].contains(&&*scheme.to_ascii_lowercase()))
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::render::Book;

    fn complaints(path: &str, text: &str) -> usize {
        let files = [(path.to_owned(), text.as_bytes().to_vec())].into();
        check(&Book { files }).len()
    }

    #[test]
    fn whatever_a_browser_would_load_from_elsewhere_is_told() {
        let wrong = [
            "<script src=\"https://example.org/a.js\"></script>",
            "<script src='//example.org/a.js'></script>",
            "<img src=HTTP://example.org/a.png>",
            "<img src=\"a.png\" srcset=\"a.png 1x, https://example.org/b.png 2x\">",
            "<link rel=\"stylesheet\" href=\"https://example.org/a.css\">",
            "<link rel=\"canonical preload\" href=\"https://example.org/a.css\">",
            "<link href=\"https://example.org/a.css\" rel=\"preconnect\">",
            "<base href=\"https://example.org/\">",
            "<iframe src=\"https://example.org/\"></iframe>",
            "<object data=\"https://example.org/\"></object>",
            "<p style=\"background: url('https://example.org/a.png')\">",
            "<style>@import \"https://example.org/a.css\";</style>",
            "<style>p { background: url(//example.org/a.png) }</style>",
            "<svg><use href=\"https://example.org/a.svg#b\"/><image xlink:href=\"https://example.org/a.png\"/></svg>",
            "<meta http-equiv=\"refresh\" content=\"0; url=https://example.org/\">",
            "<a href=\"a.html\" ping=\"https://example.org/\">a</a>",
        ];
        for wrong in wrong {
            let count = if wrong.contains("<use") { 2 } else { 1 };
            assert_eq!(complaints("a.html", wrong), count, "{wrong}");
        }
        assert_eq!(complaints("a.css", "a { b: url( \"https://example.org/x.woff2\" ) }"), 1);
        assert_eq!(complaints("a.svg", "<image href='https://example.org/a.png'/>"), 1);
    }

    #[test]
    fn what_only_a_reader_follows_is_fine() {
        let sound = "<a href=\"https://example.org/\">a</a><link rel=\"canonical\" href=\"https://example.org/a.html\">\
            <link rel=\"icon\" href=\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg'/%3E\">\
            <meta property=\"og:image\" content=\"https://example.org/card.png\"><img src=\"a.png\">\
            <meta http-equiv=\"refresh\" content=\"0; url=b.html\"><svg xmlns=\"http://www.w3.org/2000/svg\" fill=\"url(#a)\">\
            <p title=\"https://example.org/\">";
        assert_eq!(complaints("a.html", sound), 0);
        assert_eq!(complaints("a.css", "a { b: url(fonts/x.woff2); c: url(data:font/woff2;base64,AA) }"), 0);
    }
}
