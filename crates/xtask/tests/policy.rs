//! The policy for the code of others: its licences, its registries and what is banned. A new
//! exception is a decision, and is added to `docs/decisions/build.md`.

mod locks;

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

use locks::{LOCKS, locked, root};
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
const OF_TOOLS: [&str; 1] = ["MPL-2.0"];

/// Crates that no module of the browser contains: they bring chance without a seed, threads
/// or requests.
const BANNED_IN_BROWSERS: [&str; 6] = ["getrandom", "rand", "rayon", "reqwest", "ureq", "gloo-net"];

/// Crates that nothing here uses: each needs a library of the system, or opens connections.
const BANNED: [&str; 6] = [
    "curl-sys",
    "hyper",
    "native-tls",
    "openssl-sys",
    "reqwest",
    "ureq",
];

/// Crates of which the browser's modules contain two versions: `png` and `flate2` differ.
const TWICE: [&str; 1] = ["miniz_oxide"];

/// npm packages with a script that runs on installation. `.npmrc` forbids that one to run.
const INSTALL_SCRIPTS: [&str; 1] = ["node_modules/esbuild"];

/// Whether these licences are enough for an SPDX expression.
fn allowed(expression: &str, licences: &[&str]) -> bool {
    let whole = expression.trim();
    for (operator, any) in [(" OR ", true), (" AND ", false)] {
        let parts = split(whole, operator);
        if parts.len() > 1 {
            let mut each = parts.into_iter().map(|part| allowed(part, licences));
            return if any {
                each.any(|one| one)
            } else {
                each.all(|one| one)
            };
        }
    }
    match whole
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'))
    {
        Some(inside) => allowed(inside, licences),
        None => licences.contains(&whole),
    }
}

fn allowed_for_tools(expression: &str) -> bool {
    allowed(expression, &[&RELEASED[..], &OF_TOOLS].concat())
}

/// The parts of an expression between the operators that stand outside of parentheses.
fn split<'a>(expression: &'a str, operator: &str) -> Vec<&'a str> {
    let (mut parts, mut start) = (Vec::new(), 0);
    for (at, _) in expression.match_indices(operator) {
        let before = &expression[..at];
        if before.matches('(').count() == before.matches(')').count() {
            parts.push(&expression[start..at]);
            start = at + operator.len();
        }
    }
    parts.push(&expression[start..]);
    parts
}

#[test]
fn a_choice_needs_one_allowed_licence_and_a_sum_needs_all() {
    for (expression, expected) in [
        ("MIT", true),
        ("GPL-3.0-only", false),
        ("MIT OR GPL-3.0-only", true),
        ("MIT AND GPL-3.0-only", false),
        ("(MIT OR GPL-3.0-only) AND Zlib", true),
        ("MIT AND (GPL-2.0-only OR GPL-3.0-only)", false),
        ("Apache-2.0 WITH LLVM-exception", true),
        ("", false),
    ] {
        assert_eq!(allowed(expression, &RELEASED), expected, "{expression}");
    }
}

fn metadata(arguments: &[&str]) -> Result<Value> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["metadata", "--format-version", "1"]);
    let output = command.args(arguments).current_dir(root()).output()?;
    Ok(serde_json::from_slice(&output.stdout)?)
}

fn text<'a>(value: &'a Value, field: &str) -> &'a str {
    value[field].as_str().unwrap_or_default()
}

fn list<'a>(value: &'a Value, field: &str) -> impl Iterator<Item = &'a Value> {
    value[field].as_array().into_iter().flatten()
}

/// Every crate that a command here compiles on this machine or for browsers.
#[test]
fn every_crate_has_an_allowed_licence() -> Result {
    let compiler = Command::new("rustc")
        .args(["--print", "host-tuple"])
        .output()?;
    let host = String::from_utf8(compiler.stdout)?;
    let platforms = ["--filter-platform", host.trim(), "--filter-platform"];
    let described = metadata(&[&platforms[..], &["wasm32-unknown-unknown"]].concat())?;
    let mut checked = 0;
    for package in list(&described, "packages") {
        // Older crates separate alternatives by a slash.
        let licence = text(package, "license").replace('/', " OR ");
        let name = text(package, "name");
        assert!(allowed_for_tools(&licence), "{name}: licence {licence:?}");
        checked += 1;
    }
    assert!(checked > 100, "{checked} crates");
    Ok(())
}

/// What the browser's modules contain, by the bill of materials.
fn materials() -> Result<Vec<Value>> {
    let bill = fs::read_to_string(root().join("web/hearth-fire.cdx.json"))?;
    let bill: Value = serde_json::from_str(&bill)?;
    Ok(list(&bill, "components").cloned().collect())
}

#[test]
fn browsers_get_one_version_of_each_crate_with_a_licence_and_a_notice() -> Result {
    let notices = fs::read_to_string(root().join("web/THIRD-PARTY.txt"))?.replace("\r\n", "\n");
    let mut versions: BTreeMap<String, u32> = BTreeMap::new();
    for component in materials()? {
        let (name, version) = (text(&component, "name"), text(&component, "version"));
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
        assert!(!BANNED_IN_BROWSERS.contains(&name), "{name} is banned");
        *versions.entry(name.to_owned()).or_default() += 1;
    }
    let twice: Vec<_> = versions
        .into_iter()
        .filter(|(_, count)| *count > 1)
        .collect();
    assert_eq!(twice, TWICE.map(|name| (name.to_owned(), 2)));
    Ok(())
}

#[test]
fn crates_come_from_one_registry_with_a_checksum_and_none_is_banned() -> io::Result<()> {
    for file in LOCKS {
        let foreign = locked(file)?
            .into_iter()
            .filter(|[_, _, source, _]| !source.is_empty());
        let mut registries = BTreeSet::new();
        for [name, version, source, checksum] in foreign {
            assert_eq!(
                checksum.len(),
                64,
                "{file}: {name} {version} has no checksum"
            );
            assert!(!BANNED.contains(&name.as_str()), "{file}: {name} is banned");
            registries.insert(source);
        }
        let known =
            |name: &String| name.starts_with("registry+") && name.ends_with("/crates.io-index");
        assert!(
            registries.len() == 1 && registries.iter().all(known),
            "{file}: {registries:?}"
        );
    }
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
            assert!(
                allowed_for_tools(text(package, "license")),
                "{place}: licence"
            );
            assert!(
                text(package, "integrity").starts_with("sha512-"),
                "{place}: checksum"
            );
            assert!(package["resolved"].is_null(), "{place}: address");
            let scripts = package["hasInstallScript"] == true;
            assert!(
                !scripts || INSTALL_SCRIPTS.contains(&name.as_str()),
                "{place}: script"
            );
        }
        let settings = fs::read_to_string(file.with_file_name(".npmrc"))?;
        assert!(
            settings.contains("omit-lockfile-registry-resolved=true"),
            "{}",
            file.display()
        );
    }
    Ok(())
}
