//! What can be written in the tables that are no experiments, as their declarations say it.

use super::budgets::Budgets;
use super::configuration::{Defaults, Head};
use super::shelf::Catalogue;
use super::{front_matter, landing, site};
use crate::parameters::{ParameterDoc, Parameters};

/// What can be written in `workbook.toml`.
pub struct Settings {
    /// The keys of the file itself.
    pub head: Vec<ParameterDoc>,
    /// The tables with fixed keys, each by its name.
    pub tables: Vec<(&'static str, Vec<ParameterDoc>)>,
    /// The keys of a passage of the landing page.
    pub landing: Vec<ParameterDoc>,
}

/// What can be written in `workbook.toml`.
pub fn settings() -> Settings {
    Settings {
        head: Head::docs(),
        tables: vec![
            ("defaults", Defaults::docs()),
            ("repository", site::Written::docs()),
            ("budgets", Budgets::docs()),
            ("catalogue", Catalogue::docs()),
        ],
        landing: landing::Written::docs(),
    }
}

/// What can be written in a chapter's front matter.
pub fn front_matter() -> Vec<ParameterDoc> {
    front_matter::Written::docs()
}
