//! The combustion model: air in the open or in a closed domain, and burners and solids in it.
//!
//! Fuel flows in, mixes and burns, and the hot gas rises. Nothing is scripted: the taper, flicker
//! and puffing of the flame follow from the equations. One step is: births and deaths of open air
//! → neighbour grid → number density and pressure → pair interactions → vorticity confinement →
//! body forces → time step → embers → velocity → combustion → burners → seam of a closed domain →
//! position → water.

mod charred;
mod fuels;
mod gas;
mod open_air;
mod reaction;
mod readers;
mod step;
mod water;

use crate::bounds::Bounds;
use crate::forces::BodyForce;
use crate::grid::Grid;
use crate::instance::{Instance, Measured};
use crate::neighbours::Neighbours;
use crate::params::{DisplayMode, Edges, Physics};
use crate::particle::Particle;
use crate::random::Random;
use crate::report::{Stage, StepReport};
use crate::scene::Scene;
use crate::simulation::burning::SavedFire;
use crate::solids::Solids;
use crate::solids::free::FreeBodies;
use crate::solver::Solver;

pub use charred::{Charred, CharredSolid};
use fuels::Fuels;
pub use fuels::{BurningSolid, BurningState, FuelTotal, IgniteError, IgnitionTarget};
pub(crate) use gas::Gas;
use gas::interactions::Interactions;
use gas::number_density::NumberDensity;
use gas::periodic_bounds;
pub use gas::removed::RemovedGas;
pub(crate) use gas::resample::Discretisation;
use gas::resample::{self, Old};
pub(crate) use gas::time_step::sound_speed;
use gas::time_step::{self, Motion};
use gas::vorticity_confinement::VorticityConfinement;
use gas::walls::Walls;
use open_air::OpenAir;
pub(crate) use open_air::Seen;
pub use reaction::burner::Burner;
use reaction::burner::BurnerParticle;
pub use reaction::embers::Ember;
use reaction::embers::Embers;
use water::Water;
pub use water::{Droplets, SprayError, SprayTotals};

/// The errors for a number of particles that does not match the smoothing length, and for one
/// that open air cannot hold.
const WRONG_COUNT: &str = "there must be from half to twice max_particles of them";
const TOO_MANY: &str = "there must be at most max_particles of them";

/// The rectangle that holds the gas of a fire with these values and this discretisation, whatever is
/// seen.
pub(crate) fn bounds(values: &Physics, discretisation: Discretisation) -> Bounds {
    match discretisation {
        Discretisation::Open { spacing } => open_air::layout(values, None, spacing).bounds(),
        Discretisation::Periodic { .. } => periodic_bounds(values),
    }
}

/// The gas of the combustion model and the state of its solver.
#[derive(Clone, Debug)]
pub(crate) struct Combustion {
    gas: Gas,
    /// The edges of open air; `None` in a closed domain.
    open: Option<Box<OpenAir>>,
    /// The part of the world that is seen.
    seen: Option<Seen>,
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
    solids: Solids,
    walls: Walls,
    /// The particles at a burner.
    burner_particles: Vec<BurnerParticle>,
    removed: RemovedGas,
    /// The solids that burn.
    fuels: Option<Box<Fuels>>,
    /// What has been sprayed.
    water: Option<Box<Water>>,
    /// Power of the combustion in the last step, and of the heating at the sources [kW/m].
    power: f32,
    preheat: f32,
    /// Particles whose shift was clamped.
    clamped_shifts: u32,
    length: f32,
}

impl Combustion {
    /// Air at rest, or in the wind.
    pub fn new(scene: &Scene, random: &mut Random) -> Combustion {
        let parameters = scene.settings();
        let mut open = OpenAir::new(parameters, None);
        let bounds = open.as_ref().map(|open| open.bounds());
        let bounds = bounds.unwrap_or_else(|| periodic_bounds(parameters));
        let solids = Solids::of(scene, &bounds, 2.0 * parameters.smoothing_length());
        let gas = match &mut open {
            None => Gas::air(parameters, parameters.spacing(), random),
            Some(open) => open.air(scene, &solids),
        };
        let mut combustion = Combustion {
            gas,
            open,
            seen: None,
            grid: Grid::default(),
            neighbours: Neighbours::default(),
            number_density: NumberDensity::default(),
            interactions: Interactions::default(),
            vorticity_confinement: VorticityConfinement::default(),
            embers: Embers::default(),
            discretisation: Discretisation::of(parameters),
            air: parameters.ambient_temperature,
            motion: Motion::default(),
            solids,
            walls: Walls::default(),
            burner_particles: Vec::new(),
            removed: RemovedGas::default(),
            fuels: None,
            water: None,
            power: 0.0,
            preheat: 0.0,
            clamped_shifts: 0,
            length: 0.0,
        };
        combustion.set_fuels(scene);
        combustion.settle_lattice(parameters);
        combustion.reserve(parameters);
        combustion
    }

    /// Makes room for all particles that open air may have, so that births allocate nothing.
    fn reserve(&mut self, values: &Physics) {
        let capacity = self.capacity(values);
        gas::make_room(&mut self.burner_particles, capacity);
        if self.open.is_some() || !self.solids.is_empty() {
            self.walls.reserve(self.capacity(values));
        }
        if let Some(fuels) = &mut self.fuels {
            fuels.reserve(capacity);
        }
        let Some(open) = &self.open else {
            return;
        };
        let (capacity, reach) = (
            values.max_particles as usize,
            2.0 * values.smoothing_length(),
        );
        self.gas.reserve(capacity);
        self.grid.reserve(capacity, &open.bounds(), reach);
        let blocks = self.grid.max_blocks(capacity);
        self.number_density.reserve(blocks);
        self.interactions.reserve(blocks);
        self.vorticity_confinement.reserve(blocks);
    }

    /// Sets which part of the world is seen: open air reaches beyond it.
    pub fn see(&mut self, seen: Option<Seen>, scene: &Scene) {
        self.seen = seen;
        self.fit_open_air(scene);
        self.reserve(scene.settings());
    }

    /// Replaces the map of open air if the values, or what is seen, need another.
    fn fit_open_air(&mut self, scene: &Scene) {
        let values = scene.settings();
        let fits = |open: &OpenAir| open.fits(values, self.seen);
        if self.open.as_deref().is_some_and(fits) {
            return;
        }
        let old = std::mem::replace(&mut self.open, OpenAir::new(values, self.seen));
        if let Some(open) = &mut self.open {
            match old {
                Some(old) if open.has_cells_of(&old) => open.continue_from(&old),
                Some(_) => open.surround(&self.gas, values),
                None => open.adopt(&self.gas, scene, &self.solids),
            }
        }
    }

    /// Continues from a saved fire. If its discretisation is not this fire's, the gas is resampled.
    pub fn resume(&mut self, saved: SavedFire<'_>, scene: &Scene, random: &mut Random, time: f64) {
        // A saved fire does not hold what solids with fuel have lost.
        self.fuels = None;
        // The solids first: the gas of the particles is around them.
        self.place_solids(scene, time);
        self.resume_bodies(saved.bodies);
        self.set_particles(saved.particles, scene.settings());
        self.embers = Embers::of(saved.embers);
        self.discretisation = saved.discretisation;
        self.adapt(scene, random, time);
        // A change of the scene wakes them.
        self.resume_bodies(saved.bodies);
    }

    fn resume_bodies(&mut self, numbers: &[f32]) {
        if self.solids.free.is_some() {
            FreeBodies::resume(&mut self.solids, numbers);
        }
    }

    /// The division of the present gas into particles.
    pub fn discretisation(&self) -> Discretisation {
        self.discretisation
    }

    /// Moves the solids to where they are in a scene at a time \[s\].
    fn place_solids(&mut self, scene: &Scene, time: f64) {
        let values = scene.settings();
        let bounds = self.present_bounds(values);
        let support = 2.0 * values.smoothing_length();
        self.solids.update(scene, time, &bounds, support);
        self.set_fuels(scene);
    }

    /// Gives the solids that burn their cells.
    fn set_fuels(&mut self, scene: &Scene) {
        if self.fuels.is_some() || scene.has_fuel() {
            Fuels::set(&mut self.fuels, scene, &mut self.solids);
        }
    }

    /// Total power of the sources and of the solids that burn [kW/m].
    fn total_power(&self, scene: &Scene) -> f32 {
        let burning = self.fuels.as_ref().map_or(0.0, |fuels| fuels.power());
        scene.power() + burning
    }

    /// The rectangle of the gas at present.
    fn present_bounds(&self, values: &Physics) -> Bounds {
        let open = self.open.as_ref();
        open.map_or_else(|| periodic_bounds(values), |open| open.bounds())
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
        f64::from(self.make_step(scene, random, time, user, on_stage))
    }

    /// Resamples the gas if the domain or the spacing of the particles changed.
    fn adapt(&mut self, scene: &Scene, random: &mut Random, time: f64) {
        let parameters = scene.settings();
        // A new air temperature changes all gas at once; otherwise all of the old air would rise
        // or sink.
        let difference = parameters.ambient_temperature - self.air;
        if difference != 0.0 {
            self.gas.add_temperature(difference);
            self.air = parameters.ambient_temperature;
        }
        let discretisation = Discretisation::of(parameters);
        if discretisation != self.discretisation {
            self.open = None;
        }
        self.fit_open_air(scene);
        let resampled = discretisation != self.discretisation;
        if resampled {
            let old = (&self.gas, &self.solids);
            let old = Old::new(old, &self.discretisation, parameters, self.seen);
            self.gas = match &self.open {
                None => resample::resample(&old, parameters, random),
                Some(open) => resample::resample_open(&old, parameters, open),
            };
            self.discretisation = discretisation;
        }
        self.gas.set_mass(parameters);
        self.place_solids(scene, time);
        if resampled {
            self.settle_lattice(parameters);
        }
        self.settle(parameters, parameters.spacing());
        self.reserve(parameters);
    }

    fn set_particles(&mut self, particles: &[Particle], values: &Physics) {
        self.gas = Gas::of(particles, values);
        if let Some(open) = &mut self.open {
            open.surround(&self.gas, values);
        }
        self.leave_out_solids(values);
        self.settle(values, values.spacing());
        self.reserve(values);
        self.embers = Embers::default();
        self.motion = Motion::default();
        (self.power, self.preheat, self.length) = (0.0, 0.0, 0.0);
    }

    fn broken_count_rule(&self, count: usize, values: &Physics) -> Option<&'static str> {
        let most = values.max_particles as usize;
        match values.edges {
            Edges::Open => (count > most).then_some(TOO_MANY),
            Edges::Periodic => {
                // The smoothing length follows `max_particles`.
                let allowed = most.div_ceil(2)..=2 * most;
                (!allowed.contains(&count)).then_some(WRONG_COUNT)
            }
        }
    }

    fn bounds(&self, values: &Physics) -> Bounds {
        self.present_bounds(values)
    }

    fn solids(&self) -> &Solids {
        &self.solids
    }

    fn sound_speed(&self, scene: &Scene) -> f32 {
        sound_speed(scene.settings(), self.total_power(scene))
    }

    /// Length of the last step, or an estimate of the first: that of air at rest \[s\].
    fn step_length(&self, scene: &Scene) -> f64 {
        f64::from(if self.length > 0.0 {
            self.length
        } else {
            let h = scene.settings().smoothing_length();
            time_step::step_at_rest(h, self.sound_speed(scene))
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
            power: Some(self.power),
            preheat: Some(self.preheat),
            asleep: self.open.as_ref().map(|open| open.asleep()),
        }
    }

    fn count(&self) -> usize {
        self.gas.len()
    }

    fn capacity(&self, values: &Physics) -> usize {
        match self.open {
            Some(_) => values.max_particles as usize,
            None => self.count(),
        }
    }

    fn by_id(&self) -> Vec<usize> {
        self.gas.by_id()
    }

    fn id(&self, i: usize) -> u64 {
        self.gas.id[i]
    }

    fn particle(&self, i: usize, time: f64) -> Particle {
        self.gas.particle(i, time)
    }

    fn density(&self, i: usize) -> f32 {
        self.gas.density(i)
    }

    fn pressure(&self, i: usize) -> f32 {
        self.gas.pressure[i]
    }

    fn write_fire(&self, out: &mut Vec<Instance>) {
        self.gas.write_visible(out);
    }

    fn measured(&self, i: usize, _values: &Physics, mode: DisplayMode) -> Measured {
        self.gas.measured(i, mode)
    }
}
