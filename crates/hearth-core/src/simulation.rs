//! A fire, step by step, in either model: [`Classic`](crate::params::Model::Classic) or
//! [`Combustion`](crate::params::Model::Combustion).

pub mod burning;
mod fuels;
mod measure;
mod model;
mod place;
mod readers;
mod series;
mod state;
mod water;

use glam::Vec2;

use crate::combustion::Seen;
use crate::extremes::fast_min;
use crate::forces::BodyForce;
use crate::instance::Instance;
use crate::neighbourhood;
use crate::params::{DisplayMode, Edges, Floor, Input, Model, ParamError, Parameters, Walls};
use crate::particle::Particle;
use crate::random::Random;
use crate::scene::{Pose, Scene};
use crate::series::Recorder;
use crate::time_step::SHORTEST;
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
    /// The part of the world that is seen.
    seen: Option<Seen>,
    /// The steps that wait for a reader, if they are recorded.
    recorder: Option<Box<Recorder>>,
}

impl Simulation {
    /// A fire of a scene, at time zero. [`Parameters`] alone are the world of a scene with one source.
    pub fn new(scene: impl Into<Scene>) -> Simulation {
        Simulation::of(scene.into())
    }

    fn of(scene: Scene) -> Simulation {
        let mut random = Random::new(scene.world().seed);
        Simulation {
            solver: AnySolver::new(&scene, &mut random),
            random,
            scene,
            time: 0.0,
            seen: None,
            recorder: None,
        }
    }

    /// Makes one step. Its length is [`time_step`](crate::params::Physics::time_step) in the
    /// classic model, and the longest stable one in the combustion model
    /// ([`step_length`](Simulation::step_length)). A classic step with too many pairs of
    /// particles is shorter, so that the work of every step is bounded.
    pub fn step(&mut self) {
        self.step_in_stages(None, &mut |_| ());
    }

    /// Makes one [`step`](Simulation::step) with an additional force: a closure that returns the
    /// acceleration [m/s²] at a position \[m\] and velocity [m/s].
    pub fn step_with(&mut self, force: impl Fn(Vec2, Vec2) -> Vec2) {
        self.step_in_stages(Some(&force), &mut |_| ());
    }

    /// Makes one [`step`](Simulation::step) with an additional [`BodyForce`], and calls `on_stage`
    /// at the end of each stage, in every substep of the classic model. A caller can so measure
    /// the stages; the core reads no clock.
    pub fn step_in_stages(
        &mut self,
        force: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) {
        self.step_towards(f64::INFINITY, force, on_stage);
    }

    /// Makes steps until this number of seconds has passed: [`time`](Simulation::time) is then exactly the time
    /// before plus `seconds`, because the last two steps are shorter where that is needed. A number that is not
    /// above zero makes none.
    ///
    /// ```
    /// # use hearth_core as hearth_fire;
    /// let mut fire = hearth_fire::Simulation::new(hearth_fire::Parameters::default());
    /// for frame in 1..=3 {
    ///     fire.advance(1.0 / 30.0);
    ///     assert!((fire.time() - f64::from(frame) / 30.0).abs() < 1e-12);
    /// }
    /// ```
    pub fn advance(&mut self, seconds: f64) {
        let end = self.time + seconds;
        while self.time < end {
            self.step_towards(end, None, &mut |_| ());
        }
    }

    /// Makes one step as [`step_in_stages`](Simulation::step_in_stages) does, which is so short that one of the
    /// next steps towards `end` \[s\] ends exactly there. [`advance`](Simulation::advance) makes such steps.
    pub fn step_towards(
        &mut self,
        end: f64,
        force: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) {
        let left = end - self.time;
        if left < SHORTEST {
            self.time = self.time.max(end);
            return;
        }
        let (scene, random) = (&self.scene, &mut self.random);
        let times = (self.time, left);
        let length = self.solver.step(scene, random, times, force, on_stage);
        self.time = if length < f64::from(left as f32) {
            self.time + length
        } else {
            end
        };
        if self.recorder.is_some() {
            self.record(length);
        }
    }

    /// Starts again: time zero, the generator at its seed.
    pub fn reset(&mut self) {
        self.random = Random::new(self.scene.world().seed);
        self.solver = AnySolver::new(&self.scene, &mut self.random);
        self.time = 0.0;
        self.set_visible_area(self.seen);
    }

    /// Becomes a new fire of a scene, which is [recorded](Simulation::record_series) if this one is.
    pub fn begin(&mut self, scene: impl Into<Scene>) {
        let recorder = self.recorder.take();
        *self = Simulation {
            recorder,
            ..Simulation::new(scene)
        };
    }

    /// Sets which part of the world is seen, by its lower left and upper right corner \[m\];
    /// `None`: the domain alone. With open edges there is gas up to a margin beyond the domain and
    /// beyond what is seen, as far as 4 heights of the domain. A change keeps every particle; gas
    /// beyond a smaller part is removed with the next steps.
    pub fn set_visible_area(&mut self, seen: Option<[Vec2; 2]>) {
        self.seen = seen;
        if let Some(combustion) = self.solver.combustion_mut() {
            combustion.set_visible_area(seen, &self.scene);
        }
    }

    /// The values of the world.
    pub fn parameters(&self) -> &Parameters {
        self.scene.world()
    }

    /// The world and the objects.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Sets one parameter of the burning fire, or returns an error and changes nothing. A new
    /// seed or another model starts the fire again.
    ///
    /// # Errors
    /// Those of [`Scene::set`].
    pub fn set<'a>(&mut self, id: &str, input: impl Into<Input<'a>>) -> Result<(), ParamError> {
        let mut scene = self.scene.clone();
        scene.set(id, input)?;
        self.set_scene(scene);
        Ok(())
    }

    /// Sets the world and all objects of the burning fire. A new seed or another model starts
    /// the fire again.
    pub fn set_scene(&mut self, scene: Scene) {
        let reseeded = scene.world().seed != self.parameters().seed;
        self.scene = scene;
        if reseeded || self.parameters().model() != self.solver.model() {
            self.reset();
        }
        self.solver.adapt(&self.scene, &mut self.random, self.time);
    }

    /// Sets the world and all objects, also the number of particles, to which a burning fire is resampled. A fire without a
    /// step is created again, so that an earlier number does not influence it.
    pub fn adapt(&mut self, scene: Scene) {
        if self.time > 0.0 {
            self.set_scene(scene);
        } else {
            self.begin(scene);
        }
    }

    /// Where the solids that are on are now, in the order of the objects.
    pub fn poses(&self) -> Vec<Pose> {
        let mut poses = self.scene.poses(self.time);
        if let Some(free) = self.solver.solids().free.as_ref() {
            free.move_poses(&mut poses);
        }
        poses
    }

    /// Simulated time since the start \[s\].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Length of the last step \[s\]; before the first one of the classic model, its
    /// [`time_step`](crate::params::Physics::time_step).
    pub fn step_length(&self) -> f64 {
        self.solver.step_length(&self.scene)
    }

    /// Number of particles alive.
    pub fn count(&self) -> usize {
        self.solver.count()
    }

    /// A report of the last step. It counts the neighbours again, which takes about as long as
    /// the neighbour search.
    pub fn report(&self) -> StepReport {
        self.solver.report(self.scene.world())
    }

    /// Numerical speed of sound in the gas [m/s], far below that of air: the square root of the
    /// gas constant, or c₀.
    pub fn sound_speed(&self) -> f32 {
        self.solver.sound_speed(&self.scene)
    }

    /// Writes the instances for the renderer, in no particular order: the visible particles for
    /// the display of the combustion model's fire, all particles for every other
    /// [`DisplayMode`].
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.clear();
        out.reserve(self.solver.capacity(self.scene.world()));
        match self.scene.world().display_mode {
            DisplayMode::Fire | DisplayMode::Paper => self.solver.write_fire(out),
            mode => self.write_measured(mode, out),
        }
    }

    fn write_measured(&self, mode: DisplayMode, out: &mut Vec<Instance>) {
        let (solver, values) = (&self.solver, self.scene.world());
        let measured = (0..solver.count()).map(|i| solver.measured(i, values, mode));
        out.extend(measured.map(Instance::from));
        if mode == DisplayMode::Distance {
            let has_floor = match values.model() {
                Model::Classic => values.walls != Walls::Open,
                Model::Combustion => values.edges == Edges::Open && values.floor == Floor::Solid,
            };
            let [low, high] = self.extent();
            let farthest = high.distance(low);
            for instance in &mut *out {
                let floor = if has_floor { instance[1] } else { farthest };
                let place = Vec2::new(instance[0], instance[1]);
                instance[7] = solver.solids().nearest(place, fast_min(floor, farthest));
            }
        }
        let vorticity = mode == DisplayMode::Vorticity;
        if vorticity || mode == DisplayMode::Neighbours {
            let h = values.smoothing_length();
            neighbourhood::measure(out, &solver.bounds(values), solver.solids(), h, vorticity);
        }
        if let (Some(combustion), true) = (solver.combustion(), mode != DisplayMode::Sprites) {
            combustion.widen(out);
        }
    }

    /// Writes the embers for the renderer; the classic model has none.
    pub fn write_embers(&self, out: &mut Vec<Instance>) {
        out.clear();
        if let Some(combustion) = self.solver.combustion() {
            combustion.write_embers(out);
        }
    }

    /// Throws this number of embers from a position \[m\] inside the domain, up to 4000 embers
    /// in total. Their sizes and lifetimes follow the parameters. Outside of the domain, and in
    /// the classic model, it does nothing.
    pub fn throw_embers(&mut self, place: Vec2, count: u32) {
        if let Some(combustion) = self.solver.combustion_mut() {
            combustion.throw_embers(place, count, self.scene.world(), &mut self.random);
        }
    }

    /// Replaces all particles. Their order is the order in which readers return them. In the
    /// classic model, the source emits while there are fewer than `max_particles`. In the
    /// combustion model they fill the domain, each with the same share of the mass of its air.
    ///
    /// # Errors
    /// More than 400,000 particles in the classic model; in the combustion model, fewer than
    /// half of `particles` or more than twice as many, because the smoothing length follows
    /// it; or a particle outside of the domain, faster than 1000 m/s, not from 1 to 100,000 K,
    /// without a lifetime, or with fuel or oxygen not from 0 to 1 or soot not from 0 to 10.
    /// Nothing changes then.
    pub fn set_particles(&mut self, particles: &[Particle]) -> Result<(), ParticleError> {
        self.check_count(particles.len())?;
        let solver = &mut self.solver;
        let bounds = solver.bounds(self.scene.world());
        for (index, particle) in particles.iter().enumerate() {
            if let Some(what) = particle.broken_rule(&bounds) {
                return Err(ParticleError {
                    index: Some(index),
                    what,
                });
            }
        }
        solver.set_particles(particles, self.scene.world());
        Ok(())
    }

    /// Checks whether [`set_particles`](Simulation::set_particles) accepts that many particles.
    ///
    /// # Errors
    /// Too few or too many particles.
    pub fn check_count(&self, particles: usize) -> Result<(), ParticleError> {
        let broken = self.solver.broken_count_rule(particles, self.scene.world());
        broken.map_or(Ok(()), |what| Err(ParticleError { index: None, what }))
    }
}
