//! The writer: the book's folder is replaced whole or not at all.

pub mod fresh;

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic};
use crate::render::{Book, FIGURES};
use crate::workspace::LOCK;

/// What writing did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The folder was replaced.
    Written,
    /// The folder held the book already, byte for byte; nothing was touched.
    Unchanged,
}

/// The lock's name in its folder.
const LOCK_NAME: &str = "workbook.lock";

/// Makes `out` hold exactly `book`, and the lock if it was there.
///
/// The new book is written beside the old one and the two change places in one step, so that whatever happens a whole book
/// is in place. A folder that holds anything but a book is refused.
pub fn write(book: &Book, out: &Path) -> Result<Outcome, Diagnostic> {
    let lock = fs::read(out.join(LOCK_NAME)).ok();
    if !is_book_or_free(out) {
        return Err(Diagnostic::error(
            Code::NotABook,
            format!("`{}` holds files that are no book of this tool", out.display()),
        )
        .help("name another folder with `--out DIR`, or empty this one: building replaces it whole"));
    }
    if holds(out, book) {
        return Ok(Outcome::Unchanged);
    }
    let failed = |error: io::Error| {
        Diagnostic::error(Code::Unwritable, format!("the book cannot be written to `{}`: {error}", out.display()))
            .help("the last good book is untouched; check the disk's space and the folder's permissions")
    };
    let staging = Staging::create(out).map_err(failed)?;
    for (path, bytes) in &book.files {
        write_file(&staging.path.join(path), bytes).map_err(failed)?;
    }
    if let Some(lock) = &lock {
        write_file(&staging.path.join(LOCK_NAME), lock).map_err(failed)?;
    }
    exchange(&staging.path, out).map_err(failed)?;
    keep_newer_lock(&staging.path, out, lock.as_deref()).map_err(failed)?;
    Ok(Outcome::Written)
}

/// The same for students, who must not get the lock: it has the values of solutions. A folder that holds one is refused.
pub fn without_lock(book: &Book, out: &Path) -> Result<Outcome, Diagnostic> {
    if out.join(LOCK_NAME).exists() {
        let message = format!("`{}` holds the lock, which has the values of solutions", out.display());
        let error = Diagnostic::error(Code::NotABook, message);
        return Err(error.help("name another folder for the students' book with `--out DIR`"));
    }
    write(book, out)
}

/// The committed lock's path in a course.
pub fn lock_path(root: &Path) -> PathBuf {
    root.join(LOCK)
}

/// Replaces the lock in one step.
pub fn write_lock(root: &Path, text: &str) -> Result<(), Diagnostic> {
    let path = lock_path(root);
    let write = || -> io::Result<()> {
        fs::create_dir_all(path.parent().unwrap_or(root))?;
        let staged = path.with_extension(format!("lock.{}", std::process::id()));
        fs::write(&staged, text)?;
        fs::rename(&staged, &path)
    };
    write().map_err(|error| {
        Diagnostic::error(Code::Unwritable, format!("the lock cannot be written to `{}`: {error}", path.display()))
    })
}

/// A folder beside the book that is removed however the writing ends: the half-written book, or the one that was replaced.
struct Staging {
    path: PathBuf,
}

impl Staging {
    fn create(out: &Path) -> io::Result<Self> {
        let name = out.file_name().map_or_else(|| "book".into(), |name| name.to_string_lossy().into_owned());
        let parent = out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::create_dir_all(parent)?;
        remove_abandoned(parent, &name);
        let path = parent.join(format!(".{name}.staging-{}", std::process::id()));
        if path.exists() {
            fs::remove_dir_all(&path)?;
        }
        fs::create_dir(&path)?;
        Ok(Self { path })
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // Nothing is lost if this fails: the next build removes what was left.
        let _ = fs::remove_dir_all(&self.path);
    }
}

/// Removes what builds that were killed have left, if their process is gone.
fn remove_abandoned(parent: &Path, name: &str) {
    let prefix = format!(".{name}.staging-");
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let file = entry.file_name().to_string_lossy().into_owned();
        let Some(process) = file.strip_prefix(&prefix) else { continue };
        if !Path::new("/proc").join(process).exists() || cfg!(not(target_os = "linux")) {
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent)?;
    }
    fs::write(path, bytes)
}

/// Puts `staged` in the place of `out`, and what was there in the place of `staged`.
fn exchange(staged: &Path, out: &Path) -> io::Result<()> {
    if !out.exists() {
        match fs::rename(staged, out) {
            // Another build was faster; its book is the one to change places with.
            Err(_) if out.exists() => {}
            done => return done,
        }
    }
    #[cfg(any(target_os = "linux", target_os = "macos"))]
    {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        if renameat_with(CWD, staged, CWD, out, RenameFlags::EXCHANGE).is_ok() {
            return Ok(());
        }
    }
    // Where the file system cannot exchange two folders, the old one steps aside for a moment and comes back on failure.
    let aside = staged.with_extension("old");
    fs::rename(out, &aside)?;
    if let Err(error) = fs::rename(staged, out) {
        fs::rename(&aside, out)?;
        return Err(error);
    }
    fs::rename(&aside, staged)
}

/// Moves the lock of the `old` book to `out` if it was written while the new book was: accepting at the same time is not undone.
fn keep_newer_lock(old: &Path, out: &Path, copied: Option<&[u8]>) -> io::Result<()> {
    match fs::read(old.join(LOCK_NAME)) {
        Ok(lock) if Some(lock.as_slice()) != copied => fs::rename(old.join(LOCK_NAME), out.join(LOCK_NAME)),
        _ => Ok(()),
    }
}

/// Whether `out` can be replaced: it is not there, it is empty, it holds a book, or nothing but the lock.
fn is_book_or_free(out: &Path) -> bool {
    let Ok(entries) = fs::read_dir(out) else { return !out.exists() };
    let names: Vec<String> = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.iter().all(|name| name == LOCK_NAME) || names.iter().any(|name| name == FIGURES)
}

/// Whether `out` holds exactly the files of `book`, besides the lock.
fn holds(out: &Path, book: &Book) -> bool {
    let same = |(name, path): (&String, &PathBuf)| {
        book.files.get(name).is_some_and(|bytes| fs::read(path).is_ok_and(|old| old == *bytes))
    };
    paths(out).is_some_and(|paths| paths.len() == book.files.len() && paths.iter().all(same))
}

/// What the folder `out` holds besides the lock, by its path there; none if it cannot be read.
pub fn contents(out: &Path) -> Option<BTreeMap<String, Vec<u8>>> {
    paths(out)?.into_iter().map(|(name, path)| Some((name, fs::read(path).ok()?))).collect()
}

/// The files below `out` besides the lock, by their paths there with `/` between folders; none if it cannot be read.
fn paths(out: &Path) -> Option<BTreeMap<String, PathBuf>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![out.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).ok()? {
            let entry = entry.ok()?;
            let path = entry.path();
            if entry.file_type().ok()?.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(out).ok()?.to_str()?.replace(std::path::MAIN_SEPARATOR, "/");
            if name != LOCK_NAME {
                files.insert(name, path);
            }
        }
    }
    Some(files)
}
