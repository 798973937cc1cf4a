//! The stage that uses the npm package as people do.

use anyhow::Result;

use super::browser;
use crate::{package, paths, process, site, tools};

/// Makes the package of the built site, and gives it to its users: projects of all
/// sorts in `tests/consumers`, in headless Chromium and in Node.
pub(super) fn consumers() -> Result<()> {
    let browser = tools::browser()?;
    browser::packages()?;
    package::make()?;
    let folder = paths::root().join("tests").join("consumers");
    process::run(
        process::command("node")
            .current_dir(folder)
            .arg("run.mjs")
            .env("HEARTH_CHROMIUM", browser.chromium)
            .env("HEARTH_PACKAGE", package::folder())
            .env("HEARTH_YARD", site::target_folder()?.join("consumers")),
    )
}
