//! The map of the site: each of its addresses is a page of the book.

use crate::diag::{Code, Diagnostic};
use crate::render::{Book, SITEMAP};

/// Complains of entries that lead to no page of the book, which stands at `base`.
pub(super) fn check(book: &Book, base: Option<&str>) -> Vec<Diagnostic> {
    let Some(map) = book.files.get(SITEMAP).and_then(|bytes| std::str::from_utf8(bytes).ok()) else {
        return Vec::new();
    };
    let entries = map.split("<loc>").skip(1).filter_map(|rest| rest.split("</loc>").next());
    let lost = entries.filter(|entry| match base.and_then(|base| entry.strip_prefix(base)) {
        Some("") => !book.files.contains_key("index.html"),
        Some(page) => !book.files.contains_key(page),
        None => true,
    });
    let told = lost.map(|entry| format!("`{SITEMAP}` names `{entry}`, which is not in the book"));
    told.map(|message| Diagnostic::error(Code::BrokenLink, message)).collect()
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::render::{Book, SITEMAP};

    #[test]
    fn every_entry_is_a_page() {
        let lost = |map: &str| {
            let files = [(SITEMAP, map), ("index.html", ""), ("one.html", "")];
            let files = files.map(|(path, text)| (path.to_owned(), text.as_bytes().to_vec())).into();
            check(&Book { files }, Some("https://example.org/a/")).len()
        };
        assert_eq!(lost("<loc>https://example.org/a/</loc><loc>https://example.org/a/one.html</loc>"), 0);
        assert_eq!(lost("<loc>https://example.org/a/two.html</loc><loc>https://example.org/one.html</loc>"), 2);
    }
}
