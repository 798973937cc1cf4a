//! `cargo measure bench`: measures natively, in Node, in headless Chromium and on the page
//! itself, beside other programs, and writes the figures into `docs/evaluation.md`.

mod figures;
mod programs;
mod tables;
mod targets;

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use serde_json::Value;
use xshell::cmd;
use xtask::shell::Shell;
use xtask::site::{self, Module};
use xtask::{baselines, browser, paths, tools};

use crate::evaluation;
use figures::Figures;

/// The scenes of the benchmarks as a wasm module, compiled as the page's engine is.
const SCENES: Module = Module::new("hearth-benches", "engine");

/// The groups of criterion's benchmarks.
const CRITERION: [&str; 2] = ["fire", "block"];

/// Presses the button of `bench.html` and records its tables.
pub(crate) fn paper() -> Result<()> {
    evaluation::check("paper")?;
    let tables = tools::target()?.join("hearth-paper.md");
    browser::run_script("demand/bench-page.mjs", [tables.clone()], vec![])?;
    evaluation::write("paper", &Shell::new()?.read_file(tables)?)
}

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
    let package = format!("--profile {profile} --package {package}");
    sh.cargo(&format!("build {package} --examples")).run()?;
    let programs = programs::ready(yardstick, &target)?;

    println!("Measuring natively …");
    let criterion = target.join("criterion");
    for group in CRITERION {
        // An earlier run may have had other cases.
        sh.remove_path(criterion.join(group))?;
    }
    sh.cargo(&format!("bench {package}-step")).run()?;
    println!("Measuring in Node, in Chromium and beside other programs …");
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
    let measured = tables::cost(&figures, &native_times(&sh, &criterion)?);
    println!("{compared}\n{measured}");
    evaluation::write("compared", &compared)?;
    evaluation::write("measured", &measured)
}

/// The median time of a step in milliseconds that criterion recorded in `folder`, by group
/// and scene.
fn native_times(sh: &Shell, folder: &Path) -> Result<BTreeMap<String, f64>> {
    let mut times = BTreeMap::new();
    for group in CRITERION {
        for scene in sh.read_dir(folder.join(group))? {
            let Ok(text) = sh.read_file(scene.join("new/estimates.json")) else {
                continue;
            };
            let estimates: Value = serde_json::from_str(&text)?;
            let nanoseconds = estimates["median"]["point_estimate"].as_f64();
            let nanoseconds = nanoseconds.context("criterion recorded no median")?;
            let scene = scene.file_name().unwrap_or_default().to_string_lossy();
            times.insert(format!("{group} {scene}"), nanoseconds * 1e-6);
        }
    }
    Ok(times)
}
