//! The combustion model: air in the open or in a closed domain, and burners and solids in it.
//!
//! Fuel flows in, mixes and burns, and the hot gas rises. Nothing is scripted: the taper, flicker
//! and puffing of the flame follow from the equations. One step is: births and deaths of open air
//! → neighbour grid → number density and pressure → rolls → pair interactions → vorticity
//! confinement → body forces → time step → embers → solids that burn → two [parts](gas::time_step::PARTS) → water.
//! A part is: pressure where the gas is now → velocity → combustion → burners → seam of a closed domain → position.

mod charred;
mod domain;
mod fires;
mod fuels;
mod gas;
mod obstacles;
mod open_air;
mod reaction;
mod readers;
mod step;
mod water;

use crate::bounds::Bounds;
use crate::forces::BodyForce;
use crate::instance::{Instance, Measured};
use crate::params::{DisplayMode, Edges, Physics};
use crate::particle::Particle;
use crate::random::Random;
use crate::report::{Stage, StepReport};
use crate::scene::Scene;
use crate::series::{POPS, SPARKS, STEAM, Totals};
use crate::solids::Solids;
use crate::solids::free::FreeBodies;
use crate::solver::Solver;

pub use charred::{Charred, CharredSolid};
use domain::Domain;
pub(crate) use domain::bounds;
use fires::Fires;
use fuels::Fuels;
pub use fuels::{BurningSolid, BurningState, FuelTotal, IgniteError, IgnitionTarget};
pub(crate) use gas::Gas;
use gas::pairs::Pairs;
pub use gas::removed::RemovedGas;
pub(crate) use gas::resample::Discretisation;
pub(crate) use gas::time_step::sound_speed;
use gas::time_step::{self, Motion};
use obstacles::Obstacles;
pub(crate) use open_air::Seen;
use reaction::Reaction;
pub use reaction::burner::Burner;
pub use reaction::embers::Ember;
use reaction::embers::Embers;
use water::Water;
pub use water::{Droplets, SprayError, SprayTotals};

/// The errors for a number of particles that does not match the smoothing length, and for one
/// that open air cannot hold.
const WRONG_COUNT: &str = "there must be from half to twice particles of them";
const TOO_MANY: &str = "there must be at most max_particles of them";

/// What a fire continues from.
pub(crate) struct SavedFire<'a> {
    /// The gas.
    pub particles: &'a [Particle],
    /// The division of the gas into these particles.
    pub discretisation: Discretisation,
    /// The embers.
    pub embers: Vec<Ember>,
    /// The numbers of each free solid, one after another.
    pub bodies: &'a [f32],
}

/// The gas of the combustion model and the state of its solver.
#[derive(Clone, Debug)]
pub(crate) struct Combustion {
    gas: Gas,
    domain: Domain,
    pairs: Pairs,
    fires: Fires,
    obstacles: Obstacles,
    reaction: Reaction,
    motion: Motion,
    /// The solids that burn.
    fuels: Option<Box<Fuels>>,
    /// What has been sprayed.
    water: Option<Box<Water>>,
}

crate::state! { Combustion: gas domain pairs fires obstacles reaction motion fuels water }

impl Combustion {
    /// Air at rest, or in the wind.
    pub fn new(scene: &Scene, random: &mut Random) -> Combustion {
        let values = scene.world();
        let mut domain = Domain::new(values);
        let bounds = domain.bounds(values);
        let solids = Solids::of(scene, &bounds, 2.0 * values.smoothing_length());
        let mut combustion = Combustion {
            gas: domain.air(scene, &solids, random),
            domain,
            pairs: Pairs::default(),
            fires: Fires::default(),
            obstacles: Obstacles {
                solids,
                ..Obstacles::default()
            },
            reaction: Reaction::default(),
            motion: Motion::default(),
            fuels: None,
            water: None,
        };
        combustion.set_fuels(scene);
        combustion.displace_lattice(values);
        combustion.reserve(values);
        combustion
    }

    /// Makes room for all particles that open air may have, so that births allocate nothing.
    fn reserve(&mut self, values: &Physics) {
        let capacity = self.capacity(values);
        self.reaction.reserve(capacity);
        if self.domain.is_open() || !self.obstacles.solids.is_empty() {
            self.obstacles.walls.reserve(capacity);
        }
        if let Some(fuels) = self.fuels.as_mut() {
            fuels.reserve(capacity);
        }
        if self.domain.is_open() {
            let support = 2.0 * values.smoothing_length();
            self.gas.reserve(capacity);
            self.pairs
                .reserve(capacity, &self.domain.bounds(values), support);
        }
    }

    /// Sets which part of the world is seen: open air reaches beyond it.
    pub fn set_visible_area(&mut self, seen: Option<Seen>, scene: &Scene) {
        self.domain
            .set_visible_area(seen, &self.gas, scene, &self.obstacles.solids);
        self.reserve(scene.world());
    }

    /// Continues from a saved fire. If its discretisation is not this fire's, the gas is resampled.
    pub fn resume(&mut self, saved: SavedFire<'_>, scene: &Scene, random: &mut Random, time: f64) {
        // A saved fire does not hold what solids with fuel have lost.
        self.fuels = None;
        // The solids first: the gas of the particles is around them.
        self.place_solids(scene, time);
        self.resume_bodies(saved.bodies);
        self.set_particles(saved.particles, scene.world());
        self.reaction.embers = Embers::of(saved.embers);
        self.domain.discretisation = saved.discretisation;
        self.adapt(scene, random, time);
        // A change of the scene wakes them.
        self.resume_bodies(saved.bodies);
    }

    fn resume_bodies(&mut self, numbers: &[f32]) {
        if self.obstacles.solids.free.is_some() {
            FreeBodies::resume(&mut self.obstacles.solids, numbers);
        }
    }

    /// The division of the present gas into particles.
    pub fn discretisation(&self) -> Discretisation {
        self.domain.discretisation
    }

    /// Moves the solids to where they are in a scene at a time \[s\].
    fn place_solids(&mut self, scene: &Scene, time: f64) {
        let values = scene.world();
        let bounds = self.domain.bounds(values);
        let support = 2.0 * values.smoothing_length();
        let solids = &mut self.obstacles.solids;
        solids.update(scene, time, &bounds, support);
        self.set_fuels(scene);
    }

    /// Gives the solids that burn their cells.
    fn set_fuels(&mut self, scene: &Scene) {
        if self.fuels.is_some() || scene.has_fuel() {
            Fuels::set(&mut self.fuels, scene, &mut self.obstacles.solids);
        }
    }

    fn displace_lattice(&mut self, values: &Physics) {
        let (gas, domain) = (&mut self.gas, &self.domain);
        self.obstacles.displace_lattice(gas, domain, values);
    }

    fn displace_gas(&mut self, values: &Physics) {
        let (gas, domain) = (&mut self.gas, &self.domain);
        self.obstacles
            .displace(gas, domain, values, values.spacing());
    }

    /// Total power of the sources and of the solids that burn [kW/m].
    fn total_power(&self, scene: &Scene) -> f32 {
        let burning = self.fuels.as_ref().map_or(0.0, |fuels| fuels.power());
        scene.power() + burning
    }
}

impl Solver for Combustion {
    fn step(
        &mut self,
        scene: &Scene,
        random: &mut Random,
        times: (f64, f64),
        user: Option<&dyn BodyForce>,
        on_stage: &mut dyn FnMut(Stage),
    ) -> f64 {
        f64::from(self.make_step(scene, random, times, user, on_stage))
    }

    /// Resamples the gas if the domain or the spacing of the particles changed.
    fn adapt(&mut self, scene: &Scene, random: &mut Random, time: f64) {
        let (gas, solids) = (&mut self.gas, &self.obstacles.solids);
        let resampled = self.domain.adapt(gas, scene, solids, random);
        self.place_solids(scene, time);
        let values = scene.world();
        if resampled {
            self.displace_lattice(values);
        }
        self.displace_gas(values);
        self.reserve(values);
    }

    fn set_particles(&mut self, particles: &[Particle], values: &Physics) {
        self.gas = Gas::of(particles, values);
        self.domain.surround(&self.gas, values);
        self.obstacles
            .leave_out(&mut self.gas, &self.domain, values);
        self.displace_gas(values);
        self.reserve(values);
        self.motion = Motion::default();
        self.pairs.rolls.restart();
        self.reaction.extinguish();
    }

    fn broken_count_rule(&self, count: usize, values: &Physics) -> Option<&'static str> {
        let most = values.capacity() as usize;
        match values.edges {
            Edges::Open => (count > most).then_some(TOO_MANY),
            Edges::Periodic => {
                // The smoothing length follows `particles`.
                let allowed = most.div_ceil(2)..=2 * most;
                (!allowed.contains(&count)).then_some(WRONG_COUNT)
            }
        }
    }

    fn bounds(&self, values: &Physics) -> Bounds {
        self.domain.bounds(values)
    }

    fn solids(&self) -> &Solids {
        &self.obstacles.solids
    }

    fn sound_speed(&self, scene: &Scene) -> f32 {
        sound_speed(scene.world(), self.total_power(scene))
    }

    /// Length of the last step, or an estimate of the first: that of air at rest \[s\].
    fn step_length(&self, scene: &Scene) -> f64 {
        f64::from(if self.motion.length > 0.0 {
            self.motion.length
        } else {
            let h = scene.world().smoothing_length();
            time_step::step_at_rest(h, self.sound_speed(scene))
        })
    }

    fn report(&self, _values: &Physics) -> StepReport {
        let (mean_neighbours, max_neighbours) = self.pairs.mean_and_max_neighbours();
        StepReport {
            substeps: time_step::PARTS as u32,
            mean_neighbours,
            max_neighbours,
            speed_limited: self.motion.speed_limited,
            clamped: self.motion.speed_limited + self.motion.clamped_shifts,
            max_speed: self.motion.max_speed,
            length: self.motion.length,
            power: Some(self.reaction.power),
            preheat: Some(self.reaction.preheat),
            asleep: self.domain.asleep(),
        }
    }

    fn totals(&self) -> Totals {
        let mut totals = Totals::default();
        let embers = &self.reaction.embers;
        (totals.grown[SPARKS], totals.moment) = embers.thrown;
        totals.grown[POPS] = embers.popped;
        if let Some(fuels) = self.fuels.as_ref() {
            fuels.add_totals(&self.obstacles.solids, &mut totals);
        }
        if let Some(water) = self.water.as_ref() {
            totals.grown[STEAM] = water.steamed();
        }
        totals
    }

    fn count(&self) -> usize {
        self.gas.len()
    }

    fn capacity(&self, values: &Physics) -> usize {
        if self.domain.is_open() {
            values.capacity() as usize
        } else {
            self.count()
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
