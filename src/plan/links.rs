//! Links of the text: to chapters by their files, to places on a page, and to other sites.

use crate::parse::Course;

/// Why a link leads nowhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BadLink {
    /// There is no such chapter.
    NoChapter,
    /// It is of a kind that pages must not hold.
    Scheme,
}

/// The address in the book of a link as written: `03-stratification.md#sec-curse` is `stratification.html#sec-curse`.
pub fn resolve(url: &str, course: &Course) -> Result<String, BadLink> {
    if let Some((scheme, _)) = url.split_once(':').filter(|(scheme, _)| !scheme.contains(['/', '#', '?'])) {
        let known = ["http", "https", "mailto"].contains(&scheme.to_ascii_lowercase().as_str());
        return if known { Ok(url.to_owned()) } else { Err(BadLink::Scheme) };
    }
    let (path, fragment) = match url.find('#') {
        Some(at) => url.split_at(at),
        None => (url, ""),
    };
    let Some(stem) = path.strip_suffix(".md") else { return Ok(url.to_owned()) };
    let stem = stem.trim_start_matches("./");
    let chapter = course.chapters.iter().find(|chapter| chapter.stem == stem).ok_or(BadLink::NoChapter)?;
    Ok(format!("{}.html{fragment}", chapter.slug))
}
