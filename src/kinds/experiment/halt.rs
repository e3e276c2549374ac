//! Breaking off: an experiment whose result nobody wants any more ends at the next piece of its work.

use std::cell::RefCell;
use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

thread_local! {
    /// What can break off the work of this thread.
    static HALT: RefCell<Option<Halt>> = const { RefCell::new(None) };
}

/// A word to an experiment that it need not go on.
#[derive(Debug, Clone, Default)]
pub struct Halt(Arc<AtomicBool>);

impl Halt {
    /// Gives the word.
    pub fn call(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether it was given.
    pub fn is_called(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Whether `other` is a copy of this one.
    pub fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Threads whose work breaks off when the word is given. Errors if the system gives none.
    pub fn pool(
        &self,
        threads: usize, // at least 1
    ) -> Result<ThreadPool, ThreadPoolBuildError> {
        let halt = self.clone();
        let heed = move |_| HALT.set(Some(halt.clone()));
        ThreadPoolBuilder::new().num_threads(threads.max(1)).start_handler(heed).build()
    }
}

/// One piece of parallel work. It unwinds instead of beginning if the experiment is to break off, which only whoever gave the word sees.
pub fn piece<A, B>(work: impl Fn(A) -> B) -> impl Fn(A) -> B {
    move |of| {
        if HALT.with_borrow(|halt| halt.as_ref().is_some_and(Halt::is_called)) {
            resume_unwind(Box::new("nobody wants its result any more"));
        }
        work(of)
    }
}
