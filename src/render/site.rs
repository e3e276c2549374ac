//! What the web expects of a site beside its pages: a page for what is not there, signs where pages have moved, a map, a card.

use std::fmt::Write as _;

use serde::Serialize;
use serde_json::json;

use super::card;
use super::matter::{MATTER, Matter};
use super::{Book, Rendering, SITEMAP, pages};
use crate::diag::Diagnostic;
use crate::parse::Redirect;
use crate::plan::escape;
use crate::workspace::extension;

/// The page for addresses that lead nowhere.
pub const LOST: &str = "404.html";
/// The picture that stands for the book where somebody links to it.
const CARD: &str = "assets/card.png";

/// What every page knows of the site.
#[derive(Serialize)]
pub(super) struct SiteContext<'a> {
    /// Where the site will stand, with a slash at its end.
    base: Option<&'a str>,
    /// The picture that stands for it, by its whole address.
    card: Option<String>,
    /// The page of the repository.
    repository: Option<&'a str>,
    /// The page on which the source of this page is edited.
    edit: Option<String>,
    /// The day of this page's last change.
    changed: Option<&'a str>,
}

/// What the page of the chapter `current`, or a page that is no chapter's, knows of the site.
pub(super) fn context<'a>(rendering: &Rendering<'a>, current: Option<usize>) -> SiteContext<'a> {
    let site = &rendering.course.configuration.site;
    let file = current.and_then(|index| rendering.course.chapters.get(index)).map(|chapter| &*chapter.file);
    let base = site.base_url.as_deref();
    SiteContext {
        base,
        card: base.map(|base| format!("{base}{CARD}")),
        repository: site.repository.url.as_deref(),
        // A chapter that was generated has no file of its own.
        edit: file
            .filter(|file| rendering.workspace.text(file).is_some())
            .and_then(|file| site.repository.edit_page(file)),
        changed: file.and_then(|file| rendering.workspace.history.changed.get(file)).map(String::as_str),
    }
}

/// The page of a line of code, e.g. line 41 of `src/samplers/halton.rs`, if the course says where its code can be read.
pub(super) fn source_page(rendering: &Rendering<'_>, path: &str, line: usize) -> Option<String> {
    let repository = &rendering.course.configuration.site.repository;
    repository.source_page(path, line, rendering.workspace.history.commit.as_deref())
}

/// The same of a place like `src/samplers/halton.rs:41`.
pub(super) fn source_of(rendering: &Rendering<'_>, place: &str) -> Option<String> {
    let (path, line) = place.rsplit_once(':')?;
    source_page(rendering, path, line.parse().ok()?)
}

/// A page that has moved.
#[derive(Serialize)]
struct Moved<'a> {
    language: &'a str,
    title: &'a str,
    /// The title of the new page.
    name: &'a str,
    /// The link to it.
    href: String,
    /// Its whole address, if the site's is known, else the link to it.
    canonical: String,
}

/// The paths of the pages that are made of the site's settings.
pub(super) fn extra_paths(rendering: &Rendering<'_>) -> impl Iterator<Item = String> {
    let moved = rendering.course.configuration.site.redirects.iter().map(|redirect| redirect.old.clone());
    std::iter::once(LOST.to_owned()).chain(moved)
}

/// The one of them at this path.
pub(super) fn extra_page(rendering: &Rendering<'_>, path: &str, diagnostics: &mut Vec<Diagnostic>) -> Option<String> {
    if path == LOST {
        return Some(lost(rendering, diagnostics));
    }
    let redirect = rendering.course.configuration.site.redirects.iter().find(|redirect| redirect.old == path)?;
    Some(rendering.templates.fill("moved.html", &moved(rendering, redirect), diagnostics))
}

fn moved<'a>(rendering: &Rendering<'a>, redirect: &Redirect) -> Moved<'a> {
    let configuration = &rendering.course.configuration;
    let up = "../".repeat(redirect.old.matches('/').count());
    let page = redirect.new.split('#').next().unwrap_or_default();
    let chapter = rendering.course.chapters.iter().find(|chapter| page.strip_suffix(".html") == Some(&chapter.slug));
    let matter = MATTER.iter().find(|matter| matter.href == page).map(|matter| matter.title);
    Moved {
        language: &configuration.language,
        title: &configuration.title,
        name: chapter.map(|chapter| chapter.front.title.as_str()).or(matter).unwrap_or(&configuration.title),
        href: format!("{up}{}", redirect.new),
        canonical: configuration
            .site
            .base_url
            .as_ref()
            .map_or_else(|| format!("{up}{page}"), |base| address(base, page)),
    }
}

/// The whole address of a page of a site that stands at `base`: that of the landing page is the site's.
fn address(base: &str, page: &str) -> String {
    format!("{base}{}", if page == "index.html" { "" } else { page })
}

/// The page for addresses that lead nowhere: it may be shown for an address of any depth, so its links begin at the site's root if
/// that is known.
fn lost(rendering: &Rendering<'_>, diagnostics: &mut Vec<Diagnostic>) -> String {
    let root = rendering.course.configuration.site.root().unwrap_or_default();
    let matter = Matter { title: "Page not found", href: LOST, summary: "There is no page at this address." };
    let own = json!({ "root": root, "assets": format!("{root}{}", super::templates::ASSETS), "lost": true });
    pages::matter_page(rendering, &matter, own, diagnostics)
}

/// The files that only a site whose address is known has: its map and its card.
pub(super) fn files(rendering: &Rendering<'_>, book: &mut Book) {
    let site = &rendering.course.configuration.site;
    let Some(base) = &site.base_url else { return };
    let is_moved = |path: &str| site.redirects.iter().any(|redirect| redirect.old == path);
    let is_listed = |path: &&String| extension(path) == Some("html") && path.as_str() != LOST && !is_moved(path);
    let mut map = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n",
    );
    for path in book.files.keys().filter(is_listed) {
        let chapter = rendering.course.chapters.iter().find(|chapter| format!("{}.html", chapter.slug) == *path);
        let changed = chapter.and_then(|chapter| rendering.workspace.history.changed.get(&*chapter.file));
        let changed = changed.map(|day| format!("<lastmod>{day}</lastmod>")).unwrap_or_default();
        let _ = writeln!(map, "<url><loc>{}</loc>{changed}</url>", escape(&address(base, path)));
    }
    map.push_str("</urlset>\n");
    book.files.insert(SITEMAP.to_owned(), map.into_bytes());
    book.files.extend(card::png(&rendering.course.configuration.title).map(|bytes| (CARD.to_owned(), bytes)));
}
