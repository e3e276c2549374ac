//! Watching a course: a word whenever something that a build reads may have changed.
//!
//! Folders are watched, not files, since many editors save by putting a new file in the place of the old one. A folder that is moved away
//! and another that comes in its place are found by looking now and then.

use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

use notify::event::{EventKind, MetadataKind, ModifyKind};
use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};

use super::{CHAPTERS, TEMPLATES};

/// The folders whose files a build reads.
const FOLDERS: [&str; 2] = [CHAPTERS, TEMPLATES];

/// Watches the folders of a course.
pub struct Watch {
    root: PathBuf,
    watcher: Option<RecommendedWatcher>,
    /// The folders that are watched, and what is known of each: the folder itself cannot be told by its path.
    watched: Vec<(PathBuf, Option<Identity>)>,
}

/// What tells a folder from another in its place.
type Identity = (u64, u64);

impl Watch {
    /// Watches the course at `root`, and calls `tell` whenever something may have changed. Where the system gives no watcher, it is
    /// [`Watch::blind`].
    pub fn new(root: &Path, tell: impl Fn() + Send + 'static) -> Self {
        let root = root.to_path_buf();
        let from = whole(&root);
        let watcher = notify::recommended_watcher(move |event: notify::Result<Event>| {
            // What cannot be told from a change counts as one.
            if event.map_or(true, |event| concerns(&event, &from)) {
                tell();
            }
        });
        let mut watch = Self { root, watcher: watcher.ok(), watched: Vec::new() };
        watch.look();
        watch
    }

    /// Whether changes are not told, so that whoever waits for them has to look.
    pub fn blind(&self) -> bool {
        self.watcher.is_none()
    }

    /// Looks whether the folders are still those that are watched, and watches those that are there now. Says whether anything had changed.
    pub fn look(&mut self) -> bool {
        // The folder that a program is in may get another name.
        let root = whole(&self.root);
        let paths = FOLDERS.map(|folder| root.join(folder));
        let paths = [root].into_iter().chain(paths);
        let now: Vec<(PathBuf, Option<Identity>)> = paths.map(|path| (path.clone(), identity(&path))).collect();
        if now == self.watched {
            return false;
        }
        let Some(watcher) = &mut self.watcher else {
            self.watched = now;
            return true;
        };
        let mut failed = false;
        for (path, _) in self.watched.drain(..) {
            // What is gone is watched no more.
            let _ = watcher.unwatch(&path);
        }
        for (at, (path, identity)) in now.iter().enumerate() {
            let mode = if at == 0 { RecursiveMode::NonRecursive } else { RecursiveMode::Recursive };
            failed |= identity.is_some() && watcher.watch(path, mode).is_err() && path.exists();
        }
        self.watched = now;
        if failed {
            // The system has no more watches to give.
            self.watcher = None;
        }
        true
    }
}

/// A path from the root of all, if there is something.
fn whole(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_path_buf())
}

/// Whether an event is about something that a build reads.
fn concerns(event: &Event, root: &Path) -> bool {
    let reading = match event.kind {
        EventKind::Access(access) => {
            !matches!(access, notify::event::AccessKind::Close(notify::event::AccessMode::Write))
        }
        EventKind::Modify(ModifyKind::Metadata(MetadataKind::AccessTime)) => true,
        _ => false,
    };
    !reading && (event.need_rescan() || event.paths.is_empty() || event.paths.iter().any(|path| is_read(path, root)))
}

/// Whether a build reads what is at `path`: it lies in one of the folders, and is not hidden.
fn is_read(path: &Path, root: &Path) -> bool {
    let Ok(below) = path.strip_prefix(root) else { return true };
    let mut names = below.components().filter_map(|part| match part {
        Component::Normal(name) => Some(name),
        _ => None,
    });
    let Some(folder) = names.next() else { return true };
    let hidden = |name: &OsStr| name.to_string_lossy().starts_with('.');
    FOLDERS.iter().any(|known| folder == *known) && !names.any(hidden)
}

/// What tells the folder at `path` from others.
#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt as _;
    let found = path.metadata().ok().filter(std::fs::Metadata::is_dir)?;
    Some((found.dev(), found.ino()))
}

/// What tells the folder at `path` from others.
#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    let found = path.metadata().ok().filter(std::fs::Metadata::is_dir)?;
    let created = found.created().ok()?.duration_since(std::time::UNIX_EPOCH).ok()?;
    Some((created.as_secs(), u64::from(created.subsec_nanos())))
}

#[cfg(test)]
mod tests {
    use super::is_read;
    use std::path::Path;

    #[test]
    fn only_what_a_build_reads_counts() {
        let read = |path: &str| is_read(Path::new(path), Path::new("course"));
        assert!(read("course") && read("course/chapters") && read("course/chapters/a/b.csv"));
        assert!(read("course/templates/assets/style.css"));
        for other in ["book/index.html", ".workbook/cache/results/x", "chapters/.01.md.swp", "README.md", "chapters2/a"]
        {
            assert!(!read(&format!("course/{other}")), "{other}");
        }
    }
}
