//! `cargo measure bench`: measures natively, in Node, in headless Chromium and on the page
//! itself, beside other programs, and writes the figures into `docs/evaluation.md`.

mod figures;
mod programs;
mod tables;
mod targets;

use std::path::Path;

use anyhow::Result;
use xshell::cmd;
use xtask::shell::Shell;
use xtask::site::{self, Module};
use xtask::{baselines, browser, paths, tools};

use crate::evaluation;
use figures::Figures;

/// The scenes of the benchmarks as a wasm module, compiled as the page's engine is.
const SCENES: Module = Module::new("hearth-benches", "engine");

/// Measures everything, and the program `yardstick` too.
pub(crate) fn run(yardstick: Option<&Path>) -> Result<()> {
    let chromium = tools::chromium()?;
    browser::packages()?;
    for section in ["compared", "measured"] {
        evaluation::check(section)?;
    }
    baselines::check()?;
    site::build()?;
    site::compile(&SCENES, &[])?;
    let target = tools::target()?;
    let folder = target.join("hearth-bench");
    site::bind(&SCENES, "hearth_benches", &folder)?;
    let (sh, Module { package, profile }) = (Shell::new()?, SCENES);
    let build = format!("build --profile {profile} --package {package} --examples");
    sh.cargo(&build).run()?;
    let programs = programs::ready(yardstick, &target)?;

    println!("Measuring natively, in Node, in Chromium and beside other programs …");
    let file = folder.join("figures.json");
    cmd!(sh, "node benches/browser/run.mjs {file}")
        .env("HEARTH_BENCH", &folder)
        .env("HEARTH_NATIVE", target.join(profile).join("examples"))
        .env("HEARTH_PROGRAMS", programs.to_string())
        .env("HEARTH_SITE", paths::site())
        .env("HEARTH_CHROMIUM", chromium)
        .run()?;

    let figures = Figures::read(&sh.read_file(file)?)?;
    let compared = tables::compared(&figures);
    let measured = tables::cost(&figures);
    println!("{compared}\n{measured}");
    evaluation::write("compared", &compared)?;
    evaluation::write("measured", &measured)
}

/// Presses the button of `bench.html` and records its tables.
pub(crate) fn paper() -> Result<()> {
    evaluation::check("paper")?;
    let tables = tools::target()?.join("hearth-paper.md");
    browser::run_script("demand/bench-page.mjs", [tables.clone()], vec![])?;
    evaluation::write("paper", &Shell::new()?.read_file(tables)?)
}
