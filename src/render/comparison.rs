//! The report of a comparison: one file that needs no other.

use serde::Serialize;
use tera::{Context, Tera};

use super::templates::embedded;
use crate::diag::{Code, Diagnostic};

/// The template.
const TEMPLATE: &str = "compare.html";

/// What the template is given.
#[derive(Serialize)]
struct Filled<'a, R: Serialize, B: Serialize> {
    report: &'a R,
    empty: bool,
    groups: [Group<'a, B>; 2],
}

/// Exhibits that only one of the books has.
#[derive(Serialize)]
struct Group<'a, B: Serialize> {
    title: &'static str,
    exhibits: &'a [B],
}

/// The page of `report`, which says nothing if it is `empty`, with the exhibits that are new and those that are gone.
pub fn comparison<R: Serialize, B: Serialize>(
    report: &R,
    empty: bool,
    added: &[B],
    removed: &[B],
) -> Result<String, Diagnostic> {
    let groups = [Group { title: "Added", exhibits: added }, Group { title: "Removed", exhibits: removed }];
    let text = embedded(TEMPLATE).map(|bytes| String::from_utf8_lossy(bytes).into_owned()).unwrap_or_default();
    let mut tera = Tera::new();
    let filled = tera
        .add_raw_templates([(TEMPLATE.to_owned(), text)])
        .and_then(|()| Context::from_serialize(&Filled { report, empty, groups }))
        .and_then(|context| tera.render(TEMPLATE, &context));
    filled.map_err(|error| Diagnostic::error(Code::Template, format!("the report cannot be made: {error}")))
}
