//! Steam as pictures show it: puffs that the gas carries, that grow and fade.
//!
//! Vapour is transparent. Where it mixes with cool air it condenses to fog, which is white, so a puff
//! shows as far as the gas around it is cool.

use glam::Vec2;

use super::around::Around;
use crate::extremes::{fast_max, fast_min};
use crate::instance::{EmberParticle, Instance};
use crate::random::Random;

/// Most puffs.
const MAX_PUFFS: usize = 800;
/// Steam of a puff, in shares of a parcel.
const PARCELS_PER_PUFF: f32 = 0.12;
/// Age at which a puff has faded \[s\].
const MAX_AGE: f32 = 1.8;
/// Width of a puff at first and its growth over its life, in heights of the domain.
const BIRTH_WIDTH: f32 = 0.05;
const WIDTH_GROWTH: f32 = 0.16;
/// Speed at which it rises without gas [m/s].
const RISE_SPEED: f32 = 0.3;
/// Age at which it shows fully \[s\].
const APPEARANCE_TIME: f32 = 0.15;
/// Brightness of a new puff.
const BRIGHTNESS: f32 = 0.22;
/// Temperatures of the gas between which it condenses \[K\].
const FOG_TEMPERATURE: f32 = 340.0;
const CLEAR_TEMPERATURE: f32 = 900.0;

/// A puff.
#[derive(Clone, Copy, Debug)]
struct Puff {
    position: Vec2,
    age: f32,
    life: f32,
    width: f32,
    condensed: f32,
}

/// All puffs.
#[derive(Clone, Debug, Default)]
pub(super) struct Steam {
    puffs: Vec<Puff>,
    /// Steam that has not become a puff yet, in puffs.
    due: f32,
}

crate::state! { Puff: position age life width condensed, Steam: puffs due }

impl Steam {
    /// Makes room for all puffs.
    pub fn reserve(&mut self) {
        let more = MAX_PUFFS.saturating_sub(self.puffs.len());
        self.puffs.reserve(more);
    }

    /// Adds steam from a place, in parcels.
    pub fn rise(&mut self, place: Vec2, parcels: f32, random: &mut Random) {
        self.due = fast_min(self.due + parcels / PARCELS_PER_PUFF, 4.0);
        if self.due < 1.0 {
            return;
        }
        self.due -= 1.0;
        if self.puffs.len() < MAX_PUFFS {
            self.puffs.push(Puff {
                position: place,
                age: 0.0,
                life: MAX_AGE * random.between(0.5, 1.0),
                width: 0.0,
                condensed: 0.0,
            });
        }
    }

    /// Carries all puffs for a step.
    pub fn drift(&mut self, around: &mut Around) {
        let (dt, height) = (around.dt, around.values.domain_height);
        for puff in &mut self.puffs {
            let still = (
                Vec2::new(around.values.wind, RISE_SPEED),
                around.values.ambient_temperature,
            );
            let (velocity, kelvin) = around.gas_at(puff.position).unwrap_or(still);
            puff.position += velocity * dt;
            puff.age += dt;
            puff.width = height * (BIRTH_WIDTH + WIDTH_GROWTH * puff.age / MAX_AGE);
            let condensed = (CLEAR_TEMPERATURE - kelvin) / (CLEAR_TEMPERATURE - FOG_TEMPERATURE);
            puff.condensed = fast_min(fast_max(condensed, 0.0), 1.0);
        }
        self.puffs.retain(|puff| puff.age < puff.life);
    }

    /// Writes the instances for the renderer.
    pub fn write_instances(&self, out: &mut Vec<Instance>) {
        out.extend(self.puffs.iter().map(|puff| {
            let fades = 1.0 - puff.age / puff.life;
            let appears = fast_min(puff.age / APPEARANCE_TIME, 1.0);
            Instance::from(EmberParticle {
                position: puff.position,
                velocity: Vec2::ZERO,
                temperature: -2.0,
                size: puff.width,
                age: BRIGHTNESS * fades * appears * puff.condensed,
                life: 1.0,
            })
        }));
    }
}
