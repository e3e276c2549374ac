//! Citations and the bibliography, through a CSL processor and the style in `templates/citations.csl`.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use hayagriva::citationberg::{IndependentStyle, Locale, LocaleFile};
use hayagriva::{BibliographyDriver, BibliographyRequest, BufWriteFormat, CitationItem, CitationRequest, Entry};

use crate::diag::{Code, Diagnostic};
use crate::parse::{Callout, Cited, Course, Node, What};
use crate::plan::{Plan, escape};
use crate::workspace::{TEMPLATES, Workspace};

/// The style and the terms of its language.
const STYLE: &str = "citations.csl";
const LOCALE: &str = "citations-locale.xml";

/// The formatted citations and list of works of a book.
#[derive(Default)]
pub(super) struct Citations {
    /// For each cited work, what stands in the text.
    marks: BTreeMap<String, String>,
    /// The works as they are listed, by the ids that they have there.
    entries: BTreeMap<String, String>,
    list: String,
}

impl Citations {
    /// Formats the works that the course cites.
    pub(super) fn format(
        course: &Course,
        plan: &Plan,
        workspace: &Workspace,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Self {
        let cited = cited(course, plan);
        let entries: Vec<&Entry> = cited.iter().filter_map(|key| plan.bibliography.get(key)).collect();
        let (style, locale) = (template(STYLE, workspace), template(LOCALE, workspace));
        let style = IndependentStyle::from_xml(&style).map_err(|error| broken(STYLE, &error.to_string()));
        let locale = LocaleFile::from_xml(&locale).map_err(|error| broken(LOCALE, &error.to_string()));
        match (style, locale) {
            (Ok(style), Ok(locale)) => Self::process(&entries, &style, &[locale.into()]),
            (style, locale) => {
                diagnostics.extend(style.err().into_iter().chain(locale.err()));
                Self::default()
            }
        }
    }

    fn process(entries: &[&Entry], style: &IndependentStyle, locales: &[Locale]) -> Self {
        let mut driver = BibliographyDriver::new();
        for entry in entries {
            driver.citation(CitationRequest::from_items(vec![CitationItem::with_entry(*entry)], style, locales));
        }
        let rendered = driver.finish(BibliographyRequest::new(style, None, locales));
        let html = |children: &hayagriva::ElemChildren| {
            let mut text = String::new();
            let _ = children.write_buf(&mut text, BufWriteFormat::Html);
            text
        };
        let marks = entries.iter().zip(&rendered.citations);
        let marks = marks.map(|(entry, mark)| (entry.key().to_owned(), html(&mark.citation))).collect();
        let mut entries = BTreeMap::new();
        let mut list = String::from("<ol class=\"bibliography\">\n");
        for item in rendered.bibliography.iter().flat_map(|bibliography| &bibliography.items) {
            let id = format!("ref-{}", escape(&item.key));
            let entry = format!("<li id=\"{id}\">{}</li>", tied(&html(&item.content)));
            let _ = writeln!(list, "{entry}");
            entries.insert(id, entry);
        }
        list.push_str("</ol>\n");
        Self { marks, entries, list }
    }

    /// A work's mark in the text, linked to the list.
    pub(super) fn link(&self, cited: &Cited) -> String {
        let mark = self.marks.get(&cited.key).map(String::as_str).unwrap_or_default();
        let locator = if cited.locator.is_empty() { String::new() } else { format!(", {}", escape(&cited.locator)) };
        let mark = match mark.strip_suffix(']').or_else(|| mark.strip_suffix(')')) {
            Some(open) => format!("{open}{locator}{}", &mark[open.len()..]),
            None => format!("{mark}{locator}"),
        };
        format!("<a class=\"citation\" href=\"bibliography.html#ref-{}\">{mark}</a>", escape(&cited.key))
    }

    /// The work that has this id in the list, as HTML.
    pub(super) fn entry(&self, id: &str) -> Option<&str> {
        self.entries.get(id).map(String::as_str)
    }

    /// The ids of the works in the list.
    pub(super) fn ids(&self) -> impl Iterator<Item = &str> {
        self.entries.keys().map(String::as_str)
    }

    /// The list of works, as HTML.
    pub(super) fn list(&self) -> &str {
        &self.list
    }
}

/// A formatted work as HTML whose lines break neither within a range of pages nor behind an initial.
fn tied(html: &str) -> String {
    let letters: Vec<char> = html.chars().collect();
    let at = |index: usize, back: usize| index.checked_sub(back).and_then(|index| letters.get(index)).copied();
    let mut out = String::with_capacity(html.len() + 32);
    let mut in_tag = false;
    for (index, &letter) in letters.iter().enumerate() {
        in_tag = letter == '<' || in_tag && at(index, 1) != Some('>');
        let initial = at(index, 2).is_some_and(|c| c.is_uppercase() || c == 'p')
            && !at(index, 3).is_some_and(|c| c.is_lowercase() && c != 'p');
        match letter {
            ' ' if !in_tag && at(index, 1) == Some('.') && initial => out.push('\u{a0}'),
            '–' if !in_tag && letters.get(index + 1).is_some_and(char::is_ascii_digit) => out.push_str("–\u{2060}"),
            letter => out.push(letter),
        }
    }
    out
}

/// The course's own file of this name in the folder of templates, or the embedded one.
fn template(name: &str, workspace: &Workspace) -> String {
    match workspace.text(&format!("{TEMPLATES}/{name}")) {
        Some(source) => source.text.to_string(),
        None => String::from_utf8_lossy(super::templates::embedded(name).unwrap_or_default()).into_owned(),
    }
}

fn broken(name: &str, error: &str) -> Diagnostic {
    Diagnostic::error(Code::Template, format!("`{TEMPLATES}/{name}` cannot be read: {error}"))
}

/// The keys of the works that the course cites, in the order of their first citation.
pub(super) fn cited(course: &Course, plan: &Plan) -> Vec<String> {
    let mut keys = Vec::new();
    for (index, chapter) in course.chapters.iter().enumerate() {
        gather(&chapter.content.nodes, &mut keys);
        plan.exhibits
            .iter()
            .filter(|exhibit| exhibit.chapter == index)
            .for_each(|exhibit| gather(&exhibit.caption, &mut keys));
        plan.listings
            .iter()
            .filter(|listing| listing.chapter == index)
            .for_each(|listing| gather(&listing.caption, &mut keys));
    }
    keys
}

fn gather(nodes: &[Node], keys: &mut Vec<String>) {
    for node in nodes {
        match &node.what {
            What::Citation(cited) => {
                for cited in cited {
                    if !keys.contains(&cited.key) {
                        keys.push(cited.key.clone());
                    }
                }
            }
            What::CalloutStart(Callout { title, .. }) => gather(title, keys),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::tied;

    #[test]
    fn initials_and_ranges_are_not_torn() {
        let html = "<a title=\"A. B\">J. D. Owens</a> (1999). In a. Set, pp. 785–794, p. 3 of part A";
        let tied = tied(html).replace('\u{a0}', "~").replace('\u{2060}', "+");
        assert_eq!(tied, "<a title=\"A. B\">J.~D.~Owens</a> (1999). In a. Set, pp.~785–+794, p.~3 of part A");
    }
}
