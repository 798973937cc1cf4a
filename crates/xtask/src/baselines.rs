//! The baselines in JavaScript that the benchmarks measure beside Hearth.

use anyhow::Result;
use xshell::cmd;

use crate::shell::Shell;
use crate::tools;

/// Fails unless they compute what Hearth computes.
pub fn check() -> Result<()> {
    tools::node()?;
    let sh = Shell::new()?;
    let native = sh.cargo("run --quiet --package hearth-benches --example native -- gas");
    let gas = native.read()?;
    Ok(cmd!(sh, "node benches/browser/check.mjs")
        .stdin(gas)
        .run()?)
}
