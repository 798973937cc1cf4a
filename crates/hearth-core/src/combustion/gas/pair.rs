//! The pair data of the combustion interactions: one particle against four neighbours.

use std::ops::Range;

use glam::Vec2;

use super::Gas;
use super::speed_limit::artificial_viscosity;
use crate::interaction::Separation;
use crate::kernel::{self, Kernel};
use crate::lanes::{LANES, Lanes, Real, transposed};
use crate::neighbours::FAR_AWAY;
use crate::params::Physics;

/// What decides the forces of a pair, of four particles or of one in all lanes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Motion {
    /// Position, in smoothing lengths.
    pub position: [Lanes; 2],
    /// Velocity [m/s].
    pub velocity: [Lanes; 2],
    /// Volume \[m²\].
    pub volume: Lanes,
    /// Pressure \[Pa\].
    pub pressure: Lanes,
}

impl Motion {
    /// Reads the motion of some of the gas, with the positions in units of 1/`inverse_h`.
    #[inline(always)]
    pub fn read(&mut self, gas: &Gas, members: Range<usize>, inverse_h: f32) {
        let mut motion = [Lanes::new([FAR_AWAY, FAR_AWAY, 0.0, 0.0]); LANES];
        let (mut volume, mut pressure) = ([1.0; LANES], [0.0; LANES]);
        for (lane, i) in members.enumerate() {
            let (at, v) = (gas.position[i] * inverse_h, gas.velocity[i]);
            motion[lane] = Lanes::new([at.x, at.y, v.x, v.y]);
            (volume[lane], pressure[lane]) = (gas.volume[i], gas.pressure[i]);
        }
        let [x, y, vx, vy] = transposed(motion);
        (self.position, self.velocity) = ([x, y], [vx, vy]);
        (self.volume, self.pressure) = (Lanes::new(volume), Lanes::new(pressure));
    }

    /// The lanes that `pick` takes, at positions moved `by` smoothing lengths.
    #[inline(always)]
    pub fn picked(&self, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Motion {
        let [x, y] = &self.position;
        Motion {
            position: [pick(x) + by.x, pick(y) + by.y],
            velocity: self.velocity.each_ref().map(&pick),
            volume: pick(&self.volume),
            pressure: pick(&self.pressure),
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
    /// A pair without eddies.
    #[inline(always)]
    pub fn new(particle: &Motion, others: &Motion, keep: Lanes) -> Pair {
        let offset = Separation::between(particle.position, others.position);
        let (vx, vy) = (
            particle.velocity[0] - others.velocity[0],
            particle.velocity[1] - others.velocity[1],
        );
        // −W'/r is this times q² + 0.01, and −W'/r · r²/(r² + 0.01 h²) is this
        // times q²: both share one division.
        let softened = offset.softened();
        let softened_gradient = keep * kernel::minus_dw(offset.q) / (offset.q * softened);
        let volumes = particle.volume * others.volume;
        let mean_volume = (volumes + volumes) / (particle.volume + others.volume);
        Pair {
            offset,
            velocity: [vx, vy],
            gradient: softened_gradient * softened,
            softened_gradient,
            volumes,
            mean_volume,
            pressures: particle.pressure + others.pressure,
            laplacian: mean_volume * softened_gradient * offset.square,
            eddy_viscosity: Lanes::ZERO,
        }
    }

    /// C_s² h, which [`with_eddies`](Self::with_eddies) takes.
    pub fn eddy_scale(context: &Context) -> Lanes {
        let smagorinsky = context.values.eddy_viscosity;
        Lanes::splat(smagorinsky * smagorinsky * context.kernel.smoothing_length())
    }

    /// The pair, with the eddy viscosity `of_rolls`, and that of unresolved eddies.
    #[inline(always)]
    pub fn with_eddies(self, eddy_scale: Lanes, of_rolls: Lanes) -> Pair {
        let [vx, vy] = self.velocity;
        Pair {
            eddy_viscosity: (vx * vx + vy * vy).sqrt() * eddy_scale + of_rolls,
            ..self
        }
    }

    /// r·v of approaching particles, and zero of others.
    #[inline(always)]
    pub fn approach(&self) -> Lanes {
        let ([vx, vy], Separation { x, y, .. }) = (self.velocity, self.offset);
        (vx * x + vy * y).fast_min(Lanes::ZERO)
    }
}
