//! The fires that pages open with: saved simulations in `web/burning`.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::Path;

use hearth_core::burning::BurningError;
use hearth_core::params::Input;
use hearth_core::preset::Preset;
use hearth_core::{Parameters, Simulation};

/// The scenes that are stored.
const STORED: [&str; 1] = ["fireside"];

/// Gas above this temperature shines \[K\].
const BRIGHT: f32 = 1000.0;

fn stored(name: &str) -> Vec<u8> {
    let file = format!("../web/burning/{name}.fire");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn values_of(name: &str) -> Parameters {
    Preset::find(name).map_or_else(|| panic!("there is no scene {name}"), Preset::parameters)
}

#[test]
fn a_stored_fire_of_other_values_is_refused() {
    for name in STORED {
        let bytes = stored(name);
        let mut values = values_of(name);
        let mut own = Simulation::new(values.clone());
        assert_eq!(own.restore_burning(&bytes), Ok(()), "{name}");
        values
            .set("fuel_power", Input::Number(123.0))
            .expect("a power");
        let refused = Simulation::new(values).restore_burning(&bytes);
        assert_eq!(refused, Err(BurningError::OtherValues));
    }
}

#[test]
fn a_stored_fire_is_tall_at_every_quality() {
    for name in STORED {
        let bytes = stored(name);
        for particles in [500, 1200, 3000, 6700] {
            let mut values = values_of(name);
            values.set_frame_particles(particles);
            let floor = hearth_core::Burner::of(&values).bottom;
            let height = values.domain_height;
            let mut fire = Simulation::new(values);
            let restored = fire.restore_burning(&bytes);
            assert_eq!(restored, Ok(()), "{name} at {particles}");
            assert!(
                fire.count() > particles as usize / 2,
                "{name}: {} of {particles}",
                fire.count()
            );
            let places = fire.positions().into_iter().zip(fire.temperatures());
            let bright = places.filter(|&(_, kelvin)| kelvin > BRIGHT);
            let top = bright.map(|(at, _)| at.y).fold(0.0, f32::max);
            assert!(
                top - floor > 0.25 * height,
                "{name} at {particles}: {top} m"
            );
        }
    }
}
