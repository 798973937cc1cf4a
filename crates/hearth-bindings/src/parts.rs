//! Parts: code that a page loads when a scene first needs it.
//!
//! Cargo links a whole module. `cargo xtask build` takes the parts out of it and replaces each
//! function that returns whether a part is loaded. No function of a part is called for a scene
//! that [`missing`] names a part for.

use std::hint::black_box;

use hearth_core::Scene;
use hearth_core::params::Model;

/// The part that a scene needs and that is not loaded.
pub fn missing(scene: &Scene) -> Option<&'static str> {
    if scene.settings().model() == Model::Classic && !classic_is_loaded() {
        Some("classic")
    } else {
        scene.lacks_fields().then_some("outlines")
    }
}

/// Whether the part that reads saved fires is loaded. Nothing needs it: a fire without it warms up.
#[inline(never)]
pub fn burning_is_loaded() -> bool {
    black_box(2_u8) == 2
}

/// Whether the part with the classic model is loaded, as it is in a whole module.
#[inline(never)]
fn classic_is_loaded() -> bool {
    black_box(true)
}
