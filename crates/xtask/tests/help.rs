//! The help of `cargo xtask`.

use std::io;
use std::process::Command;

#[test]
fn a_reader_that_closes_the_pipe_ends_the_help_without_an_error() -> io::Result<()> {
    let (reader, writer) = io::pipe()?;
    drop(reader);
    let mut help = Command::new(env!("CARGO_BIN_EXE_xtask"));
    let ended = help.arg("help").stdout(writer).output()?;
    assert!(ended.status.success(), "{ended:?}");
    assert_eq!(String::from_utf8_lossy(&ended.stderr), "");
    Ok(())
}
