//! The shelves of the catalogue: what pages code can write, and `[catalogue]` of `workbook.toml`, which asks for them.

use super::configuration::Configuration;
use crate::parameters::{Fields, Parameters, choices, parameters};
use crate::workspace::Source;

choices! {
    /// A part of the catalogue: what it has a page of each of.
    pub enum Shelf {
        /// The samplers.
        Samplers = "samplers",
        /// The scrambles.
        Scrambles = "scrambles",
        /// The integrands.
        Integrands = "integrands",
        /// The measures.
        Measures = "measures",
    }
}

parameters! {
    /// The table `[catalogue]`.
    pub struct Catalogue {
        /// What the book has a page of each of, in the order of the shelves.
        pages: Vec<Shelf> = ["samplers", "scrambles", "integrands", "measures"],
    }
}

impl Shelf {
    /// The name of its own page.
    pub fn name(self) -> &'static str {
        match self {
            Self::Samplers => "samplers",
            Self::Scrambles => "scrambles",
            Self::Integrands => "integrands",
            Self::Measures => "measures",
        }
    }

    /// Its title.
    pub fn title(self) -> &'static str {
        match self {
            Self::Samplers => "Samplers",
            Self::Scrambles => "Scrambles",
            Self::Integrands => "Integrands",
            Self::Measures => "Measures",
        }
    }

    /// What a reader calls one of its members, before the number.
    pub fn singular(self) -> &'static str {
        match self {
            Self::Samplers => "Sampler",
            Self::Scrambles => "Scramble",
            Self::Integrands => "Integrand",
            Self::Measures => "Measure",
        }
    }

    /// The letter that stands for it, and that its members' numbers begin with; randomisations have the R.
    pub fn letter(self) -> &'static str {
        match self {
            Self::Samplers => "S",
            Self::Scrambles => "R",
            Self::Integrands => "I",
            Self::Measures => "M",
        }
    }

    /// The name of the page of its member `key`.
    pub fn page(self, key: &str) -> String {
        format!("{}-{key}", self.singular().to_lowercase())
    }
}

/// A chapter that code wrote.
#[derive(Debug, Clone)]
pub struct Generated {
    /// Its text, as a chapter's file would have it. The path is that of no file.
    pub source: Source,
    /// The shelf that it belongs to.
    pub shelf: Shelf,
    /// Whether it is the page of one member, not that of the shelf.
    pub member: bool,
    /// Its number: `S` of the samplers, `S7` of the seventh.
    pub number: String,
}

impl Generated {
    /// The name of its page.
    pub fn name(&self) -> &str {
        let (_, file) = self.source.path.rsplit_once('/').unwrap_or_default();
        file.trim_end_matches(".md")
    }
}

/// Reads `[catalogue]`: the shelves that the book has; none if the table is not there.
pub(super) fn read(fields: &mut Fields<'_>, configuration: &mut Configuration) {
    let Some(table) = fields.table("catalogue") else { return };
    let mut inner = Fields::plain(table);
    let written = Catalogue::read(&mut inner);
    inner.finish(&["pages"]);
    fields.complaints.append(&mut inner.complaints);
    configuration.catalogue = written.map(|written| written.pages).unwrap_or_default();
    configuration.catalogue.sort_by_key(|shelf| *shelf as usize);
    configuration.catalogue.dedup();
}
