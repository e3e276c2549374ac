//! `[budgets]`: how heavy the site may be.

use crate::parameters::{Fields, Parameters, parameters};

parameters! {
    /// The table `[budgets]`, in units of 1,000 bytes.
    pub struct Budgets {
        /// A chapter's page without its pictures.
        page: usize [in 1..=1_000_000] = 400,
        /// A file that a page loads or offers: a style, a script, a font, a picture, the data of an exhibit.
        file: usize [in 1..=1_000_000] = 400,
        /// All files together.
        site: usize [in 1..=10_000_000] = 15_000,
    }
}

impl Default for Budgets {
    fn default() -> Self {
        Self { page: 400, file: 400, site: 15_000 }
    }
}

/// Reads the budgets; what is wrong is told in `fields`, and the default stands in.
pub(super) fn read(fields: &mut Fields<'_>) -> Budgets {
    let Some(table) = fields.table("budgets") else { return Budgets::default() };
    let mut inner = Fields::plain(table);
    let budgets = Budgets::read(&mut inner);
    let known: Vec<&str> = Budgets::docs().iter().map(|doc| doc.name).collect();
    inner.finish(&known);
    fields.complaints.append(&mut inner.complaints);
    budgets.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_defaults_are_said_once_only_in_effect() {
        let table = toml::de::DeTable::parse("").unwrap();
        let read = Budgets::read(&mut Fields::plain(table.get_ref())).unwrap();
        let Budgets { page, file, site } = Budgets::default();
        assert_eq!((read.page, read.file, read.site), (page, file, site));
    }
}
