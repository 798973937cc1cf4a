//! `cargo xtask test`: every check of the project, one after another.
//!
//! A stage that fails does not stop the others, so that one run tells
//! everything; what needs its result is not run. Quick and strict stages come
//! first. One target folder and one set of flags serve all of them, so nothing
//! is compiled twice that need not be.

pub(crate) mod browser;
mod code;
mod library;
mod package;
mod trunk;

use anyhow::{Result, bail};

use crate::report::Report;
use crate::{bench, codegen, goldens, script, site, size};

/// One check.
struct Stage {
    name: &'static str,
    about: &'static str,
    /// Stages whose result this one uses.
    needs: &'static [&'static str],
    /// Whether it is left out with the browser.
    in_browser: bool,
    run: fn(&Options) -> Result<()>,
}

/// What a person asked for.
pub(crate) struct Options {
    /// Leave out what needs a browser.
    pub skip_browser: bool,
}

const STAGES: &[Stage] = &[
    Stage {
        name: "format",
        about: "the code is formatted",
        needs: &[],
        in_browser: false,
        run: |_| code::format(),
    },
    Stage {
        name: "generated",
        about: "generated files are those of the parameter table",
        needs: &[],
        in_browser: false,
        run: |_| generated(),
    },
    Stage {
        name: "lint",
        about: "clippy has nothing to say about native code",
        needs: &[],
        in_browser: false,
        run: |_| code::lint(),
    },
    Stage {
        name: "lint-wasm",
        about: "nor about code for the browser",
        needs: &[],
        in_browser: false,
        run: |_| code::lint_wasm(),
    },
    Stage {
        name: "lint-web",
        about: "biome has nothing to say about scripts and style sheets",
        needs: &[],
        in_browser: false,
        run: |_| script::lint(),
    },
    Stage {
        name: "docs",
        about: "documentation of the libraries builds without a warning",
        needs: &[],
        in_browser: false,
        run: |_| code::docs(),
    },
    Stage {
        name: "native",
        about: "laws of the physics, and every unit test",
        needs: &[],
        in_browser: false,
        run: |_| code::native(),
    },
    Stage {
        name: "shaders",
        about: "the reference compiler has nothing to say about any shader",
        needs: &[],
        in_browser: false,
        run: |_| code::shaders(),
    },
    Stage {
        name: "web",
        about: "what is pure in the scripts, in Node",
        needs: &[],
        in_browser: false,
        run: |_| library::scripts_in_node(),
    },
    Stage {
        name: "site",
        about: "the static site builds",
        needs: &[],
        in_browser: false,
        run: |_| site::build(),
    },
    Stage {
        name: "types",
        about: "the compiler finds no error in the types of scripts",
        needs: &["site"],
        in_browser: false,
        run: |_| script::check_types(),
    },
    Stage {
        name: "size",
        about: "downloads stay small",
        needs: &["site"],
        in_browser: false,
        run: |_| size::check(),
    },
    Stage {
        name: "library",
        about: "the simulation as a library in Node keeps its laws, and gives the native bits",
        needs: &["site"],
        in_browser: false,
        run: |_| library::laws_in_node(),
    },
    Stage {
        name: "publish",
        about: "the physics could be published as a crate",
        needs: &[],
        in_browser: false,
        run: |_| library::publishable(),
    },
    Stage {
        name: "baselines",
        about: "what benchmarks compare with computes the same gas",
        needs: &[],
        in_browser: false,
        run: |_| bench::baselines(),
    },
    Stage {
        name: "cost",
        about: "a step takes no more instructions than it did",
        needs: &[],
        in_browser: false,
        run: |_| bench::instructions(),
    },
    Stage {
        name: "wasm",
        about: "the same bits in wasm as natively",
        needs: &[],
        in_browser: false,
        run: |_| browser::wasm_in_node(),
    },
    Stage {
        name: "browser",
        about: "shaders and canvases in headless Chromium",
        needs: &[],
        in_browser: true,
        run: |_| browser::wasm_in_chromium(),
    },
    Stage {
        name: "goldens",
        about: "fires look as they did, and as they should",
        needs: &[],
        in_browser: true,
        run: |_| goldens::check(),
    },
    Stage {
        name: "e2e",
        about: "the page as a visitor uses it, and its element in every browser",
        needs: &["site"],
        in_browser: true,
        run: |_| browser::end_to_end(),
    },
    Stage {
        name: "consumers",
        about: "the npm package serves its users: pages, bundlers, React, servers",
        needs: &["site"],
        in_browser: true,
        run: |_| package::consumers(),
    },
    Stage {
        name: "trunk",
        about: "Trunk gives the same page",
        needs: &["site"],
        in_browser: false,
        run: |options| trunk::same_page(options.skip_browser),
    },
];

/// Runs the named stages, or all of them, and prints how they went; whether
/// all passed.
///
/// # Errors
/// A name that no stage has.
pub fn run(skip_browser: bool, names: &[String]) -> Result<bool> {
    let options = Options { skip_browser };
    let mut report = Report::new();
    for stage in chosen(names)? {
        if stage.in_browser && skip_browser {
            report.skip(stage.name);
        } else {
            report.stage(stage.name, stage.about, stage.needs, || {
                (stage.run)(&options)
            });
        }
    }
    print!("\n{}", report.summary());
    Ok(report.passed())
}

/// The stages of these names and what they need, in order; none: all.
fn chosen(names: &[String]) -> Result<Vec<&'static Stage>> {
    if let Some(name) = names
        .iter()
        .find(|name| STAGES.iter().all(|stage| stage.name != name.as_str()))
    {
        let all: Vec<_> = STAGES.iter().map(|stage| stage.name).collect();
        bail!(
            "there is no stage \"{name}\"; there are: {}",
            all.join(", ")
        );
    }
    let asked = |stage: &Stage| names.is_empty() || names.iter().any(|name| name == stage.name);
    let needed = |stage: &Stage| {
        STAGES
            .iter()
            .any(|other| asked(other) && other.needs.contains(&stage.name))
    };
    Ok(STAGES
        .iter()
        .filter(|stage| asked(stage) || needed(stage))
        .collect())
}

fn generated() -> Result<()> {
    let written = codegen::refresh_checkout()?;
    if !written.is_empty() {
        bail!(
            "these were behind the parameter table and have been written anew; commit them: {}",
            written.join(", ")
        );
    }
    Ok(())
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
        assert_eq!(names(&["native", "format"])?, ["format", "native"]);
        assert_eq!(names(&[])?.len(), STAGES.len());
        Ok(())
    }

    #[test]
    fn an_unknown_stage_is_refused_with_the_known_ones() {
        let said = names(&["everything"]).err().map(|error| error.to_string());
        assert!(said.is_some_and(|said| said.contains("native")));
    }

    #[test]
    fn what_a_stage_needs_comes_before_it() {
        for (at, stage) in STAGES.iter().enumerate() {
            for need in stage.needs {
                assert!(STAGES[..at].iter().any(|earlier| earlier.name == *need));
            }
        }
    }
}
