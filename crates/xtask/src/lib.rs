//! Hearth's commands: `cargo xtask <command>`.
//!
//! Everything that is built, checked or served goes through here, so that the README,
//! a developer's machine and a build server run the same commands.

mod bench;
mod burning;
mod codegen;
mod evaluation;
mod faults;
mod flags;
mod goldens;
mod links;
mod look;
mod npm;
mod package;
mod parts;
mod paths;
mod pictures;
mod report;
mod script;
mod serve;
mod shell;
mod site;
mod stages;
mod tools;
mod validate;

use std::process::ExitCode;

use anyhow::Result;
use flags::{Xtask, XtaskCmd};

fn main() -> ExitCode {
    let command = match Xtask::parse(std::env::args_os().skip(1)) {
        Ok(command) => command,
        Err(error) if error.is_help() => error.exit(),
        Err(error) => {
            eprintln!("error: {error}; `cargo xtask help` lists all commands and options");
            return ExitCode::FAILURE;
        }
    };
    run(command).unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::FAILURE
    })
}

fn run(command: Xtask) -> Result<ExitCode> {
    match command.subcommand {
        XtaskCmd::Serve(serve) => {
            site::build()?;
            serve::serve(&paths::site(), serve.port, !serve.no_open)?;
        }
        XtaskCmd::Build(build) => {
            site::build()?;
            if let Some(base) = build.url {
                links::make_absolute(&paths::site(), &base)?;
            }
            println!(
                "The site is in {}: copy it to any static host.",
                paths::shown(&paths::site())
            );
        }
        XtaskCmd::Package(_) => package::build()?,
        XtaskCmd::Reproduce(_) => package::reproduce()?,
        XtaskCmd::Test(test) => {
            if !stages::run(test.skip_browser, test.all, &test.stage)? {
                return Ok(ExitCode::FAILURE);
            }
        }
        XtaskCmd::Validate(validate) => validate::run(&validate.case)?,
        XtaskCmd::Soak(soak) => validate::soak(&soak)?,
        XtaskCmd::Fuzz(fuzz) => validate::fuzz(fuzz.minutes, fuzz.seed)?,
        XtaskCmd::Faults(faults) => faults::run(&faults.section)?,
        XtaskCmd::Bench(bench) => bench::run(&bench)?,
        XtaskCmd::Look(look) => look::run(&look.scene)?,
        XtaskCmd::Goldens(goldens) => goldens::write(goldens.snapshots, &goldens.name)?,
        XtaskCmd::Poster(_) => pictures::poster()?,
        XtaskCmd::Thumbnails(thumbnails) => pictures::thumbnails(&thumbnails.scene)?,
        XtaskCmd::Showcase(_) => pictures::showcase()?,
        XtaskCmd::Burning(_) => report_written(burning::refresh(true)?),
        XtaskCmd::Size(_) => {
            site::build()?;
            package::sizes(&paths::site().join("web"))?;
        }
        XtaskCmd::Codegen(_) => {
            let mut written = codegen::refresh_checkout()?;
            written.extend(burning::refresh(false)?);
            report_written(written);
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn report_written(files: Vec<String>) {
    if files.is_empty() {
        println!("Every generated file is up to date.");
    }
    for file in files {
        println!("wrote {file}");
    }
}
