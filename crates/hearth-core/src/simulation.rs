//! A fire, step by step, whichever model burns it.
//!
//! Parameters go in by reference; nothing flows backward.
//! [`Classic`](crate::params::Model::Classic) and
//! [`Combustion`](crate::params::Model::Combustion) each say how they step.

pub mod burning;
mod model;
mod place;
mod readers;

use glam::Vec2;

use crate::forces::BodyForce;
use crate::instance::Instance;
use crate::neighbourhood;
use crate::params::{DisplayMode, Input, ParamError, Parameters};
use crate::particle::Particle;
use crate::random::Random;
use crate::scene::Scene;
use crate::solver::Solver;
use model::AnySolver;

pub use crate::particle::ParticleError;
pub use crate::report::{Stage, StepReport};

/// A fire.
///
/// The same parameters, seed and calls give the same bits, on every machine.
#[derive(Clone, Debug)]
pub struct Simulation {
    scene: Scene,
    solver: AnySolver,
    random: Random,
    time: f64,
}

impl Simulation {
    /// A scene whose sources are about to be lit. [`Parameters`] alone are a scene with
    /// one source.
    pub fn new(scene: impl Into<Scene>) -> Simulation {
        Simulation::of(scene.into())
    }

    fn of(scene: Scene) -> Simulation {
        let parameters = scene.settings();
        let mut random = Random::new(parameters.seed);
        Simulation {
            solver: AnySolver::new(parameters, &mut random),
            random,
            scene,
            time: 0.0,
        }
    }

    /// Burns on by one step: one [`time_step`](crate::params::Physics::time_step)
    /// in the classic model; in the combustion model as long as is stable, which
    /// [`report`](Simulation::report) and [`time`](Simulation::time) tell.
    pub fn step(&mut self) {
        self.step_in_stages(None, &mut |_| ());
    }

    /// As [`step`](Simulation::step), with a force of your own: a closure that
    /// gives the acceleration [m/s²] at a position \[m\] and velocity [m/s].
    pub fn step_with(&mut self, force: impl Fn(Vec2, Vec2) -> Vec2) {
        self.step_in_stages(Some(&force), &mut |_| ());
    }

    /// As [`step`](Simulation::step), with any [`BodyForce`] besides the model's own; calls
    /// `on_stage` at the end of each stage, several times for the substeps of the classic
    /// model. The core itself never reads a clock.
    pub fn step_in_stages(
        &mut self,
        force: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) {
        let (scene, random) = (&self.scene, &mut self.random);
        let solver = &mut self.solver;
        self.time += solver.step(scene, random, self.time, force, on_stage);
    }

    /// Starts again: as at first, time zero, the generator at its seed.
    pub fn reset(&mut self) {
        self.random = Random::new(self.scene.settings().seed);
        self.solver = AnySolver::new(self.scene.settings(), &mut self.random);
        self.time = 0.0;
    }

    /// The settings that it burns by.
    pub fn parameters(&self) -> &Parameters {
        self.scene.settings()
    }

    /// The settings and the objects that it burns with.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Sets one parameter while it burns, or says why not and changes nothing.
    /// A new seed or another model starts the fire again.
    ///
    /// # Errors
    /// An unknown id, a value of the wrong kind or one outside the range.
    pub fn set(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let mut parameters = self.scene.settings().clone();
        parameters.set(id, input)?;
        self.set_parameters(parameters);
        Ok(())
    }

    /// Sets all parameters while it burns; the objects beyond the first source stay. A
    /// new seed or another model starts the fire again.
    pub fn set_parameters(&mut self, parameters: Parameters) {
        let mut scene = self.scene.clone();
        scene.set_settings(parameters);
        self.set_scene(scene);
    }

    /// Sets all parameters and objects while it burns. A new seed or another model
    /// starts the fire again.
    pub fn set_scene(&mut self, scene: Scene) {
        let reseeded = scene.settings().seed != self.parameters().seed;
        self.scene = scene;
        if reseeded || self.parameters().model() != self.solver.model() {
            self.reset();
        }
        self.solver.adapt(self.scene.settings(), &mut self.random);
    }

    /// Simulated time since the start \[s\].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Length of a step \[s\]: of the last one where the state decides.
    pub fn step_length(&self) -> f64 {
        self.solver.step_length(&self.scene)
    }

    /// Number of particles alive.
    pub fn count(&self) -> usize {
        self.solver.count()
    }

    /// What the last step did. It counts the neighbours again, which takes about
    /// as long as finding them.
    pub fn report(&self) -> StepReport {
        self.solver.report(self.scene.settings())
    }

    /// Speed of sound in the gas [m/s], which is numerical and far below that
    /// of air: the square root of the gas constant, or c₀.
    pub fn sound_speed(&self) -> f32 {
        self.solver.sound_speed(&self.scene)
    }

    /// Copies out what the renderer needs, in no particular order: of a fire in the
    /// combustion model only what can be seen, in every other
    /// [`DisplayMode`] all particles.
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.clear();
        match self.scene.settings().display_mode {
            DisplayMode::Fire | DisplayMode::Paper => self.solver.write_fire(out),
            mode => self.write_measured(mode, out),
        }
    }

    fn write_measured(&self, mode: DisplayMode, out: &mut Vec<Instance>) {
        let (solver, values) = (&self.solver, self.scene.settings());
        let measured = (0..solver.count()).map(|i| solver.measured(i, values, mode));
        out.extend(measured.map(Instance::from));
        let vorticity = mode == DisplayMode::Vorticity;
        if vorticity || mode == DisplayMode::Neighbours {
            let h = values.smoothing_length();
            neighbourhood::measure(out, &solver.bounds(values), h, vorticity);
        }
    }

    /// Copies out the embers for the renderer; the classic model has none.
    pub fn write_embers(&self, out: &mut Vec<Instance>) {
        out.clear();
        if let Some(combustion) = self.solver.combustion() {
            combustion.write_embers(out);
        }
    }

    /// Throws so many embers from a place \[m\] inside the domain; no more than 4000 fly
    /// at one time. Their sizes and lives are those of the others. Outside, and in the
    /// classic model, which has no embers, it does nothing.
    pub fn throw_embers(&mut self, place: Vec2, count: u32) {
        if let Some(combustion) = self.solver.combustion_mut() {
            combustion.throw_embers(place, count, self.scene.settings(), &mut self.random);
        }
    }

    /// Puts these particles in the place of all that there are. Their order is
    /// the order in which they are read out again. In the classic model, the
    /// source goes on as long as their number is below `max_particles`. In the
    /// combustion model they fill the domain, each with the same share of the
    /// mass of its air.
    ///
    /// # Errors
    /// More than 400,000 particles in the classic model, fewer than half of
    /// `max_particles` or more than twice as many in the combustion model, whose
    /// smoothing length goes with it; or a particle outside the domain, faster
    /// than 1000 m/s, not from 1 to 100,000 K, without a lifetime, or with fuel or
    /// oxygen that are not from 0 to 1 or soot that is not from 0 to 10. Nothing
    /// changes then.
    pub fn set_particles(&mut self, particles: &[Particle]) -> Result<(), ParticleError> {
        let solver = &mut self.solver;
        if let Some(what) = solver.refuse_count(particles.len(), self.scene.settings()) {
            return Err(ParticleError { index: None, what });
        }
        let bounds = solver.bounds(self.scene.settings());
        for (index, particle) in particles.iter().enumerate() {
            if let Some(what) = particle.fault(&bounds) {
                return Err(ParticleError {
                    index: Some(index),
                    what,
                });
            }
        }
        solver.set_particles(particles, self.scene.settings());
        Ok(())
    }
}
