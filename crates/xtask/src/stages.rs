//! `cargo xtask test`: every check of the project, in three rings. Some that use one core run in the background.
//!
//! A stage that fails stops only the stages that need its result, so one run reports
//! everything. Quick and strict stages come first. All stages share one target folder and
//! one set of flags, so that little is compiled twice.

pub mod browser;
pub mod code;
mod library;
mod trunk;

use std::thread;

use anyhow::{Result, ensure};

use crate::report::Report;
use crate::{baselines, cost, fuzz, goldens, package, paths, script, site, tools};

/// When a stage runs without being named.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Ring {
    /// With each `cargo xtask test`.
    Quick,
    /// With `--all`.
    All,
    /// Never: it runs by its name alone.
    Demand,
}
use Ring::{All, Demand, Quick};

/// One check.
struct Stage {
    ring: Ring,
    name: &'static str,
    about: &'static str,
    run: fn() -> Result<()>,
    /// The stage whose result this one uses.
    needs: Option<&'static str>,
    in_browser: bool,
    /// Uses one core: it runs in the background of the others.
    in_background: bool,
}

/// A table of stages: the ring, the name, the stage that it needs, what it checks, the function and flags.
macro_rules! stages {
    ($( $ring:ident $name:literal $(needs $needs:literal)? : $about:literal, $run:path $(, $flag:ident)*; )+) => {
        &[ $( {
            let stage = Stage {
                ring: $ring,
                name: $name,
                about: $about,
                run: $run,
                needs: None,
                in_browser: false,
                in_background: false,
            };
            $( let stage = Stage { needs: Some($needs), ..stage }; )?
            $( let stage = Stage { $flag: true, ..stage }; )*
            stage
        }, )+ ]
    };
}

const STAGES: &[Stage] = stages! {
    Quick "format": "the code is formatted", code::format;
    Quick "generated": "generated files match the parameter table", generated;
    Quick "lint": "clippy accepts the native code", code::lint;
    Quick "lint-wasm": "clippy accepts the code for the browser", code::lint_wasm;
    Quick "lint-web": "biome accepts the format of scripts, and lints scripts and style sheets", script::lint;
    All "docs": "the libraries' documentation builds without a warning", code::docs;
    Quick "site": "the static site builds", site::build;
    Quick "types" needs "site": "the compiler accepts the types of the scripts", script::check_types;
    Quick "package" needs "site": "the npm package is whole and names no folder of this machine", package::make;
    Quick "size" needs "site": "downloads are no larger than recorded", size;
    Quick "library" needs "site": "the headless library keeps its laws in Node, and the native bits", library::laws_in_node;
    Quick "native": "quick laws of the physics, and every unit test", code::native;
    Quick "shaders": "the reference compiler accepts every shader", code::shaders;
    Quick "web": "scripts that need no browser, in Node", library::scripts_in_node;
    All "burns": "laws of the physics that burn for minutes", code::burns;
    All "fuzz": "inputs that coverage guides keep the laws of the decoders", fuzz::shortly, in_background;
    All "publish": "the crates could be published", library::publishable, in_background;
    All "baselines": "the benchmarks' baselines compute the same gas", baselines::check, in_background;
    All "cost" needs "site": "steps take no more instructions, and first visits no more bytes, than recorded", cost::check, in_background, in_browser;
    All "wasm": "wasm gives the native bits", browser::wasm_in_node, in_background;
    All "browser": "shaders and canvases in headless Chromium", browser::wasm_in_chromium, in_background, in_browser;
    All "consumers" needs "package": "the npm package works in pages, bundlers, React and on servers", browser::consumers, in_background, in_browser;
    All "trunk" needs "site": "the page that Trunk builds and serves burns", trunk::page_burns, in_background, in_browser;
    Demand "trunk-files" needs "site": "Trunk builds the same files", trunk::same_files;
    All "goldens": "fires match the golden pictures", goldens::check, in_background;
    Quick "e2e-core" needs "site": "a visitor's first minutes, in Chromium", browser::core, in_browser;
    All "e2e" needs "site": "the page in Chromium, and its core in Firefox and WebKitGTK", browser::extended, in_browser;
};

/// Runs the named stages, or those of the quick ring, or with `all` of both rings, and prints a report; returns
/// whether all passed.
pub(crate) fn run(skip_browser: bool, all: bool, names: &[String]) -> Result<bool> {
    if names.is_empty() {
        tools::whole_ring(all, !skip_browser)?;
    }
    let report = Report::new();
    let run = |stages: Vec<&Stage>| {
        for stage in stages {
            if stage.in_browser && skip_browser {
                report.skip(stage.name);
            } else {
                report.stage(stage.name, stage.about, stage.needs, stage.run);
            }
        }
    };
    let ring = if all { All } else { Quick };
    let (background, others) = chosen(ring, names)?
        .into_iter()
        .partition(|stage| stage.in_background);
    thread::scope(|scope| {
        scope.spawn(|| run(background));
        run(others);
    });
    print!("\n{}", report.summary());
    Ok(report.passed())
}

/// The stages of these names and what they need, in order; without a name, those up to this ring.
fn chosen(ring: Ring, names: &[String]) -> Result<Vec<&'static Stage>> {
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
        let of_ring = names.is_empty() && stage.ring <= ring;
        if of_ring || wanted.contains(&stage.name) {
            wanted.extend(stage.needs);
            chosen.insert(0, stage);
        }
    }
    Ok(chosen)
}

fn generated() -> Result<()> {
    let written = script::generated_files()?;
    ensure!(
        written.is_empty(),
        "these files were out of date and have been written; commit them: {}",
        written.join(", ")
    );
    Ok(())
}

fn size() -> Result<()> {
    package::sizes(&paths::site().join("web"), false)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(ring: Ring, requested: &[&str]) -> Result<Vec<&'static str>> {
        let requested: Vec<_> = requested.iter().map(|&name| name.to_owned()).collect();
        Ok(chosen(ring, &requested)?
            .iter()
            .map(|stage| stage.name)
            .collect())
    }

    #[test]
    fn a_stage_brings_what_it_needs() -> Result<()> {
        assert_eq!(names(Quick, &["e2e"])?, ["site", "e2e"]);
        assert_eq!(
            names(All, &["consumers"])?,
            ["site", "package", "consumers"]
        );
        assert_eq!(names(Quick, &["trunk-files"])?, ["site", "trunk-files"]);
        assert_eq!(names(Quick, &["native", "format"])?, ["format", "native"]);
        Ok(())
    }

    #[test]
    fn a_ring_contains_the_rings_inside() -> Result<()> {
        let (quick, all) = (names(Quick, &[])?, names(All, &[])?);
        assert!(quick.iter().all(|name| all.contains(name)));
        assert!(quick.contains(&"e2e-core") && !quick.contains(&"e2e"));
        assert!(all.contains(&"e2e") && !all.contains(&"trunk-files"));
        Ok(())
    }

    #[test]
    fn an_unknown_stage_is_refused_with_the_known_ones() {
        let error = names(Quick, &["everything"])
            .err()
            .map(|error| error.to_string());
        assert!(error.is_some_and(|error| error.contains("native")));
    }

    #[test]
    fn a_stage_comes_after_what_it_needs() {
        for (at, stage) in STAGES.iter().enumerate() {
            // Stages in the background may wait for them, and never the other way round.
            let ends =
                |it: &Stage, need| it.name == need && (stage.in_background || !it.in_background);
            let before = |need| STAGES[..at].iter().any(|it| ends(it, need));
            assert!(stage.needs.is_none_or(before), "{}", stage.name);
        }
    }
}
