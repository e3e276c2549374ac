//! A session: what is known of a course from one edit to the next, and what follows from it for the book.
//!
//! Nothing is kept that the course as it is now does not ask for, so a session of a thousand edits is as large as one of a single edit.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use std::time::Duration;

use crate::chart::{Cell, Column, Drawing, Figure, Table};
use crate::compose::{self, Clock, Memory, Request, job};
use crate::diag::{Diagnostic, any_error};
use crate::exhibits::{self, Drawn, Keyed, Shown};
use crate::kinds::{Experiment, Failure, Outcome, Values};
use crate::parse::Course;
use crate::plan::{Exhibit, Plan};
use crate::render::{Parts, Proof};
use crate::run::{self, Cache, Job, Ran};
use crate::sources::Digest;
use crate::workspace::Workspace;
use crate::{generate, plan};

/// What is known of a course.
pub(super) struct Session {
    request: Request,
    cache: Option<Cache>,
    memory: Memory,
    now: Option<Read>,
    /// The digest of each experiment's key, by where the experiment is.
    keys: BTreeMap<usize, (Arc<dyn Experiment>, u64, Digest)>,
    results: BTreeMap<Digest, Result<Arc<Outcome>, Failure>>,
    /// What was drawn, by the exhibit's id.
    drawn: BTreeMap<String, Kept>,
    /// The exhibits as they were last right, by id.
    last: BTreeMap<String, Shown>,
    proof: Option<Arc<Proof>>,
}

/// The course as last read.
struct Read {
    workspace: Arc<Workspace>,
    course: Arc<Course>,
    plan: Arc<Plan>,
    digest: Digest,
    told: Vec<Diagnostic>,
    /// How long each stage took.
    times: Vec<(&'static str, Duration)>,
}

/// A drawing and what it was drawn from.
struct Kept {
    experiment: Arc<dyn Experiment>,
    key: String,
    alt: Option<String>,
    drawn: Result<Drawn, Failure>,
}

/// What has become of the course.
pub(super) struct Update {
    /// The new proof of the book; none if the course is too wrong for one.
    pub proof: Option<Arc<Proof>>,
    /// What is wrong.
    pub found: Vec<Diagnostic>,
    /// The inputs, for excerpts.
    pub workspace: Arc<Workspace>,
    /// The exhibits whose results are due.
    pub stale: Vec<String>,
    /// What is to be run; none if that has not changed.
    pub due: Option<Vec<Job>>,
    /// How long each stage took.
    pub times: Vec<(&'static str, Duration)>,
}

impl Session {
    pub fn new(request: Request) -> Self {
        let cache = request.cache();
        Self {
            request,
            cache,
            memory: Memory::default(),
            now: None,
            keys: BTreeMap::new(),
            results: BTreeMap::new(),
            drawn: BTreeMap::new(),
            last: BTreeMap::new(),
            proof: None,
        }
    }

    /// Reads the course again; says whether anything is new.
    pub fn read(&mut self) -> bool {
        let planned = compose::check_again(&self.request, &mut self.memory);
        let same = |now: &Read| now.digest == planned.course_digest && now.told == planned.diagnostics;
        if self.now.as_ref().is_some_and(same) {
            return false;
        }
        self.now = Some(Read {
            workspace: Arc::new(planned.workspace),
            course: Arc::new(planned.course),
            plan: Arc::new(planned.plan),
            digest: planned.course_digest,
            told: planned.diagnostics,
            times: planned.timings,
        });
        true
    }

    /// Takes a result; says whether the course asks for it and did not have it: the cache may have been faster.
    pub fn take(&mut self, ran: &Ran) -> bool {
        let digest = ran.key.digest();
        let wanted = self.keys.values().any(|(_, _, known)| *known == digest);
        wanted && self.results.insert(digest, ran.outcome.clone()).is_none()
    }

    /// What follows from what is known.
    pub fn update(&mut self) -> Option<Update> {
        let Read { workspace, course, plan, told, times, .. } = self.now.as_mut()?;
        let mut clock = Clock { times: std::mem::take(times) };
        let (workspace, course, plan) = (Arc::clone(workspace), Arc::clone(course), Arc::clone(plan));
        let mut found = told.clone();
        if any_error(&found) {
            return Some(Update { proof: None, found, workspace, stale: Vec::new(), due: None, times: clock.times });
        }
        let (outcomes, due) = clock.time("results", || self.outcomes(&plan, &mut found));
        let (shown, complaints) = clock.time("exhibits", || self.show(&plan, &outcomes));
        found.extend(complaints);
        found.extend(clock.time("values", || exhibits::check_values(&course, &plan, &shown)));
        let (shown, stale) = self.fill(&plan, shown);
        let waiting = due.iter().flat_map(|job| job.ids.iter().cloned()).collect();
        let converter = self.memory.planned.last_converter();
        let converter =
            converter.unwrap_or_else(|| Arc::new(plan::Converter::new(&course.configuration.macros, &mut Vec::new())));
        let parts = Parts { workspace: Arc::clone(&workspace), course, plan, shown, stale, converter };
        let (proof, complaints) = clock.time("proof", || Proof::new(parts, self.proof.as_deref()));
        found.extend(complaints);
        generate::explain(&mut found);
        let proof = proof.map(Arc::new);
        if proof.is_some() {
            self.proof.clone_from(&proof);
        }
        Some(Update { proof, found, workspace, stale: waiting, due: Some(due), times: clock.times })
    }

    /// The result of each exhibit, from memory or from the cache, and the jobs whose results are not there.
    fn outcomes(&mut self, plan: &Plan, found: &mut Vec<Diagnostic>) -> (Vec<Option<Keyed>>, Vec<Job>) {
        let mut before = std::mem::take(&mut self.keys);
        let mut due = Vec::new();
        let mut live = BTreeSet::new();
        let mut outcomes = Vec::with_capacity(plan.exhibits.len());
        for exhibit in &plan.exhibits {
            let at = Arc::as_ptr(&exhibit.experiment).cast::<()>() as usize;
            let known = before.remove(&at).filter(|(_, seed, _)| *seed == exhibit.seed);
            let digest = known.map_or_else(|| job(exhibit).key.digest(), |(_, _, digest)| digest);
            self.keys.insert(at, (Arc::clone(&exhibit.experiment), exhibit.seed, digest));
            live.insert(digest);
            if !self.results.contains_key(&digest) {
                let job = job(exhibit);
                match run::cached(&job, self.cache.as_ref()) {
                    Some(outcome) => drop(self.results.insert(digest, Ok(outcome))),
                    None => due.push(job),
                }
            }
            outcomes.push(match self.results.get(&digest) {
                Some(Ok(outcome)) => Some((digest.to_string(), Arc::clone(outcome))),
                Some(Err(failure)) => {
                    found.push(exhibits::failed(exhibit, failure));
                    None
                }
                None => None,
            });
        }
        self.results.retain(|digest, _| live.contains(digest));
        (outcomes, due)
    }

    /// The exhibits that there are results of; those that are the same as before are not drawn anew.
    fn show(&mut self, plan: &Plan, outcomes: &[Option<Keyed>]) -> (Vec<Option<Shown>>, Vec<Diagnostic>) {
        let mut before = std::mem::take(&mut self.drawn);
        let kept = &mut self.drawn;
        exhibits::show_with(plan, outcomes, &mut |_, exhibit, (key, outcome)| {
            let same = |kept: &Kept| {
                kept.key == *key && kept.alt == exhibit.alt && is_same(&kept.experiment, &exhibit.experiment)
            };
            let known = before.remove(&exhibit.id).filter(same).map(|kept| kept.drawn);
            let drawn = known.unwrap_or_else(|| {
                let words = exhibits::words(exhibit, outcome);
                exhibits::draw(exhibit, outcome, &words).map(|drawing| (Arc::new(drawing), words))
            });
            let experiment = Arc::clone(&exhibit.experiment);
            let entry = Kept { experiment, key: key.clone(), alt: exhibit.alt.clone(), drawn: drawn.clone() };
            kept.insert(exhibit.id.clone(), entry);
            drawn
        })
    }

    /// All exhibits: where one is missing, as it was before, or what stands in for it. Gives the places of those, too.
    fn fill(&mut self, plan: &Plan, shown: Vec<Option<Shown>>) -> (Vec<Shown>, BTreeSet<usize>) {
        let mut last = std::mem::take(&mut self.last);
        let mut stale = BTreeSet::new();
        let mut filled = Vec::with_capacity(shown.len());
        for (at, (exhibit, shown)) in plan.exhibits.iter().zip(shown).enumerate() {
            let before = last.remove(&exhibit.id);
            let shown = shown.unwrap_or_else(|| {
                stale.insert(at);
                stands_in(exhibit, before)
            });
            self.last.insert(exhibit.id.clone(), shown.clone());
            filled.push(shown);
        }
        (filled, stale)
    }
}

/// Whether two experiments are the same, for their drawings too.
fn is_same(one: &Arc<dyn Experiment>, other: &Arc<dyn Experiment>) -> bool {
    Arc::ptr_eq(one, other)
        || (one.kind().about().key == other.kind().about().key && one.parameters() == other.parameters())
}

/// What is shown of an exhibit that has no result yet: what it was `before`, if it was.
fn stands_in(exhibit: &Exhibit, before: Option<Shown>) -> Shown {
    let Some(mut before) = before else {
        let outcome = Arc::new(Outcome { bytes: Vec::new(), values: Values::default() });
        let alt = "This is being computed.".to_owned();
        return Shown { key: String::new(), outcome, drawing: Arc::new(empty(exhibit)), alt, verdicts: Vec::new() };
    };
    // Verdicts name the claims that they belong to by their places.
    let claims = &exhibit.claims;
    before
        .verdicts
        .retain(|verdict| claims.get(verdict.claim.0).is_some_and(|claim| verdict.claim.1 < claim.bounds.len()));
    before
}

/// A drawing without anything in it.
fn empty(exhibit: &Exhibit) -> Drawing {
    if exhibit.id.starts_with("tbl-") {
        let columns = vec![Column::left("computing …")];
        return Table::new(columns).row([Cell::text(" ")]).into();
    }
    let (width, height) = (640.0, 360.0);
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" \
         aria-label=\"This is being computed.\"><rect x=\".5\" y=\".5\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\".25\"/></svg>",
        width - 1.0,
        height - 1.0
    );
    Figure { svg, width, height }.into()
}
