//! The guide for authors: it is built by the program itself, and every example in it is run.

use std::fmt::Write as _;
use std::path::Path;

use rayon::prelude::*;
use workbook::diag::Code;
use workbook::explain::{CHAPTER, explanation};

use crate::course::{Course, PACKAGE, tree};

/// The guide's chapters, each with its text; the appendix of diagnostics is tested by its own.
fn chapters() -> Vec<(String, String)> {
    let files = tree(&Path::new(PACKAGE).join("guide/chapters")).into_iter();
    let files = files.filter(|(path, _)| path.starts_with('0'));
    let chapters: Vec<_> = files.map(|(path, bytes)| (path, String::from_utf8(bytes).unwrap())).collect();
    assert!(chapters.len() >= 7, "the guide is not where it was");
    chapters
}

/// The blocks of code of a chapter that are of `language`: what stands behind it, the text, and the line that it begins at.
fn blocks(text: &str, language: &str) -> Vec<(String, String, usize)> {
    let mut found = Vec::new();
    let mut lines = text.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        let info = line.trim_start_matches('`');
        let fence = &line[..line.len() - info.len()];
        if fence.len() < 3 {
            continue;
        }
        let body: Vec<&str> = lines.by_ref().map(|(_, line)| line).take_while(|line| *line != fence).collect();
        let (name, rest) = info.split_once(' ').unwrap_or((info, ""));
        if name == language {
            found.push((rest.to_owned(), body.join("\n") + "\n", at + 1));
        }
    }
    found
}

#[test]
fn every_example_of_markup_and_settings_builds() {
    let works = include_str!("../../guide/chapters/references.bib");
    let plain = "title = \"A course\"\nauthors = [\"A. Author\"]\nbibliography = \"references.bib\"\n";
    let front = "+++\ntitle = \"One\"\nsummary = \"The only chapter.\"\n+++\n\n";
    let mut examples = Vec::new();
    for (path, text) in chapters() {
        for (target, body, line) in blocks(&text, "markdown") {
            let body = if target == CHAPTER { body } else { format!("{front}{body}") };
            examples.push((format!("{path}:{line}"), body, plain.to_owned()));
        }
        for (_, body, line) in blocks(&text, "toml") {
            examples.push((format!("{path}:{line}"), format!("{front}A sentence.\n"), body));
        }
    }
    assert!(examples.len() > 12, "only {} examples were found", examples.len());
    let wrong: Vec<String> = examples
        .par_iter()
        .filter_map(|(place, chapter, configuration)| {
            let course = Course::new(&[
                (CHAPTER, chapter),
                ("chapters/workbook.toml", configuration),
                ("chapters/references.bib", works),
            ]);
            let said = course.say(&["build", "--quiet"]);
            (said.exit != 0 || !said.err.is_empty()).then(|| format!("{place}: {}", said.err))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_command_of_the_guide_ends_well() {
    let course = Course::empty();
    course.fine(&["init", ".", "--quiet"]);
    let mut count = 0;
    for (path, text) in chapters() {
        for (_, body, line) in blocks(&text, "console") {
            for command in body.lines() {
                let command = command.strip_prefix("$ workbook ").unwrap_or_else(|| panic!("{path}:{line}: {command}"));
                // Words between quotes are one.
                let words = command.split('"').enumerate().flat_map(|(at, part)| match at % 2 {
                    0 => part.split_whitespace().collect(),
                    _ => vec![part],
                });
                let said = course.say(&words.collect::<Vec<_>>());
                assert_eq!(said.exit, 0, "{path}:{line}: {command}: {}", said.err);
                count += 1;
            }
        }
    }
    assert!(count > 25, "only {count} commands were found");
}

#[test]
fn the_guide_builds_and_its_lock_is_kept() {
    let course = Course::empty();
    for (path, bytes) in tree(&Path::new(PACKAGE).join("guide/chapters")) {
        course.write(&format!("chapters/{path}"), bytes);
    }
    course.fine(&["build", "--quiet"]).silent();
    let lock = std::fs::read(Path::new(PACKAGE).join("guide/book/workbook.lock")).unwrap();
    let lock = String::from_utf8(lock).unwrap();
    let recorded = |id: &str| lock.contains(&format!("[exhibit.{id}]"));
    let figures: serde_json::Value = serde_json::from_str(&course.read("book/figures.json")).unwrap();
    let ids: Vec<&str> =
        figures["exhibits"].as_array().unwrap().iter().map(|exhibit| exhibit["id"].as_str().unwrap()).collect();
    assert!(!ids.is_empty() && ids.iter().all(|id| recorded(id)), "{ids:?} in {lock}");
}

#[test]
fn the_appendix_of_diagnostics_is_what_explain_says() {
    let groups = [
        ("W00", "Files", "files"),
        ("W01", "What authors write", "written"),
        ("W02", "What was computed", "computed"),
        ("W03", "The book as a reader meets it", "book"),
    ];
    let mut text = "+++\ntitle = \"Diagnostics\"\nsummary = \"Every code in a message: what it means, what to do, and a wrong and a right example.\"\n+++\n\n\
                    `workbook explain CODE` prints the same. Examples without the name of a file are the text of a chapter below its front matter. \
                    They are what the tests run: each wrong one gives its own code and no other, and each right one none.\n\n\
                    ## The codes {#sec-diagnostics}\n\nHow a code begins tells where something is wrong: W00 in @sec-files, W01 in @sec-written, W02 in @sec-computed, W03 in @sec-book.\n"
        .to_owned();
    let mut codes = Code::ALL.to_vec();
    codes.sort_by_key(|code| code.id());
    for (prefix, title, id) in groups {
        let _ = write!(text, "\n## {title} {{#sec-{id}}}\n");
        for code in codes.iter().filter(|code| code.id().starts_with(prefix)) {
            let _ = write!(text, "\n{}", explanation(*code).unwrap().for_chapters());
        }
    }
    let path = Path::new(PACKAGE).join("guide/chapters/diagnostics.md");
    if std::env::var_os("WORKBOOK_REFRESH").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    assert!(
        std::fs::read_to_string(&path).is_ok_and(|written| written == text),
        "the appendix is out of date: WORKBOOK_REFRESH=1 cargo test guide"
    );
}
