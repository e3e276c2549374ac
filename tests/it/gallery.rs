//! The gallery, `tests/books/gallery`: every kind of experiment with every parameter and every choice is in it, so that a person who
//! looks at its contact sheet has seen all there is.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use serde_json::Value as Json;
use workbook::kinds::KINDS;

use crate::course::PACKAGE;

/// The experiments of the gallery, as they are written.
fn fences() -> Vec<toml::Table> {
    let folder = Path::new(PACKAGE).join("tests/books/gallery/chapters");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let texts = files.iter().filter(|file| file.extension().is_some_and(|end| end == "md")).map(fs::read_to_string);
    let texts: Vec<String> = texts.collect::<Result<_, _>>().unwrap();
    let fences = texts.iter().flat_map(|text| text.split("```experiment\n").skip(1));
    let fences: Vec<toml::Table> = fences.map(|fence| fence.split("```").next().unwrap().parse().unwrap()).collect();
    assert!(fences.len() > 60, "the gallery has {} experiments", fences.len());
    fences
}

/// The words that a schema chooses from, at any depth.
fn words(schema: &Json) -> Vec<&str> {
    match schema {
        Json::Object(object) => object
            .iter()
            .flat_map(|(name, value)| match value {
                Json::Array(words) if name == "enum" => words.iter().filter_map(Json::as_str).collect(),
                value => words(value),
            })
            .collect(),
        Json::Array(items) => items.iter().flat_map(words).collect(),
        _ => Vec::new(),
    }
}

/// The words of a value as written: one, or those of a list.
fn written(value: &toml::Value) -> Vec<&str> {
    match value {
        toml::Value::Array(items) => items.iter().filter_map(toml::Value::as_str).collect(),
        value => value.as_str().into_iter().collect(),
    }
}

#[test]
fn the_gallery_has_every_kind_with_every_option() {
    let fences = fences();
    let mut missing = Vec::new();
    for kind in KINDS {
        let key = kind.about().key;
        let own: Vec<&toml::Table> = fences.iter().filter(|fence| fence["kind"].as_str() == Some(key)).collect();
        if own.is_empty() {
            missing.push(format!("kind {key}"));
            continue;
        }
        for doc in kind.parameters() {
            let names = [Some(doc.name), doc.alias];
            let values: Vec<&toml::Value> =
                own.iter().flat_map(|fence| names.into_iter().flatten().filter_map(|name| fence.get(name))).collect();
            if values.is_empty() {
                missing.push(format!("{key}: {}", doc.name));
            }
            // What several kinds choose from, such as scenes, need not be there for each of them.
            let others = fences.iter().filter_map(|fence| fence.get(doc.name));
            let mut used: BTreeSet<&str> = values.iter().flat_map(|value| written(value)).collect();
            if doc.name != "show" && doc.name != "form" {
                used.extend(others.flat_map(written));
            }
            let default = doc.default.unwrap_or_default();
            let unused = words(&doc.schema).into_iter().filter(|word| {
                !(used.contains(word) || values.len() < own.len() && default.contains(&format!("\"{word}\"")))
            });
            missing.extend(unused.map(|word| format!("{key}: {} = \"{word}\"", doc.name)));
        }
    }
    assert!(missing.is_empty(), "the gallery does not show {missing:#?}");
}
