//! `[[landing]]` of `workbook.toml`: what the landing page says of the course, in passages of markdown.

use std::ops::Range;

use toml::de::DeValue;

use super::node::{Node, What};
use super::source_map::SourceMap;
use crate::diag::{Code, Diagnostic};
use crate::parameters::{Complaint, Fields, Parameters, parameters};
use crate::workspace::{Source, Workspace};

parameters! {
    /// The keys of a passage.
    pub struct Written {
        /// What it is about, in a few words.
        title: String,
        /// What it says, in markdown.
        text: String,
    }
}

/// A passage of the landing page.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// What it is about.
    pub title: String,
    /// What it says.
    pub nodes: Vec<Node>,
}

/// Reads the passages in their order; what is wrong is told, in `fields` or in `diagnostics`.
pub(super) fn read(
    fields: &mut Fields<'_>,
    source: &Source,
    workspace: &Workspace,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Passage> {
    let Some(value) = fields.take("landing") else { return Vec::new() };
    let shapeless =
        || Complaint::new(Code::WrongType, value.span(), "the landing page is made of tables `[[landing]]`");
    let DeValue::Array(written) = value.get_ref() else {
        fields.complaints.push(shapeless().help("each has a `title` and a `text` in markdown"));
        return Vec::new();
    };
    let mut passages = Vec::new();
    for passage in written {
        let Some(table) = passage.get_ref().as_table() else {
            fields.complaints.push(shapeless().help("each has a `title` and a `text` in markdown"));
            continue;
        };
        let mut inner = Fields::plain(table);
        let written = Written::read(&mut inner);
        inner.finish(&["title", "text"]);
        let place = inner.place("text");
        // What is missing is told of the passage as a whole.
        let whole = |range: Range<usize>| if range.is_empty() { passage.span() } else { range };
        let located = |complaint: Complaint| Complaint { range: whole(complaint.range.clone()), ..complaint };
        fields.complaints.extend(inner.complaints.drain(..).map(located));
        if let Some(Written { title, text }) = written {
            // Exactly where it stands if it holds no escapes, else the string as a whole.
            let inside = source.text[place.clone()].find(text.as_str());
            let map = inside.map_or_else(
                || SourceMap::whole(place.start, 1),
                |inside| SourceMap::whole(place.start + inside, text.len()),
            );
            let nodes = super::events::passage(&text, &source.path, map, workspace, diagnostics);
            let refused = |node: &&Node| belongs_to_a_chapter(&node.what);
            diagnostics.extend(nodes.iter().find(refused).map(|node| {
                Diagnostic::error(Code::Markup, "this can stand in a chapter only")
                    .at(&source.path, node.range.clone())
                    .help("the landing page has paragraphs, lists, tables, formulas, code and links")
            }));
            passages.push(Passage { title, nodes });
        }
    }
    passages
}

/// Whether something has a number or a place of its own, which only chapters give.
fn belongs_to_a_chapter(what: &What) -> bool {
    use pulldown_cmark::{Event, Tag};
    matches!(
        what,
        What::Experiment(_)
            | What::Listing(_)
            | What::Equation { label: Some(_), .. }
            | What::CalloutStart(_)
            | What::Markdown(
                Event::FootnoteReference(_) | Event::Start(Tag::Heading { .. } | Tag::FootnoteDefinition(_))
            )
    )
}
