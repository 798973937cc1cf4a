//! A particle as callers put it in and read it out.

use std::fmt;

use glam::Vec2;

use crate::bounds::Bounds;

/// Fastest particle that can be put in [m/s]; what is thousands of times as
/// fast as the gas would not move it but break it.
const FASTEST: f32 = 1000.0;

/// A particle as callers put it in and read it out. What its model does not use stays
/// as it is in air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Position \[m\]; the origin is the middle of the floor, y points up.
    pub position: Vec2,
    /// Velocity [m/s].
    pub velocity: Vec2,
    /// Temperature \[K\].
    pub temperature: f32,
    /// Time since birth \[s\].
    pub age: f32,
    /// Age at which it dies \[s\]; infinite in the combustion model.
    pub lifetime: f32,
    /// Fuel, as a share of the gas that burns if it finds air.
    pub fuel: f32,
    /// Oxygen, as a share of that of fresh air.
    pub oxygen: f32,
    /// Soot, in the amount that a full share of fuel leaves.
    pub soot: f32,
}

impl Particle {
    /// Air of 293 K at rest.
    pub const fn at(position: Vec2) -> Particle {
        Particle {
            position,
            velocity: Vec2::ZERO,
            temperature: 293.0,
            age: 0.0,
            lifetime: f32::INFINITY,
            fuel: 0.0,
            oxygen: 1.0,
            soot: 0.0,
        }
    }

    /// What is wrong with it, where something is.
    pub(crate) fn fault(&self, bounds: &Bounds) -> Option<&'static str> {
        let Particle {
            position,
            velocity,
            temperature,
            age,
            lifetime,
            fuel,
            oxygen,
            soot,
        } = *self;
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
