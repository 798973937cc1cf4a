//! Long runs of the physics: `cargo measure validate` compares it with theory and writes
//! the table and its plots into `docs/evaluation.md` and `docs/validation`; `cargo measure
//! soak` drives fires to random corners of all ranges and back, moves solids through them, burns heaps;
//! `cargo measure fuzz` sends random values to every decoder.

use anyhow::Result;
use xshell::{Cmd, cmd};
use xtask::shell::Shell;
use xtask::{browser, paths, tools};

use crate::evaluation;
use crate::flags::Soak;

/// Runs the cases whose names begin with one of `names`, or all of them. Only a run of
/// all is recorded, passed or failed.
pub(crate) fn run(names: &[String]) -> Result<()> {
    let sh = Shell::new()?;
    if !names.is_empty() {
        return Ok(example(&sh, "validate").args(names).run()?);
    }
    evaluation::check("validated")?;
    let folder = tools::target()?.join("hearth-validation");
    sh.remove_path(&folder)?;
    let passed = example(&sh, "validate").arg("--write").arg(&folder).run();
    let Ok(table) = sh.read_file(folder.join("table.md")) else {
        return Ok(passed?);
    };
    let plots = paths::root().join("docs/validation");
    sh.remove_path(&plots)?;
    sh.create_dir(&plots)?;
    let mut plotted = sh.read_dir(&folder)?;
    plotted.retain(|file| file.extension() == Some("svg".as_ref()));
    for plot in &plotted {
        sh.copy_file(plot, &plots)?;
    }
    evaluation::write("validated", &table)?;
    Ok(passed?)
}

/// Burns scenes for minutes, and visits corners, crowds of solids and heaps of bodies, for so many hours; or lets a page do
/// everything at random.
pub(crate) fn soak(soak: &Soak) -> Result<()> {
    if let Some(minutes) = soak.page {
        return browser::run_script("demand/soak.mjs", [minutes.to_string().into()], vec![]);
    }
    let numbers = [soak.corners, soak.crowds, soak.heaps, soak.seed];
    let times = [soak.hours, soak.minutes];
    let given = numbers
        .map(|number| number.map(|number| number.to_string()))
        .into_iter()
        .chain(times.map(|time| time.map(|time| time.to_string())))
        .chain([soak.scenes.clone()]);
    let names = [
        "corners", "crowds", "heaps", "seed", "hours", "minutes", "scenes",
    ];
    let given = names.into_iter().zip(given);
    let given = given.filter_map(|(name, value)| Some([format!("--{name}"), value?]));
    Ok(example(&Shell::new()?, "soak")
        .args(given.flatten())
        .run()?)
}

/// Tries every law of the decoders for that long: in Node, natively, and with inputs that coverage guides.
pub(crate) fn fuzz(minutes: Option<u32>, seed: Option<u32>) -> Result<()> {
    tools::node()?;
    let sh = Shell::new()?;
    for (name, value) in [("HEARTH_FUZZ_MINUTES", minutes), ("HEARTH_FUZZ_SEED", seed)] {
        if let Some(value) = value {
            sh.set_var(name, value.to_string());
        }
    }
    let limit = 600_000 + 4 * 60_000 * u64::from(minutes.unwrap_or(0));
    let option = format!("--test-timeout={limit}");
    cmd!(sh, "node --test {option} tests/web/fuzz.test.mjs").run()?;
    cmd!(sh, "cargo test --package hearth-tests --test laws fuzz::").run()?;
    xtask::fuzz::run(60 * minutes.unwrap_or(1), seed.unwrap_or(1))
}

/// A program of the tests' package.
fn example<'a>(sh: &'a Shell, name: &str) -> Cmd<'a> {
    let run = format!("run --quiet --release --package hearth-tests --example {name} --");
    sh.cargo(&run)
}
