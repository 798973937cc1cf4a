//! Stages about the libraries: the simulation for JavaScript, and the crates for Rust.

use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

use anyhow::{Result, ensure};
use xshell::cmd;

use crate::shell::Shell;
use crate::{package, paths, script, tools};

/// The laws of `hearth-fire/sim` in the built site, in Node.
pub(super) fn laws_in_node() -> Result<()> {
    tools::node()?;
    run_tests("tests/sim", Some(tools::fingerprints()?))
}

/// The tests of scripts that need neither a browser nor a built site.
pub(super) fn scripts_in_node() -> Result<()> {
    script::tools()?;
    run_tests("tests/web", None)
}

/// Runs every test file, by name, two at a time: versions of Node search a folder differently, and
/// on two cores run one. A file that takes longer than ten minutes fails.
fn run_tests(folder: &str, variable: Option<(&str, PathBuf)>) -> Result<()> {
    let sh = Shell::new()?;
    let mut tests = sh.read_dir(folder)?;
    tests.retain(|path| path.to_string_lossy().ends_with(".test.mjs"));
    ensure!(!tests.is_empty(), "{folder} contains no test");
    let options = "--test-timeout=600000 --test-reporter=spec --test-concurrency=2".split(' ');
    let node = cmd!(sh, "node --test {options...} {tests...}").env("HEARTH_SITE", paths::site());
    Ok(node.envs(variable).run()?)
}

/// Every crate that may be published, without a warning. Uncommitted changes are allowed:
/// tests run before a commit.
pub(super) fn publishable() -> Result<()> {
    package::command_notices()?;
    let sh = Shell::new()?;
    // cargo takes a crate of an earlier dry run in the same folder, packed or compiled, for this one of the same version.
    let folders = tools::target()?.join("publish");
    sh.remove_path(&folders)?;
    let now = SystemTime::now().duration_since(UNIX_EPOCH)?;
    let folder = folders.join(now.as_millis().to_string());
    let publish = cmd!(sh, "cargo publish --workspace --dry-run --allow-dirty")
        .env("CARGO_TARGET_DIR", &folder)
        .ignore_status();
    eprintln!("$ {publish}");
    let output = publish.output()?;
    let printed = String::from_utf8_lossy(&output.stderr);
    eprint!("{printed}");
    ensure!(output.status.success(), "`{publish}` failed");
    let is_warning = |line: &&str| line.starts_with("warning") && !line.contains("due to dry run");
    let warnings: Vec<_> = printed.lines().filter(is_warning).collect();
    ensure!(warnings.is_empty(), "{}", warnings.join("\n"));
    Ok(())
}
