//! Other people's solvers that are measured beside Hearth. A solver that this machine
//! cannot have is left out, and the report states that.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde_json::{Value, json};
use xshell::cmd;
use xtask::paths;
use xtask::shell::{self, Shell};

/// Most particles for them: a step of more takes seconds.
const MOST: u32 = 100_000;

/// The version of pySPlisHSPlasH that is known to work.
const PYSPLISHSPLASH: &str = "pysplishsplash==2.19.0";

/// The programs as `benches/browser/run.mjs` reads them, and what is left out.
pub(super) fn ready(yardstick: Option<&Path>, target: &Path) -> Result<Value> {
    let sh = Shell::new()?;
    let (mut programs, mut left_out) = (Vec::new(), Vec::new());
    let others = [salva(&sh, target), splishsplash(&sh)];
    for (name, made) in ["salva2d", "SPlisHSPlasH"].into_iter().zip(others) {
        match made {
            Ok(program) => programs.push(program),
            Err(error) => {
                println!("{name} is left out: {error:#}");
                // The page gets the short reason: an installer's is long and of this machine.
                left_out.push(format!("{name}: {error}"));
            }
        }
    }
    if let Some(path) = yardstick {
        let name = || path.display().to_string();
        let program = path.canonicalize().with_context(name)?;
        programs.push(json!({ "command": [program], "yardstick": true }));
    }
    Ok(json!({ "programs": programs, "leftOut": left_out }))
}

/// salva2d, from Rust's registry, in a package of its own outside the workspace.
fn salva(sh: &Shell, target: &Path) -> Result<Value> {
    let folder = target.join("hearth-peers");
    let manifest = "benches/peers/Cargo.toml";
    cmd!(
        sh,
        "cargo build --release --locked --manifest-path {manifest} --target-dir {folder}"
    )
    .run()
    .context("it does not compile")?;
    let program = format!("release/hearth-peers{}", std::env::consts::EXE_SUFFIX);
    Ok(json!({ "command": [folder.join(program)], "most": MOST }))
}

/// SPlisHSPlasH, which Python's package installer installs into an environment of its own.
fn splishsplash(sh: &Shell) -> Result<Value> {
    let environment = paths::tools().join("splishsplash");
    let python = environment.join("bin/python");
    if !python.is_file() {
        let python3 = shell::find("python3").context("there is no python3")?;
        cmd!(sh, "{python3} -m venv {environment}")
            .read()
            .context("python3 makes no environment")?;
    }
    let works = || {
        let import = cmd!(sh, "{python} -c 'import pysplishsplash'");
        let preload = preloaded(sh, &environment).map(|library| ("LD_PRELOAD", library));
        import.envs(preload).read()
    };
    if works().is_err() {
        cmd!(sh, "{python} -m pip install --quiet {PYSPLISHSPLASH}")
            .read()
            .context("Python's package installer does not have it")?;
        works().context("it does not load")?;
    }
    Ok(json!({
        "command": [python, paths::root().join("benches/peers/splishsplash.py")],
        "env": { "LD_PRELOAD": preloaded(sh, &environment).unwrap_or_default() },
        "most": MOST,
    }))
}

/// Its own copy of a library that must be loaded before the system's: the one of both that
/// is loaded second crashes.
fn preloaded(sh: &Shell, environment: &Path) -> Option<PathBuf> {
    let pythons = sh.read_dir(environment.join("lib")).ok()?;
    let libraries = |python: PathBuf| {
        sh.read_dir(python.join("site-packages/pysplishsplash.libs"))
            .ok()
    };
    pythons
        .into_iter()
        .filter_map(libraries)
        .flatten()
        .find(|file| {
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("libGLdispatch")
        })
}
