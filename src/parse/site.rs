//! The site's settings: its address, pages that have moved, and where the text and the code can be read and edited.

use std::fmt::Write as _;
use std::ops::Range;

use toml::de::DeValue;

use super::{Chapter, OWN_PAGES};
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic};
use crate::parameters::{Complaint, Fields, Parameters, parameters};
use crate::workspace::{CHAPTERS, CONFIGURATION, Workspace, extension};

parameters! {
    /// The keys of the table `[repository]`.
    pub struct Written {
        /// The page of the repository.
        url: Option<String>,
        /// The page on which a file is edited, with `{path}` for the file.
        edit_url: Option<String>,
        /// The page of a line of code, with `{path}`, `{line}` and, if it is to stay true, `{commit}`.
        source_url: Option<String>,
        /// What stands for `{commit}`; `git` asks git.
        commit: Option<String>,
        /// Whether each chapter's page tells the day of its last change, as git has it.
        last_change: bool = false,
    }
}

/// What the course says of its site.
#[derive(Debug, Clone, Default)]
pub struct Site {
    /// Where the site will stand, with a slash at its end, e.g. `https://example.org/course/`.
    pub base_url: Option<String>,
    /// Pages that have moved.
    pub redirects: Vec<Redirect>,
    /// Where the text and the code can be read and edited.
    pub repository: Repository,
}

/// A page that has moved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Redirect {
    /// The page that was, by its path in the book.
    pub old: String,
    /// What stands for it now: a page, with an id or without.
    pub new: String,
    /// Where both stand in the configuration.
    pub places: (Range<usize>, Range<usize>),
}

/// Where the text and the code can be read and edited.
#[derive(Debug, Clone, Default)]
pub struct Repository {
    /// Its page.
    pub url: Option<String>,
    /// The page on which a file is edited.
    edit: Option<String>,
    /// The page of a line of code.
    source: Option<String>,
    /// What stands for the commit in it.
    pub commit: Commit,
    /// Whether each chapter's page tells the day of its last change.
    pub last_change: bool,
}

/// The commit that links to code name.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum Commit {
    /// None.
    #[default]
    Absent,
    /// The one that git has checked out.
    FromGit,
    /// This one.
    Given(String),
}

impl Repository {
    /// The page on which the file at `path` of the course is edited.
    pub fn edit_page(&self, path: &str) -> Option<String> {
        self.edit.as_ref().map(|pattern| pattern.replace("{path}", &encoded(path)))
    }

    /// The page of a line of code, if it is known; `commit` is what git says.
    pub fn source_page(&self, path: &str, line: usize, commit: Option<&str>) -> Option<String> {
        let pattern = self.source.as_ref()?;
        let commit = match &self.commit {
            Commit::Given(commit) => Some(commit.as_str()),
            Commit::FromGit => commit,
            Commit::Absent => None,
        };
        let pattern = match commit {
            Some(commit) => pattern.replace("{commit}", commit),
            None if pattern.contains("{commit}") => return None,
            None => pattern.clone(),
        };
        Some(pattern.replace("{line}", &line.to_string()).replace("{path}", &encoded(path)))
    }

    /// Whether git has to be asked for the commit.
    pub fn asks_for_commit(&self) -> bool {
        self.commit == Commit::FromGit && self.source.is_some()
    }
}

impl Site {
    /// The part of the site's address behind its host, e.g. `/course/`: what addresses from the root begin with.
    pub fn root(&self) -> Option<&str> {
        let (_, rest) = self.base_url.as_ref()?.split_once("://")?;
        rest.find('/').map(|at| &rest[at..])
    }
}

/// A path as an address has it.
fn encoded(path: &str) -> String {
    let mut out = String::with_capacity(path.len());
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'/' => out.push(char::from(byte)),
            // Writing to a string cannot fail.
            _ => drop(write!(out, "%{byte:02X}")),
        }
    }
    out
}

/// Reads what is said of the site; what is wrong is told in `fields`.
pub(super) fn read(base_url: Option<String>, fields: &mut Fields<'_>) -> Site {
    let base_url = base_url.and_then(|url| {
        let complaint = address(&url, "base_url", fields.place("base_url"))
            .or_else(|| url.contains(['?', '#']).then(|| bad("base_url", &url, fields.place("base_url"))));
        let fine = complaint.is_none();
        fields.complaints.extend(complaint);
        fine.then(|| format!("{}/", url.trim_end_matches('/')))
    });
    Site { base_url, redirects: redirects(fields), repository: repository(fields).unwrap_or_default() }
}

fn bad(name: &str, url: &str, place: Range<usize>) -> Complaint {
    Complaint::new(Code::Configuration, place, format!("`{url}` is no address that `{name}` can be"))
        .help(format!("write the whole address: `{name} = \"https://example.org/course/\"`"))
}

/// A complaint if `url` is no whole address on the web.
fn address(url: &str, name: &str, place: Range<usize>) -> Option<Complaint> {
    let rest = url.strip_prefix("https://").or_else(|| url.strip_prefix("http://"));
    let sound = rest.is_some_and(|rest| !rest.is_empty() && !rest.starts_with('/'))
        && !url.contains(|c: char| c.is_whitespace() || c.is_control() || "\"'<>\\".contains(c));
    (!sound).then(|| bad(name, url, place))
}

fn repository(fields: &mut Fields<'_>) -> Option<Repository> {
    let table = fields.table("repository")?;
    let mut inner = Fields::plain(table);
    let written = Written::read(&mut inner);
    let known: Vec<&str> = Written::docs().iter().map(|doc| doc.name).collect();
    inner.finish(&known);
    if let Some(written) = &written {
        let patterns = [
            ("url", &written.url, &[][..], &[][..]),
            ("edit_url", &written.edit_url, &["path"][..], &["path"][..]),
            ("source_url", &written.source_url, &["path", "line"][..], &["commit", "path", "line"][..]),
        ];
        for (name, url, needed, known) in patterns {
            let Some(url) = url else { continue };
            let place = inner.place(name);
            let complaints = address(url, name, place.clone()).into_iter().chain(holes(url, needed, known, &place));
            inner.complaints.extend(complaints);
        }
        if written.source_url.as_ref().is_some_and(|url| url.contains("{commit}")) && written.commit.is_none() {
            let message = "`source_url` has `{commit}`, and no commit is given";
            let complaint = Complaint::new(Code::Configuration, inner.place("source_url"), message);
            inner.complaints.push(
                complaint
                    .help("add `commit = \"git\"` to ask git each time, which changes the pages with each commit")
                    .help("or name one: `commit = \"main\"`, `commit = \"v1.0\"`"),
            );
        }
    }
    fields.complaints.append(&mut inner.complaints);
    let written = written?;
    let commit = match written.commit {
        None => Commit::Absent,
        Some(word) if word == "git" => Commit::FromGit,
        Some(commit) => Commit::Given(encoded(&commit)),
    };
    let Written { url, edit_url: edit, source_url: source, last_change, .. } = written;
    Some(Repository { url, edit, source, commit, last_change })
}

/// Complaints of the words in braces of a pattern: those that are needed and not there, and those that mean nothing.
fn holes(pattern: &str, needed: &[&str], known: &[&str], place: &Range<usize>) -> Vec<Complaint> {
    let written: Vec<&str> = pattern.split('{').skip(1).filter_map(|rest| Some(rest.split_once('}')?.0)).collect();
    let missing = needed.iter().filter(|name| !written.contains(name)).map(|name| {
        let message = format!("the pattern `{pattern}` has no `{{{name}}}`");
        Complaint::new(Code::Configuration, place.clone(), message)
            .help(format!("write `{{{name}}}` where it belongs in the address"))
    });
    let unknown = written.iter().filter(|name| !known.contains(name)).map(|name| {
        let near = nearest(name, known.iter().copied()).map(|near| format!("did you mean `{{{near}}}`?"));
        Complaint::new(Code::UnknownName, place.clone(), format!("nothing stands for `{{{name}}}` here")).help_if(near)
    });
    missing.chain(unknown).collect()
}

/// The table `[redirects]`.
fn redirects(fields: &mut Fields<'_>) -> Vec<Redirect> {
    let mut redirects = Vec::new();
    let Some(table) = fields.table("redirects") else { return redirects };
    for (key, value) in table {
        let old = key.get_ref().to_string();
        let DeValue::String(new) = value.get_ref() else {
            let message = format!("`{old}` leads to no page");
            let complaint = Complaint::new(Code::WrongType, value.span(), message);
            fields.complaints.push(complaint.help("write `\"old.html\" = \"new.html\"`"));
            continue;
        };
        if is_page(&old) {
            redirects.push(Redirect { old, new: new.to_string(), places: (key.span(), value.span()) });
        } else {
            let complaint =
                Complaint::new(Code::Configuration, key.span(), format!("`{old}` can be no page of the book"));
            fields.complaints.push(
                complaint
                    .help("a page is named by its path in the book, with letters, digits and `-`: `old/place.html`"),
            );
        }
    }
    redirects
}

/// Whether a page of the book can have this path.
fn is_page(path: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    extension(path) == Some("html")
        && path.split('/').all(|part| !part.is_empty() && !part.starts_with('.') && part.chars().all(plain))
}

/// Complains of redirects from pages that are there, and to pages that are not.
pub(super) fn check_redirects(site: &Site, chapters: &[Chapter], workspace: &Workspace, told: &mut Vec<Diagnostic>) {
    let file = CONFIGURATION.into();
    let own = OWN_PAGES.iter().copied();
    let pages: Vec<String> =
        chapters.iter().map(|chapter| chapter.slug.as_str()).chain(own).map(|name| format!("{name}.html")).collect();
    for Redirect { old, new, places } in &site.redirects {
        if pages.contains(old) || workspace.blobs.contains_key(format!("{CHAPTERS}/{old}").as_str()) {
            let error = Diagnostic::error(Code::Configuration, format!("`{old}` is in the book, so it has not moved"));
            told.push(error.at(&file, places.0.clone()).help("remove the line, or give the chapter another name"));
        }
        let page = new.split_once('#').map_or(new.as_str(), |(page, _)| page);
        if !pages.iter().any(|known| known == page) {
            let near = nearest(page, pages.iter().map(String::as_str)).map(|near| format!("did you mean `{near}`?"));
            let error = Diagnostic::error(Code::BrokenLink, format!("the book has no page `{page}`"));
            told.push(error.at(&file, places.1.clone()).help_if(near));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_have_plain_paths() {
        assert!(is_page("old.html") && is_page("a/b-c_1.html"));
        for path in ["old", "../old.html", "/old.html", "a//b.html", "a/.html", "a b.html", "a\".html", ".html"] {
            assert!(!is_page(path), "{path}");
        }
    }

    #[test]
    fn addresses_of_code_name_path_line_and_commit() {
        let pattern = "https://example.org/{commit}/{path}#L{line}".to_owned();
        let mut repository = Repository { source: Some(pattern), commit: Commit::FromGit, ..Repository::default() };
        let page = |repository: &Repository, commit| repository.source_page("src/a b.rs", 7, commit);
        assert_eq!(page(&repository, Some("abc")).as_deref(), Some("https://example.org/abc/src/a%20b.rs#L7"));
        assert_eq!(page(&repository, None), None, "git could not tell");
        repository.commit = Commit::Given("v1".to_owned());
        assert_eq!(page(&repository, None).as_deref(), Some("https://example.org/v1/src/a%20b.rs#L7"));
        assert_eq!(Repository::default().source_page("x", 1, Some("abc")), None);
    }

    #[test]
    fn the_root_is_what_stands_behind_the_host() {
        let root = |url: &str| Site { base_url: Some(url.to_owned()), ..Site::default() }.root().map(str::to_owned);
        assert_eq!(root("https://example.org/"), Some("/".to_owned()));
        assert_eq!(root("https://example.org/a/b/"), Some("/a/b/".to_owned()));
        assert_eq!(Site::default().root(), None);
    }
}
