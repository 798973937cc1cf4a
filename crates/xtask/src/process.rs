//! Other programs: found, run, and blamed in words when they fail.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

use crate::{paths, tools};

/// `program`, to be run in the checkout with Hearth's own tools on its PATH.
pub fn command(program: impl AsRef<Path>) -> Command {
    let mut command = Command::new(program.as_ref());
    command.current_dir(paths::root());
    if let Some(path) = tools::path() {
        command.env("PATH", path);
    }
    command
}

/// The cargo that runs this command.
pub fn cargo() -> Command {
    let mut cargo = command(env::var_os("CARGO").map_or_else(|| "cargo".into(), PathBuf::from));
    // `cargo run` describes this package in variables that build scripts
    // elsewhere could take for their own.
    for (name, _) in env::vars_os() {
        let described = name.to_str().is_some_and(|name| {
            name.starts_with("CARGO_PKG_") || name.starts_with("CARGO_MANIFEST_")
        });
        if described {
            cargo.env_remove(name);
        }
    }
    cargo
}

/// Runs `command` with its output on this console.
///
/// # Errors
/// It is not there, or ended with a failure.
pub fn run(command: &mut Command) -> Result<()> {
    let status = command
        .stdin(Stdio::null())
        .status()
        .with_context(|| format!("cannot start `{}`", line(command)))?;
    if !status.success() {
        bail!("`{}` failed ({status})", line(command));
    }
    Ok(())
}

/// What `command` prints.
///
/// # Errors
/// It is not there, or ended with a failure; then what it complained about.
pub fn output(command: &mut Command) -> Result<String> {
    let output = command
        .stdin(Stdio::null())
        .output()
        .with_context(|| format!("cannot start `{}`", line(command)))?;
    if !output.status.success() {
        bail!(
            "`{}` failed ({}): {}",
            line(command),
            output.status,
            String::from_utf8_lossy(&output.stderr).trim()
        );
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The program of that name on the PATH, Hearth's own tools first.
pub fn find(program: &str) -> Option<PathBuf> {
    let path = tools::path()?;
    env::split_paths(&path)
        .map(|folder| folder.join(format!("{program}{}", env::consts::EXE_SUFFIX)))
        .find(|file| file.is_file())
}

/// What a person would have typed.
fn line(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let mut line = program
        .file_stem()
        .unwrap_or(program.as_os_str())
        .to_string_lossy()
        .into_owned();
    for argument in command.get_args() {
        line.push(' ');
        line.push_str(&argument.to_string_lossy());
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn failures_name_the_program() {
        let missing = run(Command::new("hearth-no-such-program").arg("now"));
        let said = missing.err().map(|error| error.to_string());
        assert!(said.is_some_and(|said| said.contains("`hearth-no-such-program now`")));
        let failed = output(cargo().arg("hearth-no-such-command"));
        let said = failed.err().map(|error| error.to_string());
        assert!(said.is_some_and(|said| said.contains("`cargo hearth-no-such-command` failed")));
    }

    #[test]
    fn what_is_not_on_the_path_is_not_found() {
        assert_eq!(find("hearth-no-such-program"), None);
    }
}
