//! The pair data of the combustion interactions: one particle against four neighbours.

use glam::Vec2;

use super::Gas;
use super::speed_limit::artificial_viscosity;
use crate::interaction::Separation;
use crate::kernel::{self, Kernel};
use crate::lanes::{LANES, Lanes, Real, transposed};
use crate::neighbours::FAR_AWAY;
use crate::params::Physics;

/// A particle, packed into vectors of four numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PackedParticle {
    /// Position, in smoothing lengths, and velocity [m/s].
    pub motion: Lanes,
    /// Volume \[m²\], pressure \[Pa\], half of the viscosity of its roll [m²/s] and an unused lane.
    pub volume_pressure: Lanes,
    /// Temperature \[K\], fuel, oxygen, soot.
    pub state: Lanes,
}

impl PackedParticle {
    /// Padding, beyond every support.
    pub const EMPTY: PackedParticle = PackedParticle {
        motion: Lanes::new([FAR_AWAY, FAR_AWAY, 0.0, 0.0]),
        volume_pressure: Lanes::new([1.0, 0.0, 0.0, 0.0]),
        state: Lanes::ZERO,
    };
}

/// A particle with each property in all lanes.
pub(crate) struct Broadcast {
    motion: [Lanes; 4],
    pub volume: Lanes,
    pressure: Lanes,
    half_roll_viscosity: Lanes,
}

impl Broadcast {
    /// A particle, shifted by smoothing lengths.
    #[inline(always)]
    pub fn of(particle: &PackedParticle, shift: Vec2) -> Broadcast {
        let [x, y, vx, vy] = [0, 1, 2, 3].map(|k| particle.motion.broadcast(k));
        Broadcast {
            motion: [x - shift.x, y - shift.y, vx, vy],
            volume: particle.volume_pressure.broadcast(0),
            pressure: particle.volume_pressure.broadcast(1),
            half_roll_viscosity: particle.volume_pressure.broadcast(2),
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
    /// Volume of the others \[m²\].
    pub volume: Lanes,
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
    pub fn new(particle: &Broadcast, others: [PackedParticle; LANES], eddy_scale: Lanes) -> Pair {
        let [x, y, vx, vy] = transposed(others.map(|other| other.motion));
        let [volume, pressure, half_roll_viscosity, _] =
            transposed(others.map(|other| other.volume_pressure));
        let of_rolls = particle.half_roll_viscosity + half_roll_viscosity;
        let [own_x, own_y, own_vx, own_vy] = particle.motion;
        let offset = Separation::between([own_x, own_y], [x, y]);
        let (vx, vy) = (own_vx - vx, own_vy - vy);
        // −W'/r is this times q² + 0.01, and −W'/r · r²/(r² + 0.01 h²) is this
        // times q²: both share one division.
        let softened = offset.softened();
        let softened_gradient = kernel::minus_dw(offset.q) / (offset.q * softened);
        let volumes = particle.volume * volume;
        let mean_volume = (volumes + volumes) / (particle.volume + volume);
        Pair {
            offset,
            velocity: [vx, vy],
            volume,
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
