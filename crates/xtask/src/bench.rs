//! `cargo xtask bench`: measures natively, in Node, in headless Chromium and on
//! the page itself, beside other programs, and writes the figures into
//! `docs/evaluation.md`.

mod evaluation;
mod figures;
mod instructions;
mod programs;
mod targets;

use std::collections::BTreeMap;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use anyhow::{Context, Result, bail};
use serde_json::Value;

use crate::stages::browser;
use crate::{marks, paths, process, site, tools};
use figures::Figures;
use site::Module;

/// What `cargo xtask bench` is to do.
#[derive(Debug, PartialEq, Eq)]
pub enum Task {
    /// Measure, and write the figures down.
    Measure {
        /// A program to be measured beside Hearth.
        yardstick: Option<PathBuf>,
    },
    /// Count the instructions of fixed cases.
    Instructions {
        /// Write them down instead of holding them to those written down.
        write: bool,
    },
}

impl Task {
    /// Reads the options of `cargo xtask bench`; one that is unknown is given back.
    ///
    /// # Errors
    /// The first option that it does not know, or that lacks something.
    pub fn parse<'a>(mut options: impl Iterator<Item = &'a str>) -> Result<Task, String> {
        let (mut yardstick, mut instructions, mut write) = (None, false, false);
        while let Some(option) = options.next() {
            match option {
                "--instructions" => instructions = true,
                "--write" => write = true,
                "--yardstick" => match options.next() {
                    Some(path) => yardstick = Some(PathBuf::from(path)),
                    None => return Err(option.to_owned()),
                },
                other => match other.strip_prefix("--yardstick=") {
                    Some(path) => yardstick = Some(PathBuf::from(path)),
                    None => return Err(other.to_owned()),
                },
            }
        }
        match (yardstick, instructions, write) {
            (None, true, write) => Ok(Task::Instructions { write }),
            (yardstick, false, false) => Ok(Task::Measure { yardstick }),
            (_, _, true) => Err("--write".to_owned()),
            _ => Err("--yardstick".to_owned()),
        }
    }
}

/// The scenes of the benchmarks as a wasm module, compiled as the page's engine is.
const SCENES: Module = Module {
    package: "hearth-benches",
    profile: "engine",
};

/// Does what is asked.
///
/// # Errors
/// A tool that is missing, a measurement that fails, or instructions that have grown.
pub fn run(task: &Task) -> Result<()> {
    match task {
        Task::Measure { yardstick } => measure(yardstick.as_deref()),
        Task::Instructions { write } => instructions::run(*write),
    }
}

/// Fails where a step takes far more instructions than it did.
///
/// # Errors
/// It does, or no way to count them.
pub(crate) fn instructions() -> Result<()> {
    instructions::run(false)
}

/// Holds the baselines in JavaScript to Hearth.
///
/// # Errors
/// They compute another gas; or no Node.
pub(crate) fn baselines() -> Result<()> {
    tools::node()?;
    let gas = process::output(process::cargo().args([
        "run",
        "--quiet",
        "--package",
        SCENES.package,
        "--example",
        "native",
        "--",
        "gas",
    ]))?;
    let mut check = process::command("node")
        .arg("benches/browser/check.mjs")
        .stdin(Stdio::piped())
        .spawn()
        .context("cannot start `node`")?;
    if let Some(mut input) = check.stdin.take() {
        input.write_all(gas.as_bytes())?;
    }
    if !check.wait()?.success() {
        bail!("the baselines in JavaScript do not compute what Hearth computes");
    }
    Ok(())
}

fn measure(yardstick: Option<&Path>) -> Result<()> {
    let browser = tools::browser()?;
    browser::packages()?;
    baselines()?;
    site::build()?;
    site::compile(&SCENES)?;
    let target = site::target_folder()?;
    let folder = target.join("hearth-bench");
    site::bind(&SCENES, "hearth_benches", &folder)?;
    let native = native_programs(&target)?;
    let programs = programs::ready(yardstick, &target)?;

    println!("Measuring natively …");
    let criterion = target.join("criterion");
    for group in CRITERION {
        // What an earlier run noted of cases that are no more must not be told.
        if criterion.join(group).exists() {
            fs::remove_dir_all(criterion.join(group))?;
        }
    }
    process::run(process::cargo().args([
        "bench",
        "--profile",
        SCENES.profile,
        "--package",
        SCENES.package,
        "--bench",
        "step",
    ]))?;
    println!("Measuring in Node, in Chromium and beside other programs …");
    let figures = folder.join("figures.json");
    process::run(
        process::command("node")
            .arg("benches/browser/run.mjs")
            .arg(&figures)
            .env("HEARTH_BENCH", &folder)
            .env("HEARTH_NATIVE", native)
            .env("HEARTH_PROGRAMS", programs.to_string())
            .env("HEARTH_SITE", paths::site())
            .env("HEARTH_CHROMIUM", browser.chromium),
    )?;

    let text = fs::read_to_string(&figures).context("the measurement left no figures")?;
    let figures = Figures::read(&text)?;
    let measured = evaluation::tables(&figures, &native_times(&criterion)?);
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

/// Compiles Hearth's own native programs of the benchmarks; returns their folder.
fn native_programs(target: &Path) -> Result<PathBuf> {
    process::run(process::cargo().args([
        "build",
        "--profile",
        SCENES.profile,
        "--package",
        SCENES.package,
        "--examples",
    ]))?;
    Ok(target.join(SCENES.profile).join("examples"))
}

/// The groups of criterion's benchmarks.
const CRITERION: [&str; 2] = ["fire", "block"];

/// What criterion noted in `folder`: the median time of a step in milliseconds,
/// by `group/scene`.
fn native_times(folder: &Path) -> Result<BTreeMap<String, f64>> {
    let mut times = BTreeMap::new();
    for group in CRITERION {
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
                times.insert(format!("{group} {name}"), nanoseconds * 1e-6);
            }
        }
    }
    Ok(times)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<Task, String> {
        Task::parse(line.split_whitespace())
    }

    #[test]
    fn options_are_understood() {
        assert_eq!(parse(""), Ok(Task::Measure { yardstick: None }));
        let yardstick = Some(PathBuf::from("./other"));
        for line in ["--yardstick ./other", "--yardstick=./other"] {
            assert_eq!(
                parse(line),
                Ok(Task::Measure {
                    yardstick: yardstick.clone()
                })
            );
        }
        let count = |write| Ok(Task::Instructions { write });
        assert_eq!(parse("--instructions"), count(false));
        assert_eq!(parse("--write --instructions"), count(true));
    }

    #[test]
    fn nonsense_is_given_back() {
        for (line, option) in [
            ("--fast", "--fast"),
            ("--write", "--write"),
            ("--yardstick", "--yardstick"),
            ("--instructions --yardstick x", "--yardstick"),
        ] {
            assert_eq!(parse(line), Err(option.to_owned()));
        }
    }
}
