//! Body forces: what accelerates each particle by itself, whatever its neighbours do.
//!
//! A force is a type in a file of its own that implements [`BodyForce`]. Each model
//! lists its forces in one place, in the order in which their accelerations add up:
//! `combustion/forces.rs` and `classic/forces.rs`.

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
    /// Volume of a unit of mass, in that of the surrounding air.
    pub expansion: f32,
}

/// A force that acts on each particle by itself.
///
/// A closure of position \[m\] and velocity [m/s] is one.
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
