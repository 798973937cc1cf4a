//! `cargo xtask showcase`: takes the animation that shows in documentation what Hearth
//! draws: `docs/fire.webp`, five seconds of the scene that the page opens with.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};

use crate::stages::browser;
use crate::{paths, process, site, tools};

/// Most of the animation \[bytes\].
const LARGEST: u64 = 2_000_000;
/// Pictures a second of it.
const RATE: u32 = 20;

/// Builds the site and takes the animation.
///
/// # Errors
/// No browser, no Node, no `img2webp`, a site that does not build, or an animation that
/// is too large.
pub fn take() -> Result<()> {
    tools::webp()?;
    let mut script = browser::script("showcase.mjs")?;
    let docs = paths::root().join("docs");
    let made = site::target_folder()?.join("hearth-showcase");
    if made.exists() {
        fs::remove_dir_all(&made).context("the folder of the frames")?;
    }
    fs::create_dir_all(&made).context("the folder of the frames")?;
    script.arg(&made).arg(RATE.to_string());
    process::run(&mut script)?;

    let mut frames: Vec<PathBuf> = fs::read_dir(&made)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    frames.sort();
    // Looked at before it takes the place of the last one.
    let animation = made.join("fire.webp");
    process::run(
        process::command("img2webp")
            // Each frame is whole: what is left out between whole ones shows as blocks.
            .args(["-loop", "0", "-kmin", "0", "-kmax", "1"])
            .args(["-lossy", "-q", "50", "-m", "6", "-d"])
            .arg((1000 / RATE).to_string())
            .args(&frames)
            .arg("-o")
            .arg(&animation),
    )?;
    let size = fs::metadata(&animation)?.len();
    if size > LARGEST {
        bail!("the animation takes {size} bytes, more than {LARGEST}");
    }
    fs::copy(&animation, docs.join("fire.webp"))?;
    println!("docs/fire.webp: {} frames, {size} bytes", frames.len());
    Ok(())
}
