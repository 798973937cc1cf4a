//! What is measured on demand: `cargo measure <command>`.
//!
//! Most commands write their tables into `docs/evaluation.md`. `cargo xtask` builds what they measure.

mod bench;
mod coverage;
mod evaluation;
mod faults;
mod flags;
mod fuzz;
mod look;
mod soak;
mod validate;

use std::process::ExitCode;

use anyhow::Result;
use flags::{Measure, MeasureCmd};

fn main() -> ExitCode {
    let parsed = Measure::parse(std::env::args_os().skip(1));
    xtask::arguments::outcome("cargo measure", parsed, run)
}

fn run(command: Measure) -> Result<ExitCode> {
    match command.subcommand {
        MeasureCmd::Bench(bench) => bench::run(bench.yardstick.as_deref())?,
        MeasureCmd::Paper(_) => bench::paper()?,
        MeasureCmd::Validate(validate) => validate::run(&validate.case)?,
        MeasureCmd::Soak(soak) => soak::run(&soak)?,
        MeasureCmd::Fuzz(fuzz) => fuzz::run(&fuzz)?,
        MeasureCmd::Coverage(_) => coverage::run()?,
        MeasureCmd::Faults(faults) => faults::run(&faults.section)?,
        MeasureCmd::Look(look) => look::run(&look.scene)?,
    }
    Ok(ExitCode::SUCCESS)
}
