//! TOML within the course's files: configuration, front matter and fences, read in one way.

use std::sync::Arc;

use toml::Spanned;
use toml::de::DeTable;

use super::source_map::SourceMap;
use crate::diag::{Code, Diagnostic};

/// The table that `text` holds; what cannot be read is told at its place in `file`, and the rest is read all the same.
pub fn table<'t>(
    text: &'t str,
    file: &Arc<str>,
    map: &SourceMap,
    diagnostics: &mut Vec<Diagnostic>,
) -> Spanned<DeTable<'t>> {
    let (table, errors) = DeTable::parse_recoverable(text);
    for error in errors {
        let range = map.range(error.span().unwrap_or(0..0));
        diagnostics.push(Diagnostic::error(Code::Toml, error.message().to_owned()).at(file, range));
    }
    table
}
