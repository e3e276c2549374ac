//! A page as a preview serves it: in parts, so that a browser that has it need only be told of those that are new.
//!
//! The parts are the blocks of a chapter, and what stands before the first and behind the last; any other page is one part. A page is known
//! by the digest of its text, and so what a browser says that it has cannot be mistaken.

use std::collections::{BTreeMap, VecDeque};
use std::ops::Range;

use serde_json::{Value, json};

use crate::render::{Looks, MARK};
use crate::sources::Digest;

/// Where the server's own files are: no file of a course that is hidden is ever read.
pub(super) const OWN: &str = ".workbook/";

/// A page and its parts.
#[derive(Debug)]
pub(super) struct Page {
    text: String,
    parts: Vec<Range<usize>>,
    digests: Vec<Digest>,
    digest: String,
}

impl Page {
    /// The page with this text.
    pub fn new(text: String) -> Self {
        let mut parts = Vec::new();
        let mut start = 0;
        for (at, mark) in text.match_indices(MARK) {
            parts.push(start..at);
            start = at + mark.len();
        }
        parts.push(start..text.len());
        let digests = parts.iter().map(|part| Digest::of(text[part.clone()].as_bytes())).collect();
        Self { digest: Digest::of(text.as_bytes()).to_string(), text, parts, digests }
    }

    /// By what it is known.
    pub fn digest(&self) -> &str {
        &self.digest
    }

    /// The digests of its parts, in order.
    pub fn digests(&self) -> &[Digest] {
        &self.digests
    }

    /// The page for a browser, with the script that follows the changes of the page at `path`.
    pub fn html(&self, path: &str, looks: &Looks) -> String {
        let (digest, path) = (&self.digest, crate::plan::escape(path));
        let up = "../".repeat(path.matches('/').count());
        let script = format!(
            "<link rel=\"stylesheet\" href=\"{up}{OWN}live.css\">\
             <script src=\"{up}{OWN}live.js\" defer data-digest=\"{digest}\" data-path=\"{path}\" \
             data-assets=\"{}\" data-scripts=\"{}\"></script>",
            looks.assets, looks.scripts
        );
        // Before all other scripts that wait for the page, so that it sees the page as it was made.
        let at = self.text.find("<head>").map_or(0, |at| at + "<head>".len());
        [&self.text[..at], &script, &self.text[at..]].concat()
    }

    /// What a browser needs that has a page with the parts `known`: each part, or where it has it already.
    pub fn patch(&self, known: &[Digest], looks: &Looks) -> String {
        let places = self.places(known);
        let parts = self.parts.iter().zip(places);
        let parts: Vec<Value> =
            parts.map(|(part, place)| place.map_or_else(|| self.text[part.clone()].into(), Value::from)).collect();
        json!({ "digest": self.digest, "parts": parts, "assets": looks.assets, "scripts": looks.scripts }).to_string()
    }

    /// For each part, its place among the parts that a browser has, each of them once. What is around the blocks is had whole or not at all.
    fn places(&self, known: &[Digest]) -> Vec<Option<usize>> {
        let mut free: BTreeMap<Digest, VecDeque<usize>> = BTreeMap::new();
        for (at, digest) in known.iter().enumerate() {
            free.entry(*digest).or_default().push_back(at);
        }
        let mut places: Vec<Option<usize>> =
            self.digests.iter().map(|digest| free.get_mut(digest).and_then(VecDeque::pop_front)).collect();
        let last = places.len() - 1;
        if places[0] != Some(0) || places[last] != known.len().checked_sub(1) {
            places[0] = None;
            places[last] = None;
        }
        places
    }
}

/// The page while there is none: what is wrong with the course is shown above it.
pub(super) fn blank(words: &str) -> Page {
    Page::new(format!(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\
         <meta name=\"color-scheme\" content=\"light dark\"><title>workbook</title></head>\
         <body class=\"live-blank\"><main id=\"main\"><p>{words}</p></main></body></html>"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_new_parts_are_sent() {
        let page = |blocks: &[&str]| Page::new(format!("<head></head>{MARK}{}{MARK}tail", blocks.join(MARK)));
        let (old, new) = (page(&["a", "b", "c"]), page(&["a", "x", "b", "c"]));
        let patch: Value = serde_json::from_str(&new.patch(old.digests(), &Looks::default())).unwrap();
        assert_eq!(patch["parts"], json!([0, 1, "x", 2, 3, 4]));
        let twice: Value =
            serde_json::from_str(&page(&["a", "a", "b"]).patch(old.digests(), &Looks::default())).unwrap();
        assert_eq!(twice["parts"], json!([0, 1, "a", 2, 4]), "a block is had once");
        let around = Page::new(format!("<head></head>{MARK}a{MARK}other"));
        let around: Value = serde_json::from_str(&around.patch(old.digests(), &Looks::default())).unwrap();
        assert_eq!(around["parts"], json!(["<head></head>", 1, "other"]));
        assert_eq!(patch["digest"], json!(new.digest()));
        let whole: Value = serde_json::from_str(&new.patch(&[], &Looks::default())).unwrap();
        assert_eq!(whole["parts"], json!(["<head></head>", "a", "x", "b", "c", "tail"]));
        assert_ne!(old.digest(), new.digest());
    }

    #[test]
    fn the_script_stands_first() {
        let html =
            Page::new("<html><head><script src=\"a.js\"></script>".to_owned()).html("deep/\"x.html", &Looks::default());
        assert!(html.find("live.js").unwrap() < html.find("a.js").unwrap());
        assert!(html.contains("\"../.workbook/live.js\"") && html.contains("data-path=\"deep/&quot;x.html\""));
    }
}
