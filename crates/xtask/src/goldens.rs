//! Golden pictures: the tests that compare with them, and `cargo xtask goldens`, which
//! draws them again.
//!
//! Both draw stored fires with the renderer in headless Chromium without a graphics card,
//! whose pictures are the same on every machine.

use std::iter;
use std::path::PathBuf;

use anyhow::Result;
use xshell::cmd;

use crate::shell::Shell;
use crate::site::{self, Module};
use crate::stages::browser;
use crate::{paths, tools};

/// The renderer for tests, in the profile of the engine: the tests burn minutes of fire, which takes
/// twice as long in the profile `dev`.
const PAINTER: Module = Module::new("hearth-painter", "engine");

/// Draws the pictures whose names begin with one of `names`, or all; with `snapshots` of
/// fires simulated again.
pub(crate) fn write(snapshots: bool, names: &[String]) -> Result<()> {
    if snapshots {
        let folder = paths::root().join("tests/goldens/snapshots");
        let run = "run --quiet --release --package hearth-painter --example snapshots --";
        Shell::new()?.cargo(run).arg(folder).run()?;
    }
    run_script("write.mjs", names.iter().map(Into::into))
}

/// Compares what is drawn with the goldens, and runs the other tests of pictures.
pub(crate) fn check() -> Result<()> {
    run_script("run.mjs", iter::empty())
}

/// Runs a script of `tests/look` with a painter and a browser.
pub fn run_script(name: &str, arguments: impl Iterator<Item = PathBuf>) -> Result<()> {
    let chromium = tools::chromium()?;
    browser::packages()?;
    tools::wasm_target()?;
    site::compile(&PAINTER, &[])?;
    let folder = tools::target()?.join("hearth-look");
    let painter = folder.join("painter");
    site::bind(&PAINTER, "painter", &painter)?;
    let sh = Shell::new()?;
    sh.remove_path(folder.join("shown"))?;
    sh.change_dir("tests/look");
    Ok(cmd!(sh, "node {name}")
        .args(arguments)
        .env("HEARTH_CHROMIUM", chromium)
        .env("HEARTH_PAINTER", painter)
        .env("HEARTH_SHOWN", folder.join("shown"))
        .run()?)
}
