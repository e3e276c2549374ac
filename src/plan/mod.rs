//! The plan: all that is due. Written experiments become validated ones with keys; labels get their numbers; what refers to
//! nothing is told. Later stages cannot see the raw form.

mod amount;
mod audience;
mod bibliography;
mod changed;
mod claim;
mod emphasis;
mod exhibit;
mod format;
mod formula;
mod labels;
pub mod links;
mod listing;
mod literal;
mod memo;
mod references;
mod seen;
mod slides;
mod slug;
pub mod terms;
mod typed;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::diag::{Diagnostic, Place};
use crate::kinds::Experiment;
use crate::parse::{Chapter, Course, Node};
use crate::workspace::Workspace;

pub use amount::{Amount, Settled};
pub use audience::for_students;
pub use bibliography::Bibliography;
pub use changed::{Change, Changed};
pub use claim::{Bound, Claim, Literal, Other};
pub use format::Format;
pub(crate) use format::{escape, minus};
pub use formula::Converter;
pub use labels::{LabelKind, Labels, Section, Target};
pub use listing::{Listing, listing_docs};
pub use memo::Memo;
pub use references::address;
pub use seen::Seen;
pub use terms::Terms;

/// All that is due for a book.
pub struct Plan {
    /// The exhibits in the book's order.
    pub exhibits: Vec<Exhibit>,
    /// The places of the exhibits there, by their ids.
    pub places: BTreeMap<String, usize>,
    /// The listings in the book's order.
    pub listings: Vec<Listing>,
    /// What every label names.
    pub labels: Labels,
    /// The terms that the chapters define.
    pub terms: Terms,
    /// The works that chapters cite.
    pub bibliography: Arc<Bibliography>,
    /// What was seen of fences, the wrong ones included.
    pub seen: Seen,
    /// For each chapter, the exhibit of each of its experiment fences.
    pub exhibit_of: Vec<Vec<Option<usize>>>,
    /// For each chapter, the listing of each of its listing fences.
    pub listing_of: Vec<Vec<Option<usize>>>,
}

/// A figure or table that the book shows, with the experiment that gives it.
#[derive(Clone)]
pub struct Exhibit {
    /// Its id, e.g. `fig-rmse-1d`.
    pub id: String,
    /// The index of its chapter.
    pub chapter: usize,
    /// The fence's first line.
    pub place: Place,
    /// The caption's nodes.
    pub caption: Vec<Node>,
    /// The author's text for those who cannot see it, if there is one.
    pub alt: Option<String>,
    /// What it claims of its values.
    pub claims: Vec<Claim>,
    /// The seed of its experiment.
    pub seed: u64,
    /// The experiment.
    pub experiment: Arc<dyn Experiment>,
}

/// Plans the book. Every complaint is collected; exhibits that are wrong are left out of the plan.
pub fn plan(course: &Course, workspace: &Workspace) -> (Plan, Vec<Diagnostic>) {
    plan_again(course, workspace, &mut Memo::default())
}

/// The same, for a course that is planned again and again: of chapters that `memo` knows, little is read anew.
pub fn plan_again(course: &Course, workspace: &Workspace, memo: &mut Memo) -> (Plan, Vec<Diagnostic>) {
    memo.begin(course, workspace);
    let (plan, mut diagnostics) = planned(course, None, workspace, memo);
    typed::check(course, &plan, workspace, memo, &mut diagnostics);
    (plan, diagnostics)
}

/// The plan of a course, with the numbers that `whole` has if it is a part of one.
fn planned(course: &Course, whole: Option<&Labels>, workspace: &Workspace, memo: &mut Memo) -> (Plan, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let bibliography = memo.bibliography(course, workspace, &mut diagnostics);
    let mut plan = Plan {
        exhibits: Vec::new(),
        places: BTreeMap::new(),
        listings: Vec::new(),
        labels: Labels::default(),
        terms: Terms::default(),
        bibliography,
        seen: Seen::default(),
        exhibit_of: Vec::new(),
        listing_of: Vec::new(),
    };
    for (index, chapter) in course.chapters.iter().enumerate() {
        let reading = Reading { chapter, index, seed: course.configuration.seed, workspace };
        memo.fences(&reading, &mut plan, &mut diagnostics);
    }
    let places = plan.exhibits.iter().enumerate();
    plan.places = places.map(|(at, exhibit)| (exhibit.id.clone(), at)).collect();
    plan.labels = labels::number(course, &plan, &mut diagnostics);
    if let Some(whole) = whole {
        plan.labels.numbered_as_in(whole);
    }
    plan.terms = terms::find(course, &plan, workspace, &mut diagnostics);
    references::check(course, &plan, memo, &mut diagnostics);
    for chapter in &course.chapters {
        memo.once(chapter, "emphasis", &mut diagnostics, |told| emphasis::check(chapter, workspace, told));
        memo.once(chapter, "slides", &mut diagnostics, |told| slides::check(chapter, told));
    }
    (plan, diagnostics)
}

/// What reading a chapter's fences needs to know.
struct Reading<'a> {
    chapter: &'a Chapter,
    index: usize,
    seed: u64,
    workspace: &'a Workspace,
}

impl Plan {
    /// The exhibit with this id.
    pub fn exhibit(&self, id: &str) -> Option<&Exhibit> {
        self.exhibits.get(*self.places.get(id)?)
    }
}
