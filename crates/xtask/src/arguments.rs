//! The command line of `cargo xtask` and of `cargo measure`, around what xflags reads.

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use anyhow::Result;

/// The arguments as xflags reads them: `--name=value` is two, and no command or `help` is `--help`.
pub fn separate(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let separate: Vec<OsString> = arguments.flat_map(split).collect();
    match separate.first() {
        Some(command) if command != "help" => separate,
        _ => vec!["--help".into()],
    }
}

fn split(argument: OsString) -> Vec<OsString> {
    match argument.to_str().and_then(|text| text.split_once('=')) {
        Some((name, value)) if name.starts_with("--") => vec![name.into(), value.into()],
        _ => vec![argument],
    }
}

/// Runs a parsed command, or prints the help or the error.
pub fn outcome<C>(
    program: &str,
    parsed: xflags::Result<C>,
    run: fn(C) -> Result<ExitCode>,
) -> ExitCode {
    let result = match parsed {
        Ok(command) => run(command).map_err(|error| format!("{error:#}")),
        Err(error) if error.is_help() => {
            // A program that reads the first lines closes the pipe.
            let _ = writeln!(std::io::stdout(), "{error}");
            return ExitCode::SUCCESS;
        }
        Err(error) => Err(format!(
            "{error}; `{program} help` lists all commands and options"
        )),
    };
    result.unwrap_or_else(|error| {
        eprintln!("error: {error}");
        ExitCode::FAILURE
    })
}
