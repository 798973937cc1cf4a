//! Drag that limits other forces to a terminal speed.
//!
//! This model has no air around the fire, so nothing would stop what rises. In
//! air, lift meets a drag that grows with the square of the speed and balances
//! it at the terminal speed: a (1 − v|v|/v_t²). The factor stays within −1 and 2, so
//! that drag hits a particle that is born faster no harder than gravity does.

use glam::Vec2;

use crate::classic::block_force::{BlockForce, Four};
use crate::forces::{BodyForce, LocalGas};
use crate::lanes::{Lanes, Real};
use crate::params::Physics;

/// The drag of the air at a terminal speed [m/s].
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

    /// A force that this drag limits along its own direction.
    pub fn of<F: BodyForce>(self, force: F) -> Limited<F> {
        Limited { force, drag: self }
    }

    /// What drag leaves of an acceleration `a` at the speed `v` along it.
    #[inline(always)]
    fn left<T: Real>(self, a: T, v: T) -> T {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let drag = v * v.fast_max(zero - v) / T::of(self.speed * self.speed);
        let left = |drag: T| (one - drag).fast_max(T::of(-1.0)).fast_min(T::of(2.0));
        // An acceleration downwards meets drag upwards.
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
        free * self.drag.left(1.0, along)
    }
}

/// Forces up and down, whose sum drag limits.
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
        // Adding to −0 changes no bit of what is added.
        let mut free = [Lanes::splat(-0.0); 2];
        self.forces.add(four, &mut free);
        sum[1] += self.drag.left(free[1], four.velocity[1]);
    }
}
