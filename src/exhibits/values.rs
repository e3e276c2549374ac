//! Values in prose: whether the results give what the text takes from them.

use std::sync::Arc;

use super::Shown;
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic};
use crate::parse::{Callout, Course, Node, ValueUse, What};
use crate::plan::Plan;

/// Complains of every value that the text takes from an exhibit which does not give it; `shown` are the exhibits that there are.
pub fn check(course: &Course, plan: &Plan, shown: &[Option<Shown>]) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    for (index, chapter) in course.chapters.iter().enumerate() {
        let mut visit = |nodes: &[Node]| {
            walk(nodes, &mut |value, node| {
                diagnostics
                    .extend(missing(value, plan, shown).map(|error| error.at(&chapter.file, node.range.clone())));
            });
        };
        visit(&chapter.content.nodes);
        plan.exhibits.iter().filter(|exhibit| exhibit.chapter == index).for_each(|exhibit| visit(&exhibit.caption));
        plan.listings.iter().filter(|listing| listing.chapter == index).for_each(|listing| visit(&listing.caption));
    }
    diagnostics
}

/// Calls `see` for every value among the nodes, those in titles included.
fn walk(nodes: &[Node], see: &mut impl FnMut(&ValueUse, &Node)) {
    for node in nodes {
        match &node.what {
            What::Value(value) => see(value, node),
            What::CalloutStart(Callout { title, .. }) => walk(title, see),
            What::Term(term) => walk(&term.words, see),
            _ => {}
        }
    }
}

/// What is wrong with a value, if its exhibit is there and does not give it.
fn missing(value: &ValueUse, plan: &Plan, shown: &[Option<Shown>]) -> Option<Diagnostic> {
    let index = plan.exhibits.iter().position(|exhibit| exhibit.id == value.exhibit)?;
    let outcome = shown.get(index)?.as_ref().map(|shown| Arc::clone(&shown.outcome))?;
    if outcome.values.get(&value.name).is_some() {
        return None;
    }
    let near = nearest(&value.name, outcome.values.names()).map(|near| format!("did you mean `{near}`?"));
    let message = format!("`{}` gives no value `{}`", value.exhibit, value.name);
    let error = Diagnostic::error(Code::UnknownValue, message).help_if(near);
    Some(error.help(format!("`workbook run {}` lists its values", value.exhibit)))
}
