//! As much of HTTP/1.1 as pages of one's own machine need: requests without bodies, answers with lengths, one after the other.

use std::io::{self, Read, Write};
use std::net::TcpStream;

/// The longest head of a request, and the most lines of it.
const LONGEST: usize = 16 * 1024;
const LINES: usize = 100;

/// The head of a request.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Head {
    /// `GET`, ...
    pub method: String,
    /// What is asked for, as it was sent.
    pub target: String,
    /// Whether the connection goes on.
    pub goes_on: bool,
    /// Whether something follows the head.
    pub has_body: bool,
    lines: Vec<(String, String)>,
}

impl Head {
    /// The value of a line of the head; none if it is not there once.
    pub fn get(&self, name: &str) -> Option<&str> {
        let mut found = self.lines.iter().filter(|(known, _)| known == name);
        found.next().filter(|_| found.next().is_none()).map(|(_, value)| value.as_str())
    }

    /// Whether a line of the head is there.
    pub fn has(&self, name: &str) -> bool {
        self.lines.iter().any(|(known, _)| known == name)
    }
}

/// Why there is no request.
#[derive(Debug)]
pub(super) enum NoRequest {
    /// The connection has ended.
    Ended,
    /// It is malformed.
    Malformed,
    /// It is too long.
    TooLong,
}

/// Reads the head of the next request. `buffer` holds what has been read of the connection and not been used.
pub(super) fn read(stream: &mut impl Read, buffer: &mut Vec<u8>) -> Result<Head, NoRequest> {
    loop {
        if let Some((head, length)) = parse(buffer)? {
            buffer.drain(..length);
            return Ok(head);
        }
        if buffer.len() > LONGEST {
            return Err(NoRequest::TooLong);
        }
        let mut piece = [0; 4096];
        match stream.read(&mut piece) {
            Ok(0) => return Err(NoRequest::Ended),
            Ok(length) => buffer.extend_from_slice(&piece[..length]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(_) => return Err(NoRequest::Ended),
        }
    }
}

/// The head that `bytes` begin with, and its length; none if it is not whole.
fn parse(bytes: &[u8]) -> Result<Option<(Head, usize)>, NoRequest> {
    let mut lines = [httparse::EMPTY_HEADER; LINES];
    let mut request = httparse::Request::new(&mut lines);
    let length = match request.parse(bytes) {
        Ok(httparse::Status::Complete(length)) => length,
        Ok(httparse::Status::Partial) => return Ok(None),
        Err(httparse::Error::TooManyHeaders) => return Err(NoRequest::TooLong),
        Err(_) => return Err(NoRequest::Malformed),
    };
    let lines = request
        .headers
        .iter()
        .map(|line| Some((line.name.to_ascii_lowercase(), std::str::from_utf8(line.value).ok()?.trim().to_owned())));
    let lines = lines.collect::<Option<Vec<_>>>().ok_or(NoRequest::Malformed)?;
    let mut head = Head {
        method: request.method.unwrap_or_default().to_owned(),
        target: request.path.unwrap_or_default().to_owned(),
        lines,
        ..Head::default()
    };
    head.has_body = head.has("transfer-encoding") || head.get("content-length").is_some_and(|length| length != "0");
    let says = |word: &str| head.get("connection").is_some_and(|value| value.to_ascii_lowercase().contains(word));
    head.goes_on = if request.version == Some(0) { says("keep-alive") } else { !says("close") };
    Ok(Some((head, length)))
}

/// An answer.
#[derive(Debug, Clone)]
pub(super) struct Reply {
    /// Its status: 200 if all is well.
    pub status: u16,
    /// The type of its content.
    pub kind: &'static str,
    /// Its content.
    pub body: Vec<u8>,
}

impl Reply {
    /// Words for whoever is refused.
    pub fn refusal(status: u16, words: &str) -> Self {
        Self { status, kind: "text/plain; charset=utf-8", body: format!("{words}\n").into_bytes() }
    }
}

/// What every answer says: nothing is kept, nothing is guessed, and no other site may show or read it.
const ALWAYS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n\
    Content-Security-Policy: frame-ancestors 'none'\r\nCross-Origin-Resource-Policy: same-origin\r\nReferrer-Policy: no-referrer\r\n";

/// Writes an answer, without its content if only the head was asked for.
pub(super) fn write(stream: &mut TcpStream, reply: &Reply, head_only: bool, goes_on: bool) -> io::Result<()> {
    let connection = if goes_on { "keep-alive" } else { "close" };
    let allow = if reply.status == 405 { "Allow: GET, HEAD\r\n" } else { "" };
    let head = format!(
        "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nConnection: {connection}\r\n{allow}{ALWAYS}\r\n",
        reply.status,
        reason(reply.status),
        reply.kind,
        reply.body.len()
    );
    let body: &[u8] = if head_only { &[] } else { &reply.body };
    stream.write_all(&[head.as_bytes(), body].concat())?;
    stream.flush()
}

/// Writes the head of a stream of events.
pub(super) fn write_events(stream: &mut TcpStream) -> io::Result<()> {
    let head = format!("HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nConnection: close\r\n{ALWAYS}\r\n");
    stream.write_all(head.as_bytes())
}

fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        400 => "Bad Request",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        431 => "Request Header Fields Too Large",
        503 => "Service Unavailable",
        _ => "Internal Server Error",
    }
}

/// The type of a file's content.
pub(super) fn kind_of(path: &str) -> &'static str {
    match path.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase()).as_deref() {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("jpg" | "jpeg") => "image/jpeg",
        Some("gif") => "image/gif",
        Some("webp") => "image/webp",
        Some("avif") => "image/avif",
        Some("woff2") => "font/woff2",
        Some("pdf") => "application/pdf",
        Some("mp4") => "video/mp4",
        Some("csv") => "text/csv; charset=utf-8",
        Some("txt" | "md" | "bib" | "toml") => "text/plain; charset=utf-8",
        Some("xml") => "application/xml",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(text: &str) -> Result<Head, NoRequest> {
        read(&mut text.as_bytes(), &mut Vec::new())
    }

    #[test]
    fn heads_are_read_whole_and_one_after_the_other() {
        let mut buffer = Vec::new();
        let mut stream = "GET /a HTTP/1.1\r\nHost: x\r\n\r\nHEAD /b HTTP/1.0\r\nHost: y\r\nHost: z\r\n\r\n".as_bytes();
        let first = read(&mut stream, &mut buffer).unwrap();
        assert_eq!((first.method.as_str(), first.target.as_str(), first.get("host")), ("GET", "/a", Some("x")));
        assert!(first.goes_on && !first.has_body);
        let second = read(&mut stream, &mut buffer).unwrap();
        assert_eq!((second.method.as_str(), second.get("host"), second.has("host")), ("HEAD", None, true));
        assert!(!second.goes_on);
        assert!(matches!(read(&mut stream, &mut buffer), Err(NoRequest::Ended)));
    }

    #[test]
    fn what_is_malformed_or_too_long_is_no_request() {
        assert!(matches!(head("no request at all\r\n\r\n"), Err(NoRequest::Malformed)));
        assert!(matches!(head("GET / HTTP/1.1\r\nHost: \u{0}\r\n\r\n"), Err(NoRequest::Malformed)));
        let long = format!("GET /{} HTTP/1.1\r\n", "a".repeat(2 * LONGEST));
        assert!(matches!(head(&long), Err(NoRequest::TooLong)));
        let many = format!("GET / HTTP/1.1\r\n{}\r\n", "A: b\r\n".repeat(LINES + 1));
        assert!(matches!(head(&many), Err(NoRequest::TooLong)));
        assert!(head("GET / HTTP/1.1\r\nContent-Length: 3\r\n\r\n").unwrap().has_body);
    }
}
