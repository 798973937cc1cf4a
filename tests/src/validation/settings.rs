//! Settings that state their resolution as a number of particles, in a closed domain and in open air:
//! the same frame, and a flame as high.

use hearth_core::params::{Edges, IN_DOMAIN, Input, Model};
use hearth_core::{Parameters, Scene, Simulation};

use super::boxes::run;
use super::{Case, Expected, Outcome, Pace, Row};
use crate::fires::source;

pub(super) const CASES: &[Case] = &[
    Case {
        name: "settings-scenes",
        pace: Pace::Long(350),
        run: || heights(&SCENES),
    },
    Case {
        name: "settings-links",
        pace: Pace::Long(450),
        run: || heights(&LINKS),
    },
];

/// Settings: their name, and the values that act on the gas.
type Settings = (&'static str, &'static str);

/// The scenes with the combustion model, as settings of a closed domain.
#[rustfmt::skip]
const SCENES: [Settings; 12] = [
    ("default", ""),
    ("bonfire-in-wind", "domain_width=2.8 domain_height=2 particles=4000 wind=1 turbulence=2 turbulence_scale=0.3 fuel_power=500 emission_speed=0.5 emission_noise=0.5 source_width=0.7 source_height=0.22 source_oxygen=0.5"),
    ("campfire", "domain_width=1.8 domain_height=1.8 turbulence=0.8 turbulence_scale=0.25 fuel_power=300 emission_speed=0.6 emission_noise=0.6 source_width=0.5 source_height=0.2 source_oxygen=0.5 soot_life=0.35"),
    ("candle", CANDLE),
    ("fireside", FIRESIDE),
    ("forge", "domain_width=2.8 domain_height=1.15 gas_expansion=0.5 buoyancy=0.5 fuel_power=200 emission_speed=0.1 emission_noise=0.8 source_width=1 source_height=0.18 source_oxygen=0.9 flame_rise=1700 burn_time=0.05 soot_life=0.8"),
    ("gas-burner", "domain_width=0.44 domain_height=0.5 kinematic_viscosity=0.005 diffusion=0.001 fuel_power=22 emission_speed=0.6 emission_noise=0 source_width=0.12 source_height=0.11 source_oxygen=0.75 flame_rise=1700 burn_time=0.03 radiative_cooling=2000 soot_life=0.1"),
    ("ghost-fire", "domain_width=1.1 domain_height=1.6 turbulence=1.5 turbulence_scale=0.3 fuel_power=220 source_width=0.3 source_height=0.2 source_oxygen=0.45 soot_life=0.5"),
    ("match", "domain_width=0.42 domain_height=0.5 kinematic_viscosity=0.005 eddy_viscosity=0.25 diffusion=0.0005 wind=0.06 fuel_power=15 emission_speed=0.15 emission_noise=0.8 source_width=0.06 source_height=0.14 source_oxygen=0.7 radiative_cooling=500 soot_life=0.8"),
    ("smoke-stack", "domain_width=1.6 domain_height=2.2 turbulence=1 fuel_power=150 source_width=0.25 source_height=0.2 source_oxygen=0.1 flame_rise=900 air_demand=1 radiative_cooling=1800 soot_life=2"),
    ("torch", TORCH),
    ("wall-of-fire", "domain_width=1.55 domain_height=0.6 gas_expansion=0.8 buoyancy=0.9 turbulence=2.5 turbulence_scale=0.15 fuel_power=340 emission_speed=0.4 emission_noise=0.6 source_width=1 source_height=0.03 source_temperature=900 source_oxygen=0.8 soot_life=0.4"),
];

const CANDLE: &str = "domain_width=0.42 domain_height=0.5 kinematic_viscosity=0.01 eddy_viscosity=0.3 diffusion=0.001 fuel_power=24 emission_speed=0.15 emission_noise=0 source_width=0.08 source_height=0.11 source_oxygen=0.5 radiative_cooling=700 soot_life=0.6";
const FIRESIDE: &str = "domain_width=1.6 domain_height=1.6 seam=0.03 particles=2000 turbulence=0.8 turbulence_scale=0.25 fuel_power=390 emission_speed=0.6 emission_noise=0.6 source_width=0.44 source_height=0.03 source_oxygen=0.5 soot_life=0.5";
const TORCH: &str = "domain_width=1 domain_height=1.3 turbulence=1.5 turbulence_scale=0.12 fuel_power=190 emission_speed=1.2 emission_noise=0.3 source_width=0.14 source_height=0.33 source_oxygen=0.6 soot_life=0.35";

/// Links of the kind that people have.
#[rustfmt::skip]
const LINKS: [Settings; 20] = [
    ("wind", "wind=1.5 turbulence=2"),
    ("gentle-wind", "wind=-0.4"),
    ("thin-seam", "seam=0.03"),
    ("coarse", "particles=1200"),
    ("few-particles", "particles=500"),
    ("fine", "particles=6000"),
    ("seed", "seed=7 turbulence=0"),
    ("wide", "domain_width=4 domain_height=2.4"),
    ("high", "domain_height=3"),
    ("small-fire", "fuel_power=60 source_width=0.2"),
    ("low-source", "source_height=0.02 fuel_power=150"),
    ("aside", "source_x=0.3 domain_width=2 fuel_power=120"),
    ("large", "fuel_power=600 source_width=1 domain_width=3 domain_height=4"),
    ("sooty", "soot_life=2 radiative_cooling=500"),
    ("restless", "turbulence=4 emission_noise=1"),
    ("light-gas", "gas_expansion=1 fuel_power=120"),
    ("weak-gravity", "gravity=3 fuel_power=100"),
    ("premixed", "source_oxygen=0.9 burn_time=0.05"),
    ("candle-low", "seam=0.1 source_height=0.05 domain_width=0.42 domain_height=0.5 kinematic_viscosity=0.01 eddy_viscosity=0.3 diffusion=0.001 fuel_power=24 emission_speed=0.15 emission_noise=0 source_width=0.08 source_oxygen=0.5 radiative_cooling=700 soot_life=0.6"),
    ("torch-high", "domain_width=1 domain_height=2.6 turbulence=1.5 turbulence_scale=0.12 fuel_power=190 emission_speed=1.2 emission_noise=0.3 source_width=0.14 source_height=0.33 source_oxygen=0.6 soot_life=0.35"),
];

/// Gas hotter than this is the flame \[K\].
const FLAME: f32 = 900.0;
/// Looks a second.
const RATE: f64 = 60.0;

/// Settings as a reader completes them, with these edges.
///
/// # Panics
/// If a value is invalid, because the settings are.
fn read(values: &str, edges: &str) -> Scene {
    let mut scene = Scene::of_model(Model::Combustion);
    let mut ids = Vec::new();
    for (id, value) in values.split(' ').filter_map(|pair| pair.split_once('=')) {
        let value = value.parse().unwrap_or(f64::NAN);
        set(&mut scene, id, Input::Number(value));
        ids.push(id);
    }
    set(&mut scene, "edges", Input::Text(edges));
    let mut world = scene.world().clone();
    world.complete(&|id| ids.contains(&id), IN_DOMAIN);
    scene.set_world(world);
    scene
}

fn set(scene: &mut Scene, id: &str, input: Input<'_>) {
    if let Err(refusal) = scene.set(id, input) {
        panic!("{refusal}");
    }
}

/// Mean height of the highest flame above the source from 4 s to 12 s, some ten puffs, in the part of the frame that
/// the seam of a closed domain leaves \[m\].
fn height(scene: Scene) -> f64 {
    let (base, [half, top]) = (f64::from(source(&scene).y), room(scene.world()));
    let mut fire = Simulation::new(scene);
    let (mut sum, mut looks) = (0.0, 0.0);
    for look in 0..=(8.0 * RATE) as u32 {
        if !run(&mut fire, 4.0 + f64::from(look) / RATE, Simulation::step) {
            return f64::NAN;
        }
        let places = fire.positions().into_iter().zip(fire.temperatures());
        let flame =
            places.filter(|&(at, kelvin)| kelvin > FLAME && at.x.abs() < half && at.y < top);
        let tip = flame.map(|(at, _)| f64::from(at.y)).fold(base, f64::max);
        (sum, looks) = (sum + tip - base, looks + 1.0);
    }
    sum / looks
}

/// Half the width, and the height, of the frame without the seam of a closed domain \[m\].
fn room(values: &Parameters) -> [f32; 2] {
    let sides = if values.wind == 0.0 { 0.0 } else { values.seam };
    [
        (0.5 - sides) * values.domain_width,
        (1.0 - values.seam) * values.domain_height,
    ]
}

fn heights(all: &[Settings]) -> Outcome {
    Outcome::rows(all.iter().map(|&(name, values)| {
        let [open, closed] = ["open", "periodic"].map(|edges| read(values, edges));
        let [open_edges, closed_edges] = [&open, &closed].map(|scene| scene.world().edges);
        assert!(open_edges == Edges::Open && closed_edges == Edges::Periodic);
        let frame = |scene: &Scene| (scene.world().domain_width, scene.world().domain_height);
        let same = frame(&open) == frame(&closed);
        let top = f64::from(room(closed.world())[1] - source(&closed).y);
        let [open, closed] = [open, closed].map(height);
        Row::new(
            format!("settings-{name}"),
            format!("{name}: height of the flame below the seam, in open air / in a closed domain"),
            Expected::Share {
                value: 1.0,
                tolerance: 0.15,
            },
            if same { open / closed } else { f64::NAN },
        )
        .noting(format!(
            "{open:.2} m for {closed:.2} m, {top:.2} m below the seam"
        ))
        .unlisted()
    }))
}
