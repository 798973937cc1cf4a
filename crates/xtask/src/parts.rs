//! What wasm-bindgen makes of a module, without what no visitor needs, and with the parts that few
//! need apart.

use std::path::Path;

use anyhow::{Context, Result};
use hearth_core::preset::{PRESETS, Preset};
use wasm_parts::{Bound, Part};

use crate::shell::Shell;

/// The parts. `hearth_bindings::parts` tells when one is needed.
const PARTS: [Part; 9] = [
    Part {
        name: "classic",
        modules: &["hearth-engine", "hearth-sim"],
        symbols: &[
            "hearth_core::classic::",
            "<hearth_core::classic::",
            "<F as hearth_core::classic::",
            "core::ptr::drop_in_place<hearth_core::classic::",
        ],
        // Each calls the solver of the present model.
        callers: &["hearth_core::simulation::"],
        texts: Vec::new,
        is_loaded: "hearth_bindings::parts::classic_is_loaded",
    },
    Part {
        name: "outlines",
        modules: &["hearth-engine", "hearth-sim"],
        symbols: &[
            "hearth_core::scene::field::Field::",
            "hearth_core::scene::contour::",
            "hearth_core::scene::distance::Surface::sampled",
            "hearth_render::solids::append",
        ],
        // A surface that is not sampled has no field.
        callers: &[
            "hearth_core::scene::distance::",
            "hearth_core::solids::",
            "hearth_core::combustion::",
            "hearth_core::classic::",
            "hearth_core::simulation::",
            "hearth_engine::fire::frame::",
        ],
        texts: Vec::new,
        is_loaded: "hearth_core::scene::field::is_loaded",
    },
    Part {
        name: "fuels",
        modules: &["hearth-engine", "hearth-sim"],
        symbols: &[
            "hearth_core::combustion::fuels::",
            "<hearth_core::combustion::fuels::",
            "core::ptr::drop_in_place<alloc::boxed::Box<hearth_core::combustion::fuels::",
            "hearth_engine::engine::light",
            "hearth_render::solids::burnt",
        ],
        // A scene without fuel has none of them.
        callers: &[
            "hearth_core::combustion::",
            "hearth_core::simulation::",
            "core::ptr::drop_in_place<hearth_",
            "hearth_engine::",
            "<core::iter::adapters::map::Map<",
        ],
        texts: Vec::new,
        is_loaded: "hearth_bindings::parts::fuels_is_loaded",
    },
    Part {
        name: "bodies",
        modules: &["hearth-engine", "hearth-sim"],
        symbols: &[
            "hearth_core::solids::free::",
            "<hearth_core::solids::free::",
            "core::ptr::drop_in_place<alloc::boxed::Box<hearth_core::solids::free::",
        ],
        // A scene without a free solid has none of them.
        callers: &[
            "hearth_core::solids::",
            "hearth_core::combustion::",
            "hearth_core::simulation::",
            "core::ptr::drop_in_place<hearth_",
            "hearth_engine::",
            "hearth_sim::",
        ],
        texts: Vec::new,
        is_loaded: "hearth_bindings::parts::bodies_is_loaded",
    },
    Part {
        name: "solids",
        // Most pages with the element show a scene with solids.
        modules: &["hearth-sim"],
        symbols: &[
            "hearth_core::solids::Solids::gather",
            "hearth_core::solids::Solids::place_anew",
            "hearth_core::solids::thin::<impl hearth_core::solids::Solids>::any_between",
            "hearth_core::solids::thin::Lines::crossed",
            "hearth_core::combustion::walls::Walls::find_solids",
            "hearth_core::combustion::number_density::part",
            "hearth_core::combustion::settle::<impl hearth_core::combustion::Combustion>::push_out",
            "hearth_core::combustion::settle::<impl hearth_core::combustion::Combustion>::fill_around",
        ],
        // Where there are solids.
        callers: &[
            "hearth_core::combustion::",
            "<hearth_core::combustion::",
            "hearth_core::neighbourhood::",
            "hearth_core::simulation::",
            "hearth_core::solids::",
        ],
        texts: Vec::new,
        is_loaded: "hearth_bindings::parts::solids_are_loaded",
    },
    Part {
        name: "vorticity",
        modules: &["hearth-engine", "hearth-sim"],
        symbols: &["hearth_core::combustion::vorticity_confinement::VorticityConfinement::act"],
        // Of a confinement that is not 0.
        callers: &["hearth_core::combustion::"],
        texts: Vec::new,
        is_loaded: "hearth_bindings::parts::vorticity_is_loaded",
    },
    Part {
        name: "quantities",
        modules: &["hearth-engine"],
        symbols: &[
            "hearth_core::simulation::Simulation::write_measured",
            "hearth_render::scale::extremes",
        ],
        // Of a display mode that shows neither fire nor the paper's sprites.
        callers: &["hearth_core::simulation::", "hearth_engine::fire::"],
        texts: Vec::new,
        is_loaded: "hearth_bindings::parts::quantities_is_loaded",
    },
    Part {
        name: "burning",
        modules: &["hearth-engine"],
        symbols: &[
            "hearth_core::simulation::burning::<impl",
            "hearth_core::simulation::burning::format::",
        ],
        callers: &["hearth_engine::warm::"],
        texts: Vec::new,
        is_loaded: "hearth_bindings::parts::burning_is_loaded",
    },
    Part {
        name: "presets",
        modules: &["hearth-sim"],
        symbols: &[
            "hearth_core::preset::definition::",
            "<hearth_core::preset::definition::",
            "hearth_core::preset::resolution::",
        ],
        texts: || PRESETS.iter().map(Preset::text).collect(),
        callers: &["hearth_bindings::settings::document"],
        is_loaded: "hearth_bindings::parts::presets_are_loaded",
    },
];

/// Makes each wasm module and its glue smaller, and takes the parts out of those of the engine and the
/// library.
pub(crate) fn divide(sh: &Shell, web: &Path) -> Result<()> {
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
            for part in PARTS.iter().filter(|part| part.modules.contains(&name)) {
                let taken = bound
                    .take(part)
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
