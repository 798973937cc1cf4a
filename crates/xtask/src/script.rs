//! Scripts and style sheets as visitors download them: `scripts/` minifies them. Comments
//! and long names would be half of the download.

use std::path::{Path, PathBuf};

use anyhow::Result;
use xshell::cmd;

use crate::shell::Shell;
use crate::{npm, paths};

/// Installs esbuild, which `scripts/` pins.
pub(crate) fn tools() -> Result<()> {
    npm::install(&folder())
}

/// Minifies every script and style sheet of the site in place; `web` is the folder with
/// `package.json`. A script that only one other imports is merged into that one.
pub(crate) fn minify(web: &Path) -> Result<()> {
    tools()?;
    let (sh, scripts) = (Shell::new()?, folder());
    Ok(cmd!(sh, "node {scripts}/minify.mjs {web}").run()?)
}

/// Puts the examples with the engines of others, which their folder pins, into the site.
pub(crate) fn bundle_worlds(site: &Path) -> Result<()> {
    npm::install(&paths::root().join("examples/worlds"))?;
    let (sh, scripts) = (Shell::new()?, folder());
    Ok(cmd!(sh, "node {scripts}/worlds.mjs {site}").run()?)
}

/// Checks the format of scripts, and lints scripts and style sheets, by `biome.json`.
pub(crate) fn lint() -> Result<()> {
    node_program(
        "@biomejs/biome/bin/biome",
        &["check", "--error-on-warnings"],
    )
}

/// Checks the types of scripts: strictly those of `web/` (`tsconfig.json`), then those that
/// build and test it. The types of the wasm modules are those of the built site.
pub(crate) fn check_types() -> Result<()> {
    for packages in ["crates/xtask/packaging", "tests/e2e"] {
        npm::install(&paths::root().join(packages))?;
    }
    for project in ["tsconfig.json", "tsconfig.scripts.json"] {
        node_program("typescript/bin/tsc", &["--project", project])?;
    }
    Ok(())
}

/// Writes every generated file of the checkout that is missing or differs; returns those. The files of
/// the element's class come after the table's, because they name parameters.
pub(crate) fn generated_files() -> Result<Vec<String>> {
    tools()?;
    let mut written = codegen::refresh(&paths::root())?;
    let sh = Shell::new()?;
    let element = cmd!(sh, "node crates/codegen/element.mjs").read()?;
    written.extend(element.lines().map(str::to_owned));
    Ok(written)
}

/// Runs a program that `scripts/` pins.
fn node_program(name: &str, arguments: &[&str]) -> Result<()> {
    tools()?;
    let (sh, modules) = (Shell::new()?, folder().join("node_modules"));
    Ok(cmd!(sh, "node {modules}/{name} {arguments...}").run()?)
}

pub(crate) fn folder() -> PathBuf {
    paths::root().join("crates/xtask/scripts")
}
