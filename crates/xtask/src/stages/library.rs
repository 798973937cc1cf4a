//! Stages about the libraries: the simulation for JavaScript, and the crates for Rust.

use anyhow::{Result, ensure};
use xshell::cmd;

use crate::shell::Shell;
use crate::{paths, tools};

/// The laws of `hearth-fire/sim` in the built site, in Node.
pub(super) fn laws_in_node() -> Result<()> {
    tools::node()?;
    let sh = Shell::new()?;
    // By name: versions of Node search a folder differently.
    let mut tests = sh.read_dir("tests/sim")?;
    tests.retain(|path| path.to_string_lossy().ends_with(".test.mjs"));
    ensure!(!tests.is_empty(), "tests/sim contains no test");
    let node = cmd!(sh, "node --test --test-reporter spec {tests...}");
    Ok(node.env("HEARTH_SITE", paths::site()).run()?)
}

/// Every crate that may be published, without a warning. Uncommitted changes are allowed:
/// nobody commits before a test.
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
