//! Stages that run wasm, in Node and in browsers.

use std::env;
use std::path::{Path, PathBuf};

use anyhow::Result;
use xshell::{Cmd, cmd};

use crate::shell::Shell;
use crate::{goldens, npm, package, paths, site, tools};

pub(super) fn wasm_in_node() -> Result<()> {
    tools::node()?;
    wasm_test("determinism", [tools::fingerprints()?])
}

pub(super) fn wasm_in_chromium() -> Result<()> {
    wasm_test("browser", [("CHROMEDRIVER", tools::CHROMEDRIVER.get()?)])
}

/// `.cargo/config.toml` names the runner of wasm tests, and `tests/webdriver.json` holds
/// the browser's flags. The profile is the engine's: fires burn twice as fast as in `dev`.
fn wasm_test(name: &str, variables: [(&str, PathBuf); 1]) -> Result<()> {
    tools::wasm_target()?;
    tools::wasm_bindgen_cli()?;
    let wasm = tools::WASM;
    let (flags, paths) = tools::portable_paths()?;
    let test =
        format!("test --target {wasm} --profile engine --package hearth-tests --test {name}");
    Ok(Shell::new()?
        .cargo(&test)
        .env(flags, paths)
        .envs(variables)
        // Seconds for one program: a browser draws slowly without a graphics card.
        .env("WASM_BINDGEN_TEST_TIMEOUT", "600")
        .run()?)
}

/// What runs in each browser with `--all`: the files of the quick ring, the life of the element, its sound and the
/// library.
const EVERYWHERE: [&str; 4] = ["core", "life", "sound", "sim"];

/// A dozen files of end-to-end tests, in Chromium.
pub(super) fn core() -> Result<()> {
    end_to_end(&["core"], &["chromium"], vec![])
}

/// The other end-to-end tests in Chromium, and a core of all in Firefox and WebKit.
pub(super) fn extended() -> Result<()> {
    tools::chinese_font()?;
    let mut programs = tools::browsers()?;
    programs.extend(goldens::programs()?);
    end_to_end(&["extended"], &["chromium"], programs.clone())?;
    end_to_end(&EVERYWHERE, &tools::wanted_browsers(), programs)
}

/// `cargo xtask browsers`: every end-to-end test in every browser, or the files of these names in the browsers of
/// `HEARTH_BROWSERS`, and the table of the evaluation from it.
pub(crate) fn table(names: Vec<String>) -> Result<()> {
    tools::chinese_font()?;
    let mut programs = tools::browsers()?;
    programs.extend(goldens::programs()?);
    if let Some(chosen) = env::var_os(tools::BROWSERS) {
        programs.push((tools::BROWSERS, chosen.into()));
    }
    run_script(
        "browsers.mjs",
        names.into_iter().map(PathBuf::from),
        programs,
    )
}

/// The end-to-end tests of these folders and files in these browsers.
fn end_to_end(names: &[&str], browsers: &[&str], variables: Vec<(&str, PathBuf)>) -> Result<()> {
    if browsers.is_empty() {
        return Ok(());
    }
    let sh = Shell::new()?;
    let test = script(&sh, "run.mjs", &paths::site())?.args(names);
    let test = test.envs(variables);
    Ok(test.env(tools::BROWSERS, browsers.join(",")).run()?)
}

/// The smallest end-to-end test, of the site in `folder` or of a page that is served at
/// `address`.
pub(super) fn smoke(folder: &Path, address: Option<&str>) -> Result<()> {
    let sh = Shell::new()?;
    let test = script(&sh, "run.mjs", folder)?.arg("smoke");
    Ok(test
        .envs(address.map(|address| ("HEARTH_PAGE", address)))
        .run()?)
}

/// Lets every project of `tests/consumers` use the npm package, in headless Chromium and in
/// Node.
pub(super) fn consumers() -> Result<()> {
    let chromium = tools::chromium()?;
    packages()?;
    let sh = Shell::new()?;
    sh.change_dir("tests/consumers");
    Ok(cmd!(sh, "node run.mjs")
        .env("HEARTH_CHROMIUM", chromium)
        .env("HEARTH_PACKAGE", package::folder())
        .env("HEARTH_YARD", tools::target()?.join("consumers"))
        .envs(goldens::programs()?)
        .run()?)
}

/// Builds the site and runs the script of that name in `tests/e2e` with these variables.
pub fn run_script(
    name: &str,
    arguments: impl IntoIterator<Item = PathBuf>,
    variables: Vec<(&str, PathBuf)>,
) -> Result<()> {
    let sh = Shell::new()?;
    let script = script(&sh, name, &paths::site())?;
    site::build()?;
    Ok(script.args(arguments).envs(variables).run()?)
}

/// A script of `tests/e2e` with the browser and the site in `folder`.
pub(crate) fn script<'a>(sh: &'a Shell, name: &str, folder: &Path) -> Result<Cmd<'a>> {
    let chromium = tools::chromium()?;
    packages()?;
    sh.change_dir("tests/e2e");
    Ok(cmd!(sh, "node {name}")
        .env("HEARTH_CHROMIUM", chromium)
        .env("HEARTH_SITE", folder))
}

/// Installs what drives browsers.
pub fn packages() -> Result<()> {
    npm::install(&paths::root().join("tests/e2e"))
}
