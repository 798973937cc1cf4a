//! What wasm-bindgen makes of a module, without what no visitor needs, and with the parts that few
//! need apart.

use std::path::Path;

use anyhow::{Context, Result};
use hearth_core::preset::{PRESETS, Preset};
use wasm_parts::{Bound, Part};

use crate::shell::Shell;

/// The parts. `hearth_bindings::parts` determines when one is needed.
const PARTS: &str = include_str!("parts.json");

/// A row of the table. The file also states for readers why functions call a part.
#[derive(serde::Deserialize)]
struct Row<'a> {
    name: &'a str,
    #[serde(borrow)]
    modules: Vec<&'a str>,
    symbols: Vec<&'a str>,
    callers: Vec<&'a str>,
    is_loaded: &'a str,
}

impl Row<'_> {
    fn part(&self, module: &str) -> Part<'_> {
        Part {
            name: self.name,
            symbols: &self.symbols,
            texts: match (self.name, module) {
                ("presets", _) => || PRESETS.iter().map(Preset::text).collect(),
                ("bodies", "hearth-engine") => || {
                    let all = PRESETS.iter().map(Preset::text);
                    all.filter(|text| text.contains("motion free")).collect()
                },
                _ => Vec::new,
            },
            callers: &self.callers,
            is_loaded: self.is_loaded,
        }
    }
}

/// Makes each wasm module and its glue smaller, and takes the parts out of those of the engine and the
/// library.
pub(crate) fn divide(sh: &Shell, web: &Path) -> Result<()> {
    let parts: Vec<Row> = serde_json::from_str(PARTS)?;
    for wasm in sh.read_dir(web.join("wasm"))? {
        let name = wasm.file_name().unwrap_or_default().to_string_lossy();
        let Some(name) = name.strip_suffix("_bg.wasm") else {
            continue;
        };
        let script = wasm.with_file_name(format!("{name}.js"));
        let (bytes, glue) = (sh.read_binary_file(&wasm)?, sh.read_file(&script)?);
        let mut bound = Bound::new(&bytes, glue, env!("CARGO_PKG_VERSION"))?;
        // The panel has futures, and its glue fetches its module.
        if name != "hearth-panel" {
            bound
                .remove_dead()
                .with_context(|| format!("cannot shorten {}", script.display()))?;
            for part in parts.iter().filter(|part| part.modules.contains(&name)) {
                let taken = bound
                    .take(&part.part(name))
                    .with_context(|| format!("cannot divide {name}"))?;
                let file = format!("{name}_{}.wasm", part.name);
                sh.write_file(wasm.with_file_name(file), taken)?;
            }
        }
        let (bytes, glue) = bound.finish()?;
        sh.write_file(&wasm, bytes)?;
        sh.write_file(script, glue)?;
    }
    Ok(())
}
