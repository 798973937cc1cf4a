//! The pair data of the classic interactions: one particle against four neighbours.

use glam::Vec2;

use super::pairs::Block;
use crate::interaction::Separation;
use crate::kernel;
use crate::lanes::Lanes;

/// A particle with each property in all lanes.
pub(super) struct Broadcast {
    position: [Lanes; 2],
    velocity: [Lanes; 2],
    pub volume: Lanes,
    pub pressure: Lanes,
}

impl Broadcast {
    #[inline(always)]
    pub fn of(block: &Block, pick: impl Fn(&Lanes) -> Lanes, by: Vec2) -> Broadcast {
        let [[x, y], [vx, vy]] = [&block.position, &block.velocity];
        Broadcast {
            position: [pick(x) + by.x, pick(y) + by.y],
            velocity: [pick(vx), pick(vy)],
            volume: pick(&block.volume),
            pressure: pick(&block.pressure),
        }
    }

    /// Offset from each of the others.
    #[inline(always)]
    pub fn offset(&self, others: &Block) -> Separation {
        Separation::between(self.position, others.position)
    }

    /// Velocity relative to each of the others [m/s].
    #[inline(always)]
    pub fn relative_velocity(&self, others: &Block) -> [Lanes; 2] {
        let [vx, vy] = others.velocity;
        [self.velocity[0] - vx, self.velocity[1] - vy]
    }
}

/// A particle against four others. Kernel gradients lack their factor
/// [`Kernel::minus_dw_norm`](kernel::Kernel::minus_dw_norm).
pub(super) struct Pair {
    pub offset: Separation,
    /// Relative velocity [m/s].
    pub velocity: [Lanes; 2],
    /// −W'/r · Vᵢ Vⱼ/(r² + 0.01 h²). An interaction multiplies it by a term that is known before
    /// it: r² + 0.01 h² for the gradient, r² for the Laplacian.
    pub quotient: Lanes,
    /// r² + 0.01 h².
    pub softened: Lanes,
    /// pᵢ + pⱼ, with the factor of [`Block::pressure`].
    pub pressures: Lanes,
}

impl Pair {
    #[inline(always)]
    pub fn new(particle: &Broadcast, others: &Block, keep: Lanes) -> Pair {
        let offset = particle.offset(others);
        let softened = offset.softened();
        // The division starts before the kernel is known.
        let reciprocal = Lanes::splat(1.0) / (offset.q * softened);
        Pair {
            offset,
            velocity: particle.relative_velocity(others),
            quotient: keep
                * kernel::minus_dw(offset.q)
                * (particle.volume * others.volume)
                * reciprocal,
            softened,
            pressures: particle.pressure + others.pressure,
        }
    }
}
