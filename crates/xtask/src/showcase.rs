//! `cargo xtask showcase`: takes the pictures that show in documentation what Hearth
//! draws: `docs/fire.webp`, five seconds of a fire, and, where pictures of other
//! systems are given, `docs/comparison.jpg`, a sheet of ours and theirs.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};

use crate::stages::browser;
use crate::{paths, process, site, tools};

/// Most of the animation \[bytes\].
const LARGEST: u64 = 2_000_000;
/// Time of a frame \[ms\]; `RATE` in `tests/e2e/showcase.mjs`.
const FRAME: &str = "50";

/// Builds the site and takes the pictures; `others` are set beside ours.
///
/// # Errors
/// No browser, no Node, no `img2webp`, a site that does not build, or an animation that
/// is too large.
pub fn take(others: &[PathBuf]) -> Result<()> {
    let browser = tools::browser()?;
    tools::webp()?;
    browser::packages()?;
    site::build()?;
    let root = paths::root();
    let docs = root.join("docs");
    let frames = paths::root().join("target").join("showcase");
    if frames.exists() {
        fs::remove_dir_all(&frames).context("the folder of the frames")?;
    }
    fs::create_dir_all(&frames).context("the folder of the frames")?;
    let mut node = process::command("node");
    node.current_dir(root.join("tests").join("e2e"))
        .arg("showcase.mjs")
        .arg(&frames)
        .env("HEARTH_CHROMIUM", browser.chromium)
        .env("HEARTH_SITE", paths::site());
    if !others.is_empty() {
        node.arg(docs.join("comparison.jpg"));
        for other in others {
            node.arg(
                other
                    .canonicalize()
                    .with_context(|| format!("no {}", other.display()))?,
            );
        }
    }
    process::run(&mut node)?;

    let mut pictures: Vec<PathBuf> = fs::read_dir(&frames)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    pictures.sort();
    let animation = docs.join("fire.webp");
    process::run(
        process::command("img2webp")
            .args(["-loop", "0", "-lossy", "-q", "62", "-m", "6", "-d", FRAME])
            .args(&pictures)
            .arg("-o")
            .arg(&animation),
    )?;
    let size = fs::metadata(&animation)?.len();
    if size > LARGEST {
        bail!("the animation takes {size} bytes, more than {LARGEST}");
    }
    println!(
        "{}: {} frames, {size} bytes",
        animation.display(),
        pictures.len()
    );
    Ok(())
}
