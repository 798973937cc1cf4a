//! Which fires are kept, and how each has burnt.

use std::collections::BTreeMap;

use hearth_core::Simulation;
use hearth_core::params::{Input, Kind, Model, Param};
use hearth_core::preset::Preset;

use crate::snapshot::Snapshot;

/// Most particles in the frame of the combustion model: as many as on most machines.
const PARTICLES: u32 = 3000;
/// The same where every display mode is kept: some draw all of them.
const PARTICLES_OF_MODES: u32 = 1000;
/// How long a fire has burnt when it is kept \[s\].
const BURNT: f64 = 5.0;

/// Every fire that is kept: one of each preset, and one of each model with what
/// every display mode shows of it.
///
/// # Errors
/// A value that the table refuses.
pub fn all() -> Result<BTreeMap<String, Snapshot>, String> {
    let mut kept = BTreeMap::new();
    for preset in Preset::all() {
        kept.insert(preset.name.to_owned(), snapshot(preset, PARTICLES, &[])?);
    }
    for preset in ["default", "classic"].into_iter().filter_map(Preset::find) {
        let name = format!("modes-{}", preset.parameters().model().name());
        kept.insert(name, snapshot(preset, PARTICLES_OF_MODES, &modes())?);
    }
    Ok(kept)
}

/// The names of the display modes, without that of the distance: the kept fires have no solids, and
/// the scale of a quantity that is the same everywhere has no colours to compare.
fn modes() -> Vec<&'static str> {
    let names = match Param::find("display_mode").map(|param| param.kind) {
        Some(Kind::Choice(names)) => names,
        _ => &[],
    };
    let compared = names.iter().filter(|&&name| name != "distance");
    compared.copied().collect()
}

/// The fire of a preset, with what these display modes draw of it, or with what
/// its own one does.
fn snapshot(preset: &Preset, most: u32, modes: &[&'static str]) -> Result<Snapshot, String> {
    let mut scene = preset.scene();
    let mut parameters = scene.settings().clone();
    let own = [parameters.display_mode.name()];
    if parameters.model() == Model::Combustion && parameters.domain_particles() > most {
        parameters.set_domain_particles(most);
        scene.set_settings(parameters);
    }
    let mut fire = Simulation::new(scene);
    while fire.time() < BURNT {
        fire.step();
    }
    let mut snapshot = Snapshot::of(&fire);
    for mode in if modes.is_empty() { &own } else { modes } {
        let set = fire.set("display_mode", Input::Text(mode));
        set.map_err(|refusal| refusal.to_string())?;
        snapshot.keep(mode, &fire);
    }
    Ok(snapshot)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_and_every_mode_of_each_model_has_a_snapshot() -> Result<(), String> {
        // As few steps as that needs: the table of what is kept, not its fires.
        assert!(modes().contains(&"fire") && modes().contains(&"paper"));
        let classic = Preset::find("classic").ok_or("no classic preset")?;
        let kept = snapshot(classic, PARTICLES, &modes())?;
        assert_eq!(kept.names().collect::<Vec<_>>(), modes());
        Ok(())
    }
}
