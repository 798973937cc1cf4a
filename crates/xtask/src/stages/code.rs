//! Stages that check and run the code without a browser.

use anyhow::Result;
use xshell::cmd;

use crate::shell::Shell;
use crate::tools;

/// The package outside the workspace.
const PEERS: &str = "benches/peers/Cargo.toml";

pub(super) fn format() -> Result<()> {
    let sh = Shell::new()?;
    cmd!(sh, "cargo fmt --all --check").run()?;
    Ok(cmd!(sh, "cargo fmt --check --manifest-path {PEERS}").run()?)
}

pub(super) fn lint() -> Result<()> {
    clippy("--workspace --exclude hearth-panel")
}

/// The crates with code that only a browser runs, and the panel, which is for browsers alone.
pub(super) fn lint_wasm() -> Result<()> {
    tools::wasm_target()?;
    clippy(concat!(
        "--target wasm32-unknown-unknown -p hearth-bindings -p hearth-engine -p hearth-sim ",
        "-p hearth-panel -p hearth-tests -p hearth-painter"
    ))
}

fn clippy(packages: &str) -> Result<()> {
    let clippy = format!("clippy {packages} --all-targets -- --deny warnings");
    Ok(Shell::new()?.cargo(&clippy).run()?)
}

/// The libraries for other people.
pub(super) fn docs() -> Result<()> {
    let sh = Shell::new()?;
    let doc = sh.cargo("doc --no-deps -p hearth-fire -p hearth-fire-core -p hearth-render");
    Ok(doc.env("RUSTDOCFLAGS", "--deny warnings").run()?)
}

/// With the features that other packages need, cargo would compile xtask's libraries again.
pub(super) fn native() -> Result<()> {
    let sh = Shell::new()?;
    cmd!(
        sh,
        "cargo test --package xtask --package measure --package codegen"
    )
    .run()?;
    let others = cmd!(
        sh,
        "cargo test --workspace --exclude xtask --exclude measure --exclude codegen"
    );
    Ok(others.envs([tools::fingerprints()?]).run()?)
}

/// The laws that `native` ignores because they burn for minutes, in what it compiled.
pub(super) fn burns() -> Result<()> {
    let test = "test --workspace --exclude xtask --test laws -- --ignored";
    Ok(Shell::new()?.cargo(test).run()?)
}

/// The sources as drivers get them, by the reference compiler, in what `native` compiled.
pub(super) fn shaders() -> Result<()> {
    let (sh, validator) = (Shell::new()?, tools::GLSLANG.get()?);
    let test = "test --workspace --exclude xtask --exclude measure --exclude codegen --lib -- --include-ignored shaders::";
    Ok(sh.cargo(test).env("HEARTH_GLSLANG", validator).run()?)
}
