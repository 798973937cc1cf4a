//! The part of HTTP that a static server has to understand, and the one place
//! that decides which file a visitor may have.

use std::io::{self, BufRead, Read};
use std::path::PathBuf;

/// Longest head of a request, in bytes.
const LONGEST_HEAD: u64 = 16 * 1024;

/// What is to be done.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Verb {
    Get,
    Head,
    Other,
}

/// The first line of a request.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Request {
    pub verb: Verb,
    /// As it was sent, without the query.
    pub path: String,
}

impl Request {
    /// Reads the head of a request; `None` where it is not one.
    pub(super) fn read(reader: &mut impl BufRead) -> io::Result<Option<Request>> {
        let mut reader = reader.take(LONGEST_HEAD);
        let mut first = Vec::new();
        reader.read_until(b'\n', &mut first)?;
        let request = std::str::from_utf8(&first).ok().and_then(Request::parse);
        // The rest is read, so that closing the connection does not reset it.
        let mut line = Vec::new();
        while reader.read_until(b'\n', &mut line)? > 0 && !line.trim_ascii().is_empty() {
            line.clear();
        }
        Ok(request)
    }

    fn parse(line: &str) -> Option<Request> {
        let mut words = line.split_ascii_whitespace();
        let (verb, target, version) = (words.next()?, words.next()?, words.next()?);
        if !version.starts_with("HTTP/1.") || !target.starts_with('/') {
            return None;
        }
        let path = target.split(['?', '#']).next()?.to_owned();
        let verb = match verb {
            "GET" => Verb::Get,
            "HEAD" => Verb::Head,
            _ => Verb::Other,
        };
        Some(Request { verb, path })
    }

    /// The file that is meant, relative to the folder that is served; `None`
    /// for anything that could lie outside it.
    pub(super) fn file(&self) -> Option<PathBuf> {
        let path = decoded(&self.path)?;
        let mut file = PathBuf::new();
        for name in path.split('/').filter(|name| !name.is_empty()) {
            // A backslash or a colon could be a separator or a drive; a name
            // that starts with a dot is nobody's business.
            if name.starts_with('.') || name.contains(['\\', ':', '\0']) {
                return None;
            }
            file.push(name);
        }
        Some(file)
    }
}

/// `path` with `%20` and its like replaced.
fn decoded(path: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.bytes();
    while let Some(byte) = rest.next() {
        if byte == b'%' {
            let high = char::from(rest.next()?).to_digit(16)?;
            let low = char::from(rest.next()?).to_digit(16)?;
            bytes.push(u8::try_from(high * 16 + low).ok()?);
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn file(path: &str) -> Option<PathBuf> {
        Request {
            verb: Verb::Get,
            path: path.to_owned(),
        }
        .file()
    }

    #[test]
    fn files_inside_are_found() {
        assert_eq!(file("/"), Some(PathBuf::new()));
        assert_eq!(
            file("/web//pages/main.js"),
            Some(Path::new("web/pages/main.js").into())
        );
        assert_eq!(file("/a%20b/%C3%A9.js"), Some(Path::new("a b/é.js").into()));
    }

    #[test]
    fn nothing_outside_is_reachable() {
        for path in [
            "/..",
            "/../secret",
            "/web/../../secret",
            "/%2e%2e/secret",
            "/web/%2E%2E/%2e%2e/secret",
            "/..%2fsecret",
            "/%2e%2e%2f%2e%2e%2fetc/passwd",
            "/..%5csecret",
            "/C:/secret",
            "/web/.git/config",
            "/a%00b",
            "/%",
            "/%zz",
            "/%ff",
        ] {
            assert_eq!(file(path), None, "{path}");
        }
        // An absolute path inside the path stays inside.
        assert_eq!(file("//etc/passwd"), Some(Path::new("etc/passwd").into()));
        assert_eq!(file("/%2fetc/passwd"), Some(Path::new("etc/passwd").into()));
    }

    #[test]
    fn requests_are_read() -> io::Result<()> {
        let read = |text: &str| Request::read(&mut text.as_bytes());
        assert_eq!(
            read("GET /a/b.js?x=../..#y HTTP/1.1\r\nHost: x\r\n\r\n")?,
            Some(Request {
                verb: Verb::Get,
                path: "/a/b.js".to_owned()
            })
        );
        let verb = |request: Option<Request>| request.map(|request| request.verb);
        assert_eq!(verb(read("HEAD / HTTP/1.0\n\n")?), Some(Verb::Head));
        assert_eq!(verb(read("POST / HTTP/1.1\r\n\r\n")?), Some(Verb::Other));
        for nonsense in [
            "",
            "\r\n",
            "GET /",
            "GET x HTTP/1.1",
            "GET / FTP/1",
            "\u{1}\u{2}",
        ] {
            assert_eq!(read(nonsense)?, None);
        }
        Ok(())
    }

    #[test]
    fn an_endless_request_ends() -> io::Result<()> {
        let mut endless = io::BufReader::new(io::repeat(b'a'));
        assert_eq!(Request::read(&mut endless)?, None);
        Ok(())
    }
}
