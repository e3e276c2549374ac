//! The receipt of the last build: what the book was made of and what came of it, so that a build that would change nothing is not repeated.
//!
//! A receipt is worth nothing by itself. It counts only if it is whole, if program, course and lock are byte for byte those that
//! it was written for, and if the book's folder holds byte for byte what was written then.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::diag::Diagnostic;
use crate::parse::Audience;
use crate::render::Book;
use crate::sources::{self, Digest};
use crate::workspace::{LOCK, Workspace};
use crate::write;

/// What is known of a build that went well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Receipt {
    inputs: String,
    book: String,
    /// How much there was.
    pub counts: Counts,
    /// What was said of it; there is no error among it.
    pub diagnostics: Vec<Diagnostic>,
}

/// How much a book has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// Chapters, appendices among them.
    pub chapters: usize,
    /// Figures, tables and steppers.
    pub exhibits: usize,
    /// Distinct experiments.
    pub experiments: usize,
    /// Claims that were verified.
    pub claims: usize,
}

impl Receipt {
    /// The receipt for `book`, made of what has the digest `inputs`.
    pub fn new(inputs: Digest, book: &Book, counts: Counts, diagnostics: Vec<Diagnostic>) -> Self {
        let files = book.files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice()));
        Self { inputs: inputs.to_string(), book: contents(files).to_string(), counts, diagnostics }
    }

    /// The receipt that the course at `root` has for what has the digest `inputs`, if the folder `out` holds that very book.
    pub fn find(root: &Path, inputs: Digest, out: &Path) -> Option<Self> {
        let text = fs::read_to_string(path(root)).ok()?;
        let (digest, json) = text.split_once('\n')?;
        if digest != Digest::of(json.as_bytes()).to_string() {
            return None;
        }
        let receipt: Self = serde_json::from_str(json).ok()?;
        if receipt.inputs != inputs.to_string() {
            return None;
        }
        let files = write::contents(out)?;
        let files = files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice()));
        (receipt.book == contents(files).to_string()).then_some(receipt)
    }

    /// Keeps the receipt. One that cannot be kept is no loss: then the next build does its work.
    pub fn keep(&self, root: &Path) {
        let Ok(json) = serde_json::to_string(self) else { return };
        let path = path(root);
        let staged = path.with_extension(std::process::id().to_string());
        let text = format!("{}\n{json}", Digest::of(json.as_bytes()));
        let kept = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&staged, text));
        if kept.and_then(|()| fs::rename(&staged, path)).is_err() {
            let _ = fs::remove_file(staged);
        }
    }

    /// Forgets the last build.
    pub fn forget(root: &Path) {
        let _ = fs::remove_file(path(root));
    }
}

/// The digest of the files of a course, as they were read.
pub fn course(workspace: &Workspace) -> Digest {
    let texts = workspace.texts.iter().map(|(path, source)| (path, source.text.as_bytes()));
    let blobs = workspace.blobs.iter().map(|(path, bytes)| (path, &**bytes));
    Digest::of_parts(texts.chain(blobs).flat_map(|(path, bytes)| [path.as_bytes(), bytes]))
}

/// The digest of all that can change the book or what is said of it: the program, the [`course`], for whom the book is asked, the lock.
pub fn inputs(course: Digest, asked: Option<Audience>, root: &Path) -> Digest {
    let program = sources::program();
    let lock = fs::read(root.join(LOCK)).map(|lock| Digest::of(&lock)).ok();
    let lock = lock.as_ref().map_or(&b"none"[..], |digest| digest.bytes());
    let asked: &[u8] = match asked {
        None => b"as the course says",
        Some(Audience::Student) => b"student",
        Some(Audience::Instructor) => b"instructor",
    };
    Digest::of_parts([program.bytes(), course.bytes(), asked, lock])
}

/// The digest of files in the order of their paths.
fn contents<'a>(files: impl Iterator<Item = (&'a str, &'a [u8])>) -> Digest {
    let parts: Vec<[u8; 32]> =
        files.flat_map(|(path, bytes)| [*Digest::of(path.as_bytes()).bytes(), *Digest::of(bytes).bytes()]).collect();
    Digest::of_parts(parts.iter().map(<[u8; 32]>::as_slice))
}

fn path(root: &Path) -> PathBuf {
    root.join(".workbook").join("receipt")
}
