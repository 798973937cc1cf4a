//! The npm packages that a folder's lock file pins.

use std::fs;
use std::path::Path;

use anyhow::Result;

use crate::shell::{self, Shell};
use crate::tools;

/// Installs what the lock file in `folder` pins, unless that is done.
pub(crate) fn install(folder: &Path) -> Result<()> {
    tools::node()?;
    let _only = tools::installing();
    let written = |file: &str| fs::metadata(folder.join(file)).and_then(|about| about.modified());
    let installed = written("node_modules/.package-lock.json");
    if let (Ok(installed), Ok(locked)) = (installed, written("package-lock.json"))
        && installed >= locked
    {
        return Ok(());
    }
    let sh = Shell::new()?;
    sh.change_dir(folder);
    // On Windows npm is a script, which only its full path starts.
    let npm = shell::find("npm").unwrap_or_else(|| "npm".into());
    Ok(sh.cmd(npm).arg("ci").run()?)
}
