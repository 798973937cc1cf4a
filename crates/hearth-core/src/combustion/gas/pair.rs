//! The pair data of the combustion interactions: one particle against four neighbours.

use glam::Vec2;

use super::Gas;
use super::speed_limit::artificial_viscosity;
use crate::interaction::Separation;
use crate::kernel::{self, Kernel};
use crate::lanes::{Lanes, Real};
use crate::neighbours::{self, FAR_AWAY};
use crate::params::Physics;

/// Four particles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    /// Position, in smoothing lengths.
    pub position: [Lanes; 2],
    /// Velocity [m/s].
    pub velocity: [Lanes; 2],
    /// Volume \[m²\].
    pub volume: Lanes,
    /// Pressure \[Pa\].
    pub pressure: Lanes,
    /// Half of the viscosity of its roll [m²/s].
    pub half_roll_viscosity: Lanes,
    /// Temperature \[K\], fuel, oxygen, soot.
    pub state: [Lanes; 4],
    /// Acceleration [m/s²], the concentration gradient without its factor, and the change of the
    /// state [1/s].
    pub sums: [Lanes; SUMS],
}

/// Number of sums of a particle.
pub(crate) const SUMS: usize = 8;

impl Block {
    /// No particle.
    pub const EMPTY: Block = Block {
        position: [Lanes::splat(FAR_AWAY); 2],
        velocity: [Lanes::ZERO; 2],
        volume: Lanes::splat(1.0),
        pressure: Lanes::ZERO,
        half_roll_viscosity: Lanes::ZERO,
        state: [Lanes::ZERO; 4],
        sums: [Lanes::ZERO; SUMS],
    };
}

impl neighbours::Block for Block {
    #[inline(always)]
    fn position(&self) -> [Lanes; 2] {
        self.position
    }
    #[inline(always)]
    fn weight(&self) -> Lanes {
        self.volume
    }
    #[inline(always)]
    fn sum(&mut self) -> &mut Lanes {
        &mut self.sums[0]
    }
}

/// Particles that are paired with those of a block, lane by lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Broadcast {
    position: [Lanes; 2],
    velocity: [Lanes; 2],
    pub volume: Lanes,
    pressure: Lanes,
    half_roll_viscosity: Lanes,
    pub state: [Lanes; 4],
}

impl Broadcast {
    #[inline(always)]
    pub fn of(block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        Broadcast {
            position: [
                pick(&block.position[0]) + by.x,
                pick(&block.position[1]) + by.y,
            ],
            velocity: block.velocity.each_ref().map(&pick),
            volume: pick(&block.volume),
            pressure: pick(&block.pressure),
            half_roll_viscosity: pick(&block.half_roll_viscosity),
            state: block.state.each_ref().map(&pick),
        }
    }
}

/// The shared inputs of the interactions of a step.
pub(crate) struct Context<'a> {
    pub kernel: &'a Kernel,
    pub values: &'a Physics,
    /// Numerical speed of sound c₀ [m/s].
    pub sound: f32,
    /// The present coefficient α of the artificial viscosity.
    pub artificial_viscosity: f32,
    /// Mass of a particle [kg/m].
    pub mass: f32,
}

impl<'a> Context<'a> {
    /// The inputs for the present velocities of the gas.
    pub fn new(gas: &Gas, values: &'a Physics, kernel: &'a Kernel, sound: f32) -> Context<'a> {
        Context {
            kernel,
            values,
            sound,
            artificial_viscosity: artificial_viscosity(gas, values, sound),
            mass: gas.mass,
        }
    }
}

/// A particle against four others. Kernel gradients lack their factor
/// [`Kernel::minus_dw_norm`], which the constants of the interactions hold.
pub(crate) struct Pair {
    pub offset: Separation,
    /// Relative velocity [m/s].
    pub velocity: [Lanes; 2],
    /// −∇W/r.
    pub gradient: Lanes,
    /// −∇W/r · 1/(r² + 0.01 h²).
    pub softened_gradient: Lanes,
    /// Vᵢ Vⱼ.
    pub volumes: Lanes,
    /// Vᵢ Vⱼ ρ̄/m.
    pub mean_volume: Lanes,
    /// pᵢ + pⱼ \[Pa\].
    pub pressures: Lanes,
    /// −r·∇W/(r² + 0.01 h²) · Vᵢ Vⱼ ρ̄/m.
    pub laplacian: Lanes,
    /// Eddy viscosity ν_t = C_s² h |vᵢⱼ| + (νᵢ + νⱼ)/2, of unresolved eddies and of the rolls [m²/s].
    pub eddy_viscosity: Lanes,
}

impl Pair {
    /// C_s² h, which [`Pair::new`] takes.
    pub fn eddy_scale(context: &Context) -> Lanes {
        let smagorinsky = context.values.eddy_viscosity;
        Lanes::splat(smagorinsky * smagorinsky * context.kernel.smoothing_length())
    }

    #[inline(always)]
    pub fn new(particle: &Broadcast, others: &Block, eddy_scale: Lanes) -> Pair {
        let of_rolls = particle.half_roll_viscosity + others.half_roll_viscosity;
        let offset = Separation::between(particle.position, others.position);
        let (vx, vy) = (
            particle.velocity[0] - others.velocity[0],
            particle.velocity[1] - others.velocity[1],
        );
        let (volume, pressure) = (others.volume, others.pressure);
        // −W'/r is this times q² + 0.01, and −W'/r · r²/(r² + 0.01 h²) is this
        // times q²: both share one division.
        let softened = offset.softened();
        let softened_gradient = kernel::minus_dw(offset.q) / (offset.q * softened);
        let volumes = particle.volume * volume;
        let mean_volume = (volumes + volumes) / (particle.volume + volume);
        Pair {
            offset,
            velocity: [vx, vy],
            gradient: softened_gradient * softened,
            softened_gradient,
            volumes,
            mean_volume,
            pressures: particle.pressure + pressure,
            laplacian: mean_volume * softened_gradient * offset.square,
            eddy_viscosity: (vx * vx + vy * vy).sqrt() * eddy_scale + of_rolls,
        }
    }

    /// r·v of approaching particles, and zero of others.
    #[inline(always)]
    pub fn approach(&self) -> Lanes {
        let ([vx, vy], Separation { x, y, .. }) = (self.velocity, self.offset);
        (vx * x + vy * y).fast_min(Lanes::ZERO)
    }
}
