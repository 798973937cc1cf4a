//! What a pointer does to the gas.

/// How far from the pointer the gas moves \[m\].
const RADIUS: f32 = 0.12;

/// How quickly the gas takes the pointer's velocity [1/s].
const RATE: f32 = 60.0;

/// How long one call acts [s of fire]: until the next one, while the pointer moves on.
const DURATION: f64 = 0.05;

/// A force that pulls the gas around a place along with a pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointerForce {
    place: [f32; 2],
    velocity: [f32; 2],
    /// What is left of its time [s of fire].
    left: f64,
}

impl PointerForce {
    /// The force of a pointer at a place \[m\] with a velocity [m/s].
    pub fn new(place: [f32; 2], velocity: [f32; 2]) -> PointerForce {
        PointerForce {
            place,
            velocity,
            left: DURATION,
        }
    }

    /// The acceleration [m/s²] of gas at that place \[m\] and velocity [m/s].
    pub fn acceleration(&self, place: [f32; 2], velocity: [f32; 2]) -> [f32; 2] {
        let [x, y] = [0, 1].map(|axis| (place[axis] - self.place[axis]) / RADIUS);
        let share = 1.0 - (x * x + y * y);
        if share <= 0.0 {
            return [0.0; 2];
        }
        [0, 1].map(|axis| RATE * share * share * (self.velocity[axis] - velocity[axis]))
    }

    /// Counts a step of that length \[s\]; whether the force still acts.
    pub fn lasts(&mut self, step: f64) -> bool {
        self.left -= step;
        self.left > 0.0
    }
}
