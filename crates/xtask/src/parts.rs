//! What wasm-bindgen makes of a module, as a page loads it: with the parts that few need apart.

use std::path::Path;

use anyhow::{Context, Result};
use wasm_parts::{Bound, Part};

use crate::shell::Shell;

/// The parts of the engine. `hearth_bindings::parts` determines which one a scene needs.
const PARTS: [Part; 5] = [
    Part {
        name: "classic",
        modules: &["hearth_core::classic::"],
    },
    Part {
        name: "bodies",
        modules: &[
            "hearth_core::combustion::fuels::",
            "hearth_core::combustion::water::",
            "hearth_core::solids::free::",
        ],
    },
    Part {
        name: "children",
        modules: &["hearth_settings::children::"],
    },
    Part {
        name: "sound",
        modules: &[
            "hearth_core::simulation::series::",
            "hearth_core::sound::",
            "hearth_engine::fire::sound::",
            "hearth_engine::sound::",
        ],
    },
    Part {
        name: "films",
        modules: &["hearth_core::looping::", "hearth_engine::fire::film::"],
    },
];

/// Takes the parts out of the wasm module of the engine, and orders the functions of all modules.
pub(crate) fn divide(sh: &Shell, web: &Path) -> Result<()> {
    for wasm in sh.read_dir(web.join("wasm"))? {
        let name = wasm.file_name().unwrap_or_default().to_string_lossy();
        let Some(name) = name.strip_suffix("_bg.wasm") else {
            continue;
        };
        let script = wasm.with_file_name(format!("{name}.js"));
        let (bytes, glue) = (sh.read_binary_file(&wasm)?, sh.read_file(&script)?);
        let mut bound = Bound::new(&bytes, glue, env!("CARGO_PKG_VERSION"))?;
        // The glue of the panel fetches its module.
        if name != "hearth-panel" {
            bound
                .let_caller_load()
                .with_context(|| format!("cannot change {}", script.display()))?;
        }
        if name == "hearth-engine" {
            for part in &PARTS {
                bound
                    .take(part)
                    .with_context(|| format!("cannot divide {name}"))?;
            }
        }
        let files = bound.finish()?;
        for (part, bytes) in files.parts {
            sh.write_file(wasm.with_file_name(format!("{name}_{part}.wasm")), bytes)?;
        }
        sh.write_file(&wasm, files.module)?;
        sh.write_file(script, files.glue)?;
    }
    Ok(())
}
