//! The `use` declarations between the files of a crate form no circle, and the state of the panel
//! uses no view.
//!
//! A `mod` declaration of a parent is not a use. Unit tests may use any file.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// A crate's files by module path, "" for the root.
type Modules = BTreeMap<String, PathBuf>;

fn modules(folder: &Path, path: &str, found: &mut Modules) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let file = entry?.path();
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let module = match &*stem {
            "lib" | "main" | "mod" => path.to_owned(),
            stem if path.is_empty() => stem.to_owned(),
            stem => format!("{path}::{stem}"),
        };
        if file.is_dir() {
            modules(&file, &module, found)?;
        } else if file.extension().is_some_and(|end| end == "rs") {
            found.insert(module, file);
        }
    }
    Ok(())
}

/// The sources without comments and unit tests.
fn code(file: &Path) -> io::Result<String> {
    let text = fs::read_to_string(file)?;
    let before_tests = text.split("mod tests {").next();
    let lines = before_tests.unwrap_or_default().lines();
    let code = lines.filter(|line| !line.trim_start().starts_with("//"));
    Ok(code.collect::<Vec<_>>().join("\n"))
}

/// Every path in a `use` of these sources, and whether it is public.
fn uses(code: &str) -> Vec<(bool, String)> {
    let mut found = Vec::new();
    for statement in code.split(';') {
        let lines = statement.lines();
        let Some(start) = statement.lines().position(|line| {
            let line = line.trim_start().trim_start_matches("pub ");
            let line = line.split_once(") ").map_or(line, |(visibility, rest)| {
                if visibility.starts_with("pub(") {
                    rest
                } else {
                    line
                }
            });
            line.starts_with("use ")
        }) else {
            continue;
        };
        let text: String = lines.skip(start).map(str::trim).collect();
        let Some((visibility, tree)) = text.split_once("use ") else {
            continue;
        };
        let mut paths = Vec::new();
        expand("", tree, &mut paths);
        found.extend(paths.into_iter().map(|path| (!visibility.is_empty(), path)));
    }
    found
}

/// The paths of a use tree.
fn expand(prefix: &str, tree: &str, paths: &mut Vec<String>) {
    let tree = tree.trim();
    let Some((head, rest)) = tree.split_once('{') else {
        let name = tree.split(" as ").next().unwrap_or_default();
        paths.push(format!("{prefix}{name}"));
        return;
    };
    let prefix = format!("{prefix}{head}");
    let inside = rest.strip_suffix('}').unwrap_or(rest);
    let (mut depth, mut start) = (0, 0);
    for (at, letter) in inside.char_indices().chain([(inside.len(), ',')]) {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                if !inside[start..at].trim().is_empty() {
                    expand(&prefix, &inside[start..at], paths);
                }
                start = at + 1;
            }
            _ => {}
        }
    }
}

/// The absolute module path of a use in `module`.
fn absolute(module: &str, path: &str, modules: &Modules) -> Option<String> {
    let mut base: Vec<&str> = module.split("::").filter(|part| !part.is_empty()).collect();
    let mut parts = path.split("::").peekable();
    match parts.peek().copied()? {
        "crate" => {
            base.clear();
            parts.next();
        }
        "self" => {
            parts.next();
        }
        "super" => {}
        child => {
            let child = [&base[..], &[child]].concat().join("::");
            modules.contains_key(&child).then_some(())?;
        }
    }
    while parts.next_if_eq(&"super").is_some() {
        base.pop();
    }
    base.extend(parts);
    Some(base.join("::"))
}

/// The module that defines a path, resolved through the exports of the root.
fn target<'a>(path: &str, modules: &'a Modules, exports: &BTreeMap<String, String>) -> &'a str {
    let path = exports.get(path).map_or(path, String::as_str);
    let mut path = path.to_owned();
    loop {
        if let Some((module, _)) = modules.get_key_value(&path) {
            return module;
        }
        path = path
            .rsplit_once("::")
            .map_or(String::new(), |(up, _)| up.to_owned());
    }
}

/// The modules that each module uses.
fn arrows(all: &Modules) -> io::Result<BTreeMap<&str, BTreeSet<&str>>> {
    let mut exports = BTreeMap::new();
    if let Some(root) = all.get("") {
        for (_, path) in uses(&code(root)?).into_iter().filter(|(public, _)| *public) {
            if let Some(path) = absolute("", &path, all) {
                let name = path.rsplit("::").next().unwrap_or_default().to_owned();
                exports.insert(name, path);
            }
        }
    }
    let mut arrows: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (module, file) in all.iter().filter(|(module, _)| !module.is_empty()) {
        for (_, path) in uses(&code(file)?) {
            if let Some(path) = absolute(module, &path, all) {
                let to = target(&path, all, &exports);
                if to != module {
                    arrows.entry(module).or_default().insert(to);
                }
            }
        }
    }
    Ok(arrows)
}

/// The files of a crate that are in a circle.
fn circles(source: &Path) -> io::Result<BTreeSet<PathBuf>> {
    let mut all = Modules::new();
    modules(source, "", &mut all)?;
    let arrows = arrows(&all)?;
    let leads_back = |module: &str| {
        let (mut seen, mut next) = (BTreeSet::new(), vec![module]);
        while let Some(here) = next.pop() {
            for &to in arrows.get(here).into_iter().flatten() {
                if to == module {
                    return true;
                }
                if seen.insert(to) {
                    next.push(to);
                }
            }
        }
        false
    };
    let back = all.iter().filter(|(module, _)| leads_back(module));
    Ok(back.map(|(_, file)| file.clone()).collect())
}

#[test]
fn no_file_is_in_a_circle_of_uses() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let crates = fs::read_dir(root.join("crates")).expect("the crates");
    let mut found = Vec::new();
    for folder in crates {
        let source = folder.expect("a crate").path().join("src");
        for file in circles(&source).expect("sources") {
            let file = file.strip_prefix(&root).expect("a file of this repository");
            found.push(file.to_path_buf());
        }
    }
    assert!(found.is_empty(), "in circles: {found:#?}");
}

#[test]
fn the_state_of_the_panel_uses_no_view() {
    let mut all = Modules::new();
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/hearth-panel/src");
    modules(&source, "", &mut all).expect("sources");
    let arrows = arrows(&all).expect("sources");
    assert!(arrows["panel"].contains("view::header"), "{arrows:?}");
    for (module, uses) in arrows {
        let above = uses.iter().find(|other| {
            let layer = other.split("::").next();
            ["panel", "update", "view", "web"]
                .map(Some)
                .contains(&layer)
        });
        assert!(
            !module.starts_with("state") || above.is_none(),
            "{module} uses {above:?}"
        );
    }
}

#[test]
fn circles_through_braces_parents_and_the_root_are_found() {
    let folder = std::env::temp_dir().join(format!("hearth-circles-{}", std::process::id()));
    let write = |name: &str, text: &str| {
        let file = folder.join(name);
        fs::create_dir_all(file.parent().expect("a folder")).expect("it can be made");
        fs::write(file, text).expect("it can be written");
    };
    write("lib.rs", "mod a;\nmod b;\nmod c;\npub use a::{A, Other};\n");
    write(
        "a.rs",
        "mod inner;\nuse inner::{\n    Deep,\n    Thing,\n};\npub struct A;\n",
    );
    write("a/inner.rs", "use super::super::b::B;\n");
    write("b.rs", "use crate::{A, c};\n");
    write(
        "c.rs",
        "use std::fmt;\n#[cfg(test)]\nmod tests {\n    use crate::b::B;\n}\n",
    );
    let names: Vec<_> = circles(&folder).expect("sources").into_iter().collect();
    let expected = ["a/inner.rs", "a.rs", "b.rs"].map(|name| folder.join(name));
    fs::remove_dir_all(&folder).expect("it can be removed");
    assert_eq!(BTreeSet::from_iter(names), BTreeSet::from(expected));
}
