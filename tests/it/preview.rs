//! A preview that runs, and what an open page would ask of it and be told by it.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::course::Course;

/// The longest that anything may take on a machine that is busy with other things.
pub const PATIENCE: Duration = Duration::from_secs(90);

/// A preview that ends when it is dropped.
pub struct Served {
    /// The program.
    pub child: Child,
    /// Where it listens.
    pub address: String,
}

impl Served {
    pub fn new(course: &Course) -> Self {
        Self::with(course, &["--port", "0"])
    }

    pub fn with(course: &Course, arguments: &[&str]) -> Self {
        let mut command = course.command(&["serve", "--quiet"]);
        command.args(arguments).stderr(Stdio::null());
        Self::of(command)
    }

    /// The preview that `command` starts.
    pub fn of(mut command: Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.trim().strip_prefix("http://").and_then(|line| line.strip_suffix('/'));
        let address = address.unwrap_or_else(|| panic!("no address but {line:?}")).to_owned();
        Self { child, address }
    }

    pub fn port(&self) -> u16 {
        self.address.rsplit_once(':').unwrap().1.parse().unwrap()
    }

    /// Sends a request as it is; gives the status, the head and the content of the answer.
    pub fn raw(&self, request: &str) -> (u16, String, String) {
        let mut stream = TcpStream::connect(&self.address).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream.write_all(request.as_bytes()).unwrap();
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).unwrap();
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let (head, body) = text.split_once("\r\n\r\n").unwrap_or_else(|| panic!("{request:?}: {text:?}"));
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        (status, head.to_owned(), body.to_owned())
    }

    /// Asks with these lines in the head.
    pub fn ask(&self, target: &str, lines: &str) -> (u16, String, String) {
        self.raw(&format!("GET {target} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n{lines}\r\n", self.address))
    }

    pub fn get(&self, target: &str) -> String {
        let (status, _, body) = self.ask(target, "");
        assert_eq!(status, 200, "{target}: {body}");
        body
    }

    pub fn status(&self, target: &str) -> u16 {
        self.ask(target, "").0
    }

    /// What has changed in a page that was `html`.
    pub fn patch(&self, page: &str, html: &str) -> Vec<Value> {
        let from = html.split("data-digest=\"").nth(1).unwrap().split('"').next().unwrap();
        let answer: Value =
            serde_json::from_str(&self.get(&format!("/.workbook/page?path={page}&from={from}"))).unwrap();
        answer["parts"].as_array().unwrap().clone()
    }

    pub fn events(&self) -> Events {
        let mut stream = TcpStream::connect(&self.address).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        write!(stream, "GET /.workbook/events HTTP/1.1\r\nHost: {}\r\n\r\n", self.address).unwrap();
        Events { lines: BufReader::new(stream), last: Value::Null }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// What an open page is told.
pub struct Events {
    lines: BufReader<TcpStream>,
    /// The last that it was told.
    pub last: Value,
}

impl Events {
    /// The next.
    pub fn next(&mut self) {
        let begun = Instant::now();
        loop {
            let mut line = String::new();
            self.lines.read_line(&mut line).unwrap();
            if let Some(told) = line.strip_prefix("data: ") {
                self.last = serde_json::from_str(told).unwrap();
                return;
            }
            assert!(begun.elapsed() < PATIENCE, "nothing more is told after {}", self.last);
        }
    }

    /// The last, or the next that is `wanted`.
    pub fn until(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        while self.last.is_null() || !wanted(&self.last) {
            self.next();
        }
        self.last.clone()
    }

    /// Once there is a book with nothing more to come, which edition it is.
    pub fn settled(&mut self) -> u64 {
        edition(&self.until(|told| edition(told) > 0 && told["news"]["stale"] == serde_json::json!([])))
    }

    /// The next edition after `before`.
    pub fn after(&mut self, before: u64) -> u64 {
        edition(&self.until(|told| edition(told) > before))
    }

    /// The mistakes, once there are any.
    pub fn mistakes(&mut self) -> Vec<Value> {
        let told = self.until(|told| told["news"]["error_count"].as_u64() > Some(0));
        told["news"]["errors"].as_array().unwrap().clone()
    }

    pub fn mended(&mut self) -> u64 {
        edition(&self.until(|told| told["news"]["error_count"] == 0 && told["news"]["stale"] == serde_json::json!([])))
    }
}

pub fn edition(told: &Value) -> u64 {
    told["edition"].as_u64().unwrap()
}

/// Saves as editors do that put a new file in the place of the old one.
pub fn replace(course: &Course, path: &str, text: &str) {
    course.write("saved~", text);
    fs::rename(course.path("saved~"), course.path(path)).unwrap();
}
