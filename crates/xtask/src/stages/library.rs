//! Stages about the libraries: the simulation for JavaScript, in Node, and the core
//! as a crate of its own.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::{paths, process, tools};

/// The laws of `hearth-fire/sim`, in Node, by the built site.
pub(super) fn laws_in_node() -> Result<()> {
    tools::node()?;
    let folder = paths::root().join("tests").join("sim");
    let mut node = process::command("node");
    node.args(["--test", "--test-reporter", "spec"])
        .args(tests(&folder)?);
    // The native program that they compare with is built by the same cargo.
    node.env("CARGO", process::cargo().get_program());
    process::run(node.env("HEARTH_SITE", paths::site()))
}

/// The tests of scripts that need neither a browser nor a built site.
pub(super) fn scripts_in_node() -> Result<()> {
    tools::node()?;
    let folder = paths::root().join("tests").join("web");
    let mut node = process::command("node");
    process::run(
        node.args(["--test", "--test-reporter", "spec"])
            .args(tests(&folder)?),
    )
}

/// Every test file, by name: what Node makes of a folder depends on its version.
fn tests(folder: &Path) -> Result<Vec<PathBuf>> {
    let listed =
        fs::read_dir(folder).with_context(|| format!("cannot read {}", paths::shown(folder)))?;
    let mut found = Vec::new();
    for entry in listed {
        let path = entry?.path();
        let name = path.file_name().and_then(OsStr::to_str);
        if name.is_some_and(|name| name.ends_with(".test.mjs")) {
            found.push(path);
        }
    }
    if found.is_empty() {
        bail!("there are no tests in {}", paths::shown(folder));
    }
    found.sort();
    Ok(found)
}

/// The core could be published as it stands: its package holds all that it needs.
pub(super) fn publishable() -> Result<()> {
    let mut publish = process::cargo();
    // Nobody commits before a test.
    publish.args([
        "publish",
        "--dry-run",
        "--allow-dirty",
        "--package",
        "hearth-core",
    ]);
    process::run(&mut publish)
}
