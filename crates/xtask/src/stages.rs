//! `cargo xtask test`: every check of the project. Some that use one core run beside the others.
//!
//! A stage that fails stops only the stages that need its result, so one run reports
//! everything. Quick and strict stages come first. All stages share one target folder and
//! one set of flags, so that little is compiled twice. A long stage that passed does not run
//! again while nothing changes.

pub(crate) mod browser;
mod code;
mod library;
mod trunk;

use std::thread;

use anyhow::{Result, ensure};
use xshell::cmd;

use crate::report::Report;
use crate::shell::Shell;
use crate::{bench, codegen, goldens, package, script, site, tools};

/// One check.
struct Stage {
    name: &'static str,
    about: &'static str,
    run: fn() -> Result<()>,
    /// The stage whose result this one uses.
    needs: Option<&'static str>,
    in_browser: bool,
    /// Uses one core: it runs beside the others.
    beside: bool,
    /// Takes long and makes nothing: it runs only where an input changed since it passed.
    remembered: bool,
}

/// A table of stages: the name, the stage that it needs, what it checks, the function and flags.
macro_rules! stages {
    ($( $name:literal $(needs $needs:literal)? : $about:literal, $run:path $(, $flag:ident)*; )+) => {
        &[ $( {
            let stage = Stage {
                name: $name,
                about: $about,
                run: $run,
                needs: None,
                in_browser: false,
                beside: false,
                remembered: false,
            };
            $( let stage = Stage { needs: Some($needs), ..stage }; )?
            $( let stage = Stage { $flag: true, ..stage }; )*
            stage
        }, )+ ]
    };
}

impl Stage {
    fn run(&self) -> Result<()> {
        if !self.remembered {
            return (self.run)();
        }
        tools::node()?;
        let (sh, name, store) = (Shell::new()?, self.name, tools::passed("stages.json")?);
        let digest = cmd!(sh, "node tests/passed.mjs {store} {name}").read()?;
        if digest.is_empty() {
            println!("passed before, unchanged: `cargo xtask test --all` runs it again");
            return Ok(());
        }
        (self.run)()?;
        Ok(cmd!(sh, "node tests/passed.mjs {store} {name} {digest}").run()?)
    }
}

const STAGES: &[Stage] = stages! {
    "format": "the code is formatted", code::format;
    "generated": "generated files match the parameter table", generated;
    "lint": "clippy accepts the native code", code::lint;
    "lint-wasm": "clippy accepts the code for the browser", code::lint_wasm;
    "lint-web": "biome accepts the scripts and style sheets", script::lint;
    "docs": "the libraries' documentation builds without a warning", code::docs;
    "site": "the static site builds", site::build;
    "types" needs "site": "the compiler accepts the types of the scripts", script::check_types;
    "package" needs "site": "the npm package is whole and reproducible, and names no folder of this machine", package::make;
    "size" needs "package": "downloads stay small", size;
    "library" needs "site": "the headless library keeps its laws in Node, and the native bits", library::laws_in_node, remembered;
    "native": "laws of the physics, and every unit test", code::native, remembered;
    "shaders": "the reference compiler accepts every shader", code::shaders;
    "web": "scripts that need no browser, in Node", library::scripts_in_node;
    "publish": "the crates could be published", library::publishable, beside;
    "baselines": "the benchmarks' baselines compute the same gas", bench::baselines, beside;
    "cost": "a step takes no more instructions than recorded", bench::instructions, beside, remembered;
    "wasm": "wasm gives the native bits", browser::wasm_in_node, beside, remembered;
    "browser": "shaders and canvases in headless Chromium", browser::wasm_in_chromium, beside, in_browser, remembered;
    "consumers" needs "package": "the npm package works in pages, bundlers, React and on servers", browser::consumers, beside, in_browser, remembered;
    "trunk" needs "site": "Trunk builds the same site", trunk::same_site, beside;
    "trunk-page" needs "trunk": "the page that Trunk builds and serves burns", trunk::page_burns, beside, in_browser;
    "goldens": "fires match the golden pictures", goldens::check, beside, in_browser;
    "e2e" needs "site": "the page in Chromium, and its element in every browser", browser::end_to_end, in_browser;
};

/// Runs the named stages, or every stage, and prints a report; returns whether all passed.
/// With `all`, what passed before runs again.
pub(crate) fn run(skip_browser: bool, all: bool, names: &[String]) -> Result<bool> {
    if all {
        Shell::new()?.remove_path(tools::passed("")?)?;
    }
    let report = Report::new();
    let run = |stages: Vec<&Stage>| {
        for stage in stages {
            if stage.in_browser && skip_browser {
                report.skip(stage.name);
            } else {
                report.stage(stage.name, stage.about, stage.needs, || stage.run());
            }
        }
    };
    let (beside, others) = chosen(names)?.into_iter().partition(|stage| stage.beside);
    thread::scope(|scope| {
        scope.spawn(|| run(beside));
        run(others);
    });
    print!("\n{}", report.summary());
    Ok(report.passed())
}

/// The stages of these names and what they need, in order; without a name, all.
fn chosen(names: &[String]) -> Result<Vec<&'static Stage>> {
    let mut wanted: Vec<&str> = names.iter().map(String::as_str).collect();
    for name in &wanted {
        let known: Vec<_> = STAGES.iter().map(|stage| stage.name).collect();
        ensure!(
            known.contains(name),
            "unknown stage \"{name}\"; the stages are {}",
            known.join(", ")
        );
    }
    // Backwards, so that what a needed stage needs is wanted too.
    let mut chosen = Vec::new();
    for stage in STAGES.iter().rev() {
        if names.is_empty() || wanted.contains(&stage.name) {
            wanted.extend(stage.needs);
            chosen.insert(0, stage);
        }
    }
    Ok(chosen)
}

fn generated() -> Result<()> {
    let written = codegen::refresh_checkout()?;
    ensure!(
        written.is_empty(),
        "these files were out of date and have been written; commit them: {}",
        written.join(", ")
    );
    Ok(())
}

fn size() -> Result<()> {
    package::sizes(&package::folder())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(asked: &[&str]) -> Result<Vec<&'static str>> {
        let asked: Vec<_> = asked.iter().map(|&name| name.to_owned()).collect();
        Ok(chosen(&asked)?.iter().map(|stage| stage.name).collect())
    }

    #[test]
    fn a_stage_brings_what_it_needs() -> Result<()> {
        assert_eq!(names(&["e2e"])?, ["site", "e2e"]);
        assert_eq!(names(&["consumers"])?, ["site", "package", "consumers"]);
        assert_eq!(names(&["trunk-page"])?, ["site", "trunk", "trunk-page"]);
        assert_eq!(names(&["native", "format"])?, ["format", "native"]);
        assert_eq!(names(&[])?.len(), STAGES.len());
        Ok(())
    }

    #[test]
    fn an_unknown_stage_is_refused_with_the_known_ones() {
        let error = names(&["everything"]).err().map(|error| error.to_string());
        assert!(error.is_some_and(|error| error.contains("native")));
    }

    #[test]
    fn a_stage_comes_after_what_it_needs() {
        for (at, stage) in STAGES.iter().enumerate() {
            // Stages beside others may wait for them, and never the other way round.
            let ends = |it: &Stage, need| it.name == need && (stage.beside || !it.beside);
            let before = |need| STAGES[..at].iter().any(|it| ends(it, need));
            assert!(stage.needs.is_none_or(before), "{}", stage.name);
        }
    }
}
