//! The tools that Hearth's commands need beyond cargo. A missing tool is installed where
//! that needs no password; otherwise the error names the command that installs it.
//!
//! `serve` and `build` need the wasm target and Node. Tests also need browsers with their
//! drivers, wasm-bindgen's test runner, valgrind, the reference compiler of GLSL and Trunk.

mod debian;

use std::collections::BTreeSet;
use std::env;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError, Weak};

use anyhow::{Context, Result, bail, ensure};
use xshell::cmd;

use crate::paths;
use crate::shell::{Shell, find};

use debian::apt_install;
pub(crate) use debian::{
    BROWSERS, CHROMEDRIVER, CJPEG, COMPILER, GLSLANG, IMG2WEBP, VALGRIND, chinese_font,
    graphics_driver, installing, wanted_browsers, whole_ring,
};
pub use debian::{browsers, chromium, strace};

/// The version of wasm-bindgen of this workspace, which its command line tools must have
/// too. A test compares it with `Cargo.lock`.
const WASM_BINDGEN: &str = "0.2.130";
/// The version of Trunk that is known to work.
const TRUNK: &str = "0.21.14";
/// The target of everything that runs in a browser.
pub(crate) const WASM: &str = "wasm32-unknown-unknown";
/// The oldest Node that runs what npm installs here.
const NODE_MAJOR: u32 = 20;

/// cargo's target folder, which the environment may have moved.
pub fn target() -> Result<PathBuf> {
    let target = metadata(&["--no-deps"])?["target_directory"]
        .as_str()
        .map(PathBuf::from);
    target.context("cargo does not name its target folder")
}

/// A variable for tests: the file of the native fingerprints, which the first call computes.
pub(crate) fn fingerprints() -> Result<(&'static str, PathBuf)> {
    static BURNT: Mutex<bool> = Mutex::new(false);
    let mut burnt = BURNT.lock().unwrap_or_else(PoisonError::into_inner);
    let (sh, file) = (Shell::new()?, target()?.join("fingerprints.txt"));
    if !*burnt {
        let program = sh.cargo("run --quiet --package hearth-tests --example fingerprint");
        sh.write_file(&file, program.read()? + "\n")?;
        *burnt = true;
    }
    Ok(("HEARTH_FINGERPRINTS", file))
}

/// While this lives, no other process writes into `dist`: it waits.
pub(crate) fn writing(dist: &Path) -> Result<Arc<File>> {
    static HELD: Mutex<Weak<File>> = Mutex::new(Weak::new());
    let mut held = HELD.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(lock) = held.upgrade() {
        return Ok(lock);
    }
    fs::create_dir_all(dist)?;
    let lock = Arc::new(File::create(dist.join(".lock"))?);
    if lock.try_lock().is_err() {
        println!("Another `cargo xtask` writes into dist; waiting for it …");
        lock.lock()?;
    }
    *held = Arc::downgrade(&lock);
    Ok(lock)
}

/// What cargo says of the workspace.
pub(crate) fn metadata(arguments: &[&str]) -> Result<serde_json::Value> {
    let sh = Shell::new()?;
    let described = cmd!(sh, "cargo metadata --format-version 1 {arguments...}").read()?;
    Ok(serde_json::from_str(&described)?)
}

/// A variable for cargo. It adds flags for wasm to those of `.cargo/config.toml`, which remove
/// the folders of this machine from the file names in panic messages.
pub(crate) fn portable_paths() -> Result<(&'static str, String)> {
    const NAME: &str = "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS";
    let described = metadata(&["--filter-platform", WASM])?;
    let packages = described["packages"].as_array().into_iter().flatten();
    let foreign = packages.filter(|package| !package["source"].is_null());
    let unpacked = foreign.filter_map(|package| {
        let manifest = Path::new(package["manifest_path"].as_str()?);
        manifest.ancestors().nth(2)?.to_str()
    });
    let unpacked: BTreeSet<_> = unpacked.map(|from| (from, "")).collect();
    // The last flag that matches wins: the target folder is often inside the checkout.
    let own = [("workspace_root", ""), ("target_directory", "target")];
    let own = own.map(|(name, to)| (described[name].as_str().unwrap_or_default(), to));
    // cargo splits the variable at white space: a folder with white space keeps its name.
    let folders = own.into_iter().chain(unpacked);
    let flags = folders
        .filter(|(from, _)| !from.contains(char::is_whitespace))
        .map(|(from, to)| format!("--remap-path-prefix={from}={to}"));
    let present = env::var(NAME).into_iter();
    Ok((NAME, present.chain(flags).collect::<Vec<_>>().join(" ")))
}

/// Installs Rust's wasm target if it is missing.
pub(crate) fn wasm_target() -> Result<()> {
    let (_only, sh) = (installing(), Shell::new()?);
    let folder = cmd!(sh, "rustc --print target-libdir --target {WASM}").read()?;
    if Path::new(&folder).is_dir() {
        return Ok(());
    }
    ensure!(
        find("rustup").is_some(),
        "this Rust cannot compile to {WASM}: install Rust with rustup (https://rustup.rs), \
         or your distribution's package of Rust's standard library for {WASM}"
    );
    Ok(cmd!(sh, "rustup target add {WASM}").run()?)
}

/// Installs wasm-bindgen's test runner if it is missing or of another version.
pub(crate) fn wasm_bindgen_cli() -> Result<()> {
    // The published lock file names versions that no longer build.
    let runner = "wasm-bindgen-test-runner";
    crate_tool(runner, "wasm-bindgen-cli", WASM_BINDGEN, "1", None)
}

/// Installs Trunk if it is missing or of another version.
pub(crate) fn trunk() -> Result<()> {
    // The newest versions of its dependencies do not fit together.
    crate_tool("trunk", "trunk", TRUNK, "0", Some("--locked"))
}

fn crate_tool(
    program: &str,
    package: &str,
    version: &str,
    opt_level: &str,
    locked: Option<&str>,
) -> Result<()> {
    let _only = installing();
    let sh = Shell::new()?;
    if let Some(file) = find(program) {
        let printed = cmd!(sh, "{file} --version").read().unwrap_or_default();
        if printed.split_whitespace().nth(1) == Some(version) {
            return Ok(());
        }
    }
    println!("Installing {package} {version} (a few minutes, once on a machine) …");
    let tools = paths::tools();
    let install = cmd!(
        sh,
        "cargo install {package} --version {version} --force --root {tools} {locked...}"
    );
    // It compiles for minutes and runs for seconds.
    Ok(install
        .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", opt_level)
        .env("CARGO_PROFILE_RELEASE_LTO", "off")
        .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")
        .run()?)
}

/// Installs Node and npm if they are missing.
pub fn node() -> Result<()> {
    let hint = || {
        format!(
            "Hearth is built with Node {NODE_MAJOR} or newer and npm: install it from \
             https://nodejs.org or as Debian's packages nodejs and npm"
        )
    };
    let _only = installing();
    if find("node").is_none() || find("npm").is_none() {
        apt_install(&["nodejs", "npm"]).with_context(hint)?;
    }
    let sh = Shell::new()?;
    let version = cmd!(sh, "node --version").read().with_context(hint)?;
    match major(&version) {
        Some(major) if major >= NODE_MAJOR => Ok(()),
        _ => bail!("Node {version} is too old. {}", hint()),
    }
}

/// `v20.1.2` → 20.
fn major(version: &str) -> Option<u32> {
    version.strip_prefix('v')?.split('.').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tools_have_the_version_of_the_bindings() -> Result<()> {
        let lock = std::fs::read_to_string(paths::root().join("Cargo.lock"))?;
        let entry = format!("name = \"wasm-bindgen\"\nversion = \"{WASM_BINDGEN}\"");
        assert!(lock.replace("\r\n", "\n").contains(&entry));
        Ok(())
    }

    #[test]
    fn one_process_writes_into_dist_at_a_time_and_its_own_parts_do_not_wait() -> Result<()> {
        let dist = env::temp_dir().join(format!("hearth-dist-{}", std::process::id()));
        let held = writing(&dist)?;
        let inner = writing(&dist)?;
        let other = File::open(dist.join(".lock"))?;
        assert!(other.try_lock().is_err());
        drop(held);
        assert!(other.try_lock().is_err());
        drop(inner);
        other.try_lock()?;
        Ok(fs::remove_dir_all(dist)?)
    }

    #[test]
    fn the_version_of_node_is_parsed() {
        assert_eq!(major("v20.11.1"), Some(20));
        assert_eq!(major("20"), None);
        assert_eq!(major(""), None);
    }
}
