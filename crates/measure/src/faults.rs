//! `cargo measure faults`: fails each part that a fire needs of its browser, and writes what a visitor
//! sees into `docs/evaluation.md`.

use std::{fs, iter};

use anyhow::Result;
use xtask::shell::Shell;
use xtask::{browser, tools};

use crate::evaluation;

/// Runs the sections of that name, or all of them. Only a run of all is recorded, passed or failed.
pub(crate) fn run(names: &[String]) -> Result<()> {
    evaluation::check("faults")?;
    let table = tools::target()?.join("hearth-faults.md");
    Shell::new()?.remove_path(&table)?;
    let arguments = iter::once(table.clone()).chain(names.iter().map(Into::into));
    let passed = browser::run_script("demand/faults.mjs", arguments, tools::browsers()?);
    if names.is_empty() && table.exists() {
        evaluation::write("faults", &fs::read_to_string(table)?)?;
    }
    passed
}
