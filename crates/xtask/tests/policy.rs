//! The policy for the code of others: its licences and its sources. A new exception is a decision,
//! and is added to `docs/decisions/build.md`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

use serde_json::Value;

type Result<T = ()> = std::result::Result<T, Box<dyn Error>>;

/// The licences of what is released.
const RELEASED: [&str; 10] = [
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "ISC",
    "MIT",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

/// The licences that tools may have as well: nothing of a tool is released.
const OF_TOOLS: [&str; 3] = ["BlueOak-1.0.0", "CC-BY-4.0", "MPL-2.0"];

/// Whether these licences are enough for an SPDX expression: every licence of one with `AND`, otherwise one of them.
fn allowed(expression: &str, licences: &[&str]) -> bool {
    // Older crates separate alternatives by a slash.
    let flat = expression
        .replace(['(', ')'], "")
        .replace('/', " OR ")
        .replace(" AND ", " OR ");
    let mut named = flat.split(" OR ");
    let is_allowed = |licence: &str| licences.contains(&licence);
    if expression.contains(" AND ") {
        named.all(is_allowed)
    } else {
        named.any(is_allowed)
    }
}

fn allowed_for_tools(expression: &str) -> bool {
    allowed(expression, &[&RELEASED[..], &OF_TOOLS].concat())
}

#[test]
fn a_choice_needs_one_allowed_licence_and_a_sum_needs_all() {
    for (expression, expected) in [
        ("MIT", true),
        ("GPL-3.0-only", false),
        ("MIT OR GPL-3.0-only", true),
        ("GPL-2.0/MIT", true),
        ("MIT AND GPL-3.0-only", false),
        ("(MIT OR Apache-2.0) AND Zlib", true),
        ("Apache-2.0 WITH LLVM-exception", true),
        ("", false),
    ] {
        assert_eq!(allowed(expression, &RELEASED), expected, "{expression}");
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text<'a>(value: &'a Value, field: &str) -> &'a str {
    value[field].as_str().unwrap_or_default()
}

fn list<'a>(value: &'a Value, field: &str) -> impl Iterator<Item = &'a Value> {
    value[field].as_array().into_iter().flatten()
}

/// A folder with the notices that `legal.mjs` writes after these arguments.
fn notices(arguments: &[&str]) -> Result<xshell::TempDir> {
    let folder = xshell::Shell::new()?.create_temp_dir()?;
    let script = root().join("crates/xtask/packaging/legal.mjs");
    let mut node = Command::new("node");
    let status = node
        .arg(script)
        .args(arguments)
        .arg(folder.path())
        .status()?;
    assert!(status.success(), "{status}");
    Ok(folder)
}

/// Every crate that a command here compiles on this machine or for browsers.
#[test]
fn every_crate_has_an_allowed_licence_and_comes_from_one_registry() -> Result {
    let compiler = Command::new("rustc")
        .args(["--print", "host-tuple"])
        .output()?;
    let host = String::from_utf8(compiler.stdout)?;
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut metadata = Command::new(cargo);
    metadata.args(["metadata", "--format-version", "1"]);
    metadata.args(["--filter-platform", "wasm32-unknown-unknown"]);
    metadata.args(["--filter-platform", host.trim()]);
    let described: Value = serde_json::from_slice(&metadata.current_dir(root()).output()?.stdout)?;
    let mut checked = 0;
    for package in list(&described, "packages") {
        let (name, licence) = (text(package, "name"), text(package, "license"));
        assert!(allowed_for_tools(licence), "{name}: licence {licence:?}");
        let source = &package["source"];
        let of_registry = text(package, "source").ends_with("/crates.io-index");
        assert!(source.is_null() || of_registry, "{name}: source {source}");
        checked += 1;
    }
    assert!(checked > 100, "{checked} crates");
    Ok(())
}

/// What the browser's modules contain, by the bill of materials.
#[test]
fn what_browsers_get_has_a_licence_a_checksum_and_a_notice() -> Result {
    let made = notices(&[])?;
    let bill = fs::read_to_string(made.path().join("hearth-fire.cdx.json"))?;
    let bill: Value = serde_json::from_str(&bill)?;
    let notices = fs::read_to_string(made.path().join("THIRD-PARTY.txt"))?;
    assert!(list(&bill, "components").count() > 50);
    for component in list(&bill, "components") {
        let (name, version) = (text(component, "name"), text(component, "version"));
        if component["purl"].is_null() {
            assert!(
                notices.contains(&format!("\n{name}, ")),
                "no notice of {name}"
            );
            continue;
        }
        let licence = text(&component["licenses"][0], "expression");
        assert!(allowed(licence, &RELEASED), "{name}: licence {licence:?}");
        let notice = format!("\n{name} {version}, {licence}");
        assert!(notices.contains(&notice), "no notice of {name} {version}");
        let checksum = text(&component["hashes"][0], "content");
        assert_eq!(checksum.len(), 64, "{name} {version}: {checksum:?}");
    }
    Ok(())
}

/// What `cargo install` compiles into the command `hearth` on Linux.
#[test]
fn every_crate_of_the_command_has_a_licence_and_a_notice() -> Result {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut tree = Command::new(cargo);
    tree.args(["tree", "--package", "hearth-fire-cli", "--prefix", "none"]);
    tree.args(["--edges", "normal,no-proc-macro", "--format", "{p}|{l}"]);
    tree.arg("--no-dedupe");
    tree.args(["--target", "x86_64-unknown-linux-gnu"]);
    let listed = String::from_utf8(tree.current_dir(root()).output()?.stdout)?;
    let made = notices(&["--command"])?;
    let notices = fs::read_to_string(made.path().join("THIRD-PARTY.txt"))?;
    let mut checked = 0;
    // A crate of the workspace has its folder behind its version.
    for line in listed.lines().filter(|line| !line.contains(" (/")) {
        let Some((package, licence)) = line.split_once('|') else {
            continue;
        };
        assert!(
            allowed(licence, &RELEASED),
            "{package}: licence {licence:?}"
        );
        let package = package.replacen(" v", " ", 1);
        let notice = format!("\n{package}, ");
        assert!(notices.contains(&notice), "no notice of {package}");
        checked += 1;
    }
    assert!(checked > 20, "{checked} crates");
    Ok(())
}

/// The lock files of npm below a folder.
fn npm_locks(folder: &Path, found: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let (path, name) = entry.map(|entry| (entry.path(), entry.file_name()))?;
        let skipped = ["target", "dist", "node_modules"]
            .iter()
            .any(|&skipped| name == skipped);
        if path.is_dir() && !skipped {
            npm_locks(&path, found)?;
        } else if name == "package-lock.json" {
            found.push(path);
        }
    }
    Ok(())
}

#[test]
fn npm_packages_have_an_allowed_licence_and_a_checksum_and_name_no_address() -> Result {
    let mut files = Vec::new();
    npm_locks(&root(), &mut files)?;
    assert!(files.len() >= 6, "{files:?}");
    for file in files {
        let lock: Value = serde_json::from_str(&fs::read_to_string(&file)?)?;
        let packages = lock["packages"].as_object().into_iter().flatten();
        // The first is the folder itself.
        for (name, package) in packages.filter(|(name, _)| !name.is_empty()) {
            let place = format!("{}: {name}", file.display());
            let licence = text(package, "license");
            assert!(allowed_for_tools(licence), "{place}: licence {licence:?}");
            let checksum = text(package, "integrity");
            assert!(checksum.starts_with("sha512-"), "{place}: checksum");
            assert!(package["resolved"].is_null(), "{place}: address");
        }
    }
    Ok(())
}
