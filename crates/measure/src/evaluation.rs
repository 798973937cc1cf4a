//! `docs/evaluation.md`: measured tables in sections.

use std::fs;

use anyhow::{Context, Result};
use xtask::{paths, sections};

const PAGE: &str = "docs/evaluation.md";

/// Fails unless the page has the marks of that name: known before hours are measured.
pub(crate) fn check(name: &str) -> Result<()> {
    read(name).map(drop)
}

/// The section of that name.
pub(crate) fn read(name: &str) -> Result<String> {
    sections::read(&page()?, name).with_context(|| lacks(name))
}

/// Replaces the section of that name.
pub(crate) fn write(name: &str, section: &str) -> Result<()> {
    let page = sections::replaced(&page()?, name, section).with_context(|| lacks(name))?;
    fs::write(paths::root().join(PAGE), page)?;
    println!("wrote {PAGE}");
    Ok(())
}

fn page() -> Result<String> {
    fs::read_to_string(paths::root().join(PAGE)).context(PAGE)
}

fn lacks(name: &str) -> String {
    format!("{PAGE} lacks the marks `{name}`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_the_marks_of_every_command() -> Result<()> {
        for name in [
            "compared",
            "measured",
            "paper",
            "validated",
            "faults",
            "looked",
        ] {
            check(name)?;
        }
        Ok(())
    }
}
