//! Serves the site on this machine.
//!
//! The server is esbuild's, which `scripts/` pins for minifying: it knows the type of
//! wasm, listens on loopback only, leaves its folder for no request and lets the browser
//! store nothing, so that a reload shows the last build.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::thread;

use anyhow::{Context, Result, ensure};

use crate::script;
use crate::shell::{self, Shell};

/// Serves `folder` until the process is ended.
pub(crate) fn serve(folder: &Path, port: Option<u16>, open: bool) -> Result<()> {
    let mut server = Server::start(folder, port)?;
    println!("Hearth burns at {} (Ctrl+C ends it)", server.address);
    if open {
        open_browser(&server.address);
    }
    let status = server.process.wait()?;
    ensure!(status.success(), "the server ended ({status})");
    Ok(())
}

/// A running server. It ends when its input does: with this process, however that ends.
struct Server {
    process: Child,
    address: String,
    /// Apart from `process`, which closes it when it waits.
    input: Option<ChildStdin>,
    _output: BufReader<ChildStdout>,
}

impl Server {
    fn start(folder: &Path, port: Option<u16>) -> Result<Server> {
        script::tools()?;
        let sh = Shell::new()?;
        let mut command: Command = sh.cmd("node").into();
        command.arg(script::folder().join("serve.mjs")).arg(folder);
        command.args(port.map(|port| port.to_string()));
        let mut process = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .context("cannot start `node`")?;
        let mut output = BufReader::new(process.stdout.take().context("no output")?);
        let mut address = String::new();
        output.read_line(&mut address)?;
        let address = address.trim().to_owned();
        ensure!(
            !address.is_empty(),
            "the server did not start; another --port may be free"
        );
        Ok(Server {
            input: process.stdin.take(),
            process,
            address,
            _output: output,
        })
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        drop(self.input.take());
        let _ = self.process.wait();
    }
}

/// Opens the system's browser, where there is one.
fn open_browser(address: &str) {
    let openers: &[&[&str]] = if cfg!(target_os = "windows") {
        &[&["cmd", "/c", "start", ""]]
    } else if cfg!(target_os = "macos") {
        &[&["open"]]
    } else {
        &[&["xdg-open"], &["wslview"]]
    };
    for opener in openers {
        let Some(program) = shell::find(opener[0]) else {
            continue;
        };
        let started = Command::new(program)
            .args(&opener[1..])
            .arg(address)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn();
        if let Ok(mut browser) = started {
            // The browser may run as long as the server; its exit status is collected here.
            thread::spawn(move || browser.wait());
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::io::{Read, Write};
    use std::net::TcpStream;

    use super::*;

    /// What the server of a folder with a page and a module answers.
    fn answers(requests: &[&str]) -> Result<Vec<String>> {
        let folder = Shell::new()?.create_temp_dir()?;
        let site = folder.path().join("site");
        fs::create_dir_all(site.join("web"))?;
        fs::write(site.join("index.html"), "<p>fire</p>")?;
        fs::write(site.join("web").join("engine_bg.wasm"), b"\0asm")?;
        fs::write(folder.path().join("secret"), "secret")?;
        let server = Server::start(&site, None)?;
        let host = server.address.replace("http://", "").replace('/', "");
        let answers = requests.iter().map(|request| -> Result<String> {
            let mut visitor = TcpStream::connect(&host)?;
            write!(
                visitor,
                "{request} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"
            )?;
            let mut answer = Vec::new();
            visitor.read_to_end(&mut answer)?;
            Ok(String::from_utf8_lossy(&answer).into_owned())
        });
        answers.collect()
    }

    #[test]
    fn files_have_their_type_and_are_not_stored() -> Result<()> {
        let answers = answers(&["GET /", "GET /web/engine_bg.wasm?v=1", "HEAD /index.html"])?;
        for answer in &answers {
            assert!(answer.starts_with("HTTP/1.1 200 OK\r\n"));
            // Without these a browser asks for the file each time.
            for kept in ["Last-Modified", "ETag", "Expires"] {
                assert!(!answer.contains(kept), "{answer}");
            }
        }
        assert!(answers[0].contains("\r\nContent-Type: text/html"));
        assert!(answers[0].ends_with("\r\n\r\n<p>fire</p>"));
        assert!(answers[1].contains("\r\nContent-Type: application/wasm\r\n"));
        assert!(answers[1].ends_with("\r\n\r\n\0asm"));
        assert!(answers[2].contains("\r\nContent-Length: 11\r\n"));
        assert!(answers[2].ends_with("\r\n\r\n"));
        Ok(())
    }

    #[test]
    fn nothing_outside_the_folder_is_served() -> Result<()> {
        let outside = [
            "GET /no.js",
            "GET /../secret",
            "GET /web/../../secret",
            "GET /%2e%2e/secret",
            "GET /..%2fsecret",
            "GET /..%5csecret",
            "POST /",
        ];
        for (request, answer) in outside.iter().zip(answers(&outside)?) {
            assert!(answer.starts_with("HTTP/1.1 4"), "{request}: {answer}");
        }
        assert!(answers(&["GET /web"])?[0].contains("\r\nLocation: /web/\r\n"));
        Ok(())
    }

    #[test]
    fn only_a_requested_port_must_be_free() -> Result<()> {
        let folder = Shell::new()?.create_temp_dir()?;
        let first = Server::start(folder.path(), None)?;
        let second = Server::start(folder.path(), None)?;
        assert_ne!(first.address, second.address);
        let taken = first.address.trim_end_matches('/').rsplit(':').next();
        let taken = taken.unwrap_or_default().parse()?;
        assert!(Server::start(folder.path(), Some(taken)).is_err());
        Ok(())
    }
}
