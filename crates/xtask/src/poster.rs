//! `cargo xtask poster`: takes the picture that a link to Hearth shows,
//! `web/poster.jpg`. The fire on it is always the same; it wants a new picture
//! when the way in which fires are drawn has changed.

use anyhow::Result;

use crate::stages::browser;
use crate::{paths, process};

/// Builds the site and takes the picture of a fire in it.
///
/// # Errors
/// No browser, no Node, a site that does not build, or a picture without a fire.
pub fn take() -> Result<()> {
    let mut script = browser::script("poster.mjs")?;
    process::run(script.arg(paths::root().join("web").join("poster.jpg")))
}
