//! The combustion model: air that fills the domain, and a burner in it.
//!
//! Fuel flows in, mixes and burns, and the hot gas rises. Nothing is scripted: the taper, flicker
//! and puffing of the flame follow from the equations. One step is: neighbour grid → number density and pressure → pair interactions → vorticity
//! confinement → body forces → time step → embers → velocity → combustion → burner → seam →
//! position.

mod burner;
mod chemistry;
mod embers;
mod equation_of_state;
mod forces;
mod gas;
mod interactions;
mod number_density;
mod pair;
mod resample;
mod seam;
mod time_step;
mod vorticity_confinement;

use glam::Vec2;

use crate::bounds::Bounds;
use crate::forces::BodyForce;
use crate::grid::Grid;
use crate::instance::{GasParticle, Instance, Measured, numbered};
use crate::kernel::Kernel;
use crate::neighbours::Neighbours;
use crate::params::{DisplayMode, Parameters, Physics};
use crate::particle::Particle;
use crate::random::Random;
use crate::report::{Stage, StepReport};
use crate::scene::Scene;
use crate::solver::Solver;

pub use burner::Burner;
pub use embers::Ember;
use embers::{Air, Embers};
pub(crate) use gas::{Gas, bounds};
use interactions::Interactions;
use number_density::NumberDensity;
use pair::Context;
use resample::Discretisation;
use time_step::Motion;
pub(crate) use time_step::sound_speed;
use vorticity_confinement::VorticityConfinement;

/// Gas that is hotter \[K\] or has more soot is visible.
const VISIBLE_TEMPERATURE: f32 = 400.0;
const VISIBLE_SOOT: f32 = 0.002;

/// The error for a number of particles that does not match the smoothing length.
const WRONG_COUNT: &str = "there must be from half to twice max_particles of them";

/// The gas of the combustion model and the state of its solver.
#[derive(Clone, Debug)]
pub(crate) struct Combustion {
    gas: Gas,
    grid: Grid,
    neighbours: Neighbours,
    number_density: NumberDensity,
    interactions: Interactions,
    vorticity_confinement: VorticityConfinement,
    embers: Embers,
    /// The discretisation of the present particles.
    discretisation: Discretisation,
    /// Temperature of the air in the gas \[K\].
    air: f32,
    motion: Motion,
    /// Power of the combustion in the last step, and of the heating at the sources [kW/m].
    power: f32,
    preheat: f32,
    /// Particles whose shift was clamped.
    clamped_shifts: u32,
    length: f32,
}

impl Combustion {
    /// Air at rest.
    pub fn new(parameters: &Parameters, random: &mut Random) -> Combustion {
        Combustion {
            gas: Gas::air(parameters, parameters.spacing(), random),
            grid: Grid::default(),
            neighbours: Neighbours::default(),
            number_density: NumberDensity::default(),
            interactions: Interactions::default(),
            vorticity_confinement: VorticityConfinement::default(),
            embers: Embers::default(),
            discretisation: Discretisation::of(parameters),
            air: parameters.ambient_temperature,
            motion: Motion::default(),
            power: 0.0,
            preheat: 0.0,
            clamped_shifts: 0,
            length: 0.0,
        }
    }

    /// Continues from the particles and embers of a fire whose `max_particles` was `made_with`.
    /// If this fire's is different, the gas is resampled.
    pub fn resume(
        &mut self,
        particles: &[Particle],
        embers: Vec<Ember>,
        made_with: u32,
        parameters: &Parameters,
        random: &mut Random,
    ) {
        self.set_particles(particles, parameters);
        self.embers = Embers::of(embers);
        self.discretisation = Discretisation {
            particles: made_with,
            ..Discretisation::of(parameters)
        };
        self.adapt(parameters, random);
    }

    /// All particles, in no particular order.
    pub fn gas(&self) -> &Gas {
        &self.gas
    }

    /// All embers.
    pub fn embers(&self) -> &[Ember] {
        self.embers.alive()
    }

    /// Throws embers from a position; none from outside of the domain.
    pub fn throw_embers(&mut self, place: Vec2, count: u32, values: &Physics, random: &mut Random) {
        if bounds(values).contains(place) {
            self.embers.throw_from(place, count, values, random);
        }
    }

    /// Power of the combustion in the last step [kW/m].
    pub fn power(&self) -> f32 {
        self.power
    }

    /// Writes the embers for the renderer.
    pub fn write_embers(&self, out: &mut Vec<Instance>) {
        self.embers.write_instances(out);
    }
}

impl Solver for Combustion {
    fn step(
        &mut self,
        scene: &Scene,
        random: &mut Random,
        time: f64,
        user: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f64 {
        let parameters = scene.settings();
        let values: &Physics = parameters;
        let kernel = Kernel::new(parameters.smoothing_length());
        let sound = sound_speed(values, scene.power());
        let bounds = bounds(values);
        let gas = &mut self.gas;

        let grid = &mut self.grid;
        let positions = gas.position.iter().copied();
        let new_indices = grid.sort(positions, &bounds, kernel.support());
        gas.reorder(new_indices);
        on_stage(Stage::Sort);
        let context = Context {
            kernel: &kernel,
            values,
            sound,
            mass: gas.mass,
        };
        let neighbours = &mut self.neighbours;
        self.number_density.sum(gas, grid, neighbours, &context);
        on_stage(Stage::Density);
        self.interactions.sum(gas, grid, neighbours, &context);
        let (packed, strength) = (self.interactions.packed(), values.vorticity_confinement);
        let confinement = &mut self.vorticity_confinement;
        confinement.add(gas, grid, neighbours, packed, &kernel, strength);
        forces::add_all(gas, values, time, user);
        on_stage(Stage::Forces);

        let dt = time_step::max_stable_step(gas, values, kernel.smoothing_length(), sound);
        let air = Air {
            gas,
            grid: &self.grid,
            bounds: &bounds,
            kernel: &kernel,
        };
        self.embers.drift(&air, values, random, dt);
        self.motion = time_step::accelerate(gas, sound, dt);
        let hottest = scene.sources().map(|source| source.source_temperature);
        self.power = chemistry::react(gas, values, hottest.fold(0.0, f32::max), dt);
        self.preheat = 0.0;
        for source in scene.sources() {
            if let Some(burner) = Burner::new(source, parameters.spacing()) {
                self.preheat += burner.feed(gas, source, time, dt) / dt;
            }
        }
        seam::relax_to_air(gas, values, parameters.spacing(), dt);
        let (h, max_speed) = (kernel.smoothing_length(), self.motion.max_speed);
        self.clamped_shifts = time_step::advance(gas, &bounds, values.shifting, h, max_speed, dt);
        self.length = dt;
        on_stage(Stage::Integrate);
        f64::from(dt)
    }

    /// Resamples the gas if the domain or the number of particles changed.
    fn adapt(&mut self, parameters: &Parameters, random: &mut Random) {
        let discretisation = Discretisation::of(parameters);
        // A new air temperature changes all gas at once; otherwise all of the old air would rise
        // or sink.
        let difference = parameters.ambient_temperature - self.air;
        if difference != 0.0 {
            self.gas.add_temperature(difference);
            self.air = parameters.ambient_temperature;
        }
        if discretisation != self.discretisation {
            self.gas = resample::resample(&self.gas, &self.discretisation, parameters, random);
            self.discretisation = discretisation;
        }
        self.gas.set_mass(parameters);
    }

    fn set_particles(&mut self, particles: &[Particle], values: &Physics) {
        self.gas = Gas::of(particles, values);
        self.embers = Embers::default();
        self.motion = Motion::default();
        (self.power, self.preheat, self.length) = (0.0, 0.0, 0.0);
    }

    fn broken_count_rule(&self, count: usize, values: &Physics) -> Option<&'static str> {
        // The smoothing length follows `max_particles`.
        let expected = values.max_particles as usize;
        let allowed = expected.div_ceil(2)..=2 * expected;
        (!allowed.contains(&count)).then_some(WRONG_COUNT)
    }

    fn bounds(&self, values: &Physics) -> Bounds {
        bounds(values)
    }

    fn sound_speed(&self, scene: &Scene) -> f32 {
        sound_speed(scene.settings(), scene.power())
    }

    /// Length of the last step, or an estimate of the first \[s\].
    fn step_length(&self, scene: &Scene) -> f64 {
        f64::from(if self.length > 0.0 {
            self.length
        } else {
            let parameters = scene.settings();
            let h = parameters.smoothing_length();
            time_step::max_stable_step(&self.gas, parameters, h, self.sound_speed(scene))
        })
    }

    fn report(&self, _values: &Physics) -> StepReport {
        let (mean_neighbours, max_neighbours) = self.neighbours.mean_and_max();
        StepReport {
            substeps: 1,
            mean_neighbours,
            max_neighbours,
            speed_limited: self.motion.speed_limited,
            clamped: self.motion.speed_limited + self.clamped_shifts,
            max_speed: self.motion.max_speed,
            length: self.length,
            power: self.power,
            preheat: self.preheat,
        }
    }

    fn count(&self) -> usize {
        self.gas.len()
    }

    fn by_id(&self) -> Vec<usize> {
        self.gas.by_id()
    }

    fn id(&self, i: usize) -> u64 {
        self.gas.id[i].into()
    }

    fn particle(&self, i: usize, time: f64) -> Particle {
        self.gas.particle(i, time)
    }

    fn density(&self, i: usize) -> f32 {
        self.gas.mass / self.gas.volume[i]
    }

    fn pressure(&self, i: usize) -> f32 {
        self.gas.pressure[i]
    }

    fn write_fire(&self, out: &mut Vec<Instance>) {
        let gas = &self.gas;
        out.extend((0..gas.len()).filter_map(|i| {
            let [temperature, _, _, soot] = gas.state[i].to_array();
            let visible = temperature > VISIBLE_TEMPERATURE || soot > VISIBLE_SOOT;
            visible.then(|| {
                Instance::from(GasParticle {
                    position: gas.position[i],
                    velocity: gas.velocity[i],
                    temperature,
                    volume: gas.volume[i],
                    soot,
                    burn_rate: gas.burn[i],
                })
            })
        }));
    }

    // Inlined into a loop, it becomes a loop per mode.
    #[inline(never)]
    fn measured(&self, i: usize, _values: &Physics, mode: DisplayMode) -> Measured {
        let gas = &self.gas;
        let [temperature, fuel, _, soot] = gas.state[i].to_array();
        let value = match mode {
            DisplayMode::Particles | DisplayMode::Temperature => temperature,
            DisplayMode::Density => self.density(i),
            DisplayMode::Pressure => gas.pressure[i],
            DisplayMode::Velocity => gas.velocity[i].length(),
            DisplayMode::Fuel => fuel,
            DisplayMode::Soot | DisplayMode::Sprites => soot,
            _ => 0.0,
        };
        Measured {
            position: gas.position[i],
            velocity: gas.velocity[i],
            temperature,
            volume: gas.volume[i],
            number: numbered(gas.id[i].into(), mode),
            value,
        }
    }
}
