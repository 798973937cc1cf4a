//! The Coriolis force of a rotating frame: a = −2 Ω × v.

use hearth_core::{BodyForce, LocalGas, Vec2};

/// A frame that turns counterclockwise at this many radians a second.
pub struct Coriolis {
    pub angular_velocity: f32,
}

impl BodyForce for Coriolis {
    fn acceleration(&self, gas: &LocalGas) -> Vec2 {
        let Vec2 { x, y } = gas.velocity;
        2.0 * self.angular_velocity * Vec2::new(y, -x)
    }
}
