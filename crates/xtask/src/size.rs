//! What a visitor downloads: measured as brotli of quality 11 makes it, and
//! held under a ceiling.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::{paths, process, tools};

/// Files that one need makes a browser load together.
struct Download {
    name: &'static str,
    /// Largest allowed size in bytes, compressed.
    ceiling: u64,
    /// Whether the file of that path in `web/` belongs to it.
    holds: fn(&str) -> bool,
}

const DOWNLOADS: [Download; 5] = [
    Download {
        name: "element and engine",
        ceiling: 107_500,
        holds: |path| {
            is_code(path)
                && ![
                    is_of_panel,
                    is_of_library,
                    is_of_bar,
                    is_asked_for,
                    is_of_page,
                ]
                .iter()
                .any(|other| other(path))
        },
    },
    Download {
        name: "bar of colours, on request",
        ceiling: 3_000,
        holds: |path| is_code(path) && is_of_bar(path),
    },
    Download {
        name: "element's rest, each on request",
        ceiling: 4_000,
        holds: |path| is_code(path) && is_asked_for(path),
    },
    Download {
        name: "headless library",
        ceiling: 60_000,
        holds: |path| is_code(path) && is_of_library(path),
    },
    Download {
        name: "panel, on request",
        ceiling: 850_000,
        holds: |path| is_code(path) && is_of_panel(path),
    },
];

fn is_code(path: &str) -> bool {
    [".js", ".css", ".wasm"]
        .iter()
        .any(|ending| path.ends_with(ending))
}

/// With what the panel alone needs of the rest, as links to share.
fn is_of_panel(path: &str) -> bool {
    begins(path, &["panel", "parameters", "share", "wasm/hearth-panel"])
}

fn is_of_library(path: &str) -> bool {
    begins(path, &["sim.", "wasm/hearth-sim"])
}

/// Only a fire that shows a quantity loads its bar.
fn is_of_bar(path: &str) -> bool {
    begins(path, &["element/scale.", "generated/quantities."])
}

/// Only a fire whose values move, whose settings come from a file, that a pointer may stir,
/// that has a name that it does not know, or that no worker can draw loads these.
fn is_asked_for(path: &str) -> bool {
    begins(
        path,
        &[
            "element/transition.",
            "element/settings-file.",
            "element/spelling.",
            "element/pointer.",
            "engine/main-thread.",
        ],
    )
}

/// Pages are examples, and React's entry is the element again; who embeds the
/// element loads none of them.
fn is_of_page(path: &str) -> bool {
    begins(path, &["pages", "embed", "react"])
}

fn begins(path: &str, starts: &[&str]) -> bool {
    starts.iter().any(|start| path.starts_with(start))
}

/// Prints the sizes of the built site; fails where one is over its ceiling.
///
/// # Errors
/// No site, no Node, or a download that is too large.
pub fn check() -> Result<()> {
    tools::node()?;
    let web = paths::site().join("web");
    let files = files(&web).context("there is no built site; run `cargo xtask build` first")?;
    let mut too_large = Vec::new();
    for download in &DOWNLOADS {
        println!("{}", download.name);
        let (mut raw_sum, mut small_sum) = (0, 0);
        for file in &files {
            let name = file
                .strip_prefix(&web)
                .unwrap_or(file)
                .to_string_lossy()
                .replace('\\', "/");
            if !(download.holds)(&name) {
                continue;
            }
            let (raw, small) = (fs::metadata(file)?.len(), brotli(file)?);
            println!("  {name:<32}{raw:>12}{small:>12}");
            raw_sum += raw;
            small_sum += small;
        }
        println!(
            "  {:<32}{raw_sum:>12}{small_sum:>12} of at most {}",
            "bytes, and compressed", download.ceiling
        );
        if small_sum > download.ceiling {
            too_large.push(download.name);
        }
    }
    if !too_large.is_empty() {
        bail!("too large to download: {}", too_large.join(", "));
    }
    Ok(())
}

/// Every file under `folder`, in a steady order.
fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            found.extend(files(&entry.path())?);
        } else {
            found.push(entry.path());
        }
    }
    found.sort();
    Ok(found)
}

/// The size of `file` after brotli, which Node brings along.
fn brotli(file: &Path) -> Result<u64> {
    let script = "const { brotliCompressSync: pack } = require('zlib'); \
                  console.log(pack(require('fs').readFileSync(process.argv[1])).length)";
    let printed = process::output(process::command("node").args(["-e", script]).arg(file))?;
    printed
        .trim()
        .parse()
        .with_context(|| format!("Node says \"{}\" instead of a size", printed.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_downloaded_once() {
        let downloads = |path: &str| -> Vec<_> {
            let holding = DOWNLOADS.iter().filter(|download| (download.holds)(path));
            holding.map(|download| download.name).collect()
        };
        for path in [
            "hearth-fire.js",
            "generated/defaults.js",
            "wasm/hearth-engine_bg.wasm",
        ] {
            assert_eq!(downloads(path), ["element and engine"]);
        }
        for path in ["sim.js", "wasm/hearth-sim.js", "wasm/hearth-sim_bg.wasm"] {
            assert_eq!(downloads(path), ["headless library"]);
        }
        for path in ["element/scale.js", "generated/quantities.js"] {
            assert_eq!(downloads(path), ["bar of colours, on request"]);
        }
        for path in ["element/transition.js", "engine/main-thread.js"] {
            assert_eq!(downloads(path), ["element's rest, each on request"]);
        }
        for path in [
            "panel.js",
            "panel/scenes.js",
            "panel/panel.css",
            "parameters.js",
            "share.js",
            "wasm/hearth-panel.js",
        ] {
            assert_eq!(downloads(path), ["panel, on request"]);
        }
        for path in [
            "pages/main.js",
            "pages/main.css",
            "embed/main.js",
            "embed-client.js",
            "package.json",
            "parameters.d.ts",
            "sim.d.ts",
            "scenes/campfire.jpg",
        ] {
            assert!(downloads(path).is_empty());
        }
    }
}
