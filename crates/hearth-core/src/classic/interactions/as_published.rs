//! Pair interactions as the paper prints them.
//!
//! Each printed form has a parameter, to show its effect. They are separate because they are
//! not symmetric, and so that the corrected interactions test no flag per pair.

use glam::Vec2;

use crate::classic::pair::Broadcast;
use crate::classic::pairs::Block;
use crate::interaction::Separation;
use crate::kernel::{self, Kernel};
use crate::lanes::Lanes;
use crate::neighbours::PairSum;
use crate::params::Physics;

/// The paper's equations as printed, each selected by a parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct AsPublished {
    /// Equation 3, f = − m (pᵢ + pⱼ)/(2 ρⱼ) ∇W: the ½ halves the gradient of
    /// the pressure, and the force density is used as an acceleration.
    pressure: bool,
    /// Equation 4, f = μ m (vⱼ − vᵢ)/ρⱼ ∇²W with the kernel's own Laplacian.
    viscosity: bool,
    /// Equations 5 and 7, a = f/m: the force density is divided by the mass
    /// instead of the density, and temperature has no buoyancy.
    divisor: bool,
    mass: f32,
    kernel: Kernel,
    /// m μ [kg/m · Pa·s].
    viscous: f32,
}

impl AsPublished {
    /// The forms that `values` select.
    pub fn new(kernel: &Kernel, values: &Physics, viscosity: f32) -> AsPublished {
        AsPublished {
            pressure: values.printed_pressure,
            viscosity: values.printed_viscosity,
            divisor: values.printed_divisor,
            mass: values.particle_mass,
            kernel: *kernel,
            viscous: values.particle_mass * viscosity,
        }
    }

    /// Whether at least one is selected.
    pub fn any(&self) -> bool {
        self.pressure || self.viscosity || self.divisor
    }

    /// The factor from a force density [N/m³] to an acceleration [m/s²], for a specific
    /// volume.
    fn acceleration_factor(&self, volume: Lanes, as_acceleration: bool) -> Lanes {
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
    fn broadcast(&self, block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast::of(block, pick, by)
    }

    fn pair(&self, particle: &Broadcast, others: &Block, keep: Lanes) -> ([Lanes; 2], [Lanes; 2]) {
        let offset = particle.offset(others);
        let Separation { x, y, square, q } = offset;
        let gradient = keep * kernel::minus_dw(q) / q;
        let share = if self.pressure { 0.5 } else { 1.0 };
        let pressure = gradient * (particle.pressure + others.pressure) * share;
        let laplacian = if self.viscosity {
            let h = self.kernel.smoothing_length();
            -(keep * Lanes::new(q.to_array().map(|q| self.kernel.laplacian(q * h))))
        } else {
            -(gradient * (2.0 * self.kernel.minus_dw_norm()) * square / offset.softened())
        };
        let viscous = laplacian * self.viscous;
        let [vx, vy] = particle.relative_velocity(others);
        let ends = |mine: Lanes, theirs: Lanes| {
            let radial = pressure * theirs * self.acceleration_factor(mine, self.pressure);
            let relative = viscous * theirs * self.acceleration_factor(mine, false);
            [x * radial + vx * relative, y * radial + vy * relative]
        };
        (
            ends(particle.volume, others.volume),
            ends(others.volume, particle.volume),
        )
    }

    #[inline(always)]
    fn accumulator(block: &mut Block) -> &mut [Lanes; 2] {
        &mut block.acceleration
    }
}
