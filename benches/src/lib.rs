//! Scenes whose steps are measured, the same natively and in wasm.
//!
//! A cost means nothing without its neighbours: every scene can say how many
//! particles it holds and how many neighbours each has, and both are printed
//! beside every figure.

use hearth_core::params::{Input, Model, Parameters};
use hearth_core::preset::Preset;
use hearth_core::{Particle, Simulation};
use wasm_bindgen::prelude::*;

/// Smoothing length of a block [m]: 100,000 particles still fit the domain.
const SMOOTHING: f64 = 0.02;

/// Neighbours that a particle inside a block has within 2h.
const NEIGHBOURS: f64 = 20.0;

/// Room around a block, in distances between its particles: it spreads a
/// little, and whoever left the domain would be missed.
const MARGIN: f64 = 6.0;

/// A fire to be measured.
#[wasm_bindgen]
#[derive(Clone)]
pub struct Scene {
    simulation: Simulation,
    start: Simulation,
}

#[wasm_bindgen]
impl Scene {
    /// The fire of a preset, burnt for three seconds so that it is whole;
    /// nothing if there is no such preset.
    pub fn preset(name: &str) -> Option<Scene> {
        let parameters = Preset::find(name)?.parameters();
        Some(Scene::burnt(parameters))
    }

    /// The combustion model as fine as a large picture deserves.
    pub fn fine() -> Scene {
        let mut parameters = Parameters::new(Model::Combustion);
        for (id, value) in [("max_particles", 6700.0), ("stiffness", 10.0)] {
            let set = parameters.set(id, Input::Number(value));
            debug_assert!(set.is_ok(), "{set:?}");
        }
        Scene::burnt(parameters)
    }

    /// A fire of the classic model with a wide source and far more particles.
    pub fn bonfire() -> Scene {
        Scene::burnt(with(&[
            ("max_particles", 20_000.0),
            ("emission_rate", 30_000.0),
            ("domain_width", 4.0),
            ("domain_height", 4.0),
            ("lifetime_min", 1.5),
            ("lifetime_max", 3.0),
            ("source_width", 0.6),
            ("particle_mass", 1e-4),
            ("smoothing_radius", 0.014),
        ]))
    }

    /// A block of `count` particles at rest, without a source and without
    /// gravity, with 20 neighbours a particle and steps that need no division:
    /// what a step of the classic model costs, as other solvers are measured.
    pub fn block(count: u32) -> Scene {
        let spacing = 2.0 * SMOOTHING * (std::f64::consts::PI / (NEIGHBOURS + 1.0)).sqrt();
        let columns = f64::from(count).sqrt().ceil();
        let side = (columns + 2.0 * MARGIN) * spacing;
        let mut simulation = Simulation::new(with(&[
            ("domain_width", side),
            ("domain_height", side),
            ("smoothing_radius", SMOOTHING),
            ("particle_mass", spacing * spacing),
            ("viscosity", 0.001),
            ("gravity", 0.0),
            ("time_step", 1.0 / 480.0),
            ("max_particles", 100.0),
        ]));
        let particles: Vec<Particle> = (0..count)
            .map(|i| at_rest(i, columns as u32, spacing as f32))
            .collect();
        let filled = simulation.set_particles(&particles);
        debug_assert!(filled.is_ok(), "{filled:?}");
        Scene::from(simulation)
    }

    /// Goes back to the start, so that every round measures the same steps.
    pub fn rewind(&mut self) {
        self.simulation = self.start.clone();
    }

    /// Burns on by `steps` steps.
    pub fn step(&mut self, steps: u32) {
        for _ in 0..steps {
            self.simulation.step();
        }
    }

    /// Steps in a frame of a 60 Hz display.
    #[wasm_bindgen(js_name = stepsPerFrame)]
    pub fn steps_per_frame(&self) -> f32 {
        (1.0 / 60.0 / self.simulation.step_length()) as f32
    }

    /// Particles alive.
    pub fn particles(&self) -> u32 {
        self.simulation.count() as u32
    }

    /// Neighbours of a particle within 2h, on average.
    pub fn neighbours(&self) -> f32 {
        self.simulation.report().mean_neighbours
    }

    /// Parts into which the last step was divided.
    pub fn substeps(&self) -> u32 {
        self.simulation.report().substeps
    }
}

impl Scene {
    fn burnt(parameters: Parameters) -> Scene {
        let mut simulation = Simulation::new(parameters);
        while simulation.time() < 3.0 {
            simulation.step();
        }
        Scene::from(simulation)
    }
}

impl From<Simulation> for Scene {
    fn from(mut simulation: Simulation) -> Scene {
        // One more step, so that there is a report and every buffer has grown.
        simulation.step();
        Scene {
            start: simulation.clone(),
            simulation,
        }
    }
}

/// The classic model's defaults with some values changed.
fn with(values: &[(&str, f64)]) -> Parameters {
    let mut parameters = Parameters::new(Model::Classic);
    for &(id, value) in values {
        let set = parameters.set(id, Input::Number(value));
        debug_assert!(set.is_ok(), "{set:?}");
    }
    parameters
}

/// One of a block's particles, slightly off its place on the lattice: on an
/// exact lattice, distances at the kernel's edge would make the count of
/// neighbours a matter of rounding.
fn at_rest(index: u32, columns: u32, spacing: f32) -> Particle {
    let jitter = |salt: u32| {
        let mixed = (index ^ salt).wrapping_mul(0x9e37_79b9);
        ((mixed ^ (mixed >> 15)) >> 8) as f32 / 16_777_216.0 - 0.5
    };
    let column = (index % columns) as f32 + 0.2 * jitter(0x51);
    let row = (index / columns) as f32 + MARGIN as f32 + 0.2 * jitter(0xa7);
    let half = 0.5 * (columns as f32 - 1.0);
    Particle {
        temperature: 1000.0,
        lifetime: 1e6,
        ..Particle::at([(column - half) * spacing, row * spacing].into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_has_the_neighbours_that_it_promises() {
        for count in [1000, 5000] {
            let mut scene = Scene::block(count);
            scene.step(100);
            assert_eq!(scene.particles(), count);
            let neighbours = scene.neighbours();
            assert!(
                (15.0..=25.0).contains(&neighbours),
                "{neighbours} neighbours"
            );
            assert_eq!(scene.substeps(), 1);
        }
    }

    #[test]
    fn a_bonfire_is_far_larger_than_the_default_fire() {
        let scene = Scene::bonfire();
        assert!(scene.particles() > 5000, "{} particles", scene.particles());
    }
}
