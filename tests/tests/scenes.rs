//! Every scene burns: it stays finite and inside, no guard holds it together, it
//! glows, and it is no more work than a fire on a page may be.
//!
//! This is its beginning; `cargo xtask soak` burns each for a minute.
#![cfg(not(target_arch = "wasm32"))]

use hearth_core::params::Model;
use hearth_core::preset::{PRESETS, Preset};
use hearth_core::{Parameters, Particle, Simulation};
use hearth_tests::sweep;

/// Time of the clock for which each burns here \[s\].
const SECONDS: f64 = 2.0;

/// Most work of a second of the clock, in that of the default scene.
const MOST_WORK: f64 = 2.0;

/// Least particles that glow, so that there is a flame to see.
const GLOWING: usize = 20;
/// Temperature from which on gas shines \[K\], and how much soot it takes.
const SHINES: f32 = 900.0;
const SOOT: f32 = 0.02;

fn scene(name: &str) -> Parameters {
    Preset::find(name).map_or_else(|| panic!("there is no scene {name}"), Preset::parameters)
}

#[test]
fn every_scene_burns_without_a_guard_glows_and_is_no_more_than_twice_the_work() {
    let mut usual = f64::INFINITY;
    // Of the default one, which is the first.
    for preset in PRESETS {
        let parameters = preset.parameters();
        let seconds = SECONDS * f64::from(parameters.time_scale);
        let has_soot = parameters.model() == Model::Combustion;
        let mut fire = Simulation::new(parameters);
        let fared = sweep::burn(&mut fire, seconds);
        assert_eq!(fared.fault(), None, "{}", preset.name);
        assert!(fared.held < 0.002, "{}: {}", preset.name, fared.held);
        let glows = |particle: &&Particle| {
            particle.temperature > SHINES && (particle.soot > SOOT || !has_soot)
        };
        let glowing = fire.particles().iter().filter(glows).count();
        assert!(glowing >= GLOWING, "{}: {glowing} glow", preset.name);
        if preset.name == "default" {
            usual = fared.work;
        }
        let times = fared.work / usual;
        assert!(times < MOST_WORK, "{}: {times:.2} times", preset.name);
    }
}

/// Mean distance of what glows from the middle, above and below half its height,
/// and that height \[m\].
fn shape(parameters: Parameters) -> (f32, f32) {
    let (mut width, mut height) = (0.0, 0.0);
    let mut fire = Simulation::new(parameters);
    for _ in 0..4 {
        assert_eq!(sweep::burn(&mut fire, 1.0).fault(), None);
        let particles = fire.particles();
        let count = particles.len() as f32;
        let source = fire.parameters().source_height;
        width += particles.iter().map(|p| p.position.x.abs()).sum::<f32>() / count;
        height += particles.iter().map(|p| p.position.y - source).sum::<f32>() / count;
    }
    (width, height)
}

/// Mean distance to the nearest other particle, in spacings of particles at rest.
fn gaps(parameters: Parameters) -> f32 {
    let rest = (parameters.particle_mass / parameters.rest_density).sqrt();
    let mut fire = Simulation::new(parameters);
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
fn the_papers_scenes_show_what_they_are_named_after() {
    let (width, height) = shape(scene("paper-fire"));
    let (narrow, tall) = shape(scene("paper-buoyancy"));
    assert!(narrow < 0.9 * width, "{narrow} {width}");
    assert!(tall > 1.2 * height, "{tall} {height}");
    let (wide, _) = shape(scene("paper-stiffness"));
    assert!(wide > 1.1 * width, "{wide} {width}");
    let (plain, clustered) = (gaps(scene("paper-fire")), gaps(scene("paper-smoothing")));
    assert!(clustered < 0.8 * plain, "{clustered} {plain}");
}
