//! Golden pictures: the tests that compare with them, and `cargo xtask goldens`, which
//! draws them again.
//!
//! Both burn fires from their seeds and draw them natively with a software renderer: the same
//! version of it draws the same pictures on every machine.

use std::iter;
use std::path::PathBuf;

use anyhow::Result;
use xshell::cmd;

use crate::shell::Shell;
use crate::stages::code;
use crate::tools;

/// Draws the pictures whose names begin with one of `names`, or all.
pub(crate) fn write(names: &[String]) -> Result<()> {
    run_script("write.mjs", names.iter().map(Into::into), None)
}

/// Compares what is drawn with the goldens, and runs the other tests of pictures.
pub(crate) fn check() -> Result<()> {
    run_script("run.mjs", iter::empty(), None)
}

/// The painter of tests and the command `hearth`, each with the variable in which scripts look for it. Their
/// profile is `dev`, in which the physics is optimised: the stage `native` compiles most of them.
pub(crate) fn programs() -> Result<[(&'static str, PathBuf); 2]> {
    let programs = [
        ("HEARTH_PAINTER", "hearth-painter"),
        ("HEARTH_COMMAND", "hearth"),
    ];
    code::build(programs.map(|(_, name)| name))?;
    let folder = tools::target()?.join("debug");
    tools::graphics_driver(&folder.join("hearth"))?;
    Ok(programs.map(|(variable, name)| (variable, folder.join(name))))
}

/// Runs a script of `tests/look` with the programs that draw, and another one.
pub fn run_script(
    name: &str,
    arguments: impl IntoIterator<Item = PathBuf>,
    other: Option<(&str, PathBuf)>,
) -> Result<()> {
    tools::node()?;
    let programs = programs()?;
    let shown = tools::target()?.join("hearth-look/shown");
    let sh = Shell::new()?;
    sh.remove_path(&shown)?;
    sh.change_dir("tests/look");
    let script = cmd!(sh, "node {name}").args(arguments);
    let script = script.envs(programs).envs(other);
    Ok(script.env("HEARTH_SHOWN", shown).run()?)
}
