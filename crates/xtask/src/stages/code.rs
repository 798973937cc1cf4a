//! Stages that check and run the code without a browser.

use anyhow::Result;
use xshell::{Cmd, cmd};

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
        "-p hearth-panel -p hearth-tests"
    ))
}

fn clippy(packages: &str) -> Result<()> {
    let clippy = format!("clippy {packages} --all-targets -- --deny warnings");
    Ok(Shell::new()?.cargo(&clippy).run()?)
}

/// The libraries for other people.
pub(super) fn docs() -> Result<()> {
    let sh = Shell::new()?;
    let doc = sh.cargo("doc --no-deps -p hearth-fire -p hearth-fire-core -p hearth-fire-settings -p hearth-fire-render -p hearth-fire-cli");
    Ok(doc.env("RUSTDOCFLAGS", "--deny warnings").run()?)
}

/// The packages of the commands. With the features that other packages need, cargo would compile
/// their libraries, which read and write wasm, again.
const COMMANDS: [&str; 4] = ["xtask", "measure", "codegen", "wasm-parts"];

pub(super) fn native() -> Result<()> {
    let sh = Shell::new()?;
    let commands = COMMANDS.iter().flat_map(|name| ["--package", name]);
    sh.cargo("test").args(commands).run()?;
    build(["hearth"])?;
    tools::graphics_driver(&tools::target()?.join("debug/hearth"))?;
    Ok(test_others(&sh).envs([tools::fingerprints()?]).run()?)
}

/// The laws that `native` ignores because they burn for minutes, in what it compiled.
pub(super) fn burns() -> Result<()> {
    let sh = Shell::new()?;
    let laws = ["--test", "laws", "--", "--ignored"];
    Ok(test_others(&sh).args(laws).run()?)
}

/// The sources as drivers get them, by the reference compiler, in what `native` compiled.
pub(super) fn shaders() -> Result<()> {
    let (sh, validator) = (Shell::new()?, tools::GLSLANG.get()?);
    let test = test_others(&sh).args(["--lib", "--", "--ignored", "shaders::"]);
    Ok(test.env("HEARTH_GLSLANG", validator).run()?)
}

/// The tests of all packages but those of the commands.
fn test_others(sh: &Shell) -> Cmd<'_> {
    others(sh, "test")
}

/// Builds programs with libraries that `native` compiles too.
pub(crate) fn build<const N: usize>(programs: [&str; N]) -> Result<()> {
    let programs = programs.iter().flat_map(|name| ["--bin", name]);
    Ok(others(&Shell::new()?, "build").args(programs).run()?)
}

/// A command of cargo for all packages but those of the commands.
fn others<'a>(sh: &'a Shell, command: &str) -> Cmd<'a> {
    let commands = COMMANDS.iter().flat_map(|name| ["--exclude", name]);
    sh.cargo(&format!("{command} --workspace")).args(commands)
}
