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
#[derive(Clone)]
pub struct Shown {
    /// The digest of its key.
    pub key: String,
    /// The numbers.
    pub outcome: Arc<Outcome>,
    /// The figure or table.
    pub drawing: Arc<Drawing>,
    /// Words for those who cannot see it.
    pub alt: String,
    /// The verdict on each of its claims, in the order written; a claim with `*` has one for each value.
    pub verdicts: Vec<Verdict>,
}

/// A result with the digest of its key.
pub type Keyed = (String, Arc<Outcome>);

/// Draws every exhibit of the plan; `outcomes` are its results with the digests of their keys, in its order, where there are any.
pub fn show(plan: &Plan, outcomes: &[Option<Keyed>]) -> (Vec<Option<Shown>>, Vec<Diagnostic>) {
    show_with(plan, outcomes, &mut |_, exhibit, (_, outcome)| {
        let alt = words(exhibit, outcome);
        Ok((Arc::new(draw(exhibit, outcome, &alt)?), alt))
    })
}

/// A drawing with its words.
pub type Drawn = (Arc<Drawing>, String);

/// The same, with drawings and words from `drawn`, which gets an exhibit by its place in the plan.
pub fn show_with(
    plan: &Plan,
    outcomes: &[Option<Keyed>],
    drawn: &mut dyn FnMut(usize, &Exhibit, &Keyed) -> Result<Drawn, Failure>,
) -> (Vec<Option<Shown>>, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let values = |id: &str| -> Option<&Values> {
        outcomes.get(*plan.places.get(id)?)?.as_ref().map(|(_, outcome)| &outcome.values)
    };
    let shown = plan.exhibits.iter().zip(outcomes).enumerate().map(|(index, (exhibit, keyed))| {
        let keyed = keyed.as_ref()?;
        let verdicts = verdict::judge(exhibit, &keyed.1.values, &values, &mut diagnostics);
        match drawn(index, exhibit, keyed) {
            Ok((drawing, alt)) => {
                diagnostics.extend(wordless(exhibit, &alt));
                let (key, outcome) = keyed.clone();
                Some(Shown { key, outcome, drawing, alt, verdicts })
            }
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

/// A complaint of an exhibit that has no words.
fn wordless(exhibit: &Exhibit, alt: &str) -> Option<Diagnostic> {
    alt.trim().is_empty().then(|| {
        let error = Diagnostic::error(Code::MissingAlt, format!("`{}` has no alternative text", exhibit.id));
        error.at_place(&exhibit.place).help("say what it shows: `alt = \"…\"`")
    })
}
