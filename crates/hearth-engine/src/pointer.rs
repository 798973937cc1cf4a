//! The force of a pointer on the gas.

/// Radius of the force \[m\].
const FORCE_RADIUS: f32 = 0.12;

/// Rate at which gas takes the pointer's velocity [1/s].
const DRAG_RATE: f32 = 60.0;

/// Duration of one call's force [s of fire]: it bridges the time until the next call.
const FORCE_SECONDS: f64 = 0.05;

/// A force that pulls the gas near a pointer along with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointerForce {
    position: [f32; 2],
    velocity: [f32; 2],
    /// Remaining duration [s of fire].
    left: f64,
}

impl PointerForce {
    /// The force of a pointer at a position \[m\] with a velocity [m/s].
    pub fn new(position: [f32; 2], velocity: [f32; 2]) -> PointerForce {
        PointerForce {
            position,
            velocity,
            left: FORCE_SECONDS,
        }
    }

    /// The acceleration [m/s²] of gas at a position \[m\] with a velocity [m/s].
    pub fn acceleration(&self, position: [f32; 2], velocity: [f32; 2]) -> [f32; 2] {
        let [x, y] = [0, 1].map(|axis| (position[axis] - self.position[axis]) / FORCE_RADIUS);
        let share = 1.0 - (x * x + y * y);
        if share <= 0.0 {
            return [0.0; 2];
        }
        [0, 1].map(|axis| DRAG_RATE * share * share * (self.velocity[axis] - velocity[axis]))
    }

    /// Counts a step of that length [s of fire]. Returns whether the force still acts.
    pub fn lasts(&mut self, step: f64) -> bool {
        self.left -= step;
        self.left > 0.0
    }
}
