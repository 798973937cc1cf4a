//! The command `hearth`.

use std::process::ExitCode;

fn main() -> ExitCode {
    hearth_cli::run(std::env::args_os())
}
