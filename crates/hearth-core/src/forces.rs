//! Body forces: accelerations of a particle that do not depend on its neighbours.
//!
//! A force is a type in a file of its own that implements [`BodyForce`]. Each model
//! lists its forces in one place, in the order in which their accelerations add up:
//! `combustion/gas/forces.rs` and `classic/forces.rs`.

pub(crate) mod turbulence;

use glam::Vec2;

/// The gas at one particle, as a body force reads it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalGas {
    /// Position \[m\].
    pub position: Vec2,
    /// Velocity [m/s].
    pub velocity: Vec2,
    /// Temperature \[K\].
    pub temperature: f32,
    /// Specific volume, relative to that of the surrounding air.
    pub expansion: f32,
}

/// A force on each particle, independent of its neighbours.
///
/// Closures of position \[m\] and velocity [m/s] implement it.
pub trait BodyForce {
    /// The acceleration of a particle [m/s²].
    fn acceleration(&self, gas: &LocalGas) -> Vec2;
}

impl<F: Fn(Vec2, Vec2) -> Vec2> BodyForce for F {
    #[inline]
    fn acceleration(&self, gas: &LocalGas) -> Vec2 {
        self(gas.position, gas.velocity)
    }
}
