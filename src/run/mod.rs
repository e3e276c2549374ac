//! Running: experiments to results, in parallel, each once, and none whose result is kept.
//!
//! The results depend neither on the number of threads nor on what the cache holds; only the time that they take does.

use std::any::Any;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use crate::diag::{Code, Diagnostic};
use crate::kinds::{Experiment, Failure, Outcome};
use crate::seed::Seed;
use crate::sources::Digest;

pub mod cache;
pub mod key;
mod runner;

pub use cache::Cache;
pub use key::{Difference, Key};
pub use runner::Runner;

/// An experiment that is due, for one exhibit or several.
pub struct Job {
    /// The exhibits that show it.
    pub ids: Vec<String>,
    /// What is to be run.
    pub experiment: Arc<dyn Experiment>,
    /// The seed as the course states it.
    pub seed: u64,
    /// The address of its result.
    pub key: Key,
}

impl Job {
    /// The job of running `experiment` with `seed` for the exhibits `ids`.
    pub fn new(ids: Vec<String>, experiment: Arc<dyn Experiment>, seed: u64) -> Self {
        let key = Key::new(experiment.as_ref(), seed);
        Self { ids, experiment, seed, key }
    }
}

/// What became of the jobs of one key.
#[derive(Debug, Clone)]
pub struct Ran {
    /// The exhibits that show it, of all jobs with this key.
    pub ids: Vec<String>,
    /// The address of the result.
    pub key: Key,
    /// The result.
    pub outcome: Result<Arc<Outcome>, Failure>,
    /// Where the result is from.
    pub how: How,
    /// How long it took to compute or to read. With several threads, work of others may have run in between.
    pub time: Duration,
    /// Why the result could not be kept, if it could not.
    pub unsaved: Option<String>,
}

/// Where a result is from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum How {
    /// From the cache.
    Cached,
    /// Computed, and why.
    Computed(Why),
}

/// Why a result had to be computed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Why {
    /// There is no cache.
    NoCache,
    /// Nothing is known of this exhibit.
    New,
    /// The key differs from that of the last run; the first part that does.
    Changed(Difference),
    /// The cache no longer has it.
    Gone,
    /// The cache has something that cannot be trusted.
    Damaged,
}

/// Who is told how the run goes; from several threads.
pub trait Observer: Sync {
    /// The run begins: so many results come from the cache, and so many are to be computed.
    fn planned(&self, _cached: usize, _due: usize) {}
    /// A computation starts.
    fn started(&self, _job: &Job) {}
    /// A result is there.
    fn finished(&self, _ran: &Ran) {}
}

/// Nobody is told.
impl Observer for () {}

/// Whether `job` is fresh, that is in the cache, or why it would be computed.
pub fn status(job: &Job, cache: Option<&Cache>) -> How {
    match revive(job, cache) {
        Ok(_) => How::Cached,
        Err(why) => How::Computed(why),
    }
}

/// The result of `job` if the cache has it.
pub fn cached(job: &Job, cache: Option<&Cache>) -> Option<Arc<Outcome>> {
    from_cache(job, cache).ok()?.outcome.ok()
}

/// Runs `jobs` on `threads` threads: one result for each different key, in the order in which the keys first appear.
pub fn run(jobs: Vec<Job>, cache: Option<&Cache>, threads: usize, observer: &dyn Observer) -> Vec<Ran> {
    let jobs = distinct(jobs);
    let done: Vec<OnceLock<Ran>> = jobs.iter().map(|_| OnceLock::new()).collect();
    let reasons: Vec<OnceLock<Why>> = jobs.iter().map(|_| OnceLock::new()).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.max(1)).build().ok();
    each(pool.as_ref(), 0..jobs.len(), |at| match from_cache(&jobs[at], cache) {
        Ok(ran) => drop(done[at].set(ran)),
        Err(why) => drop(reasons[at].set(why)),
    });
    let mut due: Vec<usize> = (0..jobs.len()).filter(|&at| done[at].get().is_none()).collect();
    observer.planned(jobs.len() - due.len(), due.len());
    done.iter().filter_map(OnceLock::get).for_each(|ran| observer.finished(ran));
    // The heaviest first, so that none of them is left to run alone at the end.
    due.sort_by_key(|&at| std::cmp::Reverse(jobs[at].experiment.weight()));
    each(pool.as_ref(), due, |at| {
        observer.started(&jobs[at]);
        let ran = compute(&jobs[at], cache, reasons[at].get().cloned().unwrap_or(Why::NoCache));
        observer.finished(&ran);
        drop(done[at].set(ran));
    });
    done.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// A warning for results that could not be kept, if there are any.
pub fn unsaved(ran: &[Ran]) -> Option<Diagnostic> {
    let reasons: Vec<&str> = ran.iter().filter_map(|ran| ran.unsaved.as_deref()).collect();
    let first = reasons.first()?;
    let message = format!("{} of {} results could not be kept in the cache: {first}", reasons.len(), ran.len());
    Some(Diagnostic::warning(Code::Unreadable, message).help("they are computed again next time; the book is complete"))
}

/// Calls `work` once for each of `items`, started in their order, on the threads of `pool`.
fn each(pool: Option<&rayon::ThreadPool>, items: impl IntoIterator<Item = usize> + Send, work: impl Fn(usize) + Sync) {
    let work = &work;
    match pool {
        Some(pool) => pool.scope_fifo(|scope| {
            for item in items {
                scope.spawn_fifo(move |_| work(item));
            }
        }),
        // The system gives no threads: the results are the same without.
        None => items.into_iter().for_each(work),
    }
}

/// The jobs with different keys, each with the exhibits of all that share its key.
fn distinct(jobs: Vec<Job>) -> Vec<Job> {
    let mut places: BTreeMap<Digest, usize> = BTreeMap::new();
    let mut kept: Vec<Job> = Vec::new();
    for job in jobs {
        let at = *places.entry(job.key.digest()).or_insert(kept.len());
        if let Some(first) = kept.get_mut(at) {
            first.ids.extend(job.ids);
        } else {
            kept.push(job);
        }
    }
    for job in &mut kept {
        job.ids.sort();
        job.ids.dedup();
    }
    kept
}

/// The outcome that the cache has for `job`, or why it has none that can be trusted.
fn revive(job: &Job, cache: Option<&Cache>) -> Result<Outcome, Why> {
    let cache = cache.ok_or(Why::NoCache)?;
    match cache.read(&job.key) {
        cache::Found::Whole(bytes) => {
            let revived = catch_unwind(AssertUnwindSafe(|| job.experiment.revive(bytes)));
            revived.ok().flatten().ok_or(Why::Damaged)
        }
        cache::Found::Damaged => Err(Why::Damaged),
        cache::Found::Absent => {
            let latest = job.ids.iter().find_map(|id| cache.latest(id)).ok_or(Why::New)?;
            Err(job.key.first_difference(&latest).map_or(Why::Gone, Why::Changed))
        }
    }
}

/// The result of `job` from the cache, noted as the latest of its exhibits.
fn from_cache(job: &Job, cache: Option<&Cache>) -> Result<Ran, Why> {
    let start = Instant::now();
    let outcome = revive(job, cache)?;
    Ok(Ran {
        ids: job.ids.clone(),
        key: job.key.clone(),
        outcome: Ok(Arc::new(outcome)),
        how: How::Cached,
        time: start.elapsed(),
        unsaved: cache.and_then(|cache| note(job, cache).err()).map(|error| error.to_string()),
    })
}

/// Computes the result of `job` and keeps it.
fn compute(job: &Job, cache: Option<&Cache>, why: Why) -> Ran {
    let start = Instant::now();
    let run = || job.experiment.run(Seed::new(job.seed));
    let outcome = catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|payload| Err(broke(job, payload.as_ref())));
    let time = start.elapsed();
    let saved = match (cache, &outcome) {
        (Some(cache), Ok(outcome)) => cache.write(&job.key, &outcome.bytes).and_then(|()| note(job, cache)),
        _ => Ok(()),
    };
    Ran {
        ids: job.ids.clone(),
        key: job.key.clone(),
        outcome: outcome.map(Arc::new),
        how: How::Computed(why),
        time,
        unsaved: saved.err().map(|error| error.to_string()),
    }
}

/// Notes the key of `job` for each of its exhibits.
fn note(job: &Job, cache: &Cache) -> std::io::Result<()> {
    job.ids.iter().try_for_each(|id| cache.note(id, &job.key))
}

/// The failure of an experiment that panicked.
fn broke(job: &Job, payload: &(dyn Any + Send)) -> Failure {
    let words =
        payload.downcast_ref::<&str>().copied().or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    let words = words.and_then(|words| words.lines().next()).unwrap_or("for a reason that it did not tell");
    Failure {
        parameter: None,
        message: format!("the experiment of {} (`{}`) broke off: {words}", job.ids.join(", "), job.key.kind),
        help: Some("this is a mistake in the workbook generator, not in the course".to_owned()),
    }
}
