//! Stages that run wasm, in Node and in browsers.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::{npm, paths, process, site, tools};

/// Longest time for one wasm test program, in seconds: a browser that draws
/// without a GPU on two cores is slow.
const PATIENCE: &str = "600";

pub(super) fn wasm_in_node() -> Result<()> {
    tools::wasm_target()?;
    tools::node()?;
    tools::wasm_bindgen_cli()?;
    process::run(&mut wasm_test("determinism"))
}

pub(super) fn wasm_in_chromium() -> Result<()> {
    tools::wasm_target()?;
    let browser = tools::browser()?;
    tools::wasm_bindgen_cli()?;
    process::run(wasm_test("browser").env("CHROMEDRIVER", browser.driver))
}

/// `.cargo/config.toml` names the runner of wasm tests, and
/// `tests/webdriver.json` holds the browser's flags.
fn wasm_test(name: &str) -> Command {
    let mut test = process::cargo();
    test.args(["test", "--target", tools::WASM, "--package", "hearth-tests"])
        .args(["--test", name])
        .env("WASM_BINDGEN_TEST_TIMEOUT", PATIENCE);
    test
}

/// Everything end to end: in Chromium, and what holds in every browser in Firefox and
/// WebKit as well.
pub(super) fn end_to_end() -> Result<()> {
    let mut test = in_e2e("node");
    test.arg("run.mjs").envs(tools::other_browsers()?);
    drive(&mut test, &paths::site())
}

/// The smallest of the tests end to end, against the site in `folder`, or
/// against the one that somebody else serves at `address`.
pub(super) fn smoke(folder: &Path, address: Option<&str>) -> Result<()> {
    let mut test = in_e2e("node");
    test.args(["run.mjs", "smoke"]);
    if let Some(address) = address {
        test.env("HEARTH_PAGE", address);
    }
    drive(&mut test, folder)
}

/// Runs a test that drives Chromium against the site in `folder`.
fn drive(test: &mut Command, folder: &Path) -> Result<()> {
    equip(test, folder)?;
    process::run(test)
}

/// Builds the site; returns the script of that name beside the tests, with what it needs
/// to look at it.
///
/// # Errors
/// No browser, no Node, or a site that does not build.
pub(crate) fn script(name: &str) -> Result<Command> {
    let mut script = in_e2e("node");
    script.arg(name);
    equip(&mut script, &paths::site())?;
    site::build()?;
    Ok(script)
}

/// Gives a script the browser, and the site in `folder`.
fn equip(script: &mut Command, folder: &Path) -> Result<()> {
    let browser = tools::browser()?;
    packages()?;
    script
        .env("HEARTH_CHROMIUM", browser.chromium)
        .env("HEARTH_SITE", folder);
    Ok(())
}

/// Makes sure that what drives the browser is installed.
///
/// # Errors
/// No Node, or npm cannot install.
pub(crate) fn packages() -> Result<()> {
    npm::install(&e2e())
}

fn e2e() -> PathBuf {
    paths::root().join("tests").join("e2e")
}

fn in_e2e(program: &str) -> Command {
    let mut command = process::command(program);
    command.current_dir(e2e());
    command
}
