//! Other programs, run in the checkout with Hearth's own tools on the PATH.

use std::env;
use std::ffi::OsString;
use std::ops::Deref;
use std::path::{Path, PathBuf};

use anyhow::Result;
use xshell::Cmd;

use crate::paths;

/// The PATH of this process, with the folder of Hearth's own tools first.
fn search_path() -> Option<OsString> {
    let present = env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(paths::tools().join("bin")).chain(env::split_paths(&present));
    env::join_paths(folders).ok()
}

/// The program of that name on that PATH.
pub fn find(program: &str) -> Option<PathBuf> {
    env::split_paths(&search_path()?)
        .map(|folder| folder.join(format!("{program}{}", env::consts::EXE_SUFFIX)))
        .find(|file| file.is_file())
}

/// An [`xshell::Shell`] in the checkout; `cmd!` takes it as one.
pub struct Shell(xshell::Shell);

impl Shell {
    /// A shell whose folder is the checkout.
    pub fn new() -> Result<Shell> {
        let shell = xshell::Shell::new()?;
        shell.change_dir(paths::root());
        if let Some(path) = search_path() {
            shell.set_var("PATH", path);
        }
        Ok(Shell(shell))
    }

    /// A command without the variables in which `cargo run` describes xtask: build
    /// scripts of other packages would take them for their own.
    pub fn cmd(&self, program: impl AsRef<Path>) -> Cmd<'_> {
        let foreign = env::vars_os().map(|(name, _)| name).filter(|name| {
            name.to_str().is_some_and(|name| {
                name.starts_with("CARGO_PKG_") || name.starts_with("CARGO_MANIFEST_")
            })
        });
        foreign.fold(self.0.cmd(program), |command, name| {
            command.env_remove(name)
        })
    }

    /// Cargo with arguments, between which is white space.
    pub fn cargo(&self, arguments: &str) -> Cmd<'_> {
        self.cmd("cargo").args(arguments.split_whitespace())
    }
}

impl Deref for Shell {
    type Target = xshell::Shell;

    fn deref(&self) -> &xshell::Shell {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_names_the_command_that_failed() -> Result<()> {
        let sh = Shell::new()?;
        for (program, argument) in [("hearth-no-such", "now"), ("cargo", "hearth-no-such")] {
            let command = sh.cmd(program).arg(argument);
            let error = command.ignore_stderr().quiet().run().err();
            assert!(error.is_some_and(|error| error.to_string().contains("hearth-no-such")));
        }
        Ok(())
    }

    #[test]
    fn own_tools_come_first() {
        let first = search_path().and_then(|path| env::split_paths(&path).next());
        assert_eq!(first, Some(paths::tools().join("bin")));
        assert_eq!(find("hearth-no-such-program"), None);
    }
}
