//! The page on how the book was made: what was computed by which code, every exhibit with its provenance, every claim with its verdict.

use serde::Serialize;

use super::Rendering;
use super::exhibit::{self, Provenance};
use super::pages::{self, ChapterContext};
use crate::{chart, sources};

/// The packages that the numbers and the drawings depend on most, and what each is for.
const PACKAGES: [(&str, &str); 3] = [
    ("rand", "random number generators"),
    ("pxfm", "exponential, logarithm, sine and their kin, the same on every machine"),
    (chart::PACKAGE, "drawing"),
];

/// What is the page's own.
#[derive(Serialize)]
pub(super) struct Made<'a> {
    /// The digest of the code that all experiments share.
    engine: String,
    /// The digest of the locked dependencies.
    dependencies: String,
    packages: Vec<Package>,
    seed: u64,
    groups: Vec<Group<'a>>,
    /// The pages of the catalogue, where the provenance of their exhibits stands.
    pages: Vec<Counted<'a>>,
    exhibit_count: usize,
    claim_count: usize,
    /// How many claims hold; a book in which one does not is not built.
    held: usize,
}

/// A locked package.
#[derive(Serialize)]
struct Package {
    name: &'static str,
    version: &'static str,
    purpose: &'static str,
}

/// A page of the catalogue, and how much was made for it.
#[derive(Serialize)]
struct Counted<'a> {
    #[serde(flatten)]
    chapter: ChapterContext<'a>,
    exhibits: usize,
    claims: usize,
}

/// A chapter's part of the page.
#[derive(Serialize)]
struct Group<'a> {
    #[serde(flatten)]
    chapter: ChapterContext<'a>,
    exhibits: Vec<Provenance<'a>>,
    claims: usize,
}

/// All that the build knows of how it made the book.
pub(super) fn made<'a>(rendering: &'a Rendering<'a>) -> Made<'a> {
    let packages = PACKAGES.iter().filter_map(|&(name, purpose)| {
        let version = sources::locked(name)?;
        Some(Package { name, version, purpose })
    });
    let groups = pages::chapters(rendering, None).enumerate().map(|(number, chapter)| {
        let exhibits = (0..rendering.plan.exhibits.len()).filter(|&at| rendering.plan.exhibits[at].chapter == number);
        let exhibits: Vec<_> = exhibits.map(|index| exhibit::provenance(rendering, index)).collect();
        Group { chapter, claims: exhibits.iter().map(|exhibit| exhibit.verdicts).sum(), exhibits }
    });
    let members = rendering.course.chapters.iter().enumerate().filter(|(_, chapter)| chapter.member);
    let members = members.map(|(index, _)| {
        let own =
            || rendering.plan.exhibits.iter().zip(rendering.shown).filter(move |(exhibit, _)| exhibit.chapter == index);
        let claims = own().map(|(_, shown)| shown.verdicts.len()).sum();
        Counted { chapter: pages::line(rendering, index, false), exhibits: own().count(), claims }
    });
    let verdicts = || rendering.shown.iter().flat_map(|shown| &shown.verdicts);
    Made {
        engine: sources::sources().engine.to_string(),
        dependencies: sources::sources().dependencies.to_string(),
        packages: packages.collect(),
        seed: rendering.course.configuration.seed,
        groups: groups.filter(|group| !group.exhibits.is_empty()).collect(),
        pages: members.collect(),
        exhibit_count: rendering.shown.len(),
        claim_count: verdicts().count(),
        held: verdicts().filter(|verdict| verdict.holds).count(),
    }
}
