//! The layers of the crate: its files import each other without a cycle, and the state
//! imports no view.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::{fs, io};

/// For each module, the modules that it imports. The crate root only declares modules.
type Graph = BTreeMap<String, BTreeSet<String>>;

fn graph() -> io::Result<Graph> {
    let mut sources = BTreeMap::new();
    read(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        "",
        &mut sources,
    )?;
    let imports = |(module, source): (&String, &String)| {
        let paths = paths(module, source);
        let of = paths.iter().filter_map(|path| owner(path, &sources));
        let others = of.filter(|other| other != module).collect();
        (module.clone(), others)
    };
    Ok(sources.iter().map(imports).collect())
}

/// Reads the sources below `folder` by the paths of their modules.
fn read(folder: &Path, prefix: &str, sources: &mut BTreeMap<String, String>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let module = if stem == "mod" {
            prefix.trim_end_matches("::").to_owned()
        } else {
            format!("{prefix}{stem}")
        };
        if path.is_dir() {
            read(&path, &format!("{module}::"), sources)?;
        } else if module != "lib" {
            sources.insert(module, fs::read_to_string(&path)?);
        }
    }
    Ok(())
}

/// The paths from the crate root that a source names.
fn paths(module: &str, source: &str) -> Vec<String> {
    let code: String = source
        .lines()
        .map(str::trim)
        .filter(|line| !line.starts_with("//"))
        .collect::<Vec<_>>()
        .join(" ");
    assert!(
        !code.replace("use super::*;", "").contains("super::"),
        "{module} imports by super:: instead of crate::"
    );
    let mut all = Vec::new();
    for (root, base) in [
        ("crate::", String::new()),
        ("self::", format!("{module}::")),
    ] {
        for part in code.split(root).skip(1) {
            expand(&base, part, &mut all);
        }
    }
    all
}

/// Adds the paths of `a::b`, or of `a::{b, c::d}`, at the start of `text`.
fn expand(base: &str, text: &str, all: &mut Vec<String>) {
    let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let end = text.find(|c| !is_path(c)).unwrap_or(text.len());
    let (path, rest) = text.split_at(end);
    match rest.strip_prefix('{') {
        Some(list) => {
            let list = list.split('}').next().unwrap_or_default();
            for item in list
                .split(',')
                .map(str::trim)
                .filter(|item| !item.is_empty())
            {
                expand(&format!("{base}{path}"), item, all);
            }
        }
        None => all.push(format!("{base}{path}")),
    }
}

/// The module of the longest prefix of `path`.
fn owner(path: &str, sources: &BTreeMap<String, String>) -> Option<String> {
    let parts: Vec<&str> = path.split("::").collect();
    let prefixes = (1..=parts.len()).rev().map(|end| parts[..end].join("::"));
    prefixes
        .into_iter()
        .find(|prefix| sources.contains_key(prefix))
}

#[test]
fn the_files_import_each_other_without_a_cycle() {
    let mut graph = graph().expect("the sources can be read");
    assert!(graph["panel"].contains("view::header"), "{graph:?}");
    assert!(graph["view::row"].contains("view::control"), "{graph:?}");
    // Files whose imports are all removed are removed in turn; a cycle remains.
    loop {
        let leaves: Vec<String> = graph
            .iter()
            .filter(|(_, imports)| imports.iter().all(|other| !graph.contains_key(other)))
            .map(|(module, _)| module.clone())
            .collect();
        if leaves.is_empty() {
            break;
        }
        for leaf in leaves {
            graph.remove(&leaf);
        }
    }
    assert_eq!(graph, Graph::new());
}

#[test]
fn the_state_imports_no_view() {
    for (module, imports) in graph().expect("the sources can be read") {
        if module.starts_with("state") {
            for other in &imports {
                let above = ["panel", "update", "view", "web"];
                let layer = other.split("::").next().unwrap_or_default();
                assert!(!above.contains(&layer), "{module} imports {other}");
            }
        }
    }
}
