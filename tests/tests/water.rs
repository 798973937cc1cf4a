//! Laws of water that is sprayed: no water and no heat is lost, and a fire goes out because it is cooled
//! and wet.

mod fires;
mod gas;

use hearth_core::params::Input;
use hearth_core::{Scene, Simulation, SprayTotals, Vec2};
use hearth_tests::fires::{combustion, in_the_open, on_floor};

/// The id of the solid.
const ID: u32 = 2;

/// Open air on a floor without a source.
fn open(values: &[(&str, f64)]) -> Scene {
    let unlit = [("fuel_power", 0.0), ("ember_rate", 0.0)];
    let mut scene = on_floor(in_the_open(combustion(&[&unlit, values].concat()), 5000));
    assert_eq!(scene.set("spacing", 0.03), Ok(()));
    scene
}

/// A scene with a solid of these texts and numbers.
fn with_solid(mut scene: Scene, texts: &[(&str, &str)], numbers: &[(&str, f64)]) -> Scene {
    let mut fields = vec![("kind", Input::Text("solid"))];
    fields.extend(texts.iter().map(|&(name, text)| (name, Input::Text(text))));
    fields.extend(numbers.iter().map(|&(name, x)| (name, Input::Number(x))));
    assert_eq!(scene.add(&fields), Ok(ID));
    scene
}

/// A log of wood, 0.3 m × 0.1 m.
fn log(values: &[(&str, f64)]) -> Simulation {
    let texts = [("shape", "box"), ("fuel", "wood")];
    let numbers = [("y", 0.3), ("width", 0.3), ("height", 0.1), ("load", 8.0)];
    Simulation::new(with_solid(open(values), &texts, &numbers))
}

/// Where the water is.
fn sprayed(fire: &Simulation) -> SprayTotals {
    fire.sprayed().unwrap_or_default()
}

/// Sprays water for a time, so much in a second [kg/(m·s)], and calls `after_step` after each step.
fn spray(
    fire: &mut Simulation,
    [place, velocity]: [Vec2; 2],
    (rate, seconds): (f64, f64),
    mut after_step: impl FnMut(&Simulation),
) {
    const EVERY: f64 = 0.05;
    let (start, mut calls) = (fire.time(), 0.0);
    while fire.time() < start + seconds {
        if fire.time() >= start + EVERY * calls {
            let mass = (rate * EVERY) as f32;
            assert_eq!(fire.spray(place, velocity, mass), Ok(()));
            calls += 1.0;
        }
        fire.step();
        after_step(fire);
    }
}

/// Asserts that no water is lost.
#[track_caller]
fn assert_balanced(fire: &Simulation) {
    let all = sprayed(fire);
    let parts = [
        all.flying,
        all.evaporated,
        all.boiled,
        all.soaked,
        all.held,
        all.run_off,
    ];
    assert!(parts.iter().all(|part| *part >= 0.0), "{all:?}");
    let sum: f64 = parts.iter().sum();
    assert!((sum - all.sprayed).abs() <= 1e-4 * all.sprayed, "{all:?}");
}
