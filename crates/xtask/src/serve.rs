//! A static web server for this machine alone.
//!
//! It listens on loopback, sends files of one folder and nothing else, and
//! tells the browser to keep nothing, so that a reload shows the last build.
//! Types matter: a browser compiles wasm while it loads only where the type is
//! `application/wasm`, and refuses a module script of a wrong type.

mod request;

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result};

use crate::process;
use request::{Request, Verb};

/// The port where one was not asked for, if it is free.
const USUAL_PORT: u16 = 8080;

/// A browser that opens a connection and says nothing does not keep a thread for ever.
const PATIENCE: Duration = Duration::from_secs(30);

/// Serves `folder` until the process is ended.
///
/// # Errors
/// The port that was asked for is taken.
pub fn serve(folder: &Path, port: Option<u16>, open: bool) -> Result<()> {
    let listener = listen(port)?;
    let address = format!("http://{}/", listener.local_addr()?);
    println!("Hearth burns at {address} (Ctrl+C ends it)");
    if open {
        open_browser(&address);
    }
    answer_all(&listener, folder);
    Ok(())
}

fn listen(port: Option<u16>) -> Result<TcpListener> {
    let bind = |port| TcpListener::bind((Ipv4Addr::LOCALHOST, port));
    match port {
        Some(port) => bind(port)
            .with_context(|| format!("cannot listen on port {port}; another --port may be free")),
        None => bind(USUAL_PORT)
            .or_else(|_| bind(0))
            .context("cannot listen on any port of this machine"),
    }
}

fn answer_all(listener: &TcpListener, folder: &Path) {
    thread::scope(|scope| {
        for connection in listener.incoming() {
            // A visitor that went away again is nobody's error.
            let Ok(connection) = connection else { continue };
            scope.spawn(move || answer(connection, folder));
        }
    });
}

/// Answers one request; a connection that breaks off needs no answer.
fn answer(connection: TcpStream, folder: &Path) -> io::Result<()> {
    connection.set_read_timeout(Some(PATIENCE))?;
    connection.set_write_timeout(Some(PATIENCE))?;
    let mut reader = BufReader::new(&connection);
    let mut writer = BufWriter::new(&connection);
    match Request::read(&mut reader)? {
        Some(request) => respond(&request, folder, &mut writer)?,
        None => refuse("400 Bad Request", true, &mut writer)?,
    }
    writer.flush()
}

fn respond(request: &Request, folder: &Path, writer: &mut impl Write) -> io::Result<()> {
    let with_body = match request.verb {
        Verb::Get => true,
        Verb::Head => false,
        Verb::Other => return refuse("405 Method Not Allowed", true, writer),
    };
    let Some(mut path) = request.file().map(|file| folder.join(file)) else {
        return refuse("404 Not Found", with_body, writer);
    };
    if path.is_dir() {
        // Relative URLs of the page count from the folder, so it must end in one.
        if !request.path.ends_with('/') {
            let place = format!("{}/", request.path);
            return head(
                "301 Moved Permanently",
                "text/plain",
                0,
                &[("Location", &place)],
                writer,
            );
        }
        path.push("index.html");
    }
    let opened = File::open(&path).and_then(|file| Ok((file.metadata()?, file)));
    match opened {
        Ok((about, mut file)) if about.is_file() => {
            head("200 OK", mime_type(&path), about.len(), &[], writer)?;
            if with_body {
                io::copy(&mut file, writer)?;
            }
            Ok(())
        }
        _ => refuse("404 Not Found", with_body, writer),
    }
}

fn refuse(status: &str, with_body: bool, writer: &mut impl Write) -> io::Result<()> {
    let text = format!("{status}\n");
    head(
        status,
        "text/plain; charset=utf-8",
        text.len() as u64,
        &[],
        writer,
    )?;
    if with_body {
        writer.write_all(text.as_bytes())?;
    }
    Ok(())
}

fn head(
    status: &str,
    mime_type: &str,
    length: u64,
    more: &[(&str, &str)],
    writer: &mut impl Write,
) -> io::Result<()> {
    write!(
        writer,
        "HTTP/1.1 {status}\r\nContent-Type: {mime_type}\r\nContent-Length: {length}\r\n\
         Cache-Control: no-cache, no-store\r\nX-Content-Type-Options: nosniff\r\n\
         Connection: close\r\n"
    )?;
    for (name, value) in more {
        write!(writer, "{name}: {value}\r\n")?;
    }
    writer.write_all(b"\r\n")
}

fn mime_type(path: &Path) -> &'static str {
    let extension = path
        .extension()
        .map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    match extension.as_deref().unwrap_or_default() {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" | "map" => "application/json",
        "wasm" => "application/wasm",
        "md" | "ts" | "txt" => "text/plain; charset=utf-8",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "jpg" | "jpeg" => "image/jpeg",
        "webp" => "image/webp",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        _ => "application/octet-stream",
    }
}

/// Opens the system's browser, where there is one; the address is printed anyway.
fn open_browser(address: &str) {
    let openers: &[&[&str]] = if cfg!(target_os = "windows") {
        &[&["cmd", "/c", "start", ""]]
    } else if cfg!(target_os = "macos") {
        &[&["open"]]
    } else {
        &[&["xdg-open"], &["wslview"]]
    };
    for opener in openers {
        let Some((program, arguments)) = opener.split_first() else {
            continue;
        };
        if process::find(program).is_none() {
            continue;
        }
        let started = Command::new(program)
            .args(arguments)
            .arg(address)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn();
        if let Ok(mut browser) = started {
            // It may run as long as the server; somebody has to wait for it.
            thread::spawn(move || browser.wait());
            return;
        }
    }
}

#[cfg(test)]
mod tests;
