//! `cargo measure look`: checks a minute of every scene for flashes, and for what else its
//! pixels show, and writes the table into `docs/evaluation.md`. Then it measures some scenes as films
//! of wood fires were measured, for the table of `docs/look.md`.

use std::{fs, iter};

use anyhow::{Result, bail};
use xtask::shell::Shell;
use xtask::{goldens, tools};

use crate::evaluation;

/// Checks all scenes, or those whose names begin with one of `names`: then the rows of the
/// others stay. What is found is recorded, passed or failed.
pub(crate) fn run(names: &[String]) -> Result<()> {
    let before = evaluation::read("looked")?;
    let table = tools::target()?.join("hearth-look/table.md");
    let sh = Shell::new()?;
    sh.remove_path(&table)?;
    if !names.is_empty() {
        sh.write_file(&table, before)?;
    }
    let arguments = iter::once(table.clone()).chain(names.iter().map(Into::into));
    let passed = goldens::run_script("flash-scan.mjs", arguments, None);
    match fs::read_to_string(table) {
        Ok(table) => evaluation::write("looked", &table)?,
        Err(_) if passed.is_ok() => bail!("the scenes were not recorded"),
        Err(_) => {}
    }
    beside_films(names)?;
    passed
}

/// Measures scenes beside films. The columns of scenes without one of `names` stay.
fn beside_films(names: &[String]) -> Result<()> {
    let table = tools::target()?.join("hearth-look/films.md");
    let before = match names {
        [] => String::new(),
        _ => evaluation::read("filmed")?,
    };
    Shell::new()?.write_file(&table, before)?;
    let arguments = iter::once(table.clone()).chain(names.iter().map(Into::into));
    goldens::run_script("wood-fires.mjs", arguments, None)?;
    evaluation::write("filmed", &fs::read_to_string(table)?)
}
