//! `workbook serve`: show the course in a browser, and follow its changes.

use std::net::{IpAddr, Ipv4Addr};
use std::process::{Command, Stdio};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use clap::Args;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use super::{Exit, Options, Readers, report, timings};
use crate::compose::Request;
use crate::diag::{Diagnostic, Place, Severity};
use crate::run::{How, Ran};
use crate::serve::{Settings, Teller, serve};
use crate::workspace::{self, Workspace};

#[derive(Args)]
pub(super) struct Arguments {
    /// The port to listen at, 0 for any that is free [default: 4321, or the next that is free]
    #[arg(long, value_name = "N")]
    port: Option<u16>,
    /// The address to listen at: any but this machine's own for itself lets others read the course
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1", value_parser = host)]
    host: IpAddr,
    /// Open the course in the browser
    #[arg(long)]
    open: bool,
    /// What the place of a mistake links to: an address with {path}, {line} and {column}
    #[arg(long, value_name = "ADDRESS", default_value = "vscode://file/{path}:{line}:{column}", value_parser = editor)]
    editor: String,
    #[command(flatten)]
    readers: Readers,
}

/// Reads an address to listen at.
fn host(written: &str) -> Result<IpAddr, String> {
    if written == "localhost" {
        return Ok(Ipv4Addr::LOCALHOST.into());
    }
    written.parse().map_err(|_| "write it in numbers, such as `127.0.0.1`, or as `localhost`".to_owned())
}

/// Reads what a place links to.
fn editor(written: &str) -> Result<String, String> {
    let scheme = written.split_once(':').map(|(scheme, _)| scheme.to_ascii_lowercase()).unwrap_or_default();
    if scheme.is_empty() || ["javascript", "data"].contains(&scheme.as_str()) || !written.contains("{path}") {
        return Err(
            "write the address that the editor listens to, such as `vscode://file/{path}:{line}:{column}`".to_owned()
        );
    }
    Ok(written.to_owned())
}

pub(super) fn run(arguments: Arguments, options: &Options) -> Exit {
    // Whoever is not in a course's folder has called this in the wrong one.
    let (_, complaints) = workspace::load(&options.root);
    if Exit::of(&complaints) == Exit::Call {
        report::diagnostics(&complaints, &Workspace::default(), options);
        return Exit::Call;
    }
    let stop = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // The second time, whatever is under way ends at once; without either, the system ends the program as it is used to.
        let _ = flag::register_conditional_shutdown(signal, 1, Arc::clone(&stop));
        let _ = flag::register(signal, Arc::clone(&stop));
    }
    let request = Request { audience: arguments.readers.audience, ..options.request() };
    let Arguments { port, host, open, editor, .. } = arguments;
    let teller = Arc::new(Voice { options: options.clone(), open, host, last: Mutex::default() });
    match serve(Settings { request, host, port, editor }, teller, &stop) {
        Ok(()) => {
            report::say("stopped", options);
            Exit::Fine
        }
        Err(error) => {
            report::diagnostics(&[error], &Workspace::default(), options);
            Exit::System
        }
    }
}

/// Tells on the terminal how it goes.
struct Voice {
    options: Options,
    open: bool,
    host: IpAddr,
    /// What was said last of a course in which nothing is wrong.
    last: Mutex<String>,
}

impl Teller for Voice {
    fn serving(&self, address: &str) {
        // Whoever asks for quiet still has to know where.
        report::to_stdout(&format!("{address}\n"));
        if !self.host.is_loopback() {
            report::say("others on your network can read the course there", &self.options);
        }
        report::say("follows the changes of the course; Ctrl-C stops it", &self.options);
        if self.open && !browse(address) {
            report::say(&format!("no browser could be opened: open {address} yourself"), &self.options);
        }
    }

    fn found(&self, found: &[Diagnostic], workspace: &Workspace) {
        let (errors, warnings): (Vec<_>, Vec<_>) =
            found.iter().cloned().partition(|found| found.severity == Severity::Error);
        if !errors.is_empty() {
            report::diagnostics(&errors, workspace, &self.options);
        }
        let warned = match warnings.len() {
            0 => String::new(),
            count => format!(", {}: `workbook check` tells them", report::counted(count, "warning")),
        };
        // Whoever saves ten times need not read ten times that all is well.
        let line = if errors.is_empty() { format!("nothing is wrong{warned}") } else { String::new() };
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if *last != line && !line.is_empty() {
            report::say(&line, &self.options);
        }
        *last = line;
    }

    fn ran(&self, ran: &Ran) {
        if ran.how != How::Cached {
            report::say(&format!("ran {} ({:.0?})", ran.ids.join(", "), ran.time), &self.options);
        }
        if let Some(why) = &ran.unsaved {
            report::say(&format!("the result of {} could not be kept: {why}", ran.ids.join(", ")), &self.options);
        }
    }

    fn took(&self, times: &[(&'static str, Duration)]) {
        timings::tell(times, &[], &self.options);
    }

    fn text(&self, diagnostic: &Diagnostic, workspace: &Workspace) -> String {
        report::plain(diagnostic, workspace)
    }

    fn position(&self, place: &Place, workspace: &Workspace) -> (usize, usize) {
        let (line, column, _) = report::position(place, workspace);
        (line, column)
    }
}

/// Opens an address in the browser; says whether there is one.
fn browse(address: &str) -> bool {
    let program = if cfg!(target_os = "macos") {
        "open"
    } else if cfg!(windows) {
        "explorer"
    } else {
        "xdg-open"
    };
    let mut command = Command::new(program);
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}
