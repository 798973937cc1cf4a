//! Drag that limits other forces to a terminal speed.
//!
//! The model has no air around the fire to stop a plume. In air, drag grows with the square of
//! the speed and balances buoyancy at the terminal speed: a (1 − v|v|/v_t²). The factor is
//! clamped to −1 and 2, so that drag does not decelerate fast births harder than gravity.

use glam::Vec2;

use crate::classic::block_force::{BlockForce, Four};
use crate::forces::{BodyForce, LocalGas};
use crate::lanes::{Lanes, Real};
use crate::params::Physics;

/// Drag with a terminal speed [m/s].
#[derive(Clone, Copy, Debug)]
pub(super) struct TerminalDrag {
    speed: f32,
}

impl TerminalDrag {
    pub fn new(values: &Physics) -> TerminalDrag {
        TerminalDrag {
            speed: values.terminal_speed,
        }
    }

    /// Limits a force along its own direction.
    pub fn of<F: BodyForce>(self, force: F) -> Limited<F> {
        Limited { force, drag: self }
    }

    /// An acceleration `a` less the drag at the speed `v` along it.
    #[inline(always)]
    fn reduced<T: Real>(self, a: T, v: T) -> T {
        let (zero, one) = (T::splat(0.0), T::splat(1.0));
        let drag = v * v.fast_max(zero - v) / T::splat(self.speed * self.speed);
        let left = |drag: T| {
            (one - drag)
                .fast_max(T::splat(-1.0))
                .fast_min(T::splat(2.0))
        };
        // A downward acceleration meets an upward drag.
        a.fast_max(zero) * left(drag) + a.fast_min(zero) * left(zero - drag)
    }
}

/// A force that drag limits along its own direction.
pub(super) struct Limited<F> {
    force: F,
    drag: TerminalDrag,
}

impl<F: BodyForce> BodyForce for Limited<F> {
    fn acceleration(&self, gas: &LocalGas) -> Vec2 {
        let free = self.force.acceleration(gas);
        let along = gas.velocity.dot(free.normalize_or_zero());
        free * self.drag.reduced(1.0, along)
    }
}

/// Vertical forces whose sum is limited by drag.
pub(super) struct Vertical<F> {
    forces: F,
    drag: TerminalDrag,
}

impl<F: BlockForce> Vertical<F> {
    pub fn new(forces: F, drag: TerminalDrag) -> Vertical<F> {
        Vertical { forces, drag }
    }
}

impl<F: BlockForce> BlockForce for Vertical<F> {
    #[inline(always)]
    fn add(&self, four: &Four, sum: &mut [Lanes; 2]) {
        // Adding to −0 changes no bit of the sum.
        let mut free = [Lanes::splat(-0.0); 2];
        self.forces.add(four, &mut free);
        sum[1] += self.drag.reduced(free[1], four.velocity[1]);
    }
}
