//! Solids in the classic model: particles stay outside.
//!
//! At a surface, the velocity into it becomes zero, and friction by Coulomb's law slows the
//! motion along it. Particles that a moved solid finds deep inside, or that have no place between
//! solids, die.

use super::particles::{ParticleState, Particles};
use crate::extremes::{fast_max, fast_min};
use crate::lanes::Lanes;
use crate::params::Physics;
use crate::solids::Solids;

/// Smallest distance of a particle from a solid, in smoothing lengths.
pub(super) const GAP: f32 = 0.05;
/// Coefficient of friction.
const FRICTION: f32 = 0.3;

/// Keeps the particles outside of the solids. The life of those without a place ends.
#[inline(never)]
pub(super) fn hold(particles: &mut Particles, solids: &Solids, values: &Physics) {
    if solids.is_empty() {
        return;
    }
    let gap = GAP * values.smoothing_radius;
    let depth = values.spacing();
    for particle in particles.iter_mut() {
        if !keep_outside(particle, solids, gap, depth) {
            particle.lifetime = fast_min(particle.age, particle.lifetime);
        }
    }
}

/// Moves a particle to the surface; false if it is deep inside or still in a solid.
fn keep_outside(particle: &mut ParticleState, solids: &Solids, gap: f32, depth: f32) -> bool {
    let (mut at, mut v) = (particle.position(), particle.velocity());
    let mut moved = false;
    for body in &solids.bodies {
        if !body.may_touch(at, gap) {
            continue;
        }
        let (distance, normal) = body.surface.distance(at);
        if distance < -depth {
            return false;
        }
        if distance < gap {
            at += normal * (gap - distance);
            let wall = body.velocity_at(at);
            let inward = fast_min((v - wall).dot(normal), 0.0);
            v -= normal * inward;
            let along = v - wall;
            let speed = fast_max(along.length(), 1e-6);
            v -= along * fast_min(-FRICTION * inward / speed, 1.0);
            moved = true;
        }
    }
    particle.motion = Lanes::new([at.x, at.y, v.x, v.y]);
    !moved || !solids.touch(at, 0.0)
}
