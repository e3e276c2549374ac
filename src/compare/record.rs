//! What `figures.json` says of each exhibit, as far as it is compared.

use serde::Deserialize;
use serde_json::{Map, Value as Json};

/// The file.
#[derive(Debug, Clone, Default, Deserialize)]
pub(super) struct Figures {
    pub(super) exhibits: Vec<Record>,
}

/// An exhibit.
#[derive(Debug, Clone, Deserialize)]
pub(super) struct Record {
    pub(super) id: String,
    pub(super) kind: String,
    #[serde(default)]
    pub(super) number: Option<String>,
    #[serde(default)]
    pub(super) chapter: String,
    #[serde(default)]
    pub(super) place: String,
    #[serde(default)]
    pub(super) parameters: Map<String, Json>,
    #[serde(default)]
    pub(super) seed: Json,
    #[serde(default)]
    pub(super) values: Map<String, Json>,
    #[serde(default)]
    pub(super) claims: Vec<Claim>,
    #[serde(default)]
    pub(super) files: Vec<String>,
}

/// A claim and its verdict.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(super) struct Claim {
    pub(super) value: String,
    pub(super) bound: String,
    #[serde(default)]
    pub(super) measured: Json,
    pub(super) holds: bool,
}

impl Record {
    /// What a reader calls it, e.g. `Figure 2.3`.
    pub(super) fn name(&self) -> String {
        let word = if self.id.starts_with("tbl-") { "Table" } else { "Figure" };
        self.number.as_ref().map_or_else(|| word.to_owned(), |number| format!("{word} {number}"))
    }
}
