//! A fire, step by step.
//!
//! [`Simulation::step`] reads as the algorithm. Parameters go in by reference;
//! nothing flows backward: emitter → grid → density → pressure → forces →
//! motion.

use std::fmt;

use glam::Vec2;

use crate::density::{self, Neighbours};
use crate::emitter::Emitter;
use crate::forces;
use crate::grid::{Bounds, Grid};
use crate::integrate::{self, Motion, Substeps};
use crate::kernel::Kernel;
use crate::params::{Input, Param, ParamError, Parameters, Walls};
use crate::particles::{Particle, Particles};
use crate::random::Random;

/// One particle as the renderer gets it: x, y \[m\], vx, vy [m/s], temperature
/// \[K\], density [kg/m³], age \[s\], remaining life [0–1].
pub type Instance = [f32; 8];

/// What the last step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Parts the step was divided into.
    pub substeps: u32,
    /// Neighbours of a particle within 2h, on average.
    pub mean_neighbours: f32,
    /// Most neighbours of one particle.
    pub most_neighbours: u32,
    /// Particles that the speed limit held back in the last substep.
    pub at_speed_limit: u32,
    /// Speed of the fastest particle [m/s].
    pub fastest: f32,
}

/// A fire.
///
/// The same parameters, seed and calls give the same bits, on every machine.
#[derive(Clone, Debug)]
pub struct Simulation {
    parameters: Parameters,
    particles: Particles,
    grid: Grid,
    neighbours: Neighbours,
    emitter: Emitter,
    random: Random,
    motion: Motion,
    substeps: u32,
    time: f64,
}

impl Simulation {
    /// A source that is about to be lit.
    pub fn new(parameters: Parameters) -> Simulation {
        Simulation {
            random: Random::new(parameters.seed),
            parameters,
            particles: Particles::default(),
            grid: Grid::default(),
            neighbours: Neighbours::default(),
            emitter: Emitter::default(),
            motion: Motion::default(),
            substeps: 0,
            time: 0.0,
        }
    }

    /// Burns on by one time step.
    pub fn step(&mut self) {
        let values = &self.parameters;
        self.emitter
            .emit(&mut self.particles, values, &mut self.random, self.time);
        let substeps = Substeps::divide(values, self.motion.fastest, self.motion.hardest);
        for _ in 0..substeps.count {
            self.substep(&substeps);
        }
        self.substeps = substeps.count;
        self.time += f64::from(self.parameters.time_step);
    }

    fn substep(&mut self, substeps: &Substeps) {
        let values = &self.parameters;
        let kernel = if values.printed_kernel {
            Kernel::as_printed(values.smoothing_radius)
        } else {
            Kernel::new(values.smoothing_radius)
        };
        let bounds = bounds(values);
        let particles = &mut self.particles;
        let neighbours = &mut self.neighbours;

        self.grid.sort(particles, &bounds, kernel.support());
        density::sum_density(
            particles,
            neighbours,
            &self.grid,
            &bounds,
            &kernel,
            values.particle_mass,
        );
        density::pressure(particles, values);
        forces::accelerate(particles, neighbours, &kernel, values, substeps.viscosity);
        self.motion = integrate::integrate(particles, values, substeps.length);
        integrate::cool_and_age(particles, values, substeps.length);
        integrate::bound(particles, values, &bounds);
    }

    /// Starts again: no particle, time zero, the generator at its seed.
    pub fn reset(&mut self) {
        self.particles.clear();
        self.emitter.reset();
        self.random = Random::new(self.parameters.seed);
        self.motion = Motion::default();
        self.substeps = 0;
        self.time = 0.0;
    }

    /// The parameters that it burns by.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Sets one parameter while it burns, or says why not and changes nothing.
    /// A new seed starts the fire again.
    ///
    /// # Errors
    /// An unknown id, a value of the wrong kind or one outside the range.
    pub fn set(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let mut parameters = self.parameters.clone();
        parameters.set(id, input)?;
        self.set_parameters(parameters);
        Ok(())
    }

    /// Sets all parameters while it burns. A new seed starts the fire again.
    pub fn set_parameters(&mut self, parameters: Parameters) {
        let reseeded = parameters.seed != self.parameters.seed;
        self.parameters = parameters;
        if reseeded {
            self.reset();
        }
        // A smaller domain leaves particles outside; solid walls would sweep
        // them onto each other, so they are gone instead.
        let bounds = bounds(&self.parameters);
        self.particles.retain(|p, i| bounds.hold(p.position[i]));
    }

    /// Simulated time since the start \[s\].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Number of particles alive.
    pub fn count(&self) -> usize {
        self.particles.len()
    }

    /// What the last step did.
    pub fn report(&self) -> StepReport {
        let seen = self.neighbours.count.len();
        StepReport {
            substeps: self.substeps,
            mean_neighbours: 2.0 * self.neighbours.pair_count() as f32 / seen.max(1) as f32,
            most_neighbours: self.neighbours.count.iter().copied().max().unwrap_or(0),
            at_speed_limit: self.motion.limited,
            fastest: self.motion.fastest,
        }
    }

    /// Copies out what the renderer needs, in no particular order.
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        let p = &self.particles;
        out.clear();
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

    /// Copies of all particles, in the order of their birth.
    pub fn particles(&self) -> Vec<Particle> {
        self.read(|p, i| p.get(i))
    }

    /// Positions \[m\], in the order of birth.
    pub fn positions(&self) -> Vec<Vec2> {
        self.read(|p, i| p.position[i])
    }

    /// Velocities [m/s], in the order of birth.
    pub fn velocities(&self) -> Vec<Vec2> {
        self.read(|p, i| p.velocity[i])
    }

    /// Temperatures \[K\], in the order of birth.
    pub fn temperatures(&self) -> Vec<f32> {
        self.read(|p, i| p.temperature[i])
    }

    /// Times since birth \[s\], in the order of birth.
    pub fn ages(&self) -> Vec<f32> {
        self.read(|p, i| p.age[i])
    }

    /// Densities [kg/m³] as the last step found them, in the order of birth.
    pub fn densities(&self) -> Vec<f32> {
        self.read(|p, i| p.density[i])
    }

    /// Pressures \[Pa\] as the last step found them, in the order of birth.
    pub fn pressures(&self) -> Vec<f32> {
        self.read(|p, i| p.pressure[i])
    }

    fn read<T>(&self, property: impl Fn(&Particles, usize) -> T) -> Vec<T> {
        let order = self.particles.by_id();
        order
            .into_iter()
            .map(|i| property(&self.particles, i))
            .collect()
    }

    /// Puts these particles in the place of all that there are. Their order is
    /// the order in which they are read out again. The source goes on as long
    /// as their number is below `max_particles`.
    ///
    /// # Errors
    /// More particles than `max_particles` may ever be, or a particle with a
    /// value that is not finite, outside the domain, colder than 1 K, or
    /// without a lifetime; nothing changes then.
    pub fn set_particles(&mut self, particles: &[Particle]) -> Result<(), ParticleError> {
        let most =
            Parameters::find_range("max_particles").map_or(usize::MAX, |(_, max)| max as usize);
        if particles.len() > most {
            return Err(ParticleError {
                index: most,
                what: "too many particles",
            });
        }
        let bounds = bounds(&self.parameters);
        for (index, particle) in particles.iter().enumerate() {
            if let Some(what) = fault(particle, &bounds) {
                return Err(ParticleError { index, what });
            }
        }
        self.particles.clear();
        for &particle in particles {
            self.particles.push(particle);
        }
        self.motion = Motion::default();
        Ok(())
    }
}

impl Parameters {
    /// The range of the parameter `id`, where it has one.
    fn find_range(id: &str) -> Option<(f64, f64)> {
        Param::find(id)?.domains.first().map(|domain| domain.range)
    }
}

fn bounds(parameters: &Parameters) -> Bounds {
    Bounds {
        width: parameters.domain_width,
        height: parameters.domain_height,
        periodic: parameters.walls == Walls::Periodic,
    }
}

/// What is wrong with a particle that somebody wants to put in.
fn fault(particle: &Particle, bounds: &Bounds) -> Option<&'static str> {
    let Particle {
        position,
        velocity,
        temperature,
        age,
        lifetime,
    } = *particle;
    if !bounds.hold(position) {
        Some("position must be inside the domain")
    } else if !velocity.is_finite() {
        Some("velocity must be finite")
    } else if !(1.0..=1e5).contains(&temperature) {
        Some("temperature must be from 1 to 100000 K")
    } else if !(age >= 0.0 && lifetime > age) {
        Some("age must be at least 0 and less than the lifetime")
    } else {
        None
    }
}

/// Why particles were refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParticleError {
    /// The first particle that cannot be taken.
    pub index: usize,
    /// What is wrong with it.
    pub what: &'static str,
}

impl fmt::Display for ParticleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "particle {} is refused: {}", self.index, self.what)
    }
}

impl std::error::Error for ParticleError {}
