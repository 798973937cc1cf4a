//! `cargo measure soak`: burns scenes for minutes, drives fires to random corners of all ranges and back, moves solids through
//! them, burns heaps; or lets a page do everything at random. Long runs are recorded in `docs/evaluation.md`.

use std::fs;

use anyhow::Result;
use xtask::shell::Shell;
use xtask::{browser, tools};

use crate::evaluation;
use crate::flags::Soak;
use crate::validate::example;

/// From so many minutes on, scenes and a page are recorded.
const RECORDED: f64 = 10.0;

/// Burns scenes for minutes, and visits corners, crowds of solids and heaps of bodies, for so many hours; or a page.
pub(crate) fn run(soak: &Soak) -> Result<()> {
    if let Some(minutes) = soak.page {
        return page(minutes);
    }
    let sh = Shell::new()?;
    let numbers = [soak.corners, soak.crowds, soak.heaps, soak.seed];
    let times = [soak.hours, soak.minutes];
    let mut given: Vec<_> = numbers
        .map(|number| number.map(|number| number.to_string()))
        .into_iter()
        .chain(times.map(|time| time.map(|time| time.to_string())))
        .chain([soak.scenes.clone()])
        .zip([
            "corners", "crowds", "heaps", "seed", "hours", "minutes", "scenes",
        ])
        .filter_map(|(value, name)| Some([format!("--{name}"), value?]))
        .collect();
    if soak.minutes.is_none_or(|minutes| minutes < RECORDED) {
        return Ok(example(&sh, "soak").args(given.as_flattened()).run()?);
    }
    let table = tools::target()?.join("hearth-burnt.md");
    sh.write_file(&table, evaluation::read("burnt")?)?;
    let file = table.display().to_string();
    given.extend([
        ["--table".to_owned(), file],
        ["--of".to_owned(), evaluation::commit()?],
    ]);
    let passed = example(&sh, "soak").args(given.as_flattened()).run();
    evaluation::write("burnt", &fs::read_to_string(table)?)?;
    Ok(passed?)
}

/// Everything happens at random on a page.
fn page(minutes: f64) -> Result<()> {
    evaluation::check("page-soak")?;
    let table = tools::target()?.join("hearth-page-soak.md");
    Shell::new()?.remove_path(&table)?;
    let arguments = [table.clone(), minutes.to_string().into()];
    let passed = browser::run_script("demand/soak.mjs", arguments, vec![]);
    if minutes >= RECORDED && table.exists() {
        let measured = format!("Measured at {}.\n\n", evaluation::commit()?);
        evaluation::write("page-soak", &(measured + &fs::read_to_string(table)?))?;
    }
    passed
}
