//! The workspace: every input of a course, read once and sorted. The only reader of the course's files.

pub mod history;
pub mod revision;
pub mod watch;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::{
    fs,
    io::{self, Read},
};

use crate::diag::{Code, Diagnostic};

pub use history::History;

/// The folder of a course that holds its chapters, configuration, bibliography and pictures.
pub const CHAPTERS: &str = "chapters";
/// The folder of a course whose files override the embedded templates, file by file.
pub const TEMPLATES: &str = "templates";
/// The configuration of a course, from its root.
pub const CONFIGURATION: &str = "chapters/workbook.toml";
/// The committed record of results, from the course's root, wherever the book is written.
pub const LOCK: &str = "book/workbook.lock";

/// A text of the course and where it stands, from the course's root.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The file, with `/` between folders.
    pub path: Arc<str>,
    /// Its text.
    pub text: Arc<str>,
}

/// Every input of a course.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    /// Texts (chapters, configuration, bibliography, templates, code) by path from the root.
    pub texts: BTreeMap<Arc<str>, Source>,
    /// Everything else under the chapters' folder (pictures, data), by path from the root.
    pub blobs: BTreeMap<Arc<str>, Arc<[u8]>>,
    /// What git says of the course, if that was asked.
    pub history: History,
}

impl Workspace {
    /// A workspace of one text, for the excerpts of what is said of it.
    pub fn of(source: Source) -> Self {
        Self { texts: BTreeMap::from([(Arc::clone(&source.path), source)]), ..Self::default() }
    }

    /// The text at `path` from the course's root.
    pub fn text(&self, path: &str) -> Option<&Source> {
        self.texts.get(path)
    }

    /// The chapters in the folder, whether listed or not, in the order of their names.
    pub fn chapters(&self) -> impl Iterator<Item = &Source> {
        self.texts.values().filter(|source| chapter_stem(&source.path).is_some())
    }

    /// The paths of what is no text, but for what editors keep beside the files that they write: `01-one.md~`, `4913`.
    pub fn data(&self) -> impl Iterator<Item = &Arc<str>> {
        const KEPT: [&str; 3] = ["tmp", "bak", "swp"];
        let plain = |ending: &str| !KEPT.contains(&ending) && ending.chars().all(char::is_alphanumeric);
        let name = |path: &str| path.rsplit_once('/').map_or_else(|| path.to_owned(), |(_, name)| name.to_owned());
        self.blobs.keys().filter(move |path| extension(&name(path)).is_some_and(plain))
    }

    /// Takes from `old` each file that is still the same, so that what is unchanged can be told without being read again.
    pub fn share(&mut self, old: &Self) {
        for (path, source) in &mut self.texts {
            if let Some(before) = old.texts.get(path).filter(|before| before.text == source.text) {
                source.clone_from(before);
            }
        }
        for (path, bytes) in &mut self.blobs {
            if let Some(before) = old.blobs.get(path).filter(|before| *before == bytes) {
                bytes.clone_from(before);
            }
        }
    }

    /// The text of a file for a diagnostic's excerpt.
    pub fn excerpt(&self, path: &str) -> Option<&str> {
        self.texts.get(path).map(|source| &*source.text)
    }
}

/// The stem of a chapter's file, `01-history` for `chapters/01-history.md`; none for any other file.
pub fn chapter_stem(path: &str) -> Option<&str> {
    let stem = path.strip_prefix(CHAPTERS)?.strip_prefix('/')?.strip_suffix(".md")?;
    (!stem.contains('/')).then_some(stem)
}

/// Reads the course at `root`. Files that are not UTF-8 or cannot be read are told, and left out.
pub fn load(root: &Path) -> (Workspace, Vec<Diagnostic>) {
    let mut workspace = Workspace::default();
    let mut diagnostics = Vec::new();
    if !root.join(CHAPTERS).is_dir() {
        diagnostics.push(
            Diagnostic::error(Code::NoCourse, format!("there is no folder `{CHAPTERS}` here, so there is no course"))
                .help("run the command in a course's folder, or name it with `--root DIR`")
                .help(format!(
                    "a course is a folder with `{CONFIGURATION}` and chapters beside it; `workbook init DIR` makes one"
                )),
        );
        return (workspace, diagnostics);
    }
    for folder in [CHAPTERS, TEMPLATES] {
        if root.join(folder).is_dir() {
            read_folder(root, folder, &mut workspace, &mut diagnostics);
        }
    }
    if !workspace.texts.contains_key(CONFIGURATION) && diagnostics.is_empty() {
        diagnostics.push(
            Diagnostic::error(Code::NoCourse, format!("the course has no `{CONFIGURATION}`"))
                .help("make it with at least `title = \"…\"` and `authors = [\"…\"]`"),
        );
    }
    (workspace, diagnostics)
}

/// Reads a text of points that is no part of a course: the file `path`, or the standard input for `-`.
///
/// The error has the code [`Code::NotUtf8`], [`Code::MissingInclude`] where there is no such file, or [`Code::Unreadable`].
pub fn read_points(path: &Path) -> Result<Source, Diagnostic> {
    let piped = path == Path::new("-");
    let name = if piped { "standard input".into() } else { path.to_string_lossy() };
    let read = || {
        if !piped {
            return fs::read(path);
        }
        let mut bytes = Vec::new();
        io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    };
    let bytes = read().map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => Diagnostic::error(Code::MissingInclude, format!("there is no file `{name}`")),
        _ => unreadable(&name, &error),
    })?;
    let text = String::from_utf8(bytes).map_err(|error| not_utf8(&name, &error))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text).into();
    Ok(Source { path: name.into(), text })
}

/// Reads the files below `folder` in the order of their names. Hidden files are passed over, and so, with a warning, are links that leave the course.
fn read_folder(root: &Path, folder: &str, workspace: &mut Workspace, diagnostics: &mut Vec<Diagnostic>) {
    let entries = match sorted_entries(&root.join(folder)) {
        Ok(entries) => entries,
        Err(error) => return diagnostics.push(unreadable(folder, &error)),
    };
    for (name, path) in entries {
        let relative = format!("{folder}/{name}");
        if name.starts_with('.') {
            continue;
        }
        if path.is_symlink() && !stays(root, &path) {
            diagnostics.push(left_out(&relative));
        } else if path.is_dir() {
            read_folder(root, &relative, workspace, diagnostics);
        } else {
            match read_file(&path) {
                Ok(bytes) => place(relative, bytes, workspace, diagnostics),
                Err(error) => diagnostics.push(unreadable(&relative, &error)),
            }
        }
    }
}

/// The bytes of a file. A pipe or a device is none: it may never end.
fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    match fs::metadata(path) {
        Ok(about) if !about.is_file() => Err(io::Error::new(io::ErrorKind::InvalidInput, "it is no ordinary file")),
        _ => fs::read(path),
    }
}

/// The names in a folder with their paths, sorted; names that are not Unicode cannot be referred to and are passed over.
fn sorted_entries(folder: &Path) -> io::Result<Vec<(String, PathBuf)>> {
    let mut entries = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if let Ok(name) = entry.file_name().into_string() {
            entries.push((name, entry.path()));
        }
    }
    entries.sort();
    Ok(entries)
}

/// Whether a symbolic link leads to something in the course, and not to a folder that holds the link itself.
fn stays(root: &Path, link: &Path) -> bool {
    let folder = link.parent().unwrap_or(root);
    match (root.canonicalize(), folder.canonicalize(), link.canonicalize()) {
        (Ok(root), Ok(folder), Ok(target)) => target.starts_with(root) && !folder.starts_with(target),
        _ => false,
    }
}

/// Puts one file where it belongs: texts that the tool reads must be UTF-8, the rest stays bytes.
fn place(path: String, bytes: Vec<u8>, workspace: &mut Workspace, diagnostics: &mut Vec<Diagnostic>) {
    let path: Arc<str> = path.into();
    if !is_text(&path) {
        workspace.blobs.insert(path, bytes.into());
        return;
    }
    match String::from_utf8(bytes) {
        Ok(text) => {
            let text = text.strip_prefix('\u{feff}').unwrap_or(&text).into();
            workspace.texts.insert(Arc::clone(&path), Source { path, text });
        }
        Err(error) => diagnostics.push(not_utf8(&path, &error)),
    }
}

/// Whether the tool reads the file as text.
fn is_text(path: &str) -> bool {
    const TEXTS: &[&str] = &["md", "csl", "xml", "toml", "bib", "html", "css", "js", "c", "h", "rs", "py", "r", "jl"];
    extension(path).is_some_and(|extension| TEXTS.contains(&extension))
}

/// What stands behind the last dot of a file's name.
pub fn extension(path: &str) -> Option<&str> {
    path.rsplit_once('.').map(|(_, extension)| extension)
}

fn not_utf8(path: &str, error: &std::string::FromUtf8Error) -> Diagnostic {
    let valid = error.utf8_error().valid_up_to();
    let before = &error.as_bytes()[..valid];
    let line = before.split(|&byte| byte == b'\n').count();
    let column = before.rsplit(|&byte| byte == b'\n').next().map_or(0, <[u8]>::len) + 1;
    Diagnostic::error(Code::NotUtf8, format!("{path}:{line}:{column}: the file is not UTF-8"))
        .help("save it again from the editor with the encoding UTF-8")
}

fn unreadable(path: &str, error: &io::Error) -> Diagnostic {
    Diagnostic::error(Code::Unreadable, format!("`{path}` cannot be read: {error}"))
        .help("check the file's permissions and the disk")
}

fn left_out(path: &str) -> Diagnostic {
    let message = format!("`{path}` is left out: it is a link that leads out of the course, to itself, or nowhere");
    Diagnostic::warning(Code::Unreadable, message)
        .help("put the file itself there, or a link to another file of the course")
}

#[cfg(test)]
mod tests {
    use super::chapter_stem;

    #[test]
    fn only_markdown_directly_in_the_chapters_folder_is_a_chapter() {
        assert_eq!(chapter_stem("chapters/01-history.md"), Some("01-history"));
        assert_eq!(chapter_stem("chapters/notes/draft.md"), None);
        assert_eq!(chapter_stem("chapters/workbook.toml"), None);
        assert_eq!(chapter_stem("templates/01-history.md"), None);
    }
}
