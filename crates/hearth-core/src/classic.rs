//! The classic model: the student paper's, with its mistakes put right.
//!
//! Particles are born at a source, rise, push each other, cool and die; they
//! alone carry the fire. Broadcast step is: emitter → neighbour grid → density →
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

use crate::Particle;
use crate::bounds::Bounds;
use crate::extremes::fast_min;
use crate::forces::BodyForce;
use crate::kernel::Kernel;
use crate::params::{DisplayMode, Physics, Walls};
use crate::particle::{Instance, numbered};
use crate::random::Random;
use crate::simulation::{Stage, StepReport};

use block_force::BlockForce;
use emitter::Emitter;
pub(crate) use emitter::place as source;
use integrate::{Motion, Substeps};
use pairs::Pairs;
pub(crate) use particles::{ParticleState, Particles};

/// The particles of the classic model and what moves them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Classic {
    particles: Particles,
    pairs: Pairs,
    emitter: Emitter,
    motion: Motion,
    substeps: u32,
}

impl Classic {
    /// Burns on by one time step from `time` on, with the force
    /// `user` besides its own. Returns the length of the step \[s\].
    pub fn step(
        &mut self,
        values: &Physics,
        random: &mut Random,
        time: f64,
        user: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f64 {
        self.emitter.emit(&mut self.particles, values, random, time);
        let substeps = Substeps::divide(values, self.motion.fastest, self.motion.hardest);
        let forces = forces::list(values, time, user);
        for _ in 0..substeps.count {
            self.substep(values, &substeps, &forces, on_stage);
        }
        self.substeps = substeps.count;
        f64::from(values.time_step)
    }

    fn substep(
        &mut self,
        values: &Physics,
        substeps: &Substeps,
        forces: &impl BlockForce,
        on_stage: &mut dyn FnMut(Stage),
    ) {
        let kernel = kernel(values);
        let bounds = bounds(values);
        let particles = &mut self.particles;
        let pairs = &mut self.pairs;

        pairs.sort(particles, &bounds, &kernel);
        on_stage(Stage::Sort);
        pairs.sum_density(particles, &kernel, values);
        on_stage(Stage::Density);
        interactions::sum(pairs, &kernel, values, substeps.viscosity);
        on_stage(Stage::Forces);
        self.motion = integrate::integrate(particles, pairs, forces, values, substeps.length);
        integrate::bound(particles, values.walls, &bounds);
        on_stage(Stage::Integrate);
    }

    /// Takes up changed values: a smaller domain leaves particles outside;
    /// solid walls would sweep them onto each other, so they are gone instead.
    pub fn adapt(&mut self, values: &Physics) {
        let bounds = bounds(values);
        self.particles.retain(|one| bounds.hold(one.position()));
    }

    /// Puts these particles in the place of all that there are.
    pub fn set_particles(&mut self, particles: &[Particle]) {
        self.particles.clear();
        for &particle in particles {
            self.particles.push(particle);
        }
        self.motion = Motion::default();
    }

    /// All particles, in no particular order.
    pub fn particles(&self) -> &Particles {
        &self.particles
    }

    pub fn report(&self) -> StepReport {
        let (mean_neighbours, max_neighbours) = self.pairs.mean_and_max();
        StepReport {
            substeps: self.substeps,
            mean_neighbours,
            max_neighbours,
            speed_limited: self.motion.limited,
            at_guard: self.motion.limited,
            fastest: self.motion.fastest,
            ..StepReport::default()
        }
    }

    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.extend(self.particles.iter().map(|one| {
            let [x, y, vx, vy] = one.motion.to_array();
            [
                x,
                y,
                vx,
                vy,
                one.temperature,
                one.density,
                one.age,
                1.0 - one.age / one.lifetime,
            ]
        }));
    }

    /// The particle at `i` with what `mode` measures of it.
    // Taken into a loop, it would be a loop for each mode.
    #[inline(never)]
    pub fn measured(&self, i: usize, values: &Physics, mode: DisplayMode) -> Instance {
        let one = &self.particles[i];
        let lived = one.age / one.lifetime;
        let measured = match mode {
            DisplayMode::Particles | DisplayMode::Temperature => one.temperature,
            DisplayMode::Density => one.density,
            DisplayMode::Pressure => one.pressure,
            DisplayMode::Velocity => one.velocity().length(),
            DisplayMode::Fuel | DisplayMode::Sprites => 1.0 - lived,
            DisplayMode::Soot => lived * lived * lived,
            _ => 0.0,
        };
        // A particle alone has all the room of its kernel. The factor that the paper
        // prints makes other densities, but no other volumes.
        let w = Kernel::new(values.smoothing_radius).value(0.0);
        let share = kernel(values).value(0.0) / w;
        let volume = fast_min(share * values.particle_mass / one.density, 1.0 / w);
        let [x, y, vx, vy] = one.motion.to_array();
        let number = numbered(one.id, mode);
        [x, y, vx, vy, one.temperature, volume, number, measured]
    }
}

fn kernel(values: &Physics) -> Kernel {
    if values.printed_kernel {
        Kernel::as_published(values.smoothing_radius)
    } else {
        Kernel::new(values.smoothing_radius)
    }
}

/// The domain of the classic model: its top is open.
pub(crate) fn bounds(values: &Physics) -> Bounds {
    Bounds {
        width: values.domain_width,
        height: values.domain_height,
        periodic: values.walls == Walls::Periodic,
        endless: false,
    }
}
