//! The pages as a browser reads them: HTML without errors, ids and links that hold, words for every picture, nothing from elsewhere.

use std::collections::{BTreeMap, BTreeSet};

use html5ever::tendril::TendrilSink;
use html5ever::{ParseOpts, parse_document};
use markup5ever_rcdom::{Handle, NodeData, RcDom};
use workbook::workspace::extension;

use crate::course::Course;

/// An element of a page.
pub(crate) struct Element {
    pub(crate) name: String,
    attributes: BTreeMap<String, String>,
    /// All text within.
    pub(crate) text: String,
    /// The same without code.
    prose: String,
    pub(crate) parents: Vec<String>,
}

impl Element {
    pub(crate) fn get(&self, name: &str) -> &str {
        self.attributes.get(name).map_or("", String::as_str)
    }
}

/// A page: its elements in order and what the parser complained of.
pub(crate) struct Page {
    pub(crate) path: String,
    pub(crate) elements: Vec<Element>,
    errors: Vec<String>,
}

fn book() -> BTreeMap<String, Vec<u8>> {
    book_of("everything")
}

pub(crate) fn book_of(case: &str) -> BTreeMap<String, Vec<u8>> {
    let course = Course::case(case);
    let composed = course.compose(2);
    assert!(composed.diagnostics.is_empty(), "{:?}", composed.diagnostics);
    composed.book.files
}

pub(crate) fn pages(book: &BTreeMap<String, Vec<u8>>) -> Vec<Page> {
    let pages: Vec<Page> = book
        .iter()
        .filter(|(path, _)| extension(path) == Some("html"))
        .map(|(path, bytes)| {
            let dom = parse_document(RcDom::default(), ParseOpts::default()).from_utf8().one(bytes.as_slice());
            let mut elements = Vec::new();
            walk(&dom.document, &[], &mut elements);
            let errors = dom.errors.borrow().iter().map(ToString::to_string).collect();
            Page { path: path.clone(), elements, errors }
        })
        .collect();
    assert!(pages.len() > 5);
    pages
}

/// The pages of the books that together have everything.
fn all_pages() -> Vec<Page> {
    ["everything", "folds", "terms"].into_iter().flat_map(|case| pages(&book_of(case))).collect()
}

fn walk(node: &Handle, parents: &[String], elements: &mut Vec<Element>) {
    let mut inner = parents.to_vec();
    if let NodeData::Element { name, attrs, .. } = &node.data {
        let attributes = attrs
            .borrow()
            .iter()
            .map(|attribute| (attribute.name.local.to_string(), attribute.value.to_string()))
            .collect();
        let name = name.local.to_string();
        inner.push(name.clone());
        elements.push(Element {
            name,
            attributes,
            text: text(node, &[]),
            prose: text(node, &["code", "pre", "annotation"]),
            parents: parents.to_vec(),
        });
    }
    for child in node.children.borrow().iter() {
        walk(child, &inner, elements);
    }
}

/// The text within a node, without that of elements named in `without`.
fn text(node: &Handle, without: &[&str]) -> String {
    match &node.data {
        NodeData::Text { contents } => contents.borrow().to_string(),
        NodeData::Element { name, .. } if without.contains(&&*name.local) => String::new(),
        _ => node.children.borrow().iter().map(|child| text(child, without)).collect(),
    }
}

#[test]
fn pages_are_read_without_errors() {
    for page in all_pages() {
        assert_eq!(page.errors, Vec::<String>::new(), "{}", page.path);
        assert!(page.elements.len() > 30, "{}", page.path);
        let one = |name: &str| {
            let inner =
                |element: &&Element| element.name == name && !element.parents.iter().any(|parent| parent == "svg");
            page.elements.iter().filter(inner).count()
        };
        assert_eq!((one("main"), one("h1"), one("title")), (1, 1, 1), "{}", page.path);
        let html = &page.elements[0];
        assert_eq!((html.name.as_str(), html.get("lang")), ("html", "en-GB"), "{}", page.path);
    }
}

#[test]
fn ids_are_unique_and_what_names_them_finds_them() {
    for page in all_pages() {
        let mut ids = BTreeSet::new();
        for element in page.elements.iter().filter(|element| element.attributes.contains_key("id")) {
            let id = element.get("id");
            assert!(!id.is_empty() && !id.contains(char::is_whitespace), "{}: `{id}`", page.path);
            assert!(ids.insert(id), "{}: `{id}` twice", page.path);
        }
        for element in &page.elements {
            for name in ["aria-labelledby", "aria-describedby", "for", "aria-controls"] {
                for id in element.get(name).split_whitespace() {
                    assert!(ids.contains(id), "{}: {name} `{id}`", page.path);
                }
            }
            for (name, value) in &element.attributes {
                for id in value.split("url(#").skip(1).filter_map(|rest| rest.split(')').next()) {
                    assert!(ids.contains(id), "{}: {name}=`{value}`", page.path);
                }
            }
        }
    }
}

#[test]
fn links_lead_somewhere() {
    let book = book();
    let pages = pages(&book);
    let ids: BTreeSet<(&str, &str)> = pages
        .iter()
        .flat_map(|page| page.elements.iter().map(|element| (page.path.as_str(), element.get("id"))))
        .collect();
    let mut count = 0;
    for page in &pages {
        for element in page.elements.iter().filter(|element| element.name == "a") {
            let link = element.get("href");
            assert!(!link.is_empty() && !element.text.trim().is_empty(), "{}: an empty link `{link}`", page.path);
            assert!(!element.parents.iter().any(|parent| parent == "a"), "{}: a link in a link", page.path);
            if link.contains(':') {
                assert!(link.starts_with("https://"), "{}: `{link}`", page.path);
                continue;
            }
            let (file, id) = link.split_once('#').unwrap_or((link, ""));
            let file = if file.is_empty() { page.path.as_str() } else { file };
            assert!(book.contains_key(file), "{}: `{link}`", page.path);
            assert!(id.is_empty() || ids.contains(&(file, id)), "{}: `{link}`", page.path);
            count += 1;
        }
    }
    assert!(count > 100, "{count} links are not the links of this book");
}

#[test]
fn nothing_is_asked_of_another_host() {
    let book = book();
    for page in pages(&book) {
        for element in page.elements.iter().filter(|element| element.name != "a") {
            for name in ["src", "href", "srcset", "data", "action", "poster", "xlink:href"] {
                let value = element.get(name);
                let inner = value.is_empty()
                    || value.starts_with("data:")
                    || book.contains_key(value)
                    || value.starts_with('#');
                assert!(inner, "{}: <{} {name}=\"{value}\">", page.path, element.name);
            }
            assert!(!element.attributes.keys().any(|name| name.starts_with("on")), "{}: a handler", page.path);
        }
    }
    for path in book.keys().filter(|path| extension(path) == Some("css")) {
        let css = std::str::from_utf8(&book[path]).unwrap();
        assert!(!css.contains("@import") && !css.contains("//fonts"), "{path}");
        for url in css.split("url(").skip(1).filter_map(|rest| rest.split(')').next()) {
            let url = url.trim_matches(['"', '\'']);
            let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
            assert!(url.starts_with("data:") || book.contains_key(&format!("{folder}/{url}")), "{path}: `{url}`");
        }
    }
    for path in book.keys().filter(|path| extension(path) == Some("js") && !path.contains("/previews/")) {
        let script = std::str::from_utf8(&book[path]).unwrap();
        for word in ["http", "fetch(", "XMLHttpRequest", "import(", "Worker("] {
            assert!(!script.contains(word), "{path} holds `{word}`");
        }
    }
}

#[test]
fn every_picture_has_words() {
    let book = book();
    let mut drawings = 0;
    for page in pages(&book) {
        for element in &page.elements {
            match element.name.as_str() {
                // There the words are beside the picture, in the same link.
                "img" if ["exhibits.html", "index.html"].contains(&page.path.as_str()) => {
                    assert!(element.parents.iter().any(|parent| parent == "a"), "{}", page.path);
                }
                "img" => assert!(!element.get("alt").trim().is_empty(), "{}: a picture without words", page.path),
                "svg" => {
                    drawings += 1;
                    assert_eq!(element.get("role"), "img", "{}", page.path);
                    let named = |names: &str| {
                        let ids = element.get(names).split_whitespace();
                        let texts = ids.filter_map(|id| page.elements.iter().find(|element| element.get("id") == id));
                        texts.map(|element| element.text.trim()).any(|text| text.len() > 10)
                    };
                    assert!(
                        named("aria-labelledby") || named("aria-describedby"),
                        "{}: {:?}",
                        page.path,
                        element.attributes
                    );
                }
                "figure" => assert!(!element.text.trim().is_empty(), "{}: a figure without a caption", page.path),
                _ => {}
            }
        }
    }
    assert_eq!(drawings, 9, "every figure of the book is drawn");
}

#[test]
fn math_is_markup_and_no_sign_of_the_source_is_left() {
    let pages = pages(&book());
    let formulas: usize =
        pages.iter().map(|page| page.elements.iter().filter(|element| element.name == "math").count()).sum();
    assert!(formulas > 15, "{formulas} formulas");
    for page in &pages {
        let body = page.elements.iter().find(|element| element.name == "main").unwrap();
        // Those that an author asked for with a backslash.
        let mut text = body.prose.clone();
        for asked in ["$5 is no formula, nor is @fig-curve", "@fig-curve at the start", "$1 [^one]"] {
            text = text.replace(asked, "");
        }
        for sign in ["$", "@fig-", "@tbl-", "@eq-", "[@", "[^", "[!", "`=", "{#", "\\frac", "\\E"] {
            assert!(!text.contains(sign), "{}: `{sign}` is left over", page.path);
        }
    }
}

#[test]
fn tables_and_headings_are_in_order() {
    for page in pages(&book()) {
        let mut last = 0;
        for element in &page.elements {
            if let Some(level) = element.name.strip_prefix('h').and_then(|level| level.parse::<usize>().ok()) {
                assert!(level <= last + 1, "{}: <h{level}> after <h{last}>", page.path);
                last = level;
            }
            if element.name == "th" {
                assert!(["col", "row"].contains(&element.get("scope")), "{}: a head without a scope", page.path);
            }
        }
    }
}

#[test]
fn machines_and_readers_are_told_how_every_exhibit_was_made() {
    let course = Course::case("everything");
    let composed = course.compose(2);
    let book = composed.book.files;
    let figures: serde_json::Value = serde_json::from_slice(&book["figures.json"]).unwrap();
    let exhibits = figures["exhibits"].as_array().unwrap();
    assert_eq!(exhibits.len(), composed.plan.exhibits.len());
    let page = pages(&book).into_iter().find(|page| page.path == "made.html").unwrap();
    let items: Vec<&Element> = page.elements.iter().filter(|element| element.name == "li").collect();
    let (mut claims, mut links) = (0, BTreeSet::new());
    for (exhibit, planned) in exhibits.iter().zip(&composed.plan.exhibits) {
        let text = |field: &str| exhibit[field].as_str().unwrap_or_else(|| panic!("{field}: {exhibit}")).to_owned();
        assert_eq!(text("id"), planned.id, "in the order of the book");
        let (file, line) =
            text("place").split_once(':').map(|(f, l)| (f.to_owned(), l.parse::<usize>().unwrap())).unwrap();
        assert_eq!(course.read(&file).lines().nth(line - 1), Some("```experiment"), "{exhibit}");
        assert!(text("key").len() == 64 && exhibit["seed"].is_u64() && exhibit["parameters"].is_object(), "{exhibit}");
        assert!(!exhibit["values"].as_object().unwrap().is_empty(), "{exhibit}");
        assert!(text("number").contains('.') && file.ends_with(&format!("{}.md", text("chapter"))), "{exhibit}");
        let files: Vec<&str> = exhibit["files"].as_array().unwrap().iter().map(|file| file.as_str().unwrap()).collect();
        assert_eq!(files[0], format!("{}.html#{}", text("chapter"), text("id")));
        assert!(files.len() > 2 && files[1..].iter().all(|file| book.contains_key(*file)), "{files:?}");
        let item =
            items.iter().find(|item| item.text.contains(&text("key")) && item.text.contains(&text("id"))).unwrap();
        assert!(item.text.contains(&text("kind")), "{}", item.text);
        for claim in exhibit["claims"].as_array().unwrap() {
            let (value, bound) = (claim["value"].as_str().unwrap(), claim["bound"].as_str().unwrap());
            assert_eq!((claim["measured"].is_null(), bound.is_empty(), &claim["holds"]), (false, false, &true.into()));
            assert_eq!(exhibit["values"][value], claim["measured"]);
            claims += 1;
        }
        links.insert(files[0].to_owned());
    }
    let tally = page.elements.iter().find(|element| element.get("class") == "tally").unwrap();
    let told = format!("{} exhibits computed. {claims} claims: all hold.", exhibits.len());
    assert_eq!(tally.text, told);
    let linked: BTreeSet<String> = page.elements.iter().map(|element| element.get("href").to_owned()).collect();
    assert!(links.is_subset(&linked), "{linked:?}");
    let engine = workbook::sources::sources().engine.to_string();
    assert!(page.elements.iter().any(|element| element.name == "code" && element.text == engine));
}
