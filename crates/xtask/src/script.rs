//! Scripts and style sheets as they are shipped: a visitor downloads code, and half
//! of these files, compressed, would be what only their readers need.

use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::{npm, paths, process};

/// Makes sure that what makes them small is installed: the esbuild that `scripts/` pins.
///
/// # Errors
/// No Node, or npm cannot install.
pub(crate) fn tools() -> Result<()> {
    npm::install(&folder())
}

/// Makes every script and style sheet of the site small, each in its place, by one run
/// of esbuild; `web` is the folder with `package.json`. A script that only one other
/// needs goes into that one.
///
/// # Errors
/// No Node, npm cannot install, or a script that is none.
pub(crate) fn minify(web: &Path) -> Result<()> {
    tools()?;
    process::run(
        process::command("node")
            .arg(folder().join("minify.mjs"))
            .arg(web),
    )
}

/// Lints scripts and style sheets, by `biome.json`.
///
/// # Errors
/// No Node, npm cannot install, or a finding.
pub(crate) fn lint() -> Result<()> {
    node_program("@biomejs/biome/bin/biome", &["lint", "--error-on-warnings"])
}

/// Checks the types of scripts: strictly those of `web/` (`tsconfig.json`), then those that
/// build and test it. The types of the wasm modules are those of the built site.
///
/// # Errors
/// No Node, npm cannot install, or a type that is wrong.
pub(crate) fn check_types() -> Result<()> {
    for packages in ["crates/xtask/packaging", "tests/e2e"] {
        npm::install(&paths::root().join(packages))?;
    }
    for project in ["tsconfig.json", "tsconfig.scripts.json"] {
        node_program("typescript/bin/tsc", &["--project", project])?;
    }
    Ok(())
}

/// Derives the files about the element from its class; names those that it writes.
///
/// # Errors
/// No Node, npm cannot install, or a class whose JSDoc lacks something.
pub(crate) fn element_files() -> Result<String> {
    tools()?;
    process::output(process::command("node").arg(folder().join("element.mjs")))
}

/// Runs a program that `scripts/` pins, in the checkout's root.
fn node_program(name: &str, arguments: &[&str]) -> Result<()> {
    tools()?;
    process::run(
        process::command("node")
            .current_dir(paths::root())
            .arg(folder().join("node_modules").join(name))
            .args(arguments),
    )
}

fn folder() -> PathBuf {
    paths::root().join("crates").join("xtask").join("scripts")
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// Files of a small site.
    const FILES: [(&str, &str); 9] = [
        (
            "package.json",
            r#"{ "exports": { ".": "./a.js", "./open": "./open.js" } }"#,
        ),
        (
            "a.js",
            "/*! A licence. */\nimport { one } from './one.js';\nimport './shared.js';\n\
             import './open.js';\n/** @type {number} */\n\
             export const warmth = { perHour: one }; // Much.\n\
             export const ask = () => import('./asked.js');\n",
        ),
        (
            "one.js",
            "import './in/two.js';\nimport './named.js';\nexport const one = 1;\n",
        ),
        (
            "named.js",
            "globalThis.alone = /named\\.js$/.test(import.meta.url);\n",
        ),
        (
            "in/two.js",
            "import '../shared.js';\nglobalThis.style = new URL('../a.css', import.meta.url);\n",
        ),
        ("open.js", "globalThis.open = 1;\n"),
        ("asked.js", "import './shared.js';\n"),
        ("shared.js", "globalThis.shared = 1;\n"),
        ("a.css", "/* Red. */\na {\n  color: red;\n}\n"),
    ];

    #[test]
    fn what_is_for_readers_goes_and_what_others_name_stays() -> Result<()> {
        let web = std::env::temp_dir().join(format!("hearth-script-{}", std::process::id()));
        fs::create_dir_all(web.join("in"))?;
        for (name, text) in FILES {
            fs::write(web.join(name), text)?;
        }
        minify(&web)?;
        let script = fs::read_to_string(web.join("a.js"))?;
        for kept in [
            "/*! A licence. */",
            "warmth",
            "perHour",
            "new URL(\"./a.css\",import.meta.url)",
            "\"./shared.js\"",
            "\"./open.js\"",
            "\"./named.js\"",
            "import(\"./asked.js\")",
        ] {
            assert!(script.contains(kept), "{kept} is not in {script}");
        }
        assert!(!script.contains("Much") && !script.contains("@type"));
        assert_eq!(fs::read_to_string(web.join("a.css"))?, "a{color:red}\n");
        // Each of these was needed by one file alone.
        assert!(!web.join("one.js").exists() && !web.join("in/two.js").exists());
        Ok(fs::remove_dir_all(web)?)
    }
}
