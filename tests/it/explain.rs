//! The explanations of diagnostics: each code has one, and its examples give what they say.

use std::collections::BTreeSet;
use std::io::{BufRead, BufReader};
use std::process::Stdio;

use rayon::prelude::*;
use workbook::diag::Code;
use workbook::explain::{CHAPTER, Example, Part, explained, explanation};

use crate::course::Course;

/// What every chapter begins with.
const FRONT_MATTER: &str = "+++\ntitle = \"One\"\nsummary = \"The only chapter.\"\n+++\n\n";
/// The configuration of an example that has none.
const CONFIGURATION: &str = "title = \"A course\"\nauthors = [\"A. Author\"]\nbibliography = \"references.bib\"\n";
/// The works that an example can cite.
const WORKS: &str = include_str!("../../starter/chapters/references.bib");

/// The codes that an example gives, each with its message.
fn given(example: &Example) -> BTreeSet<(String, String)> {
    let course = Course::new(&[
        ("chapters/workbook.toml", CONFIGURATION),
        ("chapters/references.bib", WORKS),
        (CHAPTER, &format!("{FRONT_MATTER}A sentence.\n")),
    ]);
    let mut commands = vec!["build".to_owned()];
    for piece in &example.pieces {
        match &piece.part {
            Part::Chapter => course.write(CHAPTER, format!("{FRONT_MATTER}{}", piece.text)),
            Part::File(path, false) => course.write(path, &piece.text),
            Part::File(path, true) => {
                course.write(path, piece.text.chars().map(|c| u8::try_from(c).unwrap()).collect::<Vec<u8>>());
            }
            Part::Commands => {
                commands =
                    piece.text.lines().map(|line| line.strip_prefix("$ workbook ").unwrap().to_owned()).collect();
            }
        }
    }
    let (last, before) = commands.split_last().unwrap();
    for command in before {
        course.fine(&command.split(' ').collect::<Vec<_>>());
    }
    if last == "serve --port 0" {
        return served(&course);
    }
    let said = course.say(&[&last.split(' ').collect::<Vec<_>>()[..], &["--format", "json"]].concat());
    let told = said.out.lines().filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok());
    let told: BTreeSet<(String, String)> = told
        .filter_map(|line| Some((line.get("code")?.as_str()?.to_owned(), line["message"].as_str()?.to_owned())))
        .collect();
    assert!(!told.is_empty() || said.exit == 0, "{last}: {}", said.err);
    told
}

/// Nothing, if the course is served: that command would not end by itself.
fn served(course: &Course) -> BTreeSet<(String, String)> {
    let mut server = course.command(&["serve", "--port", "0", "--quiet"]).stdout(Stdio::piped()).spawn().unwrap();
    let mut address = String::new();
    BufReader::new(server.stdout.take().unwrap()).read_line(&mut address).unwrap();
    server.kill().unwrap();
    server.wait().unwrap();
    assert!(address.starts_with("http://127.0.0.1:"), "{address}");
    BTreeSet::new()
}

#[test]
fn every_code_has_an_explanation_whose_examples_are_true() {
    let wrong: Vec<String> = Code::ALL
        .par_iter()
        .filter_map(|code| {
            let Some(explanation) = explanation(*code) else { return Some(format!("{}: no page", code.id())) };
            let (bad, good) = (given(&explanation.wrong), given(&explanation.right));
            let exactly = !bad.is_empty() && bad.iter().all(|(given, _)| given == code.id());
            let complete = explanation.text.len() > 80 && !explanation.right.pieces.is_empty();
            (!(exactly && good.is_empty() && complete))
                .then(|| format!("{}: wrong gives {bad:?}, right gives {good:?}", code.id()))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    let known: BTreeSet<&str> = Code::ALL.iter().map(|code| code.id()).collect();
    assert_eq!(explained().collect::<BTreeSet<_>>(), known, "every page is of a code");
}

#[test]
fn explain_prints_a_page_or_the_nearest_code() {
    let course = Course::empty();
    let said = course.fine(&["explain", "W0107"]);
    for part in
        ["W0107: A count that the sampler cannot give.", "\nWrong:\n", "    n = 17\n", "\nRight:\n", "    n = 16\n"]
    {
        assert!(said.out.contains(part), "{part}: {}", said.out);
    }
    assert_eq!(course.fine(&["explain", "w107"]).out, said.out);
    let json: serde_json::Value =
        serde_json::from_str(&course.fine(&["explain", "107", "--format", "json"]).out).unwrap();
    assert_eq!(json["code"], "W0107");
    assert!(json["wrong"]["pieces"][0]["text"].as_str().unwrap().contains("n = 17"));
    let told = course.say(&["explain", "W9107"]);
    assert!(told.exit == 2 && told.err.contains("did you mean `W0107`?"), "{}", told.err);
    assert_eq!(course.fine(&["explain"]).out.lines().count(), Code::ALL.len());
}
