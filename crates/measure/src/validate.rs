//! `cargo measure validate`: compares the physics with theory and writes the table and its plots into
//! `docs/evaluation.md` and `docs/validation`.

use anyhow::Result;
use xshell::Cmd;
use xtask::shell::Shell;
use xtask::{paths, tools};

use crate::evaluation;

/// Runs the cases whose names begin with one of `names`, or all of them. Only a run of
/// all is recorded, passed or failed.
pub(crate) fn run(names: &[String]) -> Result<()> {
    let sh = Shell::new()?;
    if !names.is_empty() {
        return Ok(example(&sh, "validate").args(names).run()?);
    }
    evaluation::check("validated")?;
    let folder = tools::target()?.join("hearth-validation");
    sh.remove_path(&folder)?;
    let passed = example(&sh, "validate").arg("--write").arg(&folder).run();
    let Ok(table) = sh.read_file(folder.join("table.md")) else {
        return Ok(passed?);
    };
    let plots = paths::root().join("docs/validation");
    sh.remove_path(&plots)?;
    sh.create_dir(&plots)?;
    let mut plotted = sh.read_dir(&folder)?;
    plotted.retain(|file| file.extension() == Some("svg".as_ref()));
    for plot in &plotted {
        sh.copy_file(plot, &plots)?;
    }
    evaluation::write("validated", &table)?;
    Ok(passed?)
}

/// A program of the tests' package.
pub(crate) fn example<'a>(sh: &'a Shell, name: &str) -> Cmd<'a> {
    let run = format!("run --quiet --release --package hearth-tests --example {name} --");
    sh.cargo(&run)
}
