//! `cargo xtask package`: the npm package, in `dist/npm`.
//!
//! The scripts of `packaging/` decide what goes into it and whether it is whole. Nothing
//! here publishes.

use std::path::{Path, PathBuf};

use anyhow::Result;
use xshell::cmd;

use crate::shell::Shell;
use crate::{npm, paths, script, site, tools};

/// Builds the site, makes the package of it, and writes the notices into the crate of the command.
pub(crate) fn build() -> Result<()> {
    let _lock = tools::writing(&paths::dist())?;
    site::build()?;
    make()?;
    command_notices()?;
    sizes(&folder(), false)?;
    println!(
        "The package is in {}; `npm pack` there makes the file to install or publish.",
        paths::shown(&folder())
    );
    Ok(())
}

/// Makes the package of the built site, and checks it.
pub(crate) fn make() -> Result<()> {
    npm::install(&paths::packaging())?;
    let _lock = tools::writing(&paths::dist())?;
    let (package, site, scripts) = (folder(), paths::site(), paths::packaging());
    let scratch = tools::target()?.join("package-check");
    // The crates of the workspace have the version of the package.
    let version = env!("CARGO_PKG_VERSION");
    let sh = Shell::new()?;
    cmd!(
        sh,
        "node {scripts}/build.mjs {site}/web {package} {version}"
    )
    .run()?;
    Ok(cmd!(sh, "node {scripts}/check.mjs {package} {scratch}").run()?)
}

/// Writes `THIRD-PARTY.txt` into the crate of the command `hearth`, which is published with it.
pub(crate) fn command_notices() -> Result<()> {
    tools::node()?;
    let (sh, scripts) = (Shell::new()?, paths::packaging());
    Ok(cmd!(sh, "node {scripts}/legal.mjs --command").run()?)
}

/// Prints the download sizes of a package or a site's `web` folder, and compares them with the
/// recorded ones, or records them.
pub(crate) fn sizes(folder: &Path, write: bool) -> Result<()> {
    script::tools()?;
    let (sh, scripts) = (Shell::new()?, paths::packaging());
    let write = write.then_some("--write");
    Ok(cmd!(sh, "node {scripts}/sizes.mjs {folder} {write...}").run()?)
}

/// Where the package is made.
pub(crate) fn folder() -> PathBuf {
    paths::dist().join("npm")
}
