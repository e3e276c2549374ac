//! The map: from a course's folder to a book, stage by stage.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::diag::{Diagnostic, any_error};
use crate::exhibits::{Keyed, Shown};
use crate::parse::{Audience, Configuration, Course, Generated, Shelf};
use crate::plan::{Exhibit, Plan};
use crate::render::Book;
use crate::run::{Cache, Job, Observer, Ran};
use crate::sources::Digest;
use crate::workspace::{History, Workspace};
use crate::{exhibits, generate, parse, plan, receipt, render, run, verify, workspace};

/// What a book is made from.
#[derive(Debug, Clone)]
pub struct Request {
    /// The course's folder.
    pub root: PathBuf,
    /// How many threads run experiments.
    pub threads: usize,
    /// Whether results may come from the cache.
    pub cached: bool,
    /// For whom the book is; the course says it if this does not.
    pub audience: Option<Audience>,
}

impl Request {
    /// The course's cache, if it may be used.
    pub fn cache(&self) -> Option<Cache> {
        self.cached.then(|| cache(&self.root))
    }
}

/// The cache of the course at `root`.
pub fn cache(root: &std::path::Path) -> Cache {
    Cache::new(root.join(".workbook").join("cache"))
}

/// A book and how it came about. With an error among the diagnostics there is no book.
pub struct Composed {
    /// The inputs, for the excerpts of diagnostics.
    pub workspace: Workspace,
    /// The course as written.
    pub course: Course,
    /// All that was due.
    pub plan: Plan,
    /// The digest of the course's files.
    pub course_digest: Digest,
    /// For whom the book is.
    pub audience: Audience,
    /// The exhibits of the course that this audience does not get.
    pub withheld: BTreeSet<String>,
    /// The exhibits, in the plan's order; empty if any of them could not be had.
    pub shown: Vec<Shown>,
    /// The site; empty if anything is wrong.
    pub book: Book,
    /// What became of each distinct experiment.
    pub ran: Vec<Ran>,
    /// Every complaint of every stage.
    pub diagnostics: Vec<Diagnostic>,
    /// How long each stage took.
    pub timings: Vec<(&'static str, Duration)>,
}

impl Composed {
    /// Whether every exhibit that the chapters ask for is there, whatever is said of it.
    pub fn is_whole(&self) -> bool {
        !self.plan.seen.any_wrong() && self.shown.len() == self.plan.exhibits.len()
    }
}

/// What checking a course without running it gives.
pub struct Planned {
    /// The inputs, for the excerpts of diagnostics.
    pub workspace: Workspace,
    /// The course as written.
    pub course: Course,
    /// All that is due.
    pub plan: Plan,
    /// The digest of the course's files.
    pub course_digest: Digest,
    /// For whom it is.
    pub audience: Audience,
    /// The exhibits of the course that this audience does not get.
    pub withheld: BTreeSet<String>,
    /// Every complaint.
    pub diagnostics: Vec<Diagnostic>,
    /// How long each stage took.
    pub timings: Vec<(&'static str, Duration)>,
}

/// What is known of a course that is checked again and again: what has not changed is not read anew.
#[derive(Default)]
pub struct Memory {
    workspace: Workspace,
    generated: Option<(Vec<Shelf>, Vec<Generated>)>,
    /// The chapters as parsed.
    pub parsed: parse::Memo,
    /// Their parts of the plan.
    pub planned: plan::Memo,
    /// What git said, and what it was asked.
    history: Option<((bool, bool), Said)>,
}

/// What git says, and what there is to tell of it.
type Said = (History, Vec<Diagnostic>);

/// Reads, parses and plans the course: all that can be known without running.
pub fn check(request: &Request) -> Planned {
    check_again(request, &mut Memory::default())
}

/// The same, with what is known from the last time.
pub fn check_again(request: &Request, memory: &mut Memory) -> Planned {
    let mut clock = Clock::default();
    let (mut workspace, mut diagnostics) = clock.time("read", || workspace::load(&request.root));
    workspace.share(&memory.workspace);
    let course_digest = receipt::course(&workspace);
    let (configuration, complaints) = parse::configuration(&workspace);
    diagnostics.extend(complaints);
    let generated = clock.time("generate", || memory.generated(&configuration));
    workspace.texts.extend(generated.iter().map(|page| (Arc::clone(&page.source.path), page.source.clone())));
    let parsed = &mut memory.parsed;
    let (course, complaints) =
        clock.time("parse", || parse::course_again(configuration, &workspace, &generated, parsed));
    diagnostics.extend(complaints);
    let (plan, complaints) = clock.time("plan", || plan::plan_again(&course, &workspace, &mut memory.planned));
    diagnostics.extend(complaints);
    let audience = request.audience.unwrap_or(course.configuration.audience);
    let (history, complaints) = memory.history(request, &course);
    workspace.history = history;
    memory.workspace.clone_from(&workspace);
    diagnostics.extend(complaints);
    let withheld = BTreeSet::new();
    let mut planned =
        Planned { workspace, course, plan, course_digest, audience, withheld, diagnostics, timings: clock.times };
    if audience == Audience::Student {
        planned = for_students(planned);
    }
    generate::explain(&mut planned.diagnostics);
    planned
}

impl Memory {
    /// The chapters that code writes: the same as long as the same shelves are asked for.
    fn generated(&mut self, configuration: &Configuration) -> Vec<Generated> {
        let shelves = &configuration.catalogue;
        if let Some((_, generated)) = self.generated.as_ref().filter(|(known, _)| known == shelves) {
            return generated.clone();
        }
        let generated = generate::chapters(configuration);
        self.generated = Some((shelves.clone(), generated.clone()));
        generated
    }

    /// What git says, if the course wants to know; it is asked once.
    fn history(&mut self, request: &Request, course: &Course) -> Said {
        let repository = &course.configuration.site.repository;
        let wanted = (repository.asks_for_commit(), repository.last_change);
        if let Some((_, said)) = self.history.as_ref().filter(|(known, _)| *known == wanted) {
            return said.clone();
        }
        let said = workspace::history::ask(&request.root, wanted.0, wanted.1);
        self.history = Some((wanted, said.clone()));
        said
    }
}

/// The same without solutions. The whole has been planned before, so that its numbers stay, and its mistakes are told.
fn for_students(whole: Planned) -> Planned {
    let Planned { mut workspace, course, plan, course_digest, audience, mut diagnostics, timings, .. } = whole;
    let mut clock = Clock { times: timings };
    let (students, part) = clock.time("audience", || {
        let (students, orphans) = parse::without_solutions(&course);
        parse::without_files_of_solutions(&mut workspace, &course, &students);
        let (part, complaints) = plan::for_students(&students, &workspace, &plan, &diagnostics);
        diagnostics.extend(orphans.into_iter().chain(complaints));
        (students, part)
    });
    let withheld = plan.exhibits.iter().map(|exhibit| &exhibit.id).filter(|id| part.exhibit(id).is_none());
    let withheld = withheld.cloned().collect();
    let (course, plan, timings) = (students, part, clock.times);
    Planned { workspace, course, plan, course_digest, audience, withheld, diagnostics, timings }
}

/// Makes the book of a course, all but writing it.
///
/// Experiments that are right run even if others are wrong, so that false claims are told in the same run as slips of the pen.
pub fn compose(request: &Request, observer: &dyn Observer) -> Composed {
    let Planned { workspace, course, plan, course_digest, audience, withheld, mut diagnostics, timings } =
        check(request);
    let mut clock = Clock { times: timings };
    let ran = clock.time("run", || run::run(jobs(&plan), request.cache().as_ref(), request.threads, observer));
    diagnostics.extend(run::unsaved(&ran));
    let (outcomes, failures) = outcomes(&plan, &ran);
    diagnostics.extend(failures);
    let (shown, complaints) = clock.time("exhibits", || exhibits::show(&plan, &outcomes));
    diagnostics.extend(complaints);
    diagnostics.extend(exhibits::check_values(&course, &plan, &shown));
    let mut composed = Composed {
        workspace,
        course,
        plan,
        course_digest,
        audience,
        withheld,
        shown: Vec::new(),
        book: Book::default(),
        ran,
        diagnostics,
        timings: Vec::new(),
    };
    if let Some(shown) = shown.into_iter().collect::<Option<Vec<_>>>() {
        composed.shown = shown;
    }
    if any_error(&composed.diagnostics) {
        composed.diagnostics.extend(render::check(&composed.course, &composed.plan, &composed.workspace));
    } else {
        let (book, complaints) = clock
            .time("render", || render::render(&composed.course, &composed.plan, &composed.shown, &composed.workspace));
        composed.diagnostics.extend(complaints);
        composed.diagnostics.extend(clock.time("verify", || verify::book(&book, &composed.course)));
        composed.book = book;
    }
    generate::explain(&mut composed.diagnostics);
    composed.timings = clock.times;
    composed
}

/// The jobs of a plan, one for each exhibit.
pub fn jobs(plan: &Plan) -> Vec<Job> {
    plan.exhibits.iter().map(job).collect()
}

/// The job of an exhibit.
pub fn job(exhibit: &Exhibit) -> Job {
    Job::new(vec![exhibit.id.clone()], Arc::clone(&exhibit.experiment), exhibit.seed)
}

/// The result of each exhibit with the digest of its key, where there is one, and what went wrong where there is none.
fn outcomes(plan: &Plan, ran: &[Ran]) -> (Vec<Option<Keyed>>, Vec<Diagnostic>) {
    let by_id: BTreeMap<&str, &Ran> =
        ran.iter().flat_map(|ran| ran.ids.iter().map(move |id| (id.as_str(), ran))).collect();
    let mut diagnostics = Vec::new();
    let outcomes = plan.exhibits.iter().map(|exhibit| match by_id.get(exhibit.id.as_str()) {
        Some(Ran { outcome: Ok(outcome), key, .. }) => Some((key.digest().to_string(), Arc::clone(outcome))),
        Some(Ran { outcome: Err(failure), .. }) => {
            diagnostics.push(exhibits::failed(exhibit, failure));
            None
        }
        None => None,
    });
    (outcomes.collect(), diagnostics)
}

/// How long each stage takes.
#[derive(Default)]
pub(crate) struct Clock {
    /// The stages, each with its time.
    pub(crate) times: Vec<(&'static str, Duration)>,
}

impl Clock {
    /// Does the work of a stage.
    pub(crate) fn time<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let value = work();
        self.times.push((stage, start.elapsed()));
        value
    }
}
