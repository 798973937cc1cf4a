//! `cargo xtask package`: the npm package, in `dist/npm`.
//!
//! What goes into it, what is made of it and whether it is whole is said by the
//! scripts of `packaging/`, which need npm's tools; here they get what they need.
//! Nothing is ever published from here.

use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::{npm, paths, process, site};

/// Builds the site and makes the package of it.
///
/// # Errors
/// A site that does not build, no Node, or a package that is not whole.
pub fn build() -> Result<()> {
    site::build()?;
    make()?;
    println!(
        "The package is in {}; `npm pack` there makes the file that others install.",
        paths::shown(&folder())
    );
    Ok(())
}

/// Makes the package of the site that is built.
pub(crate) fn make() -> Result<()> {
    npm::install(&packaging())?;
    let (package, web) = (folder(), paths::site().join("web"));
    let scratch = site::target_folder()?.join("package-check");
    // The crates of the workspace share their version with the package.
    let version = Path::new(env!("CARGO_PKG_VERSION"));
    script("build.mjs", &[&web, &package, version])?;
    script("check.mjs", &[&package, &scratch])?;
    script("sizes.mjs", &[&package])
}

/// Where the package is made.
pub(crate) fn folder() -> PathBuf {
    paths::root().join("dist").join("npm")
}

fn packaging() -> PathBuf {
    paths::root().join("crates").join("xtask").join("packaging")
}

fn script(name: &str, arguments: &[&Path]) -> Result<()> {
    process::run(
        process::command("node")
            .arg(packaging().join(name))
            .args(arguments),
    )
}
