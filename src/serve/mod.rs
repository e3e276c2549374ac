//! Serving: a course as pages that follow its author, on this machine only.
//!
//! The disk is not written, but for the cache of results. A thread watches the course's folders and makes one *proof* of the book after the
//! other (`session`, `work`); each page is rendered when a browser asks for it (`desk`, `page`), and an open page asks for what has changed
//! whenever it is told that there is a new proof (`answer`, and `live.js` in the browser). The protocol is that of plain HTTP (`http`), and
//! what does not come from a page of this very server is refused (`guard`).

mod answer;
mod desk;
mod guard;
mod http;
mod news;
mod page;
mod session;
mod work;

use std::net::{IpAddr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::compose::Request;
use crate::diag::{Code, Diagnostic, Place};
use crate::run::Ran;
use crate::workspace::Workspace;

use desk::Desk;

/// The usual port, and how many behind it are tried if it is taken.
pub const PORT: u16 = 4321;
const TRIED: u16 = 50;

/// How often it is seen whether the server is to stop.
const PULSE: Duration = Duration::from_millis(50);

/// What is served, and where.
#[derive(Debug, Clone)]
pub struct Settings {
    /// The course.
    pub request: Request,
    /// The address to listen at.
    pub host: IpAddr,
    /// The port, if it must be this one; else the usual one or the next that is free.
    pub port: Option<u16>,
    /// What a place in a file links to, with `{path}`, `{line}` and `{column}`.
    pub editor: String,
}

/// Who tells people how it goes.
pub trait Teller: Send + Sync {
    /// The server listens at this address.
    fn serving(&self, address: &str);
    /// This is wrong with the course now; it is told whenever it has changed.
    fn found(&self, found: &[Diagnostic], workspace: &Workspace);
    /// An experiment has run.
    fn ran(&self, ran: &Ran);
    /// The book was made anew, and its stages took so long.
    fn took(&self, times: &[(&'static str, Duration)]);
    /// A diagnostic as the terminal has it.
    fn text(&self, diagnostic: &Diagnostic, workspace: &Workspace) -> String;
    /// The line and the column of a place, from 1.
    fn position(&self, place: &Place, workspace: &Workspace) -> (usize, usize);
}

/// Serves until `stop` is set. What keeps it from beginning is an error.
pub fn serve(settings: Settings, teller: Arc<dyn Teller>, stop: &AtomicBool) -> Result<(), Diagnostic> {
    let listener = listen(settings.host, settings.port)?;
    let address = listener.local_addr().map_err(|error| refused(&error.to_string()))?;
    let desk = Arc::new(Desk::default());
    let rules = guard::Rules::new(address);
    {
        let (desk, rules) = (Arc::clone(&desk), rules.clone());
        std::thread::spawn(move || answer::all(&listener, &desk, &rules));
    }
    teller.serving(&format!("http://{}/", rules.address()));
    {
        let desk = Arc::clone(&desk);
        std::thread::spawn(move || work::work(&settings, teller.as_ref(), &desk));
    }
    while !stop.load(Ordering::Relaxed) {
        std::thread::sleep(PULSE);
    }
    desk.close();
    Ok(())
}

/// Listens at the port that is asked for, or else at the first free one from the usual one on.
fn listen(host: IpAddr, port: Option<u16>) -> Result<TcpListener, Diagnostic> {
    if let Some(port) = port {
        let address = SocketAddr::new(host, port);
        return TcpListener::bind(address).map_err(|error| {
            let help = match error.kind() {
                std::io::ErrorKind::AddrInUse => {
                    "another program listens there; leave `--port` out, and a free port is found"
                }
                std::io::ErrorKind::PermissionDenied => {
                    "ports below 1024 are for the system; name one above, or leave `--port` out"
                }
                _ => "name an address of this machine with `--host`, or leave it out",
            };
            refused(&format!("{address}: {error}")).help(help)
        });
    }
    let mut last = None;
    for port in PORT..PORT + TRIED {
        match TcpListener::bind(SocketAddr::new(host, port)) {
            Ok(listener) => return Ok(listener),
            Err(error) => last = Some(error),
        }
    }
    let why = last.map(|error| error.to_string()).unwrap_or_default();
    let error = refused(&format!("{host}, ports {PORT} to {}: {why}", PORT + TRIED - 1));
    Err(error.help("name another port with `--port`, or an address of this machine with `--host`"))
}

fn refused(why: &str) -> Diagnostic {
    Diagnostic::error(Code::Address, format!("the course cannot be served at {why}"))
}
