//! Scripts and style sheets as visitors download them: `scripts/` minifies them. Comments
//! and long names would be half of the download.

use std::path::{Path, PathBuf};

use anyhow::Result;
use xshell::cmd;

use crate::shell::Shell;
use crate::{npm, package, paths};

/// Installs esbuild, which `scripts/` pins.
pub(crate) fn tools() -> Result<()> {
    npm::install(&folder())
}

/// Minifies every script and style sheet of the site in place; `web` is the folder with
/// `package.json`. A script that only one other imports is merged into that one.
pub(crate) fn minify(web: &Path) -> Result<()> {
    tools()?;
    let (sh, scripts) = (Shell::new()?, folder());
    Ok(cmd!(sh, "node {scripts}/minify.mjs {web}").run()?)
}

/// Lints scripts and style sheets, by `biome.json`.
pub(crate) fn lint() -> Result<()> {
    node_program("@biomejs/biome/bin/biome", &["lint", "--error-on-warnings"])
}

/// Checks the types of scripts: strictly those of `web/` (`tsconfig.json`), then those that
/// build and test it. The types of the wasm modules are those of the built site.
pub(crate) fn check_types() -> Result<()> {
    for packages in ["crates/xtask/packaging", "tests/e2e"] {
        npm::install(&paths::root().join(packages))?;
    }
    for project in ["tsconfig.json", "tsconfig.scripts.json"] {
        node_program("typescript/bin/tsc", &["--project", project])?;
    }
    Ok(())
}

/// Derives the files about the element from its class, and those about the code of others
/// from `Cargo.lock`; returns those that it writes, a line each.
pub(crate) fn derived_files() -> Result<String> {
    tools()?;
    let (sh, scripts, packaging) = (Shell::new()?, folder(), package::scripts());
    let element = cmd!(sh, "node {scripts}/element.mjs").read()?;
    let legal = cmd!(sh, "node {packaging}/legal.mjs").read()?;
    Ok(format!("{element}\n{legal}").trim().to_owned())
}

/// Runs a program that `scripts/` pins.
fn node_program(name: &str, arguments: &[&str]) -> Result<()> {
    tools()?;
    let (sh, modules) = (Shell::new()?, folder().join("node_modules"));
    Ok(cmd!(sh, "node {modules}/{name} {arguments...}").run()?)
}

pub(crate) fn folder() -> PathBuf {
    paths::root().join("crates/xtask/scripts")
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
    fn minifying_keeps_every_name_that_another_file_uses() -> Result<()> {
        let folder = Shell::new()?.create_temp_dir()?;
        let web = folder.path();
        for (name, text) in FILES {
            let file = web.join(name);
            fs::create_dir_all(file.parent().unwrap_or(web))?;
            fs::write(file, text)?;
        }
        minify(web)?;
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
        // One file alone imported each of these.
        assert!(!web.join("one.js").exists() && !web.join("in/two.js").exists());
        Ok(())
    }
}
