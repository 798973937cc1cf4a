//! `cargo measure faults`: fails each part that a fire needs of its browser or its system, and writes what a visitor
//! sees into `docs/evaluation.md`.

use std::{fs, iter};

use anyhow::Result;
use xtask::shell::Shell;
use xtask::{browser, tools};

use crate::evaluation;

/// Runs the sections of these names, whose rows are recorded then, passed or failed; or all of them.
pub(crate) fn run(names: &[String]) -> Result<()> {
    let before = evaluation::read("faults")?;
    let (sh, target) = (Shell::new()?, tools::target()?);
    sh.cargo("build --package hearth-fire-cli").run()?;
    let table = target.join("hearth-faults.md");
    sh.write_file(&table, before)?;
    let mut variables = tools::browsers()?;
    variables.extend([
        tools::strace()?,
        ("HEARTH_COMMAND", target.join("debug/hearth")),
        ("HEARTH_COMMIT", evaluation::commit()?.into()),
    ]);
    let arguments = iter::once(table.clone()).chain(names.iter().map(Into::into));
    let passed = browser::run_script("demand/faults.mjs", arguments, variables);
    evaluation::write("faults", &fs::read_to_string(table)?)?;
    passed
}
