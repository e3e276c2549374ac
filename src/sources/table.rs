//! What a program keeps of the sources that it was compiled from: the digests that keys are made of.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use super::digest::Digest;

/// The digests of all code that computes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table<'a> {
    /// The digest of all code that computes and is not an entry's own.
    pub engine: Digest,
    /// The digest of the locked dependencies.
    pub dependencies: Digest,
    /// The code that counts only where it is used.
    pub units: Cow<'a, [Unit<'a>]>,
    /// Every file, in order, and where its code counts.
    pub files: Cow<'a, [(&'a str, Code)]>,
}

/// The code of an entry of a catalogue, or of a module beside them that uses some.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit<'a> {
    /// Its first file, which names it.
    pub file: &'a str,
    /// The digest of its files.
    pub digest: Digest,
    /// Whether a catalogue lists it.
    pub listed: bool,
    /// The units that it uses directly.
    pub uses: Cow<'a, [usize]>,
}

/// Where the code of a file counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Code {
    /// Where this unit is used.
    Unit(usize),
    /// Everywhere, as part of the engine, or nowhere; with the digest of what computes in it.
    Shared(Digest),
}

impl Table<'_> {
    /// The files of the catalogues' entries, in order.
    pub fn entries(&self) -> impl Iterator<Item = &str> {
        self.units.iter().filter(|unit| unit.listed).map(|unit| unit.file)
    }

    /// The digests of the entries that `files` define and of all that these use, directly or not, by file.
    pub fn code<'f>(&self, files: impl IntoIterator<Item = &'f str>) -> BTreeMap<String, Digest> {
        let mut digests = BTreeMap::new();
        let mut due = BTreeSet::new();
        for file in files {
            match self.files.binary_search_by(|(name, _)| (*name).cmp(file)).map(|at| self.files[at].1) {
                Ok(Code::Unit(unit)) => drop(due.insert(unit)),
                // Covered by the engine's digest as well; named here so that the key says so.
                Ok(Code::Shared(digest)) => drop(digests.insert(file.to_owned(), digest)),
                Err(_) => drop(digests.insert(file.to_owned(), Digest::of(&[]))),
            }
        }
        let mut seen = BTreeSet::new();
        while let Some(at) = due.pop_first() {
            let Some(unit) = self.units.get(at).filter(|_| seen.insert(at)) else { continue };
            digests.insert(unit.file.to_owned(), unit.digest);
            due.extend(unit.uses.iter());
        }
        digests
    }
}
