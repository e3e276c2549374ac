//! Results to exhibits: what a reader sees of an experiment, and the verdicts on what it claims.
//!
//! Drawing is a pure function of the data; nothing here computes a statistic.

mod compute;
mod values;
mod verdict;

use std::sync::Arc;

use crate::chart::{Drawing, Sheet};
use crate::diag::{Code, Diagnostic};
use crate::kinds::{Failure, Outcome, Values};
use crate::plan::{Exhibit, Plan};

pub use values::{check as check_values, computed};
pub use verdict::Verdict;

/// An exhibit ready to be put on a page.
pub struct Shown {
    /// The digest of its key.
    pub key: String,
    /// The numbers.
    pub outcome: Arc<Outcome>,
    /// The figure or table.
    pub drawing: Drawing,
    /// Words for those who cannot see it.
    pub alt: String,
    /// The verdict on each of its claims, in the order written; a claim with `*` has one for each value.
    pub verdicts: Vec<Verdict>,
}

/// A result with the digest of its key.
pub type Keyed = (String, Arc<Outcome>);

/// Draws every exhibit of the plan; `outcomes` are its results with the digests of their keys, in its order, where there are any.
pub fn show(plan: &Plan, outcomes: &[Option<Keyed>]) -> (Vec<Option<Shown>>, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let values = |id: &str| -> Option<&Values> {
        let index = plan.exhibits.iter().position(|exhibit| exhibit.id == id)?;
        outcomes.get(index)?.as_ref().map(|(_, outcome)| &outcome.values)
    };
    let shown = plan.exhibits.iter().zip(outcomes).map(|(exhibit, outcome)| {
        let (key, outcome) = outcome.clone()?;
        let verdicts = verdict::judge(exhibit, &outcome.values, &values, &mut diagnostics);
        let alt = alternative(exhibit, &outcome, &mut diagnostics);
        match draw(exhibit, &outcome, &alt) {
            Ok(drawing) => Some(Shown { key, outcome, drawing, alt, verdicts }),
            Err(failure) => {
                diagnostics.push(failed(exhibit, &failure));
                None
            }
        }
    });
    (shown.collect(), diagnostics)
}

/// The drawing of a result, with `alt` as its words.
pub fn draw(exhibit: &Exhibit, outcome: &Outcome, alt: &str) -> Result<Drawing, Failure> {
    exhibit.experiment.draw(outcome, &Sheet::new(&exhibit.id, exhibit.experiment.kind().about().title, alt))
}

/// The author's words for the exhibit, or those derived from the data.
pub fn words(exhibit: &Exhibit, outcome: &Outcome) -> String {
    exhibit.alt.clone().or_else(|| exhibit.experiment.alt(outcome)).unwrap_or_default()
}

/// What to tell of an experiment that failed, or of a result that cannot be drawn.
pub fn failed(exhibit: &Exhibit, failure: &Failure) -> Diagnostic {
    let parameter = failure.parameter.map(|parameter| format!(", at `{parameter}`")).unwrap_or_default();
    Diagnostic::error(Code::Failed, format!("`{}` failed{parameter}: {}", exhibit.id, failure.message))
        .at_place(&exhibit.place)
        .help_if(failure.help.clone())
}

/// The words for the exhibit; none is an error.
fn alternative(exhibit: &Exhibit, outcome: &Outcome, diagnostics: &mut Vec<Diagnostic>) -> String {
    let alt = words(exhibit, outcome);
    if alt.trim().is_empty() {
        let error = Diagnostic::error(Code::MissingAlt, format!("`{}` has no alternative text", exhibit.id));
        diagnostics.push(error.at_place(&exhibit.place).help("say what it shows: `alt = \"…\"`"));
    }
    alt
}
