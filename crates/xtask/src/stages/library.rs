//! Stages about the libraries: the simulation for JavaScript, and the crates for Rust.

use std::path::PathBuf;

use anyhow::{Result, ensure};
use xshell::cmd;

use crate::shell::Shell;
use crate::{paths, script, tools};

/// The laws of `hearth-fire/sim` in the built site, in Node.
pub(super) fn laws_in_node() -> Result<()> {
    tools::node()?;
    let sh = Shell::new()?;
    let tests = tests(&sh, "tests/sim")?;
    let node = cmd!(sh, "node --test --test-reporter spec {tests...}");
    Ok(node.env("HEARTH_SITE", paths::site()).run()?)
}

/// The tests of scripts that need neither a browser nor a built site.
pub(super) fn scripts_in_node() -> Result<()> {
    script::tools()?;
    let sh = Shell::new()?;
    let tests = tests(&sh, "tests/web")?;
    Ok(cmd!(sh, "node --test --test-reporter spec {tests...}").run()?)
}

/// Every test file, by name: versions of Node search a folder differently.
fn tests(sh: &Shell, folder: &str) -> Result<Vec<PathBuf>> {
    let mut tests = sh.read_dir(folder)?;
    tests.retain(|path| path.to_string_lossy().ends_with(".test.mjs"));
    ensure!(!tests.is_empty(), "{folder} contains no test");
    Ok(tests)
}

/// Every crate that may be published, without a warning. Uncommitted changes are allowed:
/// tests run before a commit.
pub(super) fn publishable() -> Result<()> {
    let sh = Shell::new()?;
    let publish = cmd!(sh, "cargo publish --workspace --dry-run --allow-dirty").ignore_status();
    eprintln!("$ {publish}");
    let output = publish.output()?;
    let printed = String::from_utf8_lossy(&output.stderr);
    eprint!("{printed}");
    ensure!(output.status.success(), "`{publish}` failed");
    let warnings = printed.lines().filter(|line| line.starts_with("warning"));
    let warnings: Vec<_> = warnings
        .filter(|line| !line.contains("due to dry run"))
        .collect();
    ensure!(warnings.is_empty(), "{}", warnings.join("\n"));
    Ok(())
}
