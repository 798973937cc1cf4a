//! Solids in the classic model: particles stay outside.
//!
//! At a surface, the velocity into it becomes zero, and friction by Coulomb's law slows the
//! motion along it. A free solid gets the momentum that a particle loses to it. Particles that a
//! moved solid finds deep inside, or that have no place between solids, die.

use super::particles::{ParticleState, Particles};
use crate::extremes::{fast_max, fast_min};
use crate::lanes::Lanes;
use crate::params::Physics;
use crate::solids::Solids;

/// Smallest distance of a particle from a solid, in smoothing lengths.
pub(super) const MIN_GAP: f32 = 0.05;
/// Coefficient of friction.
const FRICTION_COEFFICIENT: f32 = 0.3;

/// Keeps the particles outside of the solids. The life of those without a place ends. What changes
/// their velocities took `dt` \[s\]; what takes no time does not accelerate free solids.
pub(super) fn keep_all_outside(
    particles: &mut Particles,
    solids: &mut Solids,
    values: &Physics,
    dt: f32,
) {
    if solids.is_empty() {
        return;
    }
    let gap = MIN_GAP * values.smoothing_radius;
    let depth = values.spacing();
    let rate = if dt > 0.0 {
        values.particle_mass / dt
    } else {
        0.0
    };
    for particle in particles.iter_mut() {
        if !keep_outside(particle, solids, [gap, depth], rate) {
            particle.lifetime = fast_min(particle.age, particle.lifetime);
        }
    }
}

/// Moves a particle to the surface; false if it is deep inside or still in a solid. `rate` is its
/// mass over the time that it takes [kg/(m·s)].
fn keep_outside(
    particle: &mut ParticleState,
    solids: &mut Solids,
    [gap, depth]: [f32; 2],
    rate: f32,
) -> bool {
    let (mut at, mut v) = (particle.position(), particle.velocity());
    let mut moved = false;
    for body in &mut solids.bodies {
        if !body.may_touch(at, gap) {
            continue;
        }
        let (distance, normal) = body.surface.distance(at);
        if distance < -depth {
            return false;
        }
        if distance < gap {
            at += normal * (gap - distance);
            let before = v;
            let wall = body.velocity_at(at);
            let inward = fast_min((v - wall).dot(normal), 0.0);
            v -= normal * inward;
            let along = v - wall;
            let speed = fast_max(along.length(), 1e-6);
            v -= along * fast_min(-FRICTION_COEFFICIENT * inward / speed, 1.0);
            if body.is_free {
                body.push(at, rate, before - v);
            }
            moved = true;
        }
    }
    particle.motion = Lanes::new([at.x, at.y, v.x, v.y]);
    !moved || !solids.touch(at, 0.0)
}
