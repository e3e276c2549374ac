//! Answering: a thread for each connection, which answers its requests one after the other.

use std::io::{Read as _, Write as _};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use super::desk::Desk;
use super::guard::{self, Rules};
use super::http::{self, Head, NoRequest, Reply};
use super::page::OWN;
use crate::render::{LOST, Looks, of_preview};
use crate::workspace::extension;

/// The most connections at a time.
const MOST: usize = 128;
/// How long a connection may be silent.
const PATIENCE: Duration = Duration::from_secs(30);
/// How long, and how much of, what is refused is heard out.
const PARTING: Duration = Duration::from_secs(1);
const MOST_HEARD: u64 = 1 << 20;
/// How often an open page hears that the server is there.
const PULSE: Duration = Duration::from_secs(4);

/// Answers all who connect.
pub(super) fn all(listener: &TcpListener, desk: &Arc<Desk>, rules: &Rules) {
    let open = Arc::new(AtomicUsize::new(0));
    for stream in listener.incoming() {
        let Ok(mut stream) = stream else {
            // Such as too many open files: it passes.
            std::thread::sleep(Duration::from_millis(20));
            continue;
        };
        let held = Held::new(&open);
        let (desk, rules) = (Arc::clone(desk), rules.clone());
        let begun = std::thread::Builder::new().spawn(move || {
            if held.before >= MOST {
                let _ = http::write(&mut stream, &Reply::refusal(503, "too many pages are open"), false, false);
            } else {
                // Who goes away in the middle misses nothing.
                let _ = connection(stream, &desk, &rules);
            }
        });
        drop(begun);
    }
}

/// One of the open connections, as long as it is held.
struct Held {
    open: Arc<AtomicUsize>,
    before: usize,
}

impl Held {
    fn new(open: &Arc<AtomicUsize>) -> Self {
        Self { open: Arc::clone(open), before: open.fetch_add(1, Ordering::Relaxed) }
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        self.open.fetch_sub(1, Ordering::Relaxed);
    }
}

fn connection(mut stream: TcpStream, desk: &Desk, rules: &Rules) -> std::io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    stream.set_nodelay(true)?;
    let mut buffer = Vec::new();
    loop {
        let head = match http::read(&mut stream, &mut buffer) {
            Ok(head) => head,
            Err(NoRequest::Ended) => return Ok(()),
            Err(NoRequest::Malformed) => return refuse(stream, &Reply::refusal(400, "that is no request"), false),
            Err(NoRequest::TooLong) => {
                return refuse(stream, &Reply::refusal(431, "the head of the request is too long"), false);
            }
        };
        if let Err(refusal) = rules.check(&head) {
            return refuse(stream, &refusal, head.method == "HEAD");
        }
        let head_only = head.method == "HEAD";
        if !head_only && guard::path(&head.target).as_deref() == Some(".workbook/events") {
            return events(&mut stream, desk);
        }
        http::write(&mut stream, &answer(&head, desk), head_only, head.goes_on)?;
        if !head.goes_on {
            return Ok(());
        }
    }
}

/// Refuses, and hears out what was still being sent: else whoever sends it would not hear why.
fn refuse(mut stream: TcpStream, refusal: &Reply, head_only: bool) -> std::io::Result<()> {
    http::write(&mut stream, refusal, head_only, false)?;
    stream.shutdown(Shutdown::Write)?;
    stream.set_read_timeout(Some(PARTING))?;
    std::io::copy(&mut stream.take(MOST_HEARD), &mut std::io::sink()).map(drop)
}

/// Tells an open page of every change, until it goes away.
fn events(stream: &mut TcpStream, desk: &Desk) -> std::io::Result<()> {
    http::write_events(stream)?;
    let mut now = desk.now();
    loop {
        let news = if now.news.is_empty() { "{}" } else { &*now.news };
        stream.write_all(format!("data: {{\"edition\":{},\"news\":{news}}}\n\n", now.edition).as_bytes())?;
        let turn = now.turn;
        loop {
            now = desk.wait(turn, PULSE);
            if now.closed {
                return Ok(());
            }
            if now.turn != turn {
                break;
            }
            // Whether it is still there shows when it is written to.
            stream.write_all(b": here\n\n")?;
        }
    }
}

/// The answer to a request that may be answered.
fn answer(head: &Head, desk: &Desk) -> Reply {
    let Some(path) = guard::path(&head.target) else {
        return Reply::refusal(404, "there is no such path in a book");
    };
    if let Some(name) = path.strip_prefix(OWN) {
        return own(name, &head.target, desk);
    }
    let path = if path.is_empty() { "index.html".to_owned() } else { path };
    if extension(&path) == Some("html") {
        return page(&path, desk);
    }
    match desk.first().proof.and_then(|proof| proof.file(&path)) {
        Some(body) => Reply { status: 200, kind: http::kind_of(&path), body },
        None => Reply::refusal(404, "the book has no such file"),
    }
}

/// The page at this path, or the one that stands for those that are not there.
fn page(path: &str, desk: &Desk) -> Reply {
    let (status, page) = match desk.page(path) {
        Some(page) => (200, page),
        None => match desk.page(LOST) {
            Some(page) => (404, page),
            None => return Reply::refusal(404, "the book has no such page"),
        },
    };
    Reply { status, kind: http::kind_of(".html"), body: page.html(path, &looks(desk)).into_bytes() }
}

fn looks(desk: &Desk) -> Looks {
    desk.now().proof.map(|proof| proof.looks().clone()).unwrap_or_default()
}

/// The files of the preview itself.
fn own(name: &str, target: &str, desk: &Desk) -> Reply {
    match name {
        "live.js" | "live.css" => Reply { status: 200, kind: http::kind_of(name), body: of_preview(name).to_vec() },
        "page" => {
            let path = guard::asked(target, "path").unwrap_or_default();
            let from = guard::asked(target, "from").unwrap_or_default();
            let known = desk.parts(&from);
            match desk.page(&path) {
                Some(page) => Reply {
                    status: 200,
                    kind: http::kind_of(".json"),
                    body: page.patch(&known, &looks(desk)).into_bytes(),
                },
                None => Reply::refusal(404, "the book has no such page"),
            }
        }
        _ => Reply::refusal(404, "there is no such file"),
    }
}
