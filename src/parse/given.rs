//! The table `[given]` of a front matter: numbers that the chapter states, and why no experiment has to give them.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::diag::Code;
use crate::parameters::{Complaint, Fields};

/// A number that a chapter is given, not computed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Given {
    /// The number as it stands in the text.
    pub literal: String,
    /// Where the entry's key stands in the chapter's file.
    pub range: Range<usize>,
}

/// Reads the table; an entry without a reason is told. Places are those in the front matter.
pub(super) fn read(fields: &mut Fields<'_>) -> Vec<Given> {
    let Some(table) = fields.table("given") else { return Vec::new() };
    let mut given = Vec::new();
    flatten(table, "", None, &mut given, &mut fields.complaints);
    given
}

/// Reads the entries; TOML takes a key with a point that is not quoted as a table in a table.
fn flatten(
    table: &DeTable<'_>,
    prefix: &str,
    start: Option<usize>,
    given: &mut Vec<Given>,
    complaints: &mut Vec<Complaint>,
) {
    for (key, value) in table {
        let literal = format!("{prefix}{}", key.get_ref());
        let range = start.unwrap_or(key.span().start)..key.span().end;
        match value.get_ref() {
            DeValue::Table(inner) => {
                flatten(inner, &format!("{literal}."), Some(range.start), given, complaints);
            }
            DeValue::String(reason) if !reason.trim().is_empty() => given.push(Given { literal, range }),
            _ => complaints.push(
                Complaint::new(Code::WrongType, value.span(), format!("why is `{literal}` given?"))
                    .help("write the reason as a text: `\"2.75039\" = \"the lecture's own row\"`"),
            ),
        }
    }
}
