//! The layers of the workspace: which of its packages depends on which. A new arrow is a
//! decision, and is added here and to ARCHITECTURE.md.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use serde_json::Value;

/// The packages that a package of `crates/` uses, for its code and for its tests alike.
const ARROWS: [(&str, &[&str]); 13] = [
    ("hearth-fire-core", &[]),
    ("hearth-fire", &["hearth-fire-core"]),
    ("hearth-fire-render", &["hearth-fire-core"]),
    ("hearth-fire-settings", &["hearth-fire-core"]),
    (
        "hearth-bindings",
        &["hearth-fire-core", "hearth-fire-settings"],
    ),
    (
        "hearth-engine",
        &[
            "hearth-bindings",
            "hearth-fire-core",
            "hearth-fire-render",
            "hearth-fire-settings",
        ],
    ),
    (
        "hearth-fire-cli",
        &[
            "hearth-fire-core",
            "hearth-fire-render",
            "hearth-fire-settings",
        ],
    ),
    ("hearth-panel", &["hearth-fire-core"]),
    (
        "hearth-sim",
        &[
            "hearth-bindings",
            "hearth-fire-core",
            "hearth-fire-settings",
        ],
    ),
    ("codegen", &["hearth-fire-core"]),
    ("measure", &["xtask"]),
    ("wasm-parts", &[]),
    ("xtask", &["codegen", "hearth-fire-core", "wasm-parts"]),
];

/// The only packages that the physics uses.
const CORE_USES: [&str; 2] = ["glam", "libm"];

/// Crates of a platform, on which neither the physics nor the renderer depends.
const PLATFORM: [&str; 6] = [
    "egui",
    "eframe",
    "js-sys",
    "wasm-bindgen",
    "web-sys",
    "web-time",
];

fn packages() -> Vec<Value> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let arguments = ["metadata", "--no-deps", "--format-version", "1"];
    let output = Command::new(cargo).args(arguments).output();
    let metadata = output.map(|output| serde_json::from_slice::<Value>(&output.stdout));
    match metadata {
        Ok(Ok(metadata)) => metadata["packages"].as_array().cloned().unwrap_or_default(),
        _ => Vec::new(),
    }
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

/// What a package depends on; `kind` is null for its code, else `dev` or `build`.
fn dependencies(package: &Value, kinds: &[Value]) -> BTreeSet<String> {
    let listed = package["dependencies"].as_array();
    let listed = listed.map(Vec::as_slice).unwrap_or_default().iter();
    let wanted = listed.filter(|dependency| kinds.contains(&dependency["kind"]));
    wanted.map(|dependency| text(&dependency["name"])).collect()
}

#[test]
fn the_crates_depend_on_each_other_by_the_known_arrows_only() {
    let packages = packages();
    let is_crate = |package: &&Value| {
        let manifest = text(&package["manifest_path"]).replace('\\', "/");
        manifest.contains("/crates/")
    };
    let names: BTreeSet<String> = packages
        .iter()
        .map(|package| text(&package["name"]))
        .collect();
    let all = [Value::Null, "dev".into(), "build".into()];
    let found: BTreeMap<String, BTreeSet<String>> = packages
        .iter()
        .filter(is_crate)
        .map(|package| {
            let uses = dependencies(package, &all);
            (
                text(&package["name"]),
                uses.intersection(&names).cloned().collect(),
            )
        })
        .collect();
    let known = ARROWS.map(|(name, uses)| {
        let uses = uses.iter().map(|&used| used.to_owned());
        (name.to_owned(), uses.collect())
    });
    assert_eq!(found, BTreeMap::from(known));
}

#[test]
fn physics_and_renderer_know_no_platform() {
    for package in packages() {
        let name = text(&package["name"]);
        let uses = dependencies(&package, &[Value::Null]);
        if name == "hearth-fire-core" {
            assert_eq!(uses, CORE_USES.map(str::to_owned).into());
        }
        if name == "hearth-fire-render" {
            let platform = PLATFORM.iter().find(|&&name| uses.contains(name));
            assert_eq!(platform, None, "{name}");
        }
    }
}
