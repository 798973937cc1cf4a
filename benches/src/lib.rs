//! Scenes whose steps are measured, the same natively and in wasm.
//!
//! The cost of a step depends on the numbers of particles and neighbours. Every scene reports
//! both, and the benchmarks print them beside every figure.

pub mod peak;
pub mod scenes;

use hearth_core::{Simulation, Vec2};
use wasm_bindgen::prelude::*;

/// A measured fire, and the initial state of every round.
#[wasm_bindgen]
#[derive(Clone)]
pub struct Scene {
    simulation: Simulation,
    start: Simulation,
}

#[wasm_bindgen]
impl Scene {
    /// A block of the classic model, see [`scenes::block`].
    ///
    /// # Errors
    /// A number of particles out of range.
    pub fn block(count: u32, neighbours: f64) -> Result<Scene, String> {
        scenes::block(count, neighbours).map(Scene::from)
    }

    /// A fire of the classic model, see [`scenes::plume`].
    ///
    /// # Errors
    /// A number of particles out of range.
    pub fn plume(count: u32) -> Result<Scene, String> {
        scenes::plume(count).map(Scene::from)
    }

    /// A fire of the combustion model, see [`scenes::combustion`].
    ///
    /// # Errors
    /// A value outside its range.
    pub fn combustion(particles: u32, stiffness: f64) -> Result<Scene, String> {
        scenes::combustion(particles, stiffness).map(Scene::from)
    }

    /// Returns to the initial state, so that every round measures the same steps.
    pub fn rewind(&mut self) {
        self.simulation.clone_from(&self.start);
    }

    /// Makes `steps` steps.
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

    /// Substeps of the last step.
    pub fn substeps(&self) -> u32 {
        self.simulation.report().substeps
    }

    /// Positions, x and y of each particle \[m\].
    pub fn positions(&self) -> Vec<f32> {
        flat(&self.simulation.positions())
    }

    /// Their velocities, x and y of each [m/s].
    pub fn velocities(&self) -> Vec<f32> {
        flat(&self.simulation.velocities())
    }

    /// Their densities [kg/m³] as the last step found them.
    pub fn densities(&self) -> Vec<f32> {
        self.simulation.densities()
    }
}

impl From<Simulation> for Scene {
    fn from(simulation: Simulation) -> Scene {
        Scene {
            start: simulation.clone(),
            simulation,
        }
    }
}

fn flat(vectors: &[Vec2]) -> Vec<f32> {
    vectors.iter().flat_map(|v| [v.x, v.y]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_has_the_neighbours_that_it_promises() {
        for (count, neighbours) in [(1000, 20.0), (5000, 20.0), (5000, 28.0)] {
            let mut scene = Scene::block(count, neighbours).expect("a block");
            scene.step(100);
            assert_eq!(scene.particles(), count);
            let share = f64::from(scene.neighbours()) / neighbours;
            assert!((0.75..=1.25).contains(&share), "{share} of {neighbours}");
            assert_eq!(scene.substeps(), 1);
        }
    }

    #[test]
    fn a_scene_goes_back_to_where_it_began() {
        let mut scene = Scene::block(1000, scenes::NEIGHBOURS).expect("a block");
        let at_first = (scene.positions(), scene.velocities());
        scene.step(20);
        assert_ne!((scene.positions(), scene.velocities()), at_first);
        scene.rewind();
        assert_eq!((scene.positions(), scene.velocities()), at_first);
    }

    #[test]
    fn a_plume_is_as_large_as_it_may_be() {
        let scene = Scene::plume(5000).expect("a plume");
        let particles = scene.particles();
        assert!((4000..=5000).contains(&particles), "{particles} particles");
    }

    #[test]
    fn a_fire_fills_its_domain_with_the_particles_that_it_asks_for() {
        for asked in [1500, 6700] {
            let particles = Scene::combustion(asked, 6.0).expect("a fire").particles();
            let share = f64::from(particles) / f64::from(asked);
            assert!((0.7..1.4).contains(&share), "{particles} of {asked}");
        }
    }

    #[test]
    fn a_refusal_names_the_parameter() {
        let refusal = Scene::combustion(10, 6.0).err();
        assert!(refusal.is_some_and(|text| text.contains("particles")));
    }
}

/// Makes the steps of a case of [`scenes::IN_WASM`], or no step. Returns over how many particles they went; 0 without such
/// a case.
#[wasm_bindgen]
pub fn counted(case: u32, steps: bool) -> u32 {
    let name = scenes::IN_WASM.get(case as usize).copied();
    let case = scenes::counted(name.unwrap_or_default());
    case.map_or(0, |(mut simulation, count)| {
        scenes::measured(&mut simulation, if steps { count } else { 0 }) as u32
    })
}
