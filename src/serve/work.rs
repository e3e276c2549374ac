//! The thread that makes the book: it waits for changes and results, and puts what follows from them on the desk.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use super::desk::Desk;
use super::news::{self, Editor, State};
use super::session::{Session, Update};
use super::{Settings, Teller};
use crate::diag::{Code, Diagnostic};
use crate::render::Proof;
use crate::run::{Ran, Runner};
use crate::verify;
use crate::workspace::Workspace;
use crate::workspace::watch::Watch;

/// After how much quiet the whole book is looked through, and it is seen whether the folders are still in their places.
const QUIET: Duration = Duration::from_millis(400);
/// How long files must rest after a change, since an editor may write several, or one in pieces.
const REST: Duration = Duration::from_millis(6);
/// And how many times at most, while more and more changes come.
const RESTS: usize = 8;

/// What the thread waits for.
enum Message {
    /// Something may have changed.
    Files,
    /// An experiment has run.
    Ran(Box<Ran>),
    /// The whole book of this turn has been looked through, and this was found.
    Looked(u64, Vec<Diagnostic>),
}

/// Makes the book of the course whenever it changes.
pub(super) fn work(settings: &Settings, teller: &dyn Teller, desk: &Desk) {
    let (sender, receiver) = channel();
    let request = &settings.request;
    let runner = {
        let sender = sender.clone();
        // The thread lives as long as the program.
        Runner::new(request.threads, request.cache(), move |ran| drop(sender.send(Message::Ran(Box::new(ran)))))
    };
    let watch = {
        let sender = sender.clone();
        Watch::new(&request.root, move || drop(sender.send(Message::Files)))
    };
    let editor = Editor::new(&request.root, &settings.editor);
    let mut worker = Worker {
        session: Session::new(request.clone()),
        teller,
        desk,
        runner,
        watch,
        editor,
        told: Vec::new(),
        last: None,
        turn: Arc::default(),
    };
    if worker.watch.blind() {
        teller.found(&[blind()], &Workspace::default());
    }
    worker.make(true, false);
    worker.follow(&receiver, &sender);
}

struct Worker<'a> {
    session: Session,
    teller: &'a dyn Teller,
    desk: &'a Desk,
    runner: Runner,
    watch: Watch,
    editor: Editor,
    /// What was told last.
    told: Vec<Diagnostic>,
    /// What was put on the desk last, if the course was not too wrong for a book.
    last: Option<Latest>,
    /// How many times something was put on the desk.
    turn: Arc<AtomicU64>,
}

/// An update, but for what is to be run.
struct Latest {
    proof: Arc<Proof>,
    found: Vec<Diagnostic>,
    workspace: Arc<Workspace>,
    stale: Vec<String>,
    /// Whether its whole book is looked through, or has been.
    looked: bool,
}

impl Worker<'_> {
    /// Waits for what comes, and makes what follows from it.
    fn follow(&mut self, receiver: &Receiver<Message>, sender: &Sender<Message>) {
        loop {
            match receiver.recv_timeout(QUIET) {
                Ok(first) => {
                    let (files, results) = self.gather(first, receiver);
                    if files {
                        self.watch.look();
                    }
                    if files || results {
                        self.make(files, results);
                    }
                }
                Err(RecvTimeoutError::Timeout) => {
                    if self.watch.look() || self.watch.blind() {
                        self.make(true, false);
                    }
                    self.look_through(sender);
                }
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
    }

    /// Takes all that has come: says whether files may have changed, and whether there are results that are wanted.
    fn gather(&mut self, first: Message, receiver: &Receiver<Message>) -> (bool, bool) {
        let (mut files, mut results) = (false, false);
        let mut next = Some(first);
        for _ in 0..=RESTS {
            let mut more = false;
            while let Some(message) = next.take().or_else(|| receiver.try_recv().ok()) {
                match message {
                    Message::Files => more = true,
                    Message::Ran(ran) => {
                        self.teller.ran(&ran);
                        results |= self.session.take(&ran);
                    }
                    Message::Looked(turn, told) => self.looked(turn, told),
                }
            }
            files |= more;
            if !more {
                break;
            }
            std::thread::sleep(REST);
        }
        (files, results)
    }

    /// Makes the book anew, if `files` have changed or there are new `results`.
    fn make(&mut self, files: bool, results: bool) {
        let made = catch_unwind(AssertUnwindSafe(|| {
            let new = files && self.session.read();
            if new || results { self.session.update() } else { None }
        }));
        match made {
            Ok(Some(update)) => self.put(update),
            Ok(None) => {}
            Err(_) => {
                // What was half done is not to be trusted.
                let found = Diagnostic::error(
                    Code::Failed,
                    "the preview broke off: this is a mistake in the workbook generator",
                );
                let found = [found.help("it goes on with the next change of the course")];
                self.tell(&found, &Workspace::default(), &[], None);
            }
        }
    }

    /// Puts what has been made on the desk, then runs what is due.
    fn put(&mut self, update: Update) {
        let Update { proof, found, workspace, stale, due, times } = update;
        self.teller.took(&times);
        self.turn.fetch_add(1, Ordering::Relaxed);
        self.tell(&found, &workspace, &stale, proof.clone());
        if let Some(due) = due {
            self.runner.want(due);
        }
        self.last = proof.map(|proof| Latest { proof, found, workspace, stale, looked: false });
    }

    fn tell(&mut self, found: &[Diagnostic], workspace: &Workspace, stale: &[String], proof: Option<Arc<Proof>>) {
        self.desk.put(proof, &news::text(&State { found, workspace, stale }, self.teller, &self.editor));
        if self.told != found {
            self.teller.found(found, workspace);
            self.told = found.to_vec();
        }
    }

    /// Looks through the whole book as a build does, in a thread of its own that ends as soon as there is another book.
    fn look_through(&mut self, sender: &Sender<Message>) {
        let Some(latest) = self.last.as_ref().filter(|latest| !latest.looked && latest.stale.is_empty()) else {
            return;
        };
        let (proof, turn, sender) = (Arc::clone(&latest.proof), Arc::clone(&self.turn), sender.clone());
        let of = turn.load(Ordering::Relaxed);
        if let Some(latest) = &mut self.last {
            latest.looked = true;
        }
        std::thread::spawn(move || {
            let go_on = || turn.load(Ordering::Relaxed) == of;
            if let Some((book, mut told)) = proof.book(&go_on) {
                told.extend(verify::book(&book, &proof.parts().course));
                let _ = sender.send(Message::Looked(of, told));
            }
        });
    }

    /// Tells what was found in the whole book of a turn, if that is still the last.
    fn looked(&mut self, turn: u64, told: Vec<Diagnostic>) {
        if turn != self.turn.load(Ordering::Relaxed) || told.is_empty() {
            return;
        }
        let Some(Latest { found, workspace, stale, .. }) = self.last.as_mut() else { return };
        found.extend(told);
        let (found, workspace, stale) = (found.clone(), Arc::clone(workspace), stale.clone());
        self.tell(&found, &workspace, &stale, None);
    }
}

/// What to tell where the system does not tell of changes.
fn blind() -> Diagnostic {
    let told = Diagnostic::warning(
        Code::Address,
        "the system does not tell when files change: they are looked at now and then",
    );
    told.help("on Linux, `fs.inotify.max_user_watches` and `max_user_instances` say how many folders can be watched")
}
