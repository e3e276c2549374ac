//! Running in the background, for whoever does not wait: what is wanted now goes first, and what is no longer wanted is not begun.
//!
//! An experiment that is under way when it is no longer wanted comes to its end, and its result goes to the cache.

use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::{Cache, Job, Ran, Why, compute, distinct, from_cache};
use crate::sources::Digest;

/// Runs experiments on threads of its own.
pub struct Runner {
    threads: usize,
    /// Where what is wanted now runs. What was wanted before goes on where it is, and so does not keep it waiting.
    pool: Option<rayon::ThreadPool>,
    shared: Arc<Shared>,
}

struct Shared {
    queue: Mutex<Queue>,
    cache: Option<Cache>,
    /// Who is told of each result.
    done: Box<dyn Fn(Ran) + Send + Sync>,
}

#[derive(Default)]
struct Queue {
    /// What is to be begun, the heaviest last.
    waiting: Vec<Job>,
    /// What is under way, by the digests of the keys.
    running: BTreeSet<Digest>,
}

impl Runner {
    /// A runner on `threads` threads, which tells `done` of each result.
    pub fn new(threads: usize, cache: Option<Cache>, done: impl Fn(Ran) + Send + Sync + 'static) -> Self {
        let shared = Arc::new(Shared { queue: Mutex::default(), cache, done: Box::new(done) });
        Self { threads: threads.max(1), pool: None, shared }
    }

    /// Wants the results of `jobs` and of no others: what waited is dropped, what is under way is not begun twice.
    pub fn want(&mut self, jobs: Vec<Job>) {
        let mut jobs = distinct(jobs);
        let mut queue = self.shared.queue();
        jobs.retain(|job| !queue.running.contains(&job.key.digest()));
        jobs.sort_by_key(|job| job.experiment.weight());
        let known: BTreeSet<Digest> = queue.waiting.iter().map(|job| job.key.digest()).collect();
        let new = jobs.iter().any(|job| !known.contains(&job.key.digest()));
        let due = jobs.len();
        queue.waiting = jobs;
        drop(queue);
        if new {
            self.begin(due);
        }
    }

    /// Lets threads take the next `due` that wait.
    fn begin(&mut self, due: usize) {
        self.pool = rayon::ThreadPoolBuilder::new().num_threads(self.threads).build().ok();
        for _ in 0..due {
            let shared = Arc::clone(&self.shared);
            match &self.pool {
                Some(pool) => pool.spawn_fifo(move || shared.next()),
                // The system gives no threads: the results are the same without.
                None => shared.next(),
            }
        }
    }
}

impl Shared {
    fn queue(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs the heaviest that waits, if any does.
    fn next(&self) {
        let mut queue = self.queue();
        let Some(job) = queue.waiting.pop() else { return };
        let digest = job.key.digest();
        queue.running.insert(digest);
        drop(queue);
        let cache = self.cache.as_ref();
        // Another process may have been faster.
        let ran = from_cache(&job, cache).unwrap_or_else(|why: Why| compute(&job, cache, why));
        self.queue().running.remove(&digest);
        (self.done)(ran);
    }
}
