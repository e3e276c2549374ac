//! A course as git has it at a revision, in a temporary folder; the repository and what is checked out are left as they are.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The files of a revision, which are removed when this is dropped.
#[derive(Debug)]
pub struct Checkout {
    folder: PathBuf,
}

impl Checkout {
    /// Writes the course at `root` as it was at `revision` into a new folder in `temporary`. The error is what git says.
    ///
    /// Git writes from its objects with an index of its own, so that nothing of the repository changes, and nothing is left there.
    pub fn of(root: &Path, revision: &str, temporary: &Path) -> Result<Self, String> {
        let top = git(root, None, &["rev-parse", "--show-toplevel"])?;
        let below = git(root, None, &["rev-parse", "--show-prefix"])?;
        let commit = format!("{revision}^{{commit}}");
        let commit = git(root, None, &["rev-parse", "--verify", "--end-of-options", &commit])?;
        let name = format!("workbook-revision-{}-{}", std::process::id(), &commit[..commit.len().min(12)]);
        let folder = temporary.join(name);
        fs::create_dir_all(temporary).and_then(|()| fs::create_dir(&folder)).map_err(|error| error.to_string())?;
        let checkout = Self { folder };
        let index = checkout.folder.join("index");
        let tree = if below.is_empty() { format!("{commit}^{{tree}}") } else { format!("{commit}:{below}") };
        let top = Path::new(&top);
        git(top, Some(&index), &["read-tree", tree.trim_end_matches('/')])?;
        let prefix = format!("--prefix={}/", checkout.root().display());
        git(top, Some(&index), &["checkout-index", "--all", "--quiet", &prefix])?;
        Ok(checkout)
    }

    /// The course's folder.
    pub fn root(&self) -> PathBuf {
        self.folder.join("course")
    }
}

impl Drop for Checkout {
    fn drop(&mut self) {
        // What is left in a temporary folder does no harm.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// What git answers, with an index of its own if one is named.
fn git(folder: &Path, index: Option<&Path>, arguments: &[&str]) -> Result<String, String> {
    let mut command = Command::new("git");
    command.arg("-C").arg(folder).arg("--no-optional-locks").args(arguments).stdin(Stdio::null());
    if let Some(index) = index {
        command.env("GIT_INDEX_FILE", OsStr::new(index));
    }
    let output = command.output().map_err(|error| format!("git cannot be started: {error}"))?;
    if output.status.success() {
        let text = String::from_utf8(output.stdout).map_err(|error| error.to_string())?;
        return Ok(text.trim_end_matches(['\n', '\r']).to_owned());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(said.lines().next().unwrap_or("it said nothing").to_owned())
}
