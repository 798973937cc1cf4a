//! Measured tables in sections of `docs/evaluation.md`, and of `docs/look.md`.

use std::fs;

use anyhow::{Context, Result};
use xshell::cmd;
use xtask::shell::Shell;
use xtask::{paths, sections};

/// The page with the section of that name.
fn page_of(name: &str) -> &'static str {
    match name {
        "filmed" => "docs/look.md",
        _ => "docs/evaluation.md",
    }
}

/// Fails unless the page has the marks of that name: known before hours are measured.
pub(crate) fn check(name: &str) -> Result<()> {
    read(name).map(drop)
}

/// The section of that name.
pub(crate) fn read(name: &str) -> Result<String> {
    sections::read(&page(name)?, name).with_context(|| lacks(name))
}

/// Replaces the section of that name.
pub(crate) fn write(name: &str, section: &str) -> Result<()> {
    let page = sections::replaced(&page(name)?, name, section).with_context(|| lacks(name))?;
    let file = page_of(name);
    fs::write(paths::root().join(file), page)?;
    println!("wrote {file}");
    Ok(())
}

/// The commit that is measured, with its date.
pub(crate) fn commit() -> Result<String> {
    let (sh, format) = (Shell::new()?, "%h, %cs");
    Ok(cmd!(sh, "git show --no-patch --abbrev=8 --format={format} HEAD").read()?)
}

fn page(name: &str) -> Result<String> {
    let file = page_of(name);
    fs::read_to_string(paths::root().join(file)).context(file)
}

fn lacks(name: &str) -> String {
    format!("{} lacks the marks `{name}`", page_of(name))
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
            "burnt",
            "page-soak",
            "fuzzed",
            "covered",
            "looked",
            "filmed",
        ] {
            check(name)?;
        }
        Ok(())
    }
}
