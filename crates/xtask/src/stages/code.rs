//! Stages that read and run the code without a browser.

use anyhow::Result;

use crate::{process, tools};

/// Crates that are libraries for other people.
const LIBRARIES: [&str; 2] = ["hearth-core", "hearth-render"];
/// Crates with code that only a browser runs.
const FOR_THE_BROWSER: [&str; 6] = [
    "hearth-bindings",
    "hearth-engine",
    "hearth-sim",
    "hearth-panel",
    "hearth-tests",
    "hearth-painter",
];

/// A package outside the workspace.
const PEERS: &str = "benches/peers/Cargo.toml";

pub(super) fn format() -> Result<()> {
    process::run(process::cargo().args(["fmt", "--all", "--check"]))?;
    process::run(process::cargo().args(["fmt", "--check", "--manifest-path", PEERS]))
}

pub(super) fn lint() -> Result<()> {
    process::run(process::cargo().args([
        "clippy",
        "--workspace",
        "--all-targets",
        "--",
        "--deny",
        "warnings",
    ]))
}

pub(super) fn lint_wasm() -> Result<()> {
    tools::wasm_target()?;
    let mut clippy = process::cargo();
    clippy.args(["clippy", "--target", tools::WASM, "--all-targets"]);
    for package in FOR_THE_BROWSER {
        clippy.args(["--package", package]);
    }
    process::run(clippy.args(["--", "--deny", "warnings"]))
}

pub(super) fn docs() -> Result<()> {
    let mut doc = process::cargo();
    doc.args(["doc", "--no-deps"]);
    for package in LIBRARIES {
        doc.args(["--package", package]);
    }
    process::run(doc.env("RUSTDOCFLAGS", "--deny warnings"))
}

pub(super) fn native() -> Result<()> {
    process::run(process::cargo().args(["test", "--workspace"]))
}

/// The sources as drivers get them, by the compiler that their makers agreed on.
pub(super) fn shaders() -> Result<()> {
    let validator = tools::glslang()?;
    let mut test = process::cargo();
    test.args(["test", "--package", "hearth-render", "--lib", "--"])
        .args(["--include-ignored", "shaders::"]);
    process::run(test.env("HEARTH_GLSLANG", validator))
}
