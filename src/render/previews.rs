//! The files of previews: for each page the targets there that other pages refer to, of which a script makes cards.
//!
//! A page opened from disk cannot fetch anything, but it can load a script: each file is one call, with the HTML of the targets by id. It is
//! loaded when a reader first asks for one of them.

use std::collections::{BTreeMap, BTreeSet};

use pulldown_cmark::{Event, Tag};
use serde::Serialize;

use super::exhibit::{self, label};
use super::markdown::Writer;
use super::matter::{self, BIBLIOGRAPHY};
use super::templates::ASSETS;
use super::{Rendering, blocks, table};
use crate::chart::Drawing;
use crate::parse::{Node, What};
use crate::plan::{Exhibit, terms};

/// The classes of links that have previews.
const LINKS: [&str; 3] = ["reference", "term", "citation"];

/// The most pictures of an exhibit, and the most bytes of a table, that a card has room for.
const PICTURES: usize = 4;
const TABLE: usize = 6_000;

/// The files, by their paths in the book, for what the `pages` refer to.
pub(super) fn files(rendering: &Rendering<'_>, pages: &[(String, String)]) -> Vec<(String, String)> {
    let mut files = Vec::new();
    for (page, ids) in wanted(pages) {
        let targets: BTreeMap<&str, String> =
            ids.iter().filter_map(|id| Some((*id, target(rendering, page, id)?))).collect();
        let Some(stem) = page.strip_suffix(".html").filter(|_| !targets.is_empty()) else { continue };
        files.push((format!("{ASSETS}/previews/{stem}.js"), call(page, &targets)));
    }
    files
}

/// The file at `path` with all that there is to refer to on its page, for whoever does not know what the other pages refer to.
pub(super) fn whole(rendering: &Rendering<'_>, path: &str) -> Option<String> {
    let stem = path.strip_prefix(ASSETS)?.strip_prefix("/previews/")?.strip_suffix(".js")?;
    let page = format!("{stem}.html");
    let ids: Vec<String> = match (0..rendering.course.chapters.len()).find(|&chapter| rendering.href(chapter) == page) {
        Some(chapter) => {
            let labels = &rendering.plan.labels;
            labels.ids_in(chapter).map(str::to_owned).chain(rendering.plan.terms.ids_in(chapter)).collect()
        }
        None if page == BIBLIOGRAPHY.href => rendering.citations.ids().map(str::to_owned).collect(),
        None => return None,
    };
    let targets = ids.into_iter().filter_map(|id| Some((target(rendering, &page, &id)?, id)));
    let targets: BTreeMap<String, String> = targets.map(|(html, id)| (id, html)).collect();
    Some(call(&page, &targets))
}

/// The text of a file: one call.
fn call<K: Serialize + Ord>(page: &str, targets: &BTreeMap<K, String>) -> String {
    format!("workbook.previews({}, {});\n", serde_json::json!(page), serde_json::json!(targets))
}

/// The pages that other pages refer to, with the ids there.
fn wanted(pages: &[(String, String)]) -> BTreeMap<&str, BTreeSet<&str>> {
    let mut wanted: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (path, html) in pages {
        for link in html.split("<a class=\"").skip(1) {
            let Some((_, rest)) = link.split_once("\" href=\"").filter(|(class, _)| LINKS.contains(class)) else {
                continue;
            };
            let href = rest.split('"').next().unwrap_or_default();
            if let Some((page, id)) = href.split_once('#').filter(|(page, _)| !page.is_empty() && page != path) {
                wanted.entry(page).or_default().insert(id);
            }
        }
    }
    wanted
}

/// The HTML of the target `id` on the page `page`, as it stands there, or less of it where it is large.
fn target(rendering: &Rendering<'_>, page: &str, id: &str) -> Option<String> {
    if page == BIBLIOGRAPHY.href {
        return rendering.citations.entry(id).map(str::to_owned);
    }
    let chapters = &rendering.course.chapters;
    let chapter = (0..chapters.len()).find(|&chapter| rendering.href(chapter) == page)?;
    if let Some(index) = rendering.plan.exhibits.iter().position(|exhibit| exhibit.id == id) {
        return Some(exhibit(rendering, index));
    }
    if let Some(listing) = rendering.plan.listings.iter().find(|listing| listing.id == id) {
        return Some(exhibit::listing(rendering, listing).0);
    }
    let nodes = &chapters[chapter].content.nodes;
    let anchored = |at: &usize| rendering.plan.labels.anchor(chapter, *at).is_some_and(|anchor| anchor.id == id);
    let html = match (0..nodes.len()).find(anchored) {
        Some(at) => part(rendering, chapter, at, blocks::end(nodes, at)) + &opening(rendering, chapter, at),
        None => term(rendering, chapter, id)?,
    };
    Some(html)
}

/// The nodes from `start` to `end` as HTML, without what is folded and without notes.
fn part(rendering: &Rendering<'_>, chapter: usize, start: usize, end: usize) -> String {
    let nodes = &rendering.course.chapters[chapter].content.nodes;
    let mut writer = Writer::new(rendering, chapter);
    let mut at = start;
    while at <= end {
        match &nodes[at].what {
            What::CalloutStart(callout) if callout.kind.folded() => at = blocks::end(nodes, at),
            What::Markdown(Event::Start(Tag::FootnoteDefinition(_))) => at = blocks::end(nodes, at),
            _ => writer.range(at..at + 1),
        }
        at += 1;
    }
    // What there is to complain of has been told when the page was written.
    writer.done().0
}

/// The paragraph that a section begins with, if it begins with one.
fn opening(rendering: &Rendering<'_>, chapter: usize, at: usize) -> String {
    let nodes = &rendering.course.chapters[chapter].content.nodes;
    let is = |at: usize, tag: fn(&Tag<'_>) -> bool| matches!(nodes.get(at).map(|node| &node.what), Some(What::Markdown(Event::Start(start))) if tag(start));
    let next = blocks::end(nodes, at) + 1;
    if is(at, |tag| matches!(tag, Tag::Heading { .. })) && is(next, |tag| matches!(tag, Tag::Paragraph)) {
        return part(rendering, chapter, next, blocks::end(nodes, next));
    }
    String::new()
}

/// What a term is defined in: a callout, else a paragraph, item or cell, else the caption of an exhibit.
fn term(rendering: &Rendering<'_>, chapter: usize, id: &str) -> Option<String> {
    let nodes = &rendering.course.chapters[chapter].content.nodes;
    let Some(at) = nodes.iter().position(|node| defines(node, id)) else {
        let own =
            |exhibit: &Exhibit| exhibit.chapter == chapter && exhibit.caption.iter().any(|node| defines(node, id));
        return rendering.plan.exhibits.iter().position(own).map(|index| exhibit(rendering, index));
    };
    let start = blocks::around(nodes, at)?;
    let end = blocks::end(nodes, start);
    Some(match &nodes[start].what {
        What::Markdown(Event::Start(Tag::TableCell)) => {
            format!("<p>{}</p>", part(rendering, chapter, start + 1, end.saturating_sub(1)))
        }
        _ => part(rendering, chapter, start, end),
    })
}

/// Whether a node defines the term that has this id, itself or in its title.
fn defines(node: &Node, id: &str) -> bool {
    match &node.what {
        What::Term(term) => term.defines && terms::id(&terms::key(term)) == id,
        What::CalloutStart(callout) => callout.title.iter().any(|node| defines(node, id)),
        _ => false,
    }
}

/// An exhibit: its pictures as the files that lie in the book, or its table if it is small, and its caption.
fn exhibit(rendering: &Rendering<'_>, index: usize) -> String {
    let exhibit = &rendering.plan.exhibits[index];
    let (caption, _) = Writer::new(rendering, exhibit.chapter).inline(&exhibit.caption);
    let (class, body) = if let Drawing::Table(drawn) = &*rendering.shown[index].drawing {
        ("table", table::html(drawn, rendering.converter))
    } else {
        let images = matter::images(rendering, index).take(PICTURES);
        let images: Vec<String> = images.map(|image| format!("<img src=\"{image}\" alt=\"\">")).collect();
        ("figure", format!("<div class=\"sheet\">{}</div>", images.concat()))
    };
    let body = if body.len() <= TABLE { body } else { String::new() };
    let (id, label) = (&exhibit.id, label(rendering, &exhibit.id));
    format!(
        "<figure class=\"exhibit exhibit-{class}\" id=\"{id}\"><div class=\"exhibit-body\">{body}</div>\
         <figcaption><p><span class=\"label\">{label}</span> {caption}</p></figcaption></figure>"
    )
}
