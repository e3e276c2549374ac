//! Catalogues: what every sampler, scramble, integrand and experiment kind tells about itself, and how it is found by name.
//!
//! A catalogue is a slice of references to entries in its folder's `mod.rs`; its order is the order of display.

/// What an entry of a catalogue tells about itself. The book prints it, and the key of a result hashes its `source`.
#[derive(Debug)]
pub struct About {
    /// The name that chapters and the command line use, e.g. `halton`; unique in its catalogue.
    pub key: &'static str,
    /// The name as prose uses it, e.g. `Halton sequence`.
    pub title: &'static str,
    /// One sentence for lists and help.
    pub summary: &'static str,
    /// The file that defines the entry, from the folder `src`, e.g. `samplers/halton.rs`.
    pub file: &'static str,
    /// The text of that file, as it was compiled.
    pub source: &'static str,
    /// Where the method comes from; never empty for a method of the mathematics.
    pub papers: &'static [Paper],
}

/// A primary source.
#[derive(Debug)]
pub struct Paper {
    /// Authors, as printed: `J. H. Halton`.
    pub authors: &'static str,
    /// Year of publication.
    pub year: u16,
    /// Title of the work.
    pub title: &'static str,
    /// Journal with volume and pages, or book and publisher.
    pub venue: &'static str,
    /// The DOI without a resolver, where there is one.
    pub doi: Option<&'static str>,
}

/// A member of a catalogue.
pub trait Entry {
    /// What the entry tells about itself.
    fn about(&self) -> &'static About;
}

/// The entry of `catalogue` whose key is `key`.
pub fn find<E: Entry + ?Sized>(catalogue: &[&'static E], key: &str) -> Option<&'static E> {
    catalogue.iter().copied().find(|entry| entry.about().key == key)
}

/// The name among `names` that a slip of the pen most likely meant by `written`, if any is near enough to offer.
pub fn nearest<'a>(written: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let (score, name) = names
        .into_iter()
        .map(|name| (likeness(&written.to_lowercase(), &name.to_lowercase()), name))
        .max_by(|a, b| a.0.total_cmp(&b.0))?;
    (score >= 0.75).then_some(name)
}

/// How alike two names are, at most 1. One slip in a short name is one slip, however large a part of the name it is.
fn likeness(written: &str, name: &str) -> f64 {
    let alike = strsim::jaro_winkler(written, name);
    let slip = written.len() > 2 && strsim::osa_distance(written, name) == 1;
    if slip { alike.max(0.9) } else { alike }
}
