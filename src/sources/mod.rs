//! The code that computes: digests of the sources that the library was compiled from, for the keys of results.
//!
//! A catalogue's entry (a sampler, a scramble, an integrand, a kind) counts only for the experiments that use it. What all entries share
//! is one digest, the engine's; so are the locked dependencies. What only draws, parses or renders counts for nothing.
//!
//! The build script reads the sources into a [`Table`] with the very code that is here; a test reads them again and compares.

mod analysis;
mod digest;
mod item;
mod json;
mod lex;
mod table;
mod uses;

pub use analysis::Sources;
pub use digest::Digest;
pub use item::{Item, item, items};
pub use table::{Code, Table, Unit};

/// The sources that were compiled, and the digests of them and of the locked dependencies.
mod embedded {
    use super::{Code, Digest, Table, Unit};
    use std::borrow::Cow::Borrowed;

    include!(concat!(env!("OUT_DIR"), "/sources.rs"));
    include!(concat!(env!("OUT_DIR"), "/digests.rs"));
}

/// The text of the source file `path` (from `src`, e.g. `samplers/halton.rs`), as it was compiled.
pub fn text(path: &str) -> Option<&'static str> {
    let at = embedded::FILES.binary_search_by(|(file, _)| (*file).cmp(path)).ok()?;
    std::str::from_utf8(embedded::FILES.get(at)?.1).ok()
}

/// The locked version of the package `name`, if it is known: the newest if there are several.
pub fn locked(name: &str) -> Option<&'static str> {
    version(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.lock")), name)
}

/// The version of the package `name` in the text of a `Cargo.lock`.
fn version<'l>(locked: &'l str, name: &str) -> Option<&'l str> {
    let field = |stanza: &'l str, field: &str| {
        stanza.lines().find_map(|line| line.strip_prefix(field)?.strip_prefix(" = \"")?.strip_suffix('"'))
    };
    // Stanzas of one package are sorted by version.
    let stanzas = locked.split("[[package]]").filter(|stanza| field(stanza, "name") == Some(name));
    field(stanzas.last()?, "version")
}

/// The digests of the sources that this library was compiled from.
pub fn sources() -> &'static Table<'static> {
    &embedded::DIGESTS
}

/// The digest of everything that this program is made of: sources, templates, locked dependencies.
pub fn program() -> Digest {
    embedded::PROGRAM
}

#[cfg(test)]
mod tests;
