//! Other people's solvers that are measured beside Hearth. One that cannot be
//! had on a machine is left out, and the report says so.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde_json::{Value, json};

use crate::{paths, process};

/// Most particles that they are asked for: a step of more takes seconds.
const MOST: u32 = 100_000;

/// The version of pySPlisHSPlasH that is known to work.
const PYSPLISHSPLASH: &str = "pysplishsplash==2.19.0";

/// The programs as `benches/browser/run.mjs` wants them, and what is left out.
///
/// # Errors
/// A yardstick that is not there.
pub(super) fn ready(yardstick: Option<&Path>, target: &Path) -> Result<Value> {
    let (mut programs, mut left_out) = (Vec::new(), Vec::new());
    for (name, made) in [("salva2d", salva(target)), ("SPlisHSPlasH", splishsplash())] {
        match made {
            Ok(program) => programs.push(program),
            Err(error) => {
                println!("{name} is left out: {error:#}");
                // The page is told in short: what an installer complains about is
                // long and of this machine.
                left_out.push(format!("{name}: {error}"));
            }
        }
    }
    if let Some(path) = yardstick {
        let program = path
            .canonicalize()
            .with_context(|| format!("there is no program {}", path.display()))?;
        programs.push(json!({ "command": [program], "yardstick": true }));
    }
    Ok(json!({ "programs": programs, "leftOut": left_out }))
}

fn peers() -> PathBuf {
    paths::root().join("benches").join("peers")
}

/// salva2d, from crates.io: a package of its own, so that nobody else compiles it.
fn salva(target: &Path) -> Result<Value> {
    let folder = target.join("hearth-peers");
    process::run(
        process::cargo()
            .args(["build", "--release", "--locked", "--manifest-path"])
            .arg(peers().join("Cargo.toml"))
            .arg("--target-dir")
            .arg(&folder),
    )
    .context("it could not be compiled")?;
    let program = folder
        .join("release")
        .join(format!("hearth-peers{}", std::env::consts::EXE_SUFFIX));
    Ok(json!({ "command": [program], "most": MOST }))
}

/// SPlisHSPlasH, which Python's package installer brings in an environment of its own.
fn splishsplash() -> Result<Value> {
    let environment = paths::tools().join("splishsplash");
    let python = environment.join("bin").join("python");
    if !python.is_file() {
        let python3 = process::find("python3").context("there is no python3")?;
        let venv = ["-m", "venv"];
        process::output(process::command(python3).args(venv).arg(&environment))
            .context("python3 makes no environment of its own")?;
    }
    let preload = |python: &Path| {
        let mut run = process::command(python);
        if let Some(library) = preloaded(&environment) {
            run.env("LD_PRELOAD", library);
        }
        run
    };
    let works = || process::output(preload(&python).args(["-c", "import pysplishsplash"]));
    if works().is_err() {
        let install = ["-m", "pip", "install", "--quiet", PYSPLISHSPLASH];
        process::output(process::command(&python).args(install))
            .context("Python's package installer does not give it")?;
        works().context("it does not load")?;
    }
    let script = peers().join("splishsplash.py");
    Ok(json!({
        "command": [python, script],
        "env": { "LD_PRELOAD": preloaded(&environment).unwrap_or_default() },
        "most": MOST,
    }))
}

/// Its own copy of a library that must be loaded before the system's: with both,
/// whichever comes second crashes.
fn preloaded(environment: &Path) -> Option<PathBuf> {
    let folders = fs::read_dir(environment.join("lib")).ok()?;
    let libraries = |python: PathBuf| {
        let folder = python.join("site-packages").join("pysplishsplash.libs");
        fs::read_dir(folder).ok()
    };
    folders
        .filter_map(|python| libraries(python.ok()?.path()))
        .flatten()
        .filter_map(|file| Some(file.ok()?.path()))
        .find(|file| {
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("libGLdispatch")
        })
}
