//! `cargo xtask soak`: drives many fires to random corners of all ranges, and back.

use anyhow::Result;

use crate::process;

/// Runs so many corners of each model; none: as many as are usual.
///
/// # Errors
/// A corner at which the fire breaks.
pub fn run(corners: Option<u32>, seed: Option<u32>) -> Result<()> {
    let mut soak = process::cargo();
    soak.args([
        "run",
        "--quiet",
        "--release",
        "--package",
        "hearth-tests",
        "--example",
        "soak",
        "--",
    ]);
    for (option, value) in [("--corners", corners), ("--seed", seed)] {
        if let Some(value) = value {
            soak.arg(option).arg(value.to_string());
        }
    }
    process::run(&mut soak)
}
