//! Every relative link of the documents leads to a file, and every anchor to a heading. The overviews
//! stay short.

use std::path::{Path, PathBuf};
use std::{fs, io};

use xtask::pages::anchor;

/// Folders with documents. The package's own README is checked where it is packed.
const FOLDERS: [&str; 9] = [
    "",
    "docs",
    "docs/decisions",
    "benches",
    "tests",
    "crates/hearth-core",
    "crates/hearth-fire",
    "crates/hearth-panel/font",
    "examples/worlds",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn documents() -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for folder in FOLDERS {
        for entry in fs::read_dir(root().join(folder))? {
            let path = entry?.path();
            if path.extension().is_some_and(|end| end == "md") {
                found.push(path);
            }
        }
    }
    Ok(found)
}

/// The targets of `[text](target)`, outside of code.
fn links(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for (number, part) in text.split("```").enumerate() {
        if number % 2 == 0 {
            let targets = part.split("](").skip(1);
            found.extend(targets.filter_map(|rest| Some(rest.split_once(')')?.0)));
        }
    }
    found
}

#[test]
fn every_link_of_the_documents_resolves() -> io::Result<()> {
    for document in documents()? {
        let text = fs::read_to_string(&document)?;
        for link in links(&text).into_iter().filter(|link| !link.contains(':')) {
            let (file, fragment) = link.split_once('#').unwrap_or((link, ""));
            let target = match file {
                "" => document.clone(),
                file => document.with_file_name("").join(file),
            };
            assert!(target.exists(), "{}: {link}", document.display());
            if fragment.is_empty() {
                continue;
            }
            let page = fs::read_to_string(&target)?;
            let mut headings = page.lines().filter(|line| line.starts_with('#'));
            assert!(
                headings.any(|heading| anchor(heading.trim_start_matches('#')) == fragment),
                "{}: no heading for {link}",
                document.display()
            );
        }
    }
    Ok(())
}

#[test]
fn the_overviews_stay_short() -> io::Result<()> {
    for (name, limit) in [("ARCHITECTURE.md", 150), ("README.md", 70)] {
        let lines = fs::read_to_string(root().join(name))?.lines().count();
        assert!(lines <= limit, "{name} has {lines} lines");
    }
    Ok(())
}
