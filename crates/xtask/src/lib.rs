//! Hearth's commands: `cargo xtask <command>`.
//!
//! Everything that is built, checked or served goes through here, so that the README,
//! a developer's machine and a build server run the same commands. `cargo measure` shares
//! the public modules.

pub mod arguments;
pub mod baselines;
pub mod cost;
mod flags;
pub mod fuzz;
pub mod goldens;
mod links;
mod npm;
mod package;
pub mod pages;
mod parts;
pub mod paths;
mod pictures;
mod publish;
mod report;
mod script;
mod serve;
pub mod shell;
pub mod site;
mod stages;
pub mod tools;

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Context, Result};
use codegen::prewarmed;
use flags::{Xtask, XtaskCmd};
use pages::Places;

pub use codegen::sections;
pub use stages::browser;

/// Runs the command of this process's arguments.
pub fn main() -> ExitCode {
    let parsed = Xtask::parse(std::env::args_os().skip(1));
    arguments::outcome("cargo xtask", parsed, run)
}

fn run(command: Xtask) -> Result<ExitCode> {
    match command.subcommand {
        XtaskCmd::Serve(serve) => {
            site::build()?;
            serve::serve(&paths::site(), serve.port, !serve.no_open)?;
        }
        XtaskCmd::Build(build) => {
            site::build()?;
            let (url, repository) = (build.url.as_ref(), build.repository.as_ref());
            publish::finish_site(&Places { url, repository })?;
            println!(
                "The site is in {}: copy it to any static host.",
                paths::shown(&paths::site())
            );
        }
        XtaskCmd::Pages(command) => {
            let staged = || std::env::var_os("TRUNK_STAGING_DIR").map(PathBuf::from);
            let site = command
                .site
                .or_else(staged)
                .context("--site names no folder")?;
            pages::write(&paths::root(), &site, &Places::default())?;
        }
        XtaskCmd::Package(_) => package::build()?,
        XtaskCmd::Publish(publish) => {
            let (url, repository) = (publish.url.as_ref(), publish.repository.as_ref());
            publish::make(&Places { url, repository })?;
        }
        XtaskCmd::Reproduce(_) => publish::reproduce()?,
        XtaskCmd::Test(test) => {
            if !stages::run(test.skip_browser, test.all, &test.stage)? {
                return Ok(ExitCode::FAILURE);
            }
        }
        XtaskCmd::Browsers(browsers) => browser::table(browsers.name)?,
        XtaskCmd::Cost(_) => cost::record()?,
        XtaskCmd::Goldens(goldens) => goldens::write(&goldens.name)?,
        XtaskCmd::Poster(_) => pictures::poster()?,
        XtaskCmd::Thumbnails(thumbnails) => pictures::thumbnails(&thumbnails.scene)?,
        XtaskCmd::Showcase(_) => pictures::showcase()?,
        XtaskCmd::Prewarmed(_) => report_written(prewarmed::refresh(&paths::root(), true)?),
        XtaskCmd::Size(_) => {
            site::build()?;
            package::sizes(&paths::site().join("web"), true)?;
        }
        XtaskCmd::Codegen(_) => {
            let mut written = script::generated_files()?;
            written.extend(prewarmed::refresh(&paths::root(), false)?);
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
