//! `cargo xtask bench`: measures natively, in Node, in headless Chromium and on
//! the page itself, and writes the figures into `docs/evaluation.md`.

mod evaluation;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use serde_json::Value;

use crate::stages::browser;
use crate::{marks, paths, process, site, tools};
use site::Module;

/// The scenes of the benchmarks as a wasm module, compiled as the page's engine is.
const SCENES: Module = Module {
    package: "hearth-benches",
    profile: "engine",
};

/// Runs every measurement and writes down the figures.
///
/// # Errors
/// A tool that is missing, or a measurement that fails.
pub fn run() -> Result<()> {
    let browser = tools::browser()?;
    site::build()?;
    site::compile(&SCENES)?;
    let folder = site::target_folder()?.join("hearth-bench");
    site::bind(&SCENES, "hearth_benches", &folder)?;
    browser::packages()?;

    println!("Measuring natively …");
    process::run(process::cargo().args(["bench", "--package", SCENES.package]))?;
    println!("Measuring in Node and in Chromium …");
    let figures = folder.join("figures.json");
    process::run(
        process::command("node")
            .arg("benches/browser/run.mjs")
            .arg(&figures)
            .env("HEARTH_BENCH", &folder)
            .env("HEARTH_SITE", paths::site())
            .env("HEARTH_CHROMIUM", browser.chromium),
    )?;

    let text = fs::read_to_string(&figures).context("the measurement left no figures")?;
    let figures: Value = serde_json::from_str(&text).context("the figures cannot be read")?;
    let native = native_times(&site::target_folder()?.join("criterion"))?;
    let measured = evaluation::tables(&figures, &native);
    println!("{measured}");
    let page = paths::root().join("docs").join("evaluation.md");
    let present = fs::read_to_string(&page)
        .with_context(|| format!("cannot read {}", paths::shown(&page)))?;
    let updated = marks::with(&present, "measured", &measured)
        .with_context(|| format!("{} lacks its marks", paths::shown(&page)))?;
    fs::write(&page, updated)?;
    println!("wrote {}", paths::shown(&page));
    Ok(())
}

/// What criterion noted in `folder`: the median time of a step in milliseconds,
/// by `group/scene`.
fn native_times(folder: &Path) -> Result<BTreeMap<String, f64>> {
    let mut times = BTreeMap::new();
    for group in ["fire", "block"] {
        let listed = fs::read_dir(folder.join(group))
            .with_context(|| format!("criterion noted nothing of {group}"))?;
        for scene in listed {
            let scene = scene?;
            let noted = scene.path().join("new").join("estimates.json");
            let Ok(text) = fs::read_to_string(noted) else {
                continue;
            };
            let noted: Value = serde_json::from_str(&text)?;
            if let Some(nanoseconds) = noted["median"]["point_estimate"].as_f64() {
                let name = scene.file_name().to_string_lossy().into_owned();
                times.insert(format!("{group}/{name}"), nanoseconds * 1e-6);
            }
        }
    }
    Ok(times)
}
