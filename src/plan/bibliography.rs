//! The bibliography: the works that chapters can cite, read from a BibLaTeX file.

use hayagriva::io::{BibLaTeXError, from_biblatex_str};
use hayagriva::{Entry, Library};

use crate::diag::{Code, Diagnostic};
use crate::parse::Course;
use crate::workspace::Workspace;

/// The works that chapters can cite.
#[derive(Debug, Default)]
pub struct Bibliography {
    library: Library,
    /// Whether it could not be read.
    broken: bool,
}

impl Bibliography {
    /// Whether every work of it is known: it was read, or the course has none.
    pub fn is_whole(&self) -> bool {
        !self.broken
    }

    /// Whether it has a work with this key.
    pub fn contains(&self, key: &str) -> bool {
        self.library.get(key).is_some()
    }

    /// The work with this key.
    pub fn get(&self, key: &str) -> Option<&Entry> {
        self.library.get(key)
    }

    /// The keys of all works, in the order of the file.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.library.keys()
    }
}

/// Reads the course's bibliography; what is wrong in it is told.
pub(super) fn read(course: &Course, workspace: &Workspace, diagnostics: &mut Vec<Diagnostic>) -> Bibliography {
    let Some(path) = &course.configuration.bibliography else { return Bibliography::default() };
    // A file that is not there has been told already.
    let Some(source) = workspace.text(path) else { return Bibliography { broken: true, ..Bibliography::default() } };
    match from_biblatex_str(&source.text) {
        Ok(library) => Bibliography { library, broken: false },
        Err(errors) => {
            for error in errors {
                let (range, message) = match error {
                    BibLaTeXError::Parse(error) => (error.span, error.kind.to_string()),
                    BibLaTeXError::Type(error) => (error.span, error.kind.to_string()),
                };
                let message = format!("the bibliography cannot be read: {message}");
                diagnostics.push(Diagnostic::error(Code::Bibliography, message).at(&source.path, range));
            }
            Bibliography { broken: true, ..Bibliography::default() }
        }
    }
}
