//! `cargo xtask poster`: takes the picture that a link to Hearth shows, and the page
//! while its fire loads: `web/poster.jpg`, a moment of the scene that the page opens with.
//! The same scene gives the same picture; it needs a new one when the scene changes, or the
//! way in which fires are drawn.

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
