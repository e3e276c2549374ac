//! What helps a reader along: notes beside the text, links to each place, previews, and the sheets and scripts that the pages load.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use workbook::workspace::extension;

use crate::course::PACKAGE;
use crate::pages::{Element, Page, book_of, pages};

const CASES: [&str; 4] = ["everything", "folds", "terms", "appendices"];

fn page(case: &str, path: &str) -> String {
    String::from_utf8(book_of(case)[path].clone()).unwrap()
}

/// The text between `before` and `after`.
fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let (_, rest) = text.split_once(before).unwrap_or_else(|| panic!("no `{before}`"));
    rest.split_once(after).unwrap_or_else(|| panic!("no `{after}` after `{before}`")).0
}

#[test]
fn a_note_stands_at_its_first_reference() {
    let html = page("everything", "prose.html");
    // One paragraph: in the line, so that it can stand beside it.
    let mark = "aria-label=\"Footnote 1\">1</a></sup>";
    let after = html.split_once(mark).unwrap().1;
    assert!(
        after.starts_with(
            "<span class=\"side-note\" role=\"note\" id=\"fn-1\"><a class=\"note-number\" href=\"#fnref-1\""
        )
    );
    let note = between(after, "id=\"fn-1\">", "</span>\nand another");
    assert!(note.contains("The first, with <math") && note.contains("class=\"citation\""), "{note}");
    // Two paragraphs: after the paragraph.
    let (paragraph, rest) = after.split_once("</p>\n").unwrap();
    assert!(paragraph.contains("id=\"fnref-2\"") && !paragraph.contains("The second."), "{paragraph}");
    assert!(
        rest.starts_with("<aside class=\"side-note\" role=\"note\" id=\"fn-2\"><p><a class=\"note-number\""),
        "{rest:.200}"
    );
    assert!(between(rest, "id=\"fn-2\">", "</aside>").contains("It has two paragraphs."));
    // A second reference leads to the same note, and the definitions are nowhere else.
    assert_eq!(html.matches("href=\"#fn-1\"").count(), 2);
    assert_eq!(html.matches("id=\"fn-1\"").count(), 1);
    assert!(html.contains("id=\"fnref-1-2\"") && !html.contains("class=\"footnotes\""));
    assert_eq!(html.matches("It has two paragraphs.").count(), 1);
    // In a list it stands in the item, and after a table, where no note can stand.
    assert!(between(&html, "An item with a note", "</li>").contains("<span class=\"side-note\""));
    let (table, after) = html.split_once("id=\"fnref-4\"").unwrap().1.split_once("</table></div>\n").unwrap();
    assert!(!table.contains("In a table"));
    assert!(after.starts_with("<aside class=\"side-note\" role=\"note\" id=\"fn-4\">"), "{after:.80}");
}

#[test]
fn notes_stand_where_html_allows_them() {
    for case in CASES {
        for page in pages(&book_of(case)) {
            for element in page.elements.iter().filter(|element| element.get("class") == "side-note") {
                let within = |name: &str| element.parents.iter().any(|parent| parent == name);
                assert!(!["a", "table", "h1", "h2", "h3", "h4"].iter().any(|name| within(name)), "{}", page.path);
                assert_eq!(element.name == "span", within("p") || within("li"), "{}: {:?}", page.path, element.parents);
            }
        }
    }
}

#[test]
fn every_place_has_a_link_to_itself() {
    let mut kinds = BTreeSet::new();
    for case in CASES {
        let book = book_of(case);
        for page in pages(&book) {
            let own: BTreeMap<&str, &Element> = page
                .elements
                .iter()
                .filter(|element| element.name == "a")
                .map(|link| (link.get("href"), link))
                .collect();
            for element in &page.elements {
                let (id, class) = (element.get("id"), element.get("class"));
                let kind = class.split(' ').find(|class| {
                    ["exhibit-figure", "exhibit-table", "listing", "numbered", "callout-exercise", "callout-definition"]
                        .contains(class)
                });
                let heading = ["h2", "h3", "h4"].contains(&element.name.as_str()) && page.path != "exhibits.html";
                let chapter = page.elements.iter().any(|element| element.get("class").starts_with("page chapter"));
                let Some(kind) = kind.or(heading.then_some("heading")).filter(|_| !id.is_empty() && chapter) else {
                    continue;
                };
                let marks = ["label", "permalink", "equation-number", "callout-label"];
                let links =
                    page.elements.iter().filter(|link| link.name == "a" && link.get("href") == format!("#{id}"));
                assert!(links.clone().any(|link| marks.contains(&link.get("class"))), "{}: `{id}`", page.path);
                assert!(own.contains_key(format!("#{id}").as_str()));
                kinds.insert(kind.to_owned());
            }
        }
    }
    assert_eq!(kinds.len(), 7, "{kinds:?}");
}

/// The targets of a file of previews: page, then HTML by id.
fn targets(file: &[u8]) -> (String, BTreeMap<String, String>) {
    let call = std::str::from_utf8(file).unwrap();
    let inner = call.strip_prefix("workbook.previews(").and_then(|call| call.strip_suffix(");\n")).unwrap();
    serde_json::from_str(&format!("[{inner}]")).unwrap()
}

/// What the pages of a book refer to on other pages.
fn referred(pages: &[Page]) -> BTreeSet<(String, String)> {
    let links = pages.iter().flat_map(|page| page.elements.iter().map(move |link| (page, link)));
    links
        .filter(|(_, link)| link.name == "a" && ["reference", "term", "citation"].contains(&link.get("class")))
        .filter_map(|(page, link)| {
            let (other, id) = link.get("href").split_once('#')?;
            (!other.is_empty() && other != page.path).then(|| (other.to_owned(), id.to_owned()))
        })
        .collect()
}

#[test]
fn previews_have_what_other_pages_refer_to_and_nothing_else() {
    let (mut count, mut all) = (0, String::new());
    for case in CASES {
        let book = book_of(case);
        let mut found = BTreeSet::new();
        for (path, bytes) in book.iter().filter(|(path, _)| path.starts_with("assets/previews/")) {
            let (page, targets) = targets(bytes);
            assert_eq!(*path, format!("assets/previews/{}", page.replace(".html", ".js")));
            for (id, html) in targets {
                assert!(html.contains(&format!("id=\"{id}\"")), "{page}#{id}: {html}");
                for src in html.split("src=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
                    assert!(book.contains_key(src), "{page}#{id}: {src}");
                }
                found.insert((page.clone(), id));
                all.push_str(&html);
            }
        }
        assert_eq!(found, referred(&pages(&book)), "{case}");
        count += found.len();
    }
    assert!(count >= 10, "{count} previews");
    // What is folded away is no preview.
    assert!(!all.contains("<details") && !all.contains("Four times as many"), "a preview tells a solution");
    assert!(all.contains("class=\"equation numbered\"") && all.contains("class=\"sheet\""));
}

#[test]
fn pages_load_each_sheet_and_script_once_and_all_that_there_are() {
    let book = book_of("everything");
    let mut loaded = BTreeSet::new();
    for page in pages(&book) {
        let mut once = BTreeSet::new();
        for element in &page.elements {
            let path = match element.name.as_str() {
                "script" => element.get("src"),
                "link" if element.get("rel") == "stylesheet" => element.get("href"),
                _ => continue,
            };
            assert_eq!(element.get("type"), "", "{}: no modules, which a page opened from disk cannot load", page.path);
            assert!(once.insert(path.to_owned()), "{}: `{path}` twice", page.path);
            loaded.insert(path.to_owned());
        }
    }
    let steppers = "assets/stepper.js".to_owned();
    loaded.insert(steppers);
    let is_part = |path: &&String| ["css", "js"].map(Some).contains(&extension(path)) && !path.contains("/previews/");
    let parts: BTreeSet<String> = book.keys().filter(is_part).cloned().collect();
    // What a script loads when it is wanted, it names.
    let text = |path: &str| std::str::from_utf8(&book[path]).unwrap();
    for _ in 0..2 {
        let named = |part: &&String| {
            let name = part.trim_start_matches("assets/");
            loaded.iter().any(|path| extension(path) == Some("js") && text(path).contains(name))
        };
        let wanted: Vec<String> = parts.iter().filter(named).cloned().collect();
        loaded.extend(wanted);
    }
    assert_eq!(loaded, parts);
}

#[test]
fn every_sheet_and_script_says_what_it_is_and_is_short() {
    let folder = Path::new(PACKAGE).join("templates/assets");
    let files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
    let parts = files.iter().filter(|path| ["css", "js"].map(Some).contains(&extension(&name(path))));
    assert!(parts.clone().count() > 20);
    for path in parts {
        let text = fs::read_to_string(path).unwrap();
        let path = name(path);
        let begin = if extension(&path) == Some("css") { "/* " } else { "// " };
        assert!(text.starts_with(begin), "{path} does not begin with a sentence on what it is");
        assert!(text.lines().count() <= 400, "{path} has {} lines", text.lines().count());
    }
}

#[test]
fn the_parts_that_every_page_has_are_joined_in_their_order() {
    let book = book_of("everything");
    let source = |name: &str| fs::read_to_string(Path::new(PACKAGE).join("templates/assets").join(name)).unwrap();
    for (whole, parts) in
        [("style.css", ["page.css", "text.css", "search.css"]), ("page.js", ["keys.js", "copy.js", "search.js"])]
    {
        let whole = std::str::from_utf8(&book[&format!("assets/{whole}")]).unwrap();
        let places: Vec<usize> = parts.iter().map(|part| whole.find(source(part).trim_end()).unwrap()).collect();
        assert!(places.is_sorted(), "{parts:?} stand at {places:?}");
    }
    assert!(!book.contains_key("assets/page.css") && !book.contains_key("assets/keys.js"));
}

#[test]
fn one_button_opens_what_is_folded_and_stands_before_the_first_exercise() {
    let html = page("everything", "prose.html");
    let (before, after) = html.split_once("<p class=\"fold-all\">").unwrap();
    assert!(
        after.starts_with("<button type=\"button\" aria-pressed=\"false\">Unfold all hints and solutions</button></p>")
    );
    assert!(!before.contains("callout-exercise") && after.contains("callout-exercise") && !after.contains("fold-all"));
    let without = page("everything", "experiments.html");
    assert!(!without.contains("fold-all"), "nothing is folded there");
}

#[test]
fn long_formulas_in_a_line_are_marked_so_that_they_scroll() {
    let html = page("everything", "prose.html");
    assert_eq!(html.matches("class=\"long-formula\"").count(), 1, "one formula of the page is long");
    assert!(between(&html, "<span class=\"long-formula\">", "</span>").starts_with("<math"));
    assert!(
        html.contains("Inline <span class=\"held\"><math"),
        "a short one is held together with the comma behind it"
    );
    let held = between(&html, "Inline <span class=\"held\">", "</span>");
    assert!(held.starts_with("<math") && held.ends_with("</math>,"), "{held}");
}
