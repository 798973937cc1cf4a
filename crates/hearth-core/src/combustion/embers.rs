//! Embers: sparks that the fire throws and its flow carries.
//!
//! They are the paper's lifetime emitter at work in a domain full of air: each
//! is born in the flames with a life of its own, follows the gas around it as
//! far as its weight allows, cools by radiation and dies.

use glam::Vec2;

use super::gas::Gas;
use crate::bounds::Bounds;
use crate::grid::Grid;
use crate::instance::{EmberParticle, Instance};
use crate::kernel::Kernel;
use crate::params::Physics;
use crate::random::Random;

/// A spark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ember {
    /// Position \[m\].
    pub position: Vec2,
    /// Velocity [m/s].
    pub velocity: Vec2,
    /// Temperature \[K\].
    pub temperature: f32,
    /// Diameter \[m\].
    pub size: f32,
    /// Time since birth \[s\].
    pub age: f32,
    /// Age at which it dies \[s\].
    pub lifetime: f32,
}

/// Temperature at birth \[K\].
const GLOW: f32 = 1750.0;
/// Gas hotter than this throws embers \[K\].
const FLAMES: f32 = 900.0;
/// Time in which an ember of 4 mm takes on the speed of the gas around it \[s\];
/// larger ones take longer. In the air they sink at g times this.
const FOLLOWS: f32 = 0.035;
const FOLLOWS_AT: f32 = 0.004;
/// Speed at which embers are thrown, at most, besides that of the gas [m/s].
const THROWN: f32 = 0.8;
/// The same of embers that somebody throws, up and to each side.
const THROWN_BY_HAND: Vec2 = Vec2::new(0.9, 2.2);
/// Most embers that fly where somebody throws some.
const MOST: usize = 4000;
/// Sizes go from this part of the parameter to all of it.
const SMALLEST: f32 = 0.4;
/// Longest time whose births may wait for flames \[s\].
const PATIENCE: f32 = 1.0 / 30.0;

/// All embers that glow.
#[derive(Clone, Debug, Default)]
pub(crate) struct Embers {
    alive: Vec<Ember>,
    /// Births that are due and have not happened.
    owed: f32,
}

impl Embers {
    /// These.
    pub fn of(alive: Vec<Ember>) -> Embers {
        Embers { alive, owed: 0.0 }
    }

    pub fn alive(&self) -> &[Ember] {
        &self.alive
    }

    /// Lets embers be born, drift, cool and die for `dt` in the air around them.
    pub fn drift(&mut self, air: &Air, values: &Physics, random: &mut Random, dt: f32) {
        self.throw(air.gas, values, random, dt);
        for ember in &mut self.alive {
            let flow = air.velocity_at(ember.position);
            let follows = FOLLOWS * (ember.size / FOLLOWS_AT);
            // Implicit, so that even a speck that follows at once is stable.
            let weight = Vec2::new(0.0, -values.gravity);
            let share = dt / follows;
            ember.velocity = (ember.velocity + flow * share + weight * dt) / (1.0 + share);
            ember.position += ember.velocity * dt;
            ember.age += dt;
            let relative = ember.temperature / 1500.0;
            let lost = values.radiative_cooling * relative * relative * relative * relative * dt;
            ember.temperature = (ember.temperature - lost).max(values.ambient_temperature);
        }
        // What flies out of the picture is gone; it does not come in below.
        self.alive
            .retain(|ember| ember.age < ember.lifetime && air.bounds.hold(ember.position));
    }

    fn throw(&mut self, gas: &Gas, values: &Physics, random: &mut Random, dt: f32) {
        let patience = 1.0 + values.ember_rate * PATIENCE;
        self.owed = (self.owed + values.ember_rate * dt).min(patience);
        if values.ember_rate == 0.0 {
            self.owed = 0.0;
        }
        while self.owed >= 1.0 {
            let Some(i) = flames(gas, random) else {
                return;
            };
            let aside = random.between(-0.5, 0.5);
            let thrown = Vec2::new(aside, random.unit()) * THROWN;
            self.bear(gas.position[i], gas.velocity[i] + thrown, values, random);
            self.owed -= 1.0;
        }
    }

    /// Throws so many from a place, or as many as there may be.
    pub fn throw_from(&mut self, place: Vec2, count: u32, values: &Physics, random: &mut Random) {
        let room = MOST.saturating_sub(self.alive.len());
        for _ in 0..room.min(count as usize) {
            let way = Vec2::new(random.between(-1.0, 1.0), random.unit());
            self.bear(place, way * THROWN_BY_HAND, values, random);
        }
    }

    fn bear(&mut self, position: Vec2, velocity: Vec2, values: &Physics, random: &mut Random) {
        let longest = values.ember_life_max.max(values.ember_life_min);
        self.alive.push(Ember {
            position,
            velocity,
            temperature: GLOW,
            size: values.ember_size * random.between(SMALLEST, 1.0),
            age: 0.0,
            lifetime: random.between(values.ember_life_min, longest),
        });
    }

    /// Copies out what the renderer needs.
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.extend(self.alive.iter().map(|ember| {
            Instance::from(EmberParticle {
                position: ember.position,
                velocity: ember.velocity,
                temperature: ember.temperature,
                size: ember.size,
                age: ember.age,
                life: 1.0 - ember.age / ember.lifetime,
            })
        }));
    }
}

/// Some particle of the flames, each with the same chance.
fn flames(gas: &Gas, random: &mut Random) -> Option<usize> {
    let flames = || (0..gas.len()).filter(|&i| gas.state[i].x > FLAMES);
    let chosen = (random.unit() * flames().count() as f32) as usize;
    flames().nth(chosen)
}

/// The gas that embers fly in, in the order of the grid.
pub(crate) struct Air<'a> {
    pub gas: &'a Gas,
    pub grid: &'a Grid,
    pub bounds: &'a Bounds,
    pub kernel: &'a Kernel,
}

impl Air<'_> {
    /// Velocity of the gas at a place: the mean of its neighbours by kernel and
    /// volume (Shepard).
    fn velocity_at(&self, at: Vec2) -> Vec2 {
        let (mut sum, mut weights) = (Vec2::ZERO, 0.0);
        self.grid.candidates(at, |run, shift| {
            for j in run {
                let distance = (at - shift).distance(self.gas.position[j]);
                let weight = self.kernel.value(distance) * self.gas.volume[j];
                sum += self.gas.velocity[j] * weight;
                weights += weight;
            }
        });
        if weights > 0.0 {
            sum / weights
        } else {
            Vec2::ZERO
        }
    }
}
