//! A particle as it is put in and read out, and as the renderer gets it.

use glam::Vec2;

use crate::params::DisplayMode;

/// A particle as it is put in and read out. What its model does not use is left
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
}

/// A particle as the renderer gets it. Place \[m\], velocity [m/s] and temperature
/// \[K\] come first: x, y, vx, vy, T; then, in the classic model, density [kg/m³],
/// age \[s\] and remaining life [0–1]; in the combustion model, volume \[m²\],
/// soot, and fuel burnt in a second [1/s]; of an ember, size \[m\], age \[s\] and
/// remaining life [0–1].
///
/// Where the [display mode](crate::params::DisplayMode) is not fire's or the paper's,
/// in both models: volume \[m²\], zero, and what the mode measures; of sprites, volume,
/// the particle's number modulo 4096, and how much there is of it to glow: remaining
/// life, or soot.
pub type Instance = [f32; 8];

/// What a particle of that id is told by in a picture, where that is asked for.
pub(crate) fn numbered(id: u64, mode: DisplayMode) -> f32 {
    match mode {
        DisplayMode::Sprites => (id % 4096) as f32,
        _ => 0.0,
    }
}
