//! A fire, step by step, whichever model burns it.
//!
//! Parameters go in by reference; nothing flows backward.
//! [`Classic`](crate::params::Model::Classic) and
//! [`Combustion`](crate::params::Model::Combustion) each say how they step.

pub mod burning;

use std::fmt;

use glam::Vec2;

use crate::bounds::Bounds;
use crate::classic::{self, Classic, ParticleState};
use crate::combustion::{self, Combustion, Ember};
use crate::forces::BodyForce;
use crate::neighbourhood::measure;
use crate::params::{DisplayMode, Input, Model, ParamError, Parameters};
use crate::particle::{Instance, Particle};
use crate::random::Random;

/// What the last step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Parts the step was divided into; one in the combustion model, whose
    /// steps are as long as they may be.
    pub substeps: u32,
    /// Neighbours of a particle within 2h, on average.
    pub mean_neighbours: f32,
    /// Most neighbours of one particle.
    pub max_neighbours: u32,
    /// Particles that the speed limit held back in the last substep.
    pub speed_limited: u32,
    /// Particles that any net held: the speed limit or, in the combustion model,
    /// the farthest that shifting may move one.
    pub at_guard: u32,
    /// Speed of the fastest particle [m/s].
    pub fastest: f32,
    /// Length of the step \[s\].
    pub length: f32,
    /// Power that the burning gave [kW/m]; zero in the classic model.
    pub power: f32,
    /// Power that made the gas of the source as hot as it is, which comes on
    /// top of that [kW/m]; zero in the classic model.
    pub preheat: f32,
}

/// The parts of a step, in their order; for whoever wants to know how long each
/// takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Births, and the order in which particles lie.
    Sort,
    /// Who is near whom, and how dense it is there.
    Density,
    /// Forces and exchange.
    Forces,
    /// Motion, burning, and what comes in and leaves.
    Integrate,
}

/// A fire.
///
/// The same parameters, seed and calls give the same bits, on every machine.
#[derive(Clone, Debug)]
pub struct Simulation {
    parameters: Parameters,
    gas: Gas,
    random: Random,
    time: f64,
}

/// The particles of the model that burns.
// There is one of them, so the larger one's room costs nothing.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug)]
enum Gas {
    Classic(Classic),
    Combustion(Combustion),
}

impl Gas {
    // Three callers; a copy in each would be a kilobyte of download.
    #[inline(never)]
    fn of(parameters: &Parameters, random: &mut Random) -> Gas {
        match parameters.model() {
            Model::Classic => Gas::Classic(Classic::default()),
            Model::Combustion => Gas::Combustion(Combustion::new(parameters, random)),
        }
    }

    fn model(&self) -> Model {
        match self {
            Gas::Classic(_) => Model::Classic,
            Gas::Combustion(_) => Model::Combustion,
        }
    }
}

impl Simulation {
    /// A source that is about to be lit.
    pub fn new(parameters: Parameters) -> Simulation {
        let mut random = Random::new(parameters.seed);
        Simulation {
            gas: Gas::of(&parameters, &mut random),
            random,
            parameters,
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
        let (parameters, random) = (&self.parameters, &mut self.random);
        self.time += match &mut self.gas {
            Gas::Classic(classic) => classic.step(parameters, random, self.time, force, on_stage),
            Gas::Combustion(gas) => gas.step(parameters, random, self.time, force, on_stage),
        };
    }

    /// Starts again: as at first, time zero, the generator at its seed.
    pub fn reset(&mut self) {
        self.random = Random::new(self.parameters.seed);
        self.gas = Gas::of(&self.parameters, &mut self.random);
        self.time = 0.0;
    }

    /// The parameters that it burns by.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Sets one parameter while it burns, or says why not and changes nothing.
    /// A new seed or another model starts the fire again.
    ///
    /// # Errors
    /// An unknown id, a value of the wrong kind or one outside the range.
    pub fn set(&mut self, id: &str, input: Input<'_>) -> Result<(), ParamError> {
        let mut parameters = self.parameters.clone();
        parameters.set(id, input)?;
        self.set_parameters(parameters);
        Ok(())
    }

    /// Sets all parameters while it burns. A new seed or another model starts
    /// the fire again.
    pub fn set_parameters(&mut self, parameters: Parameters) {
        let reseeded = parameters.seed != self.parameters.seed;
        self.parameters = parameters;
        if reseeded || self.parameters.model() != self.gas.model() {
            self.reset();
        }
        match &mut self.gas {
            Gas::Classic(classic) => classic.adapt(&self.parameters),
            Gas::Combustion(gas) => gas.adapt(&self.parameters, &mut self.random),
        }
    }

    /// Simulated time since the start \[s\].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Length of a step \[s\]: of the last one where the state decides.
    pub fn step_length(&self) -> f64 {
        match &self.gas {
            Gas::Classic(_) => f64::from(self.parameters.time_step),
            Gas::Combustion(gas) => gas.step_length(&self.parameters),
        }
    }

    /// Number of particles alive.
    pub fn count(&self) -> usize {
        match &self.gas {
            Gas::Classic(classic) => classic.particles().len(),
            Gas::Combustion(gas) => gas.gas().len(),
        }
    }

    /// What the last step did. It counts the neighbours anew, which takes about
    /// as long as finding them.
    pub fn report(&self) -> StepReport {
        match &self.gas {
            Gas::Classic(classic) => StepReport {
                length: self.parameters.time_step,
                ..classic.report()
            },
            Gas::Combustion(gas) => gas.report(),
        }
    }

    /// Power that the burning gave in the last step [kW/m]; zero in the classic model.
    pub fn power(&self) -> f32 {
        match &self.gas {
            Gas::Classic(_) => 0.0,
            Gas::Combustion(gas) => gas.power(),
        }
    }

    /// Speed of sound in the gas [m/s], which is numerical and far below that
    /// of air: the square root of the gas constant, or c₀.
    pub fn sound_speed(&self) -> f32 {
        match &self.gas {
            Gas::Classic(_) => self.parameters.gas_constant.sqrt(),
            Gas::Combustion(_) => combustion::sound_speed(&self.parameters),
        }
    }

    /// Copies out what the renderer needs, in no particular order: of a fire in the
    /// combustion model only what can be seen, in every other
    /// [`DisplayMode`] all particles.
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.clear();
        match (self.parameters.display_mode, &self.gas) {
            (DisplayMode::Fire | DisplayMode::Paper, Gas::Classic(classic)) => {
                classic.write_instances(out);
            }
            (DisplayMode::Fire | DisplayMode::Paper, Gas::Combustion(gas)) => {
                gas.write_instances(out);
            }
            (mode, _) => self.write_measured(mode, out),
        }
    }

    fn write_measured(&self, mode: DisplayMode, out: &mut Vec<Instance>) {
        out.extend((0..self.count()).map(|i| match &self.gas {
            Gas::Classic(classic) => classic.measured(i, &self.parameters, mode),
            Gas::Combustion(gas) => gas.measured(i, mode),
        }));
        let spin = mode == DisplayMode::Vorticity;
        if spin || mode == DisplayMode::Neighbours {
            let h = self.parameters.smoothing_length();
            measure(out, &self.bounds(), h, spin);
        }
    }

    /// Copies out the embers for the renderer.
    pub fn write_embers(&self, out: &mut Vec<Instance>) {
        out.clear();
        if let Gas::Combustion(gas) = &self.gas {
            gas.write_embers(out);
        }
    }

    /// The embers that fly; none in the classic model.
    pub fn embers(&self) -> &[Ember] {
        match &self.gas {
            Gas::Classic(_) => &[],
            Gas::Combustion(gas) => gas.embers(),
        }
    }

    /// Throws so many embers from a place \[m\] inside the domain; no more than 4000 fly
    /// at one time. Their sizes and lives are those of the others. Outside, and in the
    /// classic model, which has no embers, it does nothing.
    pub fn throw_embers(&mut self, place: Vec2, count: u32) {
        if let Gas::Combustion(gas) = &mut self.gas {
            gas.throw_embers(place, count, &self.parameters, &mut self.random);
        }
    }

    /// Copies of all particles, in the order of their birth.
    pub fn particles(&self) -> Vec<Particle> {
        self.read(ParticleState::particle, |gas, i| gas.particle(i, self.time))
    }

    /// The numbers by which particles are known from step to step, in the order of
    /// birth, which is theirs. Particles that are put in, or that take over a fire,
    /// are numbered from 0 again.
    pub fn ids(&self) -> Vec<u64> {
        self.read(|one| one.id, |gas, i| u64::from(gas.id[i]))
    }

    /// Positions \[m\], in the order of birth.
    pub fn positions(&self) -> Vec<Vec2> {
        self.read(ParticleState::position, |gas, i| gas.position[i])
    }

    /// Velocities [m/s], in the order of birth.
    pub fn velocities(&self) -> Vec<Vec2> {
        self.read(ParticleState::velocity, |gas, i| gas.velocity[i])
    }

    /// Temperatures \[K\], in the order of birth.
    pub fn temperatures(&self) -> Vec<f32> {
        self.read(|one| one.temperature, |gas, i| gas.state[i].x)
    }

    /// Times since birth \[s\], in the order of birth; the air of the combustion
    /// model is as old as the fire.
    pub fn ages(&self) -> Vec<f32> {
        self.read(|one| one.age, |_, _| self.time as f32)
    }

    /// Densities [kg/m³] as the last step found them, in the order of birth.
    pub fn densities(&self) -> Vec<f32> {
        self.read(|one| one.density, |gas, i| gas.mass / gas.volume[i])
    }

    /// Pressures \[Pa\] as the last step found them, in the order of birth; in the
    /// combustion model above the mean of the domain.
    pub fn pressures(&self) -> Vec<f32> {
        self.read(|one| one.pressure, |gas, i| gas.pressure[i])
    }

    /// Fuel \[share of the gas\], in the order of birth; none in the classic model.
    pub fn fuels(&self) -> Vec<f32> {
        self.read(|_| 0.0, |gas, i| gas.state[i].y)
    }

    /// Oxygen \[share of that of air\], in the order of birth; one in the classic model.
    pub fn oxygens(&self) -> Vec<f32> {
        self.read(|_| 1.0, |gas, i| gas.state[i].z)
    }

    /// Soot, in the order of birth; none in the classic model.
    pub fn soots(&self) -> Vec<f32> {
        self.read(|_| 0.0, |gas, i| gas.state[i].w)
    }

    /// Fuel burnt in a second [1/s] in the last step, in the order of birth;
    /// none in the classic model.
    pub fn burn_rates(&self) -> Vec<f32> {
        self.read(|_| 0.0, |gas, i| gas.burn[i])
    }

    /// Vorticities [1/s], counterclockwise above zero, in the order of birth: twice
    /// the speed at which the neighbours of each particle turn around it now.
    pub fn vorticities(&self) -> Vec<f32> {
        self.measured(DisplayMode::Vorticity)
    }

    /// How many others each particle has within 2h now, in the order of birth.
    pub fn neighbour_counts(&self) -> Vec<u32> {
        let counts = self.measured(DisplayMode::Neighbours).into_iter();
        counts.map(|count| count as u32).collect()
    }

    fn measured(&self, mode: DisplayMode) -> Vec<f32> {
        let mut all = Vec::new();
        self.write_measured(mode, &mut all);
        let order = match &self.gas {
            Gas::Classic(classic) => classic.particles().by_id(),
            Gas::Combustion(combustion) => combustion.gas().by_id(),
        };
        let found = order.into_iter().map(|i| {
            let [.., measured] = all[i];
            measured
        });
        found.collect()
    }

    fn read<T>(
        &self,
        of_classic: impl Fn(&ParticleState) -> T,
        of_gas: impl Fn(&combustion::Gas, usize) -> T,
    ) -> Vec<T> {
        match &self.gas {
            Gas::Classic(classic) => {
                let particles = classic.particles();
                let order = particles.by_id().into_iter();
                order.map(|i| of_classic(&particles[i])).collect()
            }
            Gas::Combustion(combustion) => {
                let gas = combustion.gas();
                let order = gas.by_id().into_iter();
                order.map(|i| of_gas(gas, i)).collect()
            }
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
        let few = self.parameters.max_particles as usize;
        let refused = match self.gas.model() {
            Model::Classic if particles.len() > MOST => Some(TOO_MANY),
            Model::Combustion if !(few.div_ceil(2)..=2 * few).contains(&particles.len()) => {
                Some(NOT_AS_MANY)
            }
            _ => None,
        };
        if let Some(what) = refused {
            return Err(ParticleError { index: None, what });
        }
        let bounds = self.bounds();
        for (index, particle) in particles.iter().enumerate() {
            if let Some(what) = fault(particle, &bounds) {
                return Err(ParticleError {
                    index: Some(index),
                    what,
                });
            }
        }
        match &mut self.gas {
            Gas::Classic(classic) => classic.set_particles(particles),
            Gas::Combustion(gas) => gas.set_particles(particles, &self.parameters),
        }
        Ok(())
    }

    fn bounds(&self) -> Bounds {
        match &self.gas {
            Gas::Classic(_) => classic::bounds(&self.parameters),
            Gas::Combustion(_) => combustion::bounds(&self.parameters),
        }
    }
}

/// Most particles that somebody may put into the classic model, and what is said
/// of more; and of a number that does not go with the smoothing length.
const MOST: usize = 400_000;
const TOO_MANY: &str = "there may be 400000 of them at most";
const NOT_AS_MANY: &str = "there must be from half to twice max_particles of them";

/// Fastest particle that can be put in [m/s]; what is thousands of times as
/// fast as the gas would not move it but break it.
const FASTEST: f32 = 1000.0;

/// What is wrong with a particle that somebody wants to put in.
fn fault(particle: &Particle, bounds: &Bounds) -> Option<&'static str> {
    let Particle {
        position,
        velocity,
        temperature,
        age,
        lifetime,
        fuel,
        oxygen,
        soot,
    } = *particle;
    let share = 0.0..=1.0;
    if !bounds.hold(position) {
        Some("position must be inside the domain")
    } else if !(0.0..=FASTEST).contains(&velocity.length()) {
        Some("velocity must be at most 1000 m/s")
    } else if !(1.0..=1e5).contains(&temperature) {
        Some("temperature must be from 1 to 100000 K")
    } else if !(age >= 0.0 && lifetime > age) {
        Some("age must be at least 0 and less than the lifetime")
    } else if !(share.contains(&fuel) && share.contains(&oxygen)) {
        Some("fuel and oxygen must be from 0 to 1")
    } else if !(0.0..=10.0).contains(&soot) {
        Some("soot must be from 0 to 10")
    } else {
        None
    }
}

/// Why particles were refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParticleError {
    /// The first particle that cannot be taken, where it is not their number.
    pub index: Option<usize>,
    /// What is wrong with it.
    pub what: &'static str,
}

impl fmt::Display for ParticleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index {
            Some(index) => write!(f, "particle {index} is refused: {}", self.what),
            None => write!(f, "the particles are refused: {}", self.what),
        }
    }
}

impl std::error::Error for ParticleError {}
