//! Who may ask: pages of this server, and people who type its address. Pages of other sites may neither read the preview nor drive it.

use std::net::{IpAddr, SocketAddr};

use super::http::{Head, Reply};

/// Where the server listens, and so under which names it may be asked.
#[derive(Debug, Clone)]
pub(super) struct Rules {
    address: SocketAddr,
}

impl Rules {
    pub fn new(address: SocketAddr) -> Self {
        Self { address }
    }

    /// The address as a browser on this machine writes it.
    pub fn address(&self) -> String {
        let here: IpAddr = if self.address.is_ipv6() { [0, 0, 0, 0, 0, 0, 0, 1].into() } else { [127, 0, 0, 1].into() };
        let host = if self.address.ip().is_unspecified() { here } else { self.address.ip() };
        SocketAddr::new(host, self.address.port()).to_string()
    }

    /// Refuses what is no question of a page of this server or of a person.
    pub fn check(&self, head: &Head) -> Result<(), Reply> {
        if !["GET", "HEAD"].contains(&head.method.as_str()) {
            return Err(Reply::refusal(405, "only GET and HEAD are answered here"));
        }
        if head.has_body {
            return Err(Reply::refusal(400, "a request with a body is not answered here"));
        }
        // A name of another site may lead to this machine; the browser then says that name.
        if !head.get("host").is_some_and(|host| self.is_own(host)) {
            return Err(Reply::refusal(403, "this preview is not served under that name"));
        }
        let origin = head.get("origin").and_then(|origin| origin.strip_prefix("http://"));
        if head.has("origin") && origin != head.get("host") {
            return Err(Reply::refusal(403, "pages of other sites are not answered here"));
        }
        let fetch = |part: &str| head.get(&format!("sec-fetch-{part}"));
        let from_here = fetch("site").is_none_or(|site| ["same-origin", "none"].contains(&site));
        // A link of another site may be followed; what it leads to then stands by itself.
        let followed = fetch("mode") == Some("navigate") && fetch("dest") == Some("document");
        if !from_here && !followed {
            return Err(Reply::refusal(403, "pages of other sites are not answered here"));
        }
        Ok(())
    }

    /// Whether a host with its port is this server: by the name of this machine for itself, or by a number, which no other site can have.
    fn is_own(&self, host: &str) -> bool {
        let (name, port) = match host.rsplit_once(':') {
            Some((name, port)) if !port.contains(']') => (name, port.parse().ok()),
            _ => (host, Some(80)),
        };
        let number = name.strip_prefix('[').and_then(|name| name.strip_suffix(']')).unwrap_or(name);
        let number = number.parse::<IpAddr>().ok();
        let own =
            |number: IpAddr| number == self.address.ip() || number.is_loopback() || !self.address.ip().is_loopback();
        port == Some(self.address.port()) && (name.eq_ignore_ascii_case("localhost") || number.is_some_and(own))
    }
}

/// The path in the book that a target asks for, without its query; none if it is not of the book's kind.
pub(super) fn path(target: &str) -> Option<String> {
    let target = target.split(['?', '#']).next().unwrap_or_default();
    let path = decoded(target.strip_prefix('/')?)?;
    let plain = |part: &str| !part.is_empty() && part != "." && part != ".." && !part.contains(['\\', ':']);
    let sound = path.is_empty() || path.split('/').all(plain);
    (sound && !path.chars().any(char::is_control)).then_some(path)
}

/// The value of a name in the query of a target.
pub(super) fn asked(target: &str, name: &str) -> Option<String> {
    let query = target.split_once('?')?.1;
    let value = query.split('&').find_map(|part| part.split_once('=').filter(|(known, _)| *known == name))?.1;
    decoded(value)
}

/// Text without its per cent signs; none if that is no text.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&byte, behind)) = rest.split_first() {
        rest = behind;
        if byte == b'%' {
            let digits = rest.get(..2).filter(|digits| digits.iter().all(u8::is_ascii_hexdigit))?;
            bytes.push(u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()?);
            rest = &rest[2..];
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::serve::http;

    fn status(address: &str, lines: &str) -> u16 {
        let text = format!("GET / HTTP/1.1\r\n{lines}\r\n");
        let head = http::read(&mut text.as_bytes(), &mut Vec::new()).unwrap();
        Rules::new(address.parse().unwrap()).check(&head).map_or_else(|reply| reply.status, |()| 200)
    }

    #[test]
    fn only_own_names_are_answered() {
        let local = |host: &str| status("127.0.0.1:4321", &format!("Host: {host}\r\n"));
        for own in ["127.0.0.1:4321", "localhost:4321", "LOCALHOST:4321", "[::1]:4321"] {
            assert_eq!(local(own), 200, "{own}");
        }
        for other in
            ["evil.example:4321", "localhost", "127.0.0.1:80", "localhost.evil.example:4321", "10.0.0.1:4321", ""]
        {
            assert_eq!(local(other), 403, "{other}");
        }
        assert_eq!(status("127.0.0.1:4321", ""), 403);
        assert_eq!(status("127.0.0.1:4321", "Host: localhost:4321\r\nHost: evil.example\r\n"), 403);
        assert_eq!(status("0.0.0.0:4321", "Host: 10.0.0.1:4321\r\n"), 200);
        assert_eq!(status("0.0.0.0:4321", "Host: evil.example:4321\r\n"), 403);
    }

    #[test]
    fn pages_of_other_sites_are_refused_and_their_links_are_not() {
        let with = |lines: &str| status("127.0.0.1:4321", &format!("Host: localhost:4321\r\n{lines}"));
        assert_eq!(with("Origin: http://localhost:4321\r\nSec-Fetch-Site: same-origin\r\n"), 200);
        assert_eq!(with("Sec-Fetch-Site: none\r\n"), 200);
        assert_eq!(with("Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: document\r\n"), 200);
        for other in [
            "Origin: https://evil.example\r\n",
            "Origin: null\r\n",
            "Origin: http://localhost:4322\r\n",
            "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\nSec-Fetch-Dest: script\r\n",
            "Sec-Fetch-Site: same-site\r\nSec-Fetch-Mode: cors\r\nSec-Fetch-Dest: empty\r\n",
            "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: iframe\r\n",
        ] {
            assert_eq!(with(other), 403, "{other}");
        }
    }

    #[test]
    fn no_path_leaves_the_book() {
        assert_eq!(path("/").as_deref(), Some(""));
        assert_eq!(path("/a%20b.html?theme=dark").as_deref(), Some("a b.html"));
        assert_eq!(path("/exhibits/fig.svg").as_deref(), Some("exhibits/fig.svg"));
        for bad in [
            "",
            "a",
            "/..",
            "/../x",
            "/a/../../x",
            "/%2e%2e/x",
            "/a%5c..%5cx",
            "/a\\x",
            "/a%00",
            "/a//b",
            "/./a",
            "/%",
            "/%zz",
            "/%ff",
            "//etc/passwd",
            "/c:/x",
            "http://other/",
        ] {
            assert_eq!(path(bad), None, "{bad}");
        }
        assert_eq!(asked("/x?path=a%2Fb&from=1", "path").as_deref(), Some("a/b"));
        assert_eq!(asked("/x?path=a", "from"), None);
    }
}
