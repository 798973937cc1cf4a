//! A particle as callers put it in and read it out.

use std::fmt;

use glam::Vec2;

use crate::bounds::Bounds;

/// Largest speed of a particle that can be put in [m/s]. A particle thousands of times faster
/// than the gas would destroy the simulation.
const MAX_SPEED: f32 = 1000.0;

/// A particle as callers put it in and read it out. Properties that its model does not use
/// have their values in air.
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

    /// The rule that it breaks, if any.
    // Inlined, a module in which no one reads the rules does not contain them.
    #[inline(always)]
    pub(crate) fn broken_rule(&self, bounds: &Bounds) -> Option<&'static str> {
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
        if !bounds.contains(position) {
            Some("position must be inside the domain")
        } else if !(0.0..=MAX_SPEED).contains(&velocity.length()) {
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

/// An error about particles to put in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParticleError {
    /// The first invalid particle; `None` if their number is invalid.
    pub index: Option<usize>,
    /// The rule.
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
