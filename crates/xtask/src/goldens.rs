//! Tests that look at pictures, and `cargo xtask goldens`, which makes the
//! pictures that they compare with.
//!
//! Both draw kept fires with the renderer itself, in headless Chromium without a
//! graphics card: its pictures are the same on every machine.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;

use crate::site::{self, Module};
use crate::stages::browser;
use crate::{paths, process, tools};

/// What paints for tests. Of the profile that the other tests in a browser have, so
/// that little of it is compiled again.
const PAINTER: Module = Module {
    package: "hearth-painter",
    profile: "dev",
};

/// What new goldens are wanted of.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// The fires too are burnt anew.
    pub snapshots: bool,
    /// How the names of the pictures begin; none: all.
    pub names: Vec<String>,
}

/// Burns the fires that are kept, if that is wanted, and draws the pictures anew.
///
/// # Errors
/// No browser, no Node, code that does not compile, a picture of nothing, no picture of a name.
pub fn write(wanted: &Wanted) -> Result<()> {
    if wanted.snapshots {
        let mut burn = process::cargo();
        burn.args(["run", "--quiet", "--release", "--package", "hearth-painter"])
            .args(["--example", "snapshots", "--"])
            .arg(folder().join("snapshots"));
        process::run(&mut burn)?;
    }
    process::run(script("write.mjs")?.args(&wanted.names))
}

/// Compares what is drawn with the goldens, and looks at pictures in other ways.
///
/// # Errors
/// A test that fails, or what [`write`] may fail with.
pub fn check() -> Result<()> {
    process::run(&mut script("run.mjs")?)
}

/// Where the goldens lie.
fn folder() -> PathBuf {
    paths::root().join("tests").join("goldens")
}

/// A script of `tests/look` with a painter and a browser.
///
/// # Errors
/// As [`write`].
pub(crate) fn script(name: &str) -> Result<Command> {
    let browser = tools::browser()?;
    browser::packages()?;
    tools::wasm_target()?;
    site::compile(&PAINTER)?;
    let made = site::target_folder()?.join("hearth-look");
    let painter = made.join("painter");
    site::bind(&PAINTER, "painter", &painter)?;
    let shown = made.join("shown");
    if shown.exists() {
        fs::remove_dir_all(&shown)?;
    }
    let mut node = process::command("node");
    node.current_dir(paths::root().join("tests").join("look"))
        .arg(name)
        .env("HEARTH_CHROMIUM", browser.chromium)
        .env("HEARTH_PAINTER", painter)
        .env("HEARTH_SHOWN", shown);
    Ok(node)
}
