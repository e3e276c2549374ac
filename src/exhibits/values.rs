//! Values in prose: whether the results give what the text takes and computes from them.

use std::sync::Arc;

use super::Shown;
use super::compute::{Mistake, compute, measured, unknown};
use crate::diag::Diagnostic;
use crate::integrands::Calculation;
use crate::kinds::{Measured, Values};
use crate::parse::{Callout, Course, Node, ValueUse, What};
use crate::plan::Plan;
use crate::workspace::CONFIGURATION;

/// Complains of every value that the text takes from an exhibit which does not give it, and of every expression that gives no number;
/// `shown` are the exhibits that there are.
pub fn check(course: &Course, plan: &Plan, shown: &[Option<Shown>]) -> Vec<Diagnostic> {
    let values = |id: &str| values(plan, id, |index| shown.get(index)?.as_ref());
    let mut diagnostics = Vec::new();
    let mut visit = |file: &Arc<str>, nodes: &[Node]| {
        walk(nodes, &mut |node| match &node.what {
            What::Value(value) => {
                diagnostics.extend(missing(value, &values).map(|error| error.at(file, node.range.clone())));
            }
            What::Computed(computed) => {
                let mistakes = compute(&computed.calculation, None, &values).err().unwrap_or_default();
                let place = |mistake: &Mistake| computed.place(&mistake.range, &node.range);
                diagnostics.extend(mistakes.into_iter().map(|mistake| {
                    let place = place(&mistake);
                    mistake.error.at(file, place)
                }));
            }
            _ => {}
        });
    };
    for (index, chapter) in course.chapters.iter().enumerate() {
        let mut visit = |nodes: &[Node]| visit(&chapter.file, nodes);
        visit(&chapter.content.nodes);
        plan.exhibits.iter().filter(|exhibit| exhibit.chapter == index).for_each(|exhibit| visit(&exhibit.caption));
        plan.listings.iter().filter(|listing| listing.chapter == index).for_each(|listing| visit(&listing.caption));
    }
    course.configuration.landing.iter().for_each(|passage| visit(&Arc::from(CONFIGURATION), &passage.nodes));
    diagnostics
}

/// The number that an expression in the text gives; `shown` are all exhibits, in the plan's order.
pub fn computed(calculation: &Calculation, plan: &Plan, shown: &[Shown]) -> Option<Measured> {
    compute(calculation, None, &|id| values(plan, id, |index| shown.get(index))).ok().map(measured)
}

/// The values of the exhibit `id`, if it is there.
fn values<'s>(plan: &Plan, id: &str, shown: impl Fn(usize) -> Option<&'s Shown>) -> Option<&'s Values> {
    shown(*plan.places.get(id)?).map(|shown| &shown.outcome.values)
}

/// Calls `see` for every node, those in titles included.
fn walk(nodes: &[Node], see: &mut impl FnMut(&Node)) {
    for node in nodes {
        see(node);
        match &node.what {
            What::CalloutStart(Callout { title, .. }) => walk(title, see),
            What::Term(term) => walk(&term.words, see),
            _ => {}
        }
    }
}

/// What is wrong with a value, if its exhibit is there and does not give it.
fn missing<'v>(value: &ValueUse, values: &dyn Fn(&str) -> Option<&'v Values>) -> Option<Diagnostic> {
    let values = values(&value.exhibit)?;
    values.get(&value.name).is_none().then(|| unknown(&value.exhibit, &value.name, values))
}
