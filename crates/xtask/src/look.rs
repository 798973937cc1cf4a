//! `cargo xtask look`: watches every scene for a minute, for flashes and for what else
//! its pixels say, and writes the table into `docs/evaluation.md`.

use std::fs;

use anyhow::{Context, Result, bail};

use crate::{goldens, marks, paths, process, site};

/// Watches the scenes whose names begin with one of `names`, or all of them. Only a
/// look at all is written down.
///
/// # Errors
/// A figure that misses its bar; no browser, or no scene of a name.
pub fn run(names: &[String]) -> Result<()> {
    let mut watch = goldens::script("watch.mjs")?;
    let table = site::target_folder()?.join("hearth-look").join("table.md");
    if table.exists() {
        fs::remove_file(&table)?;
    }
    watch.arg(&table).args(names);
    if !names.is_empty() {
        return process::run(&mut watch);
    }

    // A minute of every scene is long: it is to be known before that it can be written down.
    write(None)?;
    let held = process::run(&mut watch);
    // What was seen is written down whether or not it holds.
    let Ok(table) = fs::read_to_string(table) else {
        held?;
        bail!("nobody looked");
    };
    write(Some(&table))?;
    held
}

/// Writes that table into the page; without one it only sees that it could.
fn write(table: Option<&str>) -> Result<()> {
    let page = paths::root().join("docs").join("evaluation.md");
    let present = fs::read_to_string(&page)
        .with_context(|| format!("cannot read {}", paths::shown(&page)))?;
    let updated = marks::with(&present, "looked", table.unwrap_or_default())
        .with_context(|| format!("{} lacks the marks `looked`", paths::shown(&page)))?;
    if table.is_some() {
        fs::write(&page, updated)?;
        println!("wrote {}", paths::shown(&page));
    }
    Ok(())
}
