//! Every scene stays finite and inside without clamping, glows, and is cheap enough for a page.
//!
//! The tests run its first seconds; `cargo measure soak` runs each scene for a minute.

use std::fs;
use std::path::Path;

use hearth_core::params::{Input, Model};
use hearth_core::preset::Preset;
use hearth_core::{Particle, Scene, Simulation};
use hearth_settings::Settings;
use hearth_settings::untrusted::Untrusted;
use hearth_tests::fires::{source, with_first_source};
use hearth_tests::sweep;
use serde_json::Value;

/// Time of the clock for each scene \[s\].
const SECONDS: f64 = 2.0;

/// Most work per second of the clock, relative to the default scene. The dearest scene, the burning word,
/// takes 2.1: its power raises the speed of sound, so its steps are shorter.
const MAX_WORK: f64 = 2.2;

/// Minimum number of glowing particles, for a visible flame.
const GLOWING: usize = 20;
/// Minimum temperature \[K\] and soot of glowing gas.
const SHINES: f32 = 900.0;
const SOOT: f32 = 0.02;
/// Minimum rate of burning of blue gas [1/s].
const BLUE: f32 = 0.3;

fn scene(name: &str) -> Scene {
    Preset::find(name).map_or_else(|error| panic!("{error}"), Preset::scene)
}

/// Otherwise the panel would show a scene as changed that nobody has changed.
#[test]
fn a_fire_of_each_scene_has_the_number_of_particles_that_the_scene_states() {
    for preset in Preset::all() {
        let stated = preset.values().find(|(id, _)| *id == "particles");
        if let Some((_, Input::Number(stated))) = stated {
            let fire = Simulation::new(preset.scene());
            assert_eq!(
                fire.scene().world().particles as f64,
                stated,
                "{}",
                preset.name
            );
        }
    }
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn every_scene_glows_is_stable_and_costs_little_more_than_twice_the_default() {
    let mut default_work = f64::INFINITY;
    // The default scene is the first.
    for preset in Preset::all() {
        let scene = with_first_source(preset.scene());
        let seconds = SECONDS * f64::from(scene.world().time_scale);
        let has_soot = scene.model() == Model::Combustion;
        let mut fire = Simulation::new(scene);
        let outcome = sweep::burn(&mut fire, seconds);
        assert_eq!(outcome.fault(), None, "{}", preset.name);
        assert!(
            outcome.clamped < 0.002,
            "{}: {}",
            preset.name,
            outcome.clamped
        );
        let glows = |particle: &Particle| {
            particle.temperature > SHINES && (particle.soot > SOOT || !has_soot)
        };
        // Gas that burns without soot is blue.
        let burns = fire.burn_rates().unwrap_or_default();
        let blue = burns.iter().filter(|&&rate| rate > BLUE).count();
        let glowing = fire
            .particles()
            .iter()
            .filter(|particle| glows(particle))
            .count()
            + blue;
        assert!(glowing >= GLOWING, "{}: {glowing} glow", preset.name);
        if preset.name == "default" {
            default_work = outcome.work;
        }
        let times = outcome.work / default_work;
        assert!(times < MAX_WORK, "{}: {times:.2} times", preset.name);
    }
}

/// Mean distance of the particles from the middle, and their mean height above the source
/// \[m\].
fn shape(scene: Scene) -> (f32, f32) {
    let (mut width, mut height) = (0.0, 0.0);
    let mut fire = Simulation::new(scene);
    for _ in 0..4 {
        assert_eq!(sweep::burn(&mut fire, 1.0).fault(), None);
        let particles = fire.particles();
        let count = particles.len() as f32;
        let source = source(fire.scene()).y;
        width += particles.iter().map(|p| p.position.x.abs()).sum::<f32>() / count;
        height += particles.iter().map(|p| p.position.y - source).sum::<f32>() / count;
    }
    (width, height)
}

/// Mean distance to the nearest other particle, in spacings of particles at rest.
fn gaps(scene: Scene) -> f32 {
    let mut fire = Simulation::new(scene);
    let world = fire.parameters();
    let rest = (world.particle_mass / world.rest_density).sqrt();
    assert_eq!(sweep::burn(&mut fire, 3.0).fault(), None);
    let places = fire.positions();
    let nearest = places.iter().enumerate().map(|(i, a)| {
        let others = places.iter().enumerate().filter(|(j, _)| *j != i);
        let distances = others.map(|(_, b)| a.distance(*b));
        distances.fold(f32::INFINITY, f32::min)
    });
    nearest.sum::<f32>() / places.len() as f32 / rest
}

#[test]
fn the_papers_scenes_show_the_effect_of_their_parameter() {
    let (width, height) = shape(scene("paper-fire"));
    let (narrow, tall) = shape(scene("paper-buoyancy"));
    assert!(narrow < 0.9 * width, "{narrow} {width}");
    assert!(tall > 1.2 * height, "{tall} {height}");
    let (wide, _) = shape(scene("paper-stiffness"));
    assert!(wide > 1.1 * width, "{wide} {width}");
    let (plain, clustered) = (gaps(scene("paper-fire")), gaps(scene("paper-smoothing")));
    assert!(clustered < 0.8 * plain, "{clustered} {plain}");
}

#[test]
fn the_viscosity_of_the_paper_widens_the_fire_as_printed_and_narrows_it_corrected() {
    let (width, _) = shape(scene("paper-fire"));
    let mut viscous = scene("paper-viscosity");
    let (printed, _) = shape(viscous.clone());
    assert!(printed > 1.4 * width, "{printed} {width}");
    let set = viscous.set("printed_viscosity", false);
    assert_eq!(set, Ok(()));
    let (corrected, _) = shape(viscous);
    assert!(corrected < 0.9 * width, "{corrected} {width}");
}

/// Plain data as JavaScript sends it.
fn untrusted(value: &Value) -> Untrusted {
    match value {
        Value::Null => Untrusted::Missing,
        Value::Bool(on) => Untrusted::Flag(*on),
        Value::Number(number) => Untrusted::Number(number.as_f64().unwrap_or(f64::NAN)),
        Value::String(text) => Untrusted::Text(text.clone()),
        Value::Array(list) => Untrusted::List(list.iter().map(untrusted).collect()),
        Value::Object(fields) => Untrusted::Object(
            fields
                .iter()
                .map(|(name, value)| (name.clone(), untrusted(value)))
                .collect(),
        ),
    }
}

/// The settings of a file.
fn read(file: &Value) -> Settings {
    Settings::of_file(&untrusted(file)).unwrap_or_else(|errors| panic!("{errors:?}"))
}

#[test]
fn every_scene_file_is_its_preset() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    for preset in Preset::all() {
        let text = fs::read_to_string(folder.join(format!("{}.json", preset.name)));
        let file: Value = serde_json::from_str(&text.expect("a file")).expect("JSON");
        assert_eq!(file["hearth"], 3, "{}", preset.name);
        assert_eq!(
            read(&file).scene(),
            Settings::starting_from(preset).scene(),
            "{}",
            preset.name
        );
    }
}
