//! Serves the site on this machine.
//!
//! The server is esbuild's, which `scripts/` pins for minifying: it sends the type of
//! wasm, listens on loopback only, leaves its folder for no request and lets the browser
//! store nothing, so that a reload shows the last build.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;

use anyhow::{Context, Result, ensure};

use crate::script;
use crate::shell::{self, Shell};

/// Serves `folder` until the process is ended.
pub(crate) fn serve(folder: &Path, port: Option<u16>, open: bool) -> Result<()> {
    script::tools()?;
    let mut command: Command = Shell::new()?.cmd("node").into();
    command.arg(script::folder().join("serve.mjs")).arg(folder);
    command.args(port.map(|port| port.to_string()));
    let mut server = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .context("cannot start `node`")?;
    // The server ends when its input does: with this process, however that ends.
    let _input = server.stdin.take();
    let mut output = BufReader::new(server.stdout.take().context("no output")?);
    let mut address = String::new();
    output.read_line(&mut address)?;
    let address = address.trim();
    ensure!(
        !address.is_empty(),
        "the server did not start; another --port may be free"
    );
    println!("Hearth burns at {address} (Ctrl+C ends it)");
    if open {
        open_browser(address);
    }
    let status = server.wait()?;
    ensure!(status.success(), "the server ended ({status})");
    Ok(())
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
