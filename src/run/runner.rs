//! Running in the background, for whoever does not wait: what is wanted now goes first, and what is no longer wanted is not begun, or
//! broken off if it was.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::{Cache, Job, Ran, Why, compute, distinct, from_cache};
use crate::kinds::Halt;
use crate::sources::Digest;

/// Runs experiments on threads of its own.
pub struct Runner {
    shared: Arc<Shared>,
}

struct Shared {
    queue: Mutex<Queue>,
    /// How many experiments run at a time, and on how many threads each of them does.
    threads: usize,
    cache: Option<Cache>,
    /// Who is told of each result.
    done: Box<dyn Fn(Ran) + Send + Sync>,
}

#[derive(Default)]
struct Queue {
    /// What is to be begun, the heaviest last.
    waiting: Vec<Job>,
    /// What is under way, by the digests of the keys, and what breaks it off.
    running: BTreeMap<Digest, Halt>,
}

impl Runner {
    /// A runner on `threads` threads, which tells `done` of each result.
    pub fn new(threads: usize, cache: Option<Cache>, done: impl Fn(Ran) + Send + Sync + 'static) -> Self {
        let shared = Shared { queue: Mutex::default(), threads: threads.max(1), cache, done: Box::new(done) };
        Self { shared: Arc::new(shared) }
    }

    /// Wants the results of `jobs` and of no others: what waited is dropped, what is under way is not begun twice, and broken off if
    /// it is not among them.
    pub fn want(&mut self, jobs: Vec<Job>) {
        let mut jobs = distinct(jobs);
        let mut queue = self.shared.queue();
        let wanted: BTreeSet<Digest> = jobs.iter().map(|job| job.key.digest()).collect();
        queue.running.iter().filter(|(digest, _)| !wanted.contains(digest)).for_each(|(_, halt)| halt.call());
        jobs.retain(|job| queue.running.get(&job.key.digest()).is_none_or(Halt::is_called));
        jobs.sort_by_key(|job| job.experiment.weight());
        let known: BTreeSet<Digest> = queue.waiting.iter().map(|job| job.key.digest()).collect();
        let new = jobs.iter().any(|job| !known.contains(&job.key.digest()));
        queue.waiting = jobs;
        drop(queue);
        if new {
            self.begin();
        }
    }

    /// Lets threads take what waits. They are new ones, so that what is wanted now is not kept waiting by what was wanted before.
    fn begin(&self) {
        for _ in 0..self.shared.threads {
            let shared = Arc::clone(&self.shared);
            let begun = std::thread::Builder::new().spawn(move || while shared.next() {});
            if begun.is_err() {
                // The system gives no threads: the results are the same without.
                while self.shared.next() {}
            }
        }
    }
}

impl Shared {
    fn queue(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs the heaviest that waits; says whether there was any.
    fn next(&self) -> bool {
        let mut queue = self.queue();
        let Some(job) = queue.waiting.pop() else { return false };
        let (digest, halt) = (job.key.digest(), Halt::default());
        queue.running.insert(digest, halt.clone());
        drop(queue);
        let cache = self.cache.as_ref();
        // Another process may have been faster.
        let ran = from_cache(&job, cache).unwrap_or_else(|why: Why| match halt.pool(self.threads) {
            Ok(pool) => pool.install(|| compute(&job, cache, why)),
            Err(_) => compute(&job, cache, why),
        });
        let mut queue = self.queue();
        // It may have been wanted again while it was breaking off, and be under way a second time.
        if queue.running.get(&digest).is_some_and(|known| known.is(&halt)) {
            queue.running.remove(&digest);
        }
        drop(queue);
        if ran.outcome.is_ok() || !halt.is_called() {
            (self.done)(ran);
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::{RecvTimeoutError, channel};
    use std::time::Duration;

    use rayon::prelude::*;

    use super::*;
    use crate::catalogue::About;
    use crate::chart::{Drawing, Sheet};
    use crate::kinds::{AnyKind, Experiment, Failure, Frame, Outcome, Values, find, piece};
    use crate::seed::Seed;

    const PATIENCE: Duration = Duration::from_secs(30);

    /// An experiment of so many pieces, each of which tells that it has begun.
    struct Pieces {
        count: usize,
        begun: Mutex<std::sync::mpsc::Sender<usize>>,
    }

    impl Experiment for Pieces {
        fn kind(&self) -> &'static dyn AnyKind {
            find("points").unwrap()
        }
        fn parameters(&self) -> serde_json::Value {
            serde_json::json!({ "count": self.count })
        }
        fn abouts(&self) -> Vec<&'static About> {
            Vec::new()
        }
        fn weight(&self) -> u64 {
            self.count as u64
        }
        fn run(&self, _seed: Seed) -> Result<Outcome, Failure> {
            let one = |at: usize| {
                let _ = self.begun.lock().unwrap().send(at);
                std::thread::sleep(Duration::from_millis(10));
            };
            (0..self.count).into_par_iter().with_max_len(1).map(piece(one)).collect::<()>();
            Ok(Outcome { bytes: Vec::new(), values: Values::default() })
        }
        fn revive(&self, _bytes: Vec<u8>) -> Option<Outcome> {
            None
        }
        fn draw(&self, _outcome: &Outcome, _sheet: &Sheet) -> Result<Drawing, Failure> {
            unreachable!()
        }
        fn alt(&self, _outcome: &Outcome) -> Option<String> {
            None
        }
        fn tables(&self, _outcome: &Outcome) -> Vec<Frame> {
            Vec::new()
        }
    }

    #[test]
    fn what_is_no_longer_wanted_is_broken_off_and_not_told() {
        let (done, results) = channel();
        let mut runner = Runner::new(2, None, move |ran| drop(done.send(ran.key)));
        let (begun, pieces) = channel();
        // It would run for minutes.
        let (long, short) = (Pieces { count: 30_000, begun: Mutex::new(begun) }, channel());
        let short = Pieces { count: 3, begun: Mutex::new(short.0) };
        let job = |experiment: Pieces| Job::new(vec!["fig".into()], Arc::new(experiment), 1);
        runner.want(vec![job(long)]);
        pieces.recv_timeout(PATIENCE).unwrap();
        let short = job(short);
        let wanted = short.key.digest();
        runner.want(vec![short]);
        assert_eq!(results.recv_timeout(PATIENCE).unwrap().digest(), wanted);
        // The sender of its pieces goes with the experiment.
        while pieces.recv_timeout(PATIENCE).is_ok() {}
        assert_eq!(pieces.recv_timeout(PATIENCE), Err(RecvTimeoutError::Disconnected));
        assert!(results.recv_timeout(Duration::from_millis(50)).is_err());
        assert!(runner.shared.queue().running.is_empty());
    }
}
