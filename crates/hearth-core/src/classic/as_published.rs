//! The forces of pairs where an equation is taken as the paper prints it.
//!
//! Each printed form can be chosen by itself, so that a reader can see what it
//! does. They stand apart because the two ends of a pair may then feel
//! different forces, and because the usual forces need not ask at every pair.

use glam::Vec2;

use super::forces::Broadcast;
use super::pairs::Block;
use crate::kernel::{self, Kernel};
use crate::lanes::Lanes;
use crate::neighbours::PairSum;
use crate::params::Physics;

/// The paper's equations as they are printed, each to be chosen by itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AsPublished {
    /// Equation 3, f = − m (pᵢ + pⱼ)/(2 ρⱼ) ∇W: the ½ halves the gradient of
    /// the pressure, and the density of force is taken for an acceleration.
    pressure: bool,
    /// Equation 4, f = μ m (vⱼ − vᵢ)/ρⱼ ∇²W with the kernel's own Laplacian.
    viscosity: bool,
    /// Equations 5 and 7, a = f/m: a density of force is divided by the mass
    /// instead of the density, and temperature lifts nothing.
    divisor: bool,
    mass: f32,
    kernel: Kernel,
    /// m μ [kg/m · Pa·s].
    rub: f32,
}

impl AsPublished {
    /// Which of them `values` choose.
    pub fn new(kernel: &Kernel, values: &Physics, viscosity: f32) -> AsPublished {
        AsPublished {
            pressure: values.printed_pressure,
            viscosity: values.printed_viscosity,
            divisor: values.printed_divisor,
            mass: values.particle_mass,
            kernel: *kernel,
            rub: values.particle_mass * viscosity,
        }
    }

    /// Whether at least one of them is chosen.
    pub fn any(&self) -> bool {
        self.pressure || self.viscosity || self.divisor
    }

    /// What makes an acceleration [m/s²] of a density of force [N/m³] on gas of
    /// so much volume a unit of mass.
    fn by(&self, volume: Lanes, as_acceleration: bool) -> Lanes {
        if self.divisor {
            Lanes::splat(1.0 / self.mass)
        } else if as_acceleration {
            Lanes::splat(1.0)
        } else {
            volume
        }
    }
}

impl PairSum<2> for AsPublished {
    type Block = Block;
    type Broadcast = Broadcast;

    #[inline(always)]
    fn one(&self, block: &Block, lane: usize, shift: Vec2) -> Broadcast {
        Broadcast::of(block, lane, shift)
    }

    fn pair(&self, one: &Broadcast, others: &Block) -> ([Lanes; 2], [Lanes; 2]) {
        let [x, y] = one.offset(others);
        let square = x * x + y * y;
        let q = kernel::distance(square);
        let steep = kernel::minus_dw(q) / q;
        let share = if self.pressure { 0.5 } else { 1.0 };
        let push = steep * (one.pressure + others.pressure) * share;
        let drag = if self.viscosity {
            let h = self.kernel.smoothing_length();
            -Lanes::new(q.to_array().map(|q| self.kernel.laplacian(q * h)))
        } else {
            -(steep * (2.0 * self.kernel.minus_dw_norm()) * square / (square + 0.01))
        };
        let rub = drag * self.rub;
        let [vx, vy] = one.apart(others);
        let ends = |mine: Lanes, theirs: Lanes| {
            let pushed = push * theirs * self.by(mine, self.pressure);
            let rubbed = rub * theirs * self.by(mine, false);
            [x * pushed + vx * rubbed, y * pushed + vy * rubbed]
        };
        (
            ends(one.volume, others.volume),
            ends(others.volume, one.volume),
        )
    }

    #[inline(always)]
    fn gains(block: &mut Block) -> &mut [Lanes; 2] {
        &mut block.acceleration
    }
}
