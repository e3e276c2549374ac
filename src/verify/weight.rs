//! The weight of the site, held against the budgets of `[budgets]`: what a reader waits for, and what a publisher stores.

use super::tags::tags;
use crate::diag::{Code, Diagnostic};
use crate::parse::Course;
use crate::render::{Book, FIGURES};
use crate::workspace::extension;

/// The bytes in a unit of the budgets.
const UNIT: usize = 1000;

/// How many of the heaviest a diagnostic names.
const NAMED: usize = 3;

/// What a page can consist of, each with the beginning and the end of such a part. The first is not counted as the page.
const PARTS: [(&str, &str, &str); 5] = [
    ("pictures", "<svg", "</svg>"),
    ("how exhibits were made", "<details class=\"provenance\"", "</details>"),
    ("formulas", "<math", "</math>"),
    ("tables", "<table", "</table>"),
    ("code", "<pre", "</pre>"),
];

/// Complains of chapters' pages, of files and of a site that are heavier than they may be.
pub fn check(book: &Book, course: &Course) -> Vec<Diagnostic> {
    let budgets = &course.configuration.budgets;
    let mut diagnostics = Vec::new();
    for chapter in &course.chapters {
        let path = format!("{}.html", chapter.slug);
        let Some(page) = book.files.get(&path).and_then(|bytes| std::str::from_utf8(bytes).ok()) else { continue };
        // Pictures can only make it lighter.
        if page.len() > budgets.page * UNIT {
            diagnostics.extend(heavy_page(&path, page, budgets.page));
        }
    }
    for (path, bytes) in &book.files {
        let is_page = extension(path) == Some("html") || path == FIGURES;
        if !is_page && bytes.len() > budgets.file * UNIT {
            let help = "a smaller picture, fewer points or rows; or a larger budget";
            diagnostics.push(heavy(&format!("`{path}`"), bytes.len(), ("file", budgets.file)).help(help));
        }
    }
    let total: usize = book.files.values().map(Vec::len).sum();
    if total > budgets.site * UNIT {
        diagnostics.push(heavy("the site", total, ("site", budgets.site)).help(folders(book)));
    }
    diagnostics
}

fn heavy(what: &str, bytes: usize, (key, budget): (&str, usize)) -> Diagnostic {
    let message = format!("{what} weighs {}; its budget is {}", weight(bytes), weight(budget * UNIT));
    Diagnostic::error(Code::Heavy, message).help(format!("the budget is `{key}` in `[budgets]` of workbook.toml"))
}

/// A complaint of a page, if it is too heavy without its pictures.
fn heavy_page(path: &str, page: &str, budget: usize) -> Option<Diagnostic> {
    let parts = parts(page);
    let pictures = parts.iter().find(|(name, _)| *name == PARTS[0].0).map_or(0, |(_, bytes)| *bytes);
    let bytes = page.len() - pictures;
    if bytes <= budget * UNIT {
        return None;
    }
    let rest = ("the rest of the text", bytes.saturating_sub(parts[1..].iter().map(|(_, bytes)| bytes).sum()));
    let mut shares: Vec<(&str, usize)> = parts[1..].iter().copied().chain([rest]).collect();
    shares.sort_by_key(|&(_, bytes)| std::cmp::Reverse(bytes));
    let mut exhibits = exhibits(page);
    exhibits.sort_by_key(|&(_, bytes)| std::cmp::Reverse(bytes));
    let diagnostic = heavy(&format!("`{path}` without its pictures"), bytes, ("page", budget));
    let diagnostic = diagnostic.help(format!("it has {}", listed(&shares)));
    let named: Vec<(String, usize)> = exhibits.into_iter().map(|(id, bytes)| (format!("`{id}`"), bytes)).collect();
    let heaviest = || format!("its heaviest exhibits without pictures are {}", listed(&named));
    Some(diagnostic.help_if((!named.is_empty()).then(heaviest)))
}

/// What a page consists of: the bytes of each of [`PARTS`]. A part within another belongs to the one that begins first.
fn parts(page: &str) -> Vec<(&'static str, usize)> {
    let mut bytes = [0; PARTS.len()];
    let mut behind = 0;
    for tag in tags(page) {
        if tag.start < behind {
            continue;
        }
        let rest = &page[tag.start..];
        let part = PARTS.iter().position(|(_, begin, _)| {
            rest.strip_prefix(begin).is_some_and(|rest| rest.starts_with([' ', '>', '/', '\n']))
        });
        if let Some(part) = part {
            let length = rest.find(PARTS[part].2).map_or(rest.len(), |end| end + PARTS[part].2.len());
            bytes[part] += length;
            behind = tag.start + length;
        } else {
            let data = tag.attributes.iter().filter(|(name, value)| *name == "src" && value.starts_with("data:"));
            bytes[0] += data.map(|(_, value)| value.len()).sum::<usize>();
        }
    }
    PARTS.iter().map(|(name, ..)| *name).zip(bytes).collect()
}

/// The exhibits and listings of a page, each with its bytes without pictures.
fn exhibits(page: &str) -> Vec<(&str, usize)> {
    let figures = tags(page).filter(|tag| tag.name == "figure");
    figures
        .filter_map(|figure| {
            let rest = &page[figure.start..];
            let whole = &rest[..rest.find("</figure>")?];
            let pictures = parts(whole).first().map_or(0, |(_, bytes)| *bytes);
            Some((figure.get("id")?, whole.len().saturating_sub(pictures)))
        })
        .collect()
}

/// What a site consists of, by folder, and its heaviest files.
fn folders(book: &Book) -> String {
    let mut folders = std::collections::BTreeMap::<&str, usize>::new();
    for (path, bytes) in &book.files {
        let folder = match path.split_once('/') {
            Some((folder, _)) => folder,
            None if extension(path) == Some("html") => "pages",
            None => "other files",
        };
        *folders.entry(folder).or_default() += bytes.len();
    }
    let mut shares: Vec<(&str, usize)> = folders.into_iter().collect();
    shares.sort_by_key(|&(_, bytes)| std::cmp::Reverse(bytes));
    let mut files: Vec<(String, usize)> =
        book.files.iter().map(|(path, bytes)| (format!("`{path}`"), bytes.len())).collect();
    files.sort_by_key(|&(_, bytes)| std::cmp::Reverse(bytes));
    format!("it has {}; its heaviest files are {}", listed(&shares), listed(&files))
}

/// The first of a list from the heaviest on.
fn listed<T: AsRef<str>>(shares: &[(T, usize)]) -> String {
    let named = shares.iter().filter(|(_, bytes)| *bytes > 0).take(NAMED);
    named.map(|(name, bytes)| format!("{} {}", name.as_ref(), weight(*bytes))).collect::<Vec<_>>().join(", ")
}

/// Bytes as people read them.
fn weight(bytes: usize) -> String {
    if bytes < UNIT { format!("{bytes} bytes") } else { format!("{}.{} kB", bytes / UNIT, bytes % UNIT / 100) }
}

#[cfg(test)]
mod tests {
    use super::{exhibits, parts, weight};

    #[test]
    fn the_parts_of_a_page_are_weighed() {
        let page = "<p>text</p><svg a=\"b\"><path/></svg><table><tr><math>x</math></table><math>yz</math>\
            <img src=\"data:image/png;base64,AAAA\"><pre>code</pre><preface></preface>";
        let weighed: Vec<usize> = parts(page).into_iter().map(|(_, bytes)| bytes).collect();
        let length = |parts: &[&str]| parts.iter().map(|part| part.len()).sum::<usize>();
        let pictures = length(&["<svg a=\"b\"><path/></svg>", "data:image/png;base64,AAAA"]);
        let table = length(&["<table><tr><math>x</math></table>"]);
        assert_eq!(weighed, [pictures, 0, length(&["<math>yz</math>"]), table, length(&["<pre>code</pre>"])]);
    }

    #[test]
    fn exhibits_are_weighed_without_their_drawings() {
        let page = "<figure id=\"fig-a\"><svg><path/></svg>caption</figure><figure id=\"tbl-b\">b</figure>";
        let bytes = "<figure id=\"fig-a\">caption".len();
        assert_eq!(exhibits(page), [("fig-a", bytes), ("tbl-b", "<figure id=\"tbl-b\">b".len())]);
    }

    #[test]
    fn weights_are_told_in_kilobytes() {
        assert_eq!(
            (weight(999).as_str(), weight(1_050).as_str(), weight(412_345).as_str()),
            ("999 bytes", "1.0 kB", "412.3 kB")
        );
    }
}
