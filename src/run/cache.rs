//! The cache: results kept on disk, each at the address that its key gives.
//!
//! Nothing in the cache is trusted: an entry that is not whole, or not of the very key that was asked for, counts as absent.
//! An entry is written beside its place and then moved there, so that builds at the same time cannot harm each other.

use std::collections::BTreeSet;
use std::fs::{self, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};

use super::key::{FORMAT, Key};
use crate::sources::Digest;

/// What every entry begins with.
const MAGIC: &[u8; 16] = b"workbook result\n";
/// The magic, the format, the two lengths and the checksum.
const HEADER: usize = 16 + 4 + 8 + 8 + 32;

/// A folder that keeps results.
#[derive(Debug, Clone)]
pub struct Cache {
    folder: PathBuf,
}

/// What the cache has for a key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// The bytes of the result.
    Whole(Vec<u8>),
    /// Something that cannot be trusted.
    Damaged,
    /// Nothing.
    Absent,
}

/// An entry as the folder shows it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Entry {
    /// The digest of its key.
    pub key: Digest,
    /// Its size in bytes.
    pub size: u64,
}

/// The key with which an exhibit was last made.
#[derive(Serialize, Deserialize)]
struct Latest {
    id: String,
    key: Key,
}

impl Cache {
    /// The cache in `folder`, which is made when the first result is kept.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// The result that is kept for `key`.
    pub fn read(&self, key: &Key) -> Found {
        let file = self.result(key.digest());
        match fs::read(&file) {
            Ok(bytes) => {
                decode(&bytes, &key.canonical()).map_or(Found::Damaged, |result| Found::Whole(result.to_vec()))
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => Found::Absent,
            Err(_) => Found::Damaged,
        }
    }

    /// Keeps `result` for `key`, in place of what was there.
    pub fn write(&self, key: &Key, result: &[u8]) -> io::Result<()> {
        replace(&self.result(key.digest()), &encode(&key.canonical(), result))
    }

    /// The key with which the exhibit `id` was last made, as far as the cache knows.
    pub fn latest(&self, id: &str) -> Option<Key> {
        let latest: Latest = serde_json::from_slice(&fs::read(self.latest_file(id)).ok()?).ok()?;
        (latest.id == id).then_some(latest.key)
    }

    /// Notes that the exhibit `id` was made with `key`.
    pub fn note(&self, id: &str, key: &Key) -> io::Result<()> {
        let text = serde_json::to_vec_pretty(&Latest { id: id.to_owned(), key: key.clone() })?;
        let file = self.latest_file(id);
        if fs::read(&file).is_ok_and(|old| old == text) { Ok(()) } else { replace(&file, &text) }
    }

    /// Every entry, sorted.
    pub fn entries(&self) -> Vec<Entry> {
        let mut found: Vec<Entry> = files(&self.folder.join("results"))
            .filter_map(|file| {
                let key = Digest::parse(file.file_name().to_str()?)?;
                Some(Entry { key, size: file.metadata().ok()?.len() })
            })
            .collect();
        found.sort();
        found
    }

    /// The entries that no key of `live` asks for, sorted.
    pub fn stale(&self, live: &BTreeSet<Digest>) -> Vec<Entry> {
        self.entries().into_iter().filter(|entry| !live.contains(&entry.key)).collect()
    }

    /// The size of all entries, in bytes.
    pub fn size(&self) -> u64 {
        self.entries().iter().map(|entry| entry.size).sum()
    }

    /// Removes `entries`; one that is gone already is no error.
    pub fn remove(&self, entries: &[Entry]) -> io::Result<()> {
        entries.iter().try_for_each(|entry| gone(fs::remove_file(self.result(entry.key))))
    }

    /// Removes everything that the cache has written, left-overs of builds that were killed included, and nothing else.
    pub fn clean(&self) -> io::Result<()> {
        for folder in ["results", "latest"] {
            gone(fs::remove_dir_all(self.folder.join(folder)))?;
        }
        // It stays if something else is in it.
        let _ = fs::remove_dir(&self.folder);
        Ok(())
    }

    fn result(&self, key: Digest) -> PathBuf {
        self.folder.join("results").join(key.to_string())
    }

    fn latest_file(&self, id: &str) -> PathBuf {
        let plain = id.len() <= 100
            && id.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-');
        let name = if plain && !id.is_empty() { id.to_owned() } else { format!("_{}", Digest::of(id.as_bytes())) };
        self.folder.join("latest").join(format!("{name}.json"))
    }
}

/// The files of a folder; none if it cannot be read.
fn files(folder: &Path) -> impl Iterator<Item = fs::DirEntry> {
    fs::read_dir(folder).into_iter().flatten().flatten()
}

/// Success if the thing to remove was not there.
fn gone(result: io::Result<()>) -> io::Result<()> {
    match result {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        other => other,
    }
}

/// What stands before the key and the result of an entry.
fn header(key: &str, result: &[u8]) -> [u8; HEADER] {
    let mut bytes = [0; HEADER];
    let checksum = Digest::of(result);
    let parts: [&[u8]; 5] = [
        MAGIC,
        &FORMAT.to_le_bytes(),
        &(key.len() as u64).to_le_bytes(),
        &(result.len() as u64).to_le_bytes(),
        checksum.bytes(),
    ];
    for (byte, from) in bytes.iter_mut().zip(parts.into_iter().flatten()) {
        *byte = *from;
    }
    bytes
}

/// An entry: the header, the key as JSON, the result.
fn encode(key: &str, result: &[u8]) -> Vec<u8> {
    [&header(key, result), key.as_bytes(), result].concat()
}

/// The result in an entry, if the entry is whole and of `key`.
fn decode<'a>(bytes: &'a [u8], key: &str) -> Option<&'a [u8]> {
    let (head, rest) = bytes.split_at_checked(HEADER)?;
    let result = rest.strip_prefix(key.as_bytes())?;
    (head == header(key, result)).then_some(result)
}

/// Writes `bytes` to a file of its own beside `file`, then moves it there in one step.
fn replace(file: &Path, bytes: &[u8]) -> io::Result<()> {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let folder = file.parent().ok_or_else(|| io::Error::other("the cache has no folder"))?;
    fs::create_dir_all(folder)?;
    loop {
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let beside = folder.join(format!(".{}-{number}.part", std::process::id()));
        // Another process may have the same number, in another container: then the next name is tried.
        let mut open = match OpenOptions::new().write(true).create_new(true).open(&beside) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
            opened => opened?,
        };
        let moved = open.write_all(bytes).and_then(|()| {
            drop(open);
            fs::rename(&beside, file)
        });
        if moved.is_err() {
            let _ = fs::remove_file(&beside);
        }
        return moved;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_is_read_only_whole() {
        let bytes = encode("{\"key\":1}", b"result");
        assert_eq!(decode(&bytes, "{\"key\":1}"), Some(&b"result"[..]));
        assert_eq!(decode(&bytes, "{\"key\":2}"), None);
        for length in 0..bytes.len() {
            assert_eq!(decode(&bytes[..length], "{\"key\":1}"), None, "cut at {length}");
        }
        for at in 0..bytes.len() {
            for bit in 0..8 {
                let mut wrong = bytes.clone();
                wrong[at] ^= 1 << bit;
                assert_eq!(decode(&wrong, "{\"key\":1}"), None, "bit {bit} of byte {at}");
            }
        }
        let mut longer = bytes;
        longer.push(0);
        assert_eq!(decode(&longer, "{\"key\":1}"), None);
    }
}
