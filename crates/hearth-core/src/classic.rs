//! The classic model: the student paper's, with its errors corrected.
//!
//! Particles are born at a source, rise, repel each other, cool and die; they
//! alone are the fire. One step is: emitter → neighbour grid → density →
//! pressure → forces → motion.

mod block_force;
mod emitter;
mod equation_of_state;
mod forces;
mod integrate;
mod interactions;
mod pair;
mod pairs;
mod particles;
mod solids;

use crate::bounds::Bounds;
use crate::extremes::fast_min;
use crate::forces::BodyForce;
use crate::instance::{ClassicParticle, Instance, Measured, numbered};
use crate::kernel::Kernel;
use crate::params::{DisplayMode, Physics, Walls};
use crate::particle::Particle;
use crate::random::Random;
use crate::report::{Stage, StepReport};
use crate::scene::Scene;
use crate::series::{BIRTHS, DEATHS, Totals};
use crate::solids::Solids;
use crate::solver::Solver;
use crate::time_step::fitted;

use block_force::BlockForce;
use emitter::Emitter;
pub(crate) use emitter::place as source;
use integrate::{Motion, Substeps};
use pairs::Pairs;
use particles::{ParticleState, Particles};

/// Most particles that a caller may put in, and the error for more.
const MAX_PARTICLES: usize = 400_000;
const TOO_MANY: &str = "there may be 400000 of them at most";

/// Most work of a step, in the unit of [`Pairs::work`]; the substep that exceeds it is the last.
/// A fire of thousands of particles with their usual neighbours stays far below.
const MAX_WORK: usize = 1 << 22;

/// The particles of the classic model and the state of its solver.
#[derive(Clone, Debug, Default)]
pub(crate) struct Classic {
    particles: Particles,
    pairs: Pairs,
    /// One for each source.
    emitters: Vec<Emitter>,
    solids: Solids,
    motion: Motion,
    substeps: u32,
    /// Length of the last step if it was shorter than the parameter \[s\].
    cut: Option<f32>,
}

crate::state! { Classic: particles emitters solids motion substeps cut; pairs }

impl Classic {
    /// No particles yet.
    pub fn new(scene: &Scene) -> Classic {
        let values: &Physics = scene.world();
        Classic {
            solids: Solids::of(scene, &bounds(values), 2.0 * values.smoothing_radius),
            ..Classic::default()
        }
    }

    /// Length of the last step or, before the first, of the next \[s\].
    fn length(&self, values: &Physics) -> f32 {
        self.cut.unwrap_or(values.time_step)
    }

    fn substep(
        &mut self,
        values: &Physics,
        substeps: &Substeps,
        (forces, end): (&impl BlockForce, f64),
        on_stage: &mut dyn FnMut(Stage),
    ) {
        let kernel = kernel(values);
        let bounds = bounds(values);
        let particles = &mut self.particles;
        let pairs = &mut self.pairs;

        pairs.sort(particles, &bounds, &kernel);
        on_stage(Stage::Sort);
        pairs.sum_density(particles, &kernel, values, &self.solids);
        on_stage(Stage::Density);
        interactions::sum(pairs, &kernel, values, substeps.viscosity);
        on_stage(Stage::Forces);
        self.motion = integrate::integrate(particles, pairs, forces, values, substeps.length);
        self.solids.advance(end);
        let (solids, dt) = (&mut self.solids, substeps.length);
        integrate::bound(particles, values, solids, &bounds, dt);
        self.solids.end_motions(substeps.length);
        on_stage(Stage::Integrate);
    }
}

impl Solver for Classic {
    fn step(
        &mut self,
        scene: &Scene,
        random: &mut Random,
        (time, left): (f64, f64),
        user: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f64 {
        let values: &Physics = scene.world();
        self.emitters
            .resize_with(scene.sources().count(), Emitter::default);
        let passed = self.cut.unwrap_or(values.time_step);
        let emitters = self.emitters.iter_mut().zip(scene.sources());
        let mut due: f32 = emitters
            .map(|(emitter, source)| emitter.due(&source, passed, time))
            .sum();
        for (emitter, source) in self.emitters.iter_mut().zip(scene.sources()) {
            // Sources share the free places of a fire that is nearly full; the last one gets the rest.
            let (alive, own) = (self.particles.len(), emitter.backlog);
            let free = (values.max_particles as usize).saturating_sub(alive);
            let share = match due > free as f32 && due > own {
                true => (free as f32 * own / due + random.unit()) as usize,
                false => free,
            };
            due -= own;
            let solid = self.solids.parts(&source);
            emitter.emit(
                &mut self.particles,
                (&source, solid),
                alive + share.min(free),
                random,
                time,
            );
        }
        let length = fitted(values.time_step, left);
        let substeps = Substeps::divide(values, length, &self.motion);
        let forces = forces::list(values, time, user);
        let (mut made, mut work) = (0, 0);
        let bounds = bounds(values);
        while made < substeps.count && work <= MAX_WORK {
            made += 1;
            self.solids
                .renew_images(&bounds, 2.0 * values.smoothing_radius);
            let end = time + f64::from(made as f32 * substeps.length);
            self.substep(values, &substeps, (&forces, end), on_stage);
            work += self.pairs.work();
        }
        self.substeps = made;
        // Shorter steps keep the substeps stable; the fire burns more slowly.
        let length = match made < substeps.count {
            true => made as f32 * substeps.length,
            false => length,
        };
        self.cut = (length != values.time_step).then_some(length);
        f64::from(self.length(values))
    }

    /// Removes the particles outside of a smaller domain; solid walls would move them onto each
    /// other.
    fn adapt(&mut self, scene: &Scene, _random: &mut Random, time: f64) {
        let values = scene.world();
        let bounds = bounds(values);
        let stays =
            |particle: &ParticleState| particle.is_alive() && bounds.contains(particle.position());
        self.particles.retain(stays);
        let support = 2.0 * values.smoothing_radius;
        self.solids.update(scene, time, &bounds, support);
        solids::keep_all_outside(&mut self.particles, &mut self.solids, values, 0.0);
        self.particles.retain(stays);
    }

    fn set_particles(&mut self, particles: &[Particle], values: &Physics) {
        self.particles.clear();
        for &particle in particles {
            self.particles.push(particle);
        }
        let bounds = bounds(values);
        solids::keep_all_outside(&mut self.particles, &mut self.solids, values, 0.0);
        self.particles
            .retain(|particle| particle.is_alive() && bounds.contains(particle.position()));
        self.motion = Motion::default();
        self.cut = None;
    }

    fn broken_count_rule(&self, count: usize, _values: &Physics) -> Option<&'static str> {
        (count > MAX_PARTICLES).then_some(TOO_MANY)
    }

    fn bounds(&self, values: &Physics) -> Bounds {
        bounds(values)
    }

    fn solids(&self) -> &Solids {
        &self.solids
    }

    fn sound_speed(&self, scene: &Scene) -> f32 {
        scene.world().gas_constant.sqrt()
    }

    fn step_length(&self, scene: &Scene) -> f64 {
        f64::from(self.length(scene.world()))
    }

    fn report(&self, values: &Physics) -> StepReport {
        let (mean_neighbours, max_neighbours) = self.pairs.mean_and_max();
        StepReport {
            substeps: self.substeps,
            mean_neighbours,
            max_neighbours,
            speed_limited: self.motion.speed_limited,
            clamped: self.motion.speed_limited,
            max_speed: self.motion.max_speed,
            length: self.length(values),
            ..StepReport::default()
        }
    }

    fn totals(&self) -> Totals {
        let mut totals = Totals::default();
        let births = self.particles.births() as f64;
        totals.grown[BIRTHS] = births;
        totals.grown[DEATHS] = births - self.particles.len() as f64;
        totals
    }

    fn count(&self) -> usize {
        self.particles.len()
    }

    fn capacity(&self, _values: &Physics) -> usize {
        self.count()
    }

    fn by_id(&self) -> Vec<usize> {
        self.particles.by_id()
    }

    fn id(&self, i: usize) -> u64 {
        self.particles[i].id
    }

    fn particle(&self, i: usize, _time: f64) -> Particle {
        self.particles[i].particle()
    }

    fn density(&self, i: usize) -> f32 {
        self.particles[i].density
    }

    fn pressure(&self, i: usize) -> f32 {
        self.particles[i].pressure
    }

    fn write_fire(&self, out: &mut Vec<Instance>) {
        out.extend(self.particles.iter().map(|particle| {
            Instance::from(ClassicParticle {
                position: particle.position(),
                velocity: particle.velocity(),
                temperature: particle.temperature,
                density: particle.density,
                age: particle.age,
                life: 1.0 - particle.age / particle.lifetime,
            })
        }));
    }

    fn measured(&self, i: usize, values: &Physics, mode: DisplayMode) -> Measured {
        let particle = &self.particles[i];
        let age_share = particle.age / particle.lifetime;
        let value = match mode {
            DisplayMode::Particles | DisplayMode::Temperature => particle.temperature,
            DisplayMode::Density => particle.density,
            DisplayMode::Pressure => particle.pressure,
            DisplayMode::Velocity => particle.velocity().length(),
            DisplayMode::Fuel | DisplayMode::Sprites => 1.0 - age_share,
            DisplayMode::Soot => age_share * age_share * age_share,
            _ => 0.0,
        };
        // The volume of a lone particle is that of its kernel. The published normalisation
        // changes densities but not volumes.
        let w = Kernel::new(values.smoothing_radius).value(0.0);
        let share = kernel(values).value(0.0) / w;
        let volume = fast_min(share * values.particle_mass / particle.density, 1.0 / w);
        Measured {
            position: particle.position(),
            velocity: particle.velocity(),
            temperature: particle.temperature,
            volume,
            number: numbered(particle.id, mode),
            value,
        }
    }
}

fn kernel(values: &Physics) -> Kernel {
    if values.printed_kernel {
        Kernel::as_published(values.smoothing_radius)
    } else {
        Kernel::new(values.smoothing_radius)
    }
}

/// The domain of the classic model, with an open top.
pub(crate) fn bounds(values: &Physics) -> Bounds {
    Bounds {
        bottom: 0.0,
        width: values.domain_width,
        height: values.domain_height,
        periodic_x: values.walls == Walls::Periodic,
        periodic_y: false,
    }
}
