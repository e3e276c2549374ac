//! Files that are new: written only where nothing is, and all of them or none.

use std::fs::{self, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic};

/// Writes `files`, by their paths from `root`; refused if any of them is there already, and undone if one cannot be written.
pub fn create(root: &Path, files: &[(String, Vec<u8>)]) -> Result<(), Diagnostic> {
    let there: Vec<&str> =
        files.iter().map(|(path, _)| path.as_str()).filter(|path| root.join(path).symlink_metadata().is_ok()).collect();
    if !there.is_empty() {
        return Err(exists(root, &there));
    }
    let mut made = Made::default();
    for (path, bytes) in files {
        if let Err(error) = made.file(&root.join(path), bytes) {
            made.undo();
            return Err(match error.kind() {
                io::ErrorKind::AlreadyExists => exists(root, &[path]),
                _ => Diagnostic::error(
                    Code::Unwritable,
                    format!("`{}` cannot be written: {error}", root.join(path).display()),
                )
                .help("nothing was changed; check the disk's space and the folder's permissions"),
            });
        }
    }
    Ok(())
}

/// Replaces the text of a file in one step.
pub fn replace(path: &Path, text: &str) -> Result<(), Diagnostic> {
    let staged = path.with_extension(format!("staged-{}", std::process::id()));
    let written = fs::write(&staged, text).and_then(|()| fs::rename(&staged, path));
    written.map_err(|error| {
        let _ = fs::remove_file(&staged);
        Diagnostic::error(Code::Unwritable, format!("`{}` cannot be written: {error}", path.display()))
    })
}

/// Removes a file that was written just now, since what belongs to it could not be.
pub fn take_back(path: &Path) {
    let _ = fs::remove_file(path);
}

fn exists(root: &Path, paths: &[&str]) -> Diagnostic {
    let names = paths.iter().map(|path| format!("`{path}`")).collect::<Vec<_>>().join(", ");
    let verb = if paths.len() == 1 { "is" } else { "are" };
    let root = if root.as_os_str().is_empty() { Path::new(".") } else { root };
    Diagnostic::error(Code::Exists, format!("{names} {verb} in `{}` already", root.display()))
        .help("nothing was written: files that are there are never replaced")
}

/// The files and folders that were made, in their order.
#[derive(Default)]
struct Made {
    paths: Vec<PathBuf>,
}

impl Made {
    fn file(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let folders: Vec<&Path> =
            path.ancestors().skip(1).take_while(|folder| !folder.as_os_str().is_empty()).collect();
        for folder in folders.into_iter().rev().filter(|folder| !folder.is_dir()) {
            if folder.symlink_metadata().is_ok() {
                return Err(io::Error::new(
                    io::ErrorKind::NotADirectory,
                    format!("`{}` is no folder", folder.display()),
                ));
            }
            fs::create_dir(folder)?;
            self.paths.push(folder.to_owned());
        }
        let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
        self.paths.push(path.to_owned());
        file.write_all(bytes)
    }

    /// Removes what was made; folders only where nothing else has come into them.
    fn undo(self) {
        for path in self.paths.into_iter().rev() {
            let _ = if path.is_dir() { fs::remove_dir(&path) } else { fs::remove_file(&path) };
        }
    }
}
