//! `cargo xtask test`: every check of the project, one after another.
//!
//! A stage that fails stops only the stages that need its result, so one run reports
//! everything. Quick and strict stages come first. All stages share one target folder and
//! one set of flags, so that little is compiled twice. A long stage that passed does not run
//! again while nothing changes.

pub(crate) mod browser;
mod code;
mod library;
mod trunk;

use anyhow::{Result, bail, ensure};
use xshell::cmd;

use crate::report::Report;
use crate::shell::Shell;
use crate::{bench, codegen, goldens, package, paths, script, site, tools};

/// One check.
struct Stage {
    name: &'static str,
    about: &'static str,
    run: fn() -> Result<()>,
    /// The stage whose result this one uses.
    needs: Option<&'static str>,
    in_browser: bool,
    /// Takes long and makes nothing: it runs only where an input changed since it passed.
    remembered: bool,
}

impl Stage {
    const fn new(name: &'static str, about: &'static str, run: fn() -> Result<()>) -> Stage {
        Stage {
            name,
            about,
            run,
            needs: None,
            in_browser: false,
            remembered: false,
        }
    }

    const fn needs(mut self, stage: &'static str) -> Stage {
        self.needs = Some(stage);
        self
    }

    const fn in_browser(mut self) -> Stage {
        self.in_browser = true;
        self
    }

    const fn remembered(mut self) -> Stage {
        self.remembered = true;
        self
    }

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

const STAGES: &[Stage] = &[
    Stage::new("format", "the code is formatted", code::format),
    Stage::new(
        "generated",
        "generated files match the parameter table",
        generated,
    ),
    Stage::new("lint", "clippy accepts the native code", code::lint),
    Stage::new(
        "lint-wasm",
        "clippy accepts the code for the browser",
        code::lint_wasm,
    ),
    Stage::new(
        "lint-web",
        "biome accepts the scripts and style sheets",
        script::lint,
    ),
    Stage::new(
        "docs",
        "the libraries' documentation builds without a warning",
        code::docs,
    ),
    Stage::new(
        "native",
        "laws of the physics, and every unit test",
        code::native,
    )
    .remembered(),
    Stage::new(
        "shaders",
        "the reference compiler accepts every shader",
        code::shaders,
    ),
    Stage::new(
        "web",
        "scripts that need no browser, in Node",
        library::scripts_in_node,
    ),
    Stage::new("site", "the static site builds", site::build),
    Stage::new(
        "types",
        "the compiler accepts the types of the scripts",
        script::check_types,
    )
    .needs("site"),
    Stage::new("size", "downloads stay small", size).needs("site"),
    Stage::new(
        "package",
        "the npm package is whole and reproducible, and names no folder of this machine",
        package::make,
    )
    .needs("site"),
    Stage::new(
        "library",
        "the headless library keeps its laws in Node, and the native bits",
        library::laws_in_node,
    )
    .needs("site")
    .remembered(),
    Stage::new(
        "publish",
        "the crates could be published",
        library::publishable,
    ),
    Stage::new(
        "baselines",
        "the benchmarks' baselines compute the same gas",
        bench::baselines,
    ),
    Stage::new(
        "cost",
        "a step takes no more instructions than recorded",
        bench::instructions,
    )
    .remembered(),
    Stage::new("wasm", "wasm gives the native bits", browser::wasm_in_node).remembered(),
    Stage::new(
        "browser",
        "shaders and canvases in headless Chromium",
        browser::wasm_in_chromium,
    )
    .in_browser()
    .remembered(),
    Stage::new("goldens", "fires match the golden pictures", goldens::check).in_browser(),
    Stage::new(
        "e2e",
        "the page in Chromium, and its element in every browser",
        browser::end_to_end,
    )
    .needs("site")
    .in_browser(),
    Stage::new(
        "consumers",
        "the npm package works in pages, bundlers, React and on servers",
        browser::consumers,
    )
    .needs("package")
    .in_browser()
    .remembered(),
    Stage::new("trunk", "Trunk builds the same site", trunk::same_site).needs("site"),
    Stage::new(
        "trunk-page",
        "the page that Trunk builds and serves burns",
        trunk::page_burns,
    )
    .needs("trunk")
    .in_browser(),
];

/// Runs the named stages, or every stage, and prints a report; returns whether all passed.
/// With `all`, what passed before runs again.
pub(crate) fn run(skip_browser: bool, all: bool, names: &[String]) -> Result<bool> {
    if all {
        Shell::new()?.remove_path(tools::passed("")?)?;
    }
    let mut report = Report::default();
    for stage in chosen(names)? {
        if stage.in_browser && skip_browser {
            report.skip(stage.name);
        } else {
            report.stage(stage.name, stage.about, stage.needs, || stage.run());
        }
    }
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
    if !written.is_empty() {
        bail!(
            "these files were out of date and have been written; commit them: {}",
            written.join(", ")
        );
    }
    Ok(())
}

fn size() -> Result<()> {
    package::sizes(&paths::site().join("web"))
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
            let before = |need| STAGES[..at].iter().any(|earlier| earlier.name == need);
            assert!(stage.needs.is_none_or(before), "{}", stage.name);
        }
    }
}
