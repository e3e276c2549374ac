//! Golden cases: each folder of `tests/books/` is a course with the book, or the complaints, that it must give.
//!
//! `expected/` holds every file of the book; `expected.txt` the exit code and the diagnostics of `workbook build --quiet`, for courses
//! that have any. Missing and unexpected files both fail. After a change that was meant, `WORKBOOK_REFRESH=1 cargo test golden` writes
//! what is expected anew: then read the difference before it is committed.
//!
//! Two things are not compared byte for byte. Keys hold digests of code, which change with every edit of it: their text is replaced. And
//! files that are no pages are listed in `expected/others.txt`: those of the templates by name, so that a change of the style sheet
//! touches no case, and all others by digest.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use similar::TextDiff;
use workbook::sources::Digest;
use workbook::workspace::extension;

use crate::course::{Course, PACKAGE, tree};

/// What is expected of a case, or what it gives: texts by path.
type Texts = BTreeMap<String, String>;

/// The file with the diagnostics.
const DIAGNOSTICS: &str = "expected.txt";
/// The folder with the book.
const BOOK: &str = "expected/";
/// The pages that tell of this build: its kinds, its code.
const OWN_PAGES: [&str; 2] = ["kinds.html", "made.html"];
/// The index of the search, which has the kinds of this build as well; `search` tests what it holds.
const INDEX: &str = "assets/search-index.js";
/// The page for addresses that lead nowhere: one case holds its text.
const LOST: &str = "404.html";
/// The list of files that are no pages.
const OTHERS: &str = "expected/others.txt";

#[test]
fn every_case_gives_what_is_expected() {
    let refresh = std::env::var_os("WORKBOOK_REFRESH").is_some();
    let cases = cases();
    assert!(cases.len() > 20, "the cases are not where they were: {cases:?}");
    let failed: Vec<String> = cases
        .par_iter()
        .filter_map(|folder| {
            let name = folder.file_name().unwrap().to_str().unwrap();
            let (expected, given) = (expected(folder), given(name));
            if refresh {
                replace(folder, &expected, &given);
                return None;
            }
            let difference = difference(&expected, &given);
            (!difference.is_empty()).then(|| format!("case `{name}`:\n{difference}"))
        })
        .collect();
    let hint = "if that is meant: WORKBOOK_REFRESH=1 cargo test golden";
    assert!(failed.is_empty(), "{}\n{} cases differ; {hint}", failed.join("\n"), failed.len());
}

#[test]
fn missing_unexpected_and_changed_files_are_told() {
    let texts = |files: &[(&str, &str)]| -> Texts {
        files.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect()
    };
    let expected = texts(&[("same", "x\n"), ("missing", "y\n"), ("changed", "old\nkept\n")]);
    let given = texts(&[("same", "x\n"), ("unexpected", "z\n"), ("changed", "new\nkept\n")]);
    let told = difference(&expected, &given);
    assert!(told.contains("missing: it was expected"), "{told}");
    assert!(told.contains("unexpected: nobody expected it"), "{told}");
    assert!(told.contains("-old\n+new\n kept"), "{told}");
    assert!(!told.contains("same"), "{told}");
}

/// The folders of all cases, sorted.
fn cases() -> Vec<PathBuf> {
    let books = Path::new(PACKAGE).join("tests/books");
    let mut cases: Vec<PathBuf> = fs::read_dir(books).unwrap().map(|entry| entry.unwrap().path()).collect();
    cases.retain(|path| path.is_dir());
    cases.sort();
    cases
}

fn expected(folder: &Path) -> Texts {
    let mut texts: Texts = tree(&folder.join("expected"))
        .into_iter()
        .map(|(path, bytes)| (format!("{BOOK}{path}"), String::from_utf8(bytes).unwrap()))
        .collect();
    if let Ok(text) = fs::read_to_string(folder.join(DIAGNOSTICS)) {
        texts.insert(DIAGNOSTICS.to_owned(), text);
    }
    texts
}

fn given(case: &str) -> Texts {
    let course = Course::case(case);
    let said = course.say(&["build", "--quiet", "--jobs", "2"]);
    let mut texts = Texts::new();
    if said.exit != 0 || !said.err.is_empty() {
        texts.insert(DIAGNOSTICS.to_owned(), format!("exit {}\n\n{}", said.exit, said.err));
    }
    assert_eq!(said.out, "", "{case}");
    let book = course.book();
    let keys = keys(book.get("figures.json").map(Vec::as_slice).unwrap_or_default());
    let mut others = String::new();
    for (path, bytes) in book {
        if is_compared(&path, case) {
            texts.insert(format!("{BOOK}{path}"), without_keys(String::from_utf8(bytes).unwrap(), &keys));
        } else {
            let _ = writeln!(others, "{path}: {}", other(&path, &bytes));
        }
    }
    if !others.is_empty() {
        texts.insert(OTHERS.to_owned(), others);
    }
    texts
}

/// Whether a file is expected as a text: the pages of kinds and of how the book was made are those of this build, and of the gallery, which is large, the drawings and
/// data are in the list of files, each with its digest.
fn is_compared(path: &str, case: &str) -> bool {
    let own = OWN_PAGES.contains(&path) || case == "gallery" || (path == LOST && case != "site");
    path == "figures.json" || (extension(path) == Some("html") && !own)
}

/// The keys of all exhibits.
fn keys(figures: &[u8]) -> Vec<String> {
    let figures: serde_json::Value = serde_json::from_slice(figures).unwrap_or_default();
    let exhibits = figures["exhibits"].as_array().cloned().unwrap_or_default();
    exhibits.iter().map(|exhibit| exhibit["key"].as_str().unwrap().to_owned()).collect()
}

/// A page without the text of keys, in full or short.
fn without_keys(mut text: String, keys: &[String]) -> String {
    for key in keys {
        text = text.replace(key, "(key)").replace(&key[..12], "(key)");
    }
    text
}

/// What a file that is no page is: that of the templates, one that begins with it, or its digest.
fn other(path: &str, bytes: &[u8]) -> String {
    if OWN_PAGES.contains(&path) || extension(path) == Some("html") {
        return "a page".to_owned();
    }
    if path == INDEX {
        return "the index of the search".to_owned();
    }
    let template = fs::read(Path::new(PACKAGE).join("templates").join(path));
    let css = workbook::chart::palette::css();
    let (text, colours) = match bytes.strip_suffix(css.as_bytes()) {
        Some(text) => (text, ", and the colours of the charts"),
        None => (bytes, ""),
    };
    if template.is_ok_and(|template| text.trim_ascii_end() == template.trim_ascii_end()) {
        format!("as in the templates{colours}")
    } else {
        format!("{}{colours}", Digest::of(text).short())
    }
}

/// How what is given differs from what is expected, for people; empty if it does not.
fn difference(expected: &Texts, given: &Texts) -> String {
    let mut told = String::new();
    for (path, text) in expected {
        match given.get(path) {
            None => {
                let _ = writeln!(told, "{path}: it was expected, and is not there");
            }
            Some(now) if now != text => {
                let diff = TextDiff::from_lines(text.as_str(), now.as_str());
                let diff = diff.unified_diff().context_radius(2).header(path, "given").to_string();
                let lines: Vec<String> = diff.lines().take(60).map(|line| line.chars().take(400).collect()).collect();
                let _ = writeln!(told, "{}", lines.join("\n"));
            }
            Some(_) => {}
        }
    }
    for path in given.keys().filter(|path| !expected.contains_key(*path)) {
        let _ = writeln!(told, "{path}: nobody expected it");
    }
    told
}

/// Makes what is given what is expected.
fn replace(folder: &Path, expected: &Texts, given: &Texts) {
    for path in expected.keys().filter(|path| !given.contains_key(*path)) {
        fs::remove_file(folder.join(path)).unwrap();
    }
    for (path, text) in given {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
}
