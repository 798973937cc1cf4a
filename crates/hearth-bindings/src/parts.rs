//! Parts of the wasm: code that a page loads when a scene first needs it.
//!
//! Cargo links a whole module, and `cargo xtask build` takes the parts out of it. No function of a part runs
//! for a scene that [`missing`] names the part for.

use hearth_core::Scene;
use hearth_core::params::Model;
use js_sys::Set;

/// The part with the classic model.
pub const CLASSIC: &str = "classic";
/// The part with solids that burn, water, and solids that are free to move.
pub const BODIES: &str = "bodies";
/// The part that lays children of the element over the objects.
pub const CHILDREN: &str = "children";
/// The part that makes samples.
pub const SOUND: &str = "sound";
/// The part that copies a fire.
pub const FILMS: &str = "films";

/// The part that a scene needs and that is not among the `loaded` ones.
pub fn missing(scene: &Scene, loaded: &Set) -> Option<&'static str> {
    let classic = scene.world().model() == Model::Classic;
    let bodies = scene.has_fuel() || scene.has_free();
    let needed = [(CLASSIC, classic), (BODIES, bodies)];
    let mut lacking = needed
        .into_iter()
        .filter(|&(part, is_needed)| is_needed && lacks(loaded, part));
    lacking.next().map(|(part, _)| part)
}

/// Whether a part is not among the `loaded` ones.
pub fn lacks(loaded: &Set, part: &str) -> bool {
    !loaded.has(&part.into())
}
