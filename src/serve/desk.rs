//! The desk: the last good proof of the book and the news of it, between the thread that makes them and those that answer.

use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use super::page::{Page, blank};
use crate::render::Proof;
use crate::sources::Digest;

/// Of how many pages that were served it is known what they consisted of.
const REMEMBERED: usize = 64;

/// How long it may take until there is anything to be served.
const BEGINNING: Duration = Duration::from_secs(20);

/// What there is to be served.
#[derive(Default)]
pub(super) struct Desk {
    now: Mutex<Now>,
    changed: Condvar,
    pages: Mutex<Pages>,
}

/// The state of the preview.
#[derive(Clone, Default)]
pub(super) struct Now {
    /// How many times it has changed.
    pub turn: u64,
    /// How many proofs there have been.
    pub edition: u64,
    /// The last good proof.
    pub proof: Option<Arc<Proof>>,
    /// What browsers are told, as JSON without the edition.
    pub news: Arc<str>,
    /// Whether the server ends.
    pub closed: bool,
}

/// Pages that have been rendered.
#[derive(Default)]
struct Pages {
    /// Of which proof those are that need not be rendered again.
    edition: u64,
    rendered: BTreeMap<String, Arc<Page>>,
    /// What pages consisted of, by their digests, the last one last.
    served: VecDeque<(String, Vec<Digest>)>,
}

/// What is held, even if a thread that held it broke off.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Desk {
    /// The state.
    pub fn now(&self) -> Now {
        lock(&self.now).clone()
    }

    /// The state once there is any: a course that has just begun to be read takes a moment.
    pub fn first(&self) -> Now {
        self.wait(0, BEGINNING)
    }

    /// Puts a new proof on the desk, if there is one, and the news.
    pub fn put(&self, proof: Option<Arc<Proof>>, news: &str) {
        let mut now = lock(&self.now);
        if proof.is_some() {
            now.proof = proof;
            now.edition += 1;
        }
        now.news = news.into();
        now.turn += 1;
        drop(now);
        self.changed.notify_all();
    }

    /// Ends all that waits.
    pub fn close(&self) {
        lock(&self.now).closed = true;
        self.changed.notify_all();
    }

    /// The state once it is another than that of `turn`, or after `time`.
    pub fn wait(&self, turn: u64, time: Duration) -> Now {
        let same = |now: &mut Now| now.turn == turn && !now.closed;
        let waited = self.changed.wait_timeout_while(lock(&self.now), time, same);
        waited.unwrap_or_else(PoisonError::into_inner).0.clone()
    }

    /// The page at `path` as it is now; none if the book has none there.
    pub fn page(&self, path: &str) -> Option<Arc<Page>> {
        let Now { proof, edition, .. } = self.first();
        let Some(proof) = proof else { return Some(Arc::new(blank("There is no book yet."))) };
        let known = {
            let pages = lock(&self.pages);
            (pages.edition == edition).then(|| pages.rendered.get(path).cloned()).flatten()
        };
        if let Some(page) = known {
            return Some(page);
        }
        // Rendered without holding anything, so that others need not wait.
        let (text, _) = proof.page(path)?;
        // A template that is broken gives nothing.
        let page =
            if text.is_empty() { Arc::new(blank("This page cannot be made.")) } else { Arc::new(Page::new(text)) };
        let mut pages = lock(&self.pages);
        if pages.edition < edition {
            pages.edition = edition;
            pages.rendered.clear();
        }
        if pages.edition == edition {
            pages.rendered.insert(path.to_owned(), Arc::clone(&page));
        }
        pages.served.retain(|(digest, _)| digest != page.digest());
        pages.served.push_back((page.digest().to_owned(), page.digests().to_vec()));
        if pages.served.len() > REMEMBERED {
            pages.served.pop_front();
        }
        Some(page)
    }

    /// What the page with this digest consisted of; nothing if that is not known.
    pub fn parts(&self, digest: &str) -> Vec<Digest> {
        let pages = lock(&self.pages);
        pages.served.iter().find(|(known, _)| known == digest).map(|(_, parts)| parts.clone()).unwrap_or_default()
    }
}
