//! Parts: code that a page loads when a scene first needs it.
//!
//! Cargo links a whole module. `cargo xtask build` takes the parts out of it and replaces each
//! function that returns whether a part is loaded. No function of a part is called for a scene
//! that [`missing`] names a part for.

use std::hint::black_box;

use hearth_core::Scene;
use hearth_core::params::{DisplayMode, Model};

/// The part that a scene needs and that is not loaded.
pub fn missing(scene: &Scene) -> Option<&'static str> {
    let settings = scene.settings();
    let measures = !matches!(
        settings.display_mode,
        DisplayMode::Fire | DisplayMode::Paper
    );
    if settings.model() == Model::Classic && !classic_is_loaded() {
        Some("classic")
    } else if measures && !quantities_is_loaded() {
        Some("quantities")
    } else if settings.model() == Model::Combustion
        && settings.vorticity_confinement > 0.0
        && !vorticity_is_loaded()
    {
        Some("vorticity")
    } else if scene.lacks_fields() {
        Some("outlines")
    } else if scene.has_fuel() && !fuels_is_loaded() {
        Some("fuels")
    } else {
        (scene.has_free() && !bodies_is_loaded()).then_some("bodies")
    }
}

/// Whether the part that confines vorticity is loaded.
#[inline(never)]
fn vorticity_is_loaded() -> bool {
    black_box(7_u8) == 7
}

/// Whether the part of the library that holds gas outside of solids is loaded.
#[inline(never)]
pub fn solids_are_loaded() -> bool {
    black_box(8_u8) == 8
}

/// Whether the part that moves free solids is loaded.
#[inline(never)]
fn bodies_is_loaded() -> bool {
    black_box(6_u8) == 6
}

/// Whether the part that sprays water is loaded.
#[inline(never)]
pub fn water_is_loaded() -> bool {
    black_box(9_u8) == 9
}

/// Whether the part that burns solids is loaded.
#[inline(never)]
pub fn fuels_is_loaded() -> bool {
    black_box(5_u8) == 5
}

/// Whether the part with the presets is loaded.
#[inline(never)]
pub fn presets_are_loaded() -> bool {
    black_box(4_u8) == 4
}

/// Whether the part that reads saved fires is loaded.
#[inline(never)]
pub fn burning_is_loaded() -> bool {
    black_box(2_u8) == 2
}

/// Whether the part that measures what display modes and probes show is loaded.
#[inline(never)]
pub fn quantities_is_loaded() -> bool {
    black_box(3_u8) == 3
}

/// Whether the part with the classic model is loaded, as it is in a whole module.
#[inline(never)]
fn classic_is_loaded() -> bool {
    black_box(true)
}
