//! What a fire reports about itself: types and documentation from the engine's table.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use super::markdown::cell;
use crate::sections;
use table::{STATS, Stat};

/// The engine's table, without the engine: the first command on a new machine waits until
/// every dependency of `cargo xtask` is compiled.
#[path = "../../hearth-engine/src/stats.rs"]
mod table;

/// What the element adds to the engine's statistics.
const ENGINE: Stat = Stat {
    name: "engine",
    kind: "'worker' | 'main'",
    doc: "Where the engine runs: `worker` or `main`.",
};

fn all() -> impl Iterator<Item = &'static Stat> {
    STATS.iter().chain([&ENGINE])
}

/// The interface of `stats` in TypeScript.
pub(super) fn interface() -> String {
    let mut text = String::from(
        "\n/** What a fire reports about itself, about four times a second: see crates/hearth-engine/src/stats.rs. */\n\
         export interface HearthStats {\n",
    );
    for Stat { name, kind, doc } in all() {
        let _ = writeln!(text, "  /** {doc} */\n  {name}: {kind};");
    }
    text.push_str("}\n");
    text
}

/// `docs/element.md` with the list of statistics.
///
/// # Errors
/// The page, or its marks, are missing.
pub(super) fn page(checkout: &Path) -> Result<String> {
    let page = fs::read_to_string(checkout.join("docs/element.md"))?;
    let mut table = String::from("| field | |\n|---|---|\n");
    for Stat { name, doc, .. } in all() {
        let _ = writeln!(table, "| `{name}` | {} |", cell(doc));
    }
    sections::replaced(&page, "stats", &table).context("docs/element.md has no marks for stats")
}
