//! The classic model: the student paper's, with its mistakes put right.
//!
//! Particles are born at a source, rise, push each other, cool and die; they
//! alone carry the fire. One step is: emitter → neighbour grid → density →
//! pressure → forces → motion.

mod density;
mod emitter;
mod forces;
mod integrate;
mod particles;
mod printed;

use glam::Vec2;

use crate::Particle;
use crate::grid::{Bounds, Grid};
use crate::kernel::Kernel;
use crate::neighbours::Neighbours;
use crate::params::{Values, Walls};
use crate::particle::Instance;
use crate::random::Random;
use crate::simulation::StepReport;
use crate::turbulence::Turbulence;

use emitter::Emitter;
use integrate::{Motion, Substeps};
pub(crate) use particles::Particles;

/// The particles of the classic model and what moves them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Classic {
    particles: Particles,
    grid: Grid,
    neighbours: Neighbours,
    emitter: Emitter,
    motion: Motion,
    substeps: u32,
}

impl Classic {
    /// Burns on by one time step from `time` on, with the accelerations `push`
    /// besides its own. Returns the length of the step \[s\].
    pub fn step(
        &mut self,
        values: &Values,
        random: &mut Random,
        time: f64,
        push: &impl Fn(Vec2, Vec2) -> Vec2,
    ) -> f64 {
        self.emitter.emit(&mut self.particles, values, random, time);
        let substeps = Substeps::divide(values, self.motion.fastest, self.motion.hardest);
        let turbulence = Turbulence::new(values, time);
        for _ in 0..substeps.count {
            self.substep(values, &substeps, &turbulence, push);
        }
        self.substeps = substeps.count;
        f64::from(values.time_step)
    }

    fn substep(
        &mut self,
        values: &Values,
        substeps: &Substeps,
        turbulence: &Turbulence,
        push: &impl Fn(Vec2, Vec2) -> Vec2,
    ) {
        let kernel = if values.printed_kernel {
            Kernel::as_printed(values.smoothing_radius)
        } else {
            Kernel::new(values.smoothing_radius)
        };
        let bounds = bounds(values);
        let particles = &mut self.particles;
        let neighbours = &mut self.neighbours;

        particles.reorder(
            self.grid
                .sort(&particles.position, &bounds, kernel.support()),
        );
        density::sum_density(
            particles,
            neighbours,
            &self.grid,
            &kernel,
            values.particle_mass,
        );
        density::pressure(particles, values);
        forces::accelerate(particles, neighbours, &kernel, values, substeps.viscosity);
        particles.push_by(push);
        forces::stir(particles, turbulence, values);
        self.motion = integrate::integrate(particles, values, substeps.length);
        integrate::cool_and_age(particles, values, substeps.length);
        integrate::bound(particles, values, &bounds);
    }

    /// Takes up changed values: a smaller domain leaves particles outside;
    /// solid walls would sweep them onto each other, so they are gone instead.
    pub fn adapt(&mut self, values: &Values) {
        let bounds = bounds(values);
        self.particles.retain(|p, i| bounds.hold(p.position[i]));
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
        let (mean_neighbours, most_neighbours) = self.neighbours.mean_and_most();
        StepReport {
            substeps: self.substeps,
            mean_neighbours,
            most_neighbours,
            at_speed_limit: self.motion.limited,
            at_guard: self.motion.limited,
            fastest: self.motion.fastest,
            ..StepReport::default()
        }
    }

    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        let p = &self.particles;
        out.extend((0..p.len()).map(|i| {
            [
                p.position[i].x,
                p.position[i].y,
                p.velocity[i].x,
                p.velocity[i].y,
                p.temperature[i],
                p.density[i],
                p.age[i],
                1.0 - p.age[i] / p.lifetime[i],
            ]
        }));
    }
}

/// The domain of the classic model: its top is open.
pub(crate) fn bounds(values: &Values) -> Bounds {
    Bounds {
        width: values.domain_width,
        height: values.domain_height,
        periodic: values.walls == Walls::Periodic,
        endless: false,
    }
}
