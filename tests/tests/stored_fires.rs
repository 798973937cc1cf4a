//! The fires that pages open with: saved simulations in `web/prewarmed`.

use std::fs;
use std::path::Path;

use hearth_core::burning::BurningError;
use hearth_core::preset::Preset;
use hearth_core::{Scene, Simulation};
use hearth_tests::fires::{source, with_first_source};

/// The scenes that are stored.
const STORED: [&str; 1] = ["fireside"];

/// Gas above this temperature shines \[K\].
const BRIGHT: f32 = 1000.0;

fn stored(name: &str) -> Vec<u8> {
    let file = format!("../web/prewarmed/{name}.fire");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn scene_of(name: &str) -> Scene {
    Preset::find(name).map_or_else(|error| panic!("{error}"), Preset::scene)
}

/// The scene with this number of particles.
fn resampled(name: &str, particles: u32) -> Scene {
    let mut scene = scene_of(name);
    let mut world = scene.world().clone();
    world.set_domain_particles(particles);
    scene.set_world(world);
    scene
}

#[test]
fn a_stored_fire_of_other_values_is_refused() {
    for name in STORED {
        let bytes = stored(name);
        let mut own = Simulation::new(scene_of(name));
        assert_eq!(own.restore_burning(&bytes), Ok(()), "{name}");
        let mut other = scene_of(name);
        assert_eq!(other.set("fuel_power", 123.0), Ok(()));
        let without_solids = with_first_source(scene_of(name));
        for other in [other, without_solids] {
            let refused = Simulation::new(other).restore_burning(&bytes);
            assert_eq!(refused, Err(BurningError::OtherValues));
        }
    }
}

#[test]
fn a_stored_fire_is_tall_at_every_quality() {
    for name in STORED {
        let bytes = stored(name);
        for particles in [500, 1200, 3000, 6700] {
            let scene = resampled(name, particles);
            let floor = hearth_core::Burner::of(&source(&scene)).bottom;
            let height = scene.world().domain_height;
            let mut fire = Simulation::new(scene);
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
