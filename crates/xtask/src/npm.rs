//! What npm installs, in the folders that pin it.

use std::fs;
use std::path::Path;

use anyhow::Result;

use crate::{process, tools};

/// Installs what the lock file in `folder` says, if that was not done since it was
/// written.
///
/// # Errors
/// No Node, or npm cannot install.
pub(crate) fn install(folder: &Path) -> Result<()> {
    tools::node()?;
    let written = |file: &str| fs::metadata(folder.join(file)).and_then(|about| about.modified());
    let fresh = match (
        written("node_modules/.package-lock.json"),
        written("package-lock.json"),
    ) {
        (Ok(installed), Ok(locked)) => installed >= locked,
        _ => false,
    };
    if fresh {
        return Ok(());
    }
    // On Windows npm is a script, which only its full path starts.
    let npm = process::find("npm").unwrap_or_else(|| "npm".into());
    process::run(process::command(npm).current_dir(folder).arg("ci"))
}
