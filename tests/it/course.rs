//! Courses in folders of their own, and the program run on them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;
use workbook::compose::{Composed, Request, compose};
use workbook::run::How;

/// The folder of the package.
pub const PACKAGE: &str = env!("CARGO_MANIFEST_DIR");

/// A course that is gone when it is dropped.
pub struct Course {
    folder: TempDir,
}

/// What the program said and how it ended.
pub struct Said {
    /// How it ended.
    pub exit: i32,
    /// What was asked for.
    pub out: String,
    /// What people are told.
    pub err: String,
}

impl Course {
    /// A folder with nothing in it.
    pub fn empty() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    /// A course of these files, each with its path and its text.
    pub fn new(files: &[(&str, &str)]) -> Self {
        let course = Self::empty();
        for (path, text) in files {
            course.write(path, text);
        }
        course
    }

    /// A copy of the golden case `case`, without what is expected of it.
    pub fn case(case: &str) -> Self {
        let course = Self::empty();
        for (path, bytes) in tree(&Path::new(PACKAGE).join("tests/books").join(case)) {
            if !path.starts_with("expected") {
                course.write(&path, bytes);
            }
        }
        course
    }

    /// The course's folder.
    pub fn root(&self) -> &Path {
        self.folder.path()
    }

    /// A path in the course's folder.
    pub fn path(&self, path: &str) -> PathBuf {
        self.root().join(path)
    }

    /// Makes a file hold `text`.
    pub fn write(&self, path: &str, text: impl AsRef<[u8]>) {
        let path = self.path(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// The text of a file.
    pub fn read(&self, path: &str) -> String {
        fs::read_to_string(self.path(path)).unwrap()
    }

    /// Replaces the one place where `old` stands in a file.
    pub fn edit(&self, path: &str, old: &str, new: &str) {
        let text = self.read(path);
        assert_eq!(text.matches(old).count(), 1, "`{old}` in {path}");
        self.write(path, text.replace(old, new));
    }

    /// The book as the library makes it, on `threads` threads.
    pub fn compose(&self, threads: usize) -> Composed {
        compose(&Request { root: self.root().to_owned(), threads, cached: true, audience: None }, &())
    }

    /// The program with `arguments`, in the course's folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_workbook"));
        command.current_dir(self.root()).args(arguments).env_remove("RUST_BACKTRACE");
        command
    }

    /// What the program says to `arguments`, in the course's folder.
    pub fn say(&self, arguments: &[&str]) -> Said {
        Said::from(self.command(arguments).output().unwrap())
    }

    /// What the program says to `arguments`, which must end well.
    pub fn fine(&self, arguments: &[&str]) -> Said {
        let said = self.say(arguments);
        assert_eq!(said.exit, 0, "{arguments:?}: {}{}", said.out, said.err);
        said
    }

    /// The files of the book.
    pub fn book(&self) -> BTreeMap<String, Vec<u8>> {
        tree(&self.path("book"))
    }
}

impl Said {
    /// Fails if anything was said.
    pub fn silent(&self) {
        assert_eq!((self.out.as_str(), self.err.as_str()), ("", ""));
    }
}

impl From<Output> for Said {
    fn from(output: Output) -> Self {
        Self {
            exit: output.status.code().unwrap_or(-1),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

/// The configuration of [`small`].
const CONFIGURATION: &str = "title = \"A course\"\nauthors = [\"A. Author\"]\n";

/// The chapter of [`small`].
const CHAPTER: &str = r#"+++
title = "One"
summary = "The only chapter."
+++

Some prose.

```experiment
id = "fig-points"
kind = "points"
sampler = "jittered"
n = 16
caption = "Points."

[claims]
"cells.max.jittered" = { equals = 1 }
```

```experiment
id = "tbl-estimates"
kind = "estimate-table"
integrand = "x"
n = [4, 16]
caption = "Estimates."
```
"#;

/// A small course: a chapter with a sentence, a figure with a claim, and a table.
pub fn small() -> Course {
    Course::new(&[("chapters/workbook.toml", CONFIGURATION), ("chapters/01-one.md", CHAPTER)])
}

/// The small course, built and accepted.
pub fn accepted() -> Course {
    let course = small();
    course.fine(&["build", "--quiet"]);
    course.fine(&["accept", "--quiet"]);
    course
}

/// Every file below `folder` by its path there, with `/` between folders.
pub fn tree(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().to_str().unwrap().replace('\\', "/");
                files.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    files
}

/// The exhibits whose experiments were computed, sorted.
pub fn computed(composed: &Composed) -> Vec<&str> {
    let ran = composed.ran.iter().filter(|ran| ran.how != How::Cached);
    let mut ids: Vec<&str> = ran.flat_map(|ran| ran.ids.iter().map(String::as_str)).collect();
    ids.sort_unstable();
    ids
}
