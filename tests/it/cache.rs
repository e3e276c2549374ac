//! Running and the cache: each experiment runs once, the same on any number of threads, and nothing broken is trusted.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use rayon::prelude::*;
use workbook::catalogue::About;
use workbook::chart::Drawing;
use workbook::chart::Sheet;
use workbook::kinds::{AnyKind, Experiment, Failure, Frame, KINDS, Outcome, Values};
use workbook::run::cache::Found;
use workbook::run::{Cache, How, Job, Key, Observer, Ran, Why, run, status, unsaved};
use workbook::seed::Seed;
use workbook::sources::Digest;

/// What the fake experiment does when it runs.
#[derive(Clone, Copy, PartialEq)]
enum Act {
    Sum,
    Fail,
    Panic,
}

/// An experiment that counts how often it runs.
struct Fake {
    n: u64,
    act: Act,
    runs: AtomicUsize,
}

impl Experiment for Fake {
    fn kind(&self) -> &'static dyn AnyKind {
        KINDS[0]
    }

    fn parameters(&self) -> serde_json::Value {
        serde_json::json!({ "n": self.n })
    }

    fn abouts(&self) -> Vec<&'static About> {
        vec![KINDS[0].about()]
    }

    fn weight(&self) -> u64 {
        self.n
    }

    fn run(&self, seed: Seed) -> Result<Outcome, Failure> {
        self.runs.fetch_add(1, Ordering::SeqCst);
        match self.act {
            Act::Sum => {
                let terms: Vec<f64> = (1..=self.n).into_par_iter().map(|i| 1.0 / i as f64).collect();
                let sum: f64 = terms.iter().sum();
                let text = format!("{sum:?} {seed:?}");
                self.revive(text.into_bytes()).ok_or_else(|| failure("no text"))
            }
            Act::Fail => Err(failure("it cannot be")),
            Act::Panic => panic!("index out of bounds"),
        }
    }

    fn revive(&self, bytes: Vec<u8>) -> Option<Outcome> {
        let text = std::str::from_utf8(&bytes).ok()?;
        assert!(!text.contains("poison"), "a reviver that panics");
        let sum: f64 = text.split_once(' ')?.0.parse().ok()?;
        let mut values = Values::new();
        values.number("sum", sum);
        Some(Outcome { bytes, values })
    }

    fn draw(&self, _: &Outcome, _: &Sheet) -> Result<Drawing, Failure> {
        Err(failure("it cannot be drawn"))
    }

    fn alt(&self, _: &Outcome) -> Option<String> {
        None
    }

    fn tables(&self, _: &Outcome) -> Vec<Frame> {
        Vec::new()
    }
}

fn failure(message: &str) -> Failure {
    Failure { parameter: None, message: message.to_owned(), help: None }
}

fn fake(n: u64, act: Act) -> Arc<Fake> {
    Arc::new(Fake { n, act, runs: AtomicUsize::new(0) })
}

fn key(n: u64) -> Key {
    Key {
        format: 1,
        kind: "fake".into(),
        parameters: serde_json::json!({ "n": n }),
        seed: 7,
        code: BTreeMap::from([("kinds/fake.rs".into(), Digest::of(b"code"))]),
        engine: Digest::of(b"engine"),
        dependencies: Digest::of(b"dependencies"),
    }
}

fn job(id: &str, fake: &Arc<Fake>) -> Job {
    Job { ids: vec![id.to_owned()], experiment: Arc::<Fake>::clone(fake), seed: 7, key: key(fake.n) }
}

/// An empty folder for the test `name`.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("cache").join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn once(id: &str, fake: &Arc<Fake>, cache: Option<&Cache>) -> Ran {
    let mut ran = run(vec![job(id, fake)], cache, 2, &());
    assert_eq!(ran.len(), 1);
    ran.remove(0)
}

fn bytes(ran: &Ran) -> Vec<u8> {
    ran.outcome.as_ref().unwrap().bytes.clone()
}

#[test]
fn a_result_is_computed_once_and_kept() {
    let cache = Cache::new(folder("kept"));
    let fake = fake(100, Act::Sum);
    assert_eq!(status(&job("fig-a", &fake), Some(&cache)), How::Computed(Why::New));
    let first = once("fig-a", &fake, Some(&cache));
    let second = once("fig-a", &fake, Some(&cache));
    assert_eq!((first.how.clone(), second.how.clone()), (How::Computed(Why::New), How::Cached));
    assert_eq!(bytes(&first), bytes(&second));
    assert_eq!(first.outcome.unwrap().values, second.outcome.unwrap().values);
    assert_eq!(fake.runs.load(Ordering::SeqCst), 1);
    assert_eq!(once("fig-a", &fake, None).how, How::Computed(Why::NoCache));
    assert_eq!(cache.latest("fig-a"), Some(key(100)));
    assert_eq!(cache.latest("fig-b"), None);
}

#[test]
fn equal_keys_run_once() {
    let (one, two) = (fake(10, Act::Sum), fake(10, Act::Sum));
    let jobs = vec![job("fig-b", &one), job("fig-c", &fake(11, Act::Sum)), job("fig-a", &two), job("fig-b", &one)];
    let ran = run(jobs, None, 4, &());
    assert_eq!(ran.iter().map(|ran| ran.ids.join("+")).collect::<Vec<_>>(), ["fig-a+fig-b", "fig-c"]);
    assert_eq!(one.runs.load(Ordering::SeqCst) + two.runs.load(Ordering::SeqCst), 1);
}

#[test]
fn threads_change_nothing() {
    let results = |threads: usize, cache: Option<&Cache>| {
        let jobs = (0..40).map(|n| job(&format!("fig-{n}"), &fake(n * 37 % 1000 + 1, Act::Sum))).collect();
        run(jobs, cache, threads, &()).iter().map(|ran| (ran.ids.clone(), bytes(ran))).collect::<Vec<_>>()
    };
    let cache = Cache::new(folder("threads"));
    let one = results(1, None);
    assert_eq!(one, results(4, None));
    assert_eq!(one, results(4, Some(&cache)));
    assert_eq!(one, results(3, Some(&cache)));
    assert_eq!(one, results(0, Some(&cache)));
}

/// Writes down what it is told.
#[derive(Default)]
struct Log(Mutex<Vec<String>>);

impl Observer for Log {
    fn planned(&self, cached: usize, due: usize) {
        self.0.lock().unwrap().push(format!("{cached} cached, {due} due"));
    }

    fn started(&self, job: &Job) {
        self.0.lock().unwrap().push(format!("start {}", job.ids.join("+")));
    }

    fn finished(&self, ran: &Ran) {
        self.0.lock().unwrap().push(format!("end {}", ran.ids.join("+")));
    }
}

#[test]
fn the_heaviest_starts_first_and_each_is_told() {
    let cache = Cache::new(folder("told"));
    once("fig-a", &fake(5, Act::Sum), Some(&cache));
    let log = Log::default();
    let jobs = vec![
        job("fig-light", &fake(1, Act::Sum)),
        job("fig-a", &fake(5, Act::Sum)),
        job("fig-heavy", &fake(1000, Act::Sum)),
        job("fig-middle", &fake(30, Act::Sum)),
    ];
    run(jobs, Some(&cache), 1, &log);
    let told = log.0.into_inner().unwrap();
    assert_eq!(told[..2], ["1 cached, 3 due", "end fig-a"]);
    let started: Vec<&str> = told.iter().filter_map(|line| line.strip_prefix("start ")).collect();
    assert_eq!(started, ["fig-heavy", "fig-middle", "fig-light"]);
    assert_eq!(told.len(), 2 + 6);
}

#[test]
fn failures_are_not_kept() {
    let cache = Cache::new(folder("failures"));
    for _ in 0..2 {
        let ran = once("fig-a", &fake(3, Act::Fail), Some(&cache));
        assert_eq!(ran.outcome.unwrap_err(), failure("it cannot be"));
        assert_eq!(ran.how, How::Computed(Why::New));
    }
    assert_eq!(cache.entries(), []);
}

#[test]
fn a_panic_is_a_failure_that_names_the_experiment() {
    let jobs = vec![job("fig-bad", &fake(3, Act::Panic)), job("fig-good", &fake(4, Act::Sum))];
    let ran = run(jobs, None, 2, &());
    let failure = ran[0].outcome.as_ref().unwrap_err();
    assert_eq!(failure.message, "the experiment of fig-bad (`fake`) broke off: index out of bounds");
    assert!(ran[1].outcome.is_ok());
}

/// The file of the result for `n`.
fn entry(folder: &std::path::Path, n: u64) -> PathBuf {
    folder.join("results").join(key(n).digest().to_string())
}

#[test]
fn nothing_broken_is_trusted_and_all_is_mended() {
    let folder = folder("broken");
    let cache = Cache::new(&folder);
    let fake = fake(9, Act::Sum);
    let good = bytes(&once("fig-a", &fake, Some(&cache)));
    let file = entry(&folder, 9);
    let whole = fs::read(&file).unwrap();
    let mut broken: Vec<Vec<u8>> = (0..whole.len()).map(|length| whole[..length].to_vec()).collect();
    broken.extend((0..whole.len()).map(|at| {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x20;
        bytes
    }));
    broken.push([whole.as_slice(), b"!"].concat());
    for bytes in broken {
        fs::write(&file, &bytes).unwrap();
        assert_eq!(cache.read(&key(9)), Found::Damaged);
    }
    let ran = once("fig-a", &fake, Some(&cache));
    assert_eq!((ran.how.clone(), bytes(&ran)), (How::Computed(Why::Damaged), good));
    assert_eq!(fs::read(&file).unwrap(), whole);
}

#[test]
fn another_key_under_the_right_name_is_refused() {
    let folder = folder("another");
    let cache = Cache::new(&folder);
    once("fig-a", &fake(1, Act::Sum), Some(&cache));
    once("fig-b", &fake(2, Act::Sum), Some(&cache));
    fs::copy(entry(&folder, 1), entry(&folder, 2)).unwrap();
    assert_eq!(once("fig-b", &fake(2, Act::Sum), Some(&cache)).how, How::Computed(Why::Damaged));
    assert_eq!(once("fig-b", &fake(2, Act::Sum), Some(&cache)).how, How::Cached);
}

#[test]
fn bytes_that_do_not_revive_are_refused() {
    let cache = Cache::new(folder("revive"));
    for bytes in [&b"no number"[..], b"\xff\xff", b"", b"poison 1"] {
        cache.write(&key(6), bytes).unwrap();
        assert_eq!(once("fig-a", &fake(6, Act::Sum), Some(&cache)).how, How::Computed(Why::Damaged));
        assert_eq!(once("fig-a", &fake(6, Act::Sum), Some(&cache)).how, How::Cached);
    }
}

#[test]
fn a_miss_says_why() {
    let folder = folder("why");
    let cache = Cache::new(&folder);
    once("fig-a", &fake(1, Act::Sum), Some(&cache));
    let How::Computed(Why::Changed(difference)) = once("fig-a", &fake(2, Act::Sum), Some(&cache)).how else {
        panic!("the parameter changed")
    };
    assert_eq!(difference.to_string(), "parameters.n: 1 -> 2");
    fs::remove_file(entry(&folder, 2)).unwrap();
    assert_eq!(once("fig-a", &fake(2, Act::Sum), Some(&cache)).how, How::Computed(Why::Gone));
    // Undone: nothing runs, and it is the latest again.
    assert_eq!(once("fig-a", &fake(1, Act::Sum), Some(&cache)).how, How::Cached);
    assert_eq!(cache.latest("fig-a"), Some(key(1)));
}

#[test]
fn a_cache_that_cannot_be_written_is_a_warning() {
    let folder = folder("unwritable");
    fs::create_dir_all(folder.parent().unwrap()).unwrap();
    fs::write(&folder, "a file where the folder should be").unwrap();
    let ran = run(vec![job("fig-a", &fake(5, Act::Sum))], Some(&Cache::new(&folder)), 1, &());
    assert!(ran[0].outcome.is_ok() && ran[0].unsaved.is_some(), "{ran:?}");
    let warning = unsaved(&ran).unwrap();
    assert!(warning.message.starts_with("1 of 1 results could not be kept"), "{warning:?}");
    assert!(!warning.message.contains("unwritable"), "{warning:?}");
    fs::remove_file(&folder).unwrap();
}

#[test]
fn writers_at_the_same_time_do_no_harm() {
    let folder = folder("concurrent");
    let cache = Cache::new(&folder);
    let results: Vec<Vec<u8>> = (0..8_u8).map(|writer| vec![b'0' + writer; 50_000]).collect();
    std::thread::scope(|scope| {
        for result in &results {
            let cache = cache.clone();
            scope.spawn(move || {
                for n in 0..20 {
                    cache.write(&key(n % 3), result).unwrap();
                    cache.note("fig-a", &key(n % 3)).unwrap();
                    let Found::Whole(read) = cache.read(&key(n % 3)) else { panic!("a whole result was there") };
                    assert!(results_contain(&read));
                    assert!(cache.latest("fig-a").is_some());
                }
            });
        }
    });
    let left = fs::read_dir(folder.join("results")).unwrap().count();
    assert_eq!(left, 3, "nothing is left beside the results");
}

fn results_contain(read: &[u8]) -> bool {
    read.len() == 50_000 && read.iter().all(|byte| *byte == read[0])
}

#[test]
fn ids_that_are_no_file_names_are_kept_apart() {
    let cache = Cache::new(folder("ids"));
    let long = "x".repeat(300);
    let ids = ["fig-a", "fig-A", "../../fig", "fig/..", "", "fig-é", ".", "con\0", &long];
    for (n, id) in (0..).zip(ids) {
        cache.note(id, &key(n)).unwrap();
    }
    for (n, id) in (0..).zip(ids) {
        assert_eq!(cache.latest(id), Some(key(n)), "{id}");
    }
}

#[test]
fn stale_entries_are_listed_and_removed() {
    let folder = folder("stale");
    let cache = Cache::new(&folder);
    for n in 0..4 {
        once(&format!("fig-{n}"), &fake(n, Act::Sum), Some(&cache));
    }
    fs::write(folder.join("results").join("note.txt"), "not an entry").unwrap();
    let live: BTreeSet<Digest> = [key(1).digest(), key(2).digest()].into();
    let stale = cache.stale(&live);
    assert_eq!((cache.entries().len(), stale.len()), (4, 2));
    assert!(cache.size() > stale.iter().map(|entry| entry.size).sum());
    cache.remove(&stale).unwrap();
    cache.remove(&stale).unwrap();
    assert_eq!(cache.stale(&live), []);
    assert_eq!(once("fig-1", &fake(1, Act::Sum), Some(&cache)).how, How::Cached);
}

#[test]
fn clean_removes_what_the_cache_wrote_and_nothing_else() {
    let folder = folder("clean");
    let cache = Cache::new(&folder);
    once("fig-a", &fake(1, Act::Sum), Some(&cache));
    fs::write(folder.join("mine.txt"), "kept").unwrap();
    cache.clean().unwrap();
    cache.clean().unwrap();
    assert_eq!((cache.entries().len(), cache.size()), (0, 0));
    assert_eq!(fs::read_to_string(folder.join("mine.txt")).unwrap(), "kept");
    fs::remove_file(folder.join("mine.txt")).unwrap();
    once("fig-a", &fake(1, Act::Sum), Some(&cache));
    cache.clean().unwrap();
    assert!(!folder.exists());
}
